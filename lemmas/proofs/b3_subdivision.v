(* SPDX-License-Identifier: MIT *)
(* Beyond the paper: halving a simplex of weights at an edge tightens its control points as far as wanted. *)
From Coq Require Import List Reals Lra Psatz Lia.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.b1_rational_bezier_simplex Refitlab.b2_control_hull_encloses.
Import ListNotations.

(* --- Statements --- *)

(* The half at the edge (k, l) that keeps weight vertex k has the middle in place of weight vertex l. *)
Fixpoint set_nth {X} (k : nat) (y : X) (xs : list X) : list X :=
  match xs, k with [], _ => [] | _ :: t, O => y :: t | x :: t, S k => x :: set_nth k y t end.
Definition half {E} {l : Lin R E} (kept replaced : nat) (xs : list E) : list E :=
  set_nth replaced (1 / 2 *: (nth kept xs lzero + nth replaced xs lzero))%V xs.

(* 1. Cover: every blend of the whole is one of a half, and the other way round. *)
Definition halves_cover : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (xs : list E) (i j : nat) (x : E),
  (i < length xs)%nat -> (j < length xs)%nat -> i <> j ->
  (in_hull xs x <-> in_hull (half i j xs) x \/ in_hull (half j i xs) x).
(* If the weights of the whole are positive, the control points of a half have positive weights, and are in the hull of
   the whole's. *)
Definition half_points_in_hull : Prop :=
  forall (weight_vertices : list (quat R * vec R)) (x : vec R) (i j : nat),
  (i < length weight_vertices)%nat -> (j < length weight_vertices)%nat -> i <> j ->
  weights_are_positive (spherical_points x weight_vertices) ->
  Forall (fun point => 0 < snd point /\ in_hull (map position (spherical_points x weight_vertices)) (position point))
    (spherical_points x (half i j weight_vertices)).
(* 2. Rate: the control point of three weight vertices is near the surface's point at their mean. With all ||q'_i -
   q'_k|| <= s, ||r'_i - r'_k|| <= t, ||q'_i|| <= b and ||x|| <= a: *)
Definition control_point_is_near : Prop :=
  forall (a b c : quat R * vec R) (x : vec R) (s t len arm : R),
  let near p q := norm (fst p - fst q) <= s /\ norm (snd p - snd q) <= t in
  near a b -> near b c -> near a c -> norm (fst a) <= len -> norm (fst b) <= len -> norm (fst c) <= len -> norm x <= arm ->
  let q := (1 / 3 *: (fst a + fst b + fst c))%V in let r := (1 / 3 *: (snd a + snd b + snd c))%V in
  let '(n, w) := spherical_point x a b c in
  q <> lzero ->
  norm (n - w *: (rotate q x + r)) <= arm * (s * s) / 3 + len * s * t / 3 + s * s * t / 5 /\ norm2 q - s * s / 6 <= w.
(* Halving the longest edge (a, b) leaves the new edges, from its middle to c, at most sqrt(3)/2 of it. *)
Definition new_edge_is_shorter : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (a b c : E), norm (a - c) <= norm (a - b) -> norm (b - c) <= norm (a - b) ->
  norm (1 / 2 *: (a + b) - c) <= sqrt 3 / 2 * norm (a - b).
(* 3. Sign: W_kl is positive if and only if the blend in the middle is longer than half the edge. *)
Definition positive_if_middle_is_long : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (p q : E),
  dot p q = norm2 (1 / 2 *: (p + q)) - norm2 (1 / 2 *: (p - q)) /\
  (0 < dot p q <-> norm (1 / 2 *: (p - q)) < norm (1 / 2 *: (p + q))).
(* For quaternions of equal length, both parts of an edge are positive after one halving, unless the blend in its middle
   is 0. *)
Definition halving_makes_positive : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (p q : E), norm2 p = norm2 q -> let m := (1 / 2 *: (p + q))%V in
  m <> lzero -> 0 < dot p m /\ 0 < dot q m.

(* --- Proofs --- *)

Lemma set_nth_length {X} k (y : X) xs : length (set_nth k y xs) = length xs.
Proof. revert k; induction xs; intros [|k]; cbn; auto. Qed.
Lemma half_length {E} {l : Lin R E} i j (xs : list E) : length (half i j xs) = length xs.
Proof. apply set_nth_length. Qed.
Lemma set_nth_sum k a u : (k < length u)%nat -> sum (set_nth k a u) = sum u - nth k u 0 + a.
Proof.
  revert k; induction u as [|x u IH]; intros [|k] H; cbn [set_nth nth length] in *; try lia; rewrite !sum_cons; [ring|].
  rewrite IH by lia. ring.
Qed.
Lemma set_nth_nonneg k a u : 0 <= a -> Forall (Rle 0) u -> Forall (Rle 0) (set_nth k a u).
Proof. intros A U. revert k; induction U; intros [|k]; cbn; auto. Qed.
Lemma set_nth_nth_other {X} j k (y d : X) xs : j <> k -> nth j (set_nth k y xs) d = nth j xs d.
Proof. revert j k; induction xs; intros [|j] [|k] H; cbn; auto; lia. Qed.
Lemma set_nth_nth_same {X} k (y d : X) xs : (k < length xs)%nat -> nth k (set_nth k y xs) d = y.
Proof. revert k; induction xs; intros [|k] H; cbn in *; auto; try lia. apply IHxs. lia. Qed.
Lemma nth_nonneg k u : Forall (Rle 0) u -> 0 <= nth k u 0.
Proof. intros U; revert k; induction U; intros [|k]; cbn; auto; lra. Qed.

Section Halves.
Context {E : Type} `{Euclid E}.

Lemma comb_set_coefficient k a u (xs : list E) : (k < length u)%nat -> length u = length xs ->
  comb (set_nth k a u) xs = (comb u xs + (a - nth k u 0) *: nth k xs lzero)%V.
Proof.
  revert k xs; induction u as [|b u IH]; intros [|k] [|x xs] K L; cbn [set_nth nth comb length] in *; try lia; try vec_ring.
  rewrite IH by lia. vec_ring.
Qed.
Lemma comb_set_point k y u (xs : list E) : (k < length u)%nat -> length u = length xs ->
  comb u (set_nth k y xs) = (comb u xs + nth k u 0%R *: (y - nth k xs lzero))%V.
Proof.
  revert k xs; induction u as [|b u IH]; intros [|k] [|x xs] K L; cbn [set_nth nth comb length] in *; try lia; try vec_ring.
  rewrite IH by lia. vec_ring.
Qed.

(* u_i x_i + u_j x_j = (u_i - u_j) x_i + 2 u_j (x_i + x_j) / 2 for u_j <= u_i *)
Lemma half_of_whole (xs : list E) i j u : (i < length xs)%nat -> (j < length xs)%nat -> i <> j ->
  convex (length xs) u -> nth j u 0 <= nth i u 0 -> in_hull (half i j xs) (comb u xs).
Proof.
  intros I J N (L & P & S) O. exists (set_nth i (nth i u 0 - nth j u 0) (set_nth j (2 * nth j u 0) u)).
  pose proof (nth_nonneg j u P). rewrite half_length. split; [split; [|split]|].
  - now rewrite !set_nth_length.
  - repeat apply set_nth_nonneg; auto; lra.
  - rewrite set_nth_sum, set_nth_sum, set_nth_nth_other by (rewrite ?set_nth_length; auto; lia). lra.
  - unfold half. rewrite comb_set_point, comb_set_coefficient, comb_set_coefficient by (rewrite ?set_nth_length; lia).
    rewrite !set_nth_nth_other, set_nth_nth_same by (auto; lia). vec_field.
Qed.
Lemma whole_of_half (xs : list E) i j x : (i < length xs)%nat -> (j < length xs)%nat -> i <> j ->
  in_hull (half i j xs) x -> in_hull xs x.
Proof.
  intros I J N (u & (L & P & S) & ->). rewrite half_length in L.
  exists (set_nth i (nth i u 0 + nth j u 0 / 2) (set_nth j (nth j u 0 / 2) u)).
  pose proof (nth_nonneg j u P). pose proof (nth_nonneg i u P). split; [split; [|split]|].
  - now rewrite !set_nth_length.
  - repeat apply set_nth_nonneg; auto; lra.
  - rewrite set_nth_sum, set_nth_sum, set_nth_nth_other by (rewrite ?set_nth_length; auto; lia). lra.
  - unfold half. rewrite comb_set_point, !comb_set_coefficient by (rewrite ?set_nth_length; lia).
    rewrite !set_nth_nth_other by auto. vec_field.
Qed.
End Halves.

Theorem halves_cover_holds : halves_cover.
Proof.
  intros E l e xs i j x I J N. split.
  - intros (u & U & ->). destruct (Rle_lt_dec (nth j u 0) (nth i u 0)) as [O|O]; [left|right]; apply half_of_whole; auto; lra.
  - intros [X|X]; [apply whole_of_half with i j|apply whole_of_half with j i]; auto.
Qed.

Theorem new_edge_is_shorter_holds : new_edge_is_shorter.
Proof.
  intros E l e a b c A B. assert (S : sqrt 3 * sqrt 3 = 3) by (apply sqrt_sqrt; lra). pose proof (sqrt_pos 3).
  pose proof (norm_nonneg (a - b)%V). apply norm_le. split; [nra|].
  replace (sqrt 3 / 2 * norm (a - b) * (sqrt 3 / 2 * norm (a - b))) with (sqrt 3 * sqrt 3 / 4 * (norm (a - b) * norm (a - b)))
    by field.
  rewrite S. replace (norm2 (1 / 2 *: (a + b) - c)) with ((2 * norm2 (a - c) + 2 * norm2 (b - c) - norm2 (a - b)) / 4)
    by (dots; field).
  rewrite <- !norm_sq. pose proof (norm_nonneg (a - c)%V). pose proof (norm_nonneg (b - c)%V). nra.
Qed.

Theorem positive_if_middle_is_long_holds : positive_if_middle_is_long.
Proof.
  intros E l e p q.
  assert (D : dot p q = norm2 (1 / 2 *: (p + q)) - norm2 (1 / 2 *: (p - q))) by (dots; field).
  split; [exact D|]. rewrite D, <- !norm_sq. pose proof (norm_nonneg (1 / 2 *: (p + q))%V).
  pose proof (norm_nonneg (1 / 2 *: (p - q))%V). split; nra.
Qed.

Theorem halving_makes_positive_holds : halving_makes_positive.
Proof.
  intros E l e p q Q m N. apply norm2_pos in N.
  assert (M : norm2 m = (norm2 p + 2 * dot p q + norm2 q) / 4) by (unfold m; dots; field).
  replace (dot p m) with ((norm2 p + dot p q) / 2) by (unfold m; dots; field).
  replace (dot q m) with ((norm2 q + dot p q) / 2) by (unfold m; dots; field). lra.
Qed.

(* --- A half's control points --- *)

Lemma weight_between t x y : 0 <= t <= 1 -> 0 < x -> 0 < y -> 0 < t * x + (1 - t) * y.
Proof.
  intros [T0 T1] X Y. destruct (Rle_lt_or_eq_dec 0 t T0) as [P|Z]; [|subst t; lra].
  assert (0 < t * x) by now apply Rmult_lt_0_compat. assert (0 <= (1 - t) * y) by (apply Rmult_le_pos; lra). lra.
Qed.
(* Points of positive weight whose position is in a hull are a convex set. *)
Lemma positive_hull_convex (ps : list (vec R)) :
  convex_set (fun p : vec R * R => 0 < snd p /\ in_hull ps (position p)).
Proof.
  intros t [nx wx] [ny wy] T [X HX] [Y HY]. unfold position in *.
  cbn [fst snd ladd lscale lin_pair lin_num add mul ops_R] in *.
  assert (W : 0 < t * wx + (1 - t) * wy) by (apply weight_between; auto). split; [exact W|].
  set (w := t * wx + (1 - t) * wy) in *.
  replace (/ w *: (t *: nx + (1 - t) *: ny))%V with
    ((t * wx / w) *: (/ wx *: nx) + (1 - t * wx / w) *: (/ wy *: ny))%V.
  - apply hull_convex; auto. split; [apply Rmult_le_pos; [nra|left; now apply inv_pos]|].
    apply Rmult_le_reg_r with (1 := W). unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. unfold w. nra.
  - replace (1 - t * wx / w) with ((1 - t) * wy / w) by (unfold w; field; unfold w in W; lra). clearbody w. vec_field. lra.
Qed.

(* Every triple of weight vertices is among the multi-indices, whatever its order. *)
Lemma indices2_in {X Y} (f : X -> X -> Y) xs a b : (forall a b, f a b = f b a) -> In a xs -> In b xs -> In (f a b) (indices2 f xs).
Proof.
  intros S. induction xs as [|x xs IH]; [intros []|]. intros A B. cbn [indices2].
  destruct A as [<-|A], B as [<-|B]; [now left| | |]; right; apply in_or_app.
  - left. now apply in_map.
  - left. rewrite S. now apply in_map.
  - right. auto.
Qed.
Lemma indices3_in {X Y} (f : X -> X -> X -> Y) xs a b c : (forall a b c, f a b c = f b a c) -> (forall a b c, f a b c = f a c b) ->
  In a xs -> In b xs -> In c xs -> In (f a b c) (indices3 f xs).
Proof.
  intros S1 S2. induction xs as [|x xs IH]; [intros []|]. intros A B C. cbn [indices3].
  assert (One : forall y, In y xs -> In (f x x y) (f x x x :: map (f x x) xs ++ indices2 (f x) xs ++ indices3 f xs)).
  { intros y I. right. apply in_or_app. left. now apply in_map. }
  assert (Two : forall y z, In y xs -> In z xs -> In (f x y z) (f x x x :: map (f x x) xs ++ indices2 (f x) xs ++ indices3 f xs)).
  { intros y z I J. right. apply in_or_app. right. apply in_or_app. left. apply indices2_in; auto. }
  destruct A as [<-|A], B as [<-|B], C as [<-|C]; auto.
  - now left.
  - rewrite S2. auto.
  - rewrite S1, S2. auto.
  - rewrite S1. auto.
  - rewrite S2, S1. auto.
  - right. apply in_or_app. right. apply in_or_app. right. auto.
Qed.
Lemma spherical_point_swap x a b c : spherical_point x a b c = spherical_point x b a c.
Proof. rewrite <- !spherical_form_point. apply spherical_form_swap. Qed.
Lemma spherical_point_swap_last x a b c : spherical_point x a b c = spherical_point x a c b.
Proof. rewrite <- !spherical_form_point. apply spherical_form_swap_last. Qed.

(* A convex set that holds the points of all triples of weight vertices holds those of all triples of blends. *)
Lemma blends_in_convex_set (K : vec R * R -> Prop) (weight_vertices : list (quat R * vec R)) x : convex_set K ->
  (forall a b c, In a weight_vertices -> In b weight_vertices -> In c weight_vertices -> K (spherical_point x a b c)) ->
  forall a b c, in_hull weight_vertices a -> in_hull weight_vertices b -> in_hull weight_vertices c ->
    K (spherical_point x a b c).
Proof.
  intros C F.
  assert (Last : forall a b, (forall c, In c weight_vertices -> K (spherical_point x a b c)) ->
    forall c, in_hull weight_vertices c -> K (spherical_point x a b c)).
  { intros a b H c (u & U & ->). rewrite <- spherical_form_point, <- comb_with_one by auto.
    rewrite (comb_linear _ u (with_one weight_vertices) (spherical_form_linear x (1, a) (1, b))).
    unfold with_one. rewrite map_map. apply convex_set_comb; auto; [now rewrite map_length|].
    apply Forall_map, Forall_forall. intros d D. rewrite spherical_form_point. auto. }
  intros a b c A B D. apply Last; auto. intros d Id. rewrite spherical_point_swap_last. apply Last; auto.
  intros e Ie. rewrite spherical_point_swap_last, spherical_point_swap, spherical_point_swap_last.
  rewrite spherical_point_swap_last. rewrite spherical_point_swap_last. apply Last; auto.
Qed.

Lemma set_nth_in {X} k (y : X) xs z : In z (set_nth k y xs) -> z = y \/ In z xs.
Proof.
  revert k; induction xs as [|x xs IH]; intros [|k]; cbn [set_nth]; intros I; [destruct I|destruct I| |];
    destruct I as [<-|I]; auto; [right; now right|right; now left|]. destruct (IH k I); [now left|right; now right].
Qed.

Theorem half_points_in_hull_holds : half_points_in_hull.
Proof.
  intros weight_vertices x i j I J N W. set (ps := map position (spherical_points x weight_vertices)).
  assert (C : forall y, In y (half i j weight_vertices) -> in_hull weight_vertices y).
  { intros y Y. apply (whole_of_half weight_vertices i j y I J N). now apply hull_point. }
  apply (indices3_all (fun point => 0 < snd point /\ in_hull ps (position point))). intros a b c A B D.
  apply (blends_in_convex_set _ weight_vertices x (positive_hull_convex ps)); auto. clear - W ps. intros a b c A B D.
  assert (P : In (spherical_point x a b c) (spherical_points x weight_vertices)).
  { apply indices3_in; auto; intros; [apply spherical_point_swap|apply spherical_point_swap_last]. }
  unfold weights_are_positive in W. rewrite Forall_forall in W. split; [now apply W|]. apply hull_point. now apply in_map.
Qed.

(* --- The rate --- *)

(* Three numbers of each kind: Cauchy and Schwarz, and the product of two of the one kind. *)
Lemma three_products (a1 a2 a3 b1 b2 b3 s t : R) : 0 <= a1 -> 0 <= a2 -> 0 <= a3 -> 0 <= b1 -> 0 <= b2 -> 0 <= b3 ->
  0 <= s -> 0 <= t -> a1 * a1 + a2 * a2 + a3 * a3 <= s * s -> b1 * b1 + b2 * b2 + b3 * b3 <= t * t ->
  a1 * b1 + a2 * b2 + a3 * b3 <= s * t /\ b1 * (a2 * a3) + b2 * (a1 * a3) + b3 * (a1 * a2) <= 3 / 5 * (s * s * t).
Proof.
  intros A1 A2 A3 B1 B2 B3 S0 T0 A B.
  assert (C : forall x1 x2 x3 y1 y2 y3, (x1 * y1 + x2 * y2 + x3 * y3) * (x1 * y1 + x2 * y2 + x3 * y3) <=
    (x1 * x1 + x2 * x2 + x3 * x3) * (y1 * y1 + y2 * y2 + y3 * y3)).
  { intros. pose proof (Rle_0_sqr (x1 * y2 - x2 * y1)). pose proof (Rle_0_sqr (x1 * y3 - x3 * y1)).
    pose proof (Rle_0_sqr (x2 * y3 - x3 * y2)). unfold Rsqr in *. lra. }
  assert (Sq : forall z : R, 0 <= z * z) by (intro; apply Rle_0_sqr).
  split; (apply sq_le_inv; [repeat apply Rmult_le_pos; lra|]).
  - eapply Rle_trans; [apply C|]. replace (s * t * (s * t)) with (s * s * (t * t)) by ring.
    pose proof (Sq a1). pose proof (Sq a2). pose proof (Sq a3). pose proof (Sq b1). pose proof (Sq b2). pose proof (Sq b3).
    apply Rmult_le_compat; lra.
  - eapply Rle_trans; [apply C|]. set (n := s * s) in *.
    replace (3 / 5 * (n * t) * (3 / 5 * (n * t))) with (t * t * (9 / 25 * (n * n))) by field.
    pose proof (Sq b1). pose proof (Sq b2). pose proof (Sq b3).
    apply Rmult_le_compat; [lra|pose proof (Sq (a2 * a3)); pose proof (Sq (a1 * a3)); pose proof (Sq (a1 * a2)); lra|exact B|].
    set (x := a1 * a1) in *. set (y := a2 * a2) in *. set (z := a3 * a3) in *.
    replace (a2 * a3 * (a2 * a3) + a1 * a3 * (a1 * a3) + a1 * a2 * (a1 * a2)) with (y * z + x * z + x * y)
      by (unfold x, y, z; ring).
    assert (0 <= x /\ 0 <= y /\ 0 <= z) by (unfold x, y, z; auto).
    assert ((x + y + z) * (x + y + z) <= n * n) by (apply Rmult_le_compat; lra).
    pose proof (Sq n). pose proof (Sq (x - y)). pose proof (Sq (y - z)). pose proof (Sq (x - z)). lra.
Qed.

(* The deviations of three vectors from their mean. *)
Lemma deviations {E} `{Euclid E} (a b c : E) s : norm (a - b) <= s -> norm (b - c) <= s -> norm (a - c) <= s ->
  let m := (1 / 3 *: (a + b + c))%V in norm2 (a - m) + norm2 (b - m) + norm2 (c - m) <= s * s.
Proof.
  intros A B C m. apply norm_le in A as [_ A], B as [_ B], C as [_ C].
  replace (norm2 (a - m) + norm2 (b - m) + norm2 (c - m)) with ((norm2 (a - b) + norm2 (b - c) + norm2 (a - c)) / 3)
    by (unfold m; dots; field). lra.
Qed.

Lemma weight_from_mean (a b c : quat R) : let q := (1 / 3 *: (a + b + c))%V in
  (dot a b + dot b c + dot a c) / 3 = norm2 q - (norm2 (a - q) + norm2 (b - q) + norm2 (c - q)) / 6.
Proof. intros q. unfold q. dots. field. Qed.

Lemma mixed_sub x a b c : mixed a (b - c) x = (mixed a b x - mixed a c x)%V.
Proof.
  replace (b - c)%V with (b + (-1) *: c)%V by vec_ring. rewrite mixed_add, mixed_scale. vec_ring.
Qed.
Lemma mixed_add_l x a b c : mixed (a + b) c x = (mixed a c x + mixed b c x)%V.
Proof. rewrite !(mixed_swap x _ c). apply mixed_add. Qed.
Lemma mixed_scale_l x s a b : mixed (s *: a) b x = (s *: mixed a b x)%V.
Proof. rewrite !(mixed_swap x _ b). apply mixed_scale. Qed.
Lemma mixed_sub_l x a b c : mixed (a - b) c x = (mixed a c x - mixed b c x)%V.
Proof. rewrite !(mixed_swap x _ c). apply mixed_sub. Qed.
(* sum P_kl / 3 = Im(q x q* ) - sum Im(e_i x e_i* ) / 6 *)
Lemma turned_from_mean (a b c : quat R) x : let q := (1 / 3 *: (a + b + c))%V in
  (1 / 3 *: (mixed a b x + mixed b c x + mixed a c x))%V =
  (mixed q q x - 1 / 6 *: (mixed (a - q) (a - q) x + mixed (b - q) (b - q) x + mixed (c - q) (c - q) x))%V.
Proof.
  intros q. unfold q.
  repeat first [rewrite mixed_sub | rewrite mixed_sub_l | rewrite mixed_add | rewrite mixed_add_l | rewrite mixed_scale
    | rewrite mixed_scale_l].
  rewrite !(mixed_swap x b a), !(mixed_swap x c a), !(mixed_swap x c b). vec_field.
Qed.
(* sum r_j W_kl / 3 = r W + sum f_j ((e_k, e_l) - (q, e_j)) / 3 *)
Lemma centers_from_mean (a b c : quat R) (ra rb rc : vec R) :
  let q := (1 / 3 *: (a + b + c))%V in let r := (1 / 3 *: (ra + rb + rc))%V in
  (1 / 3 *: (dot b c *: ra + dot a c *: rb + dot a b *: rc))%V =
  (((dot a b + dot b c + dot a c) / 3) *: r
   + 1 / 3 *: (dot (b - q) (c - q) *: (ra - r) + dot (a - q) (c - q) *: (rb - r) + dot (a - q) (b - q) *: (rc - r))
   - 1 / 3 *: (dot q (a - q) *: (ra - r) + dot q (b - q) *: (rb - r) + dot q (c - q) *: (rc - r)))%V.
Proof.
  intros q r. apply dot_ext. intros z. unfold q, r. dots. field.
Qed.

Lemma norm_of_three {E} `{Euclid E} (x y z : E) : norm (x + y + z) <= norm x + norm y + norm z.
Proof. pose proof (norm_add (x + y)%V z). pose proof (norm_add x y). lra. Qed.
Lemma dot_abs {E} `{Euclid E} (x y : E) : Rabs (dot x y) <= norm x * norm y.
Proof. apply Rabs_le. split; [apply dot_ge_norms|apply dot_le_norms]. Qed.

Theorem control_point_is_near_holds : control_point_is_near.
Proof.
  intros [a ra] [b rb] [c rc] x s t len arm near [Qab Rab] [Qbc Rbc] [Qac Rac] La Lb Lc X. cbn [fst snd] in *. unfold spherical_point.
  set (q := (1 / 3 *: (a + b + c))%V). set (r := (1 / 3 *: (ra + rb + rc))%V). set (w := (dot a b + dot b c + dot a c) / 3).
  intros N. pose proof (deviations a b c s Qab Qbc Qac) as De. pose proof (deviations ra rb rc t Rab Rbc Rac) as Df.
  cbv zeta in De, Df. fold q in De. fold r in Df.
  assert (Wq : w = norm2 q - (norm2 (a - q) + norm2 (b - q) + norm2 (c - q)) / 6) by apply weight_from_mean.
  assert (S0 : 0 <= s) by (pose proof (norm_nonneg (a - b)%V); lra).
  assert (T0 : 0 <= t) by (pose proof (norm_nonneg (ra - rb)%V); lra).
  assert (X0 : 0 <= arm) by (pose proof (norm_nonneg x); lra). split; [|lra].
  set (n2 := norm2 (a - q) + norm2 (b - q) + norm2 (c - q)) in *.
  assert (N0 : 0 <= n2) by (unfold n2; pose proof (norm2_nonneg (a - q)%V); pose proof (norm2_nonneg (b - q)%V); pose proof (norm2_nonneg (c - q)%V); lra).
  pose proof (turned_from_mean a b c x) as M. pose proof (centers_from_mean a b c ra rb rc) as Cm. cbv zeta in M, Cm. fold q in M, Cm. fold r w in Cm.
  set (T := (mixed (a - q) (a - q) x + mixed (b - q) (b - q) x + mixed (c - q) (c - q) x)%V) in *.
  set (F4 := (dot (b - q) (c - q) *: (ra - r) + dot (a - q) (c - q) *: (rb - r) + dot (a - q) (b - q) *: (rc - r))%V) in *.
  set (F3 := (dot q (a - q) *: (ra - r) + dot q (b - q) *: (rb - r) + dot q (c - q) *: (rc - r))%V) in *.
  assert (Rq : mixed q q x = (norm2 q *: rotate q x)%V).
  { rewrite mixed_same. unfold rotate. apply norm2_pos in N. revert N. generalize (norm2 q) (turned q x q). intros m y N. vec_field. lra. }
  rewrite M, Cm, Rq. replace (_ - w *: (rotate q x + r))%V with
    ((n2 / 6) *: rotate q x - 1 / 6 *: T + (1 / 3 *: F4 - 1 / 3 *: F3))%V by (rewrite Wq; vec_field).
  assert (B1 : norm ((n2 / 6) *: rotate q x) <= arm * (s * s) / 6).
  { rewrite norm_scale, rotate_norm by (auto; lra). pose proof (norm_nonneg x). nra. }
  assert (Tn : forall d : quat R, norm (mixed d d x) <= norm2 d * arm).
  { intros d. rewrite mixed_same. pose proof (norm2_nonneg d).
    assert (Td : norm (turned d x d) = norm2 d * norm x).
    { apply norm_eq; [apply Rmult_le_pos; [assumption|apply norm_nonneg]|]. rewrite turned_norm2, <- (norm_sq x). ring. }
    rewrite Td. now apply Rmult_le_compat_l. }
  assert (B2 : norm (1 / 6 *: T) <= arm * (s * s) / 6).
  { rewrite norm_scale by lra. pose proof (norm_of_three (mixed (a - q) (a - q) x) (mixed (b - q) (b - q) x) (mixed (c - q) (c - q) x)) as G.
    fold T in G. pose proof (Tn (a - q)%V). pose proof (Tn (b - q)%V). pose proof (Tn (c - q)%V).
    assert (norm T <= n2 * arm) by (unfold n2; lra). nra. }
  assert (Lq : norm q <= len).
  { unfold q. rewrite norm_scale by lra. pose proof (norm_of_three a b c). lra. }
  pose proof (three_products (norm (a - q)) (norm (b - q)) (norm (c - q)) (norm (ra - r)) (norm (rb - r)) (norm (rc - r)) s t
    (norm_nonneg _) (norm_nonneg _) (norm_nonneg _) (norm_nonneg _) (norm_nonneg _) (norm_nonneg _) S0 T0) as TP.
  rewrite !norm_sq in TP. destruct (TP De Df) as [P1 P2]. clear TP.
  assert (B3 : norm (1 / 3 *: F3) <= len * s * t / 3).
  { rewrite norm_scale by lra. pose proof (norm_of_three (dot q (a - q) *: (ra - r)) (dot q (b - q) *: (rb - r)) (dot q (c - q) *: (rc - r)))%V as G.
    fold F3 in G. rewrite !norm_scale_abs in G.
    assert (D : forall (d : quat R) (f : vec R), Rabs (dot q d) * norm f <= len * (norm d * norm f)).
    { intros d f. pose proof (dot_abs q d). pose proof (norm_nonneg d). pose proof (norm_nonneg f).
      rewrite <- Rmult_assoc. apply Rmult_le_compat_r; auto. nra. }
    pose proof (D (a - q)%V (ra - r)%V). pose proof (D (b - q)%V (rb - r)%V). pose proof (D (c - q)%V (rc - r)%V).
    assert (Len : 0 <= len) by (pose proof (norm_nonneg q); lra).
    assert (len * (norm (a - q) * norm (ra - r) + norm (b - q) * norm (rb - r) + norm (c - q) * norm (rc - r)) <= len * (s * t))
      by (apply Rmult_le_compat_l; auto). lra. }
  assert (B4 : norm (1 / 3 *: F4) <= s * s * t / 5).
  { rewrite norm_scale by lra. pose proof (norm_of_three (dot (b - q) (c - q) *: (ra - r)) (dot (a - q) (c - q) *: (rb - r)) (dot (a - q) (b - q) *: (rc - r)))%V as G.
    fold F4 in G. rewrite !norm_scale_abs in G.
    assert (D : forall (d e : quat R) (f : vec R), Rabs (dot d e) * norm f <= norm f * (norm d * norm e)).
    { intros d e f. rewrite Rmult_comm. apply Rmult_le_compat_l; [apply norm_nonneg|apply dot_abs]. }
    pose proof (D (b - q) (c - q) (ra - r))%V. pose proof (D (a - q) (c - q) (rb - r))%V. pose proof (D (a - q) (b - q) (rc - r))%V. lra. }
  pose proof (norm_add ((n2 / 6) *: rotate q x - 1 / 6 *: T) (1 / 3 *: F4 - 1 / 3 *: F3))%V.
  pose proof (norm_sub ((n2 / 6) *: rotate q x) (1 / 6 *: T))%V. pose proof (norm_sub (1 / 3 *: F4) (1 / 3 *: F3))%V. lra.
Qed.

(* The hypotheses can be met: an edge of two quaternions of unit length, and a third weight vertex between them. *)
Example halving_instance : let p := Quat 1 0 0 0 in let q := Quat (3 / 5) (4 / 5) 0 0 in
  norm2 p = norm2 q /\ (1 / 2 *: (p + q))%V <> lzero /\ (0 < length [p; q])%nat /\ (1 < length [p; q])%nat /\ 0%nat <> 1%nat.
Proof. cbv zeta. repeat split; try (cbn; lia); [vunfold; field|apply norm2_pos_inv; vunfold; lra]. Qed.
Example longest_edge_instance : let a := Quat 1 0 0 0 in let b := Quat (-1) 0 0 0 in let c := Quat 0 1 0 0 in
  norm (a - c) <= norm (a - b) /\ norm (b - c) <= norm (a - b).
Proof.
  cbv zeta. rewrite (norm_eq (Quat 1 0 0 0 - Quat (-1) 0 0 0)%V 2) by (try lra; vunfold; ring).
  split; apply norm_le; (split; [lra|]); vunfold; lra.
Qed.
Example half_points_instance : exists weight_vertices x, (0 < length weight_vertices)%nat /\
  (1 < length weight_vertices)%nat /\ 0%nat <> 1%nat /\
  weights_are_positive (spherical_points x weight_vertices).
Proof. do 2 eexists. repeat split; cycle 3; [apply control_hull_instance|cbn; lia..]. Qed.
Example rate_instance : let a := (Quat 1 0 0 0, Vec 0 0 0) in let b := (Quat (3 / 5) (4 / 5) 0 0, Vec 1 0 0) in
  norm (fst a - fst b) <= 1 /\ norm (snd a - snd b) <= 1 /\ (1 / 3 *: (fst a + fst b + fst b))%V <> lzero.
Proof.
  cbv zeta. cbn [fst snd]. split; [|split; [|apply norm2_pos_inv; vunfold; lra]]; apply norm_le; (split; [lra|]); vunfold; lra.
Qed.
