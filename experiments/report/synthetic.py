# SPDX-License-Identifier: GPL-3.0-or-later
"""Synthetic cases in exact rationals: what each variant misses, how loose it is, what it costs."""

QUANTITIES = ["cases", "undefined", "unbounded", "missed_cases", "missed_cases_beyond_tolerance", "worst_miss"]
NOT_ALWAYS = ["looseness_mean", "looseness_median", "looseness_max", "ns_per_refit"]


def section(results, page):
    rows = []
    for variant in results.distinct("synthetic", "variant", pose="all"):
        row = {q: results.number("synthetic", variant=variant, pose="all", quantity=q) for q in QUANTITIES}
        row |= {q: results.number_or_none("synthetic", variant=variant, pose="all", quantity=q) for q in NOT_ALWAYS}
        rows.append({"variant": variant, **row})
    return {"rows": rows, "count": round(rows[0]["cases"]), "tolerance": results.constant("synthetic_tolerance")}
