(* SPDX-License-Identifier: MIT *)
(* Bounds that hold throughout an interval, and throughout a box of parameters, from convex sets that hold the ends. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.curve Refitlab.c1_chord_bound.
Import ListNotations.

(* x is in K blown up by e. *)
Definition near {E} `{Euclid E} (K : E -> Prop) (x : E) (e : R) := exists y, K y /\ norm (x - y) <= e.
Arguments near {E l H} K x%V e.

(* f has two derivatives, no longer than v and m. Over a length of h it is then within this of its chord. *)
Definition is_curved {E} `{Euclid E} (f : R -> E) (v m a b : R) := exists f' f'', derivative f f' a b /\ derivative f' f'' a b /\
  within f' v a b /\ within f'' m a b.
Definition least_slack (v m h : R) := Rmin (m * (h * h) / 8) (v * h / 2).

(* A side of a box of parameters, and the bounds of both derivatives along it. *)
Record side := Side { low : R; high : R; fast : R; bend : R }.
Definition slack (d : side) := least_slack (fast d) (bend d) (high d - low d).

Fixpoint in_box (sides : list side) (xs : list R) : Prop :=
  match sides, xs with
  | [], [] => True
  | d :: sides, x :: xs => low d <= x <= high d /\ in_box sides xs
  | _, _ => False end.
(* Along each side, the others being held, f is curved within the bounds. *)
Fixpoint bends {E} `{Euclid E} (f : list R -> E) (sides : list side) : Prop :=
  match sides with
  | [] => True
  | d :: sides => low d < high d /\
      (forall xs, in_box sides xs -> is_curved (fun x => f (x :: xs)) (fast d) (bend d) (low d) (high d)) /\
      (forall x, low d <= x <= high d -> bends (fun xs => f (x :: xs)) sides) end.
(* K holds f at all corners of the box. *)
Fixpoint at_corners {E} (K : E -> Prop) (f : list R -> E) (sides : list side) : Prop :=
  match sides with
  | [] => K (f [])
  | d :: sides => at_corners K (fun xs => f (low d :: xs)) sides /\ at_corners K (fun xs => f (high d :: xs)) sides end.
Fixpoint total_slack (sides : list side) : R :=
  match sides with [] => 0 | d :: sides => slack d + total_slack sides end.

(* --- Statements --- *)

(* (i) *)
Definition interval_in_convex_set : Prop := forall E (l : Lin R E) (H : Euclid E) (K : E -> Prop) (f : R -> E) (a b v m s : R),
  convex_set K -> K (f a) -> K (f b) -> a < b -> is_curved f v m a b -> 0 <= s <= 1 ->
  near K (f (a + s * (b - a))%R) (least_slack v m (b - a)).
(* Where nothing is known of a second derivative. *)
Definition interval_in_convex_set_by_speed : Prop := forall E (l : Lin R E) (H : Euclid E) (K : E -> Prop) (f f' : R -> E) (a b v s : R),
  convex_set K -> K (f a) -> K (f b) ->
  a < b -> derivative f f' a b -> within f' v a b -> 0 <= s <= 1 -> near K (f (a + s * (b - a))%R) (v * (b - a) / 2).
(* A ball and a slab are blown up so, by whichever slack, of an interval or of a box. *)
Definition ball_blown_up : Prop := forall E (l : Lin R E) (H : Euclid E) (c : E) (r e : R) (x : E),
  near (in_ball (Ball c r)) x e -> in_ball (Ball c (r + e)) x.
Definition slab_blown_up : Prop := forall E (l : Lin R E) (H : Euclid E) (n : E) (lo hi e : R) (x : E),
  near (fun y => lo <= dot n y <= hi) x e -> lo - norm n * e <= dot n x <= hi + norm n * e.
Definition interval_in_ball : Prop := forall E (l : Lin R E) (H : Euclid E) (c : E) (r : R) (f : R -> E) (a b v m s : R),
  in_ball (Ball c r) (f a) -> in_ball (Ball c r) (f b) -> a < b -> is_curved f v m a b -> 0 <= s <= 1 ->
  in_ball (Ball c (r + least_slack v m (b - a))) (f (a + s * (b - a))%R).
Definition interval_in_slab : Prop := forall E (l : Lin R E) (H : Euclid E) (n : E) (lo hi : R) (f : R -> E) (a b v m s : R),
  lo <= dot n (f a) <= hi -> lo <= dot n (f b) <= hi -> a < b -> is_curved f v m a b -> 0 <= s <= 1 ->
  let wider := norm n * least_slack v m (b - a) in lo - wider <= dot n (f (a + s * (b - a))%R) <= hi + wider.

(* (ii) *)
Definition box_in_convex_set : Prop := forall E (l : Lin R E) (H : Euclid E) (K : E -> Prop) (f : list R -> E) sides xs,
  convex_set K -> bends f sides -> at_corners K f sides -> in_box sides xs -> near K (f xs) (total_slack sides).

(* (iii) *)
Definition least_over_interval : Prop := forall (g : R -> R) (a b c v m s : R),
  c <= g a -> c <= g b -> a < b -> is_curved g v m a b -> 0 <= s <= 1 -> c - least_slack v m (b - a) <= g (a + s * (b - a)).

(* The hull of the ends, without a slack: false. *)
Definition ends_are_enough_somewhere : Prop := forall (K : R -> Prop) (f f' f'' : R -> R) (a b s : R),
  convex_set K -> K (f a) -> K (f b) ->
  a < b -> derivative f f' a b -> derivative f' f'' a b -> 0 <= s <= 1 -> K (f (a + s * (b - a))).

(* --- Proofs --- *)

Lemma chord_in_convex_set {E} `{Euclid E} (K : E -> Prop) x y s : convex_set K -> K x -> K y -> 0 <= s <= 1 -> K (between x y s).
Proof. intros C X Y S. unfold between. replace s with (1 - (1 - s)) at 2 by ring. apply C; auto; lra. Qed.

Lemma chord_by_speed {E} {l : Lin R E} {H : Euclid E} (f f' : R -> E) (a b v s : R) : a < b -> derivative f f' a b -> within f' v a b ->
  0 <= s <= 1 -> norm (f (a + s * (b - a))%R - between (f a) (f b) s) <= v * (b - a) / 2.
Proof.
  intros AB D W S. eapply Rle_trans; [exact (chord_first_order_holds E l H f f' a b v s AB D W S)|].
  assert (V : 0 <= v) by (eapply Rle_trans; [apply norm_nonneg|apply (W a); lra]).
  assert (P : 0 <= v * (b - a)) by (apply Rmult_le_pos; lra). pose proof (Rle_0_sqr (s - 1 / 2)) as Q. unfold Rsqr in Q.
  replace (2 * (s * (1 - s)) * (b - a) * v) with (2 * (v * (b - a)) * (s * (1 - s))) by ring. nra.
Qed.
Lemma chord_is_near {E} {l : Lin R E} {H : Euclid E} (f : R -> E) (a b v m s : R) : a < b -> is_curved f v m a b -> 0 <= s <= 1 ->
  norm (f (a + s * (b - a))%R - between (f a) (f b) s) <= least_slack v m (b - a).
Proof.
  intros AB (f' & f'' & D1 & D2 & V & W) S. apply Rmin_glb; [|now apply (chord_by_speed f f')].
  exact (chord_slack_holds E l H f f' f'' a b m s AB D1 D2 W S).
Qed.

Theorem interval_in_convex_set_by_speed_holds : interval_in_convex_set_by_speed.
Proof.
  intros E l H K f f' a b v s C A B AB D V S. exists (between (f a) (f b) s). split; [now apply chord_in_convex_set|].
  now apply (chord_by_speed f f').
Qed.
Theorem interval_in_convex_set_holds : interval_in_convex_set.
Proof.
  intros E l H K f a b v m s C A B AB D S. exists (between (f a) (f b) s). split; [now apply chord_in_convex_set|]. now apply chord_is_near.
Qed.

Theorem ball_blown_up_holds : ball_blown_up.
Proof.
  intros E l H c r e x (y & Y & N). unfold in_ball in *. cbn [center radius] in *.
  replace (x - c)%V with ((x - y) + (y - c))%V by vec_ring. pose proof (norm_add (x - y)%V (y - c)%V). lra.
Qed.
Theorem slab_blown_up_holds : slab_blown_up.
Proof.
  intros E l H n lo hi e x (y & Y & N). replace (dot n x) with (dot n (x - y) + dot n y) by (rewrite dot_sub_r; ring).
  pose proof (dot_le_norms n (x - y)%V) as U. pose proof (dot_ge_norms n (x - y)%V) as V.
  assert (norm n * norm (x - y) <= norm n * e) by (apply Rmult_le_compat_l; [apply norm_nonneg|exact N]). lra.
Qed.
Lemma slab_convex {E} {l : Lin R E} {H : Euclid E} (n : E) (lo hi : R) : convex_set (fun x => lo <= dot n x <= hi).
Proof. intros t x y T X Y. rewrite dot_add_r, !dot_scale_r. nra. Qed.

Theorem interval_in_ball_holds : interval_in_ball.
Proof. intros E l H c r f a b v m s A B AB D S. apply ball_blown_up_holds, interval_in_convex_set_holds; auto using ball_convex. Qed.
Theorem interval_in_slab_holds : interval_in_slab.
Proof.
  intros E l H n lo hi f a b v m s A B AB D S. apply slab_blown_up_holds.
  apply (interval_in_convex_set_holds E l H (fun x => lo <= dot n x <= hi)); auto using slab_convex.
Qed.

Theorem box_in_convex_set_holds : box_in_convex_set.
Proof.
  intros E l H K f sides. revert f. induction sides as [|d sides IH]; intros f xs C B A I.
  - destruct xs as [|x xs]; [|contradiction]. exists (f []). split; [exact A|].
    replace (f [] - f [])%V with (0 *: f [])%V by vec_ring. rewrite norm_scale by lra. cbn [total_slack]. lra.
  - destruct xs as [|x xs]; [contradiction|]. destruct I as [X I], B as (LH & D & B), A as [A0 A1].
    destruct (IH (fun xs => f (low d :: xs)) xs C (B (low d) ltac:(lra)) A0 I) as (y0 & Y0 & N0).
    destruct (IH (fun xs => f (high d :: xs)) xs C (B (high d) ltac:(lra)) A1 I) as (y1 & Y1 & N1).
    specialize (D xs I). set (s := (x - low d) / (high d - low d)).
    assert (Sx : x = low d + s * (high d - low d)) by (unfold s; field; lra).
    assert (S : 0 <= s <= 1).
    { assert (P : 0 < / (high d - low d)) by (apply inv_pos; lra). unfold s, Rdiv. split; [apply Rmult_le_pos; lra|].
      apply Rmult_le_reg_r with (high d - low d); [lra|]. rewrite Rmult_assoc, Rinv_l by lra. lra. }
    exists (between y0 y1 s). split; [now apply chord_in_convex_set|].
    pose proof (chord_is_near _ (low d) (high d) (fast d) (bend d) s LH D S) as N. cbv beta in N.
    rewrite <- Sx in N. cbv beta in N0, N1. fold (slack d) in N. cbn [total_slack].
    set (p := f (x :: xs)) in *. set (p0 := f (low d :: xs)) in *. set (p1 := f (high d :: xs)) in *.
    replace (p - between y0 y1 s)%V with ((p - between p0 p1 s) + ((1 - s) *: (p0 - y0) + s *: (p1 - y1)))%V
      by (unfold between; vec_ring).
    pose proof (norm_add (p - between p0 p1 s)%V ((1 - s) *: (p0 - y0) + s *: (p1 - y1))%V) as T1.
    pose proof (norm_add ((1 - s) *: (p0 - y0))%V (s *: (p1 - y1))%V) as T2. rewrite !norm_scale in T2 by lra.
    assert ((1 - s) * norm (p0 - y0) <= (1 - s) * total_slack sides) by (apply Rmult_le_compat_l; lra).
    assert (s * norm (p1 - y1) <= s * total_slack sides) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Theorem least_over_interval_holds : least_over_interval.
Proof.
  intros g a b c v m s A B AB D S.
  assert (C : convex_set (fun x : R => c <= x)). { intros t x y T X Y. cbn. nra. }
  destruct (interval_in_convex_set_holds R _ _ _ g a b v m s C A B AB D S) as (y & Y & N).
  cbv beta in Y. set (x := g (a + s * (b - a))) in *. unfold norm, norm2 in N. cbn in N. fold (Rsqr (x - y)) in N. rewrite sqrt_Rsqr_abs in N.
  pose proof (Rle_abs (- (x - y))) as P. rewrite Rabs_Ropp in P. lra.
Qed.

Theorem ends_are_enough_is_false : ~ ends_are_enough_somewhere.
Proof.
  intros F. assert (C : convex_set (fun x : R => 0 <= x)). { intros t x y T X Y. cbn. nra. }
  (* (2 x - 1)^2 - 1 / 2 = 4 x^2 - 4 x + 1 / 2 is 1 / 2 at both ends, and - 1 / 2 half-way. *)
  pose (f := fun x => 4 * square x + (-4 * x + 1 / 2)).
  assert (D1 : derivative f (fun x => 4 * (2 * x) + -4) 0 1).
  { intros e t T. cbn. replace ((4 * (2 * t) + -4) * e) with ((4 * (2 * t) + (-4 * 1 + 0)) * e + f t * 0) by ring.
    apply (derivable_pt_lim_mult f (fun _ => e) t); [|apply derivable_pt_lim_const].
    apply (derivable_pt_lim_plus (fun x => 4 * square x) (fun x => -4 * x + 1 / 2) t).
    - apply (derivable_pt_lim_scal square 4 t). pose proof (square_derivative 1 t T) as Q. cbn in Q. rewrite Rmult_1_r in Q.
      intros eps P. destruct (Q eps P) as (delta & G). exists delta. intros h Hn Hd. specialize (G h Hn Hd). now rewrite !Rmult_1_r in G.
    - apply (derivable_pt_lim_plus (fun x => -4 * x) (fun _ => 1 / 2) t); [|apply derivable_pt_lim_const].
      apply (derivable_pt_lim_scal id (-4) t), derivable_pt_lim_id. }
  assert (D2 : derivative (fun x => 4 * (2 * x) + -4) (fun _ => 8) 0 1).
  { intros e t _. cbn. replace (8 * e) with ((4 * (2 * 1) + 0) * e + (4 * (2 * t) + -4) * 0) by ring.
    apply (derivable_pt_lim_mult (fun x => 4 * (2 * x) + -4) (fun _ => e) t); [|apply derivable_pt_lim_const].
    apply (derivable_pt_lim_plus (fun x => 4 * (2 * x)) (fun _ => -4) t); [|apply derivable_pt_lim_const].
    apply (derivable_pt_lim_scal (fun x => 2 * x) 4 t), (derivable_pt_lim_scal id 2 t), derivable_pt_lim_id. }
  specialize (F _ f (fun x => 4 * (2 * x) + -4) (fun _ => 8) 0 1 (1 / 2) C). cbv beta in F. unfold f, square in F.
  assert (G : 0 <= 4 * ((0 + 1 / 2 * (1 - 0)) * (0 + 1 / 2 * (1 - 0))) + (-4 * (0 + 1 / 2 * (1 - 0)) + 1 / 2)).
  { apply F; try lra; [exact D1|exact D2]. }
  lra.
Qed.

(* The hypotheses can be met: the square over [0, 1], in the ball about 1 / 2 of the radius 1 / 2, as a function of one parameter. *)
Lemma square_is_curved : is_curved square 2 2 0 1.
Proof.
  destruct chord_instance as (A & B & C & _). exists (fun x => 2 * x), (fun _ => 2). repeat split; auto. intros t T.
  unfold norm, norm2. cbn. fold (Rsqr (2 * t)). rewrite sqrt_Rsqr; lra.
Qed.
Example interval_instance : convex_set (in_ball (Ball (1 / 2) (1 / 2))) /\ in_ball (Ball (1 / 2) (1 / 2)) (square 0) /\
  in_ball (Ball (1 / 2) (1 / 2)) (square 1) /\ is_curved square 2 2 0 1 /\ near (in_ball (Ball (1 / 2) (1 / 2))) (square 0) 0 /\
  near (fun y : R => 0 <= dot (1 : R) y <= 1) (square 0) 0.
Proof.
  assert (N : forall x, Rabs x <= 1 / 2 -> norm x <= 1 / 2).
  { intros x X. unfold norm, norm2. cbn. fold (Rsqr x). now rewrite sqrt_Rsqr_abs. }
  assert (Z : norm (square 0 - square 0)%V <= 0) by (apply norm_le; unfold square; vunfold; lra).
  split; [apply ball_convex|]. split; [|split; [|split; [apply square_is_curved|split]]].
  1, 2: unfold in_ball, square; cbn; apply N; apply Rabs_le; lra.
  - exists (square 0). split; [unfold in_ball, square; cbn; apply N, Rabs_le; lra|exact Z].
  - exists (square 0). split; [unfold square; cbn; lra|exact Z].
Qed.
Example box_instance : bends (fun xs => match xs with x :: _ => square x | [] => 0 end) [Side 0 1 2 2] /\ in_box [Side 0 1 2 2] [1 / 2] /\
  at_corners (fun x => 0 <= x) (fun xs => match xs with x :: _ => square x | [] => 0 end) [Side 0 1 2 2].
Proof.
  cbn [bends in_box at_corners low high fast bend]. unfold square at 2 3. repeat split; try lra. intros xs _. apply square_is_curved.
Qed.
