# SPDX-License-Identifier: GPL-3.0-or-later
"""This section shows what engines ship: how tight the boxes around whole characters are, who gets out of them, and what they
cost, beside ours."""
from . import pictures
from .over_time import SKINNINGS
from .statistics import mean
from .tables import grouped

# Each method has what it does, and who has it.
METHODS = {
    "joint_boxes": ("a box a joint, carried and merged", "Bevy, Godot, PlayCanvas"),
    "padded_pivots": ("the joints’ pivots, padded by the rest pose’s difference", "OpenUSD"),
    "all_skinned": ("all vertices skinned", "three.js"),
    "rest_box": ("the box of the rest pose", "Filament"),
    "scaled_rest_box": ("that box, twice as long each way", "by hand"),
    "sampled_union_keys": ("the union of boxes at key times", "flutter_scene"),
    "sampled_union_30 Hz": ("the union at 30 Hz", ""),
    "sampled_union_60 Hz": ("the union at 60 Hz", ""),
    "sampled_joint_boxes": ("the union of joint boxes at fixed steps, weights ignored", "Babylon.js"),
    "joint_capsules": ("a capsule a joint, weighted radii", "ours"),
    "rounded_boxes": ("a rounded box a joint, weighted radii", "ours"),
    "motion_bound": ("the motion bound: a ball a group of joint-sets, any skinning", "ours"),
}
# The goals compare this method with joint boxes. They are the greatest mean volume and cost.
OURS, GOALS = "rounded_boxes", {"volume": 0.8, "cost": 1.0}
RATIOS = ("volume_ratio_to_true_box", "area_ratio_to_true_box", "radius_ratio_to_true_box", "volume_ratio_to_joint_boxes")


def of_clips(results, method, quantity, **where):
    """Returns the rows of clips, by clip of any model."""
    return results.values("engines", variant=method, quantity=quantity, kind="clip", **where)


def total(results, method, quantity, kind, **where):
    return round(sum(results.values("engines", variant=method, quantity=quantity, kind=kind, **where)))


def farthest(results, method, **where):
    """Returns the row of the farthest miss, or None."""
    row = max(results.find("engines", variant=method, quantity="miss_distance_over_box_side", **where), key=lambda r: r.value, default=None)
    return row if row and row.value else None


def refused_clips(results):
    """Returns how many clips are left out because their joints do not move rigidly."""
    return round(sum(row.value for row in results.find("engines", kind="model", quantity="refused_clips")))


def row_of(results, method, skinning):
    """Returns the row of a method, or None if it was not measured."""
    if not results.find("engines", variant=method, skinning=skinning, kind="clip", quantity="poses"):
        return None
    has_twists = bool(results.find("engines", variant=method, skinning=skinning, kind="twists", quantity="missed_poses"))
    row = {"method": METHODS[method][0], "who": METHODS[method][1], "is_ours": METHODS[method][1] == "ours",
           "misses": total(results, method, "missed_poses", "clip", skinning=skinning), "poses": total(results, method, "poses", "clip", skinning=skinning),
           "undecided": total(results, method, "undecided", "clip", skinning=skinning), "by": farthest(results, method, skinning=skinning),
           "unbounded": total(results, method, "unbounded", "clip", skinning=skinning),
           "twists": (total(results, method, "missed_poses", "twists", skinning=skinning), total(results, method, "poses", "twists", skinning=skinning)) if has_twists else None}
    for quantity in RATIOS:  # of clips that have a bound at some time
        found = results.find("engines", variant=method, skinning=skinning, kind="clip", quantity=quantity)
        row[quantity] = mean(r.value for r in found) if found else None
    return row


def costs(results, method):
    """Returns means over the models with linear skinning: nanoseconds, and the ratio to joint boxes, also for methods that
    begin with matrices."""
    def mean_of(quantity):
        found = results.find("engines", variant=method, skinning="linear", kind="cost", quantity=quantity)
        return mean(r.value for r in found) if found else None
    return {"method": METHODS[method][0], "who": METHODS[method][1], "ns": mean_of("ns_per_box"), "ratio": mean_of("time_ratio_to_joint_boxes"),
            "ns_per_box_from_matrices": mean_of("ns_per_box_from_matrices"), "ratio_of_matrices": mean_of("time_ratio_to_joint_boxes_from_matrices")}


def volumes_by_model(results, method):
    """Returns {model: volumes over joint boxes, by clip} with linear skinning."""
    rows = results.select("engines", variant=method, quantity="volume_ratio_to_joint_boxes", kind="clip", skinning="linear")
    return {model: [row.value for row in some] for model, some in grouped(rows, lambda row: row.model).items()}


def costliest(results, method):
    """Returns the model for which a method costs the most from matrices, over joint boxes, and how much."""
    rows = results.find("engines", variant=method, skinning="linear", kind="cost", quantity="time_ratio_to_joint_boxes_from_matrices")
    return max(((row.model, row.value) for row in rows), key=lambda row: row[1])


def volume_goal(results):
    """Ours over joint boxes with linear skinning: the mean over all clips, what even the true box has, and the clips that reach the goal. either: the
    mean if a bake takes rounded boxes or capsules, model by model."""
    ours, true = (of_clips(results, method, "volume_ratio_to_joint_boxes", skinning="linear") for method in (OURS, "all_skinned"))
    settings = [volumes_by_model(results, method) for method in (OURS, "joint_capsules")]
    either = [volume for model in settings[0] for volume in min((s[model] for s in settings), key=mean)]
    return {"mean": mean(ours), "true": mean(true), "either": mean(either), "reached": sum(ratio <= GOALS["volume"] for ratio in ours), "clips": len(ours)}


def unseen(results):
    """Ours over joint boxes in clips that it was not fitted to but to the model's others, the same as fitted, what the true box has, and how many clips
    there are, with linear skinning; None if no model has two clips."""
    found = results.find("engines", variant="rounded_boxes_of_other_clips", quantity="volume_ratio_to_joint_boxes", kind="clip", skinning="linear")
    if not found:
        return None

    def of(method):
        return mean(results.number("engines", model=r.model, pose=r.pose, variant=method, quantity="volume_ratio_to_joint_boxes", kind="clip", skinning="linear") for r in found)
    return {"mean": mean(r.value for r in found), "fitted": of(OURS), "true": of("all_skinned"), "clips": len(found)}


def clip_rows(results):
    """Returns, for each clip, our box and the true box over the joint boxes, with linear skinning."""
    rows = []
    for row in results.select("engines", variant=OURS, quantity="volume_ratio_to_joint_boxes", kind="clip", skinning="linear"):
        true = results.number("engines", model=row.model, pose=row.pose, variant="all_skinned", quantity="volume_ratio_to_joint_boxes", kind="clip", skinning="linear")
        rows.append({"model": row.model, "clip": row.pose, "ours": row.value, "true": true, "reached": row.value <= GOALS["volume"]})
    return rows


def section(results, page):
    measured = [s for s in SKINNINGS if results.find("engines", skinning=s, kind="clip", quantity="volume_ratio_to_true_box")]
    if not measured:  # models without clips, or flat ones
        return None
    tables = [{"name": SKINNINGS[s], "is_linear": s == "linear", "rows": [row for method in METHODS if (row := row_of(results, method, s))]} for s in measured]
    timed = [costs(results, method) for method in METHODS if results.find("engines", variant=method, kind="cost", quantity="ns_per_box")]
    context = {"figures": [], "colors": {}}
    if results.was_run("pictures"):
        context = {"figures": pictures.figures_of(results, page, {"engine_boxes"}), "colors": pictures.colors_of(results)}
    return context | {"tables": tables, "ratios": RATIOS, "costs": timed, "goals": GOALS, "volume": volume_goal(results), "unseen": unseen(results), "cost": costs(results, OURS), "clips": clip_rows(results),
                      "refused": refused_clips(results)}
