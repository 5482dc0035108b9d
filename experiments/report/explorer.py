# SPDX-License-Identifier: GPL-3.0-or-later
"""The explorer, which experiments/explorer/build makes, and the run's own models for it."""
import base64

from markupsafe import Markup

from .tables import ResultError

MOST_BYTES = 3 << 20  # of all models together, as they stand in the page


def packed_models(results):
    """Returns (lines of base64, one for each model; the names of those that would make the page too large)."""
    lines, left_out = "", []
    for row in results.rows("models"):
        if not row.packed_file:  # procedural models are made by the explorer itself
            continue
        path = results.folder / row.packed_file
        try:
            line = base64.b64encode(path.read_bytes()).decode()
        except OSError as error:
            raise ResultError(f"{path}: cannot be read ({error}), but {results.path('models')} names it") from None
        if len(lines) + len(line) > MOST_BYTES:
            left_out.append(row.model)
        else:
            lines += line + "\n"
    return lines, left_out


def section(results, page):
    """If the page goes without it, it says how to have it."""
    if page.explorer is None:
        return {"explorer": None}
    lines, left_out = packed_models(results)
    return {"lines": lines, "left_out": left_out, "explorer": Markup(page.explorer.read_text(encoding="utf-8"))}
