# SPDX-License-Identifier: GPL-3.0-or-later
"""What C++ sources include, declare and name, found by regular expressions. proptests/architecture compares it with the pages and the
lemmas, and the table of statements (experiments/report/statements.py) takes from it which programs run a lemma."""
import pathlib
import re

INCLUDE = re.compile(r'^\s*#\s*include\s+(?:"([^"]+)"|<([^>]+)>)', re.M)
# What may hold braces that open nothing: raw strings, comments, strings and characters.
NO_CODE = re.compile(r'R"(\w*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.S)
# What a header declares at the beginning of a line: functions, types, constants and aliases.
DECLARED = re.compile(r"^(?!template|return|using|static_assert)[A-Za-z_][\w:<>,&* ]*[ &*](\w+)\(|^(?:struct|class|enum class) (\w+)"
                      r"|^inline constexpr [\w:]+ (\w+)|^using (\w+) =", re.M)
# Names but those of members, and of what is in other namespaces; and those of them that are called.
NAMES = re.compile(r"(?:(?<![\w.>:])refitlab::|(?<![\w.>:]))(\w+)")
CALLED = re.compile(NAMES.pattern + r"(?:<[\w:<>, *&]*>)?\(")


def sources(root, folders):
    return sorted(p for folder in folders for p in (root / folder).rglob("*") if p.suffix in (".hpp", ".cpp", ".h"))


def code_of(text):
    """Returns a file's text without include directives, comments and strings."""
    return NO_CODE.sub(" ", INCLUDE.sub("", text))


def stem(file):
    return pathlib.PurePosixPath(file).stem


def declared_in(pattern, text):
    return {name for found in pattern.findall(text) for name in found if name}


def functions_of(code):
    """Returns {name: the code of all functions of this name} of a lemma's code, and the names of constants, which are among the former."""
    bodies, constants, found = {}, set(), list(DECLARED.finditer(code))
    for this, after in zip(found, [*found[1:], None]):
        if name := this[1] or this[3]:
            bodies[name] = bodies.get(name, "") + code[this.end():after.start() if after else None]
            constants |= {name} if this[3] else set()
    return bodies, constants


def users_of_lemmas(root):
    """Returns, by the lemma's stem, the folders whose files call one of its functions or name one of its constants; and the stems of
    lemmas whose functions do so that what is shipped runs. Types do not count."""
    texts = {str(path.relative_to(root)): path.read_text() for path in sources(root, ("lemmas", "algorithms", "experiments"))}
    code = {file: code_of(text) for file, text in texts.items()}
    known = {file: functions_of(code[file]) for file in texts if str(pathlib.PurePosixPath(file).parent) == "lemmas"}
    included = {file: [quoted for quoted, _ in INCLUDE.findall(text)] for file, text in texts.items()}

    def named(file, part):
        """(lemma, function) of each that a part of a file's code names"""
        called, names = set(CALLED.findall(part)), set(NAMES.findall(part))
        return {(lemma, name) for lemma in {file, *included[file]} & set(known) for name in known[lemma][0]
                if name in called or name in names & known[lemma][1]}
    folders, ways, reached = {lemma: set() for lemma in known}, {lemma: set() for lemma in known}, set()
    for file in sorted(set(texts) - set(known)):
        found = named(file, code[file])
        for lemma, _ in found:
            folders[lemma].add(str(pathlib.PurePosixPath(file).parent))
        reached |= found if file.startswith("algorithms/") and not file.startswith("algorithms/methods/") else set()
    left = sorted(reached)
    while left:
        lemma, name = left.pop()
        found = named(lemma, known[lemma][0][name])
        for other, _ in found:
            ways[other] |= {lemma} - {other}
        left += found - reached
        reached |= found
    return {stem(lemma): (sorted(folders[lemma]), sorted(map(stem, ways[lemma]))) for lemma in known}
