# SPDX-License-Identifier: GPL-3.0-or-later
"""Shards of a certificate as one (proptests/exhaustive/subdivide.hpp). A cell's tree does not depend on who proved it, so the certificate is, byte by byte,
the one that a run without shards writes."""
import json

CELL_DEPTH = 6  # as in subdivide.hpp
HEADER = ("theorem", "statement", "constant", "domain")


class MergeError(Exception):
    pass


def sides_of(path):
    """Which halves lead to a cell, as a number: its place in the order of cells."""
    return int("".join("1" if side == "+" else "0" for side in path[1::2]), 2)


def joined(cells):
    """The tree of all cells, which are (path, tree) in order."""
    tree, before = "", None
    for path, own in cells:
        shared = 0
        if before is not None:
            while path[2 * shared:2 * shared + 2] == before[2 * shared:2 * shared + 2]:
                shared += 1
            if path[2 * shared] != before[2 * shared]:
                raise MergeError(f"the cells {before} and {path} are of different cuts")
        tree += path[0 if before is None else 2 * shared + 2::2] + own
        before = path
    return tree


def merged(paths):
    """The certificate's text, of the files of all shards in any order."""
    header, cells = None, {}
    for path in paths:
        try:
            shard = json.loads(path.read_text())
            own = {key: shard[key] for key in HEADER}
            for cell, tree in shard["cells"]:
                if len(cell) != 2 * CELL_DEPTH:
                    raise MergeError(f"{path}: the cell {cell} is not {CELL_DEPTH} cuts deep")
                if cells.setdefault(sides_of(cell), (cell, tree)) != (cell, tree):
                    raise MergeError(f"{path}: another shard has another tree of the cell {cell}")
        except (ValueError, KeyError, TypeError) as e:
            raise MergeError(f"{path}: is no shard of a certificate: {e}") from e
        if header is not None and own != header:
            raise MergeError(f"{path}: is a shard of another certificate")
        header = own
    missing = [i for i in range(2 ** CELL_DEPTH) if i not in cells]
    if missing:
        raise MergeError(f"{len(missing)} of {2 ** CELL_DEPTH} cells are in no shard; the first is {missing[0]}")
    return json.dumps({**header, "tree": joined([cells[i] for i in sorted(cells)])}, indent=1, ensure_ascii=False) + "\n"
