# SPDX-License-Identifier: GPL-3.0-or-later
"""Deformations: how tight refits are of characters whose joints scale, that have morph targets or a reduced deformation, beside the smallest balls of
the deformed and skinned vertices; what they miss, and what they cost."""
from .plots import Line, Plot
from .statistics import mean

# The kinds are in the order of tables. own is as the model's own clips have it.
KINDS = {"rigid": "rigid", "scaled": "scaled", "scaled_along_axes": "scaled along axes", "morphed": "morphed", "both": "both", "own": "its own"}
MADE_UP = ("scaled", "scaled_along_axes", "morphed", "both")
VARIANTS = {"linear_mixed": "linear, default", "control_mixed": "spherical, default", "dual_quaternion_mixed": "dual quat., default",
            "control_many_pieces": "spherical, many pieces", "spherical_repaired": "Algorithm 1 repaired"}
DEFAULTS = ("linear_mixed", "control_mixed", "dual_quaternion_mixed")
GOALS = {"default": 1.12, "tightest": 1.05}
# These say what (variant, balls of displacements) of a reduced deformation is.
REDUCED = {("reference_balls", "bd_tree"): "BD-tree", ("reference_balls", "smallest"): "smallest balls of displacements", ("control_mixed", "smallest"): "pieces, default",
           ("control_many_pieces", "smallest"): "pieces, many"}
SKINNED = {("spherical_repaired", "bd_tree"): "BD-tree, then Algorithm 1 repaired", ("spherical_repaired", "smallest"): "smallest balls, then Algorithm 1 repaired",
           ("control_miniball", "bd_tree"): "BD-tree, then a control hull", ("control_miniball", "smallest"): "smallest balls, then a control hull",
           ("control_mixed", "smallest"): "pieces, default", ("control_many_pieces", "smallest"): "pieces, many"}
REDUCED_KINDS = {"vibration": ("A vibration, no skinning", REDUCED), "clip": ("A clip’s skinned vertices, no skinning", REDUCED),
                 "vibration_skinned": ("The vibration, then spherical skinning", SKINNED)}


def levels(results, **where):
    """Returns (level, ratio to the smallest balls) of one model and variant."""
    return [(row.level, row.value) for row in results.find("deformations", quantity="radius_ratio_to_optimal", **where)]


def worst(results, **where):
    """Returns the greatest ratio of any level of any model that matches, or None."""
    return max((ratio for _, ratio in levels(results, **where)), default=None)


def misses(results, **where):
    return round(sum(row.value for row in results.find("deformations", quantity="missed_balls", **where)))


def balls(results, **where):
    return round(sum(row.value for row in results.find("deformations", quantity="nodes", **where)))


def models_of(results, kind):
    return results.distinct("deformations", "model", kind=kind, quantity="radius_ratio_to_optimal")


def tightness_rows(results):
    """Returns a row for each model and kind."""
    rows = []
    for kind in KINDS:
        for model in models_of(results, kind):
            ratios = {v: worst(results, model=model, kind=kind, variant=v) for v in VARIANTS}
            rows.append({"model": model, "kind": KINDS[kind], "is_rigid": kind == "rigid", "ratios": ratios, "misses": misses(results, model=model, kind=kind),
                         "balls": balls(results, model=model, kind=kind)})
    return sorted(rows, key=lambda row: order(results, row["model"]))


def order(results, model):
    return results.distinct("deformations", "model").index(model)


def goals(results):
    """Returns, by variant, the worst ratio of a deformed character, the goal, and in how many of the cases it is reached."""
    out = []
    for variant in (*DEFAULTS, "control_many_pieces"):
        goal = GOALS["default" if variant in DEFAULTS else "tightest"]
        ratios = [ratio for kind in (*MADE_UP, "own") for model in models_of(results, kind) if (ratio := worst(results, model=model, kind=kind, variant=variant))]
        if ratios:
            out.append({"name": variant, "variant": VARIANTS[variant], "goal": goal, "worst": max(ratios), "reached": sum(r <= goal for r in ratios), "cases": len(ratios)})
    return out


def costs(results):
    """Returns a row for each variant and kind: the cost over the rigid refit of the same run, as the mean over the models."""
    rows = []
    for variant in DEFAULTS:
        for kind in MADE_UP:
            changing, kept, ns = ([row.value for row in results.find("deformations", variant=variant, kind=kind, quantity=q)]
                                  for q in ("time_ratio_to_rigid", "time_ratio_to_rigid_deformation_kept", "ns_per_sphere"))
            if changing:
                rows.append({"variant": VARIANTS[variant], "kind": KINDS[kind], "ns": mean(ns), "changing": mean(changing), "kept": mean(kept)})
    return rows


def cost_ratios(results):
    """Returns the costs over the rigid refit of the same run, by default variant, kind and model, where every frame has a new deformation."""
    return results.values("deformations", quantity="time_ratio_to_rigid", kind=lambda k: k in MADE_UP, variant=lambda v: v in DEFAULTS)


def reduced_table(results, kind):
    """Returns the table, or None if there is none."""
    title, methods = REDUCED_KINDS[kind]
    models = results.distinct("deformations", "model", kind=kind, variant="basis")
    if not models:
        return None

    def of_model(model, quantity):
        return results.number("deformations", model=model, kind=kind, variant="basis", quantity=quantity)
    rows = [{"method": words, "ratios": [worst(results, model=m, kind=kind, variant=v, displacements=d) for m in models],
             "misses": misses(results, kind=kind, variant=v, displacements=d), "cost": cost_to_bd_tree(results, kind, v, d)} for (v, d), words in methods.items()]
    return {"title": title, "models": models, "shares": [of_model(m, "share_of_squared_displacements") for m in models], "size": round(of_model(models[0], "basis_vectors")),
            "frames": round(of_model(models[0], "frames")), "rows": rows, "has_costs": any(row["cost"] for row in rows)}


def cost_to_bd_tree(results, kind, variant, displacements):
    """Returns the mean over the models, or None if it was not measured."""
    found = [row.value for row in results.find("deformations", kind=kind, variant=variant, displacements=displacements, quantity="time_ratio_to_bd_tree")]
    return mean(found) if found else None


def plot(results, model):
    lines = [Line(KINDS[kind], levels(results, model=model, kind=kind, variant="control_mixed"), dashed=kind == "rigid", color="ink" if kind == "rigid" else "")
             for kind in KINDS]
    return Plot(f"{model}, control_mixed", "level of the tree", "average radius / Optimal", lines).svg()


def reduced_plot(results, model):
    lines = [Line(words, levels(results, model=model, kind="vibration_skinned", variant=v, displacements=d)) for (v, d), words in SKINNED.items()]
    return Plot(f"{model}, vibration and spherical skinning", "level of the tree", "average radius / Optimal", lines).svg()


def section(results, page):
    rows = tightness_rows(results)
    if not rows:  # models without clips
        return None
    first = rows[0]["model"]
    facts = [{"model": m, **{q: round(results.number("deformations", model=m, kind="model", quantity=q)) for q in ("joints", "morph_targets")}} for m in models_of(results, "own")]
    tables = [table for kind in REDUCED_KINDS if (table := reduced_table(results, kind))]
    return {"rows": rows, "variants": VARIANTS, "goals": goals(results), "costs": costs(results), "facts": facts, "reduced": tables,
            "misses": misses(results), "balls": balls(results), "plot": plot(results, first),
            "reduced_plot": reduced_plot(results, tables[0]["models"][0]) if tables else None}
