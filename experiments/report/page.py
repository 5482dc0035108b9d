# SPDX-License-Identifier: GPL-3.0-or-later
"""The page: its sections in order, put together by templates; one HTML file with nothing outside but its reference."""
import pathlib
import re
import sys
from dataclasses import dataclass

import jinja2
from markupsafe import Markup

from . import collisions, crowds, deformations, drawings, engines, explorer, growth, over_time, pictures, rounding, speed, synthetic, tightness, verdicts, volumes
from .tables import PROVENANCE, ResultError

FOLDER = pathlib.Path(__file__).resolve().parent
# A section has a heading, a template, what makes its context, and the tables without which there is no such section.
SECTIONS = [
    ("Pictures", "pictures", pictures.section, ["pictures"]),
    ("Explorer", "explorer", explorer.section, []),
    ("Queries at a glance", "headline", collisions.headline_section, ["collisions"]),
    ("Verdicts on the lemmas", "verdicts", verdicts.section, []),
    ("Tightness", "tightness", tightness.section, ["tightness"]),
    ("Speed", "speed", speed.section, ["speed"]),
    ("Tightness against cost", "pareto", speed.pareto_section, ["speed", "tightness"]),
    ("In batches", "batches", speed.batch_section, ["batch_speed"]),
    ("Rounding", "rounding", rounding.section, ["rounding"]),
    ("Boxes, k-DOPs and oriented boxes", "volumes", volumes.section, ["volumes"]),
    ("Bounds over time", "over_time", over_time.section, ["over_time"]),
    ("What engines ship", "engines", engines.section, ["engines"]),
    ("Scaled joints, morph targets, reduced deformations", "deformations", deformations.section, ["deformations"]),
    ("Collision queries", "collisions", collisions.section, ["collisions"]),
    ("Growth with triangles", "triangles", growth.triangles_section, ["triangle_growth"]),
    ("Growth with joints", "joints", growth.joints_section, ["joint_growth"]),
    ("Many characters in one scene", "crowds", crowds.crowds_section, ["crowds"]),
    ("Synthetic cases", "synthetic", synthetic.section, ["synthetic"]),
]

EFFORTS = {"quick": "a smoke run", "default": "a first look"}
# This says what experiments/options.cpp's full run adds to the default one.
FULL = ("experiments/run --full looks at all clips and detectors, with more samples, larger models and pictures, and longer timings; README.md says "
        "how long it takes. The paper's numbers are of such a run.")


def said_of_effort(results):
    """Returns what a longer run would add, which is nothing for a full run."""
    effort = results.rows("run")[0].effort
    return f"This is {EFFORTS[effort]}, with few poses and short timings. {FULL}" if effort in EFFORTS else ""


@dataclass
class Page:
    """A Page has the place of the page, the explorer's HTML that goes into it (or None), and its run."""
    folder: pathlib.Path
    explorer: pathlib.Path
    provenance: dict

    @property
    def commit(self):
        return self.provenance["commit"]


def environment(templates=FOLDER / "templates"):
    env = jinja2.Environment(loader=jinja2.FileSystemLoader(templates), autoescape=True, undefined=jinja2.StrictUndefined,
                             trim_blocks=True, lstrip_blocks=True)
    env.filters["number"] = lambda value, pattern: "" if value is None else pattern % value
    env.filters["id"] = lambda title: "part" + re.sub(r"[^a-z0-9]+", "-", f" {title}".lower())
    return env


def built(results, folder, explorer_page=None):
    """The page as HTML, and what is wrong with its tables: a section whose table cannot be used says so in its place, since
    a page without a section is better than none after a long run."""
    run = results.rows("run")[0]
    page = Page(pathlib.Path(folder), explorer_page, {column: getattr(run, column) for column in PROVENANCE})
    env, errors, sections = environment(), [], []
    for title, template, make, tables in SECTIONS:
        if not all(results.was_run(table) for table in tables):
            continue
        try:
            context = make(results, page)
            if context is not None:
                sections.append((title, Markup(env.get_template(f"{template}.html.j2").render(context))))
        except ResultError as error:
            errors.append(str(error))
            sections.append((title, Markup(env.get_template("error.html.j2").render(error=error))))
    html = env.get_template("page.html.j2").render(
        sections=sections, provenance=page.provenance, effort=said_of_effort(results), absent=[row.model for row in results.rows("models") if row.found == "no"],
        style=Markup((FOLDER / "page.css").read_text() + drawings.STYLE.read_text()),
        has_reference=(page.folder / "reference/index.html").exists())
    return html, errors


def write(results, folder, explorer_page=None):
    """Writes FOLDER/index.html whole or not at all; returns the errors, which it says on stderr too."""
    html, errors = built(results, folder, explorer_page)
    path = pathlib.Path(folder) / "index.html"
    temporary = path.with_suffix(".html.tmp")
    temporary.write_text(html, encoding="utf-8")
    temporary.replace(path)
    for error in errors:
        print(f"report: {error}", file=sys.stderr)
    return errors
