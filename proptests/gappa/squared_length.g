# SPDX-License-Identifier: GPL-3.0-or-later
# squared_norm of a quaternion of length at most 1.
@double = float<ieee_64, ne>;
p0 double= q0 * q0; p1 double= q1 * q1; p2 double= q2 * q2; p3 double= q3 * q3;
p01 double= p0 + p1; p012 double= p01 + p2; p double= p012 + p3;
E = q0 * q0 + q1 * q1 + q2 * q2 + q3 * q3;
{ |q0| <= 1 /\ |q1| <= 1 /\ |q2| <= 1 /\ |q3| <= 1 /\ q0 * q0 + q1 * q1 <= 1 /\ q0 * q0 + q1 * q1 + q2 * q2 <= 1 /\ |E| <= 1
  -> |p - E| <= BOUND }
