(* SPDX-License-Identifier: MIT *)
(* Lemma 4 and Corollary 1: a ball around unit vectors bounds the directions of all of their blends. Appendix of the
   paper, for d = 4 and r < 1; section 4.3 and lines 11 to 13 of Algorithm 1. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.cap.
Import ListNotations.

(* --- Statements --- *)

(* o = 1 + ||c||^2 - r^2: C is cut out of the unit sphere by {x : (x, 2 c) >= o} (Lemma 3). *)
Definition hull_offset {E} `{Euclid E} (c : E) (r : R) := 1 + norm2 c - r * r.
(* The n_i are unit vectors in the ball. *)
Definition units_in_ball {E} `{Euclid E} (c : E) (r : R) (ns : list E) :=
  Forall (fun n => norm2 n = 1 /\ in_ball (Ball c r) n) ns.
(* b / ||b|| *)
Definition direction {E} `{Euclid E} (b : E) := (/ norm b *: b)%V.
Arguments direction {E l H} b%V.

(* Lemma 4: if o >= 0, or if E holds the whole surface, b / ||b|| is in E for every b that is not 0. *)
Definition lemma4_repaired : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c : E) (r : R) (ns : list E) (b : E),
  0 <= hull_offset c r \/ 1 + norm c <= r -> units_in_ball c r ns -> in_hull ns b -> b <> lzero ->
  norm2 (direction b) = 1 /\ in_ball (Ball c r) (direction b).
(* If o > 0, no b is 0, and c is not 0. *)
Definition lemma4_not_zero : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c : E) (r : R) (ns : list E) (b : E),
  0 < hull_offset c r -> units_in_ball c r ns -> in_hull ns b -> b <> lzero /\ c <> lzero.
(* In at least two dimensions every other ball fails for some n_i and b, if it holds a unit vector at all. *)
Definition lemma4_needed : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c : E) (r : R), at_least_plane E -> 0 <= r ->
  hull_offset c r < 0 -> r < 1 + norm c ->
  exists ns b, units_in_ball c r ns /\ in_hull ns b /\ b <> lzero /\ ~ in_ball (Ball c r) (direction b).
(* Corollary 1: b / ||b|| or its negative is in E, whatever the radius. *)
Definition corollary1_repaired : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c : E) (r : R) (ns : list E) (b : E),
  units_in_ball c r ns -> in_hull ns b -> b <> lzero ->
  in_ball (Ball c r) (direction b) \/ in_ball (Ball c r) (-1 *: direction b).

(* Printed Lemma 4: for r < 1, b is not 0 and its direction is in C. This much is true. *)
Definition lemma4_printed : Prop :=
  forall (c : quat R) (r : R) (ns : list (quat R)) (b : quat R),
  0 <= r < 1 -> units_in_ball c r ns -> in_hull ns b ->
  b <> lzero /\ norm2 (direction b) = 1 /\ in_ball (Ball c r) (direction b).
(* What the fallback of section 4.3 takes for granted: a ball that holds the directions of all hulls of unit vectors in
   it has a radius below 1. *)
Definition radius_below_one_is_needed_printed : Prop :=
  forall (c : quat R) (r : R), norm c <= 1 ->
  (forall ns b, units_in_ball c r ns -> in_hull ns b -> b <> lzero /\ in_ball (Ball c r) (direction b)) -> r < 1.

(* --- Proofs --- *)

Lemma unit_in_ball {E} `{Euclid E} (c n : E) r : norm2 n = 1 -> 0 <= r ->
  in_ball (Ball c r) n <-> hull_offset c r <= 2 * dot n c.
Proof.
  intros U R. unfold in_ball, hull_offset. cbn [center radius]. rewrite norm_le.
  replace (norm2 (n - c)) with (norm2 n - 2 * dot n c + norm2 c) by (dots; ring). rewrite U. split; [intros [_ B]|]; lra.
Qed.

Lemma direction_unit {E} `{Euclid E} (b : E) : b <> lzero -> norm2 (direction b) = 1.
Proof. intros N. apply norm_pos in N. unfold direction. rewrite norm2_scale, <- norm_sq. field. lra. Qed.

(* The ball has no negative radius if it holds something. *)
Lemma radius_nonneg {E} `{Euclid E} c r (ns : list E) b : units_in_ball c r ns -> in_hull ns b -> 0 <= r.
Proof.
  intros U (w & W & _). destruct U as [|n ns [_ B] U]; [now apply convex_not_empty in W|].
  unfold in_ball in B. cbn [center radius] in B. pose proof (norm_nonneg (n - c)%V). lra.
Qed.

(* 2 (b, c) >= o, and ||b|| <= 1. *)
Lemma hull_facts {E} `{Euclid E} c r (ns : list E) b : units_in_ball c r ns -> in_hull ns b ->
  hull_offset c r <= 2 * dot b c /\ norm b <= 1.
Proof.
  intros U B. pose proof (radius_nonneg c r ns b U B) as R. split.
  - destruct B as (w & (L & P & S) & ->). rewrite dot_comb.
    assert (hull_offset c r / 2 * sum w <= comb w (map (fun n => dot n c) ns)); [|rewrite S in *; lra].
    apply comb_at_least; [now rewrite map_length|exact P|]. apply Forall_map. eapply Forall_impl; [|exact U]. cbv beta.
    intros n [N I]. apply unit_in_ball in I; auto. lra.
  - replace b with (b - lzero)%V by vec_ring. apply (hull_in_convex_set (in_ball (Ball lzero 1)) ns b); auto.
    + apply ball_convex.
    + eapply Forall_impl; [|exact U]. cbv beta. intros n [N _]. unfold in_ball. cbn [center radius].
      replace (n - lzero)%V with n by vec_ring. right. now apply norm_unit.
Qed.

Lemma direction_in_ball {E} `{Euclid E} (c b : E) r : b <> lzero -> 0 <= r ->
  in_ball (Ball c r) (direction b) <-> hull_offset c r * norm b <= 2 * dot b c.
Proof.
  intros N R. rewrite unit_in_ball by auto using direction_unit. unfold direction. rewrite dot_scale_l.
  pose proof (norm_pos b N) as P. split; intros B.
  - apply Rmult_le_compat_r with (r := norm b) in B; [|lra].
    replace (2 * (/ norm b * dot b c) * norm b) with (2 * dot b c) in B by (field; lra). exact B.
  - apply Rmult_le_reg_r with (1 := P). replace (2 * (/ norm b * dot b c) * norm b) with (2 * dot b c) by (field; lra).
    exact B.
Qed.

Theorem lemma4_repaired_holds : lemma4_repaired.
Proof.
  intros E l e c r ns b O U B N. split; [now apply direction_unit|].
  pose proof (radius_nonneg c r ns b U B) as R. destruct (hull_facts c r ns b U B) as [D Le].
  destruct O as [O|W].
  - apply direction_in_ball; auto. pose proof (norm_nonneg b). nra.
  - unfold in_ball. cbn [center radius]. eapply Rle_trans; [apply norm_sub|].
    rewrite (norm_unit (direction b)) by now apply direction_unit. lra.
Qed.

Theorem lemma4_not_zero_holds : lemma4_not_zero.
Proof.
  intros E l e c r ns b O U B. destruct (hull_facts c r ns b U B) as [D _].
  split; intros ->; autorewrite with dots in D; lra.
Qed.

Theorem corollary1_repaired_holds : corollary1_repaired.
Proof.
  intros E l e c r ns b U B N. pose proof (radius_nonneg c r ns b U B) as R.
  destruct (Rle_dec 0 (hull_offset c r)) as [O|O].
  { left. apply (lemma4_repaired_holds E l e c r ns b); auto. }
  apply Rnot_le_lt in O. pose proof (norm_nonneg b). destruct (Rle_lt_dec 0 (dot b c)) as [A|A].
  - left. apply direction_in_ball; auto. nra.
  - right. replace (-1 *: direction b)%V with (direction (-1 *: b)).
    + apply direction_in_ball; auto.
      * intros Z. apply N. apply norm2_zero_inv. apply (f_equal norm2) in Z. rewrite norm2_scale, norm2_zero in Z. lra.
      * autorewrite with dots. pose proof (norm_nonneg (-1 *: b)%V). nra.
    + unfold direction. replace (norm (-1 *: b)) with (norm b); [vec_ring|].
      unfold norm. f_equal. rewrite norm2_scale. ring.
Qed.

Theorem lemma4_needed_holds : lemma4_needed.
Proof.
  intros E l e c r P R O W.
  assert (C : 0 < norm c).
  { pose proof (norm_nonneg c). unfold hull_offset in O. rewrite <- norm_sq in O. nra. }
  set (o := hull_offset c r) in *.
  assert (O2 : - 2 * norm c < o) by (unfold o, hull_offset; rewrite <- norm_sq; nra).
  destruct (P c) as (v & V & Nv).
  set (t := o / (2 * norm c)).
  assert (T : -1 < t < 0).
  { unfold t. split; [apply Rmult_lt_reg_r with (2 * norm c)|apply Rmult_lt_reg_r with (2 * norm c)]; try lra;
      unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
  set (s := sqrt (1 - t * t)). assert (S : s * s = 1 - t * t) by (apply sqrt_sqrt; nra).
  pose proof (norm_sq c) as Qc.
  set (n1 := ((t / norm c) *: c + (s / norm c) *: v)%V). set (n2 := ((t / norm c) *: c + (- s / norm c) *: v)%V).
  assert (A : forall z, z * z = s * s -> let n := ((t / norm c) *: c + (z / norm c) *: v)%V in
    norm2 n = 1 /\ in_ball (Ball c r) n).
  { intros z Z n. assert (U : norm2 n = 1).
    { unfold n. replace (norm2 _) with (t / norm c * (t / norm c) * norm2 c + 2 * (t / norm c) * (z / norm c) * dot v c
        + (z * z) / (norm c * norm c) * norm2 v) by (dots; field; lra).
      rewrite V, Nv, Z, S, <- Qc. field. lra. }
    split; [exact U|]. apply unit_in_ball; auto. fold o. unfold n.
    replace (dot _ _) with (t / norm c * norm2 c + z / norm c * dot v c) by (dots; ring).
    rewrite V, <- Qc. unfold t. right. field. lra. }
  exists [n1; n2], ((t / norm c) *: c)%V. split; [|split; [|split]].
  - constructor; [apply A; ring|]. constructor; [|constructor]. unfold n2. apply A. ring.
  - exists [1 / 2; 1 / 2]. split; [repeat split; [repeat constructor; lra|cbn; lra]|].
    cbn [comb]. unfold n1, n2. vec_field. lra.
  - apply norm2_pos_inv. rewrite norm2_scale, <- Qc.
    replace (t / norm c * (t / norm c) * (norm c * norm c)) with (t * t) by (field; lra). nra.
  - intros B. apply direction_in_ball in B; auto.
    + fold o in B. assert (Nb : norm ((t / norm c) *: c) = - t).
      { apply norm_eq; [lra|]. rewrite norm2_scale, <- Qc. field. lra. }
      rewrite Nb, dot_scale_l in B. change (dot c c) with (norm2 c) in B. rewrite <- Qc in B.
      replace (2 * (t / norm c * (norm c * norm c))) with (o * 1) in B by (unfold t; field; lra).
      assert (o < o * - t) by nra. nra.
    + apply norm2_pos_inv. rewrite norm2_scale, <- Qc.
      replace (t / norm c * (t / norm c) * (norm c * norm c)) with (t * t) by (field; lra). nra.
Qed.

Theorem lemma4_printed_holds : lemma4_printed.
Proof.
  intros c r ns b R U B.
  assert (O : 0 < hull_offset c r) by (unfold hull_offset; pose proof (norm2_nonneg c); nra).
  destruct (lemma4_not_zero_holds _ _ _ c r ns b O U B) as [N _]. split; [exact N|].
  apply (lemma4_repaired_holds _ _ _ c r ns b); auto. left. lra.
Qed.

(* The mean ball of 1, 1, 1 and (-7/25, 24/25, 0, 0) has r = 6/5 and o = 2/25. *)
Theorem radius_below_one_is_needed_is_false : ~ radius_below_one_is_needed_printed.
Proof.
  intros P. set (c := Quat (17 / 25) (6 / 25) 0 0).
  assert (O : hull_offset c (6 / 5) = 2 / 25) by (unfold hull_offset, c; vunfold; field).
  assert (6 / 5 < 1); [|lra]. apply (P c).
  - apply norm_le. unfold c. split; vunfold; lra.
  - intros ns b U B. destruct (lemma4_not_zero_holds _ _ _ c (6 / 5) ns b) as [N _]; auto; [lra|]. split; [exact N|].
    apply (lemma4_repaired_holds _ _ _ c (6 / 5) ns b); auto. left. lra.
Qed.

Ltac units_in_ball_by_numbers := repeat apply Forall_cons; try apply Forall_nil;
  (split; [vunfold; lra|apply norm_le; cbn [center radius]; split; vunfold; lra]).

(* The hypotheses can be met: that mean ball holds its four units; a ball about (4/5, 0) with o < 0. *)
Example lemma4_instance : let c := Quat (17 / 25) (6 / 25) 0 0 in
  0 < hull_offset c (6 / 5) /\ units_in_ball c (6 / 5) [Quat 1 0 0 0; Quat (- 7 / 25) (24 / 25) 0 0].
Proof.
  split; [unfold hull_offset; vunfold; lra|].
  units_in_ball_by_numbers.
Qed.
Example lemma4_needed_instance : let c := ((4 / 5, 0) : plane) in hull_offset c (8 / 5) < 0 /\ 8 / 5 < 1 + norm c.
Proof.
  split; [unfold hull_offset; vunfold; lra|]. rewrite (norm_eq _ (4 / 5)); [lra|lra|vunfold; lra].
Qed.
Example lemma4_printed_instance : 0 <= 9 / 10 < 1 /\ units_in_ball (Quat (4 / 5) 0 0 0) (9 / 10) [Quat 1 0 0 0; Quat (3 / 5) (4 / 5) 0 0].
Proof.
  split; [lra|]. units_in_ball_by_numbers.
Qed.
