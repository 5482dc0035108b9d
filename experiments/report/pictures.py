# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures: pictures that the experiments' renderer drew, with captions from what was counted when they were drawn."""
import base64
from dataclasses import dataclass, field

from .drawings import drawings
from .tables import ALL, ResultError, grouped

PLANE = ["lemma1_cap_definitions", "lemma4_quaternion_hull", "lemma5_cap_enclosing_sphere"]
IN_SPACE = {
    "figure2": "Figure 2 in space: the half-space (its border green) cuts the cap (orange) with center c and apex a.",
    "figure3": "Figure 3 in space: unit vectors q, their mean ball E (blue), the cap E ∩ S (orange) and its half-space H (border green).",
    "figure4": "Figure 4 in space: a cap (orange) and its smallest ball F (blue).",
    "figure4_printed": "Where Lemma 5 fails: the angle is beyond 90°, and the printed ball (vermillion) leaves out the apex.",
    "figure4_repaired": "Repaired: the ball of such a cap is that of the whole sphere.",
}
BARE = {"reference": "reference pose", "linear": "linear blending: candy-wrappers", "spherical_repaired": "spherical blending"}
DRESSED = {"reference": "reference pose, smallest balls", "linear": "linear blending, [Kavan and Zara 2005a]",
           "spherical_printed": "spherical blending, Algorithm 1 as printed", "spherical_repaired": "spherical blending, Algorithm 1 repaired",
           "control_many_pieces": "spherical blending, the tightest (control_many_pieces)"}
NEAR = {"spherical_printed": "as printed", "spherical_repaired": "repaired", "control_many_pieces": "the tightest, control_many_pieces"}


@dataclass
class Picture:
    """A PNG file of the table: its rows say what of, its numbers what was counted, its labels where words stand (pixels)."""
    file: str
    model: str
    pose: str
    variant: str
    level: object
    numbers: dict
    labels: list
    data: str = ""  # base64
    caption: str = ""

    def count(self, quantity):
        return round(self.numbers[quantity])


@dataclass
class Figure:
    """Pictures that belong together, under a heading. legend: (what a colour means in picture_colors.csv, the words)."""
    title: str
    text: str
    pictures: list
    columns: int = 3
    phone_columns: int = 2
    legend: list = field(default_factory=list)
    drawings: list = field(default_factory=list)


def number_of(count, one, many):
    return f"{count} {one if count == 1 else many}"


def said_of_balls(picture):
    missing, undefined = picture.count("balls_that_miss"), picture.count("balls_undefined")
    if missing == 0:
        return "none misses a vertex"
    return number_of(missing, "misses a vertex", "miss a vertex") + (f" ({number_of(undefined, 'is', 'are')} no ball at all)" if undefined else "")


def captioned(pictures, caption):
    for picture in pictures:
        picture.caption = caption(picture)
    return pictures


# --- The figures, each from the pictures that the table says are its own ---

def twist_bare(pictures, default):
    return Figure(f"{pictures[0].model}: two ways to blend (the paper's Figure 1)",
                  f"The pose is “{pictures[0].pose}”. Linear blending averages matrices: where joints turn far apart the skin collapses, "
                  "the candy-wrapper. Spherical blending averages rotations.", captioned(pictures, lambda p: BARE[p.variant]))


def twist_balls(pictures, default):
    return Figure(f"{pictures[0].model}: bounding spheres of two levels of the tree (the paper's Figure 5)",
                  "Refitted from the joints and precomputed weight bounds, without looking at a vertex.",
                  captioned(pictures, lambda p: f"level {p.level}: {DRESSED[p.variant]}; of {number_of(p.count('balls'), 'ball', 'balls')} {said_of_balls(p)}"),
                  columns=5, legend=[("holding", "a ball that holds all its vertices"), ("missing", "a ball that misses one, and the vertices outside"),
                                     ("without", "vertices whose “ball” has a negative radius or is no number")])


def failing(pictures, default):
    def caption(p):
        if p.level == ALL:
            return (f"of {p.count('balls')} balls in the tree, {p.count('balls_that_miss')} miss a vertex, {p.count('balls_undefined')} of them being no ball at all")
        end = f"; a vertex is outside by {p.numbers['worst_miss']:.2g}" if p.count("balls_that_miss") else "; it holds all its vertices"
        return f"{NEAR[p.variant]}: a ball of level {p.level}, radius {p.numbers['radius']:.3g}{end}"
    ends = ": its balls leave vertices outside." if pictures[0].count("balls_that_miss") else ": no ball misses a vertex in it."
    return Figure(f"{pictures[0].model}: where the printed algorithm fails",
                  f"The {pictures[0].pose} (of 4 angles of each joint the worst for Algorithm 1 as printed, with the skinning’s signs)" + ends, captioned(pictures, caption), columns=4,
                  legend=[("missing", "the printed ball, and vertices outside their ball"),
                          ("without", "vertices whose “ball” has a negative radius or is no number"), ("holding", "balls that hold all their vertices")])


def caps(pictures, default):
    return Figure("Caps, half-spaces and balls (the paper's Figures 2, 3 and 4)",
                  "In the plane and in space (the paper’s S₃ is one dimension further), drawn from what the code of Lemmas 1, 3, 4 and 5 computes.",
                  captioned(pictures, lambda p: IN_SPACE[p.file.removesuffix(".png")]), phone_columns=1)


def scenario(title, text):
    def make(pictures, default):
        def caption(p):
            if p.level == ALL:
                return f"{p.count('touching_pairs')} pairs of triangles touch"
            return (f"level {p.level}: Algorithm 1 repaired refitted {100 * p.numbers['share_of_nodes_refitted']:.0f} % of the spheres; "
                    f"{default} would have refitted {100 * p.numbers['share_of_nodes_refitted_by_default']:.0f} %")
        return Figure(f"{pictures[0].model}: {title}", text(pictures[0]), captioned(pictures, caption),
                      legend=[("touching", "triangles that touch"), ("holding", "spheres that the query refitted"),
                              ("idle", "spheres that it never asked for (here refitted afterwards)")])
    return make


def sampled_miss(pictures, default):
    def caption(p):
        part = "a cluster (yellow)" if p.count("shows_cluster") else "the whole character"
        return (f"{part} in “{p.pose}” after {p.numbers['clip_time']:.3g} s: {number_of(p.count('vertices_outside'), 'vertex is', 'vertices are')} outside of the box, "
                f"by {100 * p.numbers['miss_distance_over_box_side']:.2g} % of its longest side")
    return Figure(f"{pictures[0].model}: the worst miss of boxes around sampled times",
                  "The character and the cluster that get farthest out of a box around the vertices at sampled times "
                  f"({' and '.join(dict.fromkeys(p.variant for p in pictures))}), at that time.", captioned(pictures, caption), columns=2, phone_columns=1,
                  legend=[("missing", "the box around the sampled times, and vertices outside of it"), ("holding", "the bound over time")])


def engine_boxes(pictures, default):
    def caption(p):
        return (f"“{p.pose}” after {p.numbers['clip_time']:.3g} s; the volumes are {p.numbers['volume_of_rounded_boxes']:.2f} (ours), "
                f"{p.numbers['volume_of_joint_boxes']:.2f} (joint boxes) and {p.numbers['volume_of_padded_pivots']:.2f} (padded pivots) times that of the true box; "
                f"{number_of(p.count('vertices_outside'), 'vertex is', 'vertices are')} outside of the last one")
    return Figure(f"{pictures[0].model}: boxes of one pose", "The true box (gray), and those by which engines and we bound the character in one pose.",
                  captioned(pictures, caption), columns=1, phone_columns=1,
                  legend=[("holding", "our box, of rounded boxes of the joints"), ("without", "the box around joint boxes"),
                          ("missing", "the box around padded pivots, and vertices outside of it")])


FIGURES = {
    "engine_boxes": engine_boxes, "sampled_miss": sampled_miss,
    "twist_bare": twist_bare, "twist_balls": twist_balls, "failing": failing, "caps": caps,
    "walking": scenario("two pass each other (the paper's Figure 6)", lambda p:
                         "A query refits a sphere only when it gets there; the deeper, the fewer of a level. (In the paper’s frame it refitted 19 % of "
                         f"level 5 and 9 % of level 6, of a tree of nine levels; this one has {p.count('tree_levels')}.)"),
    "walk_through": scenario("two in one place (the paper's Figure 7)", lambda p:
                              "The worst case, as when they walk through each other: far more triangles touch than in practice."),
}


ELSEWHERE = {"engine_boxes", "sampled_miss"}  # figures of other sections


def pictures_of(results, folder):
    """Returns [(figure's name, its pictures)], in the order of the table. Raises ResultError for a file that is not there."""
    labels, found = grouped(results.rows("picture_labels"), lambda row: row.file), {}
    for row in results.rows("pictures"):
        of_figure = found.setdefault(row.figure, {})
        picture = of_figure.setdefault(row.file, Picture(row.file, row.model, row.pose, row.variant, row.level, {}, labels.get(row.file, [])))
        picture.numbers[row.quantity] = row.value
    for picture in (p for of_figure in found.values() for p in of_figure.values()):
        try:
            picture.data = base64.b64encode((folder / picture.file).read_bytes()).decode()
        except OSError as error:
            raise ResultError(f"{folder / picture.file}: cannot be read ({error}), but {results.path('pictures')} names it") from None
    return [(name, list(of_figure.values())) for name, of_figure in found.items()]


def figures_of(results, page, names):
    """Returns those of the figures with these names that exist."""
    plane = drawings(results.rows("drawings")) if "caps" in names else {}
    figures = []
    for name, pictures in pictures_of(results, page.folder / "pictures"):
        if name in names:
            figures.append(FIGURES[name](pictures, results.default_variant()))
            if name == "caps":
                figures[-1].drawings = [plane[stem] for stem in PLANE]
    return figures


def colors_of(results):
    return {row.meaning: row.color for row in results.rows("picture_colors")}


def section(results, page):
    return {"figures": figures_of(results, page, set(FIGURES) - ELSEWHERE), "colors": colors_of(results)}
