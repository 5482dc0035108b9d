# SPDX-License-Identifier: GPL-3.0-or-later
"""Collision queries between two characters: at a glance, in full, and beside the original's Table 2."""
from . import original
from .plots import BarPanels, BarRow
from .tables import ALL

QUERIES = {"full": "Full: all pairs", "yes/no": "Yes/no: until the first pair"}
ORIGINS = {"own": "on demand", "baseline": "skins everything", "engine": "engine", "bounded": "behind a box test", "floor": "told where to look", "oracle": "oracle"}
COLORS = {"own": 1, "baseline": 2, "engine": 0, "bounded": 3, "floor": 4, "oracle": 6}  # in the order of the plots' colours
STAGES = ["pose", "skinning", "refit", "query"]
COUNTS = ["vertices_skinned", "nodes_refitted", "volume_tests", "triangle_tests"]
TABLE_2 = {"lbs": "linear", "sbs": "spherical_repaired", "bottom_up": "brown"}


def fastest_engine(results, model, scene):
    """Returns the us of a full query by the fastest engine of those that found all pairs, or None if there is none."""
    where = dict(model=model, scene=scene, query="full", level=ALL, origin="engine")
    exact = {row.variant for row in results.find("collisions", quantity="differing_pairs", **where) if row.value == 0}
    return min((row.value for row in results.find("collisions", quantity="us_per_frame", **where) if row.variant in exact), default=None)


class Model:
    """A Model has the rows of one model."""

    def __init__(self, results, model):
        self.results, self.model = results, model
        self.scenes = results.distinct("collisions", "scene", model=model)
        self.detectors = results.distinct("collisions", "variant", model=model)
        self._found = {(r.scene, r.query, r.variant, r.level, r.quantity): r for r in results.find("collisions", model=model)}

    def row(self, scene, query, detector, quantity="us_per_frame", level=ALL):
        return self._found.get((scene, query, detector, level, quantity))

    def value(self, *where, **more):
        row = self.row(*where, **more)
        return row.value if row else None

    def heads(self):
        """Returns heads such as "light, 50 pairs", by scene: the mean number of pairs over the frames."""
        pairs = [self.value(scene, "full", "brute_force", quantity="pairs") for scene in self.scenes]
        return [scene if n is None else f"{scene}, {n:.0f} pairs" for scene, n in zip(self.scenes, pairs)]

    def origin(self, query, detector):
        """Returns None if the detector was not asked, and "" if it is not to be compared, as linear blending, which is there
        for Table 2."""
        rows = [self.row(scene, query, detector) for scene in self.scenes]
        last = next((row for row in reversed(rows) if row), None)
        if last is None:
            return None
        comparable = last.origin == "oracle" or self.value(last.scene, query, detector, quantity="time_ratio_to_skin_all") is not None
        return last.origin if comparable else ""

    def bars(self, query):
        rows = [BarRow(d, COLORS[self.origin(query, d)], [self.value(scene, query, d) for scene in self.scenes])
                for d in self.detectors if self.origin(query, d) not in (None, "", "oracle")]
        return BarPanels(f"{self.model}, {query}: us a frame", self.heads(), rows).svg()

    def times(self, query):
        """Returns a row for each detector: name, origin, and by scene us, times the fastest engine's, times that of the fastest baseline skinned in float."""
        return [(d, ORIGINS[self.origin(query, d)],
                 [{q: self.value(scene, query, d, quantity=q) for q in ("us_per_frame", "time_ratio_to_engine", "time_ratio_to_skin_all")}
                  for scene in self.scenes]) for d in self.detectors if self.origin(query, d)]

    def work(self):
        """Returns a row for each scene, query and detector except the oracle, in the order of the file."""
        asked = [key[:3] for key, row in self._found.items() if key[3:] == (ALL, "us_per_frame") and row.origin != "oracle"]
        return [{"scene": scene, "query": query, "detector": detector,
                 "stages": [self.value(scene, query, detector, quantity=f"{stage}_us") for stage in STAGES],
                 "counts": [self.value(scene, query, detector, quantity=count) for count in COUNTS]} for scene, query, detector in asked]

    def shares(self, scene, detector="spherical_repaired"):
        """Returns the share of each level's spheres that a full query refitted."""
        found = {key[3]: row.value for key, row in self._found.items() if key[:3] == (scene, "full", detector) and key[4] == "share_of_nodes_refitted"}
        return [found[level] for level in sorted(found)]

    def fastest_engine(self, scene):
        return fastest_engine(self.results, self.model, scene)


def headline_section(results, page):
    """Shows the first model's times scene by scene: ours, the paper's query and what one would take instead."""
    model = Model(results, results.rows("collisions")[0].model)

    def times(detector):
        return [model.value(scene, "full", detector) for scene in model.scenes]
    ours = times("clusters")
    rows = [("skin everything in float", times("skin_all_float")),
            ("the same with clusters of 384 triangles", times("skin_all_float_384")),
            ("the same with clusters of 512 triangles", times("skin_all_float_512")),
            ("the same behind a test of whole-character boxes", times("skin_all_float_bounded")),
            ("the fastest engine of each scene", [model.fastest_engine(scene) for scene in model.scenes]),
            ("the paper’s query, spheres by " + results.default_variant(), times(results.default_variant())),
            ("the paper’s query, Algorithm 1 repaired", times("spherical_repaired")),
            ("a floor: told which clusters’ boxes meet", times("floor_of_boxes")),
            ("a floor: told which clusters touch", times("floor_of_contacts"))]
    return {"model": model, "ours": ours, "rows": [row for row in rows if any(t is not None for t in row[1])]}


def differences(results):
    """Returns, for each detector that may leave out a pair, its row of detectors.csv, how many pairs a frame differ, and of how
    many."""
    out = []
    for detector in results.rows("detectors"):
        if detector.tolerated_share_of_pairs > 0 and detector.found == "yes":
            def of(quantity):
                return sum(r.value for r in results.find("collisions", variant=detector.detector, query="full", quantity=quantity))
            if list(results.find("collisions", variant=detector.detector, query="full", quantity="pairs")):  # it was measured
                out.append((detector, of("differing_pairs"), of("pairs")))
    return out


def table_2(results):
    """Returns (scenario, [(our ms or None, the original's ms)]) for each scenario that was measured."""
    rows = []
    for row in original.table2():
        def us(detector):
            return results.number_or_none("collisions", model=row.model, scene=row.scene, query=row.query, variant=detector, quantity="us_per_frame")
        if us("brown") is not None:
            rows.append((row.scenario, [(us(detector), getattr(row, column)) for column, detector in TABLE_2.items()]))
    return rows


def sphere_costs(results):
    """Returns, by model, the ns of a sphere by linear and by spherical blending, and the ratio in the same repetitions."""
    if not results.was_run("speed"):
        return []
    rows = []
    for r in results.find("speed", variant="linear", quantity="ns_per_sphere", level=ALL):
        ns = results.number("speed", model=r.model, variant="spherical_repaired", quantity="ns_per_sphere", level=ALL)
        ratio = results.number("speed", model=r.model, variant="linear", quantity="time_ratio_to_repaired", level=ALL)
        rows.append((r.model, r.value, ns, 1 / ratio))
    return rows


def section(results, page):
    models = [Model(results, model) for model in results.distinct("collisions", "model")]
    there = set(results.distinct("collisions", "variant"))
    detectors = results.rows("detectors")
    shares = [(m.model, scene, m.shares(scene)) for m in models for scene in m.scenes]
    return {"models": models, "queries": QUERIES, "differences": differences(results),
            "detectors": [(d, COLORS[d.origin], ORIGINS[d.origin]) for d in detectors if d.detector in there and d.found == "yes"],
            "absent": [d for d in detectors if d.found == "no"], "table_2": table_2(results),
            "shares": [row for row in shares if row[2]], "share_levels": max(len(row[2]) for row in shares), "sphere_costs": sphere_costs(results)}
