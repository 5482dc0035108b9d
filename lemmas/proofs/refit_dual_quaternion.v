(* SPDX-License-Identifier: MIT *)
(* algorithms/runtime/refit/refit_dual_quaternion.hpp: refitting for dual quaternion skinning. *)
From Coq Require Import List Reals Lra Psatz Lia.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.b1_rational_bezier_simplex Refitlab.b2_control_hull_encloses Refitlab.b3_subdivision.
Require Import Refitlab.b6_dual_quaternion_ball Refitlab.algorithm1_repaired Refitlab.control_hull.
Require Import Refitlab.s41_weight_vertices_span Refitlab.s42_linear_part_hull Refitlab.s44_joint_sets.
Import ListNotations.

(* --- The program --- *)

Definition duals (z : posed_set) := map dual_of (transforms z).
Definition deformed_dual (z : posed_set) (w : list R) (v : vec R) := skin_dual (rotations z) (duals z) w v.
Definition dual_weight_vertices (z : posed_set) : list (quat R * quat R) :=
  map (fun c => (comb c (rotations z), comb c (duals z))) (weight_vertices z).

Section Dual.
(* The axis and the middle are found in any way. *)
Context (axis_of : list (quat R) -> quat R) (middle_of : list (quat R * quat R) -> vec R)
  (widest_edge : list (quat R * quat R) -> nat * nat) (most_halvings : nat).
Definition emit_dual (p : vec R) (r : R) (cs : list (quat R * quat R)) : list (ball (vec R)) :=
  map (fun point => Ball (position point) r) (dual_points p cs).
Definition are_ahead (a : quat R) (cs : list (quat R * quat R)) : bool :=
  forallb (fun c => if Rlt_dec 0 (dot (fst c) a) then true else false) cs.
Fixpoint squared_reach (p f : vec R) (a : quat R) (cs : list (quat R * quat R)) : R :=
  match cs with
  | [] => 0
  | c :: cs => Rmax (norm2 (reach_at p f c) / (dot (fst c) a * dot (fst c) a)) (squared_reach p f a cs)
  end.
(* The ball of b6_dual_quaternion_ball if all are ahead of the axis; else there is no bound. *)
Definition fall_back_dual (p : vec R) (r : R) (cs : list (quat R * quat R)) : balls_or_all :=
  let a := axis_of (map fst cs) in let f := middle_of cs in
  if are_ahead a cs then Some [Ball f (r + sqrt (squared_reach p f a cs * norm2 a))] else None.
Definition cover_dual (p : vec R) (r : R) : nat -> list (quat R * quat R) -> balls_or_all :=
  cover (all_near 2) (emit_dual p r) (fall_back_dual p r) widest_edge.
Definition dual_piece_balls (reference : ball (vec R)) (z : posed_set) : balls_or_all :=
  match dual_weight_vertices z with
  | [(q, d)] =>
    if Req_EM_T (norm2 q) 0 then cover_dual (center reference) (radius reference) 0 [(q, d)]
    else Some [Ball (skin_dual [q] [d] [1] (center reference)) (radius reference)]
  | cs => cover_dual (center reference) (radius reference) most_halvings cs
  end.
Fixpoint dual_node_balls (pieces : list (ball (vec R) * posed_set)) : balls_or_all :=
  match pieces with
  | [] => Some []
  | (reference, z) :: more => join (dual_piece_balls reference z) (dual_node_balls more)
  end.
(* One ball around them; a single one is its own. *)
Definition refit_dual_quaternion (of_balls : list (ball (vec R)) -> ball (vec R))
  (pieces : list (ball (vec R) * posed_set)) : option (ball (vec R)) :=
  match dual_node_balls pieces with
  | None => None
  | Some [b] => Some b
  | Some bs => Some (of_balls bs)
  end.
End Dual.

(* --- Statements --- *)

(* Where there are control balls, any convex set that holds them holds every deformed vertex. *)
Definition dual_hull_is_sound : Prop :=
  forall axis_of middle_of widest_edge most_halvings (K : vec R -> Prop) pieces balls reference z w v,
  edges_are_valid widest_edge -> convex_set K ->
  dual_node_balls axis_of middle_of widest_edge most_halvings pieces = Some balls -> holds_all K balls ->
  In (reference, z) pieces -> is_weight_vertex_combination (weight_vertices z) w -> in_ball reference v -> comb w (rotations z) <> lzero ->
  K (deformed_dual z w v).
(* Where it is not all of space, the ball of the program holds every deformed vertex. *)
Definition refit_dual_quaternion_is_sound : Prop :=
  forall axis_of middle_of widest_edge most_halvings of_balls pieces b reference z w v,
  edges_are_valid widest_edge -> encloses_its_balls of_balls ->
  refit_dual_quaternion axis_of middle_of widest_edge most_halvings of_balls pieces = Some b ->
  In (reference, z) pieces -> is_weight_vertex_combination (weight_vertices z) w -> in_ball reference v -> comb w (rotations z) <> lzero ->
  in_ball b (deformed_dual z w v).
(* The duals make what they stand for: with one joint, its rigid transform. *)
Definition dual_is_rigid : Prop :=
  forall (c : rigid) (v : vec R), rotation c <> lzero -> skin_dual [rotation c] [dual_of c] [1] v = apply_rigid c v.

(* --- Proofs --- *)

Definition dual_image (p : vec R) (c : quat R * quat R) : vec R := skin_dual [fst c] [snd c] [1] p.
Definition dual_goal (K : vec R -> Prop) (p : vec R) (r : R) (c : quat R * quat R) :=
  fst c <> lzero -> forall y, norm y <= r -> K (dual_image p c + y)%V.

Lemma comb_single {E} `{Euclid E} (x : E) : comb [1] [x] = x.
Proof. cbn [comb]. vec_ring. Qed.
Lemma dual_image_blend p qs ds u : dual_image p (comb u qs, comb u ds) = skin_dual qs ds u p.
Proof. unfold dual_image, skin_dual. cbn [fst snd]. now rewrite !comb_single. Qed.

Lemma emit_dual_sound (K : vec R -> Prop) p r cs c : convex_set K -> all_near 2 cs = true ->
  holds_all K (emit_dual p r cs) -> in_hull cs c -> dual_goal K p r c.
Proof.
  intros C N B (u & U & ->) Nz y Y. rewrite comb_pair. rewrite dual_image_blend.
  assert (Wp : weights_are_positive (dual_points p cs)).
  { apply (pairs_are_enough_holds [] cs p p). now apply all_near_positive with 2. }
  destruct (dual_in_hull_holds cs p u Wp U) as [_ H]. apply convex_set_around_balls with (1 := C) (2 := H).
  intros x X. apply in_map_iff in X as (pt & <- & I). apply (B (Ball (position pt) r)).
  - unfold emit_dual. apply in_map_iff. now exists pt.
  - now apply in_point_ball.
Qed.

Lemma squared_reach_bounds p f a cs c : In c cs -> norm2 (reach_at p f c) / (dot (fst c) a * dot (fst c) a) <= squared_reach p f a cs.
Proof.
  induction cs as [|d cs IH]; [intros []|]. cbn [squared_reach].
  intros [->|I]; [apply Rmax_l|]. eapply Rle_trans; [now apply IH|apply Rmax_r].
Qed.

Lemma fall_back_dual_sound axis_of middle_of (K : vec R -> Prop) p r cs bs c : 
  fall_back_dual axis_of middle_of p r cs = Some bs -> holds_all K bs -> in_hull cs c -> dual_goal K p r c.
Proof.
  intros F B (u & U & ->) Nz y Y. rewrite comb_pair, dual_image_blend. unfold fall_back_dual in F.
  set (a := axis_of (map fst cs)) in *. set (f := middle_of cs) in *.
  destruct (are_ahead a cs) eqn:A; [|discriminate]. injection F as <-.
  set (reach := sqrt (squared_reach p f a cs * norm2 a)) in *.
  destruct (dual_quaternion_ball_holds cs a p f reach u) as [_ I]; auto.
  - intros c I. unfold are_ahead in A. rewrite forallb_forall in A. specialize (A c I).
    destruct (Rlt_dec 0 (dot (fst c) a)) as [D|]; [|discriminate]. split; [exact D|].
    pose proof (squared_reach_bounds p f a cs c I) as S. set (e := norm (reach_at p f c) / dot (fst c) a).
    assert (E0 : 0 <= e) by (apply Rmult_le_pos; [apply norm_nonneg|left; now apply inv_pos]).
    assert (E2 : e * e = norm2 (reach_at p f c) / (dot (fst c) a * dot (fst c) a)).
    { unfold e. rewrite <- (norm_sq (reach_at p f c)). field. lra. }
    rewrite <- E2 in S. pose proof (norm2_nonneg a). pose proof (norm_nonneg a).
    apply sq_le_inv; [apply sqrt_pos|]. unfold reach. rewrite sqrt_sqrt by nra. rewrite <- norm_sq. nra.
  - apply (B (Ball f (r + reach))); [now left|]. unfold in_ball in *. cbn [center radius] in *.
    replace (skin_dual (map fst cs) (map snd cs) u p + y - f)%V with
      ((skin_dual (map fst cs) (map snd cs) u p - f) + y)%V by vec_ring.
    eapply Rle_trans; [apply norm_add|]. lra.
Qed.

Lemma dual_piece_balls_sound axis_of middle_of widest_edge most_halvings K reference z balls w v :
  edges_are_valid widest_edge -> convex_set K ->
  dual_piece_balls axis_of middle_of widest_edge most_halvings reference z = Some balls -> holds_all K balls ->
  is_weight_vertex_combination (weight_vertices z) w -> in_ball reference v -> comb w (rotations z) <> lzero ->
    K (deformed_dual z w v).
Proof.
  intros V C B H (u & U & Q) X N.
  assert (In : in_hull (dual_weight_vertices z) (comb w (rotations z), comb w (duals z))).
  { exists u. split; [unfold dual_weight_vertices; now rewrite map_length|]. unfold dual_weight_vertices.
    rewrite comb_pair, !map_map. cbn [fst snd].
    rewrite (swap_sums u (weight_vertices z) w (rotations z) Q), (swap_sums u (weight_vertices z) w (duals z) Q).
      reflexivity. }
  assert (G : dual_goal K (center reference) (radius reference) (comb w (rotations z), comb w (duals z))).
  { assert (Cov : forall h cs bs c, h = 0%nat \/ (2 <= length cs)%nat ->
      cover_dual axis_of middle_of widest_edge (center reference) (radius reference) h cs = Some bs -> holds_all K bs ->
      in_hull cs c -> dual_goal K (center reference) (radius reference) c).
    { apply cover_sound; auto.
      - intros cs c A E I. apply emit_dual_sound with cs; auto.
      - intros cs bs c A E I. apply fall_back_dual_sound with axis_of middle_of cs bs; auto. }
    unfold dual_piece_balls in B. destruct (dual_weight_vertices z) as [|[q d] [|c2 cs]] eqn:P.
    - destruct In as (b & Cb & _). now apply convex_not_empty in Cb.
    - destruct (Req_EM_T (norm2 q) 0) as [Z|Z].
      + apply (Cov 0%nat [(q, d)] balls); auto.
      + injection B as <-. intros _ y Y. apply single_hull in In. injection In as -> ->.
        apply (H (Ball (skin_dual [q] [d] [1] (center reference)) (radius reference))); [now left|]. now apply in_point_ball.
    - apply (Cov most_halvings ((q, d) :: c2 :: cs) balls); auto. right. cbn. lia. }
  specialize (G N (rotate (comb w (rotations z)) (v - center reference))). rewrite dual_image_blend in G.
  unfold deformed_dual. rewrite (skin_dual_moves _ _ w (center reference) v). apply G. now rewrite rotate_norm.
Qed.

Theorem dual_hull_is_sound_holds : dual_hull_is_sound.
Proof.
  intros ax mi we mh K pieces. induction pieces as [|[S z0] pieces IH]; intros balls reference z w v V C B H I W X N; [destruct I|].
  cbn [dual_node_balls] in B. destruct (dual_piece_balls ax mi we mh S z0) as [b1|] eqn:B1; [|discriminate].
  destruct (dual_node_balls ax mi we mh pieces) as [b2|] eqn:B2; [|discriminate]. injection B as <-.
  destruct I as [E|I]; [injection E as -> ->|].
  - apply (dual_piece_balls_sound ax mi we mh K reference z b1); auto. intros b y A. apply H. apply in_or_app. now left.
  - apply (IH b2 reference); auto. intros b y A. apply H. apply in_or_app. now right.
Qed.

Theorem refit_dual_quaternion_is_sound_holds : refit_dual_quaternion_is_sound.
Proof.
  intros ax mi we mh ob pieces b reference z w v V O B I W X N. unfold refit_dual_quaternion in B.
  destruct (dual_node_balls ax mi we mh pieces) as [balls|] eqn:Bs; [|discriminate].
  apply (dual_hull_is_sound_holds ax mi we mh (in_ball b) pieces balls reference); auto; [apply ball_convex|].
  destruct balls as [|b1 [|b2 bs]]; injection B as <-.
  - now apply ball_around_balls.
  - intros c x [->|[]] Z. exact Z.
  - now apply ball_around_balls.
Qed.

Theorem dual_is_rigid_holds : dual_is_rigid.
Proof.
  intros [q t] v N. cbn [rotation] in *. unfold skin_dual, apply_rigid, rotate. cbv zeta. rewrite !comb_single.
  unfold dual_of. cbn [rotation translation].
  replace (2 *: im (qmul (1 / 2 *: qmul (pure t) q) (conj q)))%V with (norm2 q *: t)%V.
  - apply norm2_pos in N. revert N. generalize (norm2 q) (turned q v q). intros n x N. vec_field. lra.
  - assert (L : qmul (1 / 2 *: qmul (pure t) q)%V (conj q) = (1 / 2 *: (norm2 q *: pure t))%V).
    { generalize (1 / 2). vring. }
    rewrite L. generalize (norm2 q). clear. vfield.
Qed.

(* The hypotheses can be met: two joints less than a right angle apart, for which there are control balls. *)
Example refit_dual_instance :
  let z := PosedSet [Rigid (Quat 1 0 0 0) (Vec 0 0 0); Rigid (Quat (4 / 5) (3 / 5) 0 0) (Vec 5 0 0)] (Vec 0 0 0) [[1; 0]; [0; 1]] in
  edges_are_valid (fun _ : list (quat R * quat R) => (1%nat, 0%nat)) /\
  is_weight_vertex_combination (weight_vertices z) [1 / 2; 1 / 2] /\ comb [1 / 2; 1 / 2] (rotations z) <> lzero /\
  exists balls, dual_node_balls (fun qs => hd lzero qs) (fun _ => Vec 0 0 0) (fun _ => (1%nat, 0%nat)) 0 [(Ball (Vec 0 0 0) 1, z)]
    = Some balls.
Proof.
  cbv zeta. split; [intros cs L; lia|]. split; [apply algorithm1_instance|]. split; [apply norm2_pos_inv; cbn; vunfold; lra|].
  unfold dual_node_balls, dual_piece_balls, dual_weight_vertices. cbn [weight_vertices map]. set (c1 := comb _ _) at 1.
    unfold cover_dual. cbn [cover].
  destruct (all_near _ _); [eexists; reflexivity|]. unfold fall_back_dual. cbn [map fst hd].
  assert (A : forall b, b = true -> exists balls, join (if b then Some [Ball (Vec 0 0 0) 0] else None) (Some []) = Some balls)
    by (intros b ->; eexists; reflexivity).
  unfold are_ahead. cbn [forallb fst]. unfold c1. cbn [comb rotations transforms map rotation]. 
  destruct (Rlt_dec 0 _) as [_|X]; [|exfalso; apply X; vunfold; lra].
  destruct (Rlt_dec 0 _) as [_|X]; [|exfalso; apply X; vunfold; lra]. eexists. reflexivity.
Qed.
