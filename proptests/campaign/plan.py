# SPDX-License-Identifier: GPL-3.0-or-later
"""What a campaign runs: shards, each a suite of property tests with a seed, a fuzz target with a seed, some mutants, a part of an exhaustive
proof, or an experiment on one character."""
import hashlib
import json

FIRST_SEED = 2006
MUTANTS_OF_SHARD = 24
PARTS_OF_PROOF = 16


class PlanError(Exception):
    pass


def digest_of(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()[:16]


def planned(suites, only, seeds, cases, targets, fuzz_seconds, mutants, programs, theorems=(), size="", parts=(), effort=""):
    """The plan, as it is kept beside the results: what another plan has found is not mixed with it.

    mutants: their positions in the sample. programs: the digests of what runs, by name. theorems: the names of those that are to be proved
    exhaustively, with constants of this size. parts: (experiment, character) of what is to be measured, with this effort."""
    if targets and not seeds:
        raise PlanError("each fuzz target is run with each seed: --fuzz-seconds takes --seeds of at least 1")
    if size and not theorems:
        raise PlanError("no theorem's name contains what --only names; build/release/proptests/exhaustive --list lists them")
    chosen = [s for s in suites if not only or any(text in s for text in only)] if seeds else []
    if seeds and not chosen:
        raise PlanError("no suite's stem contains what --only names; proptests/run --list lists them")
    shards = [{"name": f"tests.{suite}.{seed}", "kind": "tests", "of": suite, "seed": seed}
              for seed in range(FIRST_SEED, FIRST_SEED + seeds) for suite in chosen]
    shards += [{"name": f"fuzz.{target}.{seed}", "kind": "fuzz", "of": target, "seed": seed}
               for seed in range(FIRST_SEED, FIRST_SEED + seeds) for target in targets]
    shards += [{"name": f"mutants.{first:05d}", "kind": "mutants", "of": mutants[first:first + MUTANTS_OF_SHARD], "seed": 0}
               for first in range(0, len(mutants), MUTANTS_OF_SHARD)]
    shards += [{"name": f"proof.{theorem}.{part:02d}", "kind": "proof", "of": theorem, "part": f"{part}/{PARTS_OF_PROOF}", "size": size, "seed": 0}
               for theorem in theorems for part in range(PARTS_OF_PROOF)]
    shards += [{"name": f"experiment.{experiment}.{character}", "kind": "experiment", "of": experiment, "character": character, "seed": 0}
               for experiment, character in parts]
    if not shards:
        raise PlanError("there is nothing to do: no suites, no fuzz targets, no mutants, no theorems and no experiments")
    return {"cases": cases, "fuzz_seconds": fuzz_seconds, "effort": effort, "programs": programs, "shards": shards}


def effort_options(effort):
    """The options of the experiments' program for this effort."""
    return [] if effort == "default" else ["--" + effort]


def text_of(plan):
    return json.dumps(plan, indent=1) + "\n"
