# SPDX-License-Identifier: GPL-3.0-or-later
"""Copies of the sources in which mutants are planted, each with a build of its own, and programs of a few suites each."""
import contextlib
import fcntl
import hashlib
import os
import pathlib
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys

import proofs
from passed import Passed

ROOT = pathlib.Path(__file__).resolve().parents[2]
TIME_LIMIT = 900  # seconds of the processor's time, of one run of the suites
MEMORY_LIMIT = 8 << 30  # bytes of addresses, of one run of the suites: a mutant that never ends takes no more


class CannotJudge(Exception):
    """Because the suites do not build, or fail, without a mutant, too, or because the machine fails."""


def machine_failure(output):
    """The line in which a compiler or a linker says that it failed for want of memory or room, or was killed; "" if none."""
    reasons = ("Killed signal", "No space left on device", "out of memory", "memory exhausted", "Cannot allocate memory")
    return next((line.strip() for line in output.splitlines() if any(reason in line for reason in reasons)), "")


class Copy:
    """A copy of the sources, its build, and a program made of some of the suites."""

    def __init__(self, number):
        self.folder = ROOT / "out" / "mutants" / str(number)
        self.source, self.build_folder = self.folder / "source", self.folder / "build"
        self.needed = {}  # by suites: the link command and the objects that it takes
        self.archives = {}  # by name: the objects of what is linked as an archive of their places
        self.folder.mkdir(parents=True, exist_ok=True)
        self.lock = open(self.folder / "lock", "w")

    def is_free(self):
        """Whether it was, and is this process's now."""
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return True
        except BlockingIOError:
            return False

    def prepare(self):
        self.passed = Passed(self.folder.parent / "passed", self.copy_sources())
        subprocess.run(["cmake", "-S", self.source, "-B", self.build_folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DCMAKE_CXX_FLAGS_RELEASE=-O1", "-DREFITLAB_EXPERIMENTS=OFF", "-DREFITLAB_UNITY=OFF"], check=True,
                       stdout=subprocess.DEVNULL)

    def copy_sources(self):
        """Brings the copy up to date without touching files that did not change, so that builds stay incremental. Returns a digest of them."""
        files = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True, text=True,
                               capture_output=True).stdout.split("\n")
        wanted = {f for f in files if f and (ROOT / f).is_file()}
        for name in wanted:
            target = self.source / name
            text = (ROOT / name).read_bytes()
            if not target.exists() or target.read_bytes() != text:
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(text)
                shutil.copymode(ROOT / name, target)
        for path in [p for p in self.source.rglob("*") if p.is_file()]:
            if str(path.relative_to(self.source)) not in wanted:
                path.unlink()
        digest = hashlib.sha256()
        for name in sorted(wanted):
            digest.update(name.encode() + b"\0" + hashlib.sha256((ROOT / name).read_bytes()).digest())
        return digest.hexdigest()[:16]

    def ninja(self, *arguments):
        # All copies share what is compiled: to ccache their paths are relative, and a header's text counts, not its age.
        environment = {**os.environ, "CCACHE_BASEDIR": str(self.folder),
                       "CCACHE_SLOPPINESS": "include_file_mtime,include_file_ctime"}
        done = subprocess.run(["ninja", "-C", self.build_folder, *arguments], text=True, capture_output=True,
                              env=environment)
        return done.returncode == 0, done.stdout + done.stderr

    def members(self, libraries):
        """The objects of each of the build's libraries."""
        ok, text = self.ninja("-t", "query", *libraries)
        if not ok:
            sys.exit("mutants: no such libraries: " + text)
        parts = re.split(r"^(\S+):$", text, flags=re.M)
        return {name: re.findall(r"^    ([^ :|][^ ]*\.o)$", of, re.M) for name, of in zip(parts[1::2], parts[2::2])}

    def link(self, stems, jobs):
        """The command that links these suites, and the objects that the linker takes for it: what a mutant does not reach is not compiled.
        It is found once, with the sources as they are, before a mutant is planted.

        The suites, the fuzz targets, which tell of themselves, and the main program are objects; all else is in archives that name objects where they are, of which the linker takes
        what it needs."""
        key = tuple(sorted(stems))
        if key in self.needed:
            return self.needed[key]
        ok, commands = self.ninja("-t", "commands", "proptests/proptests")
        if not ok:
            sys.exit("mutants: no way to build the tests: " + commands)
        words, command, objects, helpers = shlex.split(commands.strip().split("\n")[-1].split("&&")[1]), [], [], []
        for word in words:
            path = pathlib.Path(word)
            if is_suite(word) and path.name.removesuffix(".cpp.o") not in stems:
                continue
            is_target = path.parent.name == "fuzz"
            if is_target and "fuzz" not in stems:
                continue
            if path.suffix == ".o" and not is_suite(word) and not is_target and path.parent.name != "proptests.dir":
                helpers.append(word)
                continue
            if path.suffix == ".a" and not path.is_absolute():
                command.append(str(self.thin(word)))
                continue
            command.append(word)
            if path.suffix == ".o":
                objects.append(word)
        libraries = [word for word in words if word.endswith(".a") and not os.path.isabs(word)]
        members = {**(self.archives or self.members(libraries)), "helpers.a": helpers}
        ok, output = self.ninja("-j", str(jobs), *objects, *(member for of in members.values() for member in of))
        if not ok:
            return None, output
        if not self.archives:
            for name, of in members.items():
                self.archive(self.thin(name), of)
            self.archives = members
        at = command.index("-o")
        program = self.build_folder / ("mutant_" + hashlib.sha256(" ".join(key).encode()).hexdigest()[:16])
        command[at + 1] = str(program)
        # In front of the libraries, which helpers need, too.
        command.insert(max(i for i, word in enumerate(command) if word.endswith(".o")) + 1, str(self.thin("helpers.a")))
        traced = subprocess.run([*command, "-Wl,--trace"], cwd=self.build_folder, text=True, capture_output=True)
        if traced.returncode != 0:
            return None, traced.stdout + traced.stderr
        taken = set(re.findall(r"(?:^|\()((?:[^\s()]*/)?(?:CMakeFiles|algorithms|proptests|lemmas)/[^\s()]*\.o)\)?$", traced.stdout, re.M))
        taken = {os.path.relpath(t, self.build_folder) if os.path.isabs(t) else t for t in taken}
        self.needed[key] = (command, sorted(taken | set(objects)), program)
        return self.needed[key]

    def thin(self, library):
        return self.build_folder / ("thin_" + pathlib.Path(library).name)

    def archive(self, path, members):
        path.unlink(missing_ok=True)
        subprocess.run(["ar", "rcsT", path, *members], cwd=self.build_folder, check=True)

    def build(self, stems, jobs, planted=None):
        """(the program, or None, and what the compiler said).

        planted: a source file with a mutant. Then only its object is made anew, and for a header those of the suites: all else is as it was
        before. What such a program finds wrong is wrong with the mutant, but it may overlook what a whole build sees."""
        if stems == [proofs.SUITE]:
            return proofs.build(self, jobs)
        command, parts, *program = self.link(stems, jobs)
        if command is None:
            return None, parts[-4000:]
        if planted:
            own = "/" + planted.partition("/")[2].rpartition(".")[0] + ".cpp.o"
            parts = [p for p in parts if p.endswith(own) or is_suite(p) and planted.endswith(".hpp")]
        ok, output = self.ninja("-j", str(jobs), *parts) if parts else (True, "")
        if ok:
            done = subprocess.run(command, cwd=self.build_folder, text=True, capture_output=True)
            ok, output = done.returncode == 0, done.stdout + done.stderr
        if not ok and (broken := machine_failure(output)):
            raise CannotJudge(broken)
        return program[0] if ok else None, output[-4000:]

    def first_failure(self, program, limit=TIME_LIMIT, suite=None):
        """The sentence of the first test that fails, or None if all pass. limit: seconds of the processor's time. suite: the only one that is
        run, of those that the program has."""
        if suite == proofs.SUITE:
            return proofs.first_failure(self, program, limit)
        only = ["--only", "=" + suite] if suite else []
        process = subprocess.Popen([program, *only], text=True, errors="replace", stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, cwd=ROOT,
                                   preexec_fn=lambda: bound_resources(limit))
        try:
            for line in process.stdout:
                if failed := re.match(r"  (.*)  \[ FAIL \]", line):
                    process.kill()
                    return failed[1]
            code = process.wait()
            if code == -signal.SIGKILL:
                raise CannotJudge("the suites were killed from outside")
            if code == -signal.SIGXCPU:
                return f"no end within {limit} s of the processor's time"
            return None if code == 0 else f"the run ended with code {code}"
        finally:
            process.wait()

    @contextlib.contextmanager
    def planted(self, file, text):
        """A context in which the copy's file has this text. After it the file is as old as it was, so that objects made before are still up to
        date; those made of the mutant go."""
        path = self.source / file
        original, times = path.read_text(), path.stat()
        path.write_text(text)
        planted_at = path.stat().st_mtime_ns
        try:
            yield
        finally:
            for made in self.build_folder.rglob("*.o"):
                if made.stat().st_mtime_ns >= planted_at:
                    made.unlink()
            path.write_text(original)
            os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))


def bound_resources(seconds):
    """Of this process. Nothing ends it with SIGKILL before SIGXCPU has."""
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 60))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))


def is_suite(made):
    """Whether an object is that of a suite."""
    path = pathlib.Path(made)
    return path.name.endswith(".cpp.o") and path.parent.name in ("lemmas", "algorithms")


def free_copy():
    """The first that no other process uses."""
    number = 0
    while not (copy := Copy(number)).is_free():
        number += 1
    copy.prepare()
    return copy
