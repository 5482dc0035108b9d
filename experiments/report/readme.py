# SPDX-License-Identifier: GPL-3.0-or-later
"""The README's measured blocks: <!-- measured: NAME --> ... <!-- /measured -->, each with the commit it was measured at."""
import re

from . import crowds, deformations, engines, over_time, paper_numbers
from .blocks import block, replaced
from .formats import digits
from .statistics import span
from .tables import ResultError

NAME = re.compile(r"<!-- measured: (\w+) -->\n")
COMMIT = re.compile(r"commit\s[0-9a-f]{7,40}\b")
SCENES = ["far", "near", "light", "heavy"]
CROWDS = [10, 100, 1000, 10000]
ALL_SKINNED = ("skin_all_float", "skin_all_float_512")
CROWD_ROWS = [  # of several detectors the fastest
    ("dense: `collide_all`", "dense", ("clusters",)), ("the fastest baseline", "dense", crowds.variants()), ("dense: skin everything in float", "dense", ALL_SKINNED),
    ("dense, on two threads: `collide_all`", "dense", ("clusters_on_two_threads",)), ("the fastest baseline", "dense", crowds.variants("_on_two_threads")),
    ("dense, yes/no: `collide_all`", "dense", ("clusters_yes_no",)), ("the fastest baseline", "dense", crowds.variants("_yes_no")),
    ("apart: `collide_all`", "apart", ("clusters",)), ("the fastest baseline: our motion bound alone", "apart", crowds.variants()),
    ("apart: skin everything in float", "apart", ALL_SKINNED)]
KERNELS_UP_TO = ", kernels up to "  # what experiments --target puts behind the processor's name


def from_to(found):
    return " to ".join(digits(v, 2) for v in span(found))


def commit_of(results, *files):
    for name in files:
        results.rows(name)
    return ", ".join(sorted({results.provenance[name]["commit"] for name in files}))


def command_of(results, name):
    """The command whose last run wrote this table."""
    effort = next((row.effort for row in results.rows("run") if row.file == f"{name}.csv"), "full")
    return "experiments/run" + ("" if effort == "default" else f" --{effort}")


def variants_block(results):
    commit = commit_of(results, "tightness", "speed", "collisions", "batch_speed")
    worst = {v: digits(paper_numbers.worst_ratio(results, v)) for v in ("spherical_repaired", "control_mixed", "control_many_pieces")}
    twist = digits(paper_numbers.worst_ratio(results, "control_mixed", "twist"))
    missed = paper_numbers.total(results, "tightness", quantity="missed_balls", variant=paper_numbers.is_sound(results))
    gains, opened = paper_numbers.batch_gains(results), paper_numbers.opened_gains(results)
    upper, slower = max(paper_numbers.upper_cost_ratios(results, "control_mixed")), span(paper_numbers.query_ratios(results))
    return f"""\
Measured on six characters with `{command_of(results, "tightness")}` (commit {commit}); {'no ball of a sound variant misses' if missed == 0 else f'{missed:,.0f} balls of sound variants miss'} a vertex. The tightness of a level is the
average radius over that of the smallest balls of the deformed vertices. On the worst level of the worst clip it is {worst['spherical_repaired']} for `spherical_repaired`,
{worst['control_mixed']} for `control_mixed` and {worst['control_many_pieces']} for `control_many_pieces`. Where a joint is twisted by 170 degrees or more, it is at most {twist} on
any level for `control_mixed`. The cost of a sphere, relative to `spherical_repaired` in the same run, is {from_to(paper_numbers.cost_ratios(results, 'control_mixed'))} for `control_mixed`
and {from_to(paper_numbers.cost_ratios(results, 'control_many_pieces'))} for `control_many_pieces`. Where two walking men are near each other, their queries with `spherical_repaired` refit
{from_to(paper_numbers.fewer_spheres(results))} times as many spheres as with `control_mixed`. But those of `control_mixed` are mostly on the upper levels of the tree, where a sphere costs up to {digits(upper, 2)} times as much. A whole query, far ones too, takes
{digits(slower.least, 2)} to {digits(slower.most, 2)} times as long as with `spherical_repaired`. In batches of SIMD packs (`algorithms/runtime/batch`), refitting all spheres of a tree by Algorithm 1 repaired costs
with AVX-512 1/{min(gains):.0f} to 1/{max(gains):.0f} of refitting them one by one, in float in place of double. A ball alone cannot be that fast: the longest chain of its operations, each of which waits
for the one before, takes {from_to(paper_numbers.chain_shares(results))} of the time. But a query needs no ball alone. The up to 48 nodes into which it opens one are bounded together, by the motion
bound, at 1/{min(opened):.0f} to 1/{max(opened):.0f} of refitting them one by one.
"""


def query_rows(results, more=lambda detector: []):
    """Returns the rows of a table of detectors by scene. more(detector) has the times of further columns."""
    rows = []
    for name, detector in [("`collide(ClusterBody, …)` with a `PairMemory`", "clusters"), ("the same without it", "clusters_without_memory"), ("skin everything in float", "skin_all_float"),
                           ("the same with clusters of 384 triangles in place of 256", "skin_all_float_384"), ("the same with clusters of 512", "skin_all_float_512"),
                           ("the fastest of Embree, FCL and Bullet, of those that find all pairs", None), ("sphere tree on demand, Algorithm 1 repaired", "spherical_repaired"),
                           ("*floor: told which clusters’ boxes meet*", "floor_of_boxes"), ("*floor: told which clusters touch*", "floor_of_contacts")]:
        times = [paper_numbers.time_of(results, s, detector) if detector else paper_numbers.fastest_engine(results, s) for s in SCENES]
        rows.append(f"| {name} | " + " | ".join(digits(t, 3 if t >= 100 else 2).replace("{,}", ",") for t in [*times, *more(detector)]) + " |")
    return rows


def scene_heads(results):
    return [s if s in ("far", "near") else f"{s}, {paper_numbers.pairs_of(results, s):.0f} pairs" for s in SCENES]


def cpu_of(results, target=None):
    """Returns the processor of the collisions. If a target is given, the run must have been limited to its kernels, else to none."""
    cpu = results.provenance["collisions"]["cpu"]
    name, _, limit = cpu.partition(KERNELS_UP_TO)
    if limit != (target or ""):
        raise ResultError(f"{results.path('collisions')}: is of {f'kernels up to {limit}' if limit else 'all kernels'}, "
                          f"not of {f'kernels up to {target}' if target else 'all of them'}")
    return name


def queries_block(results):
    commit = commit_of(results, "collisions", "triangle_growth")
    most = paper_numbers.largest_growth(results)
    cpu = cpu_of(results)
    rows = query_rows(results, lambda detector: [paper_numbers.grown(results, most, s, detector or "embree") for s in paper_numbers.GROWN_SCENES])
    heads = scene_heads(results) + [f"{s}, {most:,} triangles each" for s in paper_numbers.GROWN_SCENES]
    ceilings = {scene: digits(paper_numbers.gain_without(results, scene, "skin_all_float"), 3) for scene in ("light", "heavy")}
    return f"""\
The table gives the microseconds a frame, from pose to pairs, to find all touching pairs of two walking men of 8270 triangles each
(`{command_of(results, "collisions")}`; commit {commit}, {cpu}, one thread, huge pages). Every set of pairs is checked: against brute force, and in the largest models against that of the third row. All rows but that of the sphere tree compare triangles in
packs of floats first. The rows of engines and of the sphere tree skin in double, and all others in float. In the last four columns, the engine is Embree.

| | {' | '.join(heads)} |
|---|{'---|' * len(heads)}
""" + "\n".join(rows) + f"""

The last two rows are no detectors: they are told beforehand where to look, and skin and compare that alone. In contact most of the time goes into comparing
triangles, which all of these must do. If the third row needed no time at
all for skinning and bounds, it would be {ceilings['light']} times as fast in *light*, and {ceilings['heavy']} times in *heavy*. In *far* any method is as fast behind the same boxes
around whole characters. Behind our motion bound, made anew in each frame, the third row takes {digits(paper_numbers.time_of(results, 'far', 'skin_all_float_bounded'), 2)} microseconds.
"""


def queries_avx2_block(results):
    commit, cpu = commit_of(results, "collisions"), cpu_of(results, "avx2")
    heads = scene_heads(results)
    return f"""\
The same men and scenes without kernels wider than those of AVX2, as on processors without AVX-512 (`{command_of(results, "collisions")} --only collisions --target avx2`; commit {commit}, {cpu}).
Embree chooses its own instructions.

| | {' | '.join(heads)} |
|---|{'---|' * len(heads)}
""" + "\n".join(query_rows(results)) + "\n"


def crowds_block(results):
    commit = commit_of(results, "crowds")
    cpu, _, target = results.provenance["crowds"]["cpu"].partition(KERNELS_UP_TO)
    numbers = [n for n in results.distinct("crowds", "characters") if n in CROWDS]
    most = max(numbers)
    rows = []
    for name, scene, detectors in CROWD_ROWS:
        us = dict(crowds.fastest_times(results, scene, detectors))
        if us:  # there may be no threads
            rows.append(f"| {name} | " + " | ".join(digits(us[n] / n, 3 if us[n] >= 100 * n else 2) for n in numbers) + " |")
    contacts, pairs = (results.number("crowds", scene="dense", characters=most, variant="clusters", quantity=q) for q in ("contacts", "triangle_pairs"))
    boxes = 1000 * dict(crowds.times(results, "apart", "broad_phase"))[most] / most
    return f"""\
The table gives the microseconds a man and frame to find all touching pairs of triangles in a crowd of walking men of 8270 triangles each
(`{command_of(results, "crowds")} --only crowds{f" --target {target}" if target else ""}`; commit {commit}, {cpu}, one thread but where it says two). *Dense* is two square metres a man: of {most:,} men {contacts:,.0f} pairs touch, each in
{pairs / contacts:.0f} pairs of triangles on average. *Apart*, no boxes meet. The baselines skin whole men in float, in clusters of 256 or 512 triangles: all men, or those whose motion
bounds meet. All detectors find the same contacts, which is checked in each frame.

| | {' | '.join(f"{n:,} men" for n in numbers)} |
|---|{'---|' * len(numbers)}
""" + "\n".join(rows) + f"""

*Apart*, any method is fast behind a box around the whole character, as in the last row but one, for which the motion bound is made in each frame. `collide_all`
makes it now and then, and in between blows it up by what joints have moved, which would serve the others as well. What a man costs hardly depends on how many others are far from
him, but for caches, which a thousand men do not fit into. Comparing {most:,} boxes with each other is {digits(boxes, 2)} nanoseconds of it.
"""


def over_time_block(results):
    commit = commit_of(results, "over_time", "over_time_growth")
    clips = len(results.select("over_time", skinning="linear", quantity="duration"))
    rows = [f"| {' | '.join(cells)} |" for cells in paper_numbers.out_of_bounds(results, "{:.0f}".format, " %")]
    misses = sum(over_time.total(results, q) for q in ("character_misses", "cluster_misses", "exact_missed_places"))
    undecided = over_time.total(results, "exact_undecided")
    unknown = f", and of {undecided} that were placed with many digits these are too few to tell" if undecided else ""
    whole = {s: f"{over_time.whole_ratios(results, skinning=s).most:.3f}" for s in over_time.SKINNINGS}
    cluster = {s: f"{over_time.cluster_ratio(results, skinning=s):.3f}" for s in over_time.SKINNINGS}
    triangles, bounding, written = over_time.peaks(results)[-1]
    return f"""\
The table counts the characters, and the clusters of 128 triangles, of which a vertex leaves the box between sampled times, in {clips} clips of six characters
with linear skinning. The distance is the greatest of a vertex from its box, over the longest side of the box (`{command_of(results, "over_time")} --only over_time`; commit {commit}):

| | characters out | distance / side | clusters out | distance / side |
|---|---|---|---|---|
""" + "\n".join(rows) + f"""

Of {over_time.total(results, 'checks'):,} times that a vertex was compared with a bound of its character or of a cluster, with all three ways of skinning, {'none' if misses == 0 else misses} {'was' if misses < 2 else 'were'} outside{unknown}.
The volume of a character's box is at most {whole['linear']} times that of the smallest box around what was seen, and {cluster['linear']} times for a cluster on average.
With dual quaternions the factors are {whole['dual_quaternion']} and {cluster['dual_quaternion']}, because of a clip in which blends nearly vanish; with spherical blending {whole['spherical']} and {cluster['spherical']}.
Bounding {triangles:,} triangles takes {bounding:.0f} MB of memory; writing the character for refits, too, takes {written:.0f} MB.
"""


def engines_block(results):
    commit = commit_of(results, "engines")
    volume, cost, goals = engines.volume_goal(results), engines.costs(results, engines.OURS), engines.GOALS
    rows = ["| " + " | ".join([does, who, *cells]).replace("{,}", ",") + " |"
            for does, who, cells in paper_numbers.engine_rows(results, "{:.0f}".format, lambda cost: 3 if cost < 100 else 2)]
    reference = engines.row_of(results, "joint_boxes", "linear")
    twisted = {s: engines.row_of(results, engines.OURS, s)["twists"] for s in over_time.SKINNINGS}
    undecided = round(sum(row.value for row in results.find("engines", quantity="undecided")))
    unseen = engines.unseen(results)
    costliest, most = engines.costliest(results, engines.OURS)
    of_others = (f". For {unseen['clips']} clips, boxes were\nalso fitted to the model's other clips alone. They have {unseen['mean']:.3f}, where boxes fitted to all clips have "
                 f"{unseen['fitted']:.3f} and the true box {unseen['true']:.3f}") if unseen else ""
    any_ratio = {s: engines.row_of(results, "motion_bound", s) for s in ("dual_quaternion", "spherical")}
    return f"""\
The table is of {volume['clips']} clips of six characters (`{command_of(results, "engines")} --only engines`; commit {commit}). The volume is that of the box over that of the
true box, which is around all linearly skinned vertices, on average over the clips. The next three columns count the poses, of {reference['poses']:,} with each way
of skinning, in which a vertex is outside; where double precision cannot tell, {'exact arithmetic or 60 digits decide all of them' if undecided == 0 else f'exact arithmetic or 60 digits decide, but for {undecided}'}. The cost is from a pose, over that of joint boxes with the same SIMD; all vertices are skinned in double.

| box | as in | volume | linear | dual quaternion | spherical | cost |
|---|---|---|---|---|---|---|
""" + "\n".join(rows) + f"""

The goal for rounded boxes is {goals['volume']} of the volume of joint boxes on average or less, at no higher cost. They have {volume['mean']:.3f}, {'as they should' if volume['mean'] <= goals['volume'] else 'more than they should'}, where the
true box has {volume['true']:.3f}; {volume['reached']} of {volume['clips']} clips are within the goal. They are fitted to twelve poses of each of these clips{of_others}. Their cost is {cost['ratio']:.2f} of that of joint boxes from a pose, and {cost['ratio_of_matrices']:.2f} from the matrices that
skinning needs anyway, {'as it should be' if max(cost['ratio'], cost['ratio_of_matrices']) <= goals['cost'] else 'more than it should be'}; that is a mean, and the most is {most:.2f}, of {costliest}. Rounded boxes and capsules are sound for linear skinning alone: when each joint is twisted by 90 to 179 degrees, rounded boxes miss a vertex in {twisted['linear'][0]} of
{twisted['linear'][1]} poses with linear, {twisted['dual_quaternion'][0]} with dual quaternion and {twisted['spherical'][0]} with spherical skinning. The motion bound is sound for all three. It has {any_ratio['dual_quaternion']['volume_ratio_to_true_box']:.2f} and {any_ratio['spherical']['volume_ratio_to_true_box']:.2f} times the
volume of the true box with the last two, where it has a bound: it has none in {any_ratio['dual_quaternion']['unbounded']} and {any_ratio['spherical']['unbounded']} poses, in which blends nearly vanish.
"""


def deformations_block(results):
    commit = commit_of(results, "deformations")
    said = [f"`{g['name']}` has at most {g['worst']:.2f} (goal: {g['goal']}, reached in {g['reached']} of {g['cases']} cases)" for g in deformations.goals(results)]
    misses = deformations.misses(results)
    return f"""\
Characters whose joints scale or whose morph targets move, generated and real (`{command_of(results, "deformations")} --only deformations`; commit {commit}): of {deformations.balls(results):,} balls
{'none misses' if misses == 0 else f'{misses} miss'} a vertex. The tightness is the average radius over that of the smallest balls, on the worst level of the worst character: {"; ".join(said)}.
The default refits cost {from_to(deformations.cost_ratios(results))} times as much as those of the rigid character.
"""


BLOCKS = {"variants": variants_block, "over_time": over_time_block, "queries": queries_block, "queries_avx2": queries_avx2_block, "crowds": crowds_block, "engines": engines_block, "deformations": deformations_block}
OF_LIMITED_KERNELS = {"queries_avx2"}  # which a run of its own measures


def blocks(text, path):
    """{name: text} of the measured blocks. Raises ResultError if one is missing, unknown, or does not name its commit."""
    found = {}
    for name in [*BLOCKS, *NAME.findall(text)]:
        if name not in BLOCKS:
            raise ResultError(f"{path}: the block <!-- measured: {name} --> is unknown")
        found[name] = block(text, path, f"measured: {name}")
        if not COMMIT.search(found[name]):
            raise ResultError(f"{path}: the block <!-- measured: {name} --> does not say from which commit it is")
    return found


def renewed(text, results, path, names=()):
    """The README with its blocks from these results; with names, only those blocks, else all but those of limited kernels."""
    blocks(text, path)
    for name in names:
        if name not in BLOCKS:
            raise ResultError(f"{path}: has no block {name}; there are: {', '.join(BLOCKS)}")
    for name in names or [name for name in BLOCKS if name not in OF_LIMITED_KERNELS]:
        text = replaced(text, path, f"measured: {name}", BLOCKS[name](results))
    return text
