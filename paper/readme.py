# SPDX-License-Identifier: GPL-3.0-or-later
"""The README's measured blocks: <!-- measured: NAME --> ... <!-- /measured -->, each with the commit it was measured at."""
import re

import content
from formats import digits, whole_number
from report.statistics import span
from report.tables import ResultError

BLOCK = re.compile(r"(<!-- measured: (\w+) -->\n)(.*?)(<!-- /measured -->\n)", re.DOTALL)
COMMIT = re.compile(r"commit\s[0-9a-f]{7,40}\b")


def from_to(found):
    return " to ".join(digits(v, 2) for v in span(found))


def commit_of(results, *files):
    for name in files:
        results.rows(name)
    return ", ".join(sorted({results.provenance[name]["commit"] for name in files}))


def variants_block(results):
    commit = commit_of(results, "tightness", "speed", "collision", "batch_speed")
    worst = {v: digits(content.worst_ratio(results, v)) for v in ("spherical_repaired", "control_mixed", "control_many_pieces")}
    twist = digits(content.worst_ratio(results, "control_mixed", "twist"))
    missed = content.total(results, "tightness", quantity="misses", variant=lambda v: v in content.SPHERICAL)
    gains = content.batch_gains(results)
    return f"""\
Measured on six characters with `experiments/run --full` (commit {commit}); {'no ball' if missed == 0 else whole_number(missed) + ' balls'} of these {'misses' if missed == 0 else 'miss'} a vertex. The tightness of a level is the
average radius over that of the smallest balls of the deformed vertices. On the worst level of the worst clip it is {worst['spherical_repaired']} for `spherical_repaired`,
{worst['control_mixed']} for `control_mixed` and {worst['control_many_pieces']} for `control_many_pieces`. Where a joint is twisted by 170 degrees or more, it is at most {twist} on
any level for `control_mixed`. The cost of a sphere, relative to `spherical_repaired` in the same run, is {from_to(content.cost_ratios(results, 'control_mixed'))} for `control_mixed`
and {from_to(content.cost_ratios(results, 'control_many_pieces'))} for `control_many_pieces`. Where anything is near, queries refit {from_to(content.fewer_spheres(results))} times fewer spheres
with `control_mixed`. In batches of SIMD packs (`algorithms/runtime/batch`), refitting all spheres of a tree by Algorithm 1 repaired costs
1/{min(gains):.0f} to 1/{max(gains):.0f} of refitting them one by one.
"""


def queries_block(results):
    commit = commit_of(results, "collision", "triangle_growth")
    scenes = ["far", "near", "light", "heavy"]
    most = content.largest_growth(results)
    cpu = results.provenance["collision"]["cpu"]
    rows = []
    for name, detector in [("`collide(ClusterBody, …)`", "clusters"), ("skin everything in float, boxes bottom-up", "skin_all_float"),
                           ("the fastest of Embree, FCL and Bullet", None), ("sphere tree on demand, Algorithm 1 repaired", "spherical_repaired")]:
        times = [content.time_of(results, s, detector) if detector else content.fastest_engine(results, s) for s in scenes]
        times += [content.grown_time(results, most, s, detector or "embree") for s in content.GROWN_SCENES]
        rows.append(f"| {name} | " + " | ".join(digits(t, 3 if t >= 100 else 2).replace("{,}", ",") for t in times) + " |")
    heads = [s if s in ("far", "near") else f"{s}, {content.pairs_of(results, s):.0f} pairs" for s in scenes]
    heads += [f"{s}, {most:,} triangles each" for s in content.GROWN_SCENES]
    return f"""\
The table gives the microseconds a frame, from pose to pairs, to find all touching pairs of two walking men of 8270 triangles each
(`experiments/run --full`; commit {commit}, {cpu}, one thread). Every set of pairs is checked against brute force. The last three
columns compare with Embree alone.

| | {' | '.join(heads)} |
|---|{'---|' * len(heads)}
""" + "\n".join(rows) + "\n"


BLOCKS = {"variants": variants_block, "queries": queries_block}


def blocks(text, path):
    """{name: text} of the measured blocks. Raises ResultError if one is missing, unknown, or does not name its commit."""
    found = {name: body for _, name, body, _ in BLOCK.findall(text)}
    for name in [*BLOCKS, *found]:
        if name not in found or name not in BLOCKS:
            raise ResultError(f"{path}: the block <!-- measured: {name} --> is {'missing' if name in BLOCKS else 'unknown'}")
        if not COMMIT.search(found[name]):
            raise ResultError(f"{path}: the block <!-- measured: {name} --> does not say from which commit it is")
    return found


def renewed(text, results, path):
    """The README with its blocks from these results."""
    blocks(text, path)
    return BLOCK.sub(lambda m: m[1] + BLOCKS[m[2]](results) + m[4], text)
