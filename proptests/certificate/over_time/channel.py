# SPDX-License-Identifier: GPL-3.0-or-later
"""Channels of an animation as glTF 2.0 says in its appendix C: where they are at a time, and how they move between two times.

Rotations are by the keys' quaternions divided by their lengths; between two keys of a linear channel they go at one speed along
the shorter great arc. A spline's keys are not divided: the quaternions that come of it are.
"""
import math

import numpy as np

from .interval import Interval, above, below, dot, norm, where
from .motion import Motion, normalized
from .rejected import require

AXES = 24  # that are tried for how short a spline of rotations may be
SHAPES = {"translation": ("VEC3", 3), "rotation": ("VEC4", 4), "scale": ("VEC3", 3)}


def unit(q):
    return q / norm(q)[..., None]


def sinc(x):
    """sin(x) / x for 0 <= x <= 2, by its alternating series: what is left out of the innermost bracket is between 0 and 1."""
    square, tail = x.squared(), Interval(0.0, 1.0)
    for n in range(14, 0, -1):
        tail = 1 - square * tail / float(2 * n * (2 * n + 1))
    return tail


def arc(tangent):
    """Twice the arc whose tangent this is, from 0 to a little more than 1; by halves of it, and the alternating series."""
    for _ in range(3):
        tangent = tangent / (1 + (1 + tangent.squared()).root())
    square, tail = tangent.squared(), Interval(0.0, 1.0)
    for n in range(14, 0, -1):
        tail = 1 - square * tail * float(2 * n - 1) / float(2 * n + 1)
    return 16 * (tangent * tail)


def is_behind(a, b, product):
    """Whether the scalar product of two keys is negative. Of floats its sign is known even where it is hardly not 0."""
    if product.high < 0 or product.low > 0:
        return product.high < 0
    require(np.all(a.low == a.high) and np.all(b.low == b.high), "two keys of a rotation are as far apart as can be")
    return math.fsum(x * y for x, y in zip(a.low.tolist(), b.low.tolist())) < 0  # products of two floats are doubles


def between(a, b, share):
    return a * (1 - share) + b * share


class Channel:
    def __init__(self, path, times, values, interpolation):
        """values: intervals of shape (keys, width), or (3 keys, width) of a cubic spline, whose tangents are among them."""
        require(len(times) > 0 and np.all(np.diff(times) >= 0), "keys are not in order of time")
        self.path, self.times, self.interpolation = path, times, interpolation
        self.into, self.out = (values[0::3], values[2::3]) if interpolation == "CUBICSPLINE" else (None, None)
        self.values = values[1::3] if interpolation == "CUBICSPLINE" else values
        require(self.values.low.shape[0] == len(times), "a channel has not as many values as keys")
        if path == "rotation" and interpolation != "CUBICSPLINE":
            raw, self.values = self.values, unit(self.values)
            if interpolation == "LINEAR" and len(times) > 1:
                self.prepare_arcs(raw)

    def prepare_arcs(self, raw):
        from_key, to_key = self.values[:-1], self.values[1:]
        product = dot(from_key, to_key)
        behind = np.array([is_behind(raw[k], raw[k + 1], product[k]) for k in range(len(self.times) - 1)])[:, None]
        self.ends = where(behind, -to_key, to_key)  # of the arc from each key
        self.angles = arc(norm(self.ends - from_key) / norm(self.ends + from_key))

    def segment(self, times, side):
        """The keys before the times, and whether the channel moves there: between that key and the next. On the side before a
        time, a key at this time is not yet before it."""
        key = np.searchsorted(self.times, times, "left" if side == "before" else "right") - 1
        moves = (key >= 0) & (key < len(self.times) - 1) & (self.interpolation != "STEP")
        return np.clip(key, 0, len(self.times) - 1), moves

    def share(self, times, key):
        start, end = self.times[key], self.times[key + 1]
        return (Interval(times) - start) / (Interval(end) - start)

    def points(self, key):
        """The four points of the spline's Bezier curve behind the keys."""
        third = ((Interval(self.times[key + 1]) - self.times[key]) / 3.0)[..., None]
        a, b = self.values[key], self.values[key + 1]
        return [a, a + self.out[key] * third, b - self.into[key + 1] * third, b]

    def at(self, times, side):
        """Intervals of shape (times, width)."""
        key, moves = self.segment(times, side)
        stays = self.values[key]
        if self.path == "rotation" and self.interpolation == "CUBICSPLINE":
            stays = unit(stays)
        if not moves.any():
            return stays
        key = np.where(moves, key, 0)
        share = self.share(times, key)[..., None]
        if self.interpolation == "CUBICSPLINE":
            points = self.points(key)
            while len(points) > 1:
                points = [between(a, b, share) for a, b in zip(points, points[1:])]
            moved = unit(points[0]) if self.path == "rotation" else points[0]
        elif self.path == "rotation":
            angle = self.angles[key][..., None]
            left = 1 - share
            whole = sinc(angle)
            moved = self.values[key] * (left * sinc(left * angle) / whole) + self.ends[key] * (share * sinc(share * angle) / whole)
        else:
            moved = between(self.values[key], self.values[key + 1], share)
        return where(moves[:, None], moved, stays)

    def length(self, x):
        """How long a value is: of a scale, how much it stretches; of weights, each for itself."""
        if self.path == "weights":
            return x.magnitude()
        return x.magnitude().max(axis=-1) if self.path == "scale" else norm(x).high

    def motion(self, start, end):
        """From each start to its end, between which there are no keys (lemmas/c2, c3). By time; of weights by time and target."""
        key, moves = self.segment(start, "after")
        size = np.ones(len(start)) if self.path == "rotation" else self.length(self.values[key])
        if not moves.any():
            return Motion(size)
        key = np.where(moves, key, 0)
        duration = Interval(self.times[key + 1]) - self.times[key]
        along = duration[..., None] if self.path == "weights" else duration
        if self.interpolation == "CUBICSPLINE":
            moved = self.spline_motion(key, start, end, duration[..., None])
        elif self.path == "rotation":
            speed = (self.angles[key] / duration).high
            moved = Motion(1.0, speed, above(speed * speed))
        else:
            a, b = self.values[key], self.values[key + 1]
            moved = Motion(np.maximum(self.length(a), self.length(b)), (Interval(self.length(b - a)) / along).high)
        moves = moves[:, None] if self.path == "weights" else moves
        return Motion(np.where(moves, moved.size, size), np.where(moves, moved.speed, 0), np.where(moves, moved.acceleration, 0))

    def spline_motion(self, key, start, end, duration):
        """By the Bezier points of the parts from start to end, of the curve and of its derivatives."""
        low, high = self.share(start, key)[..., None], self.share(end, key)[..., None]
        curve = self.points(key)
        velocities = [(b - a) * 3.0 / duration for a, b in zip(curve, curve[1:])]
        accelerations = [(b - a) * 2.0 / duration for a, b in zip(velocities, velocities[1:])]
        hulls = [part_of(points, low, high) for points in (curve, velocities, accelerations)]
        longest = Motion(*(np.max([self.length(point) for point in hull], axis=0) for hull in hulls))
        return normalized(longest, least_length(hulls[0])) if self.path == "rotation" else longest


def part_of(points, low, high):
    """The points of the part of a Bezier curve between two shares, by its polar form."""
    def polar(shares):
        left = points
        for share in shares:
            left = [between(a, b, share) for a, b in zip(left, left[1:])]
        return left[0]
    degree = len(points) - 1
    return [polar([low] * (degree - i) + [high] * i) for i in range(degree + 1)]


def least_length(points):
    """How long the curve's points are at least: as far as all Bezier points are along an axis. Any will do, and the best one is
    the nearest point of their hull, to which some steps lead."""
    ends = np.stack([point.low for point in points])
    axis, best = ends[0] + ends[-1], -np.inf
    for _ in range(AXES):
        along = np.min([dot(point, Interval(axis)).low for point in points], axis=0)
        length = norm(axis).high
        best = np.maximum(best, below(np.divide(along, length, out=np.full_like(along, -np.inf), where=length > 0)))
        products = (ends * axis).sum(axis=-1)
        towards = np.take_along_axis(ends, np.argmin(products, axis=0)[None, :, None], axis=0)[0] - axis
        squared = (towards ** 2).sum(axis=-1)
        share = np.divide(-(axis * towards).sum(axis=-1), squared, out=np.zeros_like(squared), where=squared > 0)
        axis = axis + np.clip(share, 0, 1)[:, None] * towards
    return best
