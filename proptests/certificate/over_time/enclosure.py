# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether boxes and balls hold vertices throughout an animation: at the ends of intervals, blown up by what a vertex may be off the
chord between them (lemmas/c1, c4, c5, c6)."""
import numpy as np

from .interval import Interval, above, norm, stack
from .motion import Chain, Motion, times
from .nodes import AnimatedNodes, animation_of, product
from .rejected import require

UNIT = 2.0 ** -53  # what a sum or product is off at most, relative to itself
DENORMAL = 2.0 ** -1074  # or what it is off at most by underflow
BATCH = 50000  # numbers that are handled at a time
# By what share the checker's slack may be above the certificate's, which is not rounded upward; and how great one may be that the
# certificate says is 0, relative to the length of what moves. What is used is the greater of both.
SLACK_ROUNDING, SMALLEST_SLACK = 2.0 ** -20, 2.0 ** -40


class PartVertices:
    """The vertices of a part, its influences and displacements, by positions among these vertices."""

    def __init__(self, vertices, chosen):
        position = np.full(vertices.count, -1)
        position[chosen] = np.arange(len(chosen))
        self.count = len(chosen)
        self.positions = vertices.positions.middle_and_error()[0][chosen]

        def of_part(owner, other, value):
            mine = position[owner] >= 0
            return position[owner[mine]], other[mine], value[mine]
        self.vertex, self.joint, weight = of_part(*vertices.influences)
        self.weight = weight.middle_and_error()[0]
        self.moved, self.target, displacement = of_part(*vertices.displacements)
        self.displacement = displacement.middle_and_error()[0]
        # By row, of a joint and those vertices that the same joints move: how far these are from the joint's frame, and how long
        # their displacements are there, at most. Rows of light weights come last.
        heavy = vertices.is_heavy[position[vertices.influences[0]] >= 0]
        matrices = np.array([matrix for _, matrix in vertices.joints])
        key = (vertices.joint_sets[chosen][self.vertex] + np.where(heavy, 0, vertices.count)) * len(matrices) + self.joint
        keys, row = np.unique(key, return_inverse=True)
        self.joints, self.heavy_rows = keys % len(matrices), int(np.sum(keys < vertices.count * len(matrices)))
        self.light_share = np.bincount(self.vertex, np.where(heavy, 0, weight.high)).max() * 1.001
        self.distances = np.zeros(len(keys))
        np.maximum.at(self.distances, row, lengths_in_frames(
            matrices[self.joint], vertices.positions[chosen][self.vertex], 1.0))
        self.lengths = {}  # by target
        for target in np.unique(self.target):
            rows = np.full(self.count, -1)
            mine = np.nonzero(self.target == target)[0]
            rows[self.moved[mine]] = mine
            pairs = np.nonzero(rows[self.vertex] >= 0)[0]
            length = np.zeros(len(keys))
            np.maximum.at(length, row[pairs], lengths_in_frames(
                matrices[self.joint[pairs]], displacement[rows[self.vertex[pairs]]], 0.0))
            self.lengths[int(target)] = length

    def below(self, weights):
        """How the vertices move in the frames of joints, (rows, intervals), by the weights of targets (lemmas/a3)."""
        out = Motion(self.distances[:, None])
        for target, lengths in self.lengths.items():
            out = out + weights[target] * Motion(lengths[:, None])
        return out

    def slacks(self, moved, duration):
        """How far a vertex may be off its chord, if it is moved by its joints but the light ones; and what these add. However fast
        it moves, both are no farther from the scene's origin than it ever is."""
        slacks = np.minimum(moved.slack(duration), times(2.0, moved.size))
        light = slacks[self.heavy_rows:].max(axis=0, initial=0.0) * self.light_share
        return slacks[:self.heavy_rows].max(axis=0), above(light)

    def placed(self, matrices, weights):
        """x, y and z of the vertices, each (times, vertices), by matrices (times, joints, 3, 4)."""
        v = np.broadcast_to(self.positions, (len(matrices), self.count, 3))
        if len(self.moved):
            first = np.nonzero(np.diff(self.moved, prepend=-1))[0]
            summed = np.add.reduceat(weights[:, self.target, None] * self.displacement, first, axis=1)
            v = v.copy()
            v[:, self.moved[first]] += summed
        first = np.nonzero(np.diff(self.vertex, prepend=-1))[0]
        x, y, z = (v[:, self.vertex, i] for i in range(3))
        for row in range(3):
            a, b, c, d = (matrices[:, self.joint, row, column] for column in range(4))
            yield np.add.reduceat(((a * x + b * y) + (c * z + d)) * self.weight, first, axis=1)


def lengths_in_frames(matrices, points, one):
    """Of the images of points, or of differences, by rows of matrices."""
    images = stack([Interval(matrices[:, r, 0]) * points[:, 0] + Interval(matrices[:, r, 1]) * points[:, 1] +
                    Interval(matrices[:, r, 2]) * points[:, 2] + Interval(matrices[:, r, 3] * one) for r in range(3)])
    return norm(images).high


class Clip:
    """An animation, or the rest pose, of all vertices of a file."""

    def __init__(self, glb, nodes, vertices, animation):
        self.vertices = vertices
        channels = animation_of(glb, nodes, animation)
        self.nodes = AnimatedNodes(nodes, channels, [node for node, _ in vertices.joints])
        self.weight_channels = [channels.get((node, "weights")) for node, _ in vertices.targets]
        moving = self.nodes.moving() + [channel for channel in self.weight_channels if channel]
        keys = np.unique(np.concatenate([[0.0], *(channel.times for channel in moving)]))
        self.keys = keys[keys >= 0]

    def require_covered(self, intervals, duration):
        """From 0 to the last key and to the duration, one after the other, none across a key."""
        start, end = intervals[:, 0], intervals[:, 1]
        require(start[0] == 0 and np.all(start[1:] == end[:-1]) and np.all(start <= end) and end[-1] == duration,
                "the intervals do not cover the clip, one after the other")
        require(self.keys[-1] <= duration, "a key is out of the time that the intervals cover")
        require(np.all(np.searchsorted(self.keys, end, "left") <= np.searchsorted(self.keys, start, "right")),
                "an interval goes across a key")

    def weights(self, times, side):
        """(times, targets)"""
        still = Interval(np.array(self.vertices.resting))
        columns = [channel.at(times, side)[:, t] if channel else Interval(np.full(len(times), still.low[i]))
                   for i, ((_, t), channel) in enumerate(zip(self.vertices.targets, self.weight_channels))]
        return stack(columns) if columns else Interval(np.empty((len(times), 0)))

    def weight_motions(self, start, end):
        return [channel.motion(start, end)[:, t] if channel else Motion(abs(self.vertices.resting[i]))
                for i, ((_, t), channel) in enumerate(zip(self.vertices.targets, self.weight_channels))]

    def posed(self, times, side):
        """Skin matrices (times, joints, 3, 4) and weights (times, targets) in doubles, and by time how far the vertices that they
        skin in doubles are off at most."""
        nodes = self.nodes.matrices(times, side)
        matrices = [product(nodes[node], Interval(offset[None])) for node, offset in self.vertices.joints]
        matrices = stack([Interval(*(np.broadcast_to(end, (len(times), 3, 4)) for end in (m.low, m.high))) for m in matrices], 1)
        middle, off = matrices.middle_and_error()
        weights, weights_off = self.weights(times, side).middle_and_error()
        # The greatest coordinates of vertices, and how far these are off; (times)
        positions, positions_off = self.vertices.positions.middle_and_error()
        greatest, greatest_off = np.abs(positions).max(), positions_off.max()
        longest, longest_off = np.zeros(weights.shape[1]), np.zeros(weights.shape[1])
        _, target, displacement = self.vertices.displacements
        for most, numbers in zip((longest, longest_off), (displacement.magnitude(), displacement.middle_and_error()[1])):
            np.maximum.at(most, target, numbers.max(axis=1))
        greatest = greatest + ((np.abs(weights) + weights_off) * longest).sum(axis=1)
        greatest_off = greatest_off + (weights_off * longest + np.abs(weights) * longest_off).sum(axis=1)
        # A product that underflows loses a denormal number, which a matrix may enlarge.
        greatest, greatest_off = (above(x + DENORMAL * (weights.shape[1] + 1)) for x in (greatest, greatest_off))
        # Of a coordinate, relative to what is summed up: 4 products and their sum, the displaced vertex, and the blend.
        rounding = 2 * UNIT * (np.bincount(self.vertices.influences[0]).max() + weights.shape[1] + 8)
        share, share_off = self.vertices.influences[2].middle_and_error()
        rounding += (share_off / share).max()
        rows, rows_off = (m[..., :3].sum(axis=-1) for m in (np.abs(middle), off))
        summed = (rows + rows_off) * greatest[:, None, None] + np.abs(middle[..., 3])
        summed_off = rows_off * greatest[:, None, None] + off[..., 3] + rows * greatest_off[:, None, None]
        error = summed_off.max(axis=(1, 2)) + rounding * summed.max(axis=(1, 2))
        # Three coordinates make less than 1.8 of one; that covers the rounding of the error, too. What matrices and the blend
        # lose by underflow is far less than 1e-290.
        return middle, weights, 1.8 * error + 1e-290

    def chains(self, start, end):
        """Of the joints' nodes, (joints, intervals)."""
        by_node = self.nodes.chains(start, end)

        def rows(of):
            return Motion(*(np.array([np.broadcast_to(getattr(of(by_node[node]), name), len(start))
                                      for node, _ in self.vertices.joints]) for name in ("size", "speed", "acceleration")))
        return Chain(rows(lambda chain: chain.linear), rows(lambda chain: chain.offset))


def require_enclosed(clip, parts, bounds, directions, duration):
    """bounds: by part; directions: of their slabs."""
    for bound in bounds:
        for kind in ("box", "ball"):
            clip.require_covered(bound[kind + "_intervals"], duration)
    lists = [bound[kind + "_intervals"] for bound in bounds for kind in ("box", "ball")]
    spans = np.unique(np.concatenate([intervals[:, :2] for intervals in lists]), axis=0)
    after = np.unique(np.concatenate([spans[:, 0], [0.0, duration]]))
    before = np.unique(spans[spans[:, 0] < spans[:, 1], 1])
    span_numbers = {tuple(span): i for i, span in enumerate(spans.tolist())}
    chains, weight_motions = clip.chains(spans[:, 0], spans[:, 1]), clip.weight_motions(spans[:, 0], spans[:, 1])
    posed = [clip.posed(after, "after")] + ([clip.posed(before, "before")] if len(before) else [])
    matrices, weights, errors = (np.concatenate(found) for found in zip(*posed))
    for number, (part, bound) in enumerate(zip(parts, bounds)):
        below_joints = part.below(weight_motions)
        for kind, excess in (("box", beyond_slabs), ("ball", beyond_ball)):
            start, end, stated = bound[kind + "_intervals"].T
            lasts = start < end
            span = np.array([span_numbers[key] for key in zip(start.tolist(), end.tolist())])
            own = Chain(chains.linear[part.joints][:, span], chains.offset[part.joints][:, span])
            moved = own.carried(below_joints[:, span] if below_joints.size.shape[1] > 1 else below_joints)
            slack, light = (np.where(lasts, slacks, 0.0) for slacks in part.slacks(moved, above(end - start)))
            require(np.all(slack <= stated * (1 + SLACK_ROUNDING) + moved.size.max(axis=0) * SMALLEST_SLACK),
                    f"part {number}: a slack of its {kind} is less than what its vertices may be off the chord")
            firsts = np.searchsorted(after, start)
            lates = np.where(lasts, len(after) + np.searchsorted(before, end), np.searchsorted(after, end))
            moments = np.unique(np.concatenate([firsts, lates, [len(after) - 1]]))  # what follows a jump at the end, too
            outside = np.full(len(errors), np.nan)
            step = max(1, BATCH // len(part.vertex))
            for i in range(0, len(moments), step):
                some = moments[i:i + step]
                outside[some] = excess(bound, directions, part.placed(matrices[some], weights[some])) + errors[some]
            worst = Interval(np.maximum(outside[firsts], outside[lates])) + (Interval(np.maximum(slack, stated)) + light)
            require(np.all(worst.high <= 0) and above(outside[len(after) - 1]) <= 0, f"part {number}: a vertex may leave its {kind}")


def beyond_slabs(bound, directions, placed):
    """How far the vertices are out of the box or a slab at most, by time; not more than 0 where all are inside."""
    out, box, placed = -np.inf, bound["box"], list(placed)
    for i, x in enumerate(placed):
        out = np.maximum(out, np.maximum(above(box[i] - x.min(axis=1)), above(x.max(axis=1) - box[i + 3])))
    for n, (low, high) in zip(directions, bound["slabs"]):
        terms = [x if sign > 0 else -x for sign, x in zip(n, placed) if sign]
        along, error = sum(terms[1:], terms[0]), 4 * UNIT * sum(np.abs(x) for x in terms).max(axis=1)
        length = above(np.sqrt(float(len(terms))))
        beyond = np.maximum(above(low - along.min(axis=1)), above(along.max(axis=1) - high))
        out = np.maximum(out, above(above(beyond + error) / length))
    return out


def beyond_ball(bound, _, placed):
    ball, squared = bound["ball"], 0.0
    for i, x in enumerate(placed):
        squared = squared + (x - ball[i]) ** 2
    # Squares lose less than 2^-1073 by underflow, all three of them.
    return above(np.sqrt(squared.max(axis=1)) * (1 + 8 * UNIT) + 2.0 ** -535 - ball[3])
