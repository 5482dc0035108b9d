(* SPDX-License-Identifier: MIT *)
(* Section 4.3, after Equation 6: d_H = (1 + ||c||^2 - r^2) / (2 ||c||) is in [0, 1], so that arccos d_H exists. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.cap.

(* --- Statements --- *)

Definition hull_distance {E} `{Euclid E} (c : E) (r : R) := (1 + norm2 c - r * r) / (2 * norm c).

(* | ||c|| - 1 | <= r and r^2 <= 1 + ||c||^2 put it in [0, 1]. *)
Definition distance_range_repaired : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c : E) (r : R), c <> lzero -> 0 <= r ->
  Rabs (norm c - 1) <= r -> r * r <= 1 + norm2 c -> 0 <= hull_distance c r <= 1.
(* The first holds as soon as E holds one unit vector, the second as soon as r <= 1. *)
Definition distance_range_by_point : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c x : E) (r : R), norm2 x = 1 -> in_ball (Ball c r) x ->
  Rabs (norm c - 1) <= r.
Definition distance_range_by_radius : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c : E) (r : R), 0 <= r <= 1 -> r * r <= 1 + norm2 c.

(* Printed: r < 1 and ||c|| + r >= 1 are enough. *)
Definition distance_range_printed : Prop :=
  forall (c : quat R) (r : R), 0 <= r < 1 -> 1 <= norm c + r -> 0 <= hull_distance c r <= 1.

(* --- Proofs --- *)

(* Heron's formula: 4 ||c||^2 - N^2 = ((1 + r)^2 - ||c||^2) (||c||^2 - (1 - r)^2). *)
Lemma heron (n r : R) : 4 * (n * n) - (1 + n * n - r * r) * (1 + n * n - r * r) =
  ((1 + r) * (1 + r) - n * n) * (n * n - (1 - r) * (1 - r)).
Proof. ring. Qed.

Theorem distance_range_repaired_holds : distance_range_repaired.
Proof.
  intros E l e c r N P A B. apply norm_pos in N. unfold hull_distance. rewrite <- norm_sq in *. set (n := norm c) in *.
  assert (A' : - r <= n - 1 <= r) by (pose proof (Rle_abs (n - 1)); pose proof (Rle_abs (- (n - 1))); rewrite Rabs_Ropp in *; lra).
  split; [apply Rmult_le_pos; [lra|left; apply inv_pos; lra]|].
  apply Rmult_le_reg_r with (2 * n); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_1_l by lra.
  apply sq_le_inv; [lra|]. pose proof (heron n r) as H.
  assert (0 <= (1 + r) * (1 + r) - n * n) by nra. assert (0 <= n * n - (1 - r) * (1 - r)) by nra. nra.
Qed.

Theorem distance_range_by_point_holds : distance_range_by_point.
Proof.
  intros E l e c x r U B. unfold in_ball in B. cbn [center radius] in B. apply norm_unit in U.
  pose proof (norm_triangle c x lzero) as T1. pose proof (norm_triangle x c lzero) as T2.
  replace (c - lzero)%V with c in * by vec_ring. replace (x - lzero)%V with x in * by vec_ring.
  rewrite (norm_opposite c x) in T1. apply Rabs_le. lra.
Qed.

Theorem distance_range_by_radius_holds : distance_range_by_radius.
Proof. intros E l e c r R. pose proof (norm2_nonneg c). nra. Qed.

(* A ball outside the unit sphere that does not touch it: d_H = 13/8. *)
Theorem distance_range_printed_is_false : ~ distance_range_printed.
Proof.
  intros P. specialize (P (Quat 3 0 0 0) (1 / 2)). unfold hull_distance in P.
  rewrite (norm_eq _ 3) in P; [|lra|vunfold; ring]. vunfold. lra.
Qed.

(* The hypotheses can be met: the ball of radius 1 about (1, 0, 0, 0). *)
Example distance_range_instance : let c := Quat 1 0 0 0 in
  c <> lzero /\ Rabs (norm c - 1) <= 1 /\ 1 * 1 <= 1 + norm2 c /\ in_ball (Ball c 1) (Quat (1 / 2) (1 / 2) (1 / 2) (1 / 2)).
Proof.
  assert (N : norm2 (Quat 1 0 0 0) = 1) by (vunfold; ring). cbv zeta. split; [|split; [|split]].
  - now apply unit_not_zero.
  - rewrite (norm_unit _ N). replace (1 - 1) with 0 by ring. rewrite Rabs_R0. lra.
  - rewrite N. lra.
  - unfold in_ball. apply norm_le. cbn [center radius]. split; vunfold; lra.
Qed.
