# SPDX-License-Identifier: GPL-3.0-or-later
"""The verdicts on the lemmas: what the property tests say of each statement, summed up here for the page, the paper and README."""
import re
from dataclasses import dataclass

from markupsafe import Markup

from .statistics import weighted_mean
from .tables import grouped


@dataclass
class Verdict:
    """A Verdict is that of one statement, over its properties. stem is that of its file."""
    stem: str
    failed: bool         # a test failed: then nothing is said
    refuted_after: int   # cases until the first counterexample to what is printed; 0: none was found
    implied_after: int   # the same of what the text takes for granted without stating it
    printed_claims: list  # the cases in which each claim of what is printed held
    claims: list         # the cases in which each claim of what is repaired or goes beyond the paper held
    degenerate: float    # the share of these that were degenerate
    number_types: list
    hypotheses: list     # without which a counterexample is found


def of_stem(stem, rows):
    """Returns the verdict over these rows of verdicts.csv, which are all of this stem."""
    statements = [r for r in rows if r.role == "statement"]
    printed = [r for r in statements if r.form == "printed"]
    implied = [r for r in statements if r.form == "implied"]
    repaired = [r for r in statements if r.form not in ("printed", "implied") and r.verdict == "holds"]
    return Verdict(stem, any(r.verdict == "TEST FAILED" for r in rows),
                   *(min((r.cases for r in rows if r.verdict == "refuted"), default=0) for rows in (printed, implied)),
                   [r.cases for r in printed if r.verdict == "holds"], [r.cases for r in repaired],
                   weighted_mean([r.share_of_degenerate_cases for r in repaired], [r.cases for r in repaired]) if repaired else 0,
                   sorted({r.number_type for r in rows} - {""}), sorted({r.hypothesis for r in rows} - {""}))


def order_of_stems(stem):
    """Returns a key that sorts stems by the alphabet, and their numbers by size: b10 comes after b9."""
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", stem)]


def summed_up(rows):
    """Returns the verdict of each stem that has a statement, in the order of the stems."""
    of_stems = grouped(rows, lambda row: row.stem)
    return [of_stem(stem, of_stems[stem]) for stem in sorted(of_stems, key=order_of_stems) if any(r.role == "statement" for r in of_stems[stem])]


def said_of_claims(cases):
    """Returns how many claims held, and in how many cases each, or nothing if there are none."""
    if not cases:
        return ""
    each = f"{min(cases)} to {max(cases)}" if min(cases) < max(cases) else f"{cases[0]}"
    return f"{len(cases)} claims, {each} cases each" if len(cases) > 1 else f"1 claim, {each} cases"


def refutations(verdict, refuted="refuted"):
    """Returns what is said of what is printed and of what is implied, where it is refuted. refuted: that word, perhaps in bold."""
    return ([f"{refuted} after {verdict.refuted_after}"] * bool(verdict.refuted_after)
            + [f"implied: refuted after {verdict.implied_after}"] * bool(verdict.implied_after))


def said_of_printed(verdict, refuted="**refuted**"):
    if verdict.failed:
        return "TEST FAILED"
    holds = verdict.printed_claims and not verdict.refuted_after
    return "; ".join([f"holds ({said_of_claims(verdict.printed_claims)})"] * bool(holds) + refutations(verdict, refuted))


def said_of_repaired(verdict):
    if verdict.failed:
        return "TEST FAILED"
    return f"holds ({said_of_claims(verdict.claims)}, {100 * verdict.degenerate:.0f} % degenerate)" if verdict.claims else ""


def markdown(verdicts):
    """Returns the table as it stands in README."""
    rows = [["statement", "as printed", "repaired, or beyond", "numbers", "hypotheses shown necessary"], ["---"] * 5]
    rows += [[v.stem, said_of_printed(v), said_of_repaired(v), ", ".join(v.number_types), "; ".join(v.hypotheses).replace("|", "\\|")] for v in verdicts]
    return f"| {' | '.join(rows[0])} |\n|{'|'.join(rows[1])}|\n" + "".join(f"| {' | '.join(row)} |\n" for row in rows[2:])


def section(results, page):
    """Lemmas with a page in the reference beside the report are linked to it."""
    if not results.path("verdicts").exists():
        return {"verdicts": None}
    rows = results.rows("verdicts")
    commits = sorted({row.commit for row in rows})
    verdicts = summed_up(rows)
    return {"verdicts": verdicts, "said_of_printed": lambda v: Markup(said_of_printed(v, '<span class="bad">refuted</span>')), "said_of_repaired": said_of_repaired,
            "other_commits": [] if commits == [page.commit] else commits,
            "pages": {v.stem: f"reference/{v.stem}.html" for v in verdicts if (page.folder / "reference" / f"{v.stem}.html").exists()}}
