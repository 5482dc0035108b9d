# SPDX-License-Identifier: GPL-3.0-or-later
"""README's blocks: what stands there between the lines <!-- NAME --> and <!-- /NAME -->, made of tables. The block "measured: NAME" ends with /measured."""
from .tables import ResultError


def place(text, path, name):
    """Returns where the block begins and ends in the text of a file. Raises ResultError if it is not there."""
    opening, closing = f"<!-- {name} -->\n", f"<!-- /{name.partition(':')[0]} -->"
    start = text.find(opening)
    end = text.find(closing, start)
    if start < 0 or end < 0:
        raise ResultError(f"{path}: the lines {opening.strip()} and {closing} are missing")
    return start + len(opening), end


def block(text, path, name):
    start, end = place(text, path, name)
    return text[start:end]


def replaced(text, path, name, new):
    start, end = place(text, path, name)
    return text[:start] + new + text[end:]
