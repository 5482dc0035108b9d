# SPDX-License-Identifier: GPL-3.0-or-later
"""Which suites pass without a mutant."""
import time


class Passed:
    """A suite is run once with the sources as they are, in whichever program, and all copies of these sources know."""

    def __init__(self, path, sources):
        """path: of a file, which may be there. sources: a digest of what the suites and all else are made of."""
        self.path, self.sources = path, sources

    def seconds(self):
        """By suite."""
        rows = [line.split() for line in self.path.read_text().splitlines()] if self.path.exists() else []
        return {row[1]: float(row[2]) for row in rows if len(row) == 3 and row[0] == self.sources}

    def passes(self, suite, run):
        """Whether it does. run: gives the sentence of what fails, or None."""
        if suite in self.seconds():
            return True
        start = time.monotonic()
        if run():
            return False
        with open(self.path, "a") as file:
            file.write(f"{self.sources} {suite} {time.monotonic() - start:.1f}\n")
        return True
