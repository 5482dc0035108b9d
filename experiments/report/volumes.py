# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxes, k-DOPs and oriented boxes around the same control points."""
from .statistics import mean
from .tables import ALL


def section(results, page):
    rows = []
    for cost in results.select("volumes", quantity="ns_per_node", level=ALL):
        def of(quantity):
            return [r.value for r in results.find("volumes", model=cost.model, variant=cost.variant, quantity=quantity,
                                                  level=lambda l: l != ALL)]
        ratios = of("size_ratio_to_optimal")
        if not ratios:  # the ball that the volumes are compared with
            continue
        volumes = of("volume_ratio_to_ball")  # of flat nodes there are none
        rows.append({"model": cost.model, "variant": cost.variant, "mean": mean(ratios), "worst": max(ratios),
                     "size_ratio_to_ball": mean(of("size_ratio_to_ball")), "volume_ratio_to_ball": mean(volumes) if volumes else None,
                     "misses": round(sum(of("missed_volumes"))), "ns": cost.value,
                     "time_ratio_to_ball": results.number("volumes", model=cost.model, variant=cost.variant, level=ALL,
                                                     quantity="time_ratio_to_ball")})
    return {"rows": rows}
