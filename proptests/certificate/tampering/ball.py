# SPDX-License-Identifier: GPL-3.0-or-later
"""What certificates of balls are tampered with. Each function returns the text of one that is false or none, or None where it cannot."""
import collections
import hashlib
import math
from fractions import Fraction

from tampering import anything
from tampering.anything import sealed


def another_vertex(d, r):
    """Some vertex, its piece, and the joint-set's number of joints."""
    vertex = r.choice(d["vertices"])
    return vertex, d["pieces"][vertex["piece"]], len(vertex["weights"])


def vertex_outside(d, r):
    vertex, piece, _ = another_vertex(d, r)
    i = r.randrange(3)
    vertex["position"][i] = str(Fraction(piece["reference"]["center"][i]) + Fraction(piece["reference"]["radius"]) + Fraction(1, 10 ** r.randrange(99)))
    return sealed(d)


def weights_shifted(d, r):
    vertex, _, joints = another_vertex(d, r)
    if joints > 1:
        step = Fraction(1, 2 ** r.randrange(8, 40))
        for k, by in zip(r.sample(range(joints), 2), (step, -step)):
            vertex["weights"][k] = str(Fraction(vertex["weights"][k]) + by)
        return sealed(d)


def weights_of_a_weight_vertex(d, r):  # true of a vertex that the model has not
    vertex, piece, joints = another_vertex(d, r)
    k = r.randrange(len(piece["weight_vertices"]))
    if piece["weight_vertices"][k] != vertex["weights"]:
        vertex.update(weights=piece["weight_vertices"][k], weight_vertices=[k], shares=["1"])
        return sealed(d)


def position_in_the_middle(d, r):  # this one too
    vertex, piece, _ = another_vertex(d, r)
    if vertex["position"] != piece["reference"]["center"]:
        vertex["position"] = piece["reference"]["center"]
        return sealed(d)


def piece_left_out(d, r):
    if len(d["pieces"]) > 1:
        gone = r.choice(d["vertices"])["piece"]
        del d["pieces"][gone]
        d["vertices"] = [v for v in d["vertices"] if v["piece"] != gone]
        for v in d["vertices"]:
            v["piece"] -= v["piece"] > gone
        return sealed(d) if d["vertices"] else None


def vertex_left_out(d, r):
    if len(d["vertices"]) > 1:
        del d["vertices"][r.randrange(len(d["vertices"]))]
        return sealed(d)


def other_model(d, r):
    d["model"] = hashlib.sha256(str(r.random()).encode()).hexdigest()
    return sealed(d)


def other_pose(d, r):
    joint_set = r.choice(d["joint_sets"])
    q = r.choice(joint_set["rotations"] if "rotations" in joint_set else r.choice(joint_set["columns"]))
    q[r.randrange(len(q))] = str(Fraction(r.randrange(-99, 99), 128) + Fraction(1, 3))
    return sealed(d)


def negative_share(d, r):
    vertex, _, _ = another_vertex(d, r)
    vertex["weight_vertices"] = vertex["weight_vertices"] + vertex["weight_vertices"][:1] * 2
    vertex["shares"] = vertex["shares"] + ["1", "-1"]
    return sealed(d)


def ball_too_small(d, r):
    radius = Fraction(d["ball"]["radius"])
    if radius:
        d["ball"]["radius"] = str(-radius)
        return sealed(d)


def ball_elsewhere(d, r):
    d["ball"]["center"][r.randrange(3)] = str(Fraction(10 ** 9))
    return sealed(d)


def bound_of_another_skinning(d, r):
    other = {"linear": {"by": "all_rotations"}, "affine": {"by": "control"}, "spherical": {"by": "reach"}, "dual_quaternion": {"by": "all_rotations"}}
    r.choice(d["pieces"])["bound"] = other[d["skinning"]]
    return sealed(d)


def weight_vertex_off_the_sum(d, r):
    weight_vertex = r.choice(r.choice(d["pieces"])["weight_vertices"])
    k = r.randrange(len(weight_vertex))
    weight_vertex[k] = str(Fraction(weight_vertex[k]) + Fraction(1, 2 ** r.randrange(90)))
    return sealed(d)


def stretch_too_small(d, r):
    if d["skinning"] == "affine":
        bound = r.choice(d["pieces"])["bound"]
        stretches = bound[r.choice(["of_joints", "of_weight_vertices"])]
        k = r.randrange(len(stretches))
        stretches[k] = str(Fraction(stretches[k]) / 10 - Fraction(1, 10 ** r.randrange(1, 99)))
        return sealed(d)


# What is seen only against the documents of the model and the pose; and all.
NEEDS_DOCUMENTS = [weights_of_a_weight_vertex, position_in_the_middle, piece_left_out, vertex_left_out, other_model, other_pose]
FALSE = NEEDS_DOCUMENTS + [stretch_too_small, vertex_outside, weights_shifted, negative_share, ball_too_small, ball_elsewhere,
                           bound_of_another_skinning, weight_vertex_off_the_sum, *anything.FALSE]
FOR_KERNEL = vertex_outside  # which every checker has to look at the numbers for


def control_points(document):
    """That its pieces have, if all of them are bounded so."""
    degree = {"spherical": 3, "dual_quaternion": 2}.get(document["skinning"], 1)
    return sum(math.comb(len(piece["weight_vertices"]) + degree - 1, degree) for piece in document["pieces"])


def parts(document):
    """What it is made of, to be counted: its bounds by skinning."""
    out, todo = collections.Counter(), [piece["bound"] for piece in document["pieces"]]
    while todo:
        bound = todo.pop()
        todo += bound.get("halves", [])
        out[document["skinning"] + " " + bound["by"]] += 1
    return out
