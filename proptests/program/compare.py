# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares a glTF file with what `refitlab bake` made of it: nothing but the extras and the chunk of refitlab may differ.

usage: compare.py IN.glb OUT.glb SCHEMA.json
"""
import json
import struct
import sys

import jsonschema


def chunks_of(path):
    data = open(path, "rb").read()
    magic, version, size = struct.unpack_from("<III", data)
    assert (magic, version, size) == (0x46546C67, 2, len(data)), path
    at, chunks = 12, []
    while at < size:
        length, kind = struct.unpack_from("<II", data, at)
        chunks.append((kind, data[at + 8:at + 8 + length]))
        at += 8 + length
    return chunks


def without_bounds(text):
    """The JSON text without the members that were added, found by what comes before them."""
    key, out = '"refitlab":', text
    while (at := out.find(key)) >= 0:
        decoder = json.JSONDecoder()
        _, end = decoder.raw_decode(out, at + len(key))
        start = at
        wrapped = out[:at].endswith('"extras":{') and out[end] == "}"
        if wrapped:
            start, end = at - len('"extras":{'), end + 1
        if out[start - 1] == ",":
            start -= 1
        out = out[:start] + out[end:]
    return out


def main():
    before, after = chunks_of(sys.argv[1]), chunks_of(sys.argv[2])
    schema = json.load(open(sys.argv[3]))
    assert before[0][1].decode().rstrip() == without_bounds(after[0][1].decode()).rstrip(), "the JSON changed elsewhere"
    assert before[1:] == after[1:-1] and after[-1][0] == 0x424C4652, "a chunk changed"
    document, bounds = json.loads(after[0][1]), 0
    things = [thing for kind in ("skins", "meshes", "animations") for thing in document.get(kind, [])]
    things += [primitive for mesh in document.get("meshes", []) for primitive in mesh["primitives"]]
    for thing in things:
        if (found := thing.get("extras", {}).get("refitlab")) is not None:
            jsonschema.validate(found, schema)
            # The schema is not content with just anything.
            for wrong in ({"ball": [*found["ball"][:3], -1]}, {"box": found["box"][:5]}, {"tolerance": 7}, {"unknown": 0},
                          {"any_pose": {"node": 0, "radius": -1}}):
                assert not jsonschema.Draft7Validator(schema).is_valid({**found, **wrong}), f"{wrong} is valid"
            bounds += 1
    assert bounds >= len(document.get("animations", [])) + 1, "bounds are missing"
    print(f"{sys.argv[2]}: {bounds} objects have bounds; every other byte is as it was")


main()
