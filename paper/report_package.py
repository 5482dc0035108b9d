# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the report's package (experiments/report) importable: the paper's numbers come from the same tables and statistics."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "experiments"))
