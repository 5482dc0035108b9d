# SPDX-License-Identifier: GPL-3.0-or-later
"""Tightness: radii of the refitted balls beside the smallest possible, and which balls miss a vertex."""
from collections import defaultdict
from dataclasses import dataclass

from . import original
from .plots import Line, Plot
from .statistics import span
from .tables import grouped

PLOTTED = ["spherical_printed_signed", "spherical_repaired", "control_miniball", "control_sets_miniball", "control_mixed",
           "control_many_pieces", "bottom_up"]


@dataclass
class PoseSet:
    """A PoseSet has what was measured of a model in one pose, or in the sampled times of a clip."""
    model: str
    pose: str
    poses: int  # how many were sampled
    levels: dict   # by variant, then level, then quantity

    def ratios(self, variant):
        """Returns (level, average radius / optimal) of the levels that have a ball of the variant."""
        return [(level, cell["radius_ratio_to_optimal"]) for level, cell in sorted(self.levels[variant].items()) if "radius_ratio_to_optimal" in cell]

    def merged(self, variant):
        """Returns the counts of all levels added up, and the worst miss of any."""
        cells = self.levels[variant].values()
        out = {quantity: round(sum(cell.get(quantity, 0) for cell in cells)) for quantity in ("nodes", "undefined", "missed_balls")}
        return {**out, "worst_miss": max(cell.get("worst_miss", 0) for cell in cells)}


def pose_sets(results):
    """Returns the sets in the order of the file."""
    sets = {}
    for row in results.rows("tightness"):
        key = row.model, row.pose
        if key not in sets:
            sets[key] = PoseSet(row.model, row.pose, row.poses, defaultdict(lambda: defaultdict(dict)))
        sets[key].levels[row.variant][row.level][row.quantity] = row.value
    return list(sets.values())


def conclusion(sets, variant):
    """Returns what one would take from a model's plots and tables: the variant's least and largest ratio, and its misses."""
    all_levels = [s.merged(variant) for s in sets]
    return {"variant": variant, "ratios": span([ratio for s in sets for _, ratio in s.ratios(variant)]),
            "misses": sum(m["missed_balls"] for m in all_levels), "nodes": sum(m["nodes"] for m in all_levels)}


def plot(pose_set):
    lines = [Line(variant, pose_set.ratios(variant)) for variant in PLOTTED]
    lines.append(Line("the paper, on its creature", list(enumerate(original.ratios_to_optimal(), 1)), dashed=True, color="ink"))
    return Plot(f"{pose_set.model}, {pose_set.pose}", "level of the tree", "average radius / Optimal", lines).svg()


def section(results, page):
    sets, variants = pose_sets(results), results.rows("variants")
    optimal = {level: ratio for level, ratio in enumerate(original.ratios_to_optimal(), 1)}
    models = grouped(sets, lambda s: s.model)
    return {"variants": variants, "sets": sets, "columns": [v.variant for v in variants],
            "missing_columns": [v.variant for v in variants if v.role in ("refit", "comparison")],
            "models": models, "original": optimal, "plot": plot, "tolerance": results.constant("miss_tolerance"),
            "conclusions": {model: conclusion(some, results.default_variant()) for model, some in models.items()}}
