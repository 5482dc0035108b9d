# SPDX-License-Identifier: GPL-3.0-or-later
"""What the paper takes from the tables of results: numbers by name, tables, and the data of plots."""
import pathlib
import re

from . import collisions, crowds, deformations, engines, growth, original, over_time, statements
from .formats import broken_name, digits, escaped, long_table, power_of_ten, table, whole_number
from .statistics import mean, span
from .tables import ALL, ResultError, stored
from .verdicts import of_stem, refutations, said_of_claims, summed_up

REAL_MODELS = re.findall(r'"([^"]+\.\w+)"', (pathlib.Path(__file__).resolve().parents[1] / "scenes/real_models.hpp").read_text())
MODELS = ["man", "creature", *REAL_MODELS]
SCENES = ["far", "near", "light", "heavy", "worst"]
CLOSE_SCENES = ["near", "light", "heavy"]  # of those that grow; far is a matter of the broad phase
GROWN_SCENES = ["far", *CLOSE_SCENES]
SPHERICAL = {  # as the tables call the variants of spherical blending
    "spherical_repaired": "repaired",
    "spherical_miniball": "repaired, smallest balls",
    "control_miniball": "control points, a ball a node",
    "control_sets_miniball": "control points, a ball a joint-set",
    "control_mixed": "control points or vertices (default)",
    "control_many_pieces": "control points, clusters",
}
PRINTED = {
    "spherical_printed": "as printed",
    "spherical_printed_signed": "as printed, skinning's signs",
    "spherical_printed_miniball": "as printed, skinning's signs, smallest balls",
    "linear_under_spherical": "linear refit, spherical skin",
}


# --- Single quantities ---

def worst_ratio(results, variant, kind="clip", **where):
    """The largest average ratio to the optimal radius, over models, poses of this kind and levels."""
    return max(results.values("tightness", variant=variant, quantity="radius_ratio_to_optimal", pose_kind=kind, **where))


def total(results, file, **where):
    return sum(results.values(file, **where))


def is_sound(results):
    """Says of a variant whether it is a refit whose balls hold all vertices."""
    sound = {row.variant for row in results.rows("variants") if row.role == "refit" and row.sound == "yes"}
    return lambda variant: variant in sound


def cost_ratios(results, variant):
    return results.values("speed", variant=variant, quantity="time_ratio_to_repaired", level=ALL)


def time_of(results, scene, detector, query="full", quantity="us_per_frame"):
    return results.number("collisions", model="man", scene=scene, query=query, variant=detector, level=ALL, quantity=quantity)


def times_of_ours(results, scene, ratio):
    """Returns how many times the time of our query another detector takes in the scene, by the ratio of ours to it in the same repetitions."""
    return 1 / time_of(results, scene, "clusters", quantity=ratio)


def gain_without(results, scene, detector):
    """Returns how many times as fast a detector would be if its query alone took any time. All of its stages are of the same passes."""
    stages = [time_of(results, scene, detector, quantity=f"{stage}_us") for stage in collisions.STAGES]
    return sum(stages) / stages[-1]


def grown(results, triangles, scene, detector, quantity="us_per_frame"):
    """Returns a quantity of two men whose meshes have so many triangles."""
    return results.number("triangle_growth", triangles=triangles, scene=scene, variant=detector, quantity=quantity)


def grown_gain(results, scene):
    """Returns how many times the time of our query Embree's takes with the finest meshes, by the ratio in the same repetitions."""
    return 1 / grown(results, largest_growth(results), scene, "clusters", "time_ratio_to_engine")


def largest_growth(results):
    return max(results.distinct("triangle_growth", "triangles"))


def fastest_engine(results, scene):
    found = collisions.fastest_engine(results, "man", scene)
    if found is None:
        raise ResultError(f"{results.path('collisions')}: no engine found all pairs of two men, {scene}")
    return found


def pairs_of(results, scene):
    return time_of(results, scene, "clusters", quantity="pairs")


def fewer_spheres(results):
    """Spheres refitted by Algorithm 1 repaired over those by the default, where anything is near."""
    return [time_of(results, s, "spherical_repaired", quantity="nodes_refitted") / time_of(results, s, "control_mixed", quantity="nodes_refitted")
            for s in SCENES if s != "far"]


def upper_cost_ratios(results, variant):
    """Of spheres on the upper third of a tree's levels, which queries refit most."""
    rows = [(int(row.level), row.model, row.value) for row in results.select("speed", variant=variant, quantity="time_ratio_to_repaired") if row.level != ALL]
    levels = {model: max(level for level, other, _ in rows if other == model) for _, model, _ in rows}
    return [ratio for level, model, ratio in rows if 3 * level <= levels[model]]


def query_ratios(results):
    """Of whole queries with the default refit over those with Algorithm 1 repaired, in all scenes of the man."""
    return [time_of(results, scene, "control_mixed", quantity="time_ratio_to_repaired") for scene in SCENES]


def batch_gains(results):
    return [1 / v for v in results.values("batch_speed", operation="refit_spherical", variant="avx512", quantity="time_ratio_to_scalar")]


def opened_gains(results):
    """How many times as fast the nodes that queries open are bounded, by model, in animation."""
    return [1 / v for v in results.values("batch_speed", operation="bound_opened_nodes", variant="avx512", quantity="time_ratio_to_scalar",
                                          pose=lambda pose: pose.startswith("halfway through "))]


def chain_shares(results):
    """The longest chain of a ball's operations, as shares of the time of refitting one ball after the other, by model."""
    return results.values("batch_speed", operation="refit_spherical", variant="scalar", quantity="longest_chain_share")


# --- The paper's numbers ---

def numbers(results, root):
    out = {}
    for row in original.table1()[:2]:
        out[f"original.level{row.level}"] = f"{row.spherical / row.optimal:.2f}"
    for variant in ["spherical_repaired", "spherical_miniball", "control_mixed", "control_many_pieces"]:
        out[f"worst.{variant}"] = digits(worst_ratio(results, variant))
    out["twist.control_mixed"] = digits(worst_ratio(results, "control_mixed", "twist"))
    for variant in ["control_mixed", "control_many_pieces", "linear"]:
        out[f"cost.{variant}.least"], out[f"cost.{variant}.most"] = (digits(v, 2) for v in span(cost_ratios(results, variant)))
    for name, quantity in [("misses", "missed_balls"), ("balls", "nodes")]:
        out[f"sound.{name}"] = whole_number(total(results, "tightness", quantity=quantity, variant=is_sound(results)))
    out["volumes.misses"] = whole_number(total(results, "volumes", quantity="missed_volumes"))
    out["spheres.least"], out["spheres.most"] = (digits(v, 2) for v in span(fewer_spheres(results)))
    out["default.query.least"], out["default.query.most"] = (digits(v, 2) for v in span(query_ratios(results)))
    out["batch.least"], out["batch.most"] = (digits(v, 2) for v in span(batch_gains(results)))
    for scene in SCENES:
        for name in ("engine", "skin_all", "repaired"):
            out[f"{name.replace('_', '')}.{scene}"] = digits(times_of_ours(results, scene, f"time_ratio_to_{name}"), 2)
    most = largest_growth(results)
    out["growth.triangles"] = whole_number(most)
    for scene in CLOSE_SCENES:
        out[f"growth.engine.{scene}"] = digits(grown_gain(results, scene), 2)
    for detector in ["clusters", "skin_all_float", "embree"]:
        for scene in CLOSE_SCENES:
            out[f"exponent.{detector}.{scene}"] = f"${digits(growth.triangle_exponent(results, scene, detector), 2)}$"
    joints, sets = max(results.distinct("joint_growth", "joints")), results.values("joint_growth", variant="own", quantity="joint_sets")
    out["joints.sets"] = whole_number(max(sets))
    for name, variant, quantity in [("own", "own", "ns_of_root"), ("cold", "through_descendants", "ns_of_root"),
                                    ("below", "through_descendants", "ns_of_root_from_known_cut")]:
        out[f"joints.{name}"] = digits(results.number("joint_growth", joints=joints, variant=variant, quantity=quantity) / 1000, 2)
    out["joints.ratio"] = digits(results.number("joint_growth", joints=joints, variant="through_descendants", quantity="radius_ratio_to_optimal_of_root"))
    men = max(results.distinct("crowds", "characters"))
    us, contacts = (results.number("crowds", scene="dense", characters=men, variant="clusters", quantity=q) for q in ("us_per_frame", "contacts"))
    out["crowd.men"], out["crowd.ms"], out["crowd.contacts"] = whole_number(men), digits(us / 1000, 2), whole_number(contacts)
    out["crowd.gain"] = digits(crowds.gain(results, "dense", men), 2)
    out["crowd.apart.us"] = digits(results.number("crowds", scene="apart", characters=men, variant="clusters", quantity="us_per_frame") / men, 2)
    out["crowd.apart.bound.us"] = digits(min(us for n, us in crowds.fastest_times(results, "apart", crowds.variants()) if n == men) / men, 2)
    out["rounding.checks"] = whole_number(total(results, "rounding", quantity="exact_checks"))
    out["rounding.misses"] = whole_number(total(results, "rounding", quantity="missed_vertices") +
                                          total(results, "rounding", quantity="missed_vertices_in_float"))
    for name, quantity in [("places", "checks"), ("exact", "exact_checks"), ("unknown", "exact_undecided")]:
        out[f"overtime.{name}"] = whole_number(over_time.total(results, quantity))
    out["overtime.misses"] = whole_number(sum(over_time.total(results, q) for q in ("character_misses", "cluster_misses", "exact_missed_places")))
    out["overtime.refused"] = whole_number(over_time.total(results, "refused_clips"))
    for skinning in over_time.SKINNINGS:
        out[f"overtime.whole.{skinning}"] = f"{over_time.whole_ratios(results, skinning=skinning).most:.3f}"
        out[f"overtime.cluster.{skinning}"] = f"{over_time.cluster_ratio(results, skinning=skinning):.3f}"
        out[f"overtime.within.{skinning}"] = whole_number(over_time.within_goal(results, skinning=skinning))
        out[f"overtime.clips.{skinning}"] = whole_number(len(results.select("over_time", skinning=skinning, quantity="duration")))
    for grown in over_time.GROWN:
        out[f"overtime.exponent.{grown}"] = f"${digits(over_time.growth_exponent(results, grown), 2)}$"
    triangles, bounding, written = over_time.peaks(results)[-1]
    out["overtime.triangles"], out["overtime.bounding"], out["overtime.written"] = map(whole_number, (triangles, bounding, written))
    volume = engines.volume_goal(results)
    out["engines.volume"], out["engines.true"] = f"{volume['mean']:.2f}", f"{volume['true']:.2f}"
    out["engines.reached"], out["engines.clips"] = whole_number(volume["reached"]), whole_number(volume["clips"])
    out["engines.cost"] = digits(engines.costs(results, engines.OURS)["ratio"])
    out["deformed.balls"], out["deformed.misses"] = whole_number(deformations.balls(results)), whole_number(deformations.misses(results))
    for goal in deformations.goals(results):
        if goal["name"] not in ("control_mixed", "control_many_pieces"):
            continue
        out[f"deformed.worst.{goal['name']}"], out[f"deformed.reached.{goal['name']}"] = f"{goal['worst']:.2f}", whole_number(goal["reached"])
    out["deformed.cases"] = whole_number(deformations.goals(results)[0]["cases"])
    out["deformed.cost.least"], out["deformed.cost.most"] = (digits(v, 2) for v in span(deformations.cost_ratios(results)))
    for name, variant, balls in (("bdtree", "spherical_repaired", "bd_tree"), ("default", "control_mixed", "smallest")):
        out[f"reduced.skinned.{name}"] = f"{deformations.worst(results, kind='vibration_skinned', variant=variant, displacements=balls):.2f}"
    out["reduced.cost"] = digits(deformations.cost_to_bd_tree(results, "vibration", "control_mixed", "smallest"), 2)
    verdicts = summed_up(results.rows("verdicts"))
    out["verdicts.refuted"] = whole_number(sum(v.refuted_after > 0 for v in verdicts))
    out["verdicts.implied"] = whole_number(sum(v.implied_after > 0 for v in verdicts))
    out["verdicts.claims"] = whole_number(sum(len(v.printed_claims) + len(v.claims) for v in verdicts))
    out["verdicts.held"] = whole_number(sum(sum(v.printed_claims) + sum(v.claims) for v in verdicts))
    mutants = stored(root, statements.JUDGED)
    killed, alive, equivalent = (sum(row.verdict == verdict for row in mutants) for verdict in ("killed", "alive", "equivalent"))
    out["mutants.killed"], out["mutants.able"] = whole_number(killed), whole_number(killed + alive)
    out["mutants.equivalent"] = whole_number(equivalent)
    out["mutants.late"] = whole_number(sum((row.verdict, row.at_first) == ("killed", "alive") for row in mutants))
    out["exhaustive.theorems"] = whole_number(len({row.theorem for row in stored(root, statements.PROVED)}))
    return out


# --- Tables ---

def tightness_table(results, model, pose):
    variants = [*SPHERICAL, "bottom_up"]
    names = {**SPHERICAL, "bottom_up": "skinned, bottom-up"}
    levels = [1, 2, 3, 4, 6, 8, 10, 12]
    rows = [[names[v], *(f"{results.number('tightness', model=model, pose=pose, variant=v, level=l, quantity='radius_ratio_to_optimal'):.2f}"
                         for l in levels)] for v in variants]
    return table("l" + "r" * len(levels), ["", *map(str, levels)], rows)


def worst_table(results):
    rows = []
    for variant, name in SPHERICAL.items():
        rows.append([name, *(f"{worst_ratio(results, variant, model=m):.2f}" for m in MODELS)])
    return table("l" + "r" * len(MODELS), ["", *map(short_model, MODELS)], rows)


def short_model(name):
    return {"BCN_Epileptic.X": "Epileptic", "Testwuson.X": "Wuson", "Soldier.glb": "Soldier",
            "leftHandHigh.glb": "hand"}.get(name, name)


def misses_table(results):
    rows = []
    for variant, name in PRINTED.items():
        cells = [name]
        for kind in ("clip", "twist"):
            balls, misses, undefined = (total(results, "tightness", variant=variant, quantity=q, pose_kind=kind)
                                        for q in ("nodes", "missed_balls", "undefined"))
            cells += [f"{100 * misses / balls:.2g}\\,\\%", f"{100 * undefined / balls:.2g}\\,\\%"]
        rows.append(cells)
    return table("lrrrr", ["", "clips: missed", "undefined", "twists: missed", "undefined"], rows)


def cost_table(results):
    variants = {"linear": "linear \\cite{KavanZara2005a}", **SPHERICAL}
    rows = []
    for variant, name in variants.items():
        rows.append([name, *(f"{results.number('speed', model=m, variant=variant, level=ALL, quantity='time_ratio_to_repaired'):.2f}" for m in MODELS)])
    rows += [None, ["repaired, ns a sphere", *(whole_number(results.number(
        "speed", model=m, variant="spherical_repaired", level=ALL, quantity="ns_per_sphere")) for m in MODELS)]]
    return table("l" + "r" * len(MODELS), ["", *map(short_model, MODELS)], rows)


def batch_table(results):
    rows = []
    for operation, name in [("refit_linear", "refit, linear"), ("refit_spherical", "refit, Algorithm 1 repaired"),
                            ("skin_linear", "skinning, linear"), ("skin_spherical", "skinning, spherical"),
                            ("skin_dual_quaternion", "skinning, dual quaternion")]:
        rows.append([name, *(digits(results.number("batch_speed", model="man", operation=operation, variant=method, unit="ns"), 2)
                             for method in ["scalar", "baseline", "avx2", "avx512"])])
    return table("lrrrr", ["ns a sphere or vertex", "scalar", "SSE2", "AVX2", "AVX-512"], rows)


def volumes_table(results):
    def average(variant, quantity):
        return mean(results.values("volumes", variant=variant, quantity=quantity, pose_kind="clip", level=lambda l: l in (3, 4, 5, 6)))
    names = {"aabb": "axis-aligned box", "obb": "oriented box", "dop14": "14-DOP", "dop18": "18-DOP", "dop26": "26-DOP"}
    rows = []
    for variant, name in names.items():
        cost = span(results.values("volumes", variant=variant, quantity="time_ratio_to_ball", level=ALL))
        rows.append([name, f"{average(variant, 'size_ratio_to_optimal'):.2f}", f"{average(variant, 'volume_ratio_to_ball'):.2f}",
                     f"{cost.least:.1f}--{cost.most:.1f}"])
    return table("lrrr", ["", "size / around vertices", "volume / ball", "cost / ball"], rows)


def rounding_table(results):
    names = {"linear": "linear \\cite{KavanZara2005a}", "linear_mixed": "linear, control points or vertices", **SPHERICAL,
             "dual_quaternion_mixed": "dual quaternions, the same"}
    rows = []
    for variant, name in names.items():
        def of(quantity):
            return results.values("rounding", variant=variant, quantity=quantity)
        rows.append([name, f"{100 * sum(of('missed_vertices_without_slack')) / sum(of('exact_checks')):.2g}\\,\\%",
                     whole_number(sum(of("missed_vertices") + of("missed_vertices_in_float"))), power_of_ten(max(of("inflation_median"))),
                     power_of_ten(max(of("float_inflation_median"))), f"{min(of('time_ratio_to_without_slack')):.2f}--{max(of('time_ratio_to_without_slack')):.2f}"])
    return table("lrrrrr", ["", "outside without", "with", "adds", "adds, float", "cost"], rows)


def collision_table(results):
    names = [("clusters", "clusters (ours)"), ("spherical_repaired", "spheres on demand, repaired"),
             ("control_mixed", "spheres on demand, default"), None, ("skin_all_float", "skin all in float, boxes"), ("skin_all_float_384", "the same, clusters of 384"),
             ("skin_all_float_512", "the same, clusters of 512"),
             ("aabb_tree", "skin all, boxes bottom-up"), ("brown", "skin all, spheres bottom-up \\cite{Brown2001}"),
             ("embree", "Embree"), ("bullet_gimpact", "Bullet GImpact"), ("fcl_aabb", "FCL, boxes"),
             ("fcl_obbrss", "FCL, OBB-RSS"), None]
    rows = [None if entry is None else [entry[1], *(digits(time_of(results, scene, entry[0])) for scene in SCENES)]
            for entry in names]
    rows.append(["touching pairs", *(f"{pairs_of(results, scene):.0f}" for scene in SCENES)])
    return table("l" + "r" * len(SCENES), ["\\textmu s a frame", *SCENES], rows)


def out_of_bounds(results, number, percent):
    """Returns, by way of bounding, the cells of a row: the characters and the clusters that get out with linear skinning, each with how far at most.
    number makes a text of a count, and percent stands after a share."""
    clips = len(results.select("over_time", skinning="linear", quantity="duration"))
    clusters = over_time.clusters_of_clips(results, "linear")
    rows = []
    for way in over_time.WAYS:
        found = over_time.misses(results, "linear", way)
        whole, cluster = (f"{100 * row.value:.2g}{percent}" if row else "" for row in (found["whole"], found["cluster"]))
        rows.append([found["way"], f"{found['clips']} of {clips}", whole, f"{number(found['clusters'])} of {number(clusters)}", cluster])
    return rows


def over_time_table(results):
    return table("lrrrr", ["", "characters out", "distance / side", "clusters out", "distance / side"], out_of_bounds(results, whole_number, "\\,\\%"))


def engine_rows(results, number, cost_digits):
    """Returns, by method that was measured, what it does, who has it, and the cells of its row: the volume with linear skinning, the poses missed with each
    skinning, and the cost. number makes a text of a count, and cost_digits says how many digits a cost has."""
    rows = []
    for method in engines.METHODS:
        of = {skinning: engines.row_of(results, method, skinning) for skinning in over_time.SKINNINGS}
        if not of["linear"]:
            continue
        volume, cost = of["linear"]["volume_ratio_to_true_box"], engines.costs(results, method)["ratio"]
        cells = ["" if volume is None else f"{volume:.2f}", *(number(row["misses"]) if row else "" for row in of.values()),
                 "" if cost is None else digits(cost, cost_digits(cost))]
        rows.append((of["linear"]["method"].replace("’", "'"), of["linear"]["who"], cells))
    return rows


def engines_table(results):
    """Linear skinning, clips; and the poses missed with all skinnings, where the method is for them."""
    rows = [[escaped(does + (f" ({who})" if who else "")), *cells] for does, who, cells in engine_rows(results, whole_number, lambda cost: 2)]
    head = ["", "volume", *over_time.SKINNINGS.values(), "cost"]
    return table("p{62mm}" + "r" * (len(head) - 1), head, rows)


def reduced_table(results):
    """The worst level of the worst model, by method: of the vibration and of the clip, without skinning."""
    rows = []
    for (variant, balls), name in deformations.REDUCED.items():
        rows.append([name, *(f"{deformations.worst(results, kind=kind, variant=variant, displacements=balls):.2f}" for kind in ("vibration", "clip"))])
    return table("lrr", ["", "vibration", "clip"], rows)


def provenance_table(results):
    for name in ["tightness", "speed", "volumes", "batch_speed", "rounding", "collisions", "triangle_growth", "joint_growth",
                 "crowds", "over_time", "over_time_growth", "engines", "deformations", "verdicts"]:
        results.rows(name)
    rows = [[f"\\texttt{{{escaped(name)}.csv}}", f"\\texttt{{{p['commit']}}}", escaped(p["compiler"]), escaped(p["cpu"])]
            for name, p in results.provenance.items()]
    return table("llll", ["file", "commit", "compiler", "processor"], rows)


def verdict_table(results, lemmas):
    """lemmas: the stems that must be there."""
    out = []
    for stem in lemmas:
        v = of_stem(stem, results.select("verdicts", stem=stem))
        if v.failed:
            raise ResultError(f"verdicts.csv: a test of {stem} failed")
        as_printed = ["holds"] * bool(v.printed_claims and not v.refuted_after) + refutations(v)
        share = f"{100 * v.degenerate:.0f}\\,\\%" if v.claims else ""
        held = [said_of_claims(v.claims or ([] if v.refuted_after else v.printed_claims)), share]
        out.append([f"\\texttt{{{escaped(stem)}}}", "; ".join(as_printed), *held])
    return table("l>{\\raggedright\\arraybackslash}p{24mm}lr", ["statement", "as printed", "holds in", "degenerate"], out)


def statement_table(results, root):
    """What stands behind each statement."""
    rows = []
    for s in statements.statements(root, summed_up(results.rows("verdicts"))):
        tests, proofs, run_by = statements.cells(s, broken_name, escaped)
        rows.append([broken_name(s.verdict.stem), r" \newline ".join(tests), r" \newline ".join(proofs), run_by])
    return long_table([33, 26, 54, 27], statements.HEAD, rows)


def tables(results, lemmas, root):
    return {"tightness_man": tightness_table(results, "man", "walk"),
            "tightness_twist": tightness_table(results, "man", "full twist"),
            "worst": worst_table(results), "misses": misses_table(results), "cost": cost_table(results),
            "batch": batch_table(results), "volumes": volumes_table(results), "rounding": rounding_table(results), "collisions": collision_table(results),
            "over_time": over_time_table(results), "engines": engines_table(results), "reduced": reduced_table(results),
            "provenance": provenance_table(results), "verdicts": verdict_table(results, lemmas), "statements": statement_table(results, root)}


# --- Data of plots: columns set apart by spaces ---

def tightness_plot(results, model, pose):
    variants = [*SPHERICAL, "bottom_up"]
    levels = sorted(results.distinct("tightness", "level", model=model, pose=pose, variant="control_mixed"))
    lines = ["level " + " ".join(variants)]
    for level in levels:
        lines.append(f"{level} " + " ".join(str(results.number(
            "tightness", model=model, pose=pose, variant=v, level=level, quantity="radius_ratio_to_optimal")) for v in variants))
    return "\n".join(lines) + "\n"


def growth_plot(results, scene):
    detectors = ["clusters", "spherical_repaired", "control_mixed_through_descendants", "skin_all_float", "embree"]
    sizes = sorted(results.distinct("triangle_growth", "triangles"))
    lines = ["triangles " + " ".join(detectors)]
    lines += [f"{n} " + " ".join(str(grown(results, n, scene, d)) for d in detectors) for n in sizes]
    return "\n".join(lines) + "\n"


def pareto_plot(results, model):
    """Cost of each variant in the model's twist and its tightness in the walk, mean over the levels."""
    lines = ["cost ratio label"]
    for variant in SPHERICAL:
        ratio = mean(results.values("tightness", model=model, pose="walk", variant=variant, quantity="radius_ratio_to_optimal"))
        cost = results.number("speed", model=model, variant=variant, level=ALL, quantity="time_ratio_to_repaired")
        lines.append(f"{cost} {ratio} {variant.replace('_', '-')}")
    return "\n".join(lines) + "\n"


def plots(results):
    return {"tightness_man": tightness_plot(results, "man", "walk"),
            "tightness_soldier": tightness_plot(results, "Soldier.glb", "Run"),
            "growth_near": growth_plot(results, "near"), "growth_light": growth_plot(results, "light"),
            "pareto": pareto_plot(results, "man")}
