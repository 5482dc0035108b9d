# SPDX-License-Identifier: GPL-3.0-or-later
"""The program that proves exhaustively, in a copy of the sources, and its tests: they are a suite to the mutants of proptests/exhaustive."""
import re
import resource
import subprocess

SUITE, TARGET = "exhaustive", "proptests/exhaustive"


def build(copy, jobs):
    """(the program, or None, and what the compiler said)."""
    ok, output = copy.ninja("-j", str(jobs), TARGET)
    return copy.build_folder / TARGET if ok else None, output[-4000:]


def first_failure(copy, program, limit):
    """A sentence on the first test that fails, or on the small proofs if they are not those that are kept; None if all is well. limit: seconds
    of the processor's time, of each process."""
    folder = copy.source / TARGET
    for command in ([folder / "test", "--program", program, "--failfast"],
                    [folder / "drive", "--program", program, "--cores", "1", "--out", copy.folder / "certificates"]):
        done = subprocess.run(command, text=True, capture_output=True, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 5)))
        if done.returncode != 0:
            failed = re.search(r"^(?:FAIL|ERROR): (\w+)", done.stderr, re.M)
            return f"{SUITE}: {failed[1] if failed else (done.stderr.strip().splitlines() or ['no word'])[-1]}"
    return None
