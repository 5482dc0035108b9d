# SPDX-License-Identifier: GPL-3.0-or-later
"""How long, how fast and how bent curves are at most: ||f||, ||f'|| and ||f''||, rounded upward; arrays of doubles.

The statements are those of the lemmas c1 to c4: products of curves obey the rule of Leibniz, a curve is near its chord.
"""
import numpy as np

from .interval import above


def plus(a, b):
    return above(a + b)


def times(a, b):
    return above(a * b)


class Motion:
    def __init__(self, size, speed=0.0, acceleration=0.0):
        self.size, self.speed, self.acceleration = np.broadcast_arrays(*(np.asarray(x, float) for x in (size, speed, acceleration)))

    def __add__(self, other):
        return Motion(plus(self.size, other.size), plus(self.speed, other.speed), plus(self.acceleration, other.acceleration))

    def __mul__(self, other):
        """Of a product that is linear in both and whose length is at most the product of the lengths."""
        crossed = times(2.0, times(self.speed, other.speed))
        bent = plus(times(self.acceleration, other.size), times(self.size, other.acceleration))
        return Motion(times(self.size, other.size), plus(times(self.speed, other.size), times(self.size, other.speed)),
                      plus(bent, crossed))

    def __getitem__(self, key):
        return Motion(self.size[key], self.speed[key], self.acceleration[key])

    def slack(self, duration):
        """How far the curve is from its chord at most (lemmas/c1), over so long a time."""
        bent = times(times(self.acceleration, times(duration, duration)), 0.125)
        return np.minimum(bent, times(times(self.speed, duration), 0.5))


def normalized(blend, least):
    """Of p / ||p||, where p moves within blend and ||p|| >= least (lemmas/c3); without a bound where least is not positive."""
    is_known = least > 0
    turn = above(np.divide(blend.speed, least, out=np.full_like(blend.speed, np.inf), where=is_known))
    bend = above(np.divide(blend.acceleration, least, out=np.full_like(blend.speed, np.inf), where=is_known))
    return Motion(1.0, turn, plus(bend, times(37 / 32, times(turn, turn))))


class Chain:
    """What a chain of nodes does to a point x: it goes to A x + b (lemmas/c4)."""

    def __init__(self, linear, offset):
        self.linear, self.offset = linear, offset

    def __matmul__(self, inner):
        return Chain(self.linear * inner.linear, self.linear * inner.offset + self.offset)

    def carried(self, point):
        return self.linear * point + self.offset
