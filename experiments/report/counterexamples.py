# SPDX-License-Identifier: GPL-3.0-or-later
"""The counterexamples of proptests/cases/cases.json, and what follows from them, in exact rationals.

What the tests decide with the library is worked out here once more, from the statements alone.
"""
import json
from fractions import Fraction

from .tables import ResultError


class Cases:
    """The cases by name; numbers are Fractions."""

    def __init__(self, path):
        self.path = path
        try:
            self.inputs = {c["name"]: exact(c["inputs"]) for c in json.loads(path.read_text())["cases"]}
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise ResultError(f"{path}: is no case file ({error!r})") from None

    def __getitem__(self, name):
        if name not in self.inputs:
            raise ResultError(f"{self.path}: has no case '{name}'")
        return self.inputs[name]


def exact(value):
    if isinstance(value, dict):
        return {k: exact(v) for k, v in value.items()}
    if isinstance(value, list):
        return [exact(v) for v in value]
    return Fraction(value)


# --- Vectors and quaternions (real part first) as lists ---

def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), Fraction(0))


def scaled(a, s):
    return [x * s for x in a]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def blend(weights, vectors):
    return [dot(weights, column) for column in zip(*vectors)]


def multiply(a, b):
    (s, x, y, z), (t, u, v, w) = a, b
    return [s * t - x * u - y * v - z * w, s * u + t * x + y * w - z * v, s * v + t * y + z * u - x * w,
            s * w + t * z + x * v - y * u]


def rotate(q, x):
    q_conjugate = [q[0], *scaled(q[1:], -1)]
    return scaled(multiply(multiply(q, [Fraction(0), *x]), q_conjugate)[1:], 1 / dot(q, q))


# --- What the statements make of the cases ---

def mean_ball(points):
    """Center and squared radius of the ball about the mean."""
    center = blend([Fraction(1, len(points))] * len(points), points)
    return center, max(dot(minus(p, center), minus(p, center)) for p in points)


def algorithm_1(case):
    """Algorithm 1 as printed, for one joint-set whose joints turn about 0 with weights of [0, 1] each: then the weight
    vertices are the joints, all r'_k are 0, and the result is the one ball of line 15, inflated."""
    (joint_set,), vertex, reference = case["joint_sets"], case["vertex"], case["reference"]
    units = [t["rotation"] for t in joint_set["transforms"]]
    zero = [Fraction(0)] * 3
    simple = (joint_set["rotation_center"] == zero and reference["radius"] == 0
              and all(t["translation"] == zero for t in joint_set["transforms"])
              and set(joint_set["bounds"]["low"]) == {0} and set(joint_set["bounds"]["high"]) == {1})
    if not simple:
        raise ResultError("the case of Algorithm 1 is not of the kind that counterexamples.py works out")
    c, r2 = mean_ball(units)
    n = 1 + dot(c, c) - r2
    cosine = n * n / (2 * dot(c, c)) - 1
    p = reference["center"]
    image = rotate(blend(vertex["weights"], units), vertex["position"])
    away = minus(image, scaled(rotate(c, p), cosine))
    return {"r_E2": r2, "d_H2": n * n / (4 * dot(c, c)), "cos": cosine, "radius2": (1 - cosine * cosine) * dot(p, p),
            "distance2": dot(away, away), "quaternion": units[-1], "weights": vertex["weights"]}


def of_cases(cases):
    """Every number that the text takes from a case, by name."""
    out = {}

    def put(prefix, **values):
        out.update({f"{prefix}.{name}": value for name, value in values.items()})

    lemma1 = cases["half-space that holds the circle, printed"]
    h, s = lemma1["half_space"], lemma1["surface"]
    put("l1", normal=h["normal"], offset=h["offset"], off=abs(h["offset"] - dot(s["center"], h["normal"])),
        r2=s["squared_radius"])

    cancel = cases["three quaternions that cancel, printed"]
    put("l2", second=cancel["vectors"][1], third=cancel["vectors"][2], weights=cancel["weights"],
        blend=blend(cancel["weights"], cancel["vectors"])[0])

    inside, beyond = (cases[f"disc {where} the circle, printed"]["ball"] for where in ("inside", "beyond"))
    put("l3", inside=inside["center"], inside_r2=inside["squared_radius"], beyond=beyond["center"],
        beyond_r2=beyond["squared_radius"])

    wide = cases["mean ball of radius 6/5, printed"]
    n = 1 + dot(wide["center"], wide["center"]) - wide["squared_radius"]
    put("l4", unit=wide["units"][-1], count=Fraction(len(wide["units"]) - 1), r2=wide["squared_radius"],
        d_H2=n * n / (4 * dot(wide["center"], wide["center"])))

    cap = cases["apex of a wide cap, printed"]["cap"]
    center = scaled(cap["apex"], cap["cos_angle"])
    away, r2 = minus(cap["apex"], center), dot(cap["apex"], cap["apex"]) * (1 - cap["cos_angle"] ** 2)
    put("l5", apex=cap["apex"], cos=cap["cos_angle"], center=center, distance2=dot(away, away), radius2=r2)

    empty = cases["low bounds too high, printed"]["bounds"]
    put("s41", low=empty["low"], sum=sum(empty["low"]))

    outside = cases["ball outside, printed"]
    c2, r = dot(outside["center"], outside["center"]), outside["radius"]
    length = max(outside["center"])  # along a coordinate
    put("range", center=outside["center"], radius=r, d_H=(1 + c2 - r * r) / (2 * length))

    turned = cases["half turn past a right angle, printed"]
    put("turn", cos=turned["cos_angle"], rotation=turned["rotation"], v=turned["v"],
        image=rotate(turned["rotation"], turned["v"]), doubled=2 * turned["cos_angle"] ** 2 - 1)

    past = cases["mean ball past a half, line 15"]
    put("line15", unit=past["units"][-1], r2=past["squared_radius"],
        n=1 + dot(past["center"], past["center"]) - past["squared_radius"])

    wide_cap = algorithm_1(cases["cap beyond a right angle, printed"])
    if not wide_cap["distance2"] > wide_cap["radius2"]:
        raise ResultError(f"{cases.path}: 'cap beyond a right angle, printed': its vertex is inside the printed ball")
    put("a1", **wide_cap)

    sign = cases["lost sign, printed"]
    rotations = [t["rotation"] for t in sign["joint_sets"][0]["transforms"]]
    weights, v = sign["vertex"]["weights"], sign["vertex"]["position"]
    flipped = [rotations[0], scaled(rotations[1], -1)]
    put("sign", first=rotations[0], second=rotations[1], v=v, image=rotate(blend(weights, rotations), v),
        printed=rotate(blend(weights, flipped), v))
    return out
