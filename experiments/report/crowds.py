# SPDX-License-Identifier: GPL-3.0-or-later
"""Crowds of characters in one scene."""
from .plots import Line, Plot
from .statistics import fitted_exponent

FITTED = 3  # the largest numbers of characters
BASELINES = [("skin everything, clusters of 256", "skin_all_float"), ("skin everything, clusters of 512", "skin_all_float_512"),
             ("skin where motion bounds meet, 256", "skin_all_float_bounded"), ("skin where motion bounds meet, 512", "skin_all_float_512_bounded")]
KINDS = {"": "all pairs", "_on_two_threads": "all pairs, two threads", "_yes_no": "yes/no"}  # by what a detector's name ends with
LINES = [("all pairs", "clusters"), *BASELINES]


def times(results, scene, variant):
    """Returns (characters, us a frame), in ascending order, or none if there were no threads."""
    return sorted((r.characters, r.value) for r in results.find("crowds", scene=scene, variant=variant, quantity="us_per_frame"))


def exponent(results, scene, variant):
    return fitted_exponent(times(results, scene, variant)[-FITTED:])


def variants(kind=""):
    """Returns the baselines of a kind of query."""
    return tuple(variant + kind for _, variant in BASELINES)


def fastest_times(results, scene, detectors):
    """Returns (characters, us a frame) of the fastest of some detectors for each number of characters, in ascending order."""
    found = [dict(times(results, scene, detector)) for detector in detectors]
    return [(n, min(us[n] for us in found if n in us)) for n in sorted(set().union(*found))]


def gain(results, scene, characters, kind=""):
    """Returns how many times as fast as the fastest baseline collide_all is, both on as many threads and by the same query, or none
    if that was not measured."""
    ratios = [r.value for variant in variants(kind) for r in results.find("crowds", scene=scene, characters=characters, variant=variant, quantity="ratio_to_clusters")]
    return min(ratios, default=None)


def crowds_section(results, page):
    scenes = []
    for scene in results.distinct("crowds", "scene"):
        rows, fastest = [], {kind: dict(fastest_times(results, scene, variants(kind))) for kind in KINDS}
        for characters in results.distinct("crowds", "characters", scene=scene):
            def of(quantity, variant="clusters"):
                return results.number_or_none("crowds", scene=scene, characters=characters, variant=variant, quantity=quantity)
            def a_man(us):
                return None if us is None else us / characters
            rows.append({"characters": characters, **{q: of(q) for q in ("pairs_of_boxes", "contacts", "triangle_pairs", "share_of_clusters_skinned")},
                         "us": [a_man(of("us_per_frame", variant)) for _, variant in BASELINES],
                         "kinds": [(a_man(of("us_per_frame", "clusters" + kind)), a_man(fastest[kind].get(characters)), gain(results, scene, characters, kind)) for kind in KINDS],
                         "broad_phase": 1000 * a_man(of("us_per_frame", "broad_phase"))})
        lines = [Line(label, times(results, scene, variant)) for label, variant in LINES]
        scenes.append({"name": scene, "rows": rows, "exponent": exponent(results, scene, "clusters"),
                       "plot": Plot(scene, "characters", "us a frame", lines, log_x=True, log_y=True).svg()})
    fitted = [men for men, _ in times(results, scenes[0]["name"], "clusters")[-FITTED:]]
    return {"scenes": scenes, "fitted": fitted, "labels": [label for label, _ in BASELINES], "kinds": list(KINDS.values())}
