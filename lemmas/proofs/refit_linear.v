(* SPDX-License-Identifier: MIT *)
(* algorithms/runtime/refit/linear.hpp: refitting for linear blend skinning [Kavan and Zara 2005a]. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.s41_weight_vertices_span Refitlab.s42_linear_part_hull Refitlab.s44_joint_sets Refitlab.algorithm1_repaired.
Require Import Refitlab.control_hull.
Import ListNotations.

(* --- The program --- *)

(* sum w_i C_{j_i} v *)
Definition skin_linear (z : posed_set) (w : list R) (v : vec R) : vec R :=
  comb w (map (fun c => apply_rigid c v) (transforms z)).
(* The balls of the reference ball's radius about the weight vertex-blended images of its center. *)
Definition linear_balls (pieces : list (ball (vec R) * posed_set)) : list (ball (vec R)) :=
  flat_map (fun '(reference, z) =>
    map (fun c => Ball (skin_linear z c (center reference)) (radius reference)) (weight_vertices z)) pieces.

(* --- Statements --- *)

(* The joints are rigid, and the weight vertices' weights are convex. *)
Definition is_rigid_set (z : posed_set) :=
  Forall (fun c => rotation c <> lzero) (transforms z) /\ Forall (convex (length (transforms z))) (weight_vertices z).
(* Any convex set that holds the balls holds every deformed vertex; and so does one ball around them. *)
Definition linear_balls_are_sound : Prop :=
  forall (K : vec R -> Prop) pieces reference z w v, convex_set K -> holds_all K (linear_balls pieces) ->
  In (reference, z) pieces -> is_rigid_set z -> is_weight_vertex_combination (weight_vertices z) w -> in_ball reference v ->
    K (skin_linear z w v).
Definition refit_linear_is_sound : Prop :=
  forall of_balls pieces reference z w v, encloses_its_balls of_balls ->
  In (reference, z) pieces -> is_rigid_set z -> is_weight_vertex_combination (weight_vertices z) w -> in_ball reference v ->
  in_ball (of_balls (linear_balls pieces)) (skin_linear z w v).

(* --- Proofs --- *)

(* A convex combination of rigid images of a ball is in the ball of the same radius about that of its center's images. *)
Lemma rigid_images_stay (cs : list rigid) (w : list R) (p v : vec R) : Forall (fun c => rotation c <> lzero) cs ->
  convex (length cs) w ->
  norm (comb w (map (fun c => apply_rigid c v) cs) - comb w (map (fun c => apply_rigid c p) cs)) <= norm (v - p).
Proof.
  intros N (L & P & S). replace (norm (v - p)) with (sum w * norm (v - p)) by (rewrite S; ring). clear S.
  revert w L P; induction N as [|c cs Nc N IH]; intros [|a w] L P; try discriminate; cbn [map comb].
  - replace (lzero - lzero)%V with (lzero : vec R) by vec_ring. rewrite norm_zero. cbn. lra.
  - apply Forall_cons_iff in P as [A P]. specialize (IH w ltac:(auto) P). rewrite sum_cons.
    assert (D : (apply_rigid c v - apply_rigid c p)%V = rotate (rotation c) (v - p))
      by (unfold apply_rigid; rewrite rotate_sub; vec_ring).
    replace (_ - _)%V with (a *: (apply_rigid c v - apply_rigid c p) +
      (comb w (map (fun c => apply_rigid c v) cs) - comb w (map (fun c => apply_rigid c p) cs)))%V by vec_ring.
    rewrite D.
    eapply Rle_trans; [apply norm_add|]. rewrite norm_scale, rotate_norm by auto. lra.
Qed.

Theorem linear_balls_are_sound_holds : linear_balls_are_sound.
Proof.
  intros K pieces reference z w v C H I [Ro Co] (u & U & Q) V. unfold skin_linear.
    rewrite (swap_sums u (weight_vertices z) w) by auto.
  apply convex_set_comb; auto; [unfold weight_vertex_images; now rewrite map_length|].
  apply Forall_map, Forall_forall. intros c Ic. rewrite Forall_forall in Co.
  apply (H (Ball (skin_linear z c (center reference)) (radius reference))).
  - apply in_flat_map. exists (reference, z). split; [exact I|]. apply in_map_iff. now exists c.
  - unfold in_ball. cbn [center radius]. eapply Rle_trans; [|exact V]. now apply rigid_images_stay; auto.
Qed.

Theorem refit_linear_is_sound_holds : refit_linear_is_sound.
Proof.
  intros ob pieces reference z w v O I Ri W V. apply (linear_balls_are_sound_holds _ pieces reference); auto.
  - apply ball_convex.
  - now apply ball_around_balls.
Qed.

(* The hypotheses can be met: the joint-set of algorithm1_instance. *)
Example refit_linear_instance :
  let z := PosedSet [Rigid (Quat 1 0 0 0) (Vec 0 0 0); Rigid (Quat 0 0 0 1) (Vec 5 0 0)] (Vec 0 0 0) [[1; 0]; [0; 1]] in
  is_rigid_set z /\ is_weight_vertex_combination (weight_vertices z) [1 / 2; 1 / 2].
Proof.
  split; [split|].
  - repeat apply Forall_cons; try apply Forall_nil; apply norm2_pos_inv; cbn [rotation]; vunfold; lra.
  - repeat apply Forall_cons; try apply Forall_nil; (split; [reflexivity|]; split; [repeat constructor; lra|cbn; lra]).
  - apply algorithm1_instance.
Qed.
