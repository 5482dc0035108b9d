(* SPDX-License-Identifier: MIT *)
(* Rotations of R^3 by quaternions of any length, and the three ways of blending that the project bounds. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex.
Import ListNotations.

(* R_q x = Im(q x q-conjugate) / ||q||^2: the rotation of a non-zero quaternion of any length. *)
Definition rotate (q : quat R) (x : vec R) : vec R := (/ norm2 q *: turned q x q)%V.
Arguments rotate q%V x%V.

Lemma turned_norm2 (q : quat R) (x : vec R) : norm2 (turned q x q) = norm2 q * norm2 q * norm2 x.
Proof. vring. Qed.
Lemma norm2_pure (v : vec R) : norm2 (pure v) = norm2 v.
Proof. vring. Qed.
Lemma norm2_qmul (a b : quat R) : norm2 (qmul a b) = norm2 a * norm2 b.
Proof. vring. Qed.
Lemma norm_qmul (a b : quat R) : norm (qmul a b) = norm a * norm b.
Proof.
  apply norm_eq; [apply Rmult_le_pos; apply norm_nonneg|].
  rewrite norm2_qmul, <- (norm_sq a), <- (norm_sq b). ring.
Qed.
Lemma norm2_conj (a : quat R) : norm2 (conj a) = norm2 a.
Proof. vring. Qed.
Lemma norm2_im (a : quat R) : norm2 (im a) <= norm2 a.
Proof. destruct a as [w x y z]. vunfold. nra. Qed.
Lemma norm2_quat_pos (q : quat R) : q <> lzero -> 0 < norm2 q.
Proof. apply norm2_pos. Qed.

Lemma rotate_norm2 (q : quat R) x : q <> lzero -> norm2 (rotate q x) = norm2 x.
Proof.
  intros N. apply norm2_pos in N. unfold rotate. rewrite norm2_scale, turned_norm2. field. lra.
Qed.
Lemma rotate_norm (q : quat R) x : q <> lzero -> norm (rotate q x) = norm x.
Proof. intros N. unfold norm. now rewrite rotate_norm2. Qed.
Lemma rotate_linear q : linear (rotate q).
Proof. unfold linear, rotate. split; [|split]; intros; generalize (/ norm2 q); vring. Qed.
Lemma rotate_add q x y : rotate q (x + y) = (rotate q x + rotate q y)%V.
Proof. destruct (rotate_linear q) as (_ & A & _). apply A. Qed.
Lemma rotate_scale q a x : rotate q (a *: x) = (a *: rotate q x)%V.
Proof. destruct (rotate_linear q) as (_ & _ & S). apply S. Qed.
Lemma rotate_sub q x y : rotate q (x - y) = (rotate q x - rotate q y)%V.
Proof.
  replace (x - y)%V with (x + (-1) *: y)%V by vec_ring. rewrite rotate_add, rotate_scale. vec_ring.
Qed.
(* The length of the quaternion does not matter, nor its sign. *)
Lemma rotate_of_multiple a q x : a <> 0 -> q <> lzero -> rotate (a *: q) x = rotate q x.
Proof.
  intros A N. apply norm2_pos in N. unfold rotate. rewrite norm2_scale.
  replace (turned (a *: q) x (a *: q)) with (a * a *: turned q x q)%V by vring.
  generalize dependent (norm2 q). generalize (turned q x q). intros v n N. vec_field. split; lra.
Qed.
Lemma rotate_conj q x : q <> lzero -> rotate q (rotate (conj q) x) = x.
Proof.
  intros N. apply norm2_pos in N. unfold rotate. rewrite norm2_conj.
  replace (turned q (/ norm2 q *: turned (conj q) x (conj q)) q) with
    (/ norm2 q *: (norm2 q * norm2 q *: x))%V by (generalize (/ norm2 q); vring).
  revert N. generalize (norm2 q). intros n N. vec_field. lra.
Qed.

(* (R_q x, R_a x) ||q||^2 ||a||^2 = (2 (q, a)^2 - ||q||^2 ||a||^2) ||x||^2 + 2 (Im(q* a), x)^2 *)
Lemma turned_dot (q a : quat R) (x : vec R) :
  dot (turned q x q) (turned a x a) =
  (2 * (dot q a * dot q a) - norm2 q * norm2 a) * norm2 x + 2 * Rsqr (dot (im (qmul (conj q) a)) x).
Proof. unfold Rsqr. vring. Qed.

(* --- Blending with weights w: what is linear in the weights comes as a list --- *)

(* Equation (1) of the paper: Q_w(v - r_c) + sum_i w_i C_{j_i} r_c, with images for the C_{j_i} r_c. *)
Definition skin_spherical (qs : list (quat R)) (images : list (vec R)) (rotation_center : vec R) (w : list R)
  (v : vec R) : vec R := (rotate (comb w qs) (v - rotation_center) + comb w images)%V.
(* Dual quaternions q_i + eps d_i: (Im(q v q* ) + 2 Im(d q* )) / ||q||^2 of the blended q, d. *)
Definition skin_dual (qs ds : list (quat R)) (w : list R) (v : vec R) : vec R :=
  let q := comb w qs in let d := comb w ds in
  (/ norm2 q *: (turned q v q + 2 *: im (qmul d (conj q))))%V.

(* A rigid transform: the rotation of a quaternion that is not 0, then a translation. *)
Record rigid := Rigid { rotation : quat R; translation : vec R }.
Definition apply_rigid (c : rigid) (v : vec R) : vec R := (rotate (rotation c) v + translation c)%V.
Arguments apply_rigid c v%V.
(* Its dual part, t_i q_i / 2 for the rotation q_i and then the translation t_i. *)
Definition dual_of (c : rigid) : quat R := (1 / 2 *: qmul (pure (translation c)) (rotation c))%V.
Lemma unit_moves (t : rigid) (f : vec R) : norm2 (rotation t) = 1 ->
  (qmul (rotation t) (pure f) + 2 *: dual_of t)%V = qmul (pure (apply_rigid t f)) (rotation t).
Proof.
  intros U. unfold apply_rigid, rotate, dual_of. rewrite U, Rinv_1. destruct t as [q x]. cbn [rotation translation] in *.
  assert (G : qmul (pure (turned q f q)) q = (norm2 q *: qmul q (pure f))%V) by vring.
  replace (qmul (pure (1 *: turned q f q + x)%V) q) with (qmul (pure (turned q f q)) q + qmul (pure x) q)%V
    by (generalize (turned q f q); vring).
  rewrite G, U. generalize (qmul q (pure f)) (qmul (pure x) q). vfield.
Qed.
