# SPDX-License-Identifier: GPL-3.0-or-later
# The first coordinate of rotate: x + 2 (w v x x + v x (v x x)), of lengths at most 1.
@double = float<ieee_64, ne>;
t1a double= v2 * x3; t1b double= v3 * x2; t1 double= t1a - t1b;
t2a double= v3 * x1; t2b double= v1 * x3; t2 double= t2a - t2b;
t3a double= v1 * x2; t3b double= v2 * x1; t3 double= t3a - t3b;
ua double= v2 * t3; ub double= v3 * t2; uu double= ua - ub;
wt double= w * t1; s double= wt + uu; r double= x1 + 2 * s;
T1 = v2 * x3 - v3 * x2; T2 = v3 * x1 - v1 * x3; T3 = v1 * x2 - v2 * x1; U = v2 * T3 - v3 * T2; S = w * T1 + U; R = x1 + 2 * S;
{ |w| <= 1 /\ |v1| <= 1 /\ |v2| <= 1 /\ |v3| <= 1 /\ |x1| <= 1 /\ |x2| <= 1 /\ |x3| <= 1 /\
  |T1| <= 1 /\ |T2| <= 1 /\ |T3| <= 1 /\ |U| <= 1 /\ |S| <= 1 /\ |R| <= 1.01
  -> |r - R| <= BOUND }
