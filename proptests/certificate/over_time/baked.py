# SPDX-License-Identifier: GPL-3.0-or-later
"""What a baked file itself says of its bounds, in extras.refitlab (algorithms/program/extras.schema.json) and in the chunk of its
own (algorithms/runtime/tree/baked_file.hpp), and whether a certificate's bounds imply it."""
import struct
from fractions import Fraction

import numpy as np

from .claims import numbers, read_slabs
from .glb import items, member
from .rejected import require

BAKED_CHUNK = 0x424C4652  # "RFLB"


def key_of(thing):
    return tuple(tuple(value) if type(value) is list else value for _, value in sorted(thing.items()))


class Proven:
    """A certificate's bounds: by animation and thing."""

    def __init__(self, certificate):
        self.directions = certificate["directions"]
        self.bounds = {clip["animation"]: clip["bounds"] for clip in certificate["clips"]}
        self.parts = {key_of(thing): p for p, part in enumerate(certificate["parts"]) for thing in part}

    def of(self, animation, thing):
        require(animation in self.bounds and key_of(thing) in self.parts,
                f"the file has a bound of a {thing['kind']} in animation {animation} that the certificate has not")
        return self.bounds[animation][self.parts[key_of(thing)]]


def require_implied(box, ball, slabs, bounds, what):
    """The box holds the boxes of the bounds, the ball holds their balls, and each slab, if there are any, holds theirs."""
    for bound in bounds:
        holds_box = np.all(box[:3] <= bound["box"][:3]) and np.all(bound["box"][3:] <= box[3:])
        holds_slabs = not len(slabs) or np.all(slabs[:, 0] <= bound["slabs"][:, 0]) and np.all(bound["slabs"][:, 1] <= slabs[:, 1])
        require(holds_box and holds_slabs and holds_ball(ball.tolist(), bound["ball"].tolist()),
                f"{what} is not what the certificate implies")


def directions_of_dop(k):
    """Those of slabs beyond the axes, as algorithms/runtime/balls/slab_directions.hpp has them."""
    squares = {6: (), 14: (3,), 18: (2,), 26: (2, 3)}
    require(k in squares, "the chunk of refitlab has k-DOPs of another k")
    every = [[x, y, z] for x in (1, 0, -1) for y in (1, 0, -1) for z in (1, 0, -1)]
    ahead = [d for d in every if d > [0, 0, 0]]
    return [d for square in squares[k] for d in ahead if sum(x * x for x in d) == square]


def holds_ball(outer, inner):
    if outer == inner:
        return True
    apart = sum((Fraction(a) - Fraction(b)) ** 2 for a, b in zip(outer[:3], inner[:3]))
    more = Fraction(outer[3]) - Fraction(inner[3])
    return more >= 0 and apart <= more * more


def require_extras_implied(glb, proven, vertices):
    animations = range(-1, len(glb.list("animations")))

    def check(extras, animations_of, things, what, directions):
        box, ball = numbers(extras.get("box"), (6,), what + ".box"), numbers(extras.get("ball"), (4,), what + ".ball")
        slabs = read_slabs(items(extras, "slabs", list, []), len(directions), what + ".slabs")
        require(directions in ([], proven.directions), f"{what} has other directions than the certificate")
        require_implied(box, ball, slabs, [proven.of(a, thing) for a in animations_of for thing in things], what)

    for a, animation in enumerate(glb.list("animations")):
        extras = refitlab_extras(animation)
        if extras:
            check(extras, [a], [{"kind": "whole"}], f"animation {a}", directions_of(extras))
            for kind, plural in (("skin", "skins"), ("mesh", "meshes"), ("primitive", "primitives")):
                for part in items(extras, plural, dict):
                    names = ("node", "mesh", "primitive") if kind == "primitive" else (kind,)
                    thing = {"kind": kind, **{name: member(part, name, int) for name in names}}
                    check(part, [a], [thing], f"a {kind} of animation {a}", directions_of(extras))
    for kind, plural in (("skin", "skins"), ("mesh", "meshes")):
        for i, owner in enumerate(glb.list(plural)):
            extras = refitlab_extras(owner)
            if extras:
                check(extras, animations, [{"kind": kind, kind: i}], f"{kind} {i}", directions_of(extras))
            for p, primitive in enumerate(items(owner, "primitives", dict, [])):
                extras = refitlab_extras(primitive)
                if extras:
                    things = [{"kind": "primitive", "node": shown.node, "mesh": i, "primitive": p}
                              for shown in vertices.primitives if (shown.mesh, shown.number) == (i, p) and shown.is_kept.any()]
                    check(extras, animations, things, f"primitive {p} of mesh {i}", directions_of(extras))


def directions_of(extras):
    return items(extras, "directions", list, [])


def refitlab_extras(owner):
    extras = owner.get("extras")
    found = member(extras, "refitlab", dict, {}) if type(extras) is dict else {}
    require(not found or (found.get("version") == 1 and found.get("skinning") == "linear"),
            "extras.refitlab is not of version 1 and linear skinning")
    return found


class Bytes:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, count):
        require(0 <= count <= len(self.data) - self.at, "the chunk of refitlab ends early")
        self.at += count
        return self.data[self.at - count:self.at]

    def number(self, form):
        return struct.unpack("<" + form, self.take(struct.calcsize(form)))[0]

    def list(self, dtype, width=1):
        dtype = np.dtype(dtype)
        return np.frombuffer(self.take(self.number("Q") * width * dtype.itemsize), dtype).reshape(-1, width)

    def sealed(self, magic, version):
        """The bytes behind a header."""
        require(self.take(8) == magic and self.number("I") == version, "the chunk of refitlab is of another version")
        size, _ = self.number("Q"), self.number("Q")
        return Bytes(self.take(size))


def require_clusters_implied(glb, proven):
    for kind, data in glb.chunks:
        if kind != BAKED_CHUNK:
            continue
        body = Bytes(data).sealed(b"rflbaked", 2)
        require(body.number("I") == 0, "the chunk of refitlab is of another skinning")
        body.number("I")  # how crossfades blend rotations
        body.take(body.number("Q"))  # the character
        clusters = Bytes(body.take(body.number("Q"))).sealed(b"rfltimes", 3)
        directions = directions_of_dop(clusters.number("i"))
        require(directions == proven.directions, "the chunk of refitlab has k-DOPs of other directions than the certificate")
        primitives = clusters.list("<i4", 4).tolist()
        things = []
        for _ in range(clusters.number("Q")):
            primitive = clusters.number("i")
            require(0 <= primitive < len(primitives), "a cluster is of a primitive that is not there")
            node, mesh, number, _ = primitives[primitive]
            things.append({"kind": "cluster", "node": node, "mesh": mesh, "primitive": number,
                           "triangles": clusters.list("<i4")[:, 0].tolist()})
        count = clusters.number("Q")
        require(count == len(glb.list("animations")) + 1, "the chunk of refitlab has another number of clips")
        for clip in range(count):
            clusters.list("u1"), clusters.number("d")
            bounds = clusters.list("<f4", 10 + 2 * len(directions)).astype(float)
            clusters.list("<f4", 10 + 2 * len(directions))  # of nodes
            require(len(bounds) == len(things), "the chunk of refitlab has not a bound for each cluster")
            for i, (thing, bound) in enumerate(zip(things, bounds)):
                proved = proven.of(clip if clip + 1 < count else -1, thing)
                require_implied(bound[:6], bound[6:10], bound[10:].reshape(-1, 2), [proved], f"cluster {i} of clip {clip}")
