# SPDX-License-Identifier: GPL-3.0-or-later
"""The reason why a certificate is not accepted."""


class Rejected(Exception):
    pass


def require(condition, reason):
    if not condition:
        raise Rejected(reason)
