# SPDX-License-Identifier: GPL-3.0-or-later
"""Binary glTF 2.0: the description, the numbers of its accessors and its chunks. Files beside it are not read."""
import base64
import json
import math
import struct

import numpy as np

from .interval import Interval, above, below
from .rejected import require

MOST_NUMBERS = 2 ** 26
JSON_CHUNK, BINARY_CHUNK = 0x4E4F534A, 0x004E4942
COMPONENTS = {5120: np.dtype("<i1"), 5121: np.dtype("<u1"), 5122: np.dtype("<i2"), 5123: np.dtype("<u2"),
              5125: np.dtype("<u4"), 5126: np.dtype("<f4")}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
# What a file may require: how a surface looks, lights, and positions as integers.
READABLE = ("KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_", "EXT_lights_", "KHR_xmp", "KHR_mesh_quantization")


def unique_members(pairs):
    members = dict(pairs)
    require(len(members) == len(pairs), "an object of JSON has a member twice")
    return members


def member(value, name, kind, otherwise=None):
    """value[name], which has to be of the kind; if it is not there and there is another value for that, this one."""
    if name not in value and otherwise is not None:
        return otherwise
    found = value.get(name)
    if kind is int and type(found) is float and found.is_integer():
        found = int(found)  # JSON has one type of numbers
    require(type(found) is kind or (kind is float and type(found) is int), f"'{name}' of the file is no {kind.__name__}")
    return found


def items(value, name, kind, otherwise=None):
    """The list value[name], whose items have to be of the kind."""
    found = member(value, name, list, otherwise)
    return [member({name: item}, name, kind) for item in found]


def index(value, name, count, otherwise=None):
    found = member(value, name, int, otherwise)
    require(found == otherwise or 0 <= found < count, f"'{name}' of the file is out of range")
    return found


def chunks_of(data):
    require(len(data) >= 12, "the file is no binary glTF")
    magic, version, size = struct.unpack_from("<4sII", data)
    require(magic == b"glTF" and version == 2 and size == len(data), "the file is no whole binary glTF 2")
    at, chunks = 12, []
    while at < size:
        require(at + 8 <= size, "the file ends in the header of a chunk")
        length, kind = struct.unpack_from("<II", data, at)
        require(at + 8 + length <= size, "the file ends in a chunk")
        chunks.append((kind, data[at + 8:at + 8 + length]))
        at += 8 + length
    require(chunks and chunks[0][0] == JSON_CHUNK, "the file does not begin with JSON")
    require(not chunks[0][1].startswith(b"\xef\xbb\xbf"), "the file's JSON begins with a byte order mark, which is to be left out")
    return chunks


class Glb:
    """description, and the numbers of accessors as intervals of shape (rows, width): integers that are normalised are
    quotients, which doubles may not have."""

    def __init__(self, data):
        self.chunks = chunks_of(data)
        self.description = json.loads(self.chunks[0][1].decode(), object_pairs_hook=unique_members)
        require(type(self.description) is dict, "the file's description is no object")
        for name in items(self.description, "extensionsRequired", str, []):
            require(name.startswith(READABLE), f"the file requires {json.dumps(name)[:80]}, which is not read")
        self.views, self.accessors = self.list("bufferViews"), self.list("accessors")
        self.buffers = [self.buffer_bytes(i, buffer) for i, buffer in enumerate(self.list("buffers"))]
        self.size, self.numbers_read = len(data), 0

    def list(self, name):
        return items(self.description, name, dict, [])

    def buffer_bytes(self, i, buffer):
        if "uri" in buffer:
            uri = member(buffer, "uri", str)
            require(uri.startswith("data:") and ";base64," in uri[:100], "the file refers to another file")
            return base64.b64decode(uri.split(";base64,", 1)[1], validate=True)
        require(i == 0 and len(self.chunks) > 1 and self.chunks[1][0] == BINARY_CHUNK, "the file has a buffer without bytes")
        return self.chunks[1][1]

    def rows(self, place, count, width, component):
        """Rows of numbers from a buffer view, by an accessor or a part of a sparse one."""
        view = self.views[index(place, "bufferView", len(self.views))]
        data = self.buffers[index(view, "buffer", len(self.buffers))]
        first, length = member(view, "byteOffset", int, 0), member(view, "byteLength", int)
        offset, dtype = member(place, "byteOffset", int, 0), COMPONENTS[component]
        stride = member(view, "byteStride", int, 0) or width * dtype.itemsize
        need = (count - 1) * stride + width * dtype.itemsize if count > 0 else 0
        require(min(first, offset, length, stride) >= 0 and first + length <= len(data) and offset + need <= length,
                "an accessor of the file reaches past the end of its buffer view")
        return np.ndarray((count, width), dtype, data, first + offset, (stride, dtype.itemsize))

    def raw(self, number, shape, integers_only=False):
        """The rows as they are stored, and whether they are normalised."""
        require(type(number) is int and 0 <= number < len(self.accessors), "an accessor is not there")
        accessor = self.accessors[number]
        component, count, width = member(accessor, "componentType", int), member(accessor, "count", int), WIDTHS[shape]
        require(component in COMPONENTS and member(accessor, "type", str) == shape, f"an accessor of the file is no {shape}")
        normalized = member(accessor, "normalized", bool, False)
        require(not integers_only or (component in (5121, 5123, 5125) and not normalized), "an accessor is not of indices")
        require(not (normalized and component in (5125, 5126)), "an accessor of numbers that cannot be normalised is")
        require(0 <= count and ("bufferView" in accessor or count <= self.size), "an accessor's count is out of range")
        self.numbers_read += count * width  # what is sparse may have more of them than the file has bytes
        require(self.numbers_read <= MOST_NUMBERS, f"the file has more than {MOST_NUMBERS} numbers")
        values = (self.rows(accessor, count, width, component) if "bufferView" in accessor
                  else np.zeros((count, width), COMPONENTS[component]))
        if "sparse" in accessor:
            sparse = member(accessor, "sparse", dict)
            places, parts = member(sparse, "indices", dict), member(sparse, "values", dict)
            many, kind = member(sparse, "count", int), member(places, "componentType", int)
            require(kind in (5121, 5123, 5125) and 0 <= many <= count, "a sparse accessor's indices are no indices")
            at = self.rows(places, many, 1, kind)[:, 0].astype(np.int64)
            require(np.all(at < count) and np.all(np.diff(at) > 0), "a sparse accessor's indices are out of range or order")
            values = values.copy()
            values[at] = self.rows(parts, many, width, component)
        return values, normalized

    def numbers(self, accessor, shape):
        values, normalized = self.raw(accessor, shape)
        as_double = values.astype(float)
        require(np.all(np.isfinite(as_double)), "a number of the file is not finite")
        if not normalized:
            return Interval(as_double)
        greatest = float(np.iinfo(values.dtype).max)
        quotient = np.maximum(as_double / greatest, -1.0)
        is_exact = np.isin(quotient, (-1.0, 0.0, 1.0))
        return Interval(np.where(is_exact, quotient, below(quotient)), np.where(is_exact, quotient, above(quotient)))

    def indices(self, accessor, shape="SCALAR"):
        return self.raw(accessor, shape, integers_only=True)[0].astype(np.int64)


def finite_numbers(value, name, count, otherwise=None):
    """A list of so many numbers in the description."""
    numbers = [float(x) for x in items(value, name, float, otherwise)]
    require(len(numbers) == count and all(map(math.isfinite, numbers)), f"'{name}' of the file is no list of {count} numbers")
    return numbers
