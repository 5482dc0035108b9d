(* SPDX-License-Identifier: MIT *)
(* Lemma 3: where a ball cuts a sphere's surface there is a cap, and its half-space is at a known distance. Appendix of
   the paper; section 4.3 and line 13 of Algorithm 1, with a = 0 and r_a = 1. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.cap Refitlab.lemma1_cap_definitions.

(* --- Statements: A is the surface [a, ra], B the ball [b, rb], delta = ||b - a|| --- *)

(* H = {x : (x, 2 (b - a)) >= r_a^2 - r_b^2 + ||b||^2 - ||a||^2} *)
Definition H_normal {E} `{Euclid E} (a b : E) : E := (2 *: (b - a))%V.
Definition H_offset {E} `{Euclid E} (a b : E) (ra rb : R) : R := ra * ra - rb * rb + norm2 b - norm2 a.
(* e = delta^2 + r_a^2 - r_b^2 *)
Definition offset_from_center {E} `{Euclid E} (a b : E) (ra rb : R) : R := norm2 (b - a) + ra * ra - rb * rb.

(* (1) A point of A is in B if and only if it is in H. *)
Definition ball_is_half_space : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (a b x : E) (ra rb : R), 0 <= rb -> on_surface a ra x ->
  (in_ball (Ball b rb) x <-> in_half_space (H_normal a b) (H_offset a b ra rb) x).
(* A meets B if and only if |delta - r_a| <= r_b. *)
Definition surface_meets_ball : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (a b : E) (ra rb : R), b <> a -> 0 <= ra -> 0 <= rb ->
  ((exists x, on_surface a ra x /\ in_ball (Ball b rb) x) <-> Rabs (norm (b - a) - ra) <= rb).
(* If they meet, what they have in common is a cap. *)
Definition intersection_is_cap_repaired : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (a b : E) (ra rb : R), b <> a -> 0 < ra -> 0 <= rb ->
  (exists x, on_surface a ra x /\ in_ball (Ball b rb) x) ->
  exists apex t, norm (apex - a) = ra /\ -1 <= t <= 1 /\
  forall x, (on_surface a ra x /\ in_ball (Ball b rb) x) <-> in_cap a apex t x.
(* (2) a is outside H if and only if r_b^2 < r_a^2 + delta^2. *)
Definition center_outside : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (a b : E) (ra rb : R),
  (~ in_half_space (H_normal a b) (H_offset a b ra rb) a <-> rb * rb < ra * ra + norm2 (b - a)).
(* While e >= 0, the distance from a to H is e / (2 delta): some point of H is so far from a, and none is nearer. *)
Definition distance_repaired : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (a b : E) (ra rb : R), b <> a -> 0 <= offset_from_center a b ra rb ->
  let distance := offset_from_center a b ra rb / (2 * norm (b - a)) in
  let H := in_half_space (H_normal a b) (H_offset a b ra rb) in
  (exists foot, H foot /\ norm (foot - a) = distance) /\ (forall y, H y -> distance <= norm (y - a)).

(* Printed: a surface and a ball always have a cap in common. *)
Definition intersection_is_cap_printed (E : Type) `{Euclid E} : Prop :=
  forall (a b : E) (ra rb : R), 0 < ra -> 0 <= rb ->
  exists apex t, norm (apex - a) = ra /\ -1 <= t <= 1 /\
  forall x, (on_surface a ra x /\ in_ball (Ball b rb) x) <-> in_cap a apex t x.
Definition intersection_is_cap_printed_somewhere := somewhere (@intersection_is_cap_printed).
(* Printed: for a = 0 and r_a = 1, r_b < 1 puts 0 outside H, at the distance (1 + ||b||^2 - r_b^2) / (2 ||b||), which is
   a number. *)
Definition distance_printed (E : Type) `{Euclid E} : Prop :=
  forall (b : E) (rb : R), 0 <= rb < 1 ->
  2 * norm b <> 0 /\ exists foot, in_half_space (H_normal lzero b) (H_offset lzero b 1 rb) foot /\
  norm foot = (1 + norm2 b - rb * rb) / (2 * norm b).
Definition distance_printed_somewhere := somewhere (@distance_printed).

(* --- Proofs --- *)

(* ||x - b||^2 - r_b^2 is ||x - a||^2 - r_a^2 minus ((x, 2 (b - a)) - offset). *)
Lemma radical_plane {E} `{Euclid E} (a b x : E) (ra rb : R) :
  norm2 (x - b) - rb * rb = norm2 (x - a) - ra * ra - (dot x (H_normal a b) - H_offset a b ra rb).
Proof. unfold H_normal, H_offset. dots. ring. Qed.

Theorem ball_is_half_space_holds : ball_is_half_space.
Proof.
  intros E l e a b x ra rb P S. unfold in_ball, in_half_space. cbn [center radius]. rewrite norm_le.
  pose proof (radical_plane a b x ra rb) as I. unfold on_surface in S. rewrite <- (norm_sq (x - a)%V), S in I.
  split; [intros [_ B]; lra|]. intros B. split; [exact P|lra].
Qed.

Lemma difference_not_zero {E} `{Euclid E} (a b : E) : b <> a -> (b - a)%V <> lzero.
Proof.
  intros N Z. apply N. apply dot_ext. intros z. pose proof (f_equal (fun y => dot y z) Z) as G. cbv beta in G.
  autorewrite with dots in G. lra.
Qed.

(* The point of the surface that is nearest to b. *)
Lemma nearest_on_surface {E} `{Euclid E} (a b : E) ra : b <> a -> 0 <= ra ->
  let x := (a + (ra / norm (b - a)) *: (b - a))%V in
  on_surface a ra x /\ norm (x - b) = Rabs (norm (b - a) - ra).
Proof.
  intros N P x. pose proof (norm_pos _ (difference_not_zero a b N)) as D. set (delta := norm (b - a)) in *.
  assert (Q : 0 <= ra / delta) by (apply Rmult_le_pos; auto; left; now apply inv_pos).
  split.
  - unfold on_surface, x. replace (a + (ra / delta) *: (b - a) - a)%V with ((ra / delta) *: (b - a))%V by vec_ring.
    rewrite norm_scale by auto. fold delta. field. lra.
  - apply norm_eq; [apply Rabs_pos|]. rewrite <- Rabs_mult, Rabs_pos_eq by apply Rle_0_sqr.
    replace (x - b)%V with ((ra / delta - 1) *: (b - a))%V by (unfold x; vec_ring).
    rewrite norm2_scale, <- norm_sq. fold delta. field. lra.
Qed.

Theorem surface_meets_ball_holds : surface_meets_ball.
Proof.
  intros E l e a b ra rb N P Q. split.
  - intros (x & S & B). unfold on_surface in S. unfold in_ball in B. cbn [center radius] in B.
    pose proof (norm_triangle b x a) as T1. pose proof (norm_triangle x b a) as T2.
    rewrite (norm_opposite b x), S in T1. rewrite S in T2. apply Rabs_le. lra.
  - intros A. destruct (nearest_on_surface a b ra N P) as [S D]. eexists. split; [exact S|].
    unfold in_ball. cbn [center radius]. lra.
Qed.

Lemma H_normal_not_zero {E} `{Euclid E} (a b : E) : b <> a -> H_normal a b <> lzero.
Proof.
  intros N. apply difference_not_zero, norm2_pos in N. apply norm2_pos_inv. unfold H_normal. rewrite norm2_scale. lra.
Qed.

Theorem intersection_is_cap_repaired_holds : intersection_is_cap_repaired.
Proof.
  intros E l e a b ra rb N P Q (y & S & B). pose proof (H_normal_not_zero a b N) as Nn.
  destruct (scale_exists_holds E l e (H_normal a b) ra Nn P) as (s & S0 & Sn).
  assert (M : meets a ra (H_normal a b) (H_offset a b ra rb)).
  { exists y. split; auto. now apply (ball_is_half_space_holds E l e a b y ra rb). }
  destruct (half_space_is_cap_repaired_holds E l e a (H_normal a b) ra _ s Nn P M S0 Sn) as (T & A & I).
  eexists; eexists. split; [exact A|]. split; [exact T|]. intros x. rewrite <- I.
  split; intros [X XB]; split; auto; now apply (ball_is_half_space_holds E l e a b x ra rb).
Qed.

Lemma offset_at_center {E} `{Euclid E} (a b : E) ra rb :
  H_offset a b ra rb - dot a (H_normal a b) = offset_from_center a b ra rb.
Proof. unfold H_offset, H_normal, offset_from_center. dots. ring. Qed.

Theorem center_outside_holds : center_outside.
Proof.
  intros E l e a b ra rb. unfold in_half_space. pose proof (offset_at_center a b ra rb) as O.
  unfold offset_from_center in O. split; lra.
Qed.

Theorem distance_repaired_holds : distance_repaired.
Proof.
  intros E l e a b ra rb N P distance. set (o := offset_from_center a b ra rb) in *.
  pose proof (norm_pos _ (difference_not_zero a b N)) as D. pose proof (norm_sq (b - a)%V) as Q.
  set (delta := norm (b - a)) in *.
  assert (V : forall y, dot y (H_normal a b) - H_offset a b ra rb = 2 * dot (y - a) (b - a) - o).
  { intros y. unfold o. rewrite <- offset_at_center. unfold H_normal. dots. ring. }
  split.
  - exists (a + (o / (2 * norm2 (b - a))) *: (b - a))%V. split.
    + unfold in_half_space. assert (0 <= dot (a + (o / (2 * norm2 (b - a))) *: (b - a)) (H_normal a b) - H_offset a b ra rb).
      { rewrite V. replace (dot _ _) with (o / (2 * norm2 (b - a)) * norm2 (b - a)) by (dots; ring).
        rewrite <- Q. right. field. lra. }
      lra.
    + rewrite <- Q. replace (_ - a)%V with ((o / (2 * (delta * delta))) *: (b - a))%V by vec_ring.
      rewrite norm_scale; [fold delta; unfold distance; field; lra|].
      apply Rmult_le_pos; auto. left. apply inv_pos. nra.
  - intros y Y. unfold in_half_space in Y. specialize (V y).
    pose proof (dot_le_norms (y - a)%V (b - a)%V) as C. fold delta in C. unfold distance.
    apply Rmult_le_reg_r with (2 * delta); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

(* A point ball inside the sphere, at its center. *)
Theorem intersection_is_cap_printed_is_false : ~ intersection_is_cap_printed_somewhere.
Proof.
  intros (E & l & e & _ & S). destruct (S lzero lzero 1 0) as (apex & t & A & T & I); [lra..|].
  destruct (proj2 (I apex)) as [_ B].
  - split; [reflexivity|]. change (dot (apex - lzero) (apex - lzero)) with (norm2 (apex - lzero)).
    pose proof (norm2_nonneg (apex - lzero)%V). nra.
  - unfold in_ball in B. cbn [center radius] in B. lra.
Qed.

(* b = 0: the formula divides by 0. *)
Theorem distance_printed_is_false : ~ distance_printed_somewhere.
Proof. intros (E & l & e & _ & S). destruct (S lzero 0) as [N _]; [lra|]. apply N. rewrite norm_zero. ring. Qed.

(* The hypotheses can be met: the unit circle and the disc of radius 1 about (1, 0), where e = 1. *)
Example intersection_instance : ((1, 0) : plane) <> (0, 0) /\
  (exists x : plane, on_surface (0, 0) 1 x /\ in_ball (Ball (1, 0) 1) x) /\
  0 <= offset_from_center ((0, 0) : plane) (1, 0) 1 1.
Proof.
  split; [intros Z; apply (f_equal fst) in Z; cbn in Z; lra|]. split.
  - exists (1, 0). split; [apply norm_unit|unfold in_ball; apply norm_le; cbn [center radius]; split]; vunfold; lra.
  - unfold offset_from_center. vunfold. lra.
Qed.
