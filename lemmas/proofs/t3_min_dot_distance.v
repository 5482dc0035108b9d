(* SPDX-License-Identifier: MIT *)
(* Beyond the paper: the distance d_H is a minimum of dot products, and the ball in R^4 is not needed. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.s43_distance_range.
Import ListNotations.

(* --- Statements --- *)

(* r is the largest distance of an n_k from c; d is min_k (n_k, c) / ||c||. *)
Definition is_largest_distance {E} `{Euclid E} (c : E) (ns : list E) (r : R) :=
  (exists n, In n ns /\ norm (n - c) = r) /\ (forall n, In n ns -> norm (n - c) <= r).
Definition is_least_dot {E} `{Euclid E} (c : E) (ns : list E) (d : R) :=
  (exists n, In n ns /\ dot n c / norm c = d) /\ (forall n, In n ns -> d <= dot n c / norm c).

(* For the largest distance both are the same. *)
Definition min_dot_distance : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c : E) (ns : list E) (r : R),
  (forall n, In n ns -> norm2 n = 1) -> c <> lzero -> is_largest_distance c ns r ->
  is_least_dot c ns (hull_distance c r).
(* For any larger r the left side is smaller: the direct form is never looser. *)
Definition never_looser : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c : E) (ns : list E) (r s : R),
  (forall n, In n ns -> norm2 n = 1) -> c <> lzero -> is_largest_distance c ns r -> r < s ->
  hull_distance c s < hull_distance c r.

(* --- Proofs --- *)

(* ||n - c||^2 = 1 + ||c||^2 - 2 (n, c) is largest where (n, c) is least. *)
Lemma unit_distance {E} `{Euclid E} (c n : E) : norm2 n = 1 -> norm (n - c) * norm (n - c) = 1 + norm2 c - 2 * dot n c.
Proof.
  intros U. rewrite norm_sq. replace (norm2 (n - c)) with (norm2 n - 2 * dot n c + norm2 c) by (dots; ring). rewrite U. ring.
Qed.

Theorem min_dot_distance_holds : min_dot_distance.
Proof.
  intros E l e c ns r U N [(f & F & D) A]. apply norm_pos in N.
  assert (Q : hull_distance c r = dot f c / norm c).
  { unfold hull_distance. rewrite <- D, (unit_distance c f (U f F)). field. lra. }
  split; [exists f; auto|]. rewrite Q. intros n I. specialize (A n I). rewrite <- D in A.
  apply Rmult_le_compat_r; [left; now apply inv_pos|].
  pose proof (unit_distance c f (U f F)). pose proof (unit_distance c n (U n I)).
  pose proof (norm_nonneg (n - c)%V). pose proof (norm_nonneg (f - c)%V). nra.
Qed.

Theorem never_looser_holds : never_looser.
Proof.
  intros E l e c ns r s U N [(f & F & D) A] L. apply norm_pos in N. unfold hull_distance.
  apply Rmult_lt_compat_r; [apply inv_pos; lra|]. pose proof (norm_nonneg (f - c)%V). nra.
Qed.

(* The hypotheses can be met: one unit, about its double. *)
Example min_dot_instance : let c := ((2, 0) : plane) in let ns := [((1, 0) : plane)] in
  (forall n, In n ns -> norm2 n = 1) /\ c <> lzero /\ is_largest_distance c ns 1.
Proof.
  assert (D : norm (((1, 0) : plane) - (2, 0)) = 1) by (apply norm_unit; vunfold; ring).
  cbv zeta. split; [|split].
  - intros n [<-|[]]. vunfold. ring.
  - apply norm2_pos_inv. vunfold. lra.
  - split; [exists (1, 0); split; [now left|exact D]|]. intros n [<-|[]]. lra.
Qed.
