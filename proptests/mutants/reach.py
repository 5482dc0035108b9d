# SPDX-License-Identifier: GPL-3.0-or-later
"""Which suites a source file reaches, by the include directives: those that are nearest first."""
import collections
import re

import proofs

FOLDERS = ("lemmas", "algorithms", "proptests", "experiments")
# It is about all other suites, and fails in a program that does not have them.
OF_ALL_SUITES = "error_list"


class Reach:
    def __init__(self, root):
        files = [p for folder in FOLDERS for p in sorted((root / folder).rglob("*")) if p.suffix in (".hpp", ".cpp")]
        self.users = collections.defaultdict(set)  # by file, who needs what is in it
        known = {str(p.relative_to(root)) for p in files}
        for path in files:
            name = str(path.relative_to(root))
            included = [i for i in re.findall(r'^#include "([^"]+)"', path.read_text(), re.M) if i in known]
            for other in included:
                self.users[other].add(name)
            # Who includes a header needs what is defined beside it: in the file of the same name, or in one that has none of its own.
            if path.suffix == ".cpp":
                own = name.removesuffix(".cpp") + ".hpp"
                beside = [i for i in included if i.rpartition("/")[0] == name.rpartition("/")[0]]
                for header in [own] if own in known else beside:
                    self.users[name].add(header)

    def suites(self, file):
        """(distance, stem) of the suites, the nearest first; before all others the one that is named after the file, or tests the vocabulary and
        its numbers."""
        if file.startswith(proofs.TARGET + "/"):
            return [(0, proofs.SUITE)]
        if file == "proptests/certificate/check_pairs":
            return [(0, "pairs_certificate")]
        if file.startswith("proptests/certificate/"):
            return [(1, "clip_certificate")] if "clip" in file or "over_time" in file else [(0, "check"), (1, "documents"), (2, "certificate")]
        distance, queue = {file: 0}, collections.deque([file])
        while queue:
            at = queue.popleft()
            for user in self.users[at]:
                if user not in distance:
                    distance[user] = distance[at] + 1
                    queue.append(user)
        own = [file.rpartition("/")[2].rpartition(".")[0]] + ["vocabulary"] * file.startswith(("lemmas/vocabulary/", "lemmas/exact/"))
        found = []
        for name, far in distance.items():
            folder, _, stem = name.removesuffix(".cpp").rpartition("/")
            if name.endswith(".cpp") and folder in ("proptests/lemmas", "proptests/algorithms") and stem != OF_ALL_SUITES:
                found.append((0 if stem in own else far, stem))
        return sorted(found)
