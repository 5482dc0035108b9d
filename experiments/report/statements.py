# SPDX-License-Identifier: GPL-3.0-or-later
"""This sums up what stands behind each statement, for README, the reference and the paper: its tests, what of it is proved in
Coq or why not, and the programs that run it.

The tests' part is the run's (verdicts.csv), with what is proved for all points of a box of parameters (proptests/exhaustive/proved.csv) and
with how many mutants by rule of the statement's file the tests kill (proptests/mutants/judged.csv). The proofs' part is
lemmas/proofs/status.csv, which lemmas/proofs/check compares with the compiled library. The programs' part is what proptests/declarations.py
finds in the code: who calls a lemma's functions. A statement about a program, which has no lemma, is run by that program.
"""
import pathlib
import sys
from dataclasses import dataclass

sys.path += [str(pathlib.Path(__file__).resolve().parents[2] / folder) for folder in ("proptests", "proptests/certificate")]
import agreed  # noqa: E402
from declarations import users_of_lemmas  # noqa: E402

from .tables import ResultError, grouped, stored
from .verdicts import Verdict, refutations, said_of_claims

STATUS, PROVED, JUDGED = "lemmas/proofs/status.csv", "proptests/exhaustive/proved.csv", "proptests/mutants/judged.csv"


@dataclass
class Statement:
    """A Statement is what stands behind one statement. Names are those of the statements in Coq; that of the theorem has an
    ending."""
    verdict: Verdict
    suite: str      # the file of its tests
    exhaustive: list  # names of the theorems that are proved for all points of a box of parameters
    killed: int     # mutants by rule of its file
    planted: int    # of those that were planted, without those that do not compile or that are argued to be equivalent
    proved: list
    refuted: list   # proved false
    unproved: list  # sentences that say what is not proved, and why
    programs: list  # folders of algorithms/ and experiments/ whose code calls its functions
    through: list   # lemmas whose functions call its functions, where what is shipped runs them


def program_of(root, stem):
    """Returns the files of the program that a statement without a lemma is about. Raises ResultError if there is none of this name."""
    found = sorted((root / "algorithms").rglob(f"{stem}.hpp"))
    if not found:
        raise ResultError(f"{root / 'algorithms'}: there is no program of the name {stem}, and no lemma either")
    return [str(p.relative_to(root)) for p in found]


def suite_of(root, stem):
    for folder in ("lemmas", "algorithms"):
        if (root / "proptests" / folder / f"{stem}.cpp").exists():
            return f"proptests/{folder}/{stem}.cpp"
    raise ResultError(f"{root / 'proptests'}: there is no suite of the name {stem}")


def statements(root, verdicts):
    """Returns the statement of each verdict. Raises ResultError if a statement is neither proved nor has a sentence that says
    why not."""
    status, out = grouped(stored(root, STATUS), lambda row: row.stem), []
    theorems = grouped(stored(root, PROVED), lambda row: row.theorem.partition(".")[0])
    mutants, users = grouped(stored(root, JUDGED), lambda row: row.file), users_of_lemmas(root)
    for verdict in verdicts:
        rows = status.get(verdict.stem, [])
        if not rows or any(row.status == "not proved" and not row.note for row in rows):
            raise ResultError(f"{root / STATUS}: {verdict.stem} is not proved, and no sentence says why")
        programs, through = users[verdict.stem] if verdict.stem in users else (program_of(root, verdict.stem), [])

        def those(outcome, column):
            return [getattr(row, column) for row in rows if row.status == outcome]
        own = [f"lemmas/{verdict.stem}.hpp"] if verdict.stem in users else programs
        judged = [row.verdict for file in own for row in mutants.get(file, [])]
        exhaustive = sorted({row.theorem.partition(".")[2] for row in theorems.get(verdict.stem, [])})
        out.append(Statement(verdict, suite_of(root, verdict.stem), exhaustive, judged.count("killed"), judged.count("killed") + judged.count("alive"),
                             those("proved", "statement"), those("refuted", "statement"), those("not proved", "note"), programs, through))
    return out


def said_of_tests(statement):
    v = statement.verdict
    if v.failed:
        return "TEST FAILED"
    return "; ".join(filter(None, [*refutations(v), said_of_claims(v.printed_claims + v.claims)]))


def cells(statement, code, plain):
    """How it is tested and what is proved of it (both lists of lines), and what runs it. code and plain: what makes a name of code, and a
    sentence, of a text."""
    def names(found):
        return ", ".join(code(name) for name in found)
    tests = [said_of_tests(statement)]
    tests += ["Exhaustively: " + names(statement.exhaustive) + "."] if statement.exhaustive else []
    tests += [f"Mutants by rule killed: {statement.killed} of {statement.planted}."] if statement.planted else []
    proofs = [names(statement.proved)] if statement.proved else []
    proofs += ["Proved false: " + names(statement.refuted) + "."] if statement.refuted else []
    proofs += ["Not proved: " + plain(note) for note in statement.unproved]
    runs = [name.removeprefix("algorithms/") for name in statement.programs]
    run_by = [names(runs)] if runs else []
    if statement.through and all(name.startswith(("methods/", "experiments/")) for name in runs):  # which are compared or drawn, not shipped
        run_by.append("by way of " + names(statement.through))
    return tests, proofs, "; ".join(run_by) or "no program"


HEAD = ["statement", "tested in exact arithmetic", "proved in Coq", "run by"]


def markdown(found):
    """Returns the table as it stands in README."""
    rows = [HEAD, ["---"] * 4]
    for s in found:
        tests, proofs, run_by = cells(s, lambda name: f"`{name}`", str)
        rows.append([f"[{s.verdict.stem}]({s.suite})", "<br>".join(tests), "<br>".join(proofs), run_by])
    return "".join("| " + " | ".join(row).replace("||", "\\|\\|") + " |\n" for row in rows)


def said_of_proofs(root):
    """Returns how many statements are proved and refuted in Coq, and on which axioms, in whole sentences."""
    proved, refuted = ([row for row in stored(root, STATUS) if row.status == status] for status in ("proved", "refuted"))
    by_paper = sum(row.form in ("printed", "implied") for row in refuted)
    try:
        axioms = sum(line.startswith("used ") for line in (root / "lemmas/proofs/axioms.txt").read_text(encoding="utf-8").splitlines())
    except OSError as error:
        raise ResultError(f"{error.filename}: cannot be read: {error}") from error
    try:
        judged = agreed.totals(root)
    except (OSError, KeyError, ValueError) as error:
        raise ResultError(f"{root / agreed.TABLE}: cannot be read: {error}") from error
    of_kinds = [f"{true} true ones of {kind} and {others} others ({true_by_kernel} and {others_by_kernel} by the kernel)"
                for kind, (true, others, true_by_kernel, others_by_kernel) in judged.items() if true]
    certificates = (f"Of certificates, the Python checkers, the proved program and Coq's kernel judged alike\n{' and '.join(of_kinds)};\n"
                    f"most others are tampered with. (`{agreed.TABLE}`; `proptests/certificate/agree --record` adds to it.)\n" if of_kinds else "")
    return (f"In Coq {len(proved)} statements are proved. {len(refuted)} are proved false, {by_paper} of them as the paper prints or implies them. Nothing is admitted, and the\n"
            f"theorems rest on {axioms} axioms, which are those of Coq's real numbers. (`lemmas/proofs/check` compiles and checks them all.)\n{certificates}")
