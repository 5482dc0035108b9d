# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference reads lemma files in their fixed order, tests, and code and comments as HTML."""
import dataclasses
import html
import re

from markupsafe import Markup

GREEK = {"alpha": "α", "delta": "δ", "kappa": "κ", "pi": "π", "lambda": "λ", "epsilon": "ε", "eps": "ε"}


def inline(text):
    """Returns a line of a comment with its ASCII formulas in Unicode, with sub- and superscripts."""
    text = html.escape(text, quote=False)
    text = text.replace("||", "‖").replace("&gt;=", "≥").replace("&lt;=", "≤").replace("!=", "≠").replace("-&gt;", "→")
    text = re.sub(r"\bsum(?=_| [a-z]_| \(| ‖)", "Σ", text)
    text = re.sub(r"\b(" + "|".join(GREEK) + r")\b", lambda m: GREEK[m[1]], text)
    text = re.sub(r"((?<![A-Za-z0-9_])[A-Za-zΣα-ω]'{0,2})_(?:\{([^}]*)\}|([A-Za-z0-9]{1,3}(?![A-Za-z0-9_])))", lambda m: f"{m[1]}<sub>{m[2] or m[3]}</sub>", text)
    text = re.sub(r"\^(-?[0-9]+|[A-Za-z](?![A-Za-z]))", r"<sup>\1</sup>", text)
    return Markup(text)


def paragraphs(lines, stems):
    """Turns comment lines into paragraphs. Indented lines stay formulas, and a stem becomes a link to its page."""
    out, block = [], []

    def flush():
        if block:
            out.append("<p>" + " ".join(inline(x) for x in block) + "</p>")
            block.clear()
    for line in lines:
        line = re.sub(r"^(Statement|Proof)\. ", "", line)
        if re.match(r"(Paper|Notation|Replaces|Sources|Used by): ", line):
            flush()
        if not line.strip():
            flush()
        elif line.startswith("   ") or line.startswith("\t"):
            flush()
            out.append(f'<p class="formula">{inline(line.strip())}</p>')
        elif re.match(r"(\(\d\)|\([iv]+\)|[a-z]\)|- )", line.strip()):
            flush()
            block.append(line.strip())
        else:
            block.append(line.strip())
    flush()
    text = "\n".join(out)
    for stem in stems:
        text = re.sub(rf"\b{stem}\b", f'<a href="{stem}.html">{stem}</a>', text)
    return Markup(text)


TOKENS = re.compile(r'(?P<comment>//[^\n]*)|(?P<string>"(?:\\.|[^"\\])*")|(?P<directive>^#\w+)|'
                    r"(?P<keyword>\b(?:template|class|struct|return|if|else|for|while|const|constexpr|auto|int|bool|double|void|static|inline|using|"
                    r"namespace|typename|switch|case|default|true|false|break|continue)\b)|(?P<number>\b\d[\d.e+]*\b)|(?P<type>\b[A-Z]\w*\b)", re.M)


def code(text):
    text = text.strip("\n")
    out, last = "", 0
    for m in TOKENS.finditer(text):
        out += html.escape(text[last:m.start()], quote=False) + f'<span class="{m.lastgroup}">{html.escape(m[0], quote=False)}</span>'
        last = m.end()
    return Markup(f"<pre><code>{out}{html.escape(text[last:], quote=False)}</code></pre>\n")


@dataclasses.dataclass
class Lemma:
    title: str
    statement: list  # the lines of the comment, without the proof
    proof: list
    sections: list   # pairs (heading, code), in the file's order
    sources: list


def read_lemma(path):
    lines = path.read_text().split("\n")[1:]  # The line of the licence is left out.
    end = lines.index("#pragma once")
    comment = [l[3:] for l in lines[:end]]
    blank = next(i for i, l in enumerate(comment) if not l.strip())
    title = " ".join(comment[:blank]).rstrip(".").removeprefix("Beyond the paper: ").strip()
    at = next((i for i, l in enumerate(comment) if l.startswith("Proof")), len(comment))
    last = next(i for i, l in enumerate(lines) if l.startswith("}  // namespace refitlab"))
    first = lines.index("namespace refitlab {")
    sections, heading, block = [], "Definitions", []
    for line in lines[first + 1:last]:
        m = re.fullmatch(r"// --- (.*?) ---", line)
        if m:
            if any(l.strip() for l in block):
                sections.append((heading, "\n".join(block)))
            heading, block = m[1], []
        else:
            block.append(line)
    sections.append((heading, "\n".join(block)))
    sources = [l[3:] for l in lines[last + 1:] if l.startswith("//")]
    return Lemma(title[0].upper() + title[1:], comment[blank:at], comment[at:], sections, sources)


@dataclasses.dataclass
class Property:
    kind: str
    sentence: str
    form: str
    number_type: str
    hypothesis: str
    body: str


def read_properties(path):
    """Returns the t.holds, t.refuted and t.example of a suite, in order."""
    text = path.read_text()
    # Options may be given by name; here each name is mapped to its options.
    named = dict(re.findall(r"const Options (\w+)(\{[^}]*\});", text))
    # A helper is a lambda that runs an example; it is given a sentence, and perhaps a hypothesis.
    helpers = {}
    for m in re.finditer(r"const auto (\w+) = \[&t\]\(", text):
        end = text.index("\n  };", m.end()) + 5
        if "t.example(sentence" in text[m.start():end]:
            helpers[m[1]] = dedented(text, m.start(), end)
    names = "|".join([r"t\.holds", r"t\.refuted", r"t\.example", *helpers])
    out = []
    for m in re.finditer(rf"(?<![\w.])({names})\(", text):
        whole = dedented(text, m.start(), closing(text, m.end() - 1) + 2)
        given = literals(text[m.end():])
        if not given:
            continue  # within a helper
        options = helpers.get(m[1], whole)
        for name, value in named.items():
            options = re.sub(rf",\s*{name},", lambda _, value=value: f", {value},", options)

        def field(name):
            found = re.search(rf'\.{name} = ((?:"(?:\\.|[^"\\])*"\s*)+)', options)
            return literals(found[1])[0] if found else ""
        if m[1] in helpers:
            two = len(given) > 1
            out.append(Property("example", given[1 if two else 0], field("form"), "", given[0] if two else "", f"{whole}\n\n{helpers[m[1]]}"))
        else:
            out.append(Property(m[1].removeprefix("t."), given[0], field("form"), field("number_type"), field("hypothesis"), whole))
    return out


def literals(text):
    """Returns the string literals, separated by commas, at the start of a text."""
    out = []
    while m := re.match(r'\s*,?((?:\s*"(?:\\.|[^"\\])*")+)', text):
        out.append("".join(re.findall(r'"((?:\\.|[^"\\])*)"', m[1])).replace('\\"', '"'))
        text = text[m.end():]
    return out


def dedented(text, start, end):
    """Returns the text from start to end, each line without the indentation of the first."""
    column = start - text.rfind("\n", 0, start) - 1
    return "\n".join(l[column:] if not l[:column].strip() else l for l in text[start:end].split("\n"))


def closing(text, at):
    """Returns the position of the bracket that closes the one at this position. Brackets in strings and comments do not count."""
    depth = 0
    for m in re.compile(r'"(?:\\.|[^"\\])*"|//[^\n]*|[()]').finditer(text, at):
        depth += {"(": 1, ")": -1}.get(m[0], 0)
        if depth == 0:
            return m.start()
    raise ValueError("brackets do not match")
