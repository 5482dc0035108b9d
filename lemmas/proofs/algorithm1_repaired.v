(* SPDX-License-Identifier: MIT *)
(* algorithms/runtime/refit/algorithm1_repaired.hpp: Algorithm 1 of the paper (section 4.5), repaired, is sound over the real numbers.
   It is composed as the program is. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.lemma2_normalization Refitlab.lemma4_quaternion_hull Refitlab.rotation_bound.
Require Import Refitlab.s41_weight_vertices_span Refitlab.s42_linear_part_hull Refitlab.s44_sum_of_bounds Refitlab.s44_joint_sets.
Import ListNotations.

(* --- The program --- *)

(* Lines 5 to 13: a bound of the rotations of the weight vertices' blends. Where a blend is 0, all rotations. The
   centers of points are any function, such as the mean. *)
Definition all_nonzero (qs : list (quat R)) : bool :=
  forallb (fun q => if Req_EM_T (norm2 q) 0 then false else true) qs.
Definition bound_weight_vertex_rotations (center_of_points : list (quat R) -> quat R) (qs : list (quat R)) : rotation_ball :=
  if all_nonzero qs then let unit := map direction qs in bound_rotations unit (center_of_points unit) else all_rotations.

(* A node: the ball S = [p, r] that holds its vertices in the reference pose, and its joint-sets in the pose. *)
Record node := Node { reference : ball (vec R); joint_sets : list posed_set }.

(* Lines 7, 14 and 15: the balls of a joint-set, one a weight vertex. *)
Definition joint_set_balls (center_of_points : list (quat R) -> quat R) (p : vec R) (z : posed_set) : list (ball (vec R)) :=
  let bound := bound_weight_vertex_rotations center_of_points (weight_vertex_images (weight_vertices z) (rotations z)) in
  let u := (p - rotation_center z)%V in
  let offset := (center_ratio bound *: rotate (apex bound) u)%V in
  map (fun image => Ball (image + offset)%V (radius_ratio bound * norm u))
    (weight_vertex_images (weight_vertices z) (center_images z)).

(* Line 16: one ball around all of them, inflated by r. *)
Definition algorithm1 (center_of_points : list (quat R) -> quat R) (of_balls : list (ball (vec R)) -> ball (vec R))
  (n : node) : ball (vec R) :=
  inflate (of_balls (flat_map (joint_set_balls center_of_points (center (reference n))) (joint_sets n)))
    (radius (reference n)).

(* BOUNDINGSPHERE by mean balls. *)
Fixpoint radius_about (c : vec R) (balls : list (ball (vec R))) : R :=
  match balls with
  | [] => 0
  | [b] => norm (center b - c) + radius b
  | b :: bs => Rmax (norm (center b - c) + radius b) (radius_about c bs)
  end.
Definition mean {E} {l : Lin R E} (points : list E) : E :=
  (/ INR (length points) *: comb (repeat 1 (length points)) points)%V.
Definition mean_ball (balls : list (ball (vec R))) : ball (vec R) :=
  let c := mean (map center balls) in Ball c (radius_about c balls).

(* --- Statements --- *)

(* A way to put a ball around balls. *)
Definition encloses_its_balls (of_balls : list (ball (vec R)) -> ball (vec R)) :=
  forall balls b, In b balls -> holds_ball (of_balls balls) b.

(* The ball holds every vertex of the node, deformed by Equation (1): v in S, of any joint-set, with any weights in the hull
   of its weight vertices whose blend is not 0. *)
Definition algorithm1_repaired_is_sound : Prop :=
  forall center_of_points of_balls (n : node) (z : posed_set) (w : list R) (v : vec R),
  encloses_its_balls of_balls -> In z (joint_sets n) -> is_weight_vertex_combination (weight_vertices z) w ->
  in_ball (reference n) v -> comb w (rotations z) <> lzero ->
  in_ball (algorithm1 center_of_points of_balls n) (deformed z w v).
(* The same for weight bounds whose weight vertices are listed, as the paper has it. *)
Definition algorithm1_repaired_is_sound_for_bounds : Prop :=
  forall center_of_points of_balls (n : node) (z : posed_set) bounds (w : list R) (v : vec R),
  encloses_its_balls of_balls -> In z (joint_sets n) -> lists_weight_vertices bounds (weight_vertices z) -> admits bounds w ->
  in_ball (reference n) v -> comb w (rotations z) <> lzero ->
  in_ball (algorithm1 center_of_points of_balls n) (deformed z w v).
(* Mean balls are such a way. *)
Definition mean_balls_enclose : Prop := encloses_its_balls mean_ball.

(* --- Proofs --- *)

Lemma all_nonzero_spec qs : all_nonzero qs = true <-> Forall (fun q => q <> lzero) qs.
Proof.
  unfold all_nonzero. rewrite forallb_forall, Forall_forall. split; intros F q I; specialize (F q I).
  - destruct (Req_EM_T (norm2 q) 0) as [|N]; [discriminate|]. intros ->. now rewrite norm2_zero in N.
  - destruct (Req_EM_T (norm2 q) 0) as [Z|]; [|reflexivity]. apply norm2_zero_inv in Z. contradiction.
Qed.

(* Lemma 2 takes the bound of the units' hull to that of the blends' hull. *)
Lemma bound_weight_vertex_rotations_sound center_of_points qs : bounds_rotations qs
  (bound_weight_vertex_rotations center_of_points qs).
Proof.
  unfold bound_weight_vertex_rotations. destruct (all_nonzero qs) eqn:Z; [|apply all_rotations_bound].
  apply all_nonzero_spec in Z. set (unit := map direction qs).
  assert (D : unit = divided (map norm qs) qs) by (symmetry; apply divided_by_norms).
  assert (U : Forall (fun n => norm2 n = 1) unit).
  { unfold unit. apply Forall_map. eapply Forall_impl; [|exact Z]. intros q. apply direction_unit. }
  destruct (rotation_bound_is_sound_holds unit (center_of_points unit) U) as (A & C & R & B).
  repeat split; auto; try apply C; try apply R. intros q x H N.
  destruct (same_rotations_repaired_holds qs q Z H N) as [_ (p & P & Np & <-)]. rewrite <- D in P. now apply B.
Qed.

Theorem algorithm1_repaired_is_sound_holds : algorithm1_repaired_is_sound.
Proof.
  intros cp ob n z w v Ob I W V N. unfold algorithm1. set (b := ob _).
  set (bound := bound_weight_vertex_rotations cp (weight_vertex_images (weight_vertices z) (rotations z))).
  destruct (bound_weight_vertex_rotations_sound cp (weight_vertex_images (weight_vertices z) (rotations z))) as
    (_ & C & _ & B). fold bound in B, C.
  set (F := Ball (center_ratio bound *: rotate (apex bound) (center (reference n) - rotation_center z))%V
    (radius_ratio bound * norm (center (reference n) - rotation_center z))).
  apply (joint_sets_repaired_holds [(z, F)] (reference n) b) with (F := F); auto; [|now left].
  intros z' F' [Q|[]]. injection Q as <- <-. split.
  - (* The turned p - r_c is in F. *)
    intros w' (u & U & Q) N'. unfold in_ball, F. cbn [center radius]. apply B; auto.
    exists u. split; [unfold weight_vertex_images; now rewrite map_length|]. now apply swap_sums.
  - (* The ball is around r'_k (+) F for every weight vertex. *)
    intros image Im. apply Ob, in_flat_map. exists z. split; [exact I|]. unfold joint_set_balls. apply in_map_iff.
    exists image. split; [reflexivity|exact Im].
Qed.

Theorem algorithm1_repaired_is_sound_for_bounds_holds : algorithm1_repaired_is_sound_for_bounds.
Proof.
  intros cp ob n z bounds w v Ob I L W V N. apply algorithm1_repaired_is_sound_holds; auto.
  apply (weight_vertices_span_repaired_holds bounds (weight_vertices z) w L); auto. symmetry. now apply admits_length.
Qed.

Lemma radius_about_bounds c balls b : In b balls -> norm (center b - c) + radius b <= radius_about c balls.
Proof.
  induction balls as [|d [|e bs] IH]; [intros []|intros [->|[]]; cbn; lra|].
  change (radius_about c (d :: e :: bs)) with (Rmax (norm (center d - c) + radius d) (radius_about c (e :: bs))).
  intros [->|I]; [apply Rmax_l|]. eapply Rle_trans; [apply IH, I|apply Rmax_r].
Qed.
Theorem mean_balls_enclose_holds : mean_balls_enclose.
Proof. intros balls b I. unfold holds_ball, mean_ball. cbn [center radius]. now apply radius_about_bounds. Qed.

(* The hypotheses can be met: two joints, one turned by half a turn about the z axis and moved, half-way. *)
Example algorithm1_instance :
  let z := PosedSet [Rigid (Quat 1 0 0 0) (Vec 0 0 0); Rigid (Quat 0 0 0 1) (Vec 5 0 0)] (Vec 0 0 0) [[1; 0]; [0; 1]] in
  let n := Node (Ball (Vec 2 0 0) 1) [z] in let w := [1 / 2; 1 / 2] in
  encloses_its_balls mean_ball /\ In z (joint_sets n) /\ lists_weight_vertices [(0, 1); (0, 1)] (weight_vertices z) /\
  admits [(0, 1); (0, 1)] w /\ is_weight_vertex_combination (weight_vertices z) w /\ in_ball (reference n) (Vec 2 1 0) /\
  comb w (rotations z) <> lzero.
Proof.
  cbv zeta. split; [exact mean_balls_enclose_holds|]. split; [now left|]. split; [exact weight_vertices_instance|].
    split; [|split; [|split]].
  - split; [repeat constructor; unfold within; cbn; lra|cbn; lra].
  - exists [1 / 2; 1 / 2]. split; [repeat split; [repeat constructor; lra|cbn; lra]|]. intros [|[|[|]]]; cbn; field.
  - unfold in_ball. cbn [center radius reference]. apply norm_le. split; vunfold; lra.
  - apply norm2_pos_inv. cbn. vunfold. lra.
Qed.
