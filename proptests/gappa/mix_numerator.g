# SPDX-License-Identifier: GPL-3.0-or-later
# The first coordinate of N_kl of mix_rotations, of quaternions and a vector of length at most 1.
@double = float<ieee_64, ne>;
real double= a0 * b0;
i1 double= a1 * b1; i2 double= a2 * b2; i3 double= a3 * b3; i12 double= i1 + i2; imag double= i12 + i3;
weight double= real + imag; diff double= real - imag;
m2a double= b2 * a0; m2b double= a2 * b0; m2 double= m2a + m2b; m3a double= b3 * a0; m3b double= a3 * b0; m3 double= m3a + m3b;
ta double= m2 * x3; tb double= m3 * x2; turn double= ta - tb;
da1 double= a1 * x1; da2 double= a2 * x2; da3 double= a3 * x3; da12 double= da1 + da2; da double= da12 + da3;
db1 double= b1 * x1; db2 double= b2 * x2; db3 double= b3 * x3; db12 double= db1 + db2; db double= db12 + db3;
n1 double= x1 * diff; n2 double= b1 * da; n3 double= a1 * db; n12 double= n1 + n2; n123 double= n12 + n3; n double= n123 + turn;
Real = a0 * b0; Imag = a1 * b1 + a2 * b2 + a3 * b3; W = Real + Imag; D = Real - Imag;
M2 = b2 * a0 + a2 * b0; M3 = b3 * a0 + a3 * b0; T = M2 * x3 - M3 * x2;
DA = a1 * x1 + a2 * x2 + a3 * x3; DB = b1 * x1 + b2 * x2 + b3 * x3; N = x1 * D + b1 * DA + a1 * DB + T;
{ |a0| <= 1 /\ |a1| <= 1 /\ |a2| <= 1 /\ |a3| <= 1 /\ |b0| <= 1 /\ |b1| <= 1 /\ |b2| <= 1 /\ |b3| <= 1 /\
  |x1| <= 1 /\ |x2| <= 1 /\ |x3| <= 1 /\ |Imag| <= 1 /\ |W| <= 1 /\ |D| <= 1 /\ |M2| <= 1 /\ |M3| <= 1 /\ |T| <= 1 /\
  |DA| <= 1 /\ |DB| <= 1 /\ |N| <= 1 /\ |a1 * b1 + a2 * b2| <= 1 /\ |a1 * x1 + a2 * x2| <= 1 /\ |b1 * x1 + b2 * x2| <= 1
  -> |n - N| <= BOUND }
