# SPDX-License-Identifier: GPL-3.0-or-later
"""Rounding: whether a vertex skinned exactly is ever outside, and what the slack adds and costs."""


def section(results, page):
    rows = []
    for checks in results.select("rounding", quantity="exact_checks"):
        def of(quantity):
            return results.number("rounding", model=checks.model, variant=checks.variant, quantity=quantity)
        rows.append({"model": checks.model, "variant": checks.variant, "checks": round(checks.value),
                     "misses": round(of("missed_vertices")), "float_misses": round(of("missed_vertices_in_float")),
                     "percent_without_slack": 100 * of("missed_vertices_without_slack") / checks.value,
                     "inflation": of("inflation_median"), "float_inflation": of("float_inflation_median"), "cost": of("time_ratio_to_without_slack")})
    return {"rows": rows}
