# SPDX-License-Identifier: GPL-3.0-or-later
"""A sample of the mutants by rule, drawn evenly from lemmas, algorithms and the checkers of certificates, and their verdicts."""
import functools

import operators
from planting import ROOT
from reach import Reach

SEED = 2006
# So many of the nearest suites are built first, and only they. If a mutant lives, so many are, with all that the mutant reaches; then so
# many. What no suite so near sees, no test is about.
SUITES = (2, 6, 20)
COLUMNS = ["file", "rule", "line", "mutant", "verdict", "by", "suites"]
TIME_LIMIT = 300  # seconds of the processor's time, where suites take some ten
# Shapes: another nose is as good.
LEFT_OUT = ("algorithms/model/procedural/",)


def sources():
    paths = [p for folder in ("lemmas", "algorithms") for p in (ROOT / folder).rglob("*") if p.suffix in (".hpp", ".cpp")]
    paths += [*(ROOT / "proptests/certificate" / name for name in ("check", "check_clip", "check_pairs")), *(ROOT / "proptests/certificate/over_time").glob("*.py")]
    return sorted(f for f in (str(p.relative_to(ROOT)) for p in paths) if not f.startswith(LEFT_OUT))


def in_order(texts, seed=SEED):
    """All mutants of these texts, by file, in the order in which a sample takes them."""
    places = {}
    for file, text in texts.items():
        mutants = operators.mutants_of(file, text)
        places.update((operators.place_of(identity, seed), mutant) for identity, mutant in zip(operators.identities(mutants, text), mutants))
    return [places[place] for place in sorted(places)]


@functools.cache
def all_mutants():
    return in_order({file: (ROOT / file).read_text() for file in sources()})


@functools.cache
def reach():
    return Reach(ROOT)


def positions_of(rows):
    """Of the mutants of these rows among all; None for a row that is none of them, because its file has changed."""
    files, at = {row["file"] for row in rows}, {}
    for i, m in enumerate(all_mutants()):
        if m.file in files:
            at.setdefault((m.file, m.rule, *m.lines((ROOT / m.file).read_text())), []).append(i)
    found = []
    for row in rows:
        same = at.get((row["file"], row["rule"], row["line"], row["mutant"]), [])
        found.append(same.pop(0) if same else None)  # a line may stand twice
    return found


def still_to_judge(count, rows):
    """(the positions of the mutants to judge so that as many are known, the rows that are known already). rows: of an earlier table. One
    that lived is to be judged again, since tests may have been added, unless it is argued that no test can tell; one whose file has changed
    counts no more."""
    known, again, taken = [], [], set()
    for row, position in zip(rows, positions_of(rows)):
        if position is None:
            continue
        taken.add(position)
        if row["verdict"] in ("killed", "not built", "equivalent"):
            known.append(row)
        else:
            again.append(position)
    others = [i for i in range(len(all_mutants())) if i not in taken][:max(0, count - len(taken))]
    return sorted(again + others), known


class CannotJudge(Exception):
    """Because the suites do not build, or fail, without a mutant, too."""


def verdict_of(copy, mutant):
    """A row of COLUMNS: killed, not built, or alive."""
    text = (ROOT / mutant.file).read_text()
    line, changed = mutant.lines(text)
    stems = [stem for _, stem in reach().suites(mutant.file)]
    row = {"file": mutant.file, "rule": mutant.rule, "line": line, "mutant": changed, "verdict": "alive", "by": "", "suites": ""}
    for run, count in enumerate(SUITES):
        # A header may change more than what the first suites were built of, and they are run again with all of it.
        is_whole, past = run > 0, 0 if run == 0 or run == 1 and mutant.file.endswith(".hpp") else SUITES[run - 1]
        group, row["suites"] = stems[past:count], " ".join(stems[:count])
        if not group:
            continue
        # What an earlier mutant left to be made again is made of the sources as they are.
        program, output = copy.build(group, 1)
        if not program:
            raise CannotJudge(f"the unchanged sources do not build: {output}")
        if not copy.passes(program, TIME_LIMIT):
            raise CannotJudge(f"without a mutant, too, one of these suites fails: {' '.join(group)}")
        with copy.planted(mutant.file, mutant.applied_to(text)):
            program, output = copy.build(group, 1, None if is_whole else mutant.file)
            if not program:
                return {**row, "verdict": "not built"}
            if killer := copy.first_failure(program, TIME_LIMIT):
                return {**row, "verdict": "killed", "by": killer}
    return row
