# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings in the plane of what the lemmas' own code computes: from a table of shapes to SVG, for the page and the reference."""
import pathlib

from markupsafe import Markup, escape

from .tables import grouped

STYLE = pathlib.Path(__file__).with_name("drawings.css")
SCALE = 120   # pixels a unit
MARGIN = 20   # pixels
DOT = 4       # radius in pixels
ROOM = {"dot": 0.12, "text": 0.1}  # units around a point, so that its mark stays in the picture


class Drawing:
    """A Drawing has rows of drawings.csv, in which y points up."""

    def __init__(self, rows):
        self.caption = next(row.label for row in rows if row.shape == "caption")
        self.rows = [row for row in rows if row.shape != "caption"]

    def svg(self):
        shapes = "".join(getattr(self, row.shape)(row, points(row)) + "\n" for row in self.rows if row.shape != "text")
        words = "".join(self.words(row, points(row)[0]) for row in self.rows if row.label)
        return Markup(f'<svg xmlns="http://www.w3.org/2000/svg" class="drawing" role="img" aria-label="{escape(self.caption)}" '
                      f'viewBox="{self.view_box()}">\n{shapes}{words}</svg>\n')

    def circle(self, row, at):
        return f'<circle class="{row.kind}" cx="{pixels(at[0][0])}" cy="{pixels(-at[0][1])}" r="{pixels(row.radius)}"/>'

    def dot(self, row, at):
        return f'<circle class="{row.kind}" cx="{pixels(at[0][0])}" cy="{pixels(-at[0][1])}" r="{DOT}"/>'

    def path(self, row, at):
        steps = "L".join(f"{pixels(x)} {pixels(-y)}" for x, y in at)
        return f'<path class="{row.kind}" d="M{steps}{"Z" if row.closed == "yes" else ""}"{"" if row.closed == "yes" else " fill=" + chr(34) + "none" + chr(34)}/>'

    def words(self, row, at):
        shift = 7 if row.shape == "dot" else 0
        return f'<text x="{SCALE * at[0] + shift:.6g}" y="{-SCALE * at[1] - shift:.6g}">{escape(row.label)}</text>\n'

    def view_box(self):
        reached = [(x, y, row.radius + ROOM.get(row.shape, 0)) for row in self.rows for x, y in points(row)]
        left, right = min(x - r for x, _, r in reached), max(x + r for x, _, r in reached)
        low, high = min(y - r for _, y, r in reached), max(y + r for _, y, r in reached)
        return (f"{SCALE * left - MARGIN:.6g} {-SCALE * high - MARGIN:.6g} "
                f"{SCALE * (right - left) + 3 * MARGIN:.6g} {SCALE * (high - low) + 2 * MARGIN:.6g}")


def pixels(length):
    return f"{SCALE * length:.6g}"


def points(row):
    """Returns [(x, y)] of "x y x y ..."."""
    numbers = [float(n) for n in row.points.split()]
    return list(zip(numbers[::2], numbers[1::2], strict=True))


def drawings(rows):
    """Returns {name: Drawing}, in the order of the table."""
    return {name: Drawing(some) for name, some in grouped(rows, lambda row: row.drawing).items()}
