# SPDX-License-Identifier: GPL-3.0-or-later
"""Crowds of characters in one scene."""
from .plots import Line, Plot
from .statistics import fitted_exponent

FITTED = 3  # the largest numbers of characters
LINES = [("all pairs", "clusters"), ("all pairs, two threads", "clusters_on_two_threads"), ("yes/no", "clusters_yes_no"),
         ("skin everything in float", "skin_all_float"), ("the same, clusters of 512", "skin_all_float_512"),
         ("skin where motion bounds meet", "skin_all_float_bounded"), ("the same, clusters of 512", "skin_all_float_512_bounded")]
RIVALS = [detector for _, detector in LINES if detector.startswith("skin_all")]


def times(results, scene, variant):
    """Returns (characters, us a frame), in ascending order, or none if there were no threads."""
    return sorted((r.characters, r.value) for r in results.find("crowds", scene=scene, variant=variant, quantity="us_per_frame"))


def exponent(results, scene, variant):
    return fitted_exponent(times(results, scene, variant)[-FITTED:])


def gain(results, scene, characters):
    """Returns how many times as fast a full query is as the fastest detector that skins whole bodies."""
    def us(variant):
        return results.number("crowds", scene=scene, characters=characters, variant=variant, quantity="us_per_frame")
    return min(us(rival) for rival in RIVALS) / us("clusters")


def crowds_section(results, page):
    scenes = []
    for scene in results.distinct("crowds", "scene"):
        rows = []
        for characters in results.distinct("crowds", "characters", scene=scene):
            def of(quantity, variant="clusters"):
                return results.number_or_none("crowds", scene=scene, characters=characters, variant=variant, quantity=quantity)
            rows.append({"characters": characters, **{q: of(q) for q in ("pairs_of_boxes", "contacts", "triangle_pairs", "share_of_clusters_skinned")},
                         "us": [None if (us := of("us_per_frame", variant)) is None else us / characters for _, variant in LINES],
                         "broad_phase": 1000 * of("us_per_frame", "broad_phase") / characters, "gain": gain(results, scene, characters)})
        lines = [Line(label, times(results, scene, variant)) for label, variant in LINES if variant in ("clusters", "clusters_on_two_threads",
                 "clusters_yes_no", "skin_all_float", "skin_all_float_bounded")]
        scenes.append({"name": scene, "rows": rows, "exponent": exponent(results, scene, "clusters"),
                       "plot": Plot(scene, "characters", "us a frame", lines, log_x=True, log_y=True).svg()})
    fitted = [men for men, _ in times(results, scenes[0]["name"], "clusters")[-FITTED:]]
    return {"scenes": scenes, "fitted": fitted, "labels": [label for label, _ in LINES]}
