# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots by matplotlib, as SVG that stands in the page: text stays text, and colours follow the page's light or dark scheme.

Points have the numbers they stand for as titles. The legend of a line plot is HTML below it, so that it wraps on a phone.
"""
import io
import re
import xml.etree.ElementTree as ET
from dataclasses import dataclass, field

import matplotlib
from markupsafe import Markup, escape
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter

# The colour-blind can tell these colours apart [Okabe and Ito 2008]; black and yellow are left out, since they vanish on a dark
# or a light page.
COLORS = ["#D55E00", "#0072B2", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#8a8a8a", "#7f5fbf"]
MARKERS = ["o", "s", "^", "D"]  # of the first eight lines, the second eight, and so on
SYMBOLS = ["<circle cx='14' cy='6' r='3.4'/>", "<rect x='11' y='3' width='6' height='6'/>", "<path d='M14 2l4 7h-8z'/>",
           "<path d='M14 2l4 4-4 4-4-4z'/>"]
INK, RULE = "#010203", "#d0d1d2"  # stand for colours of the page's style sheet
STYLE = {"svg.fonttype": "none", "svg.hashsalt": "refitlab", "font.size": 11, "figure.facecolor": "none", "axes.facecolor": "none", "axes.edgecolor": INK, "axes.labelcolor": INK, "text.color": INK,
         "xtick.color": INK, "ytick.color": INK, "axes.titlesize": 12, "axes.titleweight": "semibold", "axes.titlelocation": "left",
         "axes.grid": True, "grid.color": RULE, "grid.linewidth": 0.8, "axes.spines.top": False, "axes.spines.right": False, "axes.axisbelow": True}
SVG = "{http://www.w3.org/2000/svg}"
made = 0  # plots so far: each gets ids of its own in the page


@dataclass
class Line:
    label: str
    points: list          # (x, y)
    dashed: bool = False
    color: str = ""       # "ink", or that of its place among the lines


@dataclass
class Plot:
    """A Plot is a line chart. A line without points is left out."""
    title: str
    x_label: str
    y_label: str
    lines: list
    log_x: bool = False
    log_y: bool = False
    front: list = field(default_factory=list)  # points joined by steps: what nothing else beats

    def svg(self):
        lines = [line for line in self.lines if line.points]
        styles = [(INK if line.color == "ink" else COLORS[i % len(COLORS)], i // len(COLORS) % len(MARKERS)) for i, line in enumerate(lines)]
        with matplotlib.rc_context(STYLE):
            figure = Figure(figsize=(6, 3.6), layout="constrained")
            axes = figure.add_subplot(title=self.title, xlabel=self.x_label, ylabel=self.y_label)
            if self.front:
                axes.step(*zip(*sorted(self.front)), where="post", color=INK, linewidth=0.9, linestyle=":")
            for line, (color, marker) in zip(lines, styles):
                axes.plot(*zip(*line.points), color=color, marker=MARKERS[marker], markersize=4.5 if len(line.points) > 1 else 7,
                          linestyle="--" if line.dashed else "-", gid=f"line{lines.index(line)}")
            format_axis(axes, "x", self.log_x)
            format_axis(axes, "y", self.log_y)
            svg = page_svg(figure, self.title, "plot", 0.8, {f"line{i}": line for i, line in enumerate(lines)})
        keys = "".join(f"<li>{symbol(color, marker, line.dashed)}{escape(line.label)}</li>" for line, (color, marker) in zip(lines, styles))
        front = f"<li>{symbol(INK, None, True)}best at its price</li>" if self.front else ""
        return Markup(f'<div class="scroll">{svg}</div><ul class="legend of-plot">{keys}{front}</ul>')


@dataclass
class BarRow:
    label: str
    color: int    # index into COLORS
    values: list  # by panel; a bar is left out where there is none


@dataclass
class BarPanels:
    """Horizontal bars on a log axis, a row a name, a panel beside the other for each case."""
    title: str
    panels: list
    rows: list

    def svg(self):
        shown = [v for row in self.rows for v in row.values if v]
        if not shown:
            return ""
        with matplotlib.rc_context({**STYLE, "font.size": 10, "axes.grid.axis": "x", "axes.titlesize": 10, "axes.titleweight": "normal"}):
            figure = Figure(figsize=(2.1 + 1.75 * len(self.panels), 1.1 + 0.21 * len(self.rows)), layout="constrained")
            figure.suptitle(self.title, x=0.01, ha="left", fontsize=11, fontweight="semibold")
            all_axes = figure.subplots(1, len(self.panels), sharey=True, squeeze=False)[0]
            for panel, axes in enumerate(all_axes):
                self._draw(axes, panel, min(shown), max(shown))
            return Markup(f'<div class="scroll">{page_svg(figure, self.title, "bars", 1, {})}</div>')

    def _draw(self, axes, panel, least, most):
        axes.set_title(self.panels[panel])
        axes.set_xscale("log")
        axes.set_xlim(least / 2, most * 14)  # room for the last number
        for place, row in enumerate(self.rows):
            if row.values[panel]:
                axes.barh(place, row.values[panel], height=0.68, color=COLORS[row.color])
                axes.text(row.values[panel] * 1.15, place, f" {rounded(row.values[panel])}", va="center", fontsize=8.5)
        axes.set_yticks(range(len(self.rows)), [row.label for row in self.rows])
        axes.set_ylim(len(self.rows) - 0.4, -0.6)
        axes.tick_params(axis="y", length=0)
        axes.tick_params(axis="x", labelsize=8)
        axes.xaxis.set_major_locator(LogLocator(numticks=6))
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: short(value)))
        axes.xaxis.set_minor_locator(LogLocator(subs=[]))


def rounded(value):
    return f"{value:.3g}" if value < 100 else f"{value:.0f}"


def short(value):
    """Returns a number such as 10, 1k, 100k or 1M."""
    return f"{value / 1e6:g}M" if value >= 1e6 else f"{value / 1e3:g}k" if value >= 1e3 else f"{value:g}"


def symbol(color, marker, dashed):
    """Returns a line with its marker, for a legend, or the line alone if marker is None."""
    dash = ' stroke-dasharray="4 3"' if dashed else ""
    return (f'<svg class="key" viewBox="0 0 28 12" aria-hidden="true" fill="{of_page(color)}"><path stroke="{of_page(color)}" stroke-width="2"{dash} d="M0 6h28"/>'
            + ("" if marker is None else SYMBOLS[marker]) + "</svg>")


def of_page(color):
    return {INK: "var(--ink)", RULE: "var(--rule)"}.get(color, color)


def format_axis(axes, which, is_log):
    axis = axes.xaxis if which == "x" else axes.yaxis
    if not is_log:
        axis.set_major_locator(MaxNLocator(nbins=8, steps=[1, 2, 5, 10], integer=axes.get_xlabel().startswith("level") and which == "x"))
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.6g}"))
        return
    axes.set_xscale("log") if which == "x" else axes.set_yscale("log")
    low, high = axes.get_xlim() if which == "x" else axes.get_ylim()
    axis.set_major_locator(LogLocator(subs=[1] if high > 100 * low else [1, 2, 5], numticks=12))
    axis.set_major_formatter(FuncFormatter(lambda value, _: short(value)))
    axis.set_minor_formatter(NullFormatter())


def page_svg(figure, title, kind, least, lines):
    """The figure as an SVG element for the page, at the least so many pixels a point. lines: {gid: Line}, whose markers get titles."""
    global made
    made += 1
    text = io.StringIO()
    FigureCanvasSVG(figure).print_svg(text, metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    root = ET.fromstring(text.getvalue())
    for gid, line in lines.items():
        markers = [use for use in root.find(f".//{SVG}g[@id='{gid}']").iter(f"{SVG}use")]
        for use, (x, y) in zip(markers, line.points, strict=True):
            ET.SubElement(use, f"{SVG}title").text = f"{line.label}: {x:.4g}, {y:.4g}"
    metadata = root.find(f"{SVG}metadata")
    if metadata is not None:
        root.remove(metadata)
    used = set(re.findall(r"(?:url\(#|href=\"#)([\w-]+)", text.getvalue()))
    for element in root.iter():
        tidy(element, used)
    width = float(root.get("viewBox").split()[2])
    for attribute in ("width", "height", "version"):
        root.attrib.pop(attribute, None)
    root.set("class", kind)
    root.set("style", f"min-width:{least * width:.0f}px;max-width:{1.6 * width:.0f}px")
    root.set("role", "img")
    root.set("aria-label", title)
    ET.register_namespace("", SVG[1:-1])
    return ET.tostring(root, encoding="unicode")


def tidy(element, used):
    """Ids are unique in the page and only there where something refers to them; the page's colours and font hold."""
    name = element.get("id")
    if name in used:
        element.set("id", f"plot{made}-{name}")
    elif name is not None:
        del element.attrib["id"]
    for attribute, value in list(element.attrib.items()):
        value = re.sub(r"url\(#", f"url(#plot{made}-", value)
        value = re.sub(r"font: ((?:\S+ )?[\d.]+px) [^;]*", r"font: \1 system-ui, sans-serif", value)
        for color in (INK, RULE):
            value = value.replace(color, of_page(color))
        if attribute.endswith("}href"):
            del element.attrib[attribute]
            attribute, value = "href", f"#plot{made}-{value[1:]}"
        element.set(attribute, value)
