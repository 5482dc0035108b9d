# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of a campaign's shards as one. The order of the shards does not matter, and a shard's table is as it is however often
the shard was begun: so what is merged is what an undisturbed run would have written."""
import csv
import os
import pathlib
import socket
from dataclasses import dataclass, field

KEY = ["stem", "role", "form", "number_type", "hypothesis", "property"]
BUILD = ["commit", "dirty", "compiler", "flags"]  # which all shards must have in common
COLUMNS = ["stem", "role", "form", "verdict", "cases", "seeds", "degenerate_cases", *KEY[3:], *BUILD]
FAILED = "TEST FAILED"


class MergeError(Exception):
    pass


@dataclass
class Claim:
    """What the shards found of one property, or of one example."""
    verdicts: set = field(default_factory=set)
    held: int = 0        # cases in which it held, of all seeds together
    degenerate: int = 0  # of them
    example: int = 0     # the cases of an example, which are the same with every seed
    first: int = 0       # cases until the first counterexample, with the seed that needed the fewest; 0 for none
    seeds: set = field(default_factory=set)

    def add(self, row, seed):
        """A row of a shard with this seed."""
        cases = int(row["cases"])
        self.verdicts.add(row["verdict"])
        self.seeds.add(seed)
        if row["verdict"] == "refuted":
            self.first = min(self.first or cases, cases)
        elif int(row["seed"]) == seed:  # properties have seeds of their own
            self.example = max(self.example, cases)
        else:
            self.held += cases
            self.degenerate += round(float(row["share_of_degenerate_cases"]) * cases)

    def row(self):
        verdict = FAILED if FAILED in self.verdicts else " or ".join(sorted(self.verdicts))
        return {"verdict": verdict, "cases": self.first or self.held + self.example, "seeds": len(self.seeds), "degenerate_cases": self.degenerate}


def merged_verdicts(tables):
    """tables: (seed, rows) of each shard. Returns the rows of all of them, in the order of the alphabet. Raises MergeError for shards of
    different builds, and for two of one seed that have the same claim."""
    claims, builds, seen = {}, set(), set()
    for seed, rows in tables:
        for row in rows:
            key = tuple(row[k] for k in KEY)
            if (key, seed) in seen:
                raise MergeError(f"two shards have the seed {seed} and the claim '{row['property']}' of {row['stem']}")
            seen.add((key, seed))
            builds.add(tuple(row[b] for b in BUILD))
            claims.setdefault(key, Claim()).add(row, seed)
    if len(builds) > 1:
        raise MergeError("the shards are of different builds: " + "; ".join(" ".join(b) for b in sorted(builds)))
    build = dict(zip(BUILD, next(iter(builds), [""] * len(BUILD))))
    return [{**dict(zip(KEY, key)), **claim.row(), **build} for key, claim in sorted(claims.items())]


def read_table(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def text_of(rows, columns):
    """A CSV file's text."""
    out = []
    for row in [dict(zip(columns, columns)), *rows]:
        fields = [str(row[c]) for c in columns]
        out.append(",".join('"' + f.replace('"', '""') + '"' if any(x in f for x in ',"\n') else f for f in fields))
    return "\n".join(out) + "\n"


def part_name(name):
    """Of a temporary file that no other process has, on whichever node of a cluster."""
    return f"{name}.{socket.gethostname()}.{os.getpid()}.part"


def write_whole(path, text):
    """The old file stays until the new one is there. Several processes may write the same file at once."""
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(part_name(path.name))
    temporary.write_text(text)
    temporary.replace(path)


def copy_units(source, target):
    """What an experiment measured, each file whole or not at all."""
    target.mkdir(parents=True, exist_ok=True)
    for unit in sorted(source.glob("*.unit")):
        temporary = target / part_name(unit.name)
        temporary.write_bytes(unit.read_bytes())
        temporary.replace(target / unit.name)
