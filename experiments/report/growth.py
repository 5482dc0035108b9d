# SPDX-License-Identifier: GPL-3.0-or-later
"""Growth with triangles and joints."""
from .plots import Line, Plot
from .statistics import fitted_exponent

FITTED_FROM = 4000     # triangles: below, what does not grow dominates
FITTED_JOINTS = (100, 1000)  # these two numbers


def triangle_times(results, scene, detector):
    """Returns (triangles, us a frame), in ascending order."""
    return sorted((r.triangles, r.value) for r in results.select("triangle_growth", scene=scene, variant=detector, quantity="us_per_frame"))


def triangle_exponent(results, scene, detector):
    return fitted_exponent([point for point in triangle_times(results, scene, detector) if point[0] >= FITTED_FROM])


def triangles_section(results, page):
    detectors = results.distinct("triangle_growth", "variant")
    scenes = []
    for scene in results.distinct("triangle_growth", "scene"):
        lines = [Line(d, triangle_times(results, scene, d)) for d in detectors]
        scenes.append({"name": scene, "plot": Plot(scene, "triangles", "us a frame", lines, log_x=True, log_y=True).svg(),
                       "rows": [(line.label, [us for _, us in line.points], triangle_exponent(results, scene, line.label)) for line in lines],
                       "pairs": [r.value for r in sorted(results.select("triangle_growth", scene=scene, variant=detectors[0], quantity="pairs"),
                                                         key=lambda r: r.triangles)]})
    return {"scenes": scenes, "numbers": sorted(results.distinct("triangle_growth", "triangles"))}


# --- Joints ---

JOINT_LINES = [("by itself", "own", "ns_of_root"), ("by a BVH cut", "through_descendants", "ns_of_root"),
               ("by a known cut", "through_descendants", "ns_of_root_from_known_cut")]


def joint_times(results, variant, quantity):
    """Returns (joints, ns), in ascending order. Some quantities have no row for 0 joints."""
    return sorted((r.joints, r.value) for r in results.select("joint_growth", variant=variant, quantity=quantity))


def joint_exponent(results):
    """Returns the exponent of the root's cost from a known cut."""
    return fitted_exponent([p for p in joint_times(results, "through_descendants", "ns_of_root_from_known_cut") if p[0] in FITTED_JOINTS])


def joints_section(results, page):
    lines = [Line(label, [(n, ns / 1000) for n, ns in joint_times(results, variant, quantity)]) for label, variant, quantity in JOINT_LINES]
    rows = []
    for joints in results.distinct("joint_growth", "joints"):
        def of(variant, quantity):
            return results.number_or_none("joint_growth", joints=joints, variant=variant, quantity=quantity)
        ns = [("own", "ns_of_nodes_of_many"), ("through_descendants", "ns_of_nodes_of_many"), ("own", "ns_of_root"), ("through_descendants", "ns_of_root"),
              ("through_descendants", "ns_of_root_from_known_cut")]
        rows.append({"joints": joints, "sets": round(of("own", "joint_sets")), "many": round(of("own", "nodes_of_many_joint_sets")),
                     "us": [None if (t := of(*which)) is None else t / 1000 for which in ns],
                     "ratios": [of(variant, "radius_ratio_to_optimal_of_root") for variant in ("own", "through_descendants")]})
    return {"exponent": joint_exponent(results), "fitted": FITTED_JOINTS, "rows": rows,
            "plot": Plot("the root's ball", "joints", "us", lines, log_x=True, log_y=True).svg()}
