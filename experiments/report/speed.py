# SPDX-License-Identifier: GPL-3.0-or-later
"""Speed of the refits, tightness against it, and batches in SIMD packs."""
from dataclasses import dataclass

from .plots import Line, Plot
from .statistics import is_on_cut, mean, span
from .tables import ALL

BY_LEVEL = ["spherical_repaired", "control_miniball", "control_sets_miniball", "control_mixed", "control_many_pieces"]
TIGHTEST = "control_many_pieces"


@dataclass
class Price:
    """A Price is that of one variant on one model."""
    variant: str
    skinning: str
    ns_per_sphere: float      # over the whole tree
    time_ratio_to_repaired: float
    mean_ratio: float         # of average radius / optimal, over all levels and pose sets
    worst_ratio: float        # of these the largest
    misses: int               # balls with a vertex outside
    on_cut: bool = False    # no other variant of this skinning is as cheap and has a smaller worst_ratio


def prices(results, model):
    """Returns the variants of a model that were timed and measured, cheapest first."""
    skinning = {row.variant: row.skinning for row in results.rows("variants")}
    out = []
    for row in results.find("speed", model=model, quantity="ns_per_sphere", level=ALL):
        ratios = [r.value for r in results.find("tightness", model=model, variant=row.variant, quantity="radius_ratio_to_optimal")]
        if ratios:
            out.append(Price(row.variant, skinning[row.variant], row.value,
                             results.number("speed", model=model, variant=row.variant, quantity="time_ratio_to_repaired", level=ALL),
                             mean(ratios), max(ratios),
                             round(sum(r.value for r in results.find("tightness", model=model, variant=row.variant, quantity="missed_balls")))))
    out.sort(key=lambda price: price.ns_per_sphere)
    for price in out:
        price.on_cut = is_on_cut((price.ns_per_sphere, price.worst_ratio),
                                     [(p.ns_per_sphere, p.worst_ratio) for p in out if p.skinning == price.skinning])
    return out


def price_plot(model, all_prices):
    spherical = [p for p in all_prices if p.skinning == "spherical"]
    return Plot(f"{model}, spherical blending", "ns per sphere", "average radius / Optimal: worst level",
                [Line(p.variant, [(p.ns_per_sphere, p.worst_ratio)]) for p in spherical], log_x=True,
                front=[(p.ns_per_sphere, p.worst_ratio) for p in spherical if p.on_cut]).svg()


def level_plot(results, model):
    lines = [Line(variant, sorted((r.level, r.value) for r in results.find(
        "speed", model=model, variant=variant, quantity="ns_per_sphere", level=lambda l: l != ALL))) for variant in BY_LEVEL]
    return Plot(f"{model}: cost by level", "level of the tree", "ns per sphere", lines, log_y=True).svg()


def summary(variant, of_models):
    """Returns what the run says of one variant over all models. of_models are their prices."""
    mine = [p for of_model in of_models.values() for p in of_model if p.variant == variant]
    return {"variant": variant, "costs": span(p.time_ratio_to_repaired for p in mine) if mine else None,
            "worst": max((p.worst_ratio for p in mine), default=None)}


def section(results, page):
    return {"rows": [{"model": r.model, "pose": r.pose, "variant": r.variant, "ns": r.value,
                      "ratio": results.number("speed", model=r.model, pose=r.pose, variant=r.variant, level=ALL,
                                              quantity="time_ratio_to_repaired")}
                     for r in results.select("speed", quantity="ns_per_sphere", level=ALL)]}


def pareto_section(results, page):
    of_models = {model: prices(results, model) for model in results.distinct("speed", "model")}
    default = results.default_variant()
    return {"prices": of_models, "price_plot": price_plot, "level_plot": lambda model: level_plot(results, model),
            "default": summary(default, of_models), "through_descendants": summary(f"{default}_through_descendants", of_models),
            "tightest": summary(TIGHTEST, of_models)}


def batch_section(results, page):
    rows = []
    for r in results.select("batch_speed", unit="ns"):
        where = {"model": r.model, "pose": r.pose, "operation": r.operation, "variant": r.variant}
        rows.append({**where, "ns": r.value,
                     "ratio": results.number("batch_speed", quantity="time_ratio_to_scalar", **where),
                     **{name: results.number_or_none("batch_speed", quantity=quantity, **where)
                        for name, quantity in (("to_linear", "time_ratio_to_linear"), ("chain", "longest_chain_share"), ("lanes", "lanes_used"))}})
    return {"rows": rows}
