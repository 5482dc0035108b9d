"""What the paper takes from the result files: numbers by name, tables, and the data of plots."""
import csv
import pathlib

from formats import digits, escaped, power_of_ten, table, whole_number
from results import ResultError

MODELS = ["man", "creature", "BCN_Epileptic.X", "Testwuson.X", "Soldier.glb", "leftHandHigh.glb"]
ENGINES = ["embree", "fcl_aabb", "fcl_kdop16", "fcl_obbrss", "bullet_dbvt", "bullet_gimpact"]
SCENES = ["far", "near", "light", "heavy", "worst"]
GROWN_SCENES = ["near", "light", "heavy"]
SPHERICAL = {  # as the tables call the variants of spherical blending
    "spherical_repaired": "repaired",
    "spherical_exact": "repaired, smallest balls",
    "control_exact": "control points, a ball a node",
    "control_sets_exact": "control points, a ball a joint-set",
    "control_mixed": "control points or vertices (default)",
    "control_clusters": "control points, clusters",
}
PRINTED = {
    "spherical_printed": "as printed",
    "spherical_printed_signed": "as printed, skinning's signs",
    "spherical_printed_exact": "as printed, skinning's signs, smallest balls",
    "linear_under_spherical": "linear refit, spherical skin",
}


def is_clip(posture):
    """A clip of a model, and not a posture made to twist one joint."""
    return " twisted by " not in posture and not posture.startswith(("full twist", "worst twist"))


def is_figure_twist(posture):
    return " twisted by " in posture or posture == "full twist"


def values(rows):
    return [float(row["value"]) for row in rows]


# --- Single quantities ---

def worst_ratio(results, variant, posture=is_clip):
    """The largest average ratio to the optimal radius, over models, postures and levels."""
    return max(values(results.select("tightness", variant=variant, quantity="ratio_to_optimal", posture=posture)))


def total(results, file, **where):
    return sum(values(results.select(file, **where)))


def cost_ratios(results, variant):
    return values(results.select("speed", variant=variant, quantity="ratio_to_repaired", level="all"))


def time_of(results, scene, detector, query="full"):
    return results.number("collision", model="man", posture=f"{scene}, {query}", variant=detector, level="all",
                          quantity="us_per_frame")


def grown_time(results, triangles, scene, detector):
    return results.number("triangle_growth", model=f"man of {triangles} triangles", posture=scene, variant=detector,
                          quantity="us_per_frame")


def largest_growth(results):
    return max(int(v) for v in values(results.select("triangle_growth", quantity="triangles")))


def fastest_engine(results, scene):
    found = results.select("collision", model="man", posture=f"{scene}, full", level="all", quantity="us_per_frame",
                           variant=lambda v: v in ENGINES)
    return min(values(found))


def pairs_of(results, scene):
    return results.number("collision", model="man", posture=f"{scene}, full", variant="clusters", level="all",
                          quantity="pairs")


def fewer_spheres(results):
    """Spheres refitted by Algorithm 1 repaired over those by the default, where anything is near."""
    def refitted(scene, variant):
        return results.number("collision", model="man", posture=f"{scene}, full", variant=variant, level="all",
                              quantity="nodes_refitted")
    return [refitted(s, "spherical_repaired") / refitted(s, "control_mixed") for s in SCENES if s != "far"]


def batch_gains(results):
    return [1 / v for v in values(results.select("batch_speed", variant="refit_spherical_avx512",
                                                 quantity="ratio_to_scalar"))]


def original_table(folder):
    """The original's Table 1, which is no result of ours: (level, reference, linear, spherical, optimal), averages."""
    with open(pathlib.Path(folder) / "original_table1.csv", newline="") as file:
        return [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]


# --- The paper's numbers ---

def numbers(results, folder):
    out = {}
    for row in original_table(folder)[:2]:
        out[f"original.level{row['level']:.0f}"] = f"{row['spherical'] / row['optimal']:.2f}"
    for variant in ["spherical_repaired", "spherical_exact", "control_mixed", "control_clusters"]:
        out[f"worst.{variant}"] = digits(worst_ratio(results, variant))
    out["twist.control_mixed"] = digits(worst_ratio(results, "control_mixed", is_figure_twist))
    for variant in ["control_mixed", "control_clusters"]:
        ratios = cost_ratios(results, variant)
        out[f"cost.{variant}.least"], out[f"cost.{variant}.most"] = digits(min(ratios), 2), digits(max(ratios), 2)
    ratios = cost_ratios(results, "linear")
    out["cost.linear.least"], out["cost.linear.most"] = digits(min(ratios), 2), digits(max(ratios), 2)
    sound = [*SPHERICAL, "linear", "linear_mixed", "dual_quaternion_mixed"]
    out["sound.misses"] = whole_number(total(results, "tightness", quantity="misses", variant=lambda v: v in sound))
    out["sound.balls"] = whole_number(total(results, "tightness", quantity="nodes", variant=lambda v: v in sound))
    out["volumes.misses"] = whole_number(total(results, "volumes", quantity="misses"))
    fewer = fewer_spheres(results)
    out["spheres.least"], out["spheres.most"] = digits(min(fewer), 2), digits(max(fewer), 2)
    gains = batch_gains(results)
    out["batch.least"], out["batch.most"] = digits(min(gains), 2), digits(max(gains), 2)
    for scene in SCENES:
        out[f"engine.{scene}"] = digits(fastest_engine(results, scene) / time_of(results, scene, "clusters"), 2)
        out[f"skinall.{scene}"] = digits(time_of(results, scene, "skin_all_simd") / time_of(results, scene, "clusters"), 2)
        out[f"repaired.{scene}"] = digits(time_of(results, scene, "spherical_repaired") / time_of(results, scene, "clusters"), 2)
    most = largest_growth(results)
    out["growth.triangles"] = whole_number(most)
    for scene in GROWN_SCENES:
        out[f"growth.engine.{scene}"] = digits(
            grown_time(results, most, scene, "embree") / grown_time(results, most, scene, "clusters"), 2)
    for detector in ["clusters", "skin_all_simd", "embree"]:
        for scene in GROWN_SCENES:
            exponent = results.number(
                "triangle_growth", model="man", posture=scene, variant=detector, quantity="triangle_exponent")
            out[f"exponent.{detector}.{scene}"] = f"${digits(exponent, 2)}$"
    snakes = results.select("joint_growth", variant="own", quantity="joint_sets")
    largest = max(snakes, key=lambda row: float(row["value"]))["model"]
    ns = {v: results.number("joint_growth", model=largest, variant=v, quantity=q) for v, q in
          [("own", "ns_of_root"), ("from_below", "ns_of_root_from_known")]}
    out["joints.sets"] = whole_number(max(values(snakes)))
    out["joints.own"], out["joints.below"] = digits(ns["own"] / 1000, 2), digits(ns["from_below"] / 1000, 2)
    out["joints.ratio"] = digits(results.number("joint_growth", model=largest, variant="from_below",
                                                quantity="root_ratio_to_optimal"))
    crowd = max(results.select("character_growth", variant="clusters", quantity="us_per_frame"),
                key=lambda row: int(row["model"].split()[0]))
    out["crowd.men"] = whole_number(int(crowd["model"].split()[0]))
    out["crowd.ms"] = digits(float(crowd["value"]) / 1000, 2)
    out["crowd.contacts"] = whole_number(results.number("character_growth", model=crowd["model"], variant="clusters",
                                                        quantity="contacts"))
    out["rounding.checks"] = whole_number(total(results, "rounding", quantity="exact_checks"))
    out["rounding.misses"] = whole_number(total(results, "rounding", quantity="misses") +
                                          total(results, "rounding", quantity="float_misses"))
    verdicts = results.rows("verdicts")
    out["verdicts.refuted"] = whole_number(len({r["lemma"] for r in verdicts if r["verdict"] == "refuted"}))
    out["verdicts.held"] = whole_number(sum(float(r["cases"]) for r in verdicts if r["verdict"] == "holds"))
    return out


# --- Tables ---

def tightness_table(results, model, posture):
    variants = [*SPHERICAL, "bottom_up"]
    names = {**SPHERICAL, "bottom_up": "skinned, bottom-up"}
    levels = [1, 2, 3, 4, 6, 8, 10, 12]
    rows = [[names[v], *(f"{results.number('tightness', model=model, posture=posture, variant=v, level=str(l), quantity='ratio_to_optimal'):.2f}"
                         for l in levels)] for v in variants]
    return table("l" + "r" * len(levels), ["", *map(str, levels)], rows)


def worst_table(results):
    rows = []
    for variant, name in SPHERICAL.items():
        each = [max(values(results.select("tightness", model=m, variant=variant, quantity="ratio_to_optimal", posture=is_clip)))
                for m in MODELS]
        rows.append([name, *(f"{v:.2f}" for v in each)])
    return table("l" + "r" * len(MODELS), ["", *map(short_model, MODELS)], rows)


def short_model(name):
    return {"BCN_Epileptic.X": "Epileptic", "Testwuson.X": "Wuson", "Soldier.glb": "Soldier",
            "leftHandHigh.glb": "hand"}.get(name, name)


def misses_table(results):
    rows = []
    for variant, name in PRINTED.items():
        cells = [name]
        for kind in (is_clip, is_figure_twist):
            balls, misses, undefined = (total(results, "tightness", variant=variant, quantity=q, posture=kind)
                                        for q in ("nodes", "misses", "undefined"))
            cells += [f"{100 * misses / balls:.2g}\\,\\%", f"{100 * undefined / balls:.2g}\\,\\%"]
        rows.append(cells)
    return table("lrrrr", ["", "clips: missed", "undefined", "twists: missed", "undefined"], rows)


def cost_table(results):
    variants = {"linear": "linear \\cite{KavanZara2005a}", **SPHERICAL}
    rows = []
    for variant, name in variants.items():
        ratios = [results.number("speed", model=m, variant=variant, level="all", quantity="ratio_to_repaired") for m in MODELS]
        rows.append([name, *(f"{r:.2f}" for r in ratios)])
    rows += [None, ["repaired, ns a sphere", *(whole_number(results.number(
        "speed", model=m, variant="spherical_repaired", level="all", quantity="ns_per_sphere")) for m in MODELS)]]
    return table("l" + "r" * len(MODELS), ["", *map(short_model, MODELS)], rows)


def batch_table(results):
    rows = []
    for what, name, unit in [("refit_linear", "refit, linear", "ns_per_sphere"),
                             ("refit_spherical", "refit, Algorithm 1 repaired", "ns_per_sphere"),
                             ("skin_linear", "skinning, linear", "ns_per_vertex"),
                             ("skin_spherical", "skinning, spherical", "ns_per_vertex"),
                             ("skin_dual_quaternion", "skinning, dual quaternion", "ns_per_vertex")]:
        rows.append([name, *(digits(results.number("batch_speed", model="man", variant=f"{what}_{target}", quantity=unit), 2)
                             for target in ["scalar", "baseline", "avx2", "avx512"])])
    return table("lrrrr", ["ns a sphere or vertex", "scalar", "SSE2", "AVX2", "AVX-512"], rows)


def volumes_table(results):
    def mean(variant, quantity):
        found = values(results.select("volumes", variant=variant, quantity=quantity, posture=is_clip,
                                      level=lambda l: l in ("3", "4", "5", "6")))
        return sum(found) / len(found)
    names = {"aabb": "axis-aligned box", "obb": "oriented box", "dop14": "14-DOP", "dop18": "18-DOP", "dop26": "26-DOP"}
    rows = []
    for variant, name in names.items():
        cost = values(results.select("volumes", variant=variant, quantity="ratio_to_ball", level="all"))
        rows.append([name, f"{mean(variant, 'ratio_to_optimal'):.2f}", f"{mean(variant, 'volume_to_ball'):.2f}",
                     f"{min(cost):.1f}--{max(cost):.1f}"])
    return table("lrrr", ["", "size / smallest", "volume / ball", "cost / ball"], rows)


def rounding_table(results):
    names = {"linear": "linear \\cite{KavanZara2005a}", "linear_mixed": "linear, control points or vertices", **SPHERICAL,
             "dual_quaternion_mixed": "dual quaternions, the same"}
    rows = []
    for variant, name in names.items():
        def of(quantity):
            return values(results.select("rounding", variant=variant, quantity=quantity))
        rows.append([name, f"{100 * sum(of('misses_as_computed')) / sum(of('exact_checks')):.2g}\\,\\%",
                     whole_number(sum(of("misses") + of("float_misses"))), power_of_ten(max(of("inflation_median"))),
                     power_of_ten(max(of("float_inflation_median"))), f"{min(of('cost_ratio')):.2f}--{max(of('cost_ratio')):.2f}"])
    return table("lrrrrr", ["", "outside without", "with", "adds", "adds, float", "cost"], rows)


def collision_table(results):
    names = [("clusters", "clusters (ours)"), ("spherical_repaired", "spheres on demand, repaired"),
             ("control_mixed", "spheres on demand, default"), None, ("skin_all_simd", "skin all in SIMD, boxes"),
             ("aabb_tree", "skin all, boxes bottom-up"), ("brown", "skin all, spheres bottom-up \\cite{Brown2001}"),
             ("embree", "Embree"), ("bullet_gimpact", "Bullet GImpact"), ("fcl_aabb", "FCL, boxes"),
             ("fcl_obbrss", "FCL, OBB-RSS"), None]
    rows = [None if entry is None else [entry[1], *(digits(time_of(results, scene, entry[0])) for scene in SCENES)]
            for entry in names]
    rows.append(["touching pairs", *(f"{pairs_of(results, scene):.0f}" for scene in SCENES)])
    return table("l" + "r" * len(SCENES), ["\\textmu s a frame", *SCENES], rows)


def provenance_table(results):
    for name in ["tightness", "speed", "volumes", "batch_speed", "rounding", "collision", "triangle_growth", "joint_growth",
                 "character_growth", "verdicts"]:
        results.rows(name)
    rows = [[f"\\texttt{{{escaped(name)}.csv}}", f"\\texttt{{{p['commit']}}}", escaped(p["compiler"]), escaped(p["cpu"])]
            for name, p in results.provenance.items()]
    return table("llll", ["file", "commit", "compiler", "processor"], rows)


def verdict_table(results, lemmas):
    """lemmas: the stems that must be there."""
    def cell(rows, verdict):
        chosen = [r for r in rows if r["verdict"] == verdict]
        cases = sum(float(r["cases"]) for r in chosen)
        if not chosen:
            return "", ""
        share = sum(float(r["cases"]) * float(r["degenerate_share"]) for r in chosen) / cases
        return whole_number(cases), f"{100 * share:.0f}\\,\\%"
    out = []
    for stem in lemmas:
        rows = results.select("verdicts", lemma=stem)
        if any(r["verdict"] not in ("holds", "refuted") for r in rows):
            raise ResultError(f"verdicts.csv: a test of {stem} failed")
        printed = [r for r in rows if r["form"] == "printed"]
        refuted = [int(r["cases"]) for r in printed if r["verdict"] == "refuted"]
        as_printed = f"refuted after {min(refuted)}" if refuted else f"holds ({cell(printed, 'holds')[0]})" if printed else ""
        held, degenerate = cell([r for r in rows if r["form"] != "printed"], "holds")
        out.append([f"\\texttt{{{escaped(stem)}}}", as_printed, held, degenerate])
    return table("llrr", ["statement", "as printed", "repaired or new: cases", "degenerate"], out)


def tables(results, lemmas):
    return {"tightness_man": tightness_table(results, "man", "walk"),
            "tightness_twist": tightness_table(results, "man", "full twist"),
            "worst": worst_table(results), "misses": misses_table(results), "cost": cost_table(results),
            "batch": batch_table(results), "volumes": volumes_table(results), "rounding": rounding_table(results), "collisions": collision_table(results),
            "provenance": provenance_table(results), "verdicts": verdict_table(results, lemmas)}


# --- Data of plots: columns set apart by spaces ---

def tightness_plot(results, model, posture):
    variants = [*SPHERICAL, "bottom_up"]
    levels = sorted({int(r["level"]) for r in results.select("tightness", model=model, posture=posture, variant="control_mixed")})
    lines = ["level " + " ".join(variants)]
    for level in levels:
        lines.append(f"{level} " + " ".join(str(results.number(
            "tightness", model=model, posture=posture, variant=v, level=str(level), quantity="ratio_to_optimal")) for v in variants))
    return "\n".join(lines) + "\n"


def growth_plot(results, scene):
    detectors = ["clusters", "spherical_repaired", "control_mixed_from_below", "skin_all_simd", "embree"]
    sizes = sorted({int(float(r["value"])) for r in results.select("triangle_growth", posture=scene, quantity="triangles")})
    lines = ["triangles " + " ".join(detectors)]
    lines += [f"{n} " + " ".join(str(grown_time(results, n, scene, d)) for d in detectors) for n in sizes]
    return "\n".join(lines) + "\n"


def pareto_plot(results, model):
    """Cost of each variant in the model's twist and its tightness in the walk, mean over the levels."""
    lines = ["cost ratio label"]
    for variant in SPHERICAL:
        ratio = values(results.select("tightness", model=model, posture="walk", variant=variant,
                                      quantity="ratio_to_optimal"))
        cost = results.number("speed", model=model, variant=variant, level="all", quantity="ratio_to_repaired")
        lines.append(f"{cost} {sum(ratio) / len(ratio)} {variant.replace('_', '-')}")
    return "\n".join(lines) + "\n"


def plots(results):
    return {"tightness_man": tightness_plot(results, "man", "walk"),
            "tightness_soldier": tightness_plot(results, "Soldier.glb", "Run"),
            "growth_near": growth_plot(results, "near"), "growth_light": growth_plot(results, "light"),
            "pareto": pareto_plot(results, "man")}
