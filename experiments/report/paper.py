# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's measured files: its numbers, tables and data of plots, which are those that its TeX files ask for, and no others."""
import re
import shutil

from .counterexamples import Cases, of_cases
from .formats import escaped, exact
from .paper_numbers import numbers, plots, tables
from .tables import ResultError
from .verdicts import order_of_stems


def texts(folder):
    """The paper's TeX files."""
    return sorted([*folder.glob("*.tex"), *folder.glob("sections/*.tex")])


def used(command, folder):
    """{argument: the file that has it} of a command of one argument, in all TeX files."""
    return {name: path for path in texts(folder) for line in path.read_text().splitlines()
            for name in re.findall(rf"\\{command}\{{([^}}#]*)\}}", re.sub(r"(?<!\\)%.*", "", line))}


def check_use(command, made, folder):
    """Everything that the text asks for is there, and everything that is there is asked for."""
    asked = used(command, folder)
    for name, path in asked.items():
        if name not in made:
            raise ResultError(f"{path}: \\{command}{{{name}}}: there is no such thing among the results")
    for name in made:
        if name not in asked:
            raise ResultError(f"{folder}: nothing asks for \\{command}{{{name}}}")


def draft_note(results):
    commits = sorted({p["commit"] for p in results.provenance.values()})
    return "DRAFT, from results of commit " + ", ".join(commits) if results.complaints else ""


def write(results, root, pictures, out):
    """Writes the files to the folder out, with the pictures that the text shows. root: of the repository."""
    folder = root / "paper"
    made = numbers(results, root)
    made.update({name: exact(value) for name, value in of_cases(Cases(root / "proptests/cases/cases.json")).items()})
    lemmas = ["algorithm1_printed", "algorithm1_repaired", *sorted((p.stem for p in (root / "lemmas").glob("*.hpp")), key=order_of_stems)]
    made_tables, made_plots = tables(results, lemmas, root), plots(results)
    results.rows("run") if not results.draft or (results.folder / "run.csv").exists() else None
    check_use("num", made, folder)
    check_use("resulttable", made_tables, folder)
    check_use("plotdata", made_plots, folder)
    check_use("lemmafile", lemmas[2:], folder)

    out.mkdir(parents=True, exist_ok=True)
    for name in used("rendered", folder):
        if not (pictures / name).is_file():
            raise ResultError(f"{pictures / name}: is missing; experiments/run draws it")
        shutil.copyfile(pictures / name, out / name)
    for name, text in made_tables.items():
        (out / f"{name}.tex").write_text(text)
    for name, text in made_plots.items():
        (out / f"{name}.dat").write_text(text)
    lines = [f"\\newcommand{{\\draftnote}}{{{escaped(draft_note(results))}}}"]
    lines += [f"\\expandafter\\def\\csname num@{name}\\endcsname{{{value}}}" for name, value in made.items()]
    (out / "numbers.tex").write_text("\n".join(lines) + "\n")
