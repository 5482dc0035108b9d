# SPDX-License-Identifier: GPL-3.0-or-later
"""Mutants by rule: every place of a source file where a rule could plant an error, and an order in which to take a sample of them.

The rules know C++ and Python by their tokens alone. That is enough because sources are laid out by clang-format: an operator of two
operands has a space on either side, and the brackets of a template have none.
"""
import collections
import hashlib
import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Mutant:
    file: str      # from the root of the sources
    rule: str
    at: int        # where old stands in the file's text
    old: str
    new: str

    def applied_to(self, text):
        assert text[self.at:self.at + len(self.old)] == self.old
        return text[:self.at] + self.new + text[self.at + len(self.old):]

    def lines(self, text):
        """The line, and what becomes of it."""
        start, end = text.rfind("\n", 0, self.at) + 1, text.find("\n", self.at + len(self.old))
        end = len(text) if end < 0 else end
        return text[start:end].strip(), (text[start:self.at] + self.new + text[self.at + len(self.old):end]).strip()


SWAPPED = {"+": "-", "-": "+", "*": "/", "/": "*", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||",
           "||": "&&", "and": "or", "or": "and", "true": "false", "false": "true", "True": "False", "False": "True", "low": "high",
           "high": "low", "min": "max", "max": "min", "Min": "Max", "Max": "Min", "above": "below", "below": "above", "floor": "ceil",
           "ceil": "floor", "holds": "fails", "fails": "holds", "MPFR_RNDD": "MPFR_RNDU", "MPFR_RNDU": "MPFR_RNDD", "inf": "sup",
           "sup": "inf"}
OPERAND = r"(?<=[\w)\]])"


def swaps(name, pattern, text):
    """Each match of the pattern's group 1 becomes its opposite."""
    return [(name, m.start(1), m[1], SWAPPED[m[1]]) for m in re.finditer(pattern, text)]


def numbers(text):
    out = []
    for m in re.finditer(r"(?<![\w.])(0x[\da-fA-F.]+p[+-]?\d+|\d+\.\d+(?:e[+-]?\d+)?f?|\d+e[+-]?\d+|\d+)(?![\w.']|, ?\w*>|>)", text):
        number = m[1]
        if number.isdigit():
            out.append(("constant", m.start(1), number, str(int(number) + 1)))
        else:
            out.append(("constant", m.start(1), number, f"({number} * 2)" if float_of(number) else "1.0"))
    return out


def float_of(text):
    return float.fromhex(text) if text.startswith("0x") else float(text.rstrip("f"))


def end_of_term(text, at, operators):
    """Where what begins at this place ends: before the next of these operators on its level, or before what closes it."""
    depth = 0
    for i in range(at, len(text)):
        c = text[i]
        if c in "([{":
            depth += 1
        elif c in ")]}":
            if depth == 0:
                return i
            depth -= 1
        elif depth == 0 and (c in ";,?" or c in operators and text[i - 1] == " " and i > at):
            return i - 1 if text[i - 1] == " " else i
        elif c == "\n" and text[i:i + 2] == "\n\n":
            return None
    return None


def dropped_terms(text):
    """a + b becomes a, and a && b becomes a."""
    out = []
    for m in re.finditer(OPERAND + r"( (?:\+|-|&&|\|\||and|or) )(?=[\w(!-])", text):
        is_logic = m[1].strip() not in ("+", "-")
        end = end_of_term(text, m.end(1), "&|:" if is_logic else "+-<>=!&|:")
        if end:
            out.append(("term left out", m.start(1), text[m.start(1):end], ""))
    return out


def closing(text, at):
    """Of the bracket that opens at this place."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] in "([{") - (text[i] in ")]}")
        if depth == 0:
            return i
    return None


def guards(text):
    out = []
    for m in re.finditer(r"\bif \(", text):
        end = closing(text, m.end() - 1)
        if end and ";" not in text[m.end():end]:
            for value in ("false", "true"):
                out.append(("guard " + value, m.end(), text[m.end():end], value))
    return out


def end_on_level(text, at, ends):
    """Where one of these texts is first on the level of this place, or what closes the level. None where an empty line comes first."""
    depth = 0
    for i in range(at, len(text)):
        if depth == 0 and any(text.startswith(end, i) for end in ends):
            return i
        if text[i] in ")]}" and depth == 0 or text.startswith("\n\n", i):
            return i if text[i] in ")]}" else None
        depth += (text[i] in "([{") - (text[i] in ")]}")
    return None


def python_guards(text):
    """if a: b, b if a else c, [b for c in d if a] and require(a, b), as if a always or never were so. What is always required never passes, and is not
    worth a mutant."""
    kinds = [(r"(?m)^ *(?:el)?if ", [":"], ("False", "True")), (r"(?<=\S) if ", [" else ", " for ", ",", "\n"], ("False", "True")),
             (r"(?<!def )\brequire\(", [","], ("True",))]
    out = []
    for pattern, ends, values in kinds:
        for m in re.finditer(pattern, text):
            end = end_on_level(text, m.end(), ends)
            if end:
                is_branch = text.startswith(" else ", end)
                out += [("branch" if is_branch else f"guard {value.lower()}", m.end(), text[m.end():end], value) for value in values]
    return out


def branches(text):
    """a ? b : c becomes a ? b : b, and a ? c : c."""
    out = []
    for m in re.finditer(r"(?<=\S)\s\?\s+", text):
        middle, nested = m.end(), 0
        while middle is not None:
            middle = end_on_level(text, middle, [" ? ", " : ", "\n"])
            if middle is None or text[middle] in ")]}\n" or text.startswith(" : ", middle) and nested == 0:
                break
            nested += 1 if text.startswith(" ? ", middle) else -1
            middle += 3
        if middle is None or not text.startswith(" : ", middle):
            continue
        end = end_on_level(text, middle + 3, [";", ",", " : ", " ? "])
        if end is None or text.startswith(" ? ", end):  # what is chosen else is a choice, too, with mutants of its own
            continue
        first, second = text[m.end():middle], text[middle + 3:end]
        if first != second:
            out += [("branch", m.end(), text[m.end():end], f"{one} : {one}") for one in (first, second)]
    return out


# Their two arguments may change places: they are sums of products, squares of differences, or the greater or smaller of two numbers.
SYMMETRIC = {"dot", "equal", "squared_distance", "squared_distances", "max_of", "min_of", "max", "min", "hypot", "lcm", "gcd"}


def swapped_arguments(text):
    out = []
    for m in re.finditer(r"(?<!\bif)(?<!\bfor)(?<!\bwhile)(?<=\w)\(", text):
        if re.search(r"\w+$", text[:m.start()])[0] in SYMMETRIC:
            continue
        end = closing(text, m.start())
        if not end:
            continue
        inside, depth, commas = text[m.end():end], 0, []
        for i, c in enumerate(inside):
            depth += (c in "([{") - (c in ")]}")
            if c == "," and depth == 0:
                commas.append(i)
        if not commas or "\n\n" in inside:
            continue
        ends = [0, *(c + 1 for c in commas), len(inside) + 1]
        arguments = [inside[a:b - 1] for a, b in zip(ends, ends[1:])]
        # Of two, the second may well be a name alone, as in a declaration.
        declared = [re.search(r"\bconst\b" if len(arguments) == 2 and i == 1 else r"\bconst\b|[\w>][&*]* \w+$", a) for i, a in enumerate(arguments)]
        is_definition = len(arguments) > 2 and re.search(r"\bdef \w+$", text[:m.start()])
        if any(declared) or is_definition:
            continue
        for i in range(len(arguments) - 1):
            first, second = arguments[i:i + 2]
            if first.strip() and second.strip() and first.strip() != second.strip():
                lead = first[:len(first) - len(first.lstrip())]
                out.append(("arguments", m.end() + ends[i] + len(lead), inside[ends[i] + len(lead):ends[i + 2] - 1], f"{second.strip()}, {first.strip()}"))
    return out


def dropped_statements(text):
    """Statements that change what is there already: x += y; v &= ...; raise(x);"""
    pattern = r"(?m)^[ ]+([\w.\[\]>()*-]+ (?:\+|-|\*|/|&|\|)= [^;\n]*;|(?!return|throw|delete)\w[\w.]*\([^;\n{}]*\);)$"
    return [("statement left out", m.start(1), m[1], ";") for m in re.finditer(pattern, text)]


def masked(text, is_python):
    """The text with comments, strings and what the preprocessor reads as blanks, each character in its place."""
    if is_python:
        pattern = r'"""(?:.|\n)*?"""|[frb]?"(?:\\.|[^"\\\n])*"|[frb]?\'(?:\\.|[^\'\\\n])*\'|#[^\n]*|(?m:^(?:from|import) [^\n]*)'
    else:
        pattern = (r'//[^\n]*|/\*(?:.|\n)*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|(?m:^\s*#(?:[^\n]*\\\n)*[^\n]*)|'
                   r'\bstatic_assert\((?:[^;])*;|(?m:^\s*(?:template|using|namespace)\b[^\n]*)|\bif constexpr \([^\n]*\)|\brequires\b[^{;]*')
    return re.sub(pattern, lambda m: re.sub(r"[^\n]", " ", m[0]), text)


def mutants_of(file, text):
    """All of the file, in the order of their places."""
    is_python = not file.endswith((".cpp", ".hpp"))
    code = masked(text, is_python)
    found = swaps("sign", OPERAND + r" ([+-]) (?=[\w(-])", code)
    found += swaps("sign", r" ([+-])= ", code)
    found += [("sign", m.start(1), "-", "") for m in re.finditer(r"(?:[(,=?:] ?|return )(-)(?=[a-zA-Z(])", code)]
    found += swaps("factor", OPERAND + r" ([*/]) (?=[\w(-])", code)
    found += swaps("comparison", r" (<=|>=|==|!=|<|>) ", code)
    found += [("comparison turned", m.start(1), m[1], {"<": ">", ">": "<", "<=": ">=", ">=": "<="}[m[1]])
              for m in re.finditer(r" (<=|>=|<|>) ", code)]
    found += swaps("logic", r" (&&|\|\||and|or) ", code)
    found += [("negation", m.start(1), m[1], "") for m in re.finditer(r"(!|\bnot )(?=[\w(])", code)]
    found += swaps("truth", r"(?<!\w)(true|false|True|False|holds|fails)\b(?!\()", code)
    found += swaps("bound", r"(?:\b|_|::)(min|max|low|high)(?=\b|_of\b)(?!:)", code) + swaps("bound", r"\w(Min|Max)\b", code)
    found += swaps("rounding", r"\b(?:float_)?(above|below|floor|ceil)\(", code)
    found += swaps("rounding", r"\b(MPFR_RND[DU])\b", code) + swaps("rounding", r"\.(inf|sup)\(\)", code)
    found += numbers(code) + dropped_terms(code) + swapped_arguments(code) + dropped_statements(code)
    found += python_guards(code) if is_python else guards(code) + branches(code)
    unique = {}  # two rules may do the same
    for rule, at, old, new in found:
        unique.setdefault((at, old, new), Mutant(file, rule, at, text[at:at + len(old)], new))
    # What a rule saw is the text without its comments and strings.
    seen = {key: m for key, m in unique.items() if m.old == key[1] or m.rule in ("arguments", "term left out") or m.new in ("true", "false", "True", "False")}
    kept = [m if m.rule != "arguments" else rebuilt_arguments(m, text) for m in seen.values()]
    return sorted((m for m in kept if m), key=lambda m: (m.at, m.old, m.new))


def rebuilt_arguments(mutant, text):
    """Strings among the arguments would have been blanked: then there is none."""
    return mutant if '"' not in mutant.old and "//" not in mutant.old else None


def identities(mutants, text):
    """What each of the mutants of a file is known by, in the order of their places: its file, its rule, the line, what becomes of it, and how
    many before it have these in common. None of this changes with what stands elsewhere."""
    before, found = collections.Counter(), []
    for mutant in mutants:
        key = (mutant.file, mutant.rule, *mutant.lines(text))
        found.append((*key, before[key]))
        before[key] += 1
    return found


def place_of(identity, seed):
    """Where a mutant with this identity stands in the order with this seed: a number that is as good as drawn, evenly from all of one size. It
    depends on nothing else, and so a mutant that comes or goes leaves the others in the order that they had."""
    return hashlib.blake2b(repr(identity).encode(), key=str(seed).encode(), digest_size=16).digest()
