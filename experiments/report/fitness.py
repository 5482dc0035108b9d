# SPDX-License-Identifier: GPL-3.0-or-later
"""Says whether results are fit for the paper: whole, of one run, and not older than what made them.

Each row has the commit, dirty flag, compiler, flags and processor that it comes from. A file is stale if what made it has
changed since: any file of SOURCES, committed or not. All files must be of one commit, compiler and processor, and run.csv,
which a run writes when it is done, must name them as of a full run.
"""
import pathlib
import subprocess

from .tables import PROVENANCE, ResultError, Results

RUN = ["CMakeLists.txt", "lemmas", "algorithms", "experiments/CMakeLists.txt", "experiments/main.cpp", "experiments/options.cpp",
       "experiments/options.hpp", "experiments/run_file.hpp", "experiments/resume", "experiments/procedural", "experiments/scenes"]
TIMING = ["experiments/speed/timing.cpp", "experiments/speed/timing.hpp", "experiments/speed/statistics.hpp"]
QUERIES = ["experiments/collisions", "experiments/baselines", *TIMING]
SOURCES = {
    "tightness": [*RUN, "experiments/tightness"],
    "volumes": [*RUN, "experiments/tightness", "experiments/speed"],
    "speed": [*RUN, "experiments/speed"],
    "batch_speed": [*RUN, "experiments/speed"],
    "collisions": [*RUN, *QUERIES],
    "triangle_growth": [*RUN, *QUERIES, "experiments/growth"],
    "rounding": [*RUN, "experiments/rounding", *TIMING],
    "joint_growth": [*RUN, *QUERIES, "experiments/growth"],
    "crowds": [*RUN, *QUERIES, "experiments/crowds"],
    "over_time": [*RUN, "experiments/over_time", "proptests/oracles"],
    "crossfades": [*RUN, "experiments/over_time", "proptests/oracles"],
    "over_time_growth": [*RUN, "experiments/over_time", "proptests/oracles"],
    "engines": [*RUN, "experiments/engines", "experiments/over_time", *TIMING, "proptests/oracles"],
    "deformations": [*RUN, "experiments/deformations", "experiments/tightness", *TIMING],
    "variants": [*RUN, *QUERIES, "experiments/catalogue", "experiments/tightness"],
    "run": [*RUN, "experiments/render", "experiments/pictures"],
    "verdicts": ["CMakeLists.txt", "lemmas", "algorithms", "proptests/CMakeLists.txt", "proptests/main.cpp",
                 "proptests/harness", "proptests/lemmas", "proptests/algorithms", "proptests/gen",
                 "proptests/oracles", "proptests/refits", "proptests/counterexamples", "proptests/cases"],
}


class FitResults(Results):
    """Results that the paper may use. root: of the repository, for what is stale.

    With draft, what makes a file unfit is gathered in complaints and not raised; a file or a number that is missing or
    malformed is an error all the same.
    """

    def __init__(self, folder, root, draft=False):
        super().__init__(folder)
        self.root, self.draft = pathlib.Path(root), draft
        self.complaints = []
        self.provenance = {}  # by file

    def rows(self, name):
        if name not in self._rows:
            super().rows(name)
            self._judge(name)
        return self._rows[name]

    def _judge(self, name):
        path, rows = self.path(name), self._rows[name]
        own = {tuple(getattr(row, column) for column in PROVENANCE) for row in rows}
        if len(own) > 1:
            self._complain(f"{path}: its rows are of different runs")
        first = {column: getattr(rows[0], column) for column in PROVENANCE}
        dirty = first.pop("dirty")
        self.provenance[name] = first
        if dirty != "clean":
            self._complain(f"{path}: was made from sources with uncommitted changes ({first['commit']}, {dirty})")
        else:
            self._complain_if_stale(path, first["commit"], SOURCES[name])
        for other, provenance in self.provenance.items():
            differing = [c for c in provenance if provenance[c] != first[c]]
            if differing:
                c = differing[0]
                self._complain(f"{path}: is of another run than {self.path(other)} ({c} {first[c]}, not {provenance[c]})")
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
        if self.draft and not self.path("run").exists():
            return self._complain(f"{self.path('run')}: is missing: no run was finished")
        of_file = [row for row in self.rows("run") if row.file == f"{name}.csv"]
        if not of_file:
            self._complain(f"{self.path(name)}: is not of the last run ({self.path('run')} does not name it)")
        elif of_file[0].effort != "full":
            self._complain(f"{self.path(name)}: is not of a full run (experiments/run --full)")
        elif of_file[0].models != "default":
            self._complain(f"{self.path(name)}: is of other models than the default ones")

    def _git(self, *arguments):
        done = subprocess.run(["git", *arguments], cwd=self.root, text=True, capture_output=True)
        return done.stdout.splitlines() if done.returncode == 0 else None

    def _complain(self, message):
        if not self.draft:
            raise ResultError(message)
        if message not in self.complaints:
            self.complaints.append(message)
