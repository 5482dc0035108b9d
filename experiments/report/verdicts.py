"""The verdicts on the lemmas: what the property tests say of each statement, summed up here for the page and the paper."""
from dataclasses import dataclass, field

from .statistics import weighted_mean

VERDICTS = ("holds", "refuted")


@dataclass
class Verdict:
    """Of one statement, over its properties. lemma: the stem of its file."""
    lemma: str
    failed: bool = False        # a test failed: then nothing is said
    refuted_after: int = 0      # cases until the first counterexample to what is printed; 0: none was found
    printed_cases: int = 0      # in which what is printed held
    cases: int = 0              # in which what is repaired or goes beyond the paper held
    degenerate: float = 0       # the share of these that were degenerate
    number_types: list = field(default_factory=list)


def of_lemma(lemma, rows):
    """The verdict over these rows of verdicts.csv, which are all of this lemma."""
    def held(is_printed):
        return [r for r in rows if (r.form == "printed") == is_printed and r.verdict == "holds"]
    refuted = [r.cases for r in rows if r.form == "printed" and r.verdict == "refuted"]
    repaired = held(False)
    cases = sum(r.cases for r in repaired)
    return Verdict(lemma, any(r.verdict not in VERDICTS for r in rows), min(refuted, default=0),
                   sum(r.cases for r in held(True)), cases,
                   weighted_mean([r.degenerate_share for r in repaired], [r.cases for r in repaired]) if cases else 0,
                   list(dict.fromkeys(r.number_type for r in rows if r.number_type)))


def summed_up(rows):
    """By lemma, in the order of the table."""
    by_lemma = {}
    for row in rows:
        by_lemma.setdefault(row.lemma, []).append(row)
    return [of_lemma(lemma, some) for lemma, some in by_lemma.items()]


def section(results, page):
    """page.reference: the folder of the reference's pages, and where it is from the page."""
    if not results.path("verdicts").exists():
        return {"verdicts": None}
    rows = results.rows("verdicts")
    commits = sorted({row.commit for row in rows})
    verdicts = summed_up(rows)
    return {"verdicts": verdicts, "other_commits": [] if commits == [page.commit] else commits,
            "pages": {v.lemma: f"reference/{v.lemma}.html" for v in verdicts if (page.folder / "reference" / f"{v.lemma}.html").exists()}}
