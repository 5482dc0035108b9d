# SPDX-License-Identifier: GPL-3.0-or-later
"""Certificates at the edges of what checkers take: very long lists, work that only the way of computing makes long, and numbers of very
different sizes. Random ones are never so."""
import hashlib
import json

from tampering.anything import sealed

ORIGIN, IDENTITY = ["0", "0", "0"], ["1", "0", "0", "0"]


def ball():
    """A vertex at the origin, carried by one joint."""
    return {"about": "an edge", "ball": {"center": ORIGIN, "radius": "1"}, "digest": "", "model": "0" * 64, "node": 0, "pose": "0" * 64,
            "joint_sets": [{"joints": [0], "rotations": [IDENTITY], "translations": [ORIGIN]}],
            "pieces": [{"bound": {"by": "control"}, "joint_set": 0, "reference": {"center": ORIGIN, "radius": "1"}, "weight_vertices": [["1"]]}],
            "skinning": "linear",
            "vertices": [{"id": 0, "piece": 0, "position": ORIGIN, "shares": ["1"], "weight_vertices": [0], "weights": ["1"]}]}


def pair():
    """A triangle on each side of a plane."""
    body = lambda name, z: {"name": name, "triangles": [[0, 1, 2]], "vertices": [["0", "0", z], ["1", "0", z], ["0", "1", z]]}
    return {"about": "an edge", "contacts": [], "digest": "", "first": body("first", "0"), "first_order": [0], "second": body("second", "5"),
            "second_order": [0], "steps": [{"normal": ["0", "0", "1"], "offset": "1"}]}


def many_joints():
    d = ball()
    d["joint_sets"][0]["joints"] = [0] * 600000
    return d


def many_weights_of_many_vertices():  # of each vertex and share, a list is walked once for each weight
    d, n = ball(), 20000
    weights = ["0"] * (n - 1) + ["1"]
    d["joint_sets"][0].update(rotations=[IDENTITY] * n, translations=[ORIGIN] * n)
    d["pieces"][0]["weight_vertices"] = [weights]
    d["vertices"] = [{**d["vertices"][0], "weights": weights}] * 8
    return d


def denominators_of_one_hash():
    d, prime = ball(), 2 ** 61 - 1
    d["vertices"][0]["weights"] = [f"1/{k * prime + 1}" for k in range(1, 30001)]
    return d


def quotient_of_unlike_numbers():  # of a cap: 1 and 2^-600
    d, small = ball(), f"1/{2 ** 300}"
    d["skinning"] = "spherical"
    d["joint_sets"] = [{"joints": [0], "rotations": [["1", small, "0", "0"]], "center_images": [ORIGIN], "rotation_center": ORIGIN}]
    away = ["0", "10", "0"]
    d["pieces"][0].update(bound={"by": "cap", "axis": ["1", "0", small, "0"]}, reference={"center": away, "radius": "1"})
    d["ball"], d["vertices"][0]["position"] = {"center": away, "radius": "2"}, away
    return d


def piece_far_beyond_the_list():
    d = ball()
    d["vertices"][0]["piece"] = 999999999
    return d


def many_triangles():
    d = pair()
    d["second"]["triangles"] = [[0, 1, 2]] * 150000
    d["second_order"] = list(range(150000))
    return d


def many_denominators():
    d, odd = pair(), iter(range(10 ** 9 + 1, 10 ** 9 + 10 ** 6, 2))
    d["first"]["vertices"] += [[f"1/{next(odd)}" for _ in range(3)] for _ in range(20000)]
    return d


# Each with the verdict, and whether the kernel is asked too.
OF_BALLS = [(many_joints, "accepted", False), (many_weights_of_many_vertices, "rejected", False), (denominators_of_one_hash, "rejected", False),
            (quotient_of_unlike_numbers, "accepted", True), (piece_far_beyond_the_list, "rejected", True)]
OF_PAIRS = [(many_triangles, "accepted", False), (many_denominators, "rejected", False)]


def large_model():
    """A certificate, and the document of a model of many vertices, with more denominators than a certificate may have."""
    vertex = {"joints": [0], "position": ORIGIN, "weights": ["1"]}
    odd = [{**vertex, "position": [f"1/{d}", "0", "0"]} for d in range(10 ** 6 + 1, 10 ** 6 + 2001, 2)]
    model = json.dumps({"name": "large", "nodes": [[0, 1]], "triangles": [[0, 0, 0]], "vertices": [vertex] * 150000 + odd}, indent=1, sort_keys=True) + "\n"
    return sealed({**ball(), "model": hashlib.sha256(model.encode()).hexdigest()}), model
