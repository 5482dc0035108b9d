(* SPDX-License-Identifier: MIT *)
(* The checkers as an OCaml program (ocaml/main.ml reads files for it). Natural numbers become machine integers, which is right
   for lengths and places of lists that fit in memory; integers become Zarith's. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlZBigInt ZArith.
Require Import Refitlab.checker.numbers Refitlab.checker.quick.

Extract Constant Z.gcd => "Big_int_Z.gcd_big_int".
Extract Constant Z.leb => "Big_int_Z.le_big_int".
Extraction "checker.ml" check_exactly check_exactly_against check_pairs_quickly.
