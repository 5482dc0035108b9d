# SPDX-License-Identifier: GPL-3.0-or-later
# The first coordinate of rotate_scaled: a quaternion (w, v) and a vector x of length at most 1. The others are the same with
# the coordinates exchanged.
@double = float<ieee_64, ne>;
d1 double= v1 * x1; d2 double= v2 * x2; d3 double= v3 * x3; d12 double= d1 + d2; d double= d12 + d3; along = d * 2;
w2 double= w * w; s1 double= v1 * v1; s2 double= v2 * v2; s3 double= v3 * v3; s12 double= s1 + s2; s double= s12 + s3;
keep double= w2 - s;
ta double= v2 * x3; tb double= v3 * x2; turn double= ta - tb;
k1 double= keep * x1; k2 double= along * v1; k12 double= k1 + k2; k3 double= (w * 2) * turn; r double= k12 + k3;
Dot = v1 * x1 + v2 * x2 + v3 * x3; Along = Dot * 2; Keep = w * w - (v1 * v1 + v2 * v2 + v3 * v3); Turn = v2 * x3 - v3 * x2;
R = Keep * x1 + Along * v1 + (w * 2) * Turn;
{ |w| <= 1 /\ |v1| <= 1 /\ |v2| <= 1 /\ |v3| <= 1 /\ |x1| <= 1 /\ |x2| <= 1 /\ |x3| <= 1 /\
  |Dot| <= 1 /\ v1 * v1 + v2 * v2 + v3 * v3 in [0, 1] /\ |Turn| <= 1 /\ |R| <= 1
  -> |r - R| <= BOUND }
