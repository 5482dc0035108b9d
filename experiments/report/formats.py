# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers as TeX."""
import re
from fractions import Fraction


def fraction(x):
    sign = "-" if x < 0 else ""
    return f"{sign}{abs(x)}" if x.denominator == 1 else f"{sign}\\tfrac{{{abs(x.numerator)}}}{{{x.denominator}}}"


def exact(x):
    """A Fraction or a list of them, for math mode."""
    return fraction(x) if isinstance(x, (Fraction, int)) else "(" + ",\\, ".join(fraction(c) for c in x) + ")"


def digits(x, count=3):
    """With so many significant digits, never in powers of ten; thousands are set apart."""
    if x == 0:
        return "0"
    text = f"{x:.{count}g}"
    if "e" in text:
        text = f"{float(text):.0f}" if abs(x) >= 1 else f"{float(text):.10f}".rstrip("0")
    if "." not in text and abs(float(text)) < 10 ** (count - 1):  # the zeros that %g leaves out
        text = f"{x:.{max(0, count - len(text.lstrip('-')))}f}"
    elif "." in text:
        whole, part = text.lstrip("-").split(".")
        shown = len((whole + part).lstrip("0"))
        text += "0" * (count - shown)
    return whole_number(float(text)) if "." not in text else text


def power_of_ten(x):
    """One digit and a power of ten, for text: 7e-14 is 7 times 10 to the -14."""
    mantissa, exponent = f"{x:.0e}".split("e")
    return f"${mantissa}\\cdot10^{{{int(exponent)}}}$"


def whole_number(x):
    return re.sub(r"(?<=\d)(?=(\d{3})+$)", "{,}", f"{x:.0f}") if abs(x) >= 10000 else f"{x:.0f}"


def escaped(text):
    return re.sub(r"([_&%#$])", r"\\\1", text)


def table(columns, head, rows):
    """A booktabs table. columns: as in tabular; head, rows: lists of cells in TeX; a row None is a rule."""
    lines = [f"\\begin{{tabular}}{{{columns}}}", "\\toprule", " & ".join(head) + r" \\", "\\midrule"]
    lines += ["\\addlinespace" if row is None else " & ".join(row) + r" \\" for row in rows]
    return "\n".join([*lines, "\\bottomrule", "\\end{tabular}", ""])


def broken_name(name):
    """A name of code that may be broken after each of its words."""
    broken = re.sub(r"(\\_|/)", r"\1\\allowbreak{}", escaped(name))
    return f"\\texttt{{{broken}}}"


def long_table(widths, head, rows):
    """A booktabs table that goes on over pages, without a caption. widths: of its columns, in millimetres."""
    columns = "".join(f">{{\\raggedright\\arraybackslash}}p{{{width}mm}}" for width in widths)
    lines = [f"\\begin{{longtable}}{{{columns}}}", "\\toprule", " & ".join(head) + r" \\", "\\midrule", "\\endhead", "\\bottomrule", "\\endfoot"]
    return "\n".join([*lines, *(" & ".join(row) + r" \\" for row in rows), "\\end{longtable}", ""])
