"""Result files of a run, and whether the paper may use them.

Rows in long form, each with the commit, dirty flag, compiler, flags and processor that it comes from. A file is stale if
what made it has changed since: any file of SOURCES, committed or not. All files must be of one commit, compiler and
processor, and out/results/run.csv, which a run writes when it is done, must name them.
"""
import csv
import math
import pathlib
import subprocess

RUN = ["CMakeLists.txt", "lemmas", "algorithms", "experiments/CMakeLists.txt", "experiments/main.cpp",
       "experiments/parallel.hpp", "experiments/scenes"]
QUERIES = ["experiments/collisions", "experiments/rivals", "experiments/speed/timing.cpp", "experiments/speed/timing.hpp"]
SOURCES = {
    "tightness": [*RUN, "experiments/tightness"],
    "volumes": [*RUN, "experiments/tightness", "experiments/speed"],
    "speed": [*RUN, "experiments/speed"],
    "batch_speed": [*RUN, "experiments/speed"],
    "collision": [*RUN, *QUERIES],
    "triangle_growth": [*RUN, *QUERIES, "experiments/growth"],
    "rounding": [*RUN, "experiments/rounding", "experiments/speed/timing.cpp", "experiments/speed/timing.hpp"],
    "joint_growth": [*RUN, *QUERIES, "experiments/growth"],
    "character_growth": [*RUN, *QUERIES, "experiments/growth"],
    "run": [*RUN, "experiments/render", "experiments/report/twist_figures.cpp"],
    "verdicts": ["CMakeLists.txt", "lemmas", "algorithms", "proptests/CMakeLists.txt", "proptests/main.cpp",
                 "proptests/harness.cpp", "proptests/harness.hpp", "proptests/session.cpp", "proptests/session.hpp",
                 "proptests/verdict_table.cpp", "proptests/lemmas", "proptests/algorithms", "proptests/gen",
                 "proptests/oracles", "proptests/counterexamples", "proptests/cases"],
}
PROVENANCE = ["commit", "dirty", "compiler", "flags", "cpu"]
LONG = ["experiment", "model", "posture", "variant", "level", "quantity", "value", "unit", *PROVENANCE]
COLUMNS = {"verdicts": ["lemma", "form", "verdict", "cases", "degenerate_share", "number_type", *PROVENANCE],
           "run": ["file", "effort", "models", *PROVENANCE]}
NUMERIC = {"verdicts": ["cases", "degenerate_share"], "run": []}


class ResultError(Exception):
    """The message names the file and the reason."""


class Results:
    """The result files of a folder, read when first asked for. root: of the repository, for what is stale.

    With draft, what makes a file unfit for the paper is gathered in complaints and not raised; a file or a number that is
    missing or malformed is an error all the same.
    """

    def __init__(self, folder, root, draft=False):
        self.folder, self.root, self.draft = pathlib.Path(folder), pathlib.Path(root), draft
        self.complaints = []
        self.provenance = {}  # by file
        self._rows = {}
        self._by_variant = {}  # by file, variant and quantity: the tightness file alone has a hundred thousand rows

    def rows(self, name):
        if name not in self._rows:
            self._rows[name] = self._read(name)
            self._judge(name)
            index = self._by_variant[name] = {}
            for row in self._rows[name]:
                index.setdefault((row.get("variant"), row.get("quantity")), []).append(row)
        return self._rows[name]

    def select(self, name, **where):
        """The rows with these values; a value may be a function that says which ones. Raises ResultError for none."""
        def fits(row):
            return all(v(row[k]) if callable(v) else row[k] == v for k, v in where.items())
        rows = self.rows(name)
        if isinstance(where.get("variant"), str) and "quantity" in where:
            rows = self._by_variant[name].get((where["variant"], where["quantity"]), [])
        found = [row for row in rows if fits(row)]
        if not found:
            raise ResultError(f"{self._path(name)}: has no row of " + self._text(where))
        return found

    def number(self, name, **where):
        """The value of the one row with these values."""
        found = self.select(name, **where)
        if len(found) > 1:
            raise ResultError(f"{self._path(name)}: has {len(found)} rows, not one, of " + self._text(where))
        return float(found[0]["value"])

    def _text(self, where):
        return ", ".join(f"{k} {'...' if callable(v) else repr(v)}" for k, v in where.items())

    def _path(self, name):
        return self.folder / f"{name}.csv"

    def _read(self, name):
        path = self._path(name)
        try:
            text = path.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise ResultError(f"{path}: cannot be read ({error}); experiments/run or proptests/run makes it") from None
        table = list(csv.reader(text.splitlines(keepends=True)))
        missing = [c for c in COLUMNS.get(name, LONG) if not table or c not in table[0]]
        if missing:
            raise ResultError(f"{path}: has no column {missing[0]}")
        rows = []
        for line, fields in enumerate(table[1:], 2):
            if len(fields) != len(table[0]):
                raise ResultError(f"{path}: row {line} has {len(fields)} fields, not {len(table[0])}")
            row = dict(zip(table[0], fields))
            for column in NUMERIC.get(name, ["value"]):
                if not is_finite(row[column]):
                    raise ResultError(f"{path}: row {line}: {column} '{row[column]}' is no finite number")
            rows.append(row)
        if not rows:
            raise ResultError(f"{path}: has no rows")
        return rows

    def _judge(self, name):
        path, rows = self._path(name), self._rows[name]
        own = {tuple(row[c] for c in PROVENANCE) for row in rows}
        if len(own) > 1:
            self._complain(f"{path}: its rows are of different runs")
        commit, dirty, compiler, flags, cpu = (rows[0][c] for c in PROVENANCE)
        self.provenance[name] = dict(commit=commit, compiler=compiler, flags=flags, cpu=cpu)
        if dirty != "clean":
            self._complain(f"{path}: was made from sources with uncommitted changes ({commit}, {dirty})")
        else:
            self._complain_if_stale(path, commit, SOURCES[name])
        for other, provenance in self.provenance.items():
            differing = [c for c in provenance if provenance[c] != self.provenance[name][c]]
            if differing:
                c = differing[0]
                self._complain(f"{path}: is of another run than {self._path(other)} "
                               f"({c} {self.provenance[name][c]}, not {provenance[c]})")
                break
        if name not in ("run", "verdicts"):
            self._complain_if_unfinished(name)

    def _complain_if_stale(self, path, commit, sources):
        changed = self._git("diff", "--name-only", commit, "--", *sources)
        if changed is None:
            return self._complain(f"{path}: its commit {commit} is not in this repository")
        changed += self._git("ls-files", "--others", "--exclude-standard", "--", *sources) or []
        if changed:
            self._complain(f"{path}: is stale: made at {commit}, and since then {changed[0]}"
                           + (f" and {len(changed) - 1} more of its sources" if changed[1:] else "") + " changed")

    def _complain_if_unfinished(self, name):
        if self.draft and not self._path("run").exists():
            return self._complain(f"{self._path('run')}: is missing: no run was finished")
        of_file = [row for row in self.rows("run") if row["file"] == f"{name}.csv"]
        if not of_file:
            self._complain(f"{self._path(name)}: is not of the last run ({self._path('run')} does not name it)")
        elif of_file[0]["effort"] == "quick":
            self._complain(f"{self._path(name)}: is of a quick run")
        elif of_file[0]["models"] != "default":
            self._complain(f"{self._path(name)}: is of other models than the default ones")

    def _git(self, *arguments):
        done = subprocess.run(["git", *arguments], cwd=self.root, text=True, capture_output=True)
        return done.stdout.splitlines() if done.returncode == 0 else None

    def _complain(self, message):
        if not self.draft:
            raise ResultError(message)
        if message not in self.complaints:
            self.complaints.append(message)


def is_finite(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False
