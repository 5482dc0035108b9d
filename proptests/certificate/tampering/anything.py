# SPDX-License-Identifier: GPL-3.0-or-later
"""What certificates of all kinds can be tampered with. Each function returns a text, or None where it cannot."""
import copy
import hashlib
import json


def sealed(document):
    """With the digest that fits: a forger can do that too."""
    text = lambda: json.dumps(document, indent=1, sort_keys=True) + "\n"
    document["digest"] = ""
    document["digest"] = hashlib.sha256(text().encode()).hexdigest()
    return text()


def changed_digest(d, r):
    d["about"] += " "
    return json.dumps(d, indent=1, sort_keys=True) + "\n"


def changed_bytes(d, r):
    text = sealed(d)
    at = r.randrange(len(text))
    return r.choice([text[:at] + text[at + 1:], text[:at], text[:at] + r.choice("0123456789\"-/,[]{} \n") + text[at:]])


def other_layout(d, r):
    return json.dumps(json.loads(sealed(d)), indent=r.choice([None, 2]), sort_keys=True) + "\n"


def half_a_character(d, r):
    d["about"] += r.choice(["\udc00", "\udfff.", "\ud800", "\udbff."])
    return sealed(d)


# What none may accept.
FALSE = [changed_digest, changed_bytes, other_layout, half_a_character]


def changed_value(d, r):  # anything anywhere, with the digest that fits: false or not
    change_value(d, r)
    return sealed(d)


def change_value(d, r):
    place = d
    while True:
        key = r.choice(list(place)) if isinstance(place, dict) else r.randrange(len(place))
        if isinstance(place[key], (dict, list)) and place[key] and r.random() < 0.8:
            place = place[key]
            continue
        others = [None, True, 0, -1, 1.5, "", "1/0", "0/1", "-1", "1/3", "1e3", "\u00e9", "\U0001f600", "\udc00", [], {}, "7" * 401, ["1", "2", "3"], ["1/2", "0", "-1/3"]]
        place[key] = copy.deepcopy(r.choice(others))
        return
