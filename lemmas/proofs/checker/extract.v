(* SPDX-License-Identifier: MIT *)
(* The checkers as an OCaml program (ocaml/main.ml reads files for it). Natural numbers become machine integers, which is right
   for lengths and places of lists that fit in memory; integers become Zarith's. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlZBigInt ZArith.
Require Import Refitlab.checker.numbers Refitlab.checker.quick.

(* As in ExtrOcamlZBigInt, without a division. *)
Extract Inductive positive => "Big_int_Z.big_int"
  [ "(fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))" "Big_int_Z.mult_int_big_int 2" "Big_int_Z.unit_big_int" ]
  "Positive.kind".
Extract Constant Z.gcd => "Big_int_Z.gcd_big_int".
Extract Constant Z.leb => "Big_int_Z.le_big_int".
Extraction "checker.ml" check_exactly check_exactly_against check_pairs_quickly.
