# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of what all checkers of certificates judged alike, which `agree --record` writes. A row is of the checkers whose sources
have its digest: what other ones said does not count."""
import csv, hashlib

TABLE = "proptests/certificate/agreed.csv"
COLUMNS = ["kind", "checkers", "seed", "count", "true", "others", "true_by_kernel", "others_by_kernel"]
SOURCES = ["proptests/certificate/check*", "lemmas/proofs/checker/*.v", "lemmas/proofs/checker/in_kernel", "lemmas/proofs/checker/ocaml/*.ml"]
NOT_OF = {"balls": {"check_pairs", "check_clip", "pairs.v", "quick.v", "pairs.ml"}, "pairs": {"check", "check_clip"}}

def sources_digest(root, kind):
    """Of all that decides what is accepted: the first 12 digits of SHA-256."""
    files = sorted(path for pattern in SOURCES for path in root.glob(pattern) if path.name not in NOT_OF[kind])
    return hashlib.sha256(b"".join(hashlib.sha256(path.read_bytes()).digest() for path in files)).hexdigest()[:12]

def totals(root):
    """Of each kind, the sums of the columns true to others_by_kernel over the rows of today's checkers. A seed counts once."""
    today = {kind: sources_digest(root, kind) for kind in NOT_OF}
    of_seed = {kind: {} for kind in NOT_OF}
    with (root / TABLE).open(newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            if row["checkers"] == today[row["kind"]]:
                of_seed[row["kind"]][row["seed"]] = [int(row[column]) for column in COLUMNS[4:]]
    return {kind: [sum(column) for column in zip([0] * 4, *rows.values())] for kind, rows in of_seed.items()}
