# SPDX-License-Identifier: GPL-3.0-or-later
"""The arithmetic of what is published: pure functions of numbers, without files and without text."""
import math
from collections import namedtuple


def mean(values):
    """Returns the arithmetic mean of at least one number."""
    values = list(values)
    if not values:
        raise ValueError("the mean of no numbers")
    return sum(values) / len(values)


Span = namedtuple("Span", "least most")


def span(values):
    """Returns the least and the largest of at least one number."""
    values = list(values)
    return Span(min(values), max(values))


def weighted_mean(values, weights):
    """Returns the mean with these weights, of which at least one is positive and none negative."""
    values, weights = list(values), list(weights)
    if any(w < 0 for w in weights) or sum(weights) == 0:
        raise ValueError("weights are positive or 0, and not all of them 0")
    return sum(v * w for v, w in zip(values, weights, strict=True)) / sum(weights)


def fitted_exponent(points):
    """Returns e of the least-squares fit of a x^e to y through the logarithms of points (x, y), all positive, with two x at
    least."""
    points = list(points)
    if len({x for x, _ in points}) < 2 or any(x <= 0 or y <= 0 for x, y in points):
        raise ValueError("an exponent is fitted to positive points with two different x at least")
    n = len(points)
    logs = [(math.log(x), math.log(y)) for x, y in points]
    x, y = sum(a for a, _ in logs), sum(b for _, b in logs)
    xx, xy = sum(a * a for a, _ in logs), sum(a * b for a, b in logs)
    return (n * xy - x * y) / (n * xx - x * x)


def is_on_cut(point, points):
    """Returns whether no other (cost, ratio) costs as little and has a smaller ratio."""
    cost, ratio = point
    return not any(c <= cost and r < ratio for c, r in points)
