(* SPDX-License-Identifier: MIT *)
(* Which of the three kinds of a positive number of Coq's a number of Zarith's is, which is at least 1: 2 q + 1, 2 q or 1. *)
let kind odd even one p =
  if Z.equal p Z.one then one ()
  else if Z.is_odd p then odd (Z.shift_right p 1)
  else even (Z.shift_right p 1)
