(* SPDX-License-Identifier: MIT *)
(* algorithms/runtime/refit/control_hull.hpp: the control balls of a piece, with halving and the fallback, hold its vertices under
   spherical blending. It is composed as the program is; so is its halving for any kind of blend. *)
From Coq Require Import List Reals Lra Psatz Lia.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.b1_rational_bezier_simplex Refitlab.b2_control_hull_encloses Refitlab.b3_subdivision.
Require Import Refitlab.lemma4_quaternion_hull Refitlab.rotation_bound Refitlab.algorithm1_repaired.
Require Import Refitlab.s41_weight_vertices_span Refitlab.s42_linear_part_hull Refitlab.s44_sum_of_bounds Refitlab.s44_joint_sets.
Import ListNotations.

(* --- The program --- *)

(* Balls, or None for all of space. *)
Definition balls_or_all := option (list (ball (vec R))).
Definition join (a b : balls_or_all) : balls_or_all :=
  match a, b with Some x, Some y => Some (x ++ y) | _, _ => None end.

(* Weight vertices that are near emit their control balls; others are halved at an edge, a few times; then they fall back. *)
Section Cover.
Context {E : Type} {l : Lin R E} (near : list E -> bool) (emit : list E -> list (ball (vec R)))
  (fall_back : list E -> balls_or_all) (widest_edge : list E -> nat * nat).
Fixpoint cover (halvings_left : nat) (weight_vertices : list E) : balls_or_all :=
  if near weight_vertices then Some (emit weight_vertices)
  else match halvings_left with
  | O => fall_back weight_vertices
  | S h => let (k, l) := widest_edge weight_vertices in join (cover h (half l k weight_vertices))
    (cover h (half k l weight_vertices))
  end.
End Cover.

(* Pairs of weight vertices are near if (q_k, q_l) > 0 and its square times a factor is above ||q_k||^2 ||q_l||^2. (The
   program looks at the widest pair, which decides for all.) *)
Definition pair_is_near (factor : R) (a b : quat R) : bool :=
  if Rlt_dec 0 (dot a b) then if Rlt_dec (norm2 a * norm2 b) (factor * (dot a b * dot a b)) then true else false else false.
Definition all_near {X} (factor : R) (weight_vertices : list (quat R * X)) : bool :=
  forallb (fun a => forallb (fun b => pair_is_near factor (fst a) (fst b)) weight_vertices) weight_vertices.

(* Spherical blending of a piece: x = p - r_c and r is the radius of the reference ball. *)
Section Spherical.
Context (center_of_points : list (quat R) -> quat R) (widest_edge : list (quat R * vec R) -> nat * nat) (most_halvings : nat).
Definition emit_spherical (x : vec R) (r : R) (weight_vertices : list (quat R * vec R)) : list (ball (vec R)) :=
  map (fun point => Ball (position point) r) (spherical_points x weight_vertices).
Definition fall_back_spherical (x : vec R) (r : R) (weight_vertices : list (quat R * vec R)) : balls_or_all :=
  let bound := bound_weight_vertex_rotations center_of_points (map fst weight_vertices) in
  let offset := (center_ratio bound *: rotate (apex bound) x)%V in
  Some (map (fun c => Ball (snd c + offset)%V (r + radius_ratio bound * norm x)) weight_vertices).
Definition cover_spherical (x : vec R) (r : R) : nat -> list (quat R * vec R) -> balls_or_all :=
  cover (all_near 4) (emit_spherical x r) (fall_back_spherical x r) widest_edge.

(* The weight vertices of a joint-set, and its control balls: one ball where there is one rotation. *)
Definition posed_weight_vertices (z : posed_set) : list (quat R * vec R) :=
  map (fun c => (comb c (rotations z), comb c (center_images z))) (weight_vertices z).
Definition piece_balls (reference : ball (vec R)) (z : posed_set) : balls_or_all :=
  let x := (center reference - rotation_center z)%V in
  match posed_weight_vertices z with
  | [(q, r')] =>
    if Req_EM_T (norm2 q) 0 then cover_spherical x (radius reference) 0 [(q, r')]
    else Some [Ball (rotate q x + r')%V (radius reference)]
  | cs => cover_spherical x (radius reference) most_halvings cs
  end.
(* A node's pieces: each has a reference ball and the joint-set of its vertices; several may have one joint-set. *)
Fixpoint node_balls (pieces : list (ball (vec R) * posed_set)) : balls_or_all :=
  match pieces with
  | [] => Some []
  | (reference, z) :: more => join (piece_balls reference z) (node_balls more)
  end.
End Spherical.

(* --- Statements --- *)

Definition edges_are_valid {E} (widest_edge : list E -> nat * nat) :=
  forall weight_vertices, (2 <= length weight_vertices)%nat -> let (k, l) := widest_edge weight_vertices in
  (k < length weight_vertices)%nat /\ (l < length weight_vertices)%nat /\ k <> l.
(* A set of points holds balls. *)
Definition holds_all (K : vec R -> Prop) (balls : list (ball (vec R))) := forall b z, In b balls -> in_ball b z -> K z.

(* Any convex set that holds the control balls of a node holds every deformed vertex of every piece. *)
Definition control_hull_is_sound : Prop :=
  forall center_of_points widest_edge most_halvings (K : vec R -> Prop) (pieces : list (ball (vec R) * posed_set))
    (balls : list (ball (vec R))) (reference : ball (vec R)) (z : posed_set) (w : list R) (v : vec R),
  edges_are_valid widest_edge -> convex_set K ->
  node_balls center_of_points widest_edge most_halvings pieces = Some balls -> holds_all K balls ->
  In (reference, z) pieces -> is_weight_vertex_combination (weight_vertices z) w -> in_ball reference v -> comb w (rotations z) <> lzero ->
  K (deformed z w v).
(* There always are such balls. *)
Definition control_hull_is_bounded : Prop :=
  forall center_of_points widest_edge most_halvings pieces,
  exists balls, node_balls center_of_points widest_edge most_halvings pieces = Some balls.
(* One ball around them, as the program returns it. *)
Definition refit_control_hull_is_sound : Prop :=
  forall center_of_points widest_edge most_halvings of_balls (pieces : list (ball (vec R) * posed_set))
    (balls : list (ball (vec R))) (reference : ball (vec R)) (z : posed_set) (w : list R) (v : vec R),
  edges_are_valid widest_edge -> encloses_its_balls of_balls ->
  node_balls center_of_points widest_edge most_halvings pieces = Some balls ->
  In (reference, z) pieces -> is_weight_vertex_combination (weight_vertices z) w -> in_ball reference v -> comb w (rotations z) <> lzero ->
  in_ball (of_balls balls) (deformed z w v).

(* --- Proofs --- *)

(* Whatever passes from the balls of near weight vertices, and from those of the fallback, to all blends, passes from
   those of cover. *)
Lemma cover_sound {E} `{Euclid E} near emit fall_back widest_edge (P : E -> Prop) (K : vec R -> Prop) :
  edges_are_valid widest_edge ->
  (forall cs x, near cs = true -> holds_all K (emit cs) -> in_hull cs x -> P x) ->
  (forall cs bs x, fall_back cs = Some bs -> holds_all K bs -> in_hull cs x -> P x) ->
  forall h cs bs x, h = 0%nat \/ (2 <= length cs)%nat ->
  cover near emit fall_back widest_edge h cs = Some bs -> holds_all K bs -> in_hull cs x -> P x.
Proof.
  intros V EM FB. induction h as [|h IH]; intros cs bs x L C B X; cbn [cover] in C; destruct (near cs) eqn:N.
  - injection C as <-. now apply (EM cs).
  - now apply (FB cs bs).
  - injection C as <-. now apply (EM cs).
  - destruct L as [L|L]; [discriminate|]. specialize (V cs L). destruct (widest_edge cs) as [k l0].
    destruct V as (Kv & Lv & D).
    destruct (cover near emit fall_back widest_edge h (half l0 k cs)) as [b1|] eqn:C1; [|discriminate].
    destruct (cover near emit fall_back widest_edge h (half k l0 cs)) as [b2|] eqn:C2; [|discriminate].
    injection C as <-. apply (halves_cover_holds _ _ _ cs k l0 x Kv Lv D) in X as [X|X].
    + apply (IH _ b2 x) in X; auto; [right; now rewrite half_length|].
      intros b z I Z. apply (B b z); auto. apply in_or_app. now right.
    + apply (IH _ b1 x) in X; auto; [right; now rewrite half_length|].
      intros b z I Z. apply (B b z); auto. apply in_or_app. now left.
Qed.

Lemma all_near_positive {X} factor (weight_vertices : list (quat R * X)) : all_near factor weight_vertices = true ->
  forall a b, In a weight_vertices -> In b weight_vertices -> 0 < dot (fst a) (fst b).
Proof.
  intros N a b A B. unfold all_near in N. rewrite forallb_forall in N. specialize (N a A). rewrite forallb_forall in N.
  specialize (N b B). unfold pair_is_near in N. destruct (Rlt_dec 0 (dot (fst a) (fst b))); [assumption|discriminate].
Qed.

(* What the balls of a piece have to hold: R_q x + r' + y for every blend (q, r') with q not 0, and ||y|| <= r. *)
Definition spherical_goal (K : vec R -> Prop) (x : vec R) (r : R) (c : quat R * vec R) :=
  fst c <> lzero -> forall y, norm y <= r -> K (rotate (fst c) x + snd c + y)%V.

Lemma in_point_ball (p y : vec R) r : norm y <= r -> in_ball (Ball p r) (p + y).
Proof. intros Y. unfold in_ball. cbn [center radius]. replace (p + y - p)%V with y by vec_ring. exact Y. Qed.

Lemma emit_spherical_sound (K : vec R -> Prop) x r cs c : convex_set K -> all_near 4 cs = true ->
  holds_all K (emit_spherical x r cs) -> in_hull cs c -> spherical_goal K x r c.
Proof.
  intros C N B (u & U & ->) Nz y Y. rewrite comb_pair in *. cbn [fst snd] in *.
  assert (Wp : weights_are_positive (spherical_points x cs)).
  { apply (pairs_are_enough_holds cs [] x x). now apply all_near_positive with 4. }
  assert (Z : (x - lzero)%V = x) by vec_ring.
  destruct (spherical_in_hull_holds cs x lzero u) as [_ H]; [now rewrite Z|auto|]. rewrite Z in H.
  unfold skin_spherical in H. rewrite Z in H. apply convex_set_around_balls with (1 := C) (2 := H).
  intros p P. apply in_map_iff in P as (pt & <- & I). apply (B (Ball (position pt) r)).
  - unfold emit_spherical. apply in_map_iff. now exists pt.
  - now apply in_point_ball.
Qed.

Lemma fall_back_spherical_sound center_of_points (K : vec R -> Prop) x r cs bs c : convex_set K ->
  fall_back_spherical center_of_points x r cs = Some bs -> holds_all K bs -> in_hull cs c -> spherical_goal K x r c.
Proof.
  intros C F B (u & U & ->) Nz y Y. rewrite comb_pair in *. cbn [fst snd] in *. injection F as <-.
  destruct (bound_weight_vertex_rotations_sound center_of_points (map fst cs)) as (_ & _ & _ & Bd).
  set (bound := bound_weight_vertex_rotations center_of_points (map fst cs)) in *.
  set (offset := (center_ratio bound *: rotate (apex bound) x)%V) in *.
  assert (S : norm (rotate (comb u (map fst cs)) x - offset) <= radius_ratio bound * norm x).
  { apply Bd; auto. exists u. split; [now rewrite map_length|reflexivity]. }
  replace (rotate (comb u (map fst cs)) x + comb u (map snd cs) + y)%V with
    (comb u (map snd cs) + (offset + ((rotate (comb u (map fst cs)) x - offset) + y)))%V by vec_ring.
  apply convex_set_around_balls with (ps := map snd cs); auto.
  - exists u. split; [now rewrite map_length|reflexivity].
  - intros p P. apply in_map_iff in P as (c & <- & I).
    apply (B (Ball (snd c + offset)%V (r + radius_ratio bound * norm x))); [apply in_map_iff; now exists c|].
    replace (snd c + (offset + ((rotate (comb u (map fst cs)) x - offset) + y)))%V with
      ((snd c + offset) + ((rotate (comb u (map fst cs)) x - offset) + y))%V by vec_ring.
    apply in_point_ball. eapply Rle_trans; [apply norm_add|]. lra.
Qed.

(* The blend of a joint-set's weight vertices. *)
Lemma posed_blend z w u : convex (length (weight_vertices z)) u ->
  (forall i, nth i w 0 = comb u (map (fun c => nth i c 0) (weight_vertices z))) ->
  comb u (posed_weight_vertices z) = (comb w (rotations z), comb w (center_images z)).
Proof.
  intros U Q. unfold posed_weight_vertices. rewrite comb_pair, !map_map. cbn [fst snd].
  rewrite (swap_sums u (weight_vertices z) w (rotations z) Q), (swap_sums u (weight_vertices z) w (center_images z) Q).
    reflexivity.
Qed.

Lemma single_hull {E} `{Euclid E} (p x : E) : in_hull [p] x -> x = p.
Proof.
  intros (u & (L & _ & S) & ->). destruct u as [|a [|]]; try discriminate. cbn in S. cbn [comb].
  replace a with 1 by lra. vec_ring.
Qed.

Lemma piece_balls_sound center_of_points widest_edge most_halvings K reference z balls w v :
  edges_are_valid widest_edge -> convex_set K ->
  piece_balls center_of_points widest_edge most_halvings reference z = Some balls -> holds_all K balls ->
  is_weight_vertex_combination (weight_vertices z) w -> in_ball reference v -> comb w (rotations z) <> lzero ->
    K (deformed z w v).
Proof.
  intros V C B H (u & U & Q) X N. set (x := (center reference - rotation_center z)%V).
  assert (In : in_hull (posed_weight_vertices z) (comb w (rotations z), comb w (center_images z))).
  { exists u. split; [unfold posed_weight_vertices; now rewrite map_length|]. symmetry. now apply posed_blend. }
  assert (G : spherical_goal K x (radius reference) (comb w (rotations z), comb w (center_images z))).
  { assert (Cov : forall h cs bs c, h = 0%nat \/ (2 <= length cs)%nat ->
      cover_spherical center_of_points widest_edge x (radius reference) h cs = Some bs -> holds_all K bs ->
      in_hull cs c -> spherical_goal K x (radius reference) c).
    { apply cover_sound; auto.
      - intros cs c A E I. apply emit_spherical_sound with cs; auto.
      - intros cs bs c A E I. apply fall_back_spherical_sound with center_of_points cs bs; auto. }
    unfold piece_balls in B. fold x in B. destruct (posed_weight_vertices z) as [|[q r'] [|c2 cs]] eqn:P.
    - destruct In as (b & Cb & _). now apply convex_not_empty in Cb.
    - destruct (Req_EM_T (norm2 q) 0) as [Z|Z].
      + apply (Cov 0%nat [(q, r')] balls); auto.
      + injection B as <-. intros _ y Y. apply single_hull in In. injection In as -> ->. cbn [fst snd].
        apply (H (Ball (rotate q x + r')%V (radius reference))); [now left|]. now apply in_point_ball.
    - apply (Cov most_halvings ((q, r') :: c2 :: cs) balls); auto. right. cbn. lia. }
  unfold deformed, skin_spherical. specialize (G N (rotate (comb w (rotations z)) (v - center reference))).
  cbn [fst snd] in G. unfold x in G. rewrite !rotate_sub in G.
  replace (rotate (comb w (rotations z)) (v - rotation_center z) + comb w (center_images z))%V with
    (rotate (comb w (rotations z)) (center reference) - rotate (comb w (rotations z)) (rotation_center z) +
     comb w (center_images z) + (rotate (comb w (rotations z)) v - rotate (comb w (rotations z)) (center reference)))%V
    by (rewrite rotate_sub; vec_ring).
  apply G. rewrite <- rotate_sub, rotate_norm by exact N. exact X.
Qed.

Theorem control_hull_is_sound_holds : control_hull_is_sound.
Proof.
  intros cp we mh K pieces. induction pieces as [|[S z0] pieces IH]; intros balls reference z w v V C B H I W X N; [destruct I|].
  cbn [node_balls] in B. destruct (piece_balls cp we mh S z0) as [b1|] eqn:B1; [|discriminate].
  destruct (node_balls cp we mh pieces) as [b2|] eqn:B2; [|discriminate]. injection B as <-.
  destruct I as [E|I]; [injection E as -> ->|].
  - apply (piece_balls_sound cp we mh K reference z b1); auto. intros b y A. apply H. apply in_or_app. now left.
  - apply (IH b2 reference); auto. intros b y A. apply H. apply in_or_app. now right.
Qed.

Theorem control_hull_is_bounded_holds : control_hull_is_bounded.
Proof.
  intros cp we mh pieces.
  assert (C : forall x r h cs, exists bs, cover_spherical cp we x r h cs = Some bs).
  { intros x r. induction h as [|h IH]; intros cs; unfold cover_spherical in *; cbn [cover]; destruct (all_near 4 cs);
      try (eexists; reflexivity). destruct (we cs) as [k l].
    destruct (IH (half l k cs)) as (b1 & ->). destruct (IH (half k l cs)) as (b2 & ->). eexists. reflexivity. }
  induction pieces as [|[reference z] pieces (bs & Bs)]; [eexists; reflexivity|]. cbn [node_balls]. rewrite Bs.
  assert (P : exists ps, piece_balls cp we mh reference z = Some ps).
  { unfold piece_balls. destruct (posed_weight_vertices z) as [|[q r'] [|c2 cs]]; auto.
    destruct (Req_EM_T (norm2 q) 0); auto. eexists. reflexivity. }
  destruct P as (ps & ->). eexists. reflexivity.
Qed.

Lemma ball_around_balls of_balls balls : encloses_its_balls of_balls -> holds_all (in_ball (of_balls balls)) balls.
Proof. intros O b z I Z. apply holds_ball_point with b; auto. Qed.

Theorem refit_control_hull_is_sound_holds : refit_control_hull_is_sound.
Proof.
  intros cp we mh ob pieces balls reference z w v V O B I W X N.
  apply (control_hull_is_sound_holds cp we mh (in_ball (ob balls)) pieces balls reference); auto.
  - apply ball_convex.
  - now apply ball_around_balls.
Qed.

(* The hypotheses can be met: by the node of algorithm1_instance, with any edge of the weight vertices, and mean balls. *)
Example control_hull_instance :
  let z := PosedSet [Rigid (Quat 1 0 0 0) (Vec 0 0 0); Rigid (Quat 0 0 0 1) (Vec 5 0 0)] (Vec 0 0 0) [[1; 0]; [0; 1]] in
  let edge := fun _ : list (quat R * vec R) => (1%nat, 0%nat) in let S := Ball (Vec 2 0 0) 1 in let w := [1 / 2; 1 / 2] in
  edges_are_valid edge /\
  (exists balls, node_balls mean edge 4 [(S, z)] = Some balls /\ holds_all (in_ball (mean_ball balls)) balls /\
    convex_set (in_ball (mean_ball balls))) /\
  is_weight_vertex_combination (weight_vertices z) w /\ in_ball S (Vec 2 1 0) /\ comb w (rotations z) <> lzero.
Proof.
  cbv zeta. split; [intros cs L; lia|]. split; [|split; [|split]]; try apply algorithm1_instance.
  edestruct control_hull_is_bounded_holds as (balls & B). exists balls. split; [exact B|]. split; [|apply ball_convex].
  apply ball_around_balls, mean_balls_enclose_holds.
Qed.
