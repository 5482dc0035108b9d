(* SPDX-License-Identifier: MIT *)
(* algorithms/runtime/refit/refit_linear.hpp: refitting for linear blend skinning [Kavan and Zara 2005a]. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.a1_affine_image Refitlab.s41_weight_vertices_span Refitlab.s42_linear_part_hull Refitlab.s44_joint_sets Refitlab.algorithm1_repaired.
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

(* Affine joints: maps x -> A x + b, and what each stretches at most. A ball's radius is multiplied by what the blend at the
   weight vertex stretches, or by the blend of what the joints stretch. *)
Record affine_set := AffineSet {
  maps : list (matrix R); offsets : list (vec R); stretches_of_joints : list R; listed : list (list R); stretch_at : list R -> R }.
Definition skin_affine (z : affine_set) (w : list R) (v : vec R) : vec R := comb w (affine_images (maps z) (offsets z) v).
Definition affine_balls (pieces : list (ball (vec R) * affine_set)) : list (ball (vec R)) :=
  flat_map (fun '(reference, z) =>
    map (fun c => Ball (skin_affine z c (center reference)) (stretch_at z c * radius reference)) (listed z)) pieces.

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

Definition is_affine_set (z : affine_set) :=
  Forall2 stretches (maps z) (stretches_of_joints z) /\ length (offsets z) = length (maps z) /\
  Forall (fun c => convex (length (maps z)) c /\
    (stretches (comb c (maps z)) (stretch_at z c) \/ comb c (stretches_of_joints z) <= stretch_at z c)) (listed z).
Definition refit_affine_is_sound : Prop :=
  forall of_balls pieces reference z w v, encloses_its_balls of_balls ->
  In (reference, z) pieces -> is_affine_set z -> is_weight_vertex_combination (listed z) w -> in_ball reference v ->
  in_ball (of_balls (affine_balls pieces)) (skin_affine z w v).

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

Theorem refit_affine_is_sound_holds : refit_affine_is_sound.
Proof.
  intros ob pieces reference z w v O I (S & L & C) (u & U & Q) V. unfold skin_affine. rewrite (swap_sums u (listed z) w) by auto.
  apply convex_set_comb; [apply ball_convex|unfold weight_vertex_images; now rewrite map_length|].
  apply Forall_map, Forall_forall. intros c Ic. rewrite Forall_forall in C. destruct (C c Ic) as [(_ & P & _) By].
  pose (b := Ball (skin_affine z c (center reference)) (stretch_at z c * radius reference)).
  apply (ball_around_balls ob (affine_balls pieces) O b).
  - apply in_flat_map. exists (reference, z). split; [exact I|]. apply in_map_iff. now exists c.
  - destruct reference as [p r]. apply (blend_is_in_control_ball_holds _ _ (stretches_of_joints z)); auto.
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
(* And a joint that doubles lengths beside one that keeps them. *)
Example refit_affine_instance :
  let doubled := (Vec 2 0 0, Vec 0 2 0, Vec 0 0 2) in let kept := (Vec 1 0 0, Vec 0 1 0, Vec 0 0 1) in
  let z := AffineSet [doubled; kept] [Vec 0 0 0; Vec 5 0 0] [2; 1] [[1; 0]; [0; 1]] (fun c => comb c [2; 1]) in
  is_affine_set z /\ is_weight_vertex_combination (listed z) [1 / 2; 1 / 2].
Proof.
  split; [split; [|split; [reflexivity|]]|].
  - repeat apply Forall2_cons; try apply Forall2_nil; (split; [lra|]); unfold squared_stretch, row_sum; cbn [fst snd];
      vunfold; repeat apply Rmax_lub; rewrite !Rabs_pos_eq by lra; lra.
  - repeat apply Forall_cons; try apply Forall_nil;
      (split; [split; [reflexivity|]; split; [repeat constructor; lra|cbn; lra]|right; apply Rle_refl]).
  - apply algorithm1_instance.
Qed.
