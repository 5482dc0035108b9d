(* SPDX-License-Identifier: MIT *)
(* lemmas/rotation_bound.hpp: a ball around all images of a vector under a hull of unit quaternions. Section 4.3,
   repaired; lines 11 to 15 of Algorithm 1. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.cap Refitlab.theory.quaternion.
Require Import Refitlab.lemma5_cap_enclosing_sphere Refitlab.t3_one_cap.
Import ListNotations.

(* --- Statement --- *)

(* For every q in the hull that is not 0 and every x, R_q x is within radius_ratio ||x|| of center_ratio R_apex x. *)
Record rotation_ball := RotationBall { apex : quat R; center_ratio : R; radius_ratio : R }.
Definition bounds_rotations (qs : list (quat R)) (b : rotation_ball) :=
  norm2 (apex b) = 1 /\ 0 <= center_ratio b <= 1 /\ 0 <= radius_ratio b <= 1 /\
  forall q x, in_hull qs q -> q <> lzero ->
  norm (rotate q x - center_ratio b *: rotate (apex b) x) <= radius_ratio b * norm x.

(* The program: all rotations where the direction is 0 or the cap would be a half-sphere of S_3 or more; else by the
   chord, with s2 the square of half the largest distance from the apex. *)
Definition all_rotations := RotationBall (Quat 1 0 0 0) 0 1.
Fixpoint largest_squared_distance (a : quat R) (qs : list (quat R)) : R :=
  match qs with [] => 0 | q :: qs => Rmax (norm2 (q - a)) (largest_squared_distance a qs) end.
Definition bound_rotations (unit : list (quat R)) (direction : quat R) : rotation_ball :=
  if Req_EM_T (norm2 direction) 0 then all_rotations else
  let a := (/ norm direction *: direction)%V in
  let s2 := largest_squared_distance a unit / 4 in
  if Rlt_dec s2 (1 / 2) then
    let one_minus_cos := Rmin (8 * s2 * (1 - s2)) 1 in
    RotationBall a (1 - one_minus_cos) (sqrt (one_minus_cos * (2 - one_minus_cos)))
  else all_rotations.

(* It is sound for any direction. *)
Definition rotation_bound_is_sound : Prop :=
  forall (unit : list (quat R)) (direction : quat R),
  Forall (fun n => norm2 n = 1) unit -> bounds_rotations unit (bound_rotations unit direction).

(* --- Proof --- *)

Lemma all_rotations_bound qs : bounds_rotations qs all_rotations.
Proof.
  split; [cbn; vunfold; ring|]. cbn [apex center_ratio radius_ratio all_rotations]. split; [lra|]. split; [lra|].
  intros q x _ N.
  replace (rotate q x - 0 *: rotate (Quat 1 0 0 0) x)%V with (rotate q x) by vec_ring. rewrite rotate_norm by auto. lra.
Qed.

Lemma largest_squared_distance_bounds a qs q : In q qs -> norm2 (q - a) <= largest_squared_distance a qs.
Proof.
  induction qs as [|p qs IH]; [intros []|]. intros [->|I]; cbn; [apply Rmax_l|]. eapply Rle_trans; [now apply IH|apply Rmax_r].
Qed.
Lemma largest_squared_distance_nonneg a qs : 0 <= largest_squared_distance a qs.
Proof. induction qs as [|q qs IH]; cbn; [lra|]. eapply Rle_trans; [exact IH|apply Rmax_r]. Qed.

(* Rotations within the angle arccos t of each other, and Lemma 5: what R_q x is near to. *)
Lemma rotation_in_cap_ball (a q : quat R) (t : R) (x : vec R) : a <> lzero -> q <> lzero -> t <= 1 ->
  t * norm2 x <= dot (rotate q x) (rotate a x) ->
  let k := Rmax t 0 in norm (rotate q x - k *: rotate a x) <= sqrt (1 - k * k) * norm x.
Proof.
  intros A Q T D k.
  assert (C : in_cap lzero (rotate a x) t (rotate q x)).
  { unfold in_cap. replace (rotate q x - lzero)%V with (rotate q x) by vec_ring.
    replace (rotate a x - lzero)%V with (rotate a x) by vec_ring. rewrite !rotate_norm2; auto. }
  apply (encloses_repaired_holds _ _ _ lzero (rotate a x) (rotate q x) t T) in C. unfold in_ball, cap_ball in C.
  cbn [center radius] in C. fold k in C.
  replace (rotate a x - lzero)%V with (rotate a x) in C by vec_ring. rewrite rotate_norm in C by auto.
  replace (rotate q x - (lzero + k *: rotate a x))%V with (rotate q x - k *: rotate a x)%V in C by vec_ring. exact C.
Qed.

(* For units, ||q - a||^2 <= 4 s2 is (q, a) >= 1 - 2 s2: the half-angle's cosine squared. *)
Theorem rotation_bound_is_sound_holds : rotation_bound_is_sound.
Proof.
  intros unit direction U. unfold bound_rotations. destruct (Req_EM_T _ _) as [Z|Z]; [apply all_rotations_bound|].
  set (a := (/ norm direction *: direction)%V). set (s2 := largest_squared_distance a unit / 4).
  destruct (Rlt_dec s2 (1 / 2)) as [S|S]; [|apply all_rotations_bound].
  assert (S0 : 0 <= s2) by (pose proof (largest_squared_distance_nonneg a unit); unfold s2; lra).
  assert (Nd : direction <> lzero) by (apply norm2_pos_inv; pose proof (norm2_nonneg direction); lra).
  assert (A : norm2 a = 1).
  { apply norm_pos in Nd. unfold a. rewrite norm2_scale, <- norm_sq. field. lra. }
  set (m := Rmin (8 * s2 * (1 - s2)) 1).
  assert (M : 0 <= m <= 1 /\ 1 - m = Rmax (1 - 8 * s2 * (1 - s2)) 0).
  { unfold m, Rmin, Rmax. destruct (Rle_dec _ _), (Rle_dec _ _); nra. }
  destruct M as [M K].
  assert (Q2 : sqrt (m * (2 - m)) * sqrt (m * (2 - m)) = m * (2 - m)) by (apply sqrt_sqrt; nra).
  pose proof (sqrt_pos (m * (2 - m))). split; [exact A|]. cbn [apex center_ratio radius_ratio].
  split; [lra|]. split; [split; [auto|]; apply sq_le_inv; [lra|]; nra|].
  intros q x H0 N. assert (An : a <> lzero) by now apply unit_not_zero.
  set (k2 := (1 - 2 * s2) * (1 - 2 * s2)).
  assert (C : in_cone a k2 q).
  { apply (one_cap_holds _ _ _ a k2 unit q); auto; [unfold k2; nra|].
    rewrite Forall_forall in *. intros n I. specialize (U n I). pose proof (largest_squared_distance_bounds a unit n I) as L.
    replace (norm2 (n - a)) with (norm2 n - 2 * dot n a + norm2 a) in L by (dots; ring). rewrite U, A in L.
    assert (D : 1 - 2 * s2 <= dot n a) by (unfold s2; lra). unfold in_cone, k2. rewrite U, A. split; nra. }
  assert (D : (2 * k2 - 1) * norm2 x <= dot (rotate q x) (rotate a x)) by (apply one_cap_rotated_holds; auto).
  replace (m * (2 - m)) with (1 - (1 - m) * (1 - m)) by ring. rewrite K.
  replace (1 - 8 * s2 * (1 - s2)) with (2 * k2 - 1) by (unfold k2; ring).
  apply rotation_in_cap_ball; auto. unfold k2. nra.
Qed.

(* The hypothesis can be met, and the bound is no triviality: 1 and (4/5, 3/5, 0, 0) about 1 make a cap of cos alpha 7/25. *)
Example rotation_bound_instance : let unit := [Quat 1 0 0 0; Quat (4 / 5) (3 / 5) 0 0] in
  Forall (fun n => norm2 n = 1) unit /\ center_ratio (bound_rotations unit (Quat 1 0 0 0)) = 7 / 25.
Proof.
  cbv zeta. split; [repeat apply Forall_cons; try apply Forall_nil; vunfold; lra|].
  unfold bound_rotations. assert (O : norm2 (Quat 1 0 0 0) = 1) by (vunfold; ring).
  destruct (Req_EM_T _ _) as [Z|_]; [lra|]. rewrite (norm_unit _ O).
  replace (/ 1 *: Quat 1 0 0 0)%V with (Quat 1 0 0 0) by (vunfold; f_equal; field).
  replace (largest_squared_distance _ _) with (2 / 5).
  - destruct (Rlt_dec _ _) as [_|N]; [|lra]. cbn [center_ratio]. rewrite Rmin_left; lra.
  - cbn [largest_squared_distance]. replace (norm2 (Quat 1 0 0 0 - Quat 1 0 0 0)) with 0 by (vunfold; ring).
    replace (norm2 (Quat (4 / 5) (3 / 5) 0 0 - Quat 1 0 0 0)) with (2 / 5) by (vunfold; field).
    rewrite (Rmax_left (2 / 5) 0), Rmax_right; lra.
Qed.
