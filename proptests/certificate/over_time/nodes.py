# SPDX-License-Identifier: GPL-3.0-or-later
"""The nodes of a glTF file: who is below whom, what the scene shows, and where an animation has them."""
import json

import numpy as np

from .channel import SHAPES, Channel, unit
from .glb import finite_numbers, index, items, member
from .interval import Interval, above, dot, interval, norm, stack
from .motion import Chain, Motion, plus
from .rejected import require

RESTS = {"translation": [0.0, 0.0, 0.0], "rotation": [0.0, 0.0, 0.0, 1.0], "scale": [1.0, 1.0, 1.0]}


class Nodes:
    def __init__(self, glb):
        self.list = glb.list("nodes")
        self.parents = [-1] * len(self.list)
        for n, node in enumerate(self.list):
            for child in items(node, "children", int, []):
                require(0 <= child < len(self.list) and self.parents[child] < 0, "a node is below two, or not there")
                self.parents[child] = n
        self.children = [items(node, "children", int, []) for node in self.list]
        self.order = self.below([n for n, parent in enumerate(self.parents) if parent < 0])  # parents first
        require(len(self.order) == len(self.list), "a node is below itself")
        self.shown = self.below(self.roots(glb))

    def roots(self, glb):
        scenes = glb.list("scenes")
        if not scenes:
            return [n for n, parent in enumerate(self.parents) if parent < 0]
        roots = items(scenes[index(glb.description, "scene", len(scenes), 0)], "nodes", int, [])
        require(len(set(roots)) == len(roots) and all(0 <= n < len(self.list) and self.parents[n] < 0 for n in roots),
                "the scene names a node that is no root")
        return roots

    def below(self, roots):
        found, waiting = [], roots[::-1]
        while waiting:
            found.append(waiting.pop())
            waiting += self.children[found[-1]][::-1]
        return found

    def matrix(self, n):
        """Of a node that has one: its first three rows."""
        rows = np.array(finite_numbers(self.list[n], "matrix", 16)).reshape(4, 4).T
        require(np.array_equal(rows[3], (0, 0, 0, 1)), "a node's matrix is not affine")
        return rows[:3]

    def rest(self, n, path):
        """(1, width)"""
        values = Interval(np.array([finite_numbers(self.list[n], path, len(RESTS[path]), RESTS[path])]))
        return unit(values) if path == "rotation" else values


def animation_of(glb, nodes, number):
    """Its channels by node and path, without those that move no shape; for the rest pose, -1, none."""
    channels = {}
    if number < 0:
        return channels
    animation = glb.list("animations")[number]
    samplers, meshes = items(animation, "samplers", dict, []), glb.list("meshes")
    for channel in items(animation, "channels", dict, []):
        target = member(channel, "target", dict)
        if "node" not in target:  # as glTF lets readers ignore
            require("KHR_animation_pointer" not in member(target, "extensions", dict, {}), "a channel moves what a pointer names")
            continue
        node, path = index(target, "node", len(nodes.list)), member(target, "path", str)
        require(path in SHAPES or path == "weights", f"a channel moves {json.dumps(path)[:40]}")
        require((node, path) not in channels, "two channels move the same")
        sampler = samplers[index(channel, "sampler", len(samplers))]
        interpolation = member(sampler, "interpolation", str, "LINEAR")
        require(interpolation in ("LINEAR", "STEP", "CUBICSPLINE"), "a channel is interpolated in a way that glTF has not")
        times = glb.numbers(member(sampler, "input", int), "SCALAR")
        require(np.all(times.low == times.high), "a channel's times are no floats")
        shape, width = SHAPES.get(path, ("SCALAR", 0))
        if path == "weights":
            width = target_count(meshes, nodes.list[node])
            if width == 0:
                continue
        require(path == "weights" or "matrix" not in nodes.list[node], "a node that has a matrix is moved")
        values = glb.numbers(member(sampler, "output", int), shape)
        rows = len(times.low) * (3 if interpolation == "CUBICSPLINE" else 1)
        require(values.low.size >= rows * width, "a channel has not as many values as keys")
        values = Interval(values.low.reshape(-1, width)[:rows], values.high.reshape(-1, width)[:rows])
        channels[node, path] = Channel(path, times.low[:, 0], values, interpolation)
    return channels


def target_count(meshes, node):
    if "mesh" not in node:
        return 0
    primitives = items(meshes[index(node, "mesh", len(meshes))], "primitives", dict)
    require(primitives, "a mesh has no primitives")
    return len(items(primitives[0], "targets", dict, []))


def rotation_matrix(q):
    """Of unit quaternions (x, y, z, w): rows and columns last."""
    x, y, z, w = (q[..., i] for i in range(4))
    double = [[y * y + z * z, x * y - w * z, x * z + w * y], [x * y + w * z, x * x + z * z, y * z - w * x],
              [x * z - w * y, y * z + w * x, x * x + y * y]]
    return stack([stack([1 - 2.0 * e if r == c else 2.0 * e for c, e in enumerate(row)]) for r, row in enumerate(double)], -2)


def times_matrix(a, b):
    return stack([stack([dot(a[..., r, :], b[..., :, c]) for c in range(b.low.shape[-1])]) for r in range(3)], -2)


class AnimatedNodes:
    """Some nodes, with all that are above them, in an animation."""

    def __init__(self, nodes, channels, wanted):
        self.nodes, self.channels, needed = nodes, channels, set()
        for n in wanted:
            while n >= 0 and n not in needed:
                needed.add(n)
                n = nodes.parents[n]
        self.needed, self.order = needed, [n for n in nodes.order if n in needed]

    def moving(self):
        """The channels of these nodes."""
        return [channel for (n, path), channel in self.channels.items() if path != "weights" and n in self.needed]

    def value(self, n, path, times, side):
        channel = self.channels.get((n, path))
        return channel.at(times, side) if channel else self.nodes.rest(n, path)

    def matrices(self, times, side):
        """By node: its first three rows, to the scene; (times or 1, 3, 4)."""
        found = {-1: None}
        for n in self.order:
            if "matrix" in self.nodes.list[n]:
                local = interval(self.nodes.matrix(n)[None])
            else:
                turned = rotation_matrix(self.value(n, "rotation", times, side))
                scaled = turned * self.value(n, "scale", times, side)[:, None, :]
                local = joined(scaled, self.value(n, "translation", times, side))
            above_it = found[self.nodes.parents[n]]
            found[n] = local if above_it is None else product(above_it, local)
        return found

    def link(self, n, start, end):
        """How the node moves what is below it, between times without keys."""
        if "matrix" in self.nodes.list[n]:
            rows = self.nodes.matrix(n)
            squared = times_matrix(Interval(rows[:, :3].T), Interval(rows[:, :3])).magnitude()
            greatest = max(plus(plus(row[0], row[1]), row[2]) for row in squared)  # no eigenvalue of A^T A is greater
            return Chain(Motion(above(np.sqrt(greatest))), Motion(norm(rows[:, 3]).high))
        moved = {}
        for path, rest in RESTS.items():
            channel = self.channels.get((n, path))
            if channel:
                moved[path] = channel.motion(start, end)
            else:
                value = self.nodes.rest(n, path)
                moved[path] = Motion({"rotation": 1.0, "scale": value.magnitude().max(), "translation": norm(value).high[0]}[path])
        return Chain(moved["rotation"] * moved["rotation"] * moved["scale"], moved["translation"])

    def chains(self, start, end):
        """By node: how it moves what is below it, in the scene."""
        found = {-1: Chain(Motion(1.0), Motion(0.0))}
        for n in self.order:
            found[n] = found[self.nodes.parents[n]] @ self.link(n, start, end)
        return found


def joined(linear, offset):
    rows = np.broadcast_shapes(linear.low.shape[:1], offset.low.shape[:1])
    parts = [(np.broadcast_to(a, rows + (3, 3)), np.broadcast_to(b, rows + (3,))[..., None])
             for a, b in ((linear.low, offset.low), (linear.high, offset.high))]
    return Interval(*(np.concatenate(part, axis=-1) for part in parts))


def product(outer, inner):
    """Of affine maps, by their first three rows."""
    both = times_matrix(outer[..., :3], inner)
    return joined(both[..., :3], both[..., 3] + outer[..., 3])
