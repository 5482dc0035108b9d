(* SPDX-License-Identifier: MIT *)
(* algorithms/methods/refit/algorithm1_printed.hpp: Algorithm 1 of the paper (section 4.5) as printed. It is not sound. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.lemma4_quaternion_hull Refitlab.rotation_bound Refitlab.s43_distance_range Refitlab.algorithm1_repaired.
Require Import Refitlab.s41_weight_vertices_span Refitlab.s42_linear_part_hull Refitlab.s44_sum_of_bounds Refitlab.s44_joint_sets.
Import ListNotations.

(* --- The program, over the real numbers: with the skinning's own signs --- *)

Definition printed_balls (center_of_points : list (quat R) -> quat R) (p : vec R) (z : posed_set) : list (ball (vec R)) :=
  let unit := map direction (weight_vertex_images (weight_vertices z) (rotations z)) in                 (* lines 8 to 10 *)
  let c := center_of_points unit in                                                     (* line 11 *)
  let r := sqrt (largest_squared_distance c unit) in
  let d := hull_distance c r in                                                         (* line 13: alpha = 2 arccos d *)
  let cos_alpha := 2 * (d * d) - 1 in
  let sin_alpha := 2 * d * sqrt (1 - d * d) in
  let u := (p - rotation_center z)%V in
  map (fun image => Ball (image + cos_alpha *: rotate (direction c) u)%V (sin_alpha * norm u))  (* lines 12, 14, 15 *)
    (weight_vertex_images (weight_vertices z) (center_images z)).
Definition algorithm1_printed (center_of_points : list (quat R) -> quat R) (of_balls : list (ball (vec R)) -> ball (vec R))
  (n : node) : ball (vec R) :=
  inflate (of_balls (flat_map (printed_balls center_of_points (center (reference n))) (joint_sets n)))
    (radius (reference n)).                                                             (* line 16 *)

(* --- Statements --- *)

(* With mean balls throughout: the ball holds every deformed vertex, even if no norm that it divides by is 0. *)
Definition algorithm1_printed_is_sound : Prop :=
  forall (n : node) (z : posed_set) (w : list R) (v : vec R),
  In z (joint_sets n) -> is_weight_vertex_combination (weight_vertices z) w -> in_ball (reference n) v ->
  comb w (rotations z) <> lzero ->
  Forall (fun q => q <> lzero) (weight_vertex_images (weight_vertices z) (rotations z)) ->
  mean (map direction (weight_vertex_images (weight_vertices z) (rotations z))) <> lzero ->
  in_ball (algorithm1_printed mean mean_ball n) (deformed z w v).
(* Line 9 divides by ||q'_k||, for unit quaternions and the weight vertices of weight bounds. *)
Definition line_9_is_defined : Prop :=
  forall bounds weight_vertices (qs : list (quat R)), lists_weight_vertices bounds weight_vertices ->
    length bounds = length qs ->
  Forall (fun q => norm2 q = 1) qs -> Forall (fun q => q <> lzero) (weight_vertex_images weight_vertices qs).
(* Line 3 takes quaternions from matrices, which are the same for q and -q: the blend is as good as the skinning's. *)
Definition line_3_keeps_blends : Prop :=
  exists of_matrix : quat R -> quat R, (forall q, of_matrix (-1 *: q)%V = of_matrix q) /\
  forall (qs : list (quat R)) (w : list R) x, Forall (fun q => norm2 q = 1) qs -> convex (length qs) w ->
  rotate (comb w (map of_matrix qs)) x = rotate (comb w qs) x.

(* --- Proofs --- *)

Lemma direction_of_unit {E} `{Euclid E} (q : E) : norm2 q = 1 -> direction q = q.
Proof. intros U. unfold direction. rewrite (norm_unit q U). vec_field. Qed.

Lemma mean_ball_of_same (b : ball (vec R)) : mean_ball [b; b; b; b] = b.
Proof.
  destruct b as [c r]. unfold mean_ball. cbn [map center]. assert (M : mean [c; c; c; c] = c).
  { unfold mean. cbn [length repeat comb INR]. vec_field. }
  rewrite M. f_equal. cbn [radius_about center radius]. replace (c - c)%V with (lzero : vec R) by vec_ring.
  rewrite norm_zero, Rplus_0_l. now rewrite !(Rmax_left r r) by lra.
Qed.

(* Three joints at rest and one turned by (1/2, 1/2, 1/2, 1/2): their mean has cos alpha = -1/26, and the vertex (1, 0, 0),
   blended with equal weights, is on the wrong side of the printed ball's center. *)
Theorem algorithm1_printed_is_false : ~ algorithm1_printed_is_sound.
Proof.
  intros P. set (one := Quat 1 0 0 0). set (far := Quat (1 / 2) (1 / 2) (1 / 2) (1 / 2)). set (o := Vec 0 0 0).
  set (z := PosedSet [Rigid one o; Rigid one o; Rigid one o; Rigid far o] o [[1; 0; 0; 0]; [0; 1; 0; 0]; [0; 0; 1; 0]; [0; 0; 0; 1]]).
  set (x := Vec 1 0 0). set (n := Node (Ball x 0) [z]). set (w := [1 / 4; 1 / 4; 1 / 4; 1 / 4]).
  set (c := Quat (7 / 8) (1 / 8) (1 / 8) (1 / 8)).
  assert (Q : weight_vertex_images (weight_vertices z) (rotations z) = [one; one; one; far]).
  { unfold weight_vertex_images, rotations, z. cbn [weight_vertices transforms map rotation comb]. unfold one, far.
    repeat f_equal; vunfold; f_equal; ring. }
  assert (U : map direction [one; one; one; far] = [one; one; one; far]).
  { cbn [map]. rewrite !direction_of_unit by (unfold one, far; vunfold; field). reflexivity. }
  assert (C : mean [one; one; one; far] = c).
  { unfold mean, one, far, c. cbn [length repeat comb INR]. vunfold. f_equal; field. }
  assert (C2 : norm2 c = 13 / 16) by (unfold c; vunfold; field).
  assert (Nc : c <> lzero) by (apply norm2_pos_inv; lra).
  assert (B : comb w (rotations z) = c).
  { unfold w, rotations, z, c, one, far. cbn [transforms map rotation comb]. vunfold. f_equal; field. }
  assert (I0 : forall u, convex 4 u -> comb u [o; o; o; o] = o).
  { intros u (L & _ & S). change [o; o; o; o] with (repeat o 4). rewrite (comb_same u o 4 L). unfold o. generalize (sum u). vring. }
  assert (Zr : forall q, q <> lzero -> apply_rigid (Rigid q o) o = o).
  { intros q N. unfold apply_rigid. cbn [rotation translation]. replace (rotate q o) with (lzero : vec R); [unfold o; vring|].
    symmetry. apply norm2_zero_inv. rewrite rotate_norm2 by exact N. unfold o. vunfold. ring. }
  assert (Im : center_images z = [o; o; o; o]).
  { unfold center_images, z. cbn [transforms rotation_center map].
    rewrite !Zr by (apply norm2_pos_inv; unfold one, far; vunfold; lra). reflexivity. }
  assert (Ci : weight_vertex_images (weight_vertices z) (center_images z) = [o; o; o; o]).
  { rewrite Im. unfold weight_vertex_images, z. cbn [weight_vertices map].
    rewrite !I0 by (repeat split; [repeat constructor; lra|cbn; lra]). reflexivity. }
  assert (F : largest_squared_distance c [one; one; one; far] = 9 / 16).
  { cbn [largest_squared_distance]. replace (norm2 (one - c)) with (1 / 16) by (unfold one, c; vunfold; field).
    replace (norm2 (far - c)) with (9 / 16) by (unfold far, c; vunfold; field).
    rewrite (Rmax_left (9 / 16) 0), !(Rmax_right (1 / 16) (9 / 16)) by lra. reflexivity. }
  set (d := hull_distance c (sqrt (9 / 16))).
  assert (D : d * d = 25 / 52).
  { unfold d, hull_distance. rewrite C2, sqrt_sqrt by lra. apply norm_pos in Nc. pose proof (norm_sq c) as S. rewrite C2 in S.
    replace (_ / _ * (_ / _)) with (25 / 16 / (4 * (norm c * norm c))) by (field; lra). rewrite S. field. }
  set (s := 2 * d * sqrt (1 - d * d)).
  assert (S1 : s <= 1).
  { apply sq_le_inv; [lra|]. unfold s. pose proof (sqrt_sqrt (1 - d * d) ltac:(lra)) as S.
    replace (2 * d * sqrt (1 - d * d) * (2 * d * sqrt (1 - d * d))) with
      (4 * (d * d) * (sqrt (1 - d * d) * sqrt (1 - d * d))) by ring. rewrite S, D. lra. }
  set (y := rotate c x).
  assert (Y : norm2 y = 1) by (unfold y; rewrite rotate_norm2 by exact Nc; unfold x; vunfold; ring).
  assert (A : algorithm1_printed mean mean_ball n = Ball (o + (2 * (d * d) - 1) *: y)%V (s * 1 + 0)).
  { unfold algorithm1_printed, n. cbn [reference joint_sets flat_map center radius]. rewrite app_nil_r.
    unfold printed_balls. rewrite Q, U, C, F, Ci. cbn [map rotation_center].
    replace (x - rotation_center z)%V with x by (unfold x, z, o; cbn [rotation_center]; vunfold; f_equal; ring).
    rewrite mean_ball_of_same. unfold inflate. cbn [center radius]. fold d s.
    rewrite (norm_unit x) by (unfold x; vunfold; ring). unfold direction. rewrite rotate_of_multiple; [reflexivity| |exact Nc].
    apply norm_pos in Nc. pose proof (inv_pos _ Nc). lra. }
  assert (V : deformed z w x = y).
  { unfold deformed, skin_spherical. rewrite B, Im, I0 by (unfold w; repeat split; [repeat constructor; lra|cbn; lra]).
    replace (x - rotation_center z)%V with x by (unfold x, z, o; cbn [rotation_center]; vunfold; f_equal; ring).
    fold y. unfold o. destruct y as [y1 y2 y3]. vunfold. f_equal; ring. }
  specialize (P n z w x). rewrite A, V in P.
  assert (G : in_ball (Ball (o + (2 * (d * d) - 1) *: y)%V (s * 1 + 0)) y).
  { apply P.
    - now left.
    - exists w. unfold w, z. cbn [weight_vertices]. split; [repeat split; [repeat constructor; lra|cbn; lra]|].
      intros [|[|[|[|[|]]]]]; cbn; field.
    - unfold in_ball, n. cbn [reference center radius]. right. apply norm_eq; [lra|]. unfold x. vunfold. ring.
    - now rewrite B.
    - rewrite Q. repeat apply Forall_cons; try apply Forall_nil; apply norm2_pos_inv; unfold one, far; vunfold; lra.
    - now rewrite Q, U, C. }
  unfold in_ball in G. cbn [center radius] in G. rewrite D in G.
  replace (y - (o + (2 * (25 / 52) - 1) *: y))%V with ((27 / 26) *: y)%V in G
    by (unfold o; generalize y; vfield). rewrite norm_scale, (norm_unit y Y) in G by lra. lra.
Qed.

(* 1 and -1 with weights of one half each. *)
Theorem line_9_is_defined_is_false : ~ line_9_is_defined.
Proof.
  intros P. specialize (P [(1 / 2, 1 / 2); (1 / 2, 1 / 2)] [[1 / 2; 1 / 2]] [Quat 1 0 0 0; Quat (-1) 0 0 0]).
  assert (F : Forall (fun q => q <> lzero) (weight_vertex_images [[1 / 2; 1 / 2]] [Quat 1 0 0 0; Quat (-1) 0 0 0])).
  { apply P; [|reflexivity|repeat apply Forall_cons; try apply Forall_nil; vunfold; ring].
    split.
    - intros c [<-|[]]. split; [repeat constructor; unfold within; cbn; lra|cbn; lra].
    - intros w [F S] _. inversion F as [|b x bs v X F1]; subst. inversion F1 as [|c y cs u Y F2]; subst. inversion F2; subst.
      unfold within in *. cbn in *. left. repeat f_equal; lra. }
  apply Forall_cons_iff in F as [N _]. apply N. cbn [comb]. vunfold. f_equal; field.
Qed.

(* 1/2 (3/5, 4/5, 0, 0) + 1/2 (-3/5, 4/5, 0, 0) is half a turn, with the negative of the second it is none. *)
Theorem line_3_keeps_blends_is_false : ~ line_3_keeps_blends.
Proof.
  intros (M & S & P). set (p := Quat (3 / 5) (4 / 5) 0 0). set (q := Quat (- (3 / 5)) (4 / 5) 0 0). set (y := Vec 0 1 0).
  assert (W : convex 2 [1 / 2; 1 / 2]) by (repeat split; [repeat constructor; lra|cbn; lra]).
  assert (U : norm2 p = 1 /\ norm2 q = 1 /\ norm2 (-1 *: q) = 1) by (unfold p, q; repeat split; vunfold; field).
  destruct U as (Up & Uq & Uo).
  assert (A := P [p; q] [1 / 2; 1 / 2] y ltac:(auto) W). assert (B := P [p; (-1 *: q)%V] [1 / 2; 1 / 2] y ltac:(auto) W).
  cbn [map] in A, B. rewrite S, A in B.
  replace (comb [1 / 2; 1 / 2] [p; q]) with (Quat 0 (4 / 5) 0 0) in B by (unfold p, q; cbn [comb]; vunfold; f_equal; field).
  replace (comb [1 / 2; 1 / 2] [p; (-1 *: q)%V]) with (Quat (3 / 5) 0 0 0) in B
    by (unfold p, q; cbn [comb]; vunfold; f_equal; field).
  unfold rotate in B. replace (norm2 (Quat 0 (4 / 5) 0 0)) with (16 / 25) in B by (vunfold; field).
  replace (norm2 (Quat (3 / 5) 0 0 0)) with (9 / 25) in B by (vunfold; field).
  apply (f_equal vy) in B. unfold y in B. vunfold. lra.
Qed.
