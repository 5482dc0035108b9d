(* SPDX-License-Identifier: MIT *)
(* Section 4.4, several joint-sets: one ball of the balls of all joint-sets. Lines 4 to 8 of Algorithm 1. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.s41_weight_vertices_span Refitlab.s42_linear_part_hull Refitlab.s43_minkowski_sum Refitlab.s44_sum_of_bounds.
Import ListNotations.

(* --- Statements --- *)

(* A joint-set in a pose: its joints' transforms, the skinning's rotation center, and the weight vertices of its weights. *)
Record posed_set := PosedSet {
  transforms : list rigid; rotation_center : vec R; weight_vertices : list (list R) }.
Definition rotations (z : posed_set) := map rotation (transforms z).
Definition center_images (z : posed_set) := map (fun c => apply_rigid c (rotation_center z)) (transforms z).
(* Equation (1). *)
Definition deformed (z : posed_set) (w : list R) (v : vec R) :=
  skin_spherical (rotations z) (center_images z) (rotation_center z) w v.

(* F holds the turned p - r_c of the joint-set. *)
Definition holds_turned (z : posed_set) (p : vec R) (F : ball (vec R)) :=
  forall w, is_weight_vertex_combination (weight_vertices z) w -> comb w (rotations z) <> lzero ->
  in_ball F (rotate (comb w (rotations z)) (p - rotation_center z)).
(* [0, ||p - r_c||] always does. *)
Definition simplest_turned (z : posed_set) (p : vec R) := Ball (lzero : vec R) (norm (p - rotation_center z)).
Definition simplest_holds_turned : Prop := forall z p, holds_turned z p (simplest_turned z p).

(* If a ball [g, R] encloses the balls r'_{k,z} (+) F_z of every joint-set, then [g, R + r] encloses every deformed
   vertex of every joint-set. *)
Definition joint_sets_repaired : Prop :=
  forall (sets : list (posed_set * ball (vec R))) (reference b : ball (vec R)),
  (forall z F, In (z, F) sets -> holds_turned z (center reference) F /\
    encloses_equal_balls b F (weight_vertex_images (weight_vertices z) (center_images z))) ->
  forall z F w v, In (z, F) sets -> is_weight_vertex_combination (weight_vertices z) w -> in_ball reference v ->
  comb w (rotations z) <> lzero -> in_ball (inflate b (radius reference)) (deformed z w v).

(* Printed: the weight vertices and the rotation center of the first joint-set serve all of them. *)
Definition joint_sets_printed : Prop :=
  forall (first : posed_set) (sets : list posed_set) (reference b : ball (vec R)),
  (forall z, In z (first :: sets) ->
    encloses_equal_balls b (simplest_turned first (center reference))
      (weight_vertex_images (weight_vertices first) (map (fun c => apply_rigid c (rotation_center first)) (transforms z)))) ->
  forall z w v, In z (first :: sets) -> is_weight_vertex_combination (weight_vertices z) w -> in_ball reference v ->
  comb w (rotations z) <> lzero -> in_ball (inflate b (radius reference)) (deformed z w v).

(* --- Proofs --- *)

Theorem simplest_holds_turned_holds : simplest_holds_turned.
Proof.
  intros z p w W N. unfold in_ball. cbn [center radius simplest_turned].
  replace (_ - lzero)%V with (rotate (comb w (rotations z)) (p - rotation_center z)) by vec_ring.
  right. now apply rotate_norm.
Qed.

Theorem joint_sets_repaired_holds : joint_sets_repaired.
Proof.
  intros sets reference b B z F w v I W V N. destruct (B z F I) as [T C].
  destruct (W) as (u & U & Q). unfold deformed, skin_spherical. set (q := comb w (rotations z)) in *.
  replace (rotate q (v - rotation_center z) + comb w (center_images z))%V with
    (comb w (center_images z) + rotate q (center reference - rotation_center z) + rotate q (v - center reference))%V
    by (rewrite !rotate_sub; vec_ring).
  apply (sum_of_bounds_holds _ _ _ b F (weight_vertex_images (weight_vertices z) (center_images z))); auto.
  - rewrite (swap_sums u (weight_vertices z) w) by auto. exists u. split; [|reflexivity]. unfold weight_vertex_images.
    now rewrite map_length.
  - now apply T.
  - unfold in_ball in V. now rewrite rotate_norm.
Qed.

(* The first joint-set is moved by its first joint only, the second by its second, by (5, 0, 0). *)
Definition at_rest := Rigid (Quat 1 0 0 0) (Vec 0 0 0).
Definition moved_by_five := Rigid (Quat 1 0 0 0) (Vec 5 0 0).
Theorem joint_sets_printed_is_false : ~ joint_sets_printed.
Proof.
  intros P. set (first := PosedSet [at_rest; at_rest] (Vec 0 0 0) [[1; 0]]).
  set (second := PosedSet [at_rest; moved_by_five] (Vec 0 0 0) [[0; 1]]).
  assert (One : / norm2 (Quat 1 0 0 0) = 1) by (replace (norm2 _) with 1 by (vunfold; ring); apply Rinv_1).
  assert (Z : forall t, apply_rigid (Rigid (Quat 1 0 0 0) t) (Vec 0 0 0) = t).
  { intros [a b c]. unfold apply_rigid, rotate. cbn [rotation translation]. rewrite One. vunfold. f_equal; ring. }
  specialize (P first [second] (Ball (Vec 0 0 0) 0) (Ball (Vec 0 0 0) 0)).
  assert (D : in_ball (inflate (Ball (Vec 0 0 0) 0) 0) (deformed second [0; 1] (Vec 0 0 0))).
  { apply P.
    - intros z [<-|[<-|[]]] x; unfold weight_vertex_images, first, second, at_rest, moved_by_five;
        cbn [weight_vertices map In transforms rotation_center]; rewrite !Z;
        (intros [<-|[]]); unfold holds_ball, simplest_turned; cbn [center radius first rotation_center];
        rewrite !(norm_eq _ 0) by (try lra; cbn [comb]; vunfold; ring); lra.
    - right. now left.
    - exists [1]. split; [repeat split; [repeat constructor; lra|cbn; lra]|].
      intros [|[|[|]]]; cbn; ring.
    - unfold in_ball. cbn [center radius]. right. apply norm_eq; [lra|]. vunfold. ring.
    - apply norm2_pos_inv. cbn. vunfold. lra. }
  assert (deformed second [0; 1] (Vec 0 0 0) = Vec 5 0 0) as Q.
  { unfold deformed, skin_spherical, second, rotations, center_images. cbn [transforms rotation_center map comb].
    unfold at_rest, moved_by_five. rewrite !Z. cbn [rotation].
    replace (0 *: Quat 1 0 0 0 + (1 *: Quat 1 0 0 0 + lzero))%V with (Quat 1 0 0 0) by (vunfold; f_equal; ring).
    unfold rotate. rewrite One. vunfold. f_equal; ring. }
  rewrite Q in D. unfold in_ball in D. cbn [center radius inflate] in D. apply norm_le in D as [_ D]. vunfold. lra.
Qed.

(* The hypotheses can be met: one joint at rest, and the ball of radius 0 about the vertex. *)
Example joint_sets_instance : exists z b w, holds_turned z (Vec 0 0 0) (simplest_turned z (Vec 0 0 0)) /\
  encloses_equal_balls b (simplest_turned z (Vec 0 0 0)) (weight_vertex_images (weight_vertices z) (center_images z)) /\
  is_weight_vertex_combination (weight_vertices z) w /\ comb w (rotations z) <> lzero.
Proof.
  set (z := PosedSet [at_rest] (Vec 0 0 0) [[1]]). set (y := comb [1] (center_images z)).
  exists z, (Ball y 0), [1]. split; [apply simplest_holds_turned_holds|]. split; [|split].
  - intros x [<-|[]]. fold y. unfold holds_ball, simplest_turned, z. cbn [center radius rotation_center].
    rewrite (norm_eq (Vec 0 0 0 - Vec 0 0 0)%V 0) by (try lra; vunfold; ring).
    replace (y + lzero - y)%V with (lzero : vec R) by vec_ring. rewrite norm_zero. lra.
  - exists [1]. split; [repeat split; [repeat constructor; lra|cbn; lra]|]. intros [|[|]]; cbn; ring.
  - apply norm2_pos_inv. cbn. vunfold. lra.
Qed.
