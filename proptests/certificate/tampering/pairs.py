# SPDX-License-Identifier: GPL-3.0-or-later
"""What certificates of pairs are tampered with. Each function returns the text of one that is false or none, or None where it cannot."""
import collections
from fractions import Fraction

from tampering import anything
from tampering.anything import sealed


def corners(body, triangles):
    return [[Fraction(x) for x in body["vertices"][v]] for t in triangles for v in body["triangles"][t]]


def made(weights, triangle):
    return [sum(Fraction(w) * p[c] for w, p in zip(weights, triangle)) for c in range(3)]


def sets_of_steps(d):
    """By step the sets of triangles that it is about."""
    todo, out = [(d["first_order"], d["second_order"])], []
    for step in d["steps"]:
        a, b = todo.pop()
        out.append((a, b))
        if step == "first":
            todo += [(a[len(a) // 2:], b), (a[:len(a) // 2], b)]
        elif step == "second":
            todo += [(a, b[len(b) // 2:]), (a, b[:len(b) // 2])]
    return out


def some(d, r, kind):
    """The place of some step of a kind, or None."""
    places = [i for i, step in enumerate(d["steps"]) if (step if type(step) is str else "plane") == kind]
    return r.choice(places) if places else None


def number_of_contact(d, place):
    return d["steps"][:place].count("contact")


# --- Pairs ---
def pair_left_out(d, r):
    if d["contacts"]:
        del d["contacts"][r.randrange(len(d["contacts"]))]
        return sealed(d)


def plane_between_what_touches(d, r):
    place = some(d, r, "contact")
    if place is not None:
        del d["contacts"][number_of_contact(d, place)]
        planes = [step for step in d["steps"] if type(step) is dict]
        d["steps"][place] = r.choice(planes + [{"normal": ["0", "0", "0"], "offset": "0"}, {"normal": ["1", "0", "0"], "offset": "1/2"}])
        return sealed(d)


def contact_of_what_is_apart(d, r):
    place = some(d, r, "plane")
    if place is not None:
        a, b = sets_of_steps(d)[place]
        d["steps"][place] = "contact"
        weights = [["1", "0", "0"], ["1/3", "1/3", "1/3"], ["0", "1/2", "1/2"]]
        contact = {"pair": [a[0], b[0]], "first": r.choice(weights), "second": r.choice(weights)}
        d["contacts"].insert(number_of_contact(d, place), contact)
        return sealed(d)


def pair_twice(d, r):
    if d["contacts"]:
        d["contacts"].insert(r.randrange(len(d["contacts"])), r.choice(d["contacts"]))
        return sealed(d)


def another_pair(d, r):
    if d["contacts"]:
        pair = r.choice(d["contacts"])["pair"]
        side = r.randrange(2)
        pair[side] = r.choice([-1, pair[side] + 1, pair[side] - 1, 999999999])
        return sealed(d)


# --- Weights ---
def weights_of(d, r):
    contact = r.choice(d["contacts"])
    name = r.choice(["first", "second"])
    return contact, name, d[name]


def negative_weight(d, r):
    if d["contacts"]:
        contact, name, _ = weights_of(d, r)
        i, j = r.sample(range(3), 2)
        for k, by in ((i, 2), (j, -2)):
            contact[name][k] = str(Fraction(contact[name][k]) + by)
        return sealed(d)


def weights_off_the_sum(d, r):
    if d["contacts"]:
        contact, name, _ = weights_of(d, r)
        k = r.randrange(3)
        contact[name][k] = str(Fraction(contact[name][k]) + r.choice([1, Fraction(1, 10 ** r.randrange(99))]))
        return sealed(d)


def weights_of_nothing(d, r):
    if d["contacts"]:
        weights_of(d, r)[0].update(first=["0"] * 3, second=["0"] * 3)
        return sealed(d)


def weights_of_another_point(d, r):
    if d["contacts"]:
        contact, name, body = weights_of(d, r)
        triangle = corners(body, [contact["pair"][name == "second"]])
        other = r.choice([["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"], ["1/2", "1/2", "0"], ["1/3", "1/3", "1/3"]])
        if made(other, triangle) != made(contact[name], triangle):
            contact[name] = other
            return sealed(d)


# --- Planes ---
def plane_onto_a_vertex(d, r):
    place = some(d, r, "plane")
    if place is not None:
        sets, name = sets_of_steps(d)[place], r.choice(["first", "second"])
        normal = [Fraction(x) for x in d["steps"][place]["normal"]]
        products = [sum(n * x for n, x in zip(normal, p)) for p in corners(d[name], sets[name == "second"])]
        d["steps"][place]["offset"] = str(max(products) if name == "first" else min(products))
        return sealed(d)


def plane_turned_round(d, r):
    place = some(d, r, "plane")
    if place is not None:
        d["steps"][place]["normal"] = [str(-Fraction(x)) for x in d["steps"][place]["normal"]]
        return sealed(d)


def plane_without_normal(d, r):
    place = some(d, r, "plane")
    if place is not None:
        d["steps"][place]["normal"] = ["0", "0", "0"]
        return sealed(d)


# --- What is covered ---
def step_left_out(d, r):
    del d["steps"][r.randrange(len(d["steps"]))]
    return sealed(d)


def step_twice(d, r):
    i = r.randrange(len(d["steps"]))
    d["steps"].insert(i, d["steps"][i])
    return sealed(d)


def triangle_left_out_of_the_order(d, r):
    order = d[r.choice(["first_order", "second_order"])]
    if len(order) > 1:
        i, j = r.sample(range(len(order)), 2)
        order[i] = order[j]
        return sealed(d)


def shorter_order(d, r):
    order = d[r.choice(["first_order", "second_order"])]
    if len(order) > 1:
        del order[r.randrange(len(order))]
        return sealed(d)


def longer_order(d, r):
    order = d[r.choice(["first_order", "second_order"])]
    order.insert(r.randrange(len(order) + 1), r.choice(order))
    return sealed(d)


def order_out_of_range(d, r):
    order = d[r.choice(["first_order", "second_order"])]
    order[r.randrange(len(order))] = r.choice([-1, len(order)])
    return sealed(d)


def triangle_left_out(d, r):
    del d[r.choice(["first", "second"])]["triangles"][-1]
    return sealed(d)


def triangle_added(d, r):
    triangles = d[r.choice(["first", "second"])]["triangles"]
    triangles.append(r.choice(triangles))
    return sealed(d)


def corner_out_of_range(d, r):
    body = d[r.choice(["first", "second"])]
    r.choice(body["triangles"])[r.randrange(3)] = r.choice([-1, len(body["vertices"])])
    return sealed(d)


# --- What is seen only against the documents of the bodies ---
def other_name(d, r):
    d[r.choice(["first", "second"])]["name"] += " "
    return sealed(d)


def vertex_beyond(d, r):  # of no triangle
    body = d[r.choice(["first", "second"])]
    body["vertices"].append(r.choice(body["vertices"]))
    return sealed(d)


def vertex_moved_a_little(d, r):
    vertex = r.choice(d[r.choice(["first", "second"])]["vertices"])
    c = r.randrange(3)
    vertex[c] = str(Fraction(vertex[c]) + Fraction(1, 10 ** r.randrange(40, 99)))
    return sealed(d)


NEEDS_DOCUMENTS = [other_name, vertex_beyond, vertex_moved_a_little]
FALSE = NEEDS_DOCUMENTS + [pair_left_out, plane_between_what_touches, contact_of_what_is_apart, pair_twice, another_pair, negative_weight,
                           weights_off_the_sum, weights_of_nothing, weights_of_another_point, plane_onto_a_vertex, plane_turned_round,
                           plane_without_normal, step_left_out, step_twice, triangle_left_out_of_the_order, shorter_order, longer_order,
                           order_out_of_range, triangle_left_out, triangle_added, corner_out_of_range, *anything.FALSE]
FOR_KERNEL = plane_onto_a_vertex  # which every checker has to look at the numbers for


def control_points(document):
    """None: these have no hulls."""
    return 0


def parts(document):
    """What it is made of, to be counted."""
    out = collections.Counter(step if type(step) is str else "plane" for step in document["steps"])
    out["certificate without contacts"] = int(not document["contacts"])
    return out
