# SPDX-License-Identifier: GPL-3.0-or-later
"""Bounds over time: what gets out of them, and of boxes around sampled times; how tight they are, and what baking them costs."""
from . import pictures
from .plots import Line, Plot
from .statistics import fitted_exponent, span, weighted_mean

WAYS = {"bounds": "bounds over time", "keys": "boxes at keys", "30 Hz": "boxes at 30 Hz", "60 Hz": "boxes at 60 Hz"}
SKINNINGS = {"linear": "linear", "dual_quaternion": "dual quaternion", "spherical": "spherical"}
GOALS = {"whole": 1.02, "cluster": 1.10}  # of the ratio of volumes, at most
FADE_GOAL = 1.25  # of the ratio of volumes, while one clip fades to another
GROWN = {"walk_cycles": "longer clips", "triangles": "more triangles"}


def total(results, quantity, way="bounds", **where):
    return round(sum(results.values("over_time", variant=way, quantity=quantity, **where)))


def worst(results, quantity, way, **where):
    """Returns the row with the greatest value."""
    return max(results.select("over_time", variant=way, quantity=quantity, **where), key=lambda row: row.value)


def clusters_of_clips(results, skinning):
    """Returns the number of clusters, each counted once in every clip that has bounds."""
    return sum(results.number("over_time", model=clip.model, skinning=skinning, pose="all", variant="bounds", quantity="clusters")
               for clip in results.select("over_time", skinning=skinning, variant="bounds", quantity="duration"))


def misses(results, skinning, way):
    whole, cluster = (worst(results, quantity, way, skinning=skinning) for quantity in ("character_miss_distance_over_box_side", "cluster_miss_distance_over_box_side"))
    return {"way": WAYS[way], "is_ours": way == "bounds", "clips": total(results, "character_misses", way, skinning=skinning),
            "clusters": total(results, "cluster_misses", way, skinning=skinning), "undecided": total(results, "undecided", way, skinning=skinning),
            "whole": whole if whole.value else None, "cluster": cluster if cluster.value else None}


def whole_ratios(results, **where):
    return span(results.values("over_time", variant="bounds", quantity="character_volume_ratio", **where))


def within_goal(results, **where):
    """Returns in how many clips the box of the whole character is as tight as it should be."""
    return sum(ratio <= GOALS["whole"] for ratio in results.values("over_time", variant="bounds", quantity="character_volume_ratio", **where))


def cluster_ratio(results, **where):
    """Returns the mean over all clusters that are not flat, in all clips; None if all are."""
    ratios = results.select("over_time", variant="bounds", quantity="mean_cluster_volume_ratio", **where)

    def counted(row):
        same = dict(model=row.model, skinning=row.skinning, variant="bounds")
        return (results.number("over_time", pose="all", quantity="clusters", **same)
                - results.number("over_time", pose=row.pose, quantity="flat_clusters", **same))
    weights = [counted(row) for row in ratios]
    return weighted_mean([row.value for row in ratios], weights) if any(weights) else None


def seconds(results, grown):
    """Returns (walks times clusters, seconds of bounding), in ascending order."""
    return sorted((r.walk_cycles * r.clusters, r.value) for r in results.select("over_time_growth", variant=grown, quantity="bounding_seconds"))


def growth_exponent(results, grown):
    return fitted_exponent(seconds(results, grown))


def peaks(results):
    """Returns (triangles, megabytes until the bounds are there, and until the file is), in ascending order."""
    return sorted((r.triangles, r.value, results.number("over_time_growth", triangles=r.triangles, variant="triangles", quantity="peak_megabytes"))
                  for r in results.find("over_time_growth", quantity="peak_megabytes_bounding"))


def tightness_row(results, model, skinning):
    found = results.find("over_time", model=model, skinning=skinning, variant="bounds", quantity="character_volume_ratio")
    refused, duration = (results.number("over_time", model=model, skinning=skinning, pose="all", variant="bounds", quantity=q) for q in ("refused_clips", "bounding_seconds"))
    row = {"model": model, "skinning": SKINNINGS[skinning], "clips": len(found), "refused": round(refused), "seconds": duration, "whole": None, "clusters": None}
    if found:
        row.update(whole=whole_ratios(results, model=model, skinning=skinning), clusters=cluster_ratio(results, model=model, skinning=skinning))
    return row


def fades(results, **where):
    """Returns a row for each crossfade that has a bound."""
    def of(row, quantity):
        return results.number("crossfades", model=row.model, pose=row.pose, skinning=row.skinning, quantity=quantity)
    return [{"model": row.model, "pose": row.pose, "skinning": SKINNINGS[row.skinning], "whole": row.value, "has_clusters": of(row, "clusters") > 0,
             "clusters": of(row, "mean_cluster_volume_ratio"), "checks": round(of(row, "checks")), "misses": round(of(row, "missed_places")),
             "undecided": round(of(row, "undecided")), "out_of_both_clips": round(of(row, "out_of_both_clips")),
             "is_within": max(row.value, of(row, "mean_cluster_volume_ratio")) <= FADE_GOAL}
            for row in results.find("crossfades", quantity="character_volume_ratio", **where)]


def section(results, page):
    measured = [s for s in SKINNINGS if results.find("over_time", skinning=s, quantity="character_volume_ratio")]
    if not measured:  # models without clips
        return None
    of_skinnings = [{"name": SKINNINGS[s], "clips": len(results.select("over_time", skinning=s, quantity="duration")), "clusters": round(clusters_of_clips(results, s)),
                     "checks": total(results, "checks", skinning=s), "exact": {q: total(results, f"exact_{q}", skinning=s) for q in ("checks", "missed_places", "undecided")},
                     "rows": [misses(results, s, way) for way in WAYS], "whole": whole_ratios(results, skinning=s), "within": within_goal(results, skinning=s), "cluster": cluster_ratio(results, skinning=s)}
                    for s in measured]
    rows = [tightness_row(results, model, s) for model in results.distinct("over_time", "model") for s in SKINNINGS]
    context = {"skinnings": of_skinnings, "goals": GOALS, "rows": rows, "random_times": max(results.values("over_time", quantity="random_times")),
               "close_times": max(results.values("over_time", quantity="close_times")), "growth": None, "figures": [], "colors": {}}
    context.update(fades=[], fade_goal=FADE_GOAL)
    if results.was_run("crossfades"):
        refused = sum(results.values("crossfades", quantity="refused"))
        context.update(fades=fades(results), fades_refused=round(refused))
    if results.was_run("pictures"):
        context.update(figures=pictures.figures_of(results, page, {"sampled_miss"}), colors=pictures.colors_of(results))
    if results.was_run("over_time_growth"):
        lines = [Line(words, seconds(results, grown)) for grown, words in GROWN.items()]
        context["growth"] = {"plot": Plot("bounding the walking man", "walks times clusters", "s", lines, log_x=True, log_y=True).svg(),
                             "exponents": {grown: growth_exponent(results, grown) for grown in GROWN}, "peaks": peaks(results)}
    return context
