(* SPDX-License-Identifier: MIT *)
(* Which of the three kinds of a positive number of Coq's a number of Zarith's is, which is at least 1: 2 q + 1, 2 q or 1. (One is a
   machine integer to Zarith, so that it is itself and no other.) *)
let kind odd even one p =
  if p == Z.one then one ()
  else if Z.logand p Z.one == Z.one then odd (Z.shift_right p 1)
  else even (Z.shift_right p 1)
