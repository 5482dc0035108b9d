# SPDX-License-Identifier: GPL-3.0-or-later
"""What a certificate of bounds over time says: algorithms/program/clip_certificate.hpp has the format."""
import json
import re

import numpy as np

from .glb import unique_members
from .rejected import require

MEMBERS = {"whole": {}, "skin": {"skin": int}, "mesh": {"mesh": int}, "primitive": {"node": int, "mesh": int, "primitive": int},
           "cluster": {"node": int, "mesh": int, "primitive": int, "triangles": list}}


def read(value, shape, what):
    """The value, if it is an object that has these members and no others."""
    require(type(value) is dict and value.keys() == shape.keys(), f"{what} has not the members {', '.join(shape)}")
    for name, kind in shape.items():
        require(type(value[name]) is kind, f"{what}.{name} is no {kind.__name__}")
    return value


def integers(values, what):
    require(values and all(type(v) is int for v in values), f"{what} is no list of integers")
    return values


def numbers(values, shape, what):
    """An array of the shape; -1 in it for any length but 0."""
    require(type(values) is list and values, f"{what} is no list of something")
    if len(shape) > 1:
        require(all(type(row) is list and len(row) == shape[1] for row in values), f"{what} is no list of {shape[1]} numbers each")
    flat = values if len(shape) == 1 else [x for row in values for x in row]
    require(all(type(x) in (int, float) for x in flat), f"{what} has what is no number")
    array = np.array(flat, float).reshape(-1, *shape[1:])
    require(shape[0] in (-1, len(array)) and np.all(np.isfinite(array)), f"{what} has not {shape[0]} finite numbers")
    return array


def read_thing(thing, what):
    kind = thing.get("kind") if type(thing) is dict else None
    require(type(kind) is str and kind in MEMBERS, f"{what} is of no kind that there is")
    read(thing, {"kind": str, **MEMBERS[kind]}, what)
    if kind == "cluster":
        integers(thing["triangles"], what + ".triangles")
    return thing


def read_directions(directions):
    """Of slabs beyond the axes; each of -1, 0 and 1."""
    for d in directions:
        require(type(d) is list and len(d) == 3 and all(type(x) is int and abs(x) <= 1 for x in d) and any(d),
                "certificate.directions has what is no direction")
    return directions


def read_slabs(slabs, count, what):
    """(count, 2)"""
    return numbers(slabs, (count, 2), what) if count or slabs else np.empty((0, 2))


def read_bound(bound, slab_count, what):
    read(bound, {"ball": list, "ball_intervals": list, "box": list, "box_intervals": list, "slabs": list}, what)
    return {"ball": numbers(bound["ball"], (4,), what + ".ball"), "box": numbers(bound["box"], (6,), what + ".box"),
            "slabs": read_slabs(bound["slabs"], slab_count, what + ".slabs"),
            **{name: numbers(bound[name], (-1, 3), f"{what}.{name}") for name in ("ball_intervals", "box_intervals")}}


def integer(text):
    require(len(text) < 20, "an integer has too many digits")
    return int(text)


def no_constant(text):
    require(False, f"{text} is no number of JSON")


def read_certificate(text):
    """Parts, each a list of things of the file, and clips, each with a bound by part."""
    document = json.loads(text, parse_int=integer, parse_constant=no_constant, object_pairs_hook=unique_members)
    read(document, {"clips": list, "directions": list, "file": str, "parts": list, "skinning": str, "version": int}, "certificate")
    require(document["version"] == 2 and document["skinning"] == "linear", "the certificate is not of version 2 and linear skinning")
    slab_count = len(read_directions(document["directions"]))
    require(re.fullmatch("[0-9a-f]{64}", document["file"]), "certificate.file is no SHA-256")
    require(document["parts"] and document["clips"], "the certificate has no parts or no clips")
    for p, part in enumerate(document["parts"]):
        require(type(part) is list and part, f"parts[{p}] is no list of something")
        for i, thing in enumerate(part):
            read_thing(thing, f"parts[{p}][{i}]")
    for c, clip in enumerate(document["clips"]):
        read(clip, {"animation": int, "bounds": list, "duration": type(clip.get("duration")) if type(clip) is dict else float},
             f"clips[{c}]")
        clip["duration"] = float(numbers([clip["duration"]], (1,), f"clips[{c}].duration")[0])
        require(len(clip["bounds"]) == len(document["parts"]), f"clips[{c}] has not a bound for each part")
        clip["bounds"] = [read_bound(bound, slab_count, f"clips[{c}].bounds[{b}]") for b, bound in enumerate(clip["bounds"])]
    animations = [clip["animation"] for clip in document["clips"]]
    require(len(set(animations)) == len(animations), "an animation has two clips")
    return document
