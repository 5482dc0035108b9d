# SPDX-License-Identifier: GPL-3.0-or-later
"""Intervals of doubles, whole arrays of them at a time, rounded outward after every operation.

IEEE 754 rounds the result of + - * / and of the square root to the nearest double, so the exact one is between the neighbours
of what is computed. What is undefined becomes NaN, and no comparison with NaN holds: every check says what must hold.
"""
import numpy as np


def above(x):
    return np.nextafter(x, np.inf)


def below(x):
    return np.nextafter(x, -np.inf)


class Interval:
    """The numbers from low to high, by element."""
    __array_ufunc__ = None  # so that numpy leaves mixed operations to this class

    def __init__(self, low, high=None):
        self.low = np.asarray(low, dtype=float)
        self.high = self.low if high is None else np.asarray(high, dtype=float)

    def __add__(self, other):
        other = interval(other)
        return Interval(below(self.low + other.low), above(self.high + other.high))

    def __neg__(self):
        return Interval(-self.high, -self.low)

    def __sub__(self, other):
        return self + -interval(other)

    def __rsub__(self, other):
        return interval(other) - self

    def __mul__(self, other):
        other = interval(other)
        products = self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high
        least, greatest = products[0], products[0]
        for product in products[1:]:
            least, greatest = np.minimum(least, product), np.maximum(greatest, product)
        return Interval(below(least), above(greatest))

    __radd__, __rmul__ = __add__, __mul__

    def __truediv__(self, other):
        other = interval(other)
        is_apart = (other.low > 0) | (other.high < 0)  # from 0
        return self * Interval(np.where(is_apart, below(1 / other.high), -np.inf), np.where(is_apart, above(1 / other.low), np.inf))

    def __rtruediv__(self, other):
        return interval(other) / self

    def __getitem__(self, key):
        return Interval(self.low[key], self.high[key])

    def squared(self):
        least = np.where((self.low <= 0) & (self.high >= 0), 0, np.minimum(np.abs(self.low), np.abs(self.high)))
        greatest = np.maximum(np.abs(self.low), np.abs(self.high))
        return Interval(np.maximum(below(least * least), 0), above(greatest * greatest))

    def root(self):
        """Of what is not negative, but for rounding."""
        return Interval(np.maximum(below(np.sqrt(np.maximum(self.low, 0))), 0), above(np.sqrt(self.high)))

    def magnitude(self):
        """The greatest absolute value, a double."""
        return np.maximum(np.abs(self.low), np.abs(self.high))

    def middle_and_error(self):
        """A double, and how far the numbers are from it at most."""
        middle = self.low + (self.high - self.low) / 2
        return middle, above(np.maximum(self.high - middle, middle - self.low))


def interval(x):
    return x if isinstance(x, Interval) else Interval(x)


def where(condition, a, b):
    return Interval(np.where(condition, a.low, b.low), np.where(condition, a.high, b.high))


def stack(intervals, axis=-1):
    parts = np.broadcast_arrays(*[i.low for i in intervals]), np.broadcast_arrays(*[i.high for i in intervals])
    return Interval(*(np.stack(part, axis) for part in parts))


def dot(a, b):
    """Along the last axis."""
    products = interval(a) * b
    total = products[..., 0]
    for i in range(1, products.low.shape[-1]):
        total = total + products[..., i]
    return total


def norm(a):
    """Of vectors along the last axis."""
    squares = interval(a).squared()
    total = squares[..., 0]
    for i in range(1, squares.low.shape[-1]):
        total = total + squares[..., i]
    return total.root()
