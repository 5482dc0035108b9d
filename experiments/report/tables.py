# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of results: CSV files in long form, read into typed rows; and by the same reader, tables that are stored in the repository.

A row is a value of one quantity, in a unit, with what it is of: experiment, model, pose, variant, level and, by file, what
else a reader needs to know of it. What the report wants to know of a row is a column: nothing is parsed out of a name.
"""
import csv
import math
import pathlib
import re
from collections import namedtuple

PROVENANCE = ["commit", "dirty", "compiler", "flags", "cpu"]
UNITS = ["1", "ns", "us", "s", "MB", "pixel", "model unit", "size of the coordinates"]
ALL = "all"  # the level of a row that is of all levels


NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", re.ASCII)


class ResultError(Exception):
    """The message names the file and the reason."""


def text(field):
    return field


def number(field):
    if not NUMBER.fullmatch(field) or not math.isfinite(float(field)):
        raise ValueError("is no finite number")
    return float(field)


def count(field):
    if not (field.isascii() and field.isdigit()):
        raise ValueError("is no whole number")
    return int(field)


def level(field):
    return ALL if field == ALL else count(field)


def one_of(*allowed):
    def parse(field):
        if field not in allowed:
            raise ValueError(f"is none of {', '.join(allowed)}")
        return field
    return parse


yes_no = one_of("yes", "no")
pose_kind = one_of("clip", "twist", "worst_twist")
skinning = one_of("linear", "spherical", "dual_quaternion")
LONG = {"experiment": text, "model": text, "pose": text, "variant": text, "level": level, "quantity": text,
        "value": number, "unit": one_of(*UNITS)}
ORIGIN = one_of("own", "baseline", "engine", "bounded", "floor", "oracle")
SCHEMAS = {
    "tightness": {**LONG, "pose_kind": pose_kind, "poses": count},
    "volumes": {**LONG, "pose_kind": pose_kind, "poses": count},
    "speed": LONG,
    "batch_speed": {**LONG, "operation": text},
    "collisions": {**LONG, "scene": text, "query": one_of("full", "yes/no"), "origin": ORIGIN},
    "triangle_growth": {**LONG, "scene": text, "triangles": count},
    "joint_growth": {**LONG, "joints": count},
    "crowds": {**LONG, "scene": one_of("dense", "apart"), "characters": count},
    "rounding": LONG,
    "over_time": {**LONG, "skinning": skinning},
    "crossfades": {**LONG, "skinning": skinning},
    "over_time_growth": {**LONG, "walk_cycles": count, "triangles": count, "clusters": count},
    "engines": {**LONG, "skinning": one_of("all", "linear", "spherical", "dual_quaternion"), "kind": one_of("model", "clip", "twists", "cost")},
    "deformations": {**LONG, "skinning": one_of("all", "none", "linear", "spherical", "dual_quaternion"),
                     "kind": one_of("model", "rigid", "scaled", "scaled_along_axes", "morphed", "both", "own", "vibration", "vibration_skinned", "clip"),
                     "displacements": one_of("smallest", "bd_tree")},
    "synthetic": LONG,
    "pictures": {**LONG, "figure": text, "file": text},
    "picture_labels": {"file": text, "label": text, "x": number, "y": number},
    "picture_colors": {"meaning": text, "color": text},
    "drawings": {"drawing": text, "shape": one_of("circle", "path", "dot", "text", "caption"), "kind": text, "points": text,
                 "radius": number, "closed": yes_no, "label": text},
    "models": {"model": text, "found": yes_no, "packed_file": text},
    "variants": {"variant": text, "role": one_of("refit", "reference", "comparison", "optimal"), "skinning": skinning,
                 "sound": yes_no, "default": yes_no, "description": text},
    "detectors": {"detector": text, "origin": ORIGIN, "found": yes_no, "tolerated_share_of_pairs": number, "description": text},
    "constants": {"constant": text, "value": number, "unit": one_of(*UNITS)},
    "run": {"file": text, "effort": one_of("quick", "default", "full"), "models": one_of("default", "own")},
    "verdicts": {"stem": text, "role": one_of("statement", "hypothesis", "other"), "form": text,
                 "verdict": one_of("holds", "refuted", "skipped", "TEST FAILED"), "cases": count, "share_of_degenerate_cases": number, "number_type": text,
                 "hypothesis": text, "property": text},
}

MAY_BE_EMPTY = ["models", "crossfades"]  # of a run that needs none, and of models with one clip

# These are the columns that are read of tables in the repository, by path.
STORED = {
    "lemmas/proofs/status.csv": dict.fromkeys(["stem", "form", "statement", "status", "note"], text),
    "proptests/exhaustive/proved.csv": {"theorem": text},
    "proptests/mutants/judged.csv": dict.fromkeys(["file", "verdict", "at_first"], text),
    "paper/original_table1.csv": {"level": count, **dict.fromkeys(["reference", "linear", "spherical", "optimal"], number)},
    "paper/original_table2.csv": {**dict.fromkeys(["scenario", "model", "scene", "query"], text), **dict.fromkeys(["lbs", "sbs", "bottom_up"], number)},
}


def read(path, schema, may_be_empty=False, provenance=PROVENANCE):
    """The rows of a file as named tuples of the schema's columns and the provenance. schema: {column: parser}.

    Raises ResultError that names the file, the row (1 is the head) and the reason: a file that cannot be read, or has no rows
    and may not be empty; a column that is missing or there twice, a row that is cut off, a field that its parser refuses.
    """
    try:
        with open(path, newline="", encoding="utf-8") as file:
            table = list(csv.reader(file))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        maker = "; experiments/run or proptests/run makes it" if provenance else ""
        raise ResultError(f"{path}: cannot be read ({error}){maker}") from None
    parsers = {**schema, **dict.fromkeys(provenance, text)}
    head = table[0] if table else []
    for column in parsers:
        if head.count(column) != 1:
            raise ResultError(f"{path}: has {'two columns' if column in head else 'no column'} {column}")
    if not table[1:] and not may_be_empty:
        raise ResultError(f"{path}: has no rows")
    Row = namedtuple("Row", parsers)
    places = [(column, head.index(column), parse) for column, parse in parsers.items()]
    rows = []
    for row, fields in enumerate(table[1:], 2):
        if len(fields) != len(head):
            raise ResultError(f"{path}: row {row} has {len(fields)} fields, not {len(head)}")
        values = []
        for column, place, parse in places:
            try:
                values.append(parse(fields[place]))
            except ValueError as error:
                raise ResultError(f"{path}: row {row}: {column} '{fields[place]}' {error}") from None
        rows.append(Row(*values))
    return rows


def stored(root, path):
    """Returns the rows of a table in the repository."""
    return read(root / path, STORED[path], provenance=[])


def grouped(rows, key):
    """Returns {what key makes of a row: those rows}, in the order in which they first stand there."""
    out = {}
    for row in rows:
        out.setdefault(key(row), []).append(row)
    return out


class Results:
    """The tables of a folder, read when first asked for."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self._rows = {}
        self._by_variant = {}  # by file, variant and quantity: the tightness file alone has a hundred thousand rows

    def path(self, name):
        return self.folder / f"{name}.csv"

    def was_run(self, name):
        """Returns whether the last finished run wrote this table, that is, whether run.csv names it."""
        return any(row.file == f"{name}.csv" for row in self.rows("run"))

    def rows(self, name):
        if name not in self._rows:
            self._rows[name] = read(self.path(name), SCHEMAS[name], may_be_empty=name in MAY_BE_EMPTY)
            self._by_variant[name] = grouped(self._rows[name], lambda row: (getattr(row, "variant", None), getattr(row, "quantity", None)))
        return self._rows[name]

    def select(self, name, **where):
        """The rows with these values, in the file's order; a value may be a function that says which ones. Raises
        ResultError if there are none."""
        found = self.find(name, **where)
        if not found:
            raise ResultError(f"{self.path(name)}: has no row of " + said(where))
        return found

    def find(self, name, **where):
        """Returns the same, but there may be none."""
        rows = self.rows(name)
        if isinstance(where.get("variant"), str) and isinstance(where.get("quantity"), str):
            rows = self._by_variant[name].get((where["variant"], where["quantity"]), [])
        return [row for row in rows if all(v(getattr(row, k)) if callable(v) else getattr(row, k) == v for k, v in where.items())]

    def values(self, name, **where):
        return [row.value for row in self.select(name, **where)]

    def number(self, name, **where):
        """Returns the value of the one row with these values."""
        found = self.select(name, **where)
        if len(found) > 1:
            raise ResultError(f"{self.path(name)}: has {len(found)} rows, not one, of " + said(where))
        return found[0].value

    def number_or_none(self, name, **where):
        return self.number(name, **where) if self.find(name, **where) else None

    def distinct(self, name, column, **where):
        """Returns the different values of a column, in the order in which they first stand there."""
        return list(dict.fromkeys(getattr(row, column) for row in self.find(name, **where)))

    def constant(self, name):
        return self.number("constants", constant=name)

    def default_variant(self, skinning="spherical"):
        """Returns the name of the refit that the library takes unless told otherwise."""
        return self.select("variants", skinning=skinning, default="yes")[0].variant


def said(where):
    return ", ".join(f"{k} {'...' if callable(v) else repr(v)}" for k, v in where.items())
