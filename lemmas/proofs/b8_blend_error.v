(* SPDX-License-Identifier: MIT *)
(* Beyond the paper: how far off is what a blend makes of a point, if the blend is off. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.b7_motion_bound.
Import ListNotations.

(* --- Statements --- *)

(* t(q, d) = 2 Im(d q* ) / ||q||^2 *)
Definition moved (q d : quat R) : vec R := (2 / norm2 q *: im (qmul d (conj q)))%V.

Definition turns_by_error : Prop :=
  forall (q q' : quat R) (x : vec R) (e kappa : R), q' <> lzero -> 0 <= kappa -> 1 <= kappa * norm q -> norm (q' - q) <= e ->
  norm (rotate q' x - rotate q x) <= 2 * kappa * e * norm x.
Definition moves_by_error : Prop :=
  forall (q q' d d' : quat R) (e f l kappa : R), 0 <= kappa -> 1 <= kappa * norm q -> 1 <= kappa * norm q' ->
  norm (q' - q) <= e -> norm (d' - d) <= f -> norm d <= l ->
  norm (moved q' d' - moved q d) <= 2 * kappa * (f + kappa * e * l).
(* No smaller factor than 2 kappa will do. *)
Definition turns_by_less : Prop :=
  exists factor, factor < 2 /\ forall (q q' : quat R) (x : vec R) (e kappa : R), q' <> lzero -> 0 <= kappa ->
  1 <= kappa * norm q -> norm (q' - q) <= e -> norm (rotate q' x - rotate q x) <= factor * kappa * e * norm x.

(* --- Proofs --- *)

Lemma long_not_zero {E} `{Euclid E} (x : E) kappa : 1 <= kappa * norm x -> x <> lzero.
Proof. intros L ->. rewrite norm_zero in L. lra. Qed.

(* ||q||^2 (1 - (n, n')^2) is the squared distance of q from the line of q'. *)
Lemma distance_from_line {E} `{Euclid E} (p q : E) : 0 < norm2 p -> norm2 q - dot p q * dot p q / norm2 p <= norm2 (p - q).
Proof.
  intros P. replace (norm2 (p - q)) with (norm2 p - 2 * dot p q + norm2 q)
    by (unfold norm2; rewrite !dot_sub_l, !dot_sub_r, (dot_comm q p); ring).
  assert (D : norm2 p - 2 * dot p q + dot p q * dot p q / norm2 p = (norm2 p - dot p q) * (norm2 p - dot p q) / norm2 p)
    by (field; lra).
  assert (0 <= (norm2 p - dot p q) * (norm2 p - dot p q) / norm2 p); [|lra].
  apply Rmult_le_pos; [apply Rle_0_sqr|left; now apply inv_pos].
Qed.

Lemma norm2_of_unit {E} `{Euclid E} (x : E) : x <> lzero -> norm2 (/ norm x *: x) = 1.
Proof.
  intros N. rewrite norm2_scale, <- (norm_sq x). apply norm_pos in N. field. lra.
Qed.
Lemma unit_turns (q : quat R) x : q <> lzero -> rotate (/ norm q *: q) x = rotate q x.
Proof. intros N. apply rotate_of_multiple; [|exact N]. apply norm_pos, inv_pos in N. lra. Qed.

Theorem turns_by_error_holds : turns_by_error.
Proof.
  intros q q' x e kappa N K L E. assert (M := long_not_zero q kappa L).
  pose proof (turns_little_holds (/ norm q' *: q')%V (/ norm q *: q)%V x (norm2_of_unit q' N) (norm2_of_unit q M)) as T.
  rewrite !unit_turns, dot_scale_l, dot_scale_r in T by assumption.
  pose proof (distance_from_line q' q (norm2_pos q' N)) as D.
  assert (E0 : 0 <= e) by (pose proof (norm_nonneg (q' - q)%V); lra).
  pose proof (norm_sq (q' - q)%V) as S. pose proof (norm_nonneg (q' - q)%V). apply norm_pos in N as N', M as M'.
  pose proof (norm_sq q) as Sq. pose proof (norm_sq q') as Sq'. pose proof (norm_sq x) as Sx. pose proof (norm_nonneg x).
  set (g := dot q' q) in *. set (a := norm q) in *. set (b := norm q') in *.
  assert (C : (1 - / b * (/ a * g) * (/ b * (/ a * g))) * (a * a) <= e * e).
  { replace ((1 - / b * (/ a * g) * (/ b * (/ a * g))) * (a * a)) with (norm2 q - g * g / norm2 q')
      by (rewrite <- Sq, <- Sq'; field; lra). nra. }
  apply norm_le. split; [repeat apply Rmult_le_pos; lra|]. eapply Rle_trans; [exact T|]. rewrite <- Sx.
  set (c := 1 - / b * (/ a * g) * (/ b * (/ a * g))) in *.
  assert (B : c <= kappa * e * (kappa * e)).
  { assert (1 <= kappa * a * (kappa * a)) by nra. destruct (Rle_or_lt c 0) as [Z|Z]; [nra|].
    apply Rle_trans with (c * (kappa * a * (kappa * a))); [nra|].
    replace (c * (kappa * a * (kappa * a))) with (kappa * kappa * (c * (a * a))) by ring.
    replace (kappa * e * (kappa * e)) with (kappa * kappa * (e * e)) by ring. apply Rmult_le_compat_l; nra. }
  replace (2 * kappa * e * norm x * (2 * kappa * e * norm x)) with (4 * (kappa * e * (kappa * e)) * (norm x * norm x)) by ring.
  apply Rmult_le_compat_r; [nra|lra].
Qed.

(* Inverses. *)
Definition inverse_of (q : quat R) : quat R := (/ norm2 q *: conj q)%V.
Lemma norm_inverse q : q <> lzero -> norm (inverse_of q) = / norm q.
Proof.
  intros N. apply norm_pos in N as P. apply norm_eq; [left; now apply inv_pos|].
  unfold inverse_of. rewrite norm2_scale, norm2_conj, <- (norm_sq q). field. lra.
Qed.
Lemma norm_between_inverses p q : p <> lzero -> q <> lzero ->
  norm (inverse_of p - inverse_of q) = norm (p - q) * / norm p * / norm q.
Proof.
  intros P Q. apply norm_pos in P as P', Q as Q'. apply norm_eq.
  - repeat apply Rmult_le_pos; try apply norm_nonneg; left; now apply inv_pos.
  - replace (norm (p - q) * / norm p * / norm q * (norm (p - q) * / norm p * / norm q)) with
      (norm (p - q) * norm (p - q) / (norm p * norm p * (norm q * norm q))) by (field; lra).
    rewrite !norm_sq. apply norm2_pos in P, Q. unfold inverse_of. revert P Q.
    replace (norm2 (p - q)) with (norm2 p - 2 * dot p q + norm2 q)
      by (unfold norm2; rewrite !dot_sub_l, !dot_sub_r, (dot_comm q p); ring).
    replace (norm2 (/ norm2 p *: conj p - / norm2 q *: conj q)) with
      (/ norm2 p * / norm2 p * norm2 p - 2 * (/ norm2 p * / norm2 q * dot p q) + / norm2 q * / norm2 q * norm2 q)
      by (generalize (/ norm2 p) (/ norm2 q); intros; vring).
    intros P Q. field. lra.
Qed.

Lemma norm_im_le (a : quat R) : norm (im a) <= norm a.
Proof. apply norm_le. split; [apply norm_nonneg|]. rewrite norm_sq. apply norm2_im. Qed.

Lemma moved_by_inverse q d : moved q d = (2 *: im (qmul d (inverse_of q)))%V.
Proof. unfold moved, inverse_of, Rdiv. generalize (/ norm2 q). intros. vring. Qed.

Theorem moves_by_error_holds : moves_by_error.
Proof.
  intros q q' d d' e f l kappa K L L' E F D. assert (N := long_not_zero q kappa L). assert (N' := long_not_zero q' kappa L').
  rewrite !moved_by_inverse.
  replace (_ - _)%V with (2 *: im (qmul (d' - d) (inverse_of q') + qmul d (inverse_of q' - inverse_of q)))%V
    by (generalize (inverse_of q) (inverse_of q'); vring).
  rewrite norm_scale by lra. rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|].
  eapply Rle_trans; [apply norm_im_le|]. eapply Rle_trans; [apply norm_add|].
  rewrite !norm_qmul, norm_inverse, norm_between_inverses by assumption.
  apply norm_pos in N, N'. pose proof (norm_nonneg (q' - q)%V). pose proof (norm_nonneg (d' - d)%V). pose proof (norm_nonneg d).
  assert (I : 0 < / norm q <= kappa).
  { split; [now apply inv_pos|]. apply Rmult_le_reg_r with (norm q); [exact N|]. rewrite Rinv_l; lra. }
  assert (I' : 0 < / norm q' <= kappa).
  { split; [now apply inv_pos|]. apply Rmult_le_reg_r with (norm q'); [exact N'|]. rewrite Rinv_l; lra. }
  set (i := / norm q) in *. set (i' := / norm q') in *. clearbody i i'.
  rewrite Rmult_plus_distr_l. apply Rplus_le_compat.
  - rewrite (Rmult_comm kappa). apply Rmult_le_compat; lra.
  - replace (kappa * (kappa * e * l)) with (l * (e * kappa * kappa)) by ring.
    apply Rmult_le_compat; [lra| |lra|].
    + repeat apply Rmult_le_pos; lra.
    + apply Rmult_le_compat; try lra; [apply Rmult_le_pos; lra|apply Rmult_le_compat; lra].
Qed.

(* q' is the nearest to q of those that turn by twice the angle of cosine 4/5, and x is perpendicular to the axis. *)
Theorem turns_by_less_is_false : ~ turns_by_less.
Proof.
  intros (factor & Less & H).
  set (q := Quat 1 0 0 0 : quat R). set (q' := Quat (16 / 25) (12 / 25) 0 0 : quat R). set (x := Vec 0 1 0 : vec R).
  assert (A : norm q = 1) by (apply norm_eq; [lra|unfold q; vunfold; lra]).
  assert (B : norm (q' - q)%V = 3 / 5) by (apply norm_eq; [lra|unfold q, q'; vunfold; lra]).
  assert (C : norm x = 1) by (apply norm_eq; [lra|unfold x; vunfold; lra]).
  assert (D : norm (rotate q' x - rotate q x)%V = 6 / 5).
  { apply norm_eq; [lra|]. unfold rotate.
    replace (norm2 q') with (16 / 25) by (unfold q'; vunfold; lra). replace (norm2 q) with 1 by (unfold q; vunfold; lra).
    unfold q, q', x. vunfold. field. }
  assert (N : q' <> lzero) by (apply norm2_pos_inv; unfold q'; vunfold; lra).
  specialize (H q q' x (3 / 5) 1 N). rewrite A, B, C, D in H. lra.
Qed.

(* The hypotheses can be met. *)
Example blend_error_instance : let q := Quat 1 0 0 0 : quat R in let q' := Quat 1 (1 / 10) 0 0 : quat R in
  q' <> lzero /\ 1 <= 1 * norm q /\ 1 <= 1 * norm q' /\ norm (q' - q) <= 1 / 10 /\ norm (q' - q') <= 0 /\ norm q <= 1.
Proof.
  cbv zeta. assert (A : norm (Quat 1 0 0 0 : quat R) = 1) by (apply norm_eq; [lra|vunfold; lra]).
  split; [apply norm2_pos_inv; vunfold; lra|]. rewrite A. split; [lra|]. split; [|split; [|split; [|lra]]].
  - rewrite Rmult_1_l. apply sq_le_inv; [apply norm_nonneg|]. rewrite norm_sq. vunfold. lra.
  - apply norm_le. split; [lra|]. vunfold. lra.
  - apply norm_le. split; [lra|]. vunfold. lra.
Qed.
