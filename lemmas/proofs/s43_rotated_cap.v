(* SPDX-License-Identifier: MIT *)
(* Section 4.3, after Figure 2: from a cap of rotations on S_3 to a cap of rotated vectors in R^3 ("an arbitrary axis and
   angle within <0, 2 alpha_C>", without a proof). *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.cap Refitlab.theory.quaternion.

(* --- Statements --- *)

(* (R_p v, R_q v) >= ||v||^2 (2 c^2 - 1) for the cosine c of the angle between p and q. *)
Definition rotation_bound : Prop :=
  forall (p q : quat R) (v : vec R), p <> lzero -> q <> lzero ->
  let c := dot p q / (norm p * norm q) in norm2 v * (2 * (c * c) - 1) <= dot (rotate p v) (rotate q v).
(* The same for any c^2 that is no greater, without roots. *)
Definition rotation_bound_squared : Prop :=
  forall (p q : quat R) (v : vec R) (c2 : R), p <> lzero -> q <> lzero ->
  c2 * (norm2 p * norm2 q) <= dot p q * dot p q -> (2 * c2 - 1) * norm2 v <= dot (rotate p v) (rotate q v).

(* q is within the angle arccos t of the apex a. *)
Definition within_angle (a q : quat R) (t : R) := t * (norm a * norm q) <= dot a q.

(* The cosine of the rotated cap: past pi/2 the whole sphere is reached. *)
Definition rotated_cosine (t : R) := 2 * (Rmax t 0 * Rmax t 0) - 1.

(* {R_q v : q in C} is inside the cap of R^3 with apex R_a v and the angle 2 alpha, and it is all of that cap; for
   alpha > pi/2 it is all of the sphere of radius ||v||. *)
Definition rotated_cap_repaired : Prop :=
  forall (a : quat R) (t : R) (v x : vec R), a <> lzero -> -1 <= t <= 1 ->
  ((exists q, q <> lzero /\ within_angle a q t /\ x = rotate q v) <->
   in_cap lzero (rotate a v) (rotated_cosine t) x).

(* Printed: the angle is doubled, whatever it is. *)
Definition rotated_cap_printed : Prop :=
  forall (a q : quat R) (t : R) (v : vec R), a <> lzero -> q <> lzero -> -1 <= t <= 1 -> within_angle a q t ->
  norm2 v * (2 * (t * t) - 1) <= dot (rotate a v) (rotate q v).

(* --- Proofs --- *)

Theorem rotation_bound_squared_holds : rotation_bound_squared.
Proof.
  intros p q v c2 P Q C. apply norm2_pos in P, Q. assert (D : 0 < norm2 p * norm2 q) by nra.
  unfold rotate. rewrite dot_scale_l, dot_scale_r, <- Rmult_assoc, <- Rinv_mult.
  apply Rmult_le_reg_l with (1 := D). rewrite <- (Rmult_assoc _ (/ _)), Rinv_r, Rmult_1_l, turned_dot by lra.
  pose proof (Rle_0_sqr (dot (im (qmul (conj p) q)) v)). pose proof (norm2_nonneg v). nra.
Qed.

Theorem rotation_bound_holds : rotation_bound.
Proof.
  intros p q v P Q c. rewrite Rmult_comm. apply rotation_bound_squared_holds; auto.
  apply norm_pos in P, Q. unfold c. rewrite <- !norm_sq. right. field. lra.
Qed.

Lemma within_angle_squared (a q : quat R) t : 0 <= t ->
  within_angle a q t -> t * t * (norm2 a * norm2 q) <= dot a q * dot a q.
Proof.
  intros T A. unfold within_angle in A. rewrite <- !norm_sq. pose proof (norm_nonneg a). pose proof (norm_nonneg q).
  replace (t * t * (norm a * norm a * (norm q * norm q))) with (t * (norm a * norm q) * (t * (norm a * norm q))) by ring.
  assert (0 <= t * (norm a * norm q)) by (repeat apply Rmult_le_pos; auto). apply Rmult_le_compat; auto.
Qed.

(* The shortest rotation from u to x: s u = x s for s = ||u||^2 + (u, x) + u x x. *)
Definition shortest (u x : vec R) : quat R := Quat (norm2 u + dot u x) (vx (cross u x)) (vy (cross u x)) (vz (cross u x)).

Lemma shortest_turns (u x : vec R) : norm2 x = norm2 u -> qmul (shortest u x) (pure u) = qmul (pure x) (shortest u x).
Proof.
  intros N. apply dot_ext. intros z. apply Rminus_diag_uniq.
  replace (_ - _) with ((norm2 u - norm2 x) * dot (pure u) z); [rewrite N; ring|].
  unfold shortest. vring.
Qed.
Lemma norm2_shortest (u x : vec R) : norm2 x = norm2 u ->
  norm2 (shortest u x) = 2 * norm2 u * (norm2 u + dot u x).
Proof.
  intros N. replace (norm2 (shortest u x)) with
    (2 * norm2 u * (norm2 u + dot u x) + norm2 u * (norm2 x - norm2 u)) by (unfold shortest; vring).
  rewrite N. ring.
Qed.

(* A rotation s with s u = x s takes u to x. *)
Lemma rotate_if_commutes (s : quat R) (u x : vec R) : s <> lzero -> qmul s (pure u) = qmul (pure x) s -> rotate s u = x.
Proof.
  intros N C. apply norm2_pos in N. unfold rotate, turned. rewrite C.
  replace (im (qmul (qmul (pure x) s) (conj s))) with (norm2 s *: x)%V by vring.
  revert N. generalize (norm2 s). intros n N. vec_field. lra.
Qed.
Lemma rotate_compose (s a : quat R) (v : vec R) : s <> lzero -> a <> lzero ->
  rotate (qmul s a) v = rotate s (rotate a v).
Proof.
  intros S A. unfold rotate. rewrite norm2_qmul.
  replace (turned (qmul s a) v (qmul s a)) with (turned s (turned a v a) s) by vring.
  rewrite Rinv_mult. generalize (/ norm2 s) (/ norm2 a) (turned a v a). vring.
Qed.
Lemma dot_qmul (s a : quat R) : dot a (qmul s a) = qw s * norm2 a.
Proof. vring. Qed.

(* Any x of the rotated cap of an angle of at most pi/2 is reached: by s a with the shortest s, or half a turn. *)
Lemma cap_is_filled (a : quat R) (t : R) (v x : vec R) : a <> lzero -> 0 <= t <= 1 ->
  norm2 x = norm2 v -> (2 * (t * t) - 1) * norm2 v <= dot x (rotate a v) ->
  exists q, q <> lzero /\ within_angle a q t /\ x = rotate q v.
Proof.
  intros A T N D. set (u := rotate a v) in *. assert (U : norm2 u = norm2 v) by now apply rotate_norm2.
  assert (G : forall s, s <> lzero -> qmul s (pure u) = qmul (pure x) s -> t * norm s <= qw s ->
    exists q, q <> lzero /\ within_angle a q t /\ x = rotate q v).
  { intros s S C W. exists (qmul s a). split; [|split].
    - apply norm2_pos_inv. rewrite norm2_qmul. apply norm2_pos in S, A. nra.
    - unfold within_angle. rewrite dot_qmul, norm_qmul, <- norm_sq. pose proof (norm_nonneg a). nra.
    - rewrite rotate_compose by auto. fold u. symmetry. now apply rotate_if_commutes. }
  pose proof (norm2_nonneg v) as P. destruct (Rle_lt_or_eq_dec _ _ P) as [V|V].
  2:{ assert (u = lzero) as Z by (apply norm2_zero_inv; lra). assert (x = lzero) as Zx by (apply norm2_zero_inv; lra).
      apply (G (Quat 1 0 0 0)).
      - apply norm2_pos_inv. vunfold. lra.
      - rewrite Z, Zx. vring.
      - rewrite (norm_unit (Quat 1 0 0 0)) by (vunfold; ring). cbn. lra. }
  pose proof (dot_comm x u) as Sy. assert (W : - norm2 v <= dot u x) by (rewrite <- Sy; nra).
  destruct (Rle_lt_or_eq_dec _ _ W) as [L|L].
  - assert (Q : norm2 (shortest u x) = 2 * norm2 v * (norm2 v + dot u x)) by (rewrite norm2_shortest, U; congruence).
    apply (G (shortest u x)).
    + apply norm2_pos_inv. rewrite Q. nra.
    + apply shortest_turns. congruence.
    + cbn [shortest qw]. rewrite U. apply sq_le_inv; [lra|].
      replace (t * norm (shortest u x) * (t * norm (shortest u x))) with (t * t * norm2 (shortest u x))
        by (rewrite <- norm_sq; ring).
      rewrite Q. rewrite Sy in D.
      replace (t * t * (2 * norm2 v * (norm2 v + dot u x))) with (2 * (t * t) * norm2 v * (norm2 v + dot u x)) by ring.
      apply Rmult_le_compat_r; lra.
  - assert (T0 : t = 0).
    { rewrite Sy, <- L in D. assert (t * t * norm2 v <= 0) by lra.
      assert (t * t <= 0) by (apply Rmult_le_reg_r with (1 := V); lra). apply Rle_antisym; nra. }
    assert (X : x = (-1 *: u)%V).
    { assert (Z : (x + u)%V = lzero).
      { apply norm2_zero_inv. replace (norm2 (x + u)) with (norm2 x + 2 * dot u x + norm2 u) by (dots; ring). lra. }
      apply dot_ext. intros z. apply (f_equal (fun y => dot y z)) in Z. cbv beta in Z. autorewrite with dots in *. lra. }
    destruct (vec_is_plane u) as (w & O & Nw).
    apply (G (pure w)).
    + apply norm2_pos_inv. rewrite norm2_pure. lra.
    + rewrite X. clear - O. apply dot_ext. intros z. apply Rminus_diag_uniq.
      replace (_ - _) with (- 2 * dot w u * qw z) by vring. rewrite O. ring.
    + rewrite T0. cbn. lra.
Qed.

Theorem rotated_cap_repaired_holds : rotated_cap_repaired.
Proof.
  intros a t v x A T. unfold in_cap, rotated_cosine. set (k := Rmax t 0).
  assert (K : 0 <= k <= 1 /\ t <= k) by (unfold k, Rmax; destruct (Rle_dec t 0); lra).
  replace (rotate a v - lzero)%V with (rotate a v) by vec_ring. replace (x - lzero)%V with x by vec_ring.
  rewrite rotate_norm2 by auto. split.
  - intros (q & Q & W & ->). split; [now apply rotate_norm2|].
    destruct (Rle_lt_dec 0 t) as [P|P].
    + replace k with t by (unfold k; rewrite Rmax_left; lra). apply rotation_bound_squared_holds; auto.
      apply within_angle_squared in W; auto. rewrite (dot_comm q a). lra.
    + replace k with 0 by (unfold k; rewrite Rmax_right; lra).
      pose proof (dot_ge_norms (rotate q v) (rotate a v)) as G. rewrite !rotate_norm in G by auto.
      rewrite norm_sq in G. lra.
  - intros [N D]. destruct (cap_is_filled a k v x) as (q & Q & W & X); auto; [lra|].
    exists q. split; [exact Q|]. split; [|exact X]. unfold within_angle in *.
    pose proof (norm_nonneg a). pose proof (norm_nonneg q). assert (0 <= norm a * norm q) by now apply Rmult_le_pos.
    assert (t * (norm a * norm q) <= k * (norm a * norm q)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

(* The half turn about the x axis is in the cap of cosine -4/5 about 1, and takes y to -y; the doubled angle has the
   cosine 7/25. *)
Theorem rotated_cap_printed_is_false : ~ rotated_cap_printed.
Proof.
  intros P. specialize (P (Quat 1 0 0 0) (Quat 0 1 0 0) (-4 / 5) (Vec 0 1 0)).
  assert (N1 : norm2 (Quat 1 0 0 0) = 1) by (vunfold; ring). assert (N2 : norm2 (Quat 0 1 0 0) = 1) by (vunfold; ring).
  assert (D : norm2 (Vec 0 1 0) * (2 * (-4 / 5 * (-4 / 5)) - 1) <=
    dot (rotate (Quat 1 0 0 0) (Vec 0 1 0)) (rotate (Quat 0 1 0 0) (Vec 0 1 0))).
  { apply P; [now apply unit_not_zero| now apply unit_not_zero|lra|].
    unfold within_angle. rewrite !norm_unit by assumption. vunfold. lra. }
  unfold rotate in D. rewrite N1, N2, Rinv_1 in D. vunfold. lra.
Qed.

(* The hypotheses can be met: the cap of cosine 4/5 about 1. *)
Example rotated_cap_instance : Quat 1 0 0 0 <> lzero /\ -1 <= 4 / 5 <= 1 /\ within_angle (Quat 1 0 0 0) (Quat (4 / 5) (3 / 5) 0 0) (4 / 5).
Proof.
  split; [apply norm2_pos_inv; vunfold; lra|]. split; [lra|]. unfold within_angle.
  rewrite !norm_unit by (vunfold; field). vunfold. lra.
Qed.
