# SPDX-License-Identifier: GPL-3.0-or-later
"""The original paper printed these Tables 1 and 2. They have no results of ours."""
import pathlib

from .tables import stored

ROOT = pathlib.Path(__file__).resolve().parents[2]


def table1():
    """Returns average radii by level: level, reference, linear, spherical, optimal."""
    return stored(ROOT, "paper/original_table1.csv")


def ratios_to_optimal():
    """Returns the ratios of spherical blending, by level."""
    return [row.spherical / row.optimal for row in table1()]


def table2():
    """Returns milliseconds a query: scenario, the model, scene and query of ours that it is compared with, lbs, sbs,
    bottom_up."""
    return stored(ROOT, "paper/original_table2.csv")
