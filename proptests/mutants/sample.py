# SPDX-License-Identifier: GPL-3.0-or-later
"""A sample of the mutants by rule, drawn evenly from lemmas, algorithms, engines' boxes, exhaustive proofs and the checkers of certificates, and
their verdicts."""
import csv
import functools
import hashlib
import time

import operators
import proofs
from planting import CannotJudge, ROOT
from reach import Reach

SEED = 2006
# (so many of the nearest suites, whether all that the mutant reaches is built). The nearest is tried alone, because it mostly kills. The
# first two steps of a header build nothing but the suites anew: what they find wrong is wrong, but they may overlook what a whole build sees.
# What no suite so near as the last step's sees, no test is about.
STEPS = ((1, False), (3, False), (6, True), (20, True))
# Suites that take longer come after the others of their step.
SECONDS_OF_SHORT_SUITE = 10
VERDICTS = ("killed", "not built", "alive", "equivalent")
COLUMNS = ["file", "rule", "line", "mutant", "verdict", "by", "suites", "seconds"]
# An older table has no seconds. They are what the judging took, and the one column that a second judging does not give again.
TIME_LIMIT = 300  # seconds of the processor's time, where suites take some ten
# What measures and prints, and no suite is built of.
UNTESTED = ("experiments/engines/engines.",)


def sources():
    folders = ("lemmas", "algorithms", "experiments/engines", proofs.TARGET)
    paths = [ROOT / proofs.TARGET / "check", *(p for folder in folders for p in (ROOT / folder).rglob("*") if p.suffix in (".hpp", ".cpp"))]
    paths += [*(ROOT / "proptests/certificate" / name for name in ("check", "check_clip", "check_pairs")), *(ROOT / "proptests/certificate/over_time").glob("*.py")]
    return sorted(f for f in (str(p.relative_to(ROOT)) for p in paths) if not f.startswith(UNTESTED))


def digest_of_sources():
    """Of all that decides whether a mutant lives."""
    tests = [str(p.relative_to(ROOT)) for p in sorted((ROOT / "proptests").rglob("*")) if p.is_file() and p.suffix not in (".md", ".csv")]
    builds = [str(p.relative_to(ROOT)) for p in sorted(ROOT.glob("*/**/CMakeLists.txt"))]
    digest = hashlib.sha256()
    for name in [*sources(), *tests, *builds]:
        digest.update(name.encode() + b"\0" + (ROOT / name).read_bytes() + b"\0")
    return digest.hexdigest()[:16]


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
    """(the positions of the mutants to judge so that the first count are known, the rows that are known already). rows: of an earlier
    table. One that lived is to be judged again, since tests may have been added, unless it is argued that no test can tell; one whose file
    has changed counts no more, and neither does one that an earlier order had among the first: a sample is even only if it is a draw's."""
    known, again, taken = [], [], set()
    for row, position in zip(rows, positions_of(rows)):
        if position is None or position >= count:
            continue
        taken.add(position)
        if row["verdict"] in ("killed", "not built", "equivalent"):
            known.append(row)
        else:
            again.append(position)
    others = [i for i in range(min(count, len(all_mutants()))) if i not in taken]
    return beside_each_other(again + others), known


def beside_each_other(positions):
    """In the order of the sources: a program for a mutant is mostly one for the next, too."""
    return sorted(positions, key=lambda i: (all_mutants()[i].file, all_mutants()[i].at, i))


def read_rows(path):
    """Of a table of judged mutants. ValueError: it is none."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    for number, row in enumerate(rows, 2):
        if missing := [name for name in COLUMNS if name not in row and name != "seconds"]:
            raise ValueError(f"{path}, line {number}: has no column {missing[0]}: it is no table of judged mutants")
        if row["verdict"] not in VERDICTS:
            raise ValueError(f"{path}, line {number}: there is no verdict '{row['verdict']}'")
    return [{**dict.fromkeys(COLUMNS, ""), **row} for row in rows]


def steps_of(stems, is_header):
    """(the suites that are run, whether all is built anew) of each step. A header may change more than what the first suites were built of, and
    with the first whole build they are run again. All else is built wholly from the start: nothing includes it."""
    seen, was_whole = 0, not is_header
    for count, is_whole in STEPS:
        is_whole = is_whole or not is_header
        group = stems[seen if was_whole or not is_whole else 0:count]
        seen, was_whole = count, is_whole
        if group:
            yield group, is_whole


def in_order_of_time(group, seconds):
    """The nearest first, but before those that take long all that do not. seconds: by suite; one that is not in it takes none."""
    return sorted(group, key=lambda suite: seconds.get(suite, 0) > SECONDS_OF_SHORT_SUITE)


def verdict_of(copy, mutant):
    """A row of COLUMNS: killed, not built, or alive."""
    # Of the copy, which is one state of the sources, whatever is done to them in the meantime.
    start, text = time.monotonic(), (copy.source / mutant.file).read_text()
    line, changed = mutant.lines(text)
    row = {"file": mutant.file, "rule": mutant.rule, "line": line, "mutant": changed, "verdict": "alive", "by": ""}
    tried = []
    for group, is_whole in steps_of([stem for _, stem in reach().suites(mutant.file)], mutant.file.endswith(".hpp")):
        tried += [stem for stem in group if stem not in tried]
        # What an earlier mutant left to be made again is made of the sources as they are.
        program, output = copy.build(group, 1)
        if not program:
            raise CannotJudge(f"the unchanged sources do not build: {output}")
        for suite in group:
            if not copy.passed.passes(suite, lambda: copy.first_failure(program, TIME_LIMIT, suite)):
                raise CannotJudge(f"without a mutant, too, the suite {suite} fails")
        with copy.planted(mutant.file, mutant.applied_to(text)):
            program, output = copy.build(group, 1, None if is_whole else mutant.file)
            if not program:
                row["verdict"] = "not built"
                break
            failures = (copy.first_failure(program, TIME_LIMIT, suite) for suite in in_order_of_time(group, copy.passed.seconds()))
            if killer := next(filter(None, failures), None):
                row.update(verdict="killed", by=killer)
                break
    return {**row, "suites": " ".join(tried), "seconds": f"{time.monotonic() - start:.0f}"}
