# SPDX-License-Identifier: GPL-3.0-or-later
"""The vertices that a glTF file shows, each with its joints and weights and the displacements of its morph targets.

The vertex of a skin is at sum_k w_k G_k B_k v, by the transforms G_k of the joints' nodes, the first three rows of the inverse
bind matrices B_k and weights that are divided by their sum; one without a skin is at G v. v is the position with the
displacements of the morph targets times their weights.
"""
import numpy as np

from .glb import finite_numbers, index, items, member
from .interval import Interval, stack, where
from .nodes import target_count
from .rejected import require


UNITS = 2.0 ** 24  # weights become so many parts of 1 in all


class Primitive:
    """As one node shows it. corners: the vertices of its triangles, of those that are not degenerate in every pose."""

    def __init__(self, node, mesh, number, skin, corners, is_kept):
        self.node, self.mesh, self.number, self.skin, self.corners, self.is_kept = node, mesh, number, skin, corners, is_kept


class Vertices:
    """positions: (V, 3). Influences: by pair of a vertex and a joint, in order of the vertex. Displacements: by pair of a vertex and
    a morph target, in order of the vertex. joints: pairs of a node and a matrix. targets: pairs of a node and its target."""

    def __init__(self, glb, nodes):
        self.glb, self.nodes = glb, nodes
        self.meshes, self.skins = glb.list("meshes"), glb.list("skins")
        self.joints, self.joint_numbers, self.targets, self.primitives, self.resting = [], {}, [], [], []
        tables, self.count = [], 0
        for n in nodes.shown:
            if "mesh" in nodes.list[n]:
                tables += self.read_shown(n)
        require(tables, "the file shows no mesh")
        self.positions = joined([table[0] for table in tables])
        self.influences = joined_pairs([table[1] for table in tables])  # vertex, joint, weight
        self.is_heavy = self.heavy_influences()
        self.joint_sets = self.sets_of_heavy(np.concatenate([table[3] for table in tables]))
        self.displacements = joined_pairs([table[2] for table in tables])  # vertex, target, displacement
        self.per_vertex = sum(np.bincount(pairs[0], minlength=self.count) for pairs in (self.influences, self.displacements))

    def heavy_influences(self):
        """Those whose joints have a weight after refitlab's rounding: each share of a vertex is rounded down to a multiple of a unit,
        and what is missing goes to the largest remainders, a unit each. Bounds are made for these joints, and the others only add to
        them. Whichever are taken for light, what is accepted is true."""
        vertex, joint, share = self.influences
        out = np.ones(len(vertex), bool)
        for v in np.unique(vertex[share.high < 1 / UNITS]):
            start, end = np.searchsorted(vertex, [v, v + 1])
            _, of_joint = np.unique(joint[start:end], return_inverse=True)
            exact = np.bincount(of_joint, share[start:end].middle_and_error()[0]) * UNITS
            units = np.floor(exact)
            units[np.argsort(units - exact, kind="stable")[:int(UNITS - units.sum())]] += 1
            out[start:end] = (units > 0)[of_joint]
        return out

    def sets_of_heavy(self, owner):
        """By vertex: the number of the set of joints that have a weight, and of the mesh that is morphed."""
        vertex, joint = self.influences[0][self.is_heavy], self.influences[1][self.is_heavy]
        order = np.lexsort((joint, vertex))
        ends = np.cumsum(np.bincount(vertex, minlength=self.count))
        joint, numbers, out = joint[order], {}, np.empty(self.count, np.int64)
        for v, (start, end) in enumerate(zip([0, *ends.tolist()], ends.tolist())):
            out[v] = numbers.setdefault((owner[v], joint[start:end].tobytes()), len(numbers))
        return out

    def read_shown(self, n):
        node = self.nodes.list[n]
        require("EXT_mesh_gpu_instancing" not in member(node, "extensions", dict, {}), "a node is shown in many places")
        mesh = index(node, "mesh", len(self.meshes))
        skin = index(node, "skin", len(self.skins)) if "skin" in node else -1
        count, first = target_count(self.meshes, node), len(self.targets)
        weights = node if "weights" in node else self.meshes[mesh]
        resting = finite_numbers(weights, "weights", count, [0.0] * count)
        joints = self.joints_of(n, skin)
        shown = []
        for p, primitive in enumerate(items(self.meshes[mesh], "primitives", dict)):
            corners = self.corners(primitive) if "POSITION" in member(primitive, "attributes", dict) else ()
            if len(corners):
                shown.append((p, primitive, corners))
        if not shown:
            return  # its weights move nothing
        self.targets += [(n, t) for t in range(count)]
        self.resting += resting
        for p, primitive, corners in shown:
            yield self.read_primitive(n, mesh, p, primitive, skin, corners, joints, first, count)

    def joints_of(self, n, skin):
        """The numbers of the skin's joints, or of the node alone."""
        if skin < 0:
            found = [(n, np.eye(4)[:3])]
        else:
            listed = items(self.skins[skin], "joints", int)
            require(listed and all(0 <= j < len(self.nodes.list) for j in listed), "a skin has a joint that is not there")
            matrices = np.broadcast_to(np.eye(4), (len(listed), 4, 4))
            if "inverseBindMatrices" in self.skins[skin]:
                read = self.glb.numbers(member(self.skins[skin], "inverseBindMatrices", int), "MAT4")
                require(np.all(read.low == read.high) and len(read.low) >= len(listed), "inverse bind matrices do not fit the joints")
                matrices = read.low[:len(listed)].reshape(-1, 4, 4).transpose(0, 2, 1)
            found = [(j, matrix[:3]) for j, matrix in zip(listed, matrices)]
        numbers = []
        for node, matrix in found:
            key = node, matrix.tobytes()
            if key not in self.joint_numbers:
                self.joint_numbers[key] = len(self.joints)
                self.joints.append((node, matrix))
            numbers.append(self.joint_numbers[key])
        return np.array(numbers)

    def corners(self, primitive):
        """(triangles, 3), of the primitive's vertices."""
        mode = member(primitive, "mode", int, 4)
        count = self.glb.accessors[index(member(primitive, "attributes", dict), "POSITION", len(self.glb.accessors))]
        count = member(count, "count", int)
        if "indices" in primitive:
            listed = self.glb.indices(member(primitive, "indices", int))[:, 0]
        else:
            require(0 <= count <= self.glb.size, "an accessor's count is out of range")
            listed = np.arange(count)
        require(np.all(listed < count), "an index names a vertex that is not there")
        if mode == 4:
            require(len(listed) % 3 == 0, "the corners of triangles are no multiple of three")
            return listed.reshape(-1, 3)
        require(0 <= mode <= 6, "a primitive has a mode that glTF has not")
        strip = np.arange(max(len(listed) - 2, 0))[:, None]
        if mode == 5:
            return listed[strip + (0, 1, 2)]
        return listed[np.concatenate([strip + (1, 2), 0 * strip], axis=1)] if mode == 6 else np.empty((0, 3), np.int64)

    def read_primitive(self, n, mesh, p, primitive, skin, corners, joints, first_target, target_count_):
        require("KHR_draco_mesh_compression" not in member(primitive, "extensions", dict, {}), "a primitive is compressed")
        attributes = member(primitive, "attributes", dict)
        positions = self.glb.numbers(member(attributes, "POSITION", int), "VEC3")
        bound, weights = self.influences_of(attributes, len(positions.low), skin, joints)
        targets = items(primitive, "targets", dict, [])
        require(len(targets) == target_count_, "primitives of a mesh have not as many morph targets")
        moved = [self.glb.numbers(member(t, "POSITION", int), "VEC3") if "POSITION" in t else None for t in targets]
        moved = [Interval(np.zeros_like(positions.low)) if m is None else m for m in moved]
        require(all(m.low.shape == positions.low.shape for m in moved), "a morph target does not fit the vertices")
        # Vertices that agree in all of that are one.
        rows = np.concatenate([positions.low, bound, weights.low, *(m.low for m in moved)], axis=1)
        used, inverse = np.unique(corners, return_inverse=True)
        _, kept, of_used = np.unique(rows[used], axis=0, return_index=True, return_inverse=True)
        kept, corners = used[kept], of_used[inverse].reshape(corners.shape)
        is_kept = (corners[:, 0] != corners[:, 1]) & (corners[:, 1] != corners[:, 2]) & (corners[:, 2] != corners[:, 0])
        self.primitives.append(Primitive(n, mesh, p, skin, corners + self.count, is_kept))
        has_weight = weights[kept].high > 0
        vertex, column = np.nonzero(has_weight)
        influences = vertex + self.count, bound[kept][vertex, column].astype(np.int64), weights[kept][vertex, column]
        displacements = np.empty(0, np.int64), np.empty(0, np.int64), Interval(np.empty((0, 3)))
        if moved:
            moved = stack([m[kept] for m in moved], 1)  # by vertex and target
            vertex, target = np.nonzero(np.any(moved.magnitude() > 0, axis=-1))
            displacements = vertex + self.count, target + first_target, moved[vertex, target]
        self.count += len(kept)
        return positions[kept], influences, displacements, np.full(len(kept), first_target if target_count_ else -1)

    def influences_of(self, attributes, count, skin, joints):
        """By vertex and column: the joint's number and its share of the weights; a share of 0 is of no joint."""
        if skin < 0:
            return np.full((count, 1), float(joints[0])), Interval(np.ones((count, 1)))
        listed, weights = [], []
        while f"JOINTS_{len(listed)}" in attributes:
            name = f"_{len(listed)}"
            listed.append(self.glb.indices(member(attributes, "JOINTS" + name, int), "VEC4"))
            weights.append(self.glb.numbers(member(attributes, "WEIGHTS" + name, int), "VEC4"))
            require(len(listed[-1]) == len(weights[-1].low) == count, "joints and weights do not fit the vertices")
        require(listed, "a primitive of a skin has no joints")
        listed = np.concatenate(listed, axis=1)
        weights = Interval(*(np.concatenate(ends, axis=1) for ends in ([w.low for w in weights], [w.high for w in weights])))
        require(np.all(weights.low >= 0), "a weight is negative")
        # In the order of the joints, so that neither the slots of a vertex nor the sum of its weights depend on that of the file.
        order = np.argsort(np.where(weights.high > 0, listed, len(joints)), axis=1, kind="stable")
        listed = np.take_along_axis(listed, order, axis=1)
        weights = Interval(*(np.take_along_axis(end, order, axis=1) for end in (weights.low, weights.high)))
        has_weight = weights.high > 0
        require(np.all(has_weight.any(axis=1)), "a vertex has no weight")
        require(np.all(listed[has_weight] < len(joints)), "a joint of a vertex is not there")
        total = weights[:, 0]
        for k in range(1, listed.shape[1]):
            total = total + weights[:, k]
        share = where(has_weight, weights / total[:, None], Interval(0.0))
        return np.where(has_weight, joints[np.where(has_weight, listed, 0)], 0).astype(float), share

    def placings_of(self, chosen):
        """How many placings of a vertex by a joint or a displacement there are of these."""
        return int(self.per_vertex[chosen].sum())

    def vertices_of(self, things):
        """The vertices of parts of the file, each of which has some."""
        found = []
        for thing in things:
            primitives = [p for p in self.primitives if is_part_of(p, thing)]
            if thing["kind"] == "cluster":
                require(len(primitives) == 1, "a cluster is of no primitive")
                listed = np.array(thing["triangles"])
                require(np.all((listed >= 0) & (listed < len(primitives[0].corners))), "a cluster's triangle is not there")
                corners = [primitives[0].corners[listed][primitives[0].is_kept[listed]]]
            else:
                corners = [p.corners[p.is_kept] for p in primitives]
            require(sum(map(len, corners)), f"a part, {thing['kind']}, has no triangles")
            found += [c.ravel() for c in corners]
        return np.unique(np.concatenate(found))


def is_part_of(primitive, thing):
    if thing["kind"] == "skin":
        return primitive.skin == thing["skin"]
    if thing["kind"] == "mesh":
        return primitive.mesh == thing["mesh"]
    return thing["kind"] == "whole" or (
        primitive.node, primitive.mesh, primitive.number) == (thing["node"], thing["mesh"], thing["primitive"])


def joined(intervals):
    return Interval(*(np.concatenate(ends) for ends in ([i.low for i in intervals], [i.high for i in intervals])))


def joined_pairs(tables):
    return (*(np.concatenate([table[i] for table in tables]) for i in range(2)), joined([table[2] for table in tables]))
