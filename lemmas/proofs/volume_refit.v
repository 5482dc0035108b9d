(* SPDX-License-Identifier: MIT *)
(* algorithms/methods/refit/volume_refit.hpp: boxes, oriented boxes and k-DOPs around the control balls hold the node's vertices. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.b1_rational_bezier_simplex Refitlab.b2_control_hull_encloses Refitlab.control_hull.
Require Import Refitlab.s41_weight_vertices_span Refitlab.s44_joint_sets.
Import ListNotations.

(* --- The program --- *)

(* The volume with the given directions, of any length, around balls: in each, from the least to the greatest coordinate of a
   ball. A box has the three axes, an oriented box three others, a k-DOP k / 2 directions. *)
Definition greatest_coordinate (d : vec R) (balls : list (ball (vec R))) : R :=
  match balls with
  | [] => 0
  | b :: bs => fold_right (fun b m => Rmax (dot (center b) d + radius b * norm d) m) (dot (center b) d + radius b * norm d) bs
  end.
Definition in_volume_around (directions : list (vec R)) (balls : list (ball (vec R))) (x : vec R) :=
  forall d, In d directions ->
  - greatest_coordinate (-1 *: d)%V balls <= dot x d <= greatest_coordinate d balls.
Definition box_directions := [Vec 1 0 0; Vec 0 1 0; Vec 0 0 1].

(* --- Statements --- *)

(* The volume around the control balls of a node holds its deformed vertices. *)
Definition volume_refit_is_sound : Prop :=
  forall directions center_of_points widest_edge most_halvings pieces balls reference z w v,
  edges_are_valid widest_edge ->
  node_balls center_of_points widest_edge most_halvings pieces = Some balls ->
  In (reference, z) pieces -> is_weight_vertex_combination (weight_vertices z) w -> in_ball reference v -> comb w (rotations z) <> lzero ->
  in_volume_around directions balls (deformed z w v).
(* A half-space by the cone theorem: if (d, N_I) <= D W_I for all control points, whatever the signs of the W_I, then
   (d, v') <= D for every blend that is not 0. *)
Definition half_space_by_cone : Prop :=
  forall (weight_vertices : list (quat R * vec R)) (p rotation_center d : vec R) (D : R) (u : list R),
  Forall (fun point => dot (fst point) d <= D * snd point) (spherical_points (p - rotation_center)%V weight_vertices) ->
  convex (length weight_vertices) u -> comb u (map fst weight_vertices) <> lzero ->
  dot (skin_spherical (map fst weight_vertices) (map snd weight_vertices) rotation_center u p) d <= D.

(* --- Proofs --- *)

Lemma greatest_coordinate_bounds d balls b : In b balls -> dot (center b) d + radius b * norm d <= greatest_coordinate d balls.
Proof.
  assert (G : forall bs m, m <= fold_right (fun b m => Rmax (dot (center b) d + radius b * norm d) m) m bs /\
    (In b bs -> dot (center b) d + radius b * norm d <=
      fold_right (fun b m => Rmax (dot (center b) d + radius b * norm d) m) m bs)).
  { induction bs as [|c bs IH]; intros m; cbn [fold_right]; [split; [lra|intros []]|]. destruct (IH m) as [A B].
    split; [eapply Rle_trans; [exact A|apply Rmax_r]|].
    intros [->|I]; [apply Rmax_l|]. eapply Rle_trans; [now apply B|apply Rmax_r]. }
  destruct balls as [|c bs]; [intros []|]. intros [->|I]; cbn [greatest_coordinate].
  - apply (proj1 (G bs _)).
  - now apply (proj2 (G bs _)).
Qed.

Lemma ball_coordinate (b : ball (vec R)) (x d : vec R) : in_ball b x -> dot x d <= dot (center b) d + radius b * norm d.
Proof.
  unfold in_ball. intros X. pose proof (dot_le_norms (x - center b)%V d) as C. rewrite dot_sub_l in C.
  pose proof (norm_nonneg d). assert (norm (x - center b) * norm d <= radius b * norm d) by (apply Rmult_le_compat_r; auto). lra.
Qed.

Lemma volume_is_convex directions balls : convex_set (in_volume_around directions balls).
Proof.
  intros t x y T X Y d I. specialize (X d I). specialize (Y d I).
  replace (dot (t *: x + (1 - t) *: y) d) with (t * dot x d + (1 - t) * dot y d) by (dots; ring). nra.
Qed.

Lemma volume_holds_balls directions balls : holds_all (in_volume_around directions balls) balls.
Proof.
  intros b x I X d D. split.
  - pose proof (greatest_coordinate_bounds (-1 *: d)%V balls b I). pose proof (ball_coordinate b x (-1 *: d)%V X) as C.
    replace (dot x (-1 *: d)) with (- dot x d) in C by (dots; ring). lra.
  - pose proof (greatest_coordinate_bounds d balls b I). pose proof (ball_coordinate b x d X). lra.
Qed.

Theorem volume_refit_is_sound_holds : volume_refit_is_sound.
Proof.
  intros ds cp we mh pieces balls reference z w v V B I W X N.
  apply (control_hull_is_sound_holds cp we mh (in_volume_around ds balls) pieces balls reference); auto.
  - apply volume_is_convex.
  - apply volume_holds_balls.
Qed.

Lemma half_space_cone (d : vec R) D : cone (fun p : vec R * R => dot (fst p) d <= D * snd p).
Proof.
  split; [|intros x y|intros a x A]; cbn [fst snd lzero ladd lscale lin_pair lin_num zero add mul ops_R];
    rewrite ?dot_zero_l, ?dot_add_l, ?dot_scale_l; intros; nra.
Qed.
Theorem half_space_by_cone_holds : half_space_by_cone.
Proof.
  intros weight_vertices p c d D u F U N.
  pose proof (spherical_in_cone_holds _ weight_vertices (p - c)%V u (half_space_cone d D) U F) as G. cbv zeta in G.
    cbn [fst snd] in G.
  unfold skin_spherical, rotate. set (q := comb u (map fst weight_vertices)) in *. apply norm2_pos in N.
  rewrite dot_add_l, dot_scale_l in *. apply Rmult_le_reg_l with (1 := N).
  rewrite Rmult_plus_distr_l, <- Rmult_assoc, Rinv_r, Rmult_1_l by lra. lra.
Qed.

(* The hypotheses of volume_refit_is_sound can be met. Those of half_space_by_cone: a
   half-space with the control points of two rotations. *)
Definition volume_refit_instance := control_hull_instance.
Example half_space_instance :
  let weight_vertices := [(Quat 1 0 0 0, Vec 0 0 0); (Quat (3 / 5) (4 / 5) 0 0, Vec 0 0 0)] in let d := Vec 0 1 0 in
  Forall (fun point => dot (fst point) d <= 2 * snd point) (spherical_points (Vec 0 1 0 - Vec 0 0 0)%V weight_vertices) /\
  convex (length weight_vertices) [1 / 2; 1 / 2] /\ comb [1 / 2; 1 / 2] (map fst weight_vertices) <> lzero.
Proof.
  split; [|split; [repeat split; [repeat constructor; lra|cbn; lra]|apply norm2_pos_inv; cbn; vunfold; lra]].
  unfold spherical_points. cbn. repeat apply Forall_cons; try apply Forall_nil; cbn [fst snd]; vunfold; lra.
Qed.

(* The box is no larger than it has to be: around one ball it is that of the ball. *)
Example box_is_tight : in_volume_around box_directions [Ball (Vec 1 2 3) 1] (Vec 2 2 3) /\
  ~ in_volume_around box_directions [Ball (Vec 1 2 3) 1] (Vec 3 2 3).
Proof.
  assert (N : forall d : vec R, norm2 d = 1 -> norm d = 1) by (intros d; apply norm_unit).
  split.
  - intros d [<-|[<-|[<-|[]]]]; unfold greatest_coordinate; cbn [fold_right center radius];
      rewrite !N by (vunfold; ring); vunfold; lra.
  - intros V. specialize (V (Vec 1 0 0) (or_introl eq_refl)). unfold greatest_coordinate in V. cbn [fold_right center radius] in V.
    rewrite !N in V by (vunfold; ring). vunfold. lra.
Qed.
