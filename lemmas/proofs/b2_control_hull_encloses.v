(* SPDX-License-Identifier: MIT *)
(* Beyond the paper: the control points hold all of a blend. *)
From Coq Require Import List Reals Lra Psatz Lia.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.b1_rational_bezier_simplex.
Import ListNotations.

(* --- Statements --- *)

(* The control points (N_I, W_I) of a blend of degree 2 and of degree 3, and the positions N_I / W_I. *)
Definition dual_points (p : vec R) (weight_vertices : list (quat R * quat R)) := indices2 (dual_point p) weight_vertices.
Definition spherical_points (x : vec R) (weight_vertices : list (quat R * vec R)) :=
  indices3 (spherical_point x) weight_vertices.
Definition position (point : vec R * R) : vec R := (/ snd point *: fst point)%V.
Definition weights_are_positive (points : list (vec R * R)) := Forall (fun point => 0 < snd point) points.

(* If all W_I > 0, v'(u) is a convex combination of the N_I / W_I. The blend is then not 0. *)
Definition spherical_in_hull : Prop :=
  forall (weight_vertices : list (quat R * vec R)) (p rotation_center : vec R) (u : list R),
  let points := spherical_points (p - rotation_center)%V weight_vertices in
  weights_are_positive points -> convex (length weight_vertices) u ->
  comb u (map fst weight_vertices) <> lzero /\
  in_hull (map position points) (skin_spherical (map fst weight_vertices) (map snd weight_vertices) rotation_center u p).
Definition dual_in_hull : Prop :=
  forall (weight_vertices : list (quat R * quat R)) (p : vec R) (u : list R),
  weights_are_positive (dual_points p weight_vertices) -> convex (length weight_vertices) u ->
  comb u (map fst weight_vertices) <> lzero /\
  in_hull (map position (dual_points p weight_vertices)) (skin_dual (map fst weight_vertices) (map snd weight_vertices) u p).
(* A convex set that holds the ball of radius r about each of them holds v'(u) + y for all ||y|| <= r; and so all that
   the blend makes of the reference ball [p, r]. *)
Definition spherical_in_convex_set : Prop :=
  forall (K : vec R -> Prop) (weight_vertices : list (quat R * vec R)) (reference : ball (vec R))
    (rotation_center v : vec R) (u : list R),
  let points := spherical_points (center reference - rotation_center)%V weight_vertices in
  convex_set K -> weights_are_positive points -> convex (length weight_vertices) u ->
  (forall point y, In point points -> norm y <= radius reference -> K (position point + y)%V) ->
  in_ball reference v -> K (skin_spherical (map fst weight_vertices) (map snd weight_vertices) rotation_center u v).
Definition dual_in_convex_set : Prop :=
  forall (K : vec R -> Prop) (weight_vertices : list (quat R * quat R)) (reference : ball (vec R)) (v : vec R) (u : list R),
  let points := dual_points (center reference) weight_vertices in
  convex_set K -> weights_are_positive points -> convex (length weight_vertices) u ->
  (forall point y, In point points -> norm y <= radius reference -> K (position point + y)%V) ->
  in_ball reference v -> K (skin_dual (map fst weight_vertices) (map snd weight_vertices) u v).
(* It is enough that all pairwise (q'_k, q'_l) > 0. *)
Definition pairs_are_enough : Prop :=
  forall (weight_vertices : list (quat R * vec R)) (duals : list (quat R * quat R)) (x p : vec R),
  ((forall a b, In a weight_vertices -> In b weight_vertices -> 0 < dot (fst a) (fst b)) ->
    weights_are_positive (spherical_points x weight_vertices)) /\
  ((forall a b, In a duals -> In b duals -> 0 < dot (fst a) (fst b)) -> weights_are_positive (dual_points p duals)).
(* A convex cone that holds the (N_I, W_I), whatever their signs, holds numerator and denominator of the blend: balls,
   half-spaces and hulls are such cones. *)
Definition spherical_in_cone : Prop :=
  forall (C : vec R * R -> Prop) (weight_vertices : list (quat R * vec R)) (x : vec R) (u : list R),
  cone C -> convex (length weight_vertices) u -> Forall C (spherical_points x weight_vertices) ->
  let q := comb u (map fst weight_vertices) in let r := comb u (map snd weight_vertices) in
  C ((turned q x q + norm2 q *: r)%V, norm2 q).
Definition dual_in_cone : Prop :=
  forall (C : vec R * R -> Prop) (weight_vertices : list (quat R * quat R)) (p : vec R) (u : list R),
  cone C -> convex (length weight_vertices) u -> Forall C (dual_points p weight_vertices) ->
  let q := comb u (map fst weight_vertices) in let d := comb u (map snd weight_vertices) in
  C ((turned q p q + 2 *: im (qmul d (conj q)))%V, norm2 q).

(* --- Proofs --- *)

Theorem spherical_in_cone_holds : spherical_in_cone.
Proof.
  intros C weight_vertices x u K U F. cbv zeta. assert (U' := U). destruct U' as (L & P & S).
  rewrite <- spherical_is_bezier_holds by auto. apply comb_in_cone; auto. now apply bernstein3_nonneg.
Qed.
Theorem dual_in_cone_holds : dual_in_cone.
Proof.
  intros C weight_vertices p u K (L & P & S) F. cbv zeta. rewrite <- dual_is_bezier_holds by auto.
  apply comb_in_cone; auto. now apply bernstein2_nonneg.
Qed.

(* v' = sum B_I N_I / sum B_I W_I = sum (B_I W_I / sum) (N_I / W_I) *)
Lemma quotient_in_hull (b : list R) (points : list (vec R * R)) : length b = length points ->
  Forall (Rle 0) b -> 0 < sum b -> weights_are_positive points ->
  0 < snd (comb b points) /\ in_hull (map position points) (position (comb b points)).
Proof.
  intros L B S W. rewrite comb_pair. cbn [snd].
  assert (P : 0 < comb b (map snd points)).
  { apply comb_positive; auto; [now rewrite map_length|]. now apply Forall_map. }
  split; [exact P|]. set (d := comb b (map snd points)) in *.
  exists (map (Rmult (/ d)) (map (fun z => fst z * snd (snd z)) (combine b points))). split; [split; [|split]|].
  - rewrite !map_length, combine_length, L. apply Nat.min_id.
  - apply scale_nonneg; [left; now apply inv_pos|]. apply Forall_map, Forall_forall. intros [a pt] I. cbn.
    unfold weights_are_positive in W. rewrite Forall_forall in B, W. pose proof (B a (in_combine_l _ _ _ _ I)).
    pose proof (W pt (in_combine_r _ _ _ _ I)). nra.
  - rewrite sum_scale. replace (sum _) with d; [apply Rinv_l; lra|]. unfold d. clear - L.
    revert points L; induction b as [|a b IH]; intros [|pt points] L; try discriminate; [reflexivity|].
    cbn [combine map comb fst snd]. rewrite sum_cons, <- IH by auto. reflexivity.
  - rewrite comb_scale. unfold position at 1. cbn [fst snd]. f_equal. clear - L W.
    revert points L W; induction b as [|a b IH]; intros [|pt points] L W; try discriminate; [reflexivity|].
    apply Forall_cons_iff in W as [W1 W]. cbn [combine map comb fst snd]. rewrite <- IH by auto. unfold position.
    vec_field. lra.
Qed.

Lemma indices3_length {X Y} (f : X -> X -> X -> Y) (u : list R) xs : length u = length xs ->
  length (bernstein3 u) = length (indices3 f xs).
Proof.
  revert xs; induction u as [|a u IH]; intros [|x xs] L; try discriminate; [reflexivity|].
  cbn [bernstein3 indices3 length]. rewrite !app_length, !map_length, (IH xs) by auto.
  rewrite (indices2_length (f x) u xs) by auto. cbn in L. lia.
Qed.

Theorem spherical_in_hull_holds : spherical_in_hull.
Proof.
  intros weight_vertices p c u points W U. destruct (bernstein_is_convex_holds u _ U) as [_ [B S]]. assert (U' := U).
  destruct U' as (L & P & Su).
  destruct (quotient_in_hull (bernstein3 u) points) as [D H]; auto; [now apply indices3_length|lra|].
  pose proof (spherical_is_bezier_holds u (p - c)%V weight_vertices L Su : comb (bernstein3 u) points = _) as Z.
  assert (N : comb u (map fst weight_vertices) <> lzero).
  { intros Z0. rewrite Z in D. cbn [snd] in D. rewrite Z0, norm2_zero in D. lra. }
  split; [exact N|]. pose proof (spherical_is_skinning_holds u p c weight_vertices L Su N) as Sk.
  fold (spherical_points (p - c)%V weight_vertices) in Sk. fold points in Sk. rewrite Z in Sk, H. destruct Sk as [_ <-].
    exact H.
Qed.
Theorem dual_in_hull_holds : dual_in_hull.
Proof.
  intros weight_vertices p u W U. destruct (bernstein_is_convex_holds u _ U) as [[B S] _]. assert (U' := U).
  destruct U' as (L & P & Su).
  destruct (quotient_in_hull (bernstein2 u) (dual_points p weight_vertices)) as [D H]; auto; [now apply indices2_length|lra|].
  pose proof (dual_is_bezier_holds u p weight_vertices L : comb (bernstein2 u) (dual_points p weight_vertices) = _) as Z.
  assert (N : comb u (map fst weight_vertices) <> lzero).
  { intros Z0. rewrite Z in D. cbn [snd] in D. rewrite Z0, norm2_zero in D. lra. }
  split; [exact N|]. pose proof (dual_is_skinning_holds u p weight_vertices L N) as Sk.
  fold (dual_points p weight_vertices) in Sk. rewrite Z in Sk, H. destruct Sk as [_ <-]. exact H.
Qed.

(* A convex set around the balls about points holds the ball about any point of their hull. *)
Lemma convex_set_around_balls {E} `{Euclid E} (K : E -> Prop) (ps : list E) x y : convex_set K -> in_hull ps x ->
  (forall p, In p ps -> K (p + y)%V) -> K (x + y)%V.
Proof.
  intros C (u & U & ->) F. rewrite <- comb_shift_convex by auto.
  apply convex_set_comb; auto; [now rewrite map_length|]. apply Forall_map, Forall_forall. exact F.
Qed.

Theorem spherical_in_convex_set_holds : spherical_in_convex_set.
Proof.
  intros K weight_vertices reference c v u points C W U F V.
  destruct (spherical_in_hull_holds weight_vertices (center reference) c u W U) as [N H].
  replace (skin_spherical _ _ c u v) with (skin_spherical (map fst weight_vertices) (map snd weight_vertices) c u
    (center reference) +
    rotate (comb u (map fst weight_vertices)) (v - center reference))%V.
  - apply convex_set_around_balls with (1 := C) (2 := H). intros q Q. apply in_map_iff in Q as (pt & <- & I).
    apply F; [exact I|]. rewrite rotate_norm by exact N. exact V.
  - unfold skin_spherical. rewrite !rotate_sub. vec_ring.
Qed.
Lemma skin_dual_moves (qs ds : list (quat R)) u p v : skin_dual qs ds u v = (skin_dual qs ds u p + rotate (comb u qs) (v - p))%V.
Proof.
  rewrite rotate_sub. unfold skin_dual, rotate. cbv zeta. generalize (im (qmul (comb u ds) (conj (comb u qs)))). intros t. vec_ring.
Qed.
Theorem dual_in_convex_set_holds : dual_in_convex_set.
Proof.
  intros K weight_vertices reference v u points C W U F V.
  destruct (dual_in_hull_holds weight_vertices (center reference) u W U) as [N H].
  rewrite (skin_dual_moves _ _ u (center reference) v).
  apply convex_set_around_balls with (1 := C) (2 := H). intros q Q. apply in_map_iff in Q as (pt & <- & I).
  apply F; [exact I|]. rewrite rotate_norm by exact N. exact V.
Qed.

(* What holds of f at all weight vertices holds at all multi-indices. *)
Lemma indices2_all {X Y} (P : Y -> Prop) (f : X -> X -> Y) xs : (forall a b, In a xs -> In b xs -> P (f a b)) ->
  Forall P (indices2 f xs).
Proof.
  induction xs as [|x xs IH]; intros F; cbn [indices2]; constructor; [apply F; now left|].
  apply Forall_app. split; [apply Forall_map, Forall_forall; intros z Z; apply F; [now left|now right]|].
  apply IH. intros a b A B. apply F; now right.
Qed.
Lemma indices3_all {X Y} (P : Y -> Prop) (f : X -> X -> X -> Y) xs :
  (forall a b c, In a xs -> In b xs -> In c xs -> P (f a b c)) -> Forall P (indices3 f xs).
Proof.
  induction xs as [|x xs IH]; intros F; cbn [indices3]; constructor; [apply F; now left|].
  apply Forall_app. split; [apply Forall_map, Forall_forall; intros z Z; apply F; (now left) || now right|].
  apply Forall_app. split; [apply indices2_all; intros a b A B; apply F; (now left) || now right|].
  apply IH. intros a b c A B D. apply F; now right.
Qed.

Theorem pairs_are_enough_holds : pairs_are_enough.
Proof.
  intros weight_vertices duals x p. split; intros F.
  - apply indices3_all. intros [qa ra] [qb rb] [qc rc] A B C. cbn [spherical_point snd].
    pose proof (F _ _ A B). pose proof (F _ _ B C). pose proof (F _ _ A C). cbn [fst] in *. lra.
  - apply indices2_all. intros [qa da] [qb db] A B. exact (F _ _ A B).
Qed.

(* The hypotheses can be met: two weight vertices 53 degrees apart on S_3, a proper hull. *)
Example control_hull_instance :
  let weight_vertices := [(Quat 1 0 0 0, Vec 0 0 0); (Quat (3 / 5) (4 / 5) 0 0, Vec 0 0 0)] in
  weights_are_positive (spherical_points (Vec 0 1 0) weight_vertices) /\ convex (length weight_vertices) [1 / 2; 1 / 2].
Proof.
  split; [|repeat split; [repeat constructor; lra|cbn; lra]].
  apply (pairs_are_enough_holds _ [] _ (Vec 0 0 0)). intros a b [<-|[<-|[]]] [<-|[<-|[]]]; cbn [fst]; vunfold; lra.
Qed.
Example dual_hull_instance :
  let weight_vertices := [(Quat 1 0 0 0, Quat 0 1 0 0); (Quat (3 / 5) (4 / 5) 0 0, Quat 0 0 1 0)] in
  weights_are_positive (dual_points (Vec 0 1 0) weight_vertices) /\ convex (length weight_vertices) [1 / 2; 1 / 2].
Proof.
  split; [|repeat split; [repeat constructor; lra|cbn; lra]].
  apply (pairs_are_enough_holds [] _ (Vec 0 0 0) _). intros a b [<-|[<-|[]]] [<-|[<-|[]]]; cbn [fst]; vunfold; lra.
Qed.
(* The convex sets and cones of the other statements: a half-space that has the ball about each control point, and a cone that has them all. *)
Example convex_set_instance :
  let weight_vertices := [(Quat 1 0 0 0, Vec 0 0 0)] in let points := spherical_points (Vec 0 1 0) weight_vertices in
  let K := fun v : vec R => dot v (Vec 1 0 0) <= 2 in
  convex_set K /\ weights_are_positive points /\ forall point y, In point points -> norm y <= 1 -> K (position point + y)%V.
Proof.
  cbv zeta. split; [|split].
  - intros t x y T X Y. rewrite dot_add_l, !dot_scale_l. nra.
  - unfold weights_are_positive, spherical_points. cbn. repeat apply Forall_cons; try apply Forall_nil; cbn [snd]; vunfold; lra.
  - intros point y P Y. unfold spherical_points in P. cbn in P. destruct P as [<-|[]]. rewrite dot_add_l.
    pose proof (dot_le_norms y (Vec 1 0 0)) as D. rewrite (norm_unit (Vec 1 0 0)) in D by (vunfold; ring).
    match goal with |- dot ?p _ + _ <= _ => assert (dot p (Vec 1 0 0) <= 1) by (unfold position; cbn; vunfold; lra) end. lra.
Qed.
Example cone_instance :
  let weight_vertices := [(Quat 1 0 0 0, Vec 0 0 0); (Quat (3 / 5) (4 / 5) 0 0, Vec 0 0 0)] in
  let duals := [(Quat 1 0 0 0, Quat 0 1 0 0); (Quat (3 / 5) (4 / 5) 0 0, Quat 0 0 1 0)] in
  let C := fun p : vec R * R => 0 <= snd p in
  cone C /\ Forall C (spherical_points (Vec 0 1 0) weight_vertices) /\ Forall C (dual_points (Vec 0 1 0) duals).
Proof.
  cbv zeta. split; [|split].
  - split; [|intros x y|intros a x A]; cbn [fst snd lzero ladd lscale lin_pair lin_num zero add mul ops_R]; intros; nra.
  - eapply Forall_impl; [|exact (proj1 control_hull_instance)]. cbn. intros; lra.
  - eapply Forall_impl; [|exact (proj1 dual_hull_instance)]. cbn. intros; lra.
Qed.
(* Without pairs that are positive: 104 degrees apart, and still a hull of degree 3. *)
Example beyond_half_a_turn_instance :
  let weight_vertices := [(Quat 1 0 0 0, Vec 0 0 0); (Quat (- 1 / 4) 1 0 0, Vec 0 0 0)] in
  weights_are_positive (spherical_points (Vec 0 1 0) weight_vertices).
Proof. unfold weights_are_positive, spherical_points. cbn. repeat apply Forall_cons; try apply Forall_nil; cbn [snd]; vunfold; lra. Qed.
