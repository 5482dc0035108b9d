(* SPDX-License-Identifier: MIT *)
(* Where a point below a chain of joints can be in any pose, from lengths and scales alone. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.b7_motion_bound.
Import ListNotations.

(* y -> t + R (s y), and how long t is and how much s stretches at most. *)
Record link := Link { turn : quat R; translation : vec R; scale : vec R }.
Record range := Range { length_ : R; stretch : R }.
Definition posed (k : link) (y : vec R) := (translation k + rotate (turn k) (scaled (scale k) y))%V.
Definition is_in_range (k : link) (r : range) := turn k <> lzero /\ norm (translation k) <= length_ r /\
  factors_within (scale k) (stretch r).

(* The first link first. *)
Definition image (links : list link) (x : vec R) := fold_right posed x links.
Definition reach (ranges : list range) (d : R) := fold_right (fun r d => stretch r * d + length_ r) d ranges.

(* --- Statements --- *)

Definition stays_in_reach : Prop := forall links ranges x d,
  Forall2 is_in_range links ranges -> norm x <= d -> norm (image links x) <= reach ranges d.
(* Stretched out at its greatest scales, the chain reaches it. *)
Definition stretched_out (r : range) := Link (Quat 1 0 0 0) (Vec (length_ r) 0 0) (Vec (stretch r) (stretch r) (stretch r)).
Definition chain_reaches : Prop := forall ranges d, 0 <= d -> Forall (fun r => 0 <= length_ r /\ 0 <= stretch r) ranges ->
  Forall2 is_in_range (map stretched_out ranges) ranges /\ norm (Vec d 0 0) = d /\
  norm (image (map stretched_out ranges) (Vec d 0 0)) = reach ranges d.

(* (i): two chains with the first links in common. *)
Definition stays_near : Prop := forall common rs links ranges others other_ranges x y d e,
  Forall2 is_in_range common rs -> Forall2 is_in_range links ranges -> Forall2 is_in_range others other_ranges ->
  norm x <= d -> norm y <= e ->
  norm (image (common ++ links) x - image (common ++ others) y) <=
    fold_right (fun r apart => stretch r * apart) (reach ranges d + reach other_ranges e) rs.
(* (ii): by linear blending, of the joints' images of the vertex, and spherically about a fixed center, of those of the center. *)
Definition blend_stays_in_reach : Prop := forall w (images : list (vec R)) r, convex (length images) w ->
  Forall (fun x => norm x <= r) images -> norm (comb w images) <= r.
Definition turned_stays_in_reach : Prop := forall qs images center w v r, comb w qs <> lzero -> convex (length images) w ->
  Forall (fun x => norm x <= r) images -> norm (skin_spherical qs images center w v) <= norm (v - center) + r.
(* By dual quaternions, of rigid joints with dot products of 0 or more, whose images are at most so far apart, pair by pair. *)
Definition dual_stays_in_reach : Prop := forall (cs : list rigid) u f r (apart : list R) A, are_within 0 cs -> convex (length cs) u ->
  Forall (fun c => norm (apply_rigid c f) <= r) cs ->
  Forall2 (fun p e => norm (apply_rigid (fst p) f - apply_rigid (snd p) f) <= e) (pairs cs) apart ->
  0 <= A -> sum (map (fun e => e * e) apart) <= A * A -> norm (dual_blend cs u f) <= r + 3 / 4 * A.

(* --- Proofs --- *)

Theorem stays_in_reach_holds : stays_in_reach.
Proof.
  intros links ranges x d F X. induction F as [|k r links ranges (N & T & S) F IH]; [exact X|].
  cbn [image reach fold_right]. fold (image links x) (reach ranges d). unfold posed.
  pose proof (norm_add (translation k) (rotate (turn k) (scaled (scale k) (image links x)))) as P.
  rewrite rotate_norm in P by exact N. pose proof (scaled_norm (scale k) (image links x) (stretch r) S) as Q.
  pose proof (factor_nonneg _ _ S).
  assert (stretch r * norm (image links x) <= stretch r * reach ranges d) by (apply Rmult_le_compat_l; auto). lra.
Qed.

Lemma image_app (a b : list link) x : image (a ++ b) x = image a (image b x).
Proof. unfold image. apply fold_right_app. Qed.
Lemma common_links_stretch common rs (x y : vec R) apart : Forall2 is_in_range common rs -> norm (x - y) <= apart ->
  norm (image common x - image common y) <= fold_right (fun r apart => stretch r * apart) apart rs.
Proof.
  intros F X. induction F as [|k r common rs (N & T & S) F IH]; [exact X|].
  cbn [image fold_right]. fold (image common x) (image common y). unfold posed.
  replace (_ - _)%V with (rotate (turn k) (scaled (scale k) (image common x)) - rotate (turn k) (scaled (scale k) (image common y)))%V
    by vec_ring.
  rewrite <- rotate_sub, rotate_norm, scaled_sub by exact N. eapply Rle_trans; [apply (scaled_norm _ _ (stretch r) S)|].
  apply Rmult_le_compat_l; [now apply (factor_nonneg (scale k))|exact IH].
Qed.
Theorem stays_near_holds : stays_near.
Proof.
  intros common rs links ranges others other_ranges x y d e C L O X Y. rewrite !image_app. apply common_links_stretch; [exact C|].
  eapply Rle_trans; [apply norm_sub|]. apply Rplus_le_compat; now apply stays_in_reach_holds.
Qed.
Theorem blend_stays_in_reach_holds : blend_stays_in_reach.
Proof.
  intros w images r W I. assert (C : convex_set (in_ball (Ball (lzero : vec R) r))) by apply ball_convex.
  assert (Z : forall x : vec R, norm (x - lzero) = norm x) by (intro x; f_equal; vec_ring).
  rewrite <- Z. apply (convex_set_comb _ w images C W).
  eapply Forall_impl; [|exact I]. intros x X. unfold in_ball. cbn [center radius]. now rewrite Z.
Qed.
Theorem turned_stays_in_reach_holds : turned_stays_in_reach.
Proof.
  intros qs images center w v r N W I. unfold skin_spherical. eapply Rle_trans; [apply norm_add|]. rewrite rotate_norm by exact N.
  apply Rplus_le_compat_l. now apply blend_stays_in_reach_holds.
Qed.

Theorem chain_reaches_holds : chain_reaches.
Proof.
  intros ranges d D F.
  assert (N : forall x, 0 <= x -> norm (Vec x 0 0) = x) by (intros x X; apply norm_eq; [exact X|vunfold; ring]).
  assert (G : Forall2 is_in_range (map stretched_out ranges) ranges /\ 0 <= reach ranges d /\
    image (map stretched_out ranges) (Vec d 0 0) = Vec (reach ranges d) 0 0).
  { induction F as [|r ranges [L S] F (IH & P & E)]; [repeat split; [constructor|exact D]|]. cbn [map reach image fold_right].
    fold (reach ranges d) (image (map stretched_out ranges) (Vec d 0 0)). split; [|split].
    - apply Forall2_cons; [|exact IH]. unfold is_in_range, stretched_out, factors_within. cbn [turn translation scale vx vy vz].
      split; [apply norm2_pos_inv; vunfold; lra|]. split; [rewrite N; lra|]. repeat split; rewrite Rabs_pos_eq; lra.
    - assert (0 <= stretch r * reach ranges d) by now apply Rmult_le_pos. lra.
    - rewrite E. unfold posed, stretched_out, rotate, scaled. cbn [turn translation scale]. vunfold. f_equal; field. }
  destruct G as (G & P & E). split; [exact G|]. split; [now apply N|]. rewrite E. now apply N.
Qed.
Theorem dual_stays_in_reach_holds : dual_stays_in_reach.
Proof.
  intros cs u f r apart A W C Rs P PA SA.
  assert (Spread : squared_spread cs f <= sum (map (fun e => e * e) apart)).
  { unfold squared_spread. induction P as [|p e ps apart Ne P IH]; [cbn; lra|]. cbn [total map]. rewrite sum_cons.
    assert (SA' : 0 <= e * e) by nra. apply Rplus_le_compat; [|apply IH; rewrite map_cons, sum_cons in SA; lra].
    rewrite <- norm_sq. pose proof (norm_nonneg (apply_rigid (fst p) f - apply_rigid (snd p) f)%V). nra. }
  pose proof (deviates_little_holds cs 0 f u W C) as D.
  assert (Off : norm (dual_blend cs u f - carried cs u f) <= 3 / 4 * A) by (apply norm_le; nra).
  assert (In : norm (carried cs u f) <= r).
  { apply blend_stays_in_reach_holds; [now rewrite map_length|]. now apply Forall_map. }
  replace (dual_blend cs u f) with ((dual_blend cs u f - carried cs u f) + carried cs u f)%V by vec_ring.
  pose proof (norm_add (dual_blend cs u f - carried cs u f)%V (carried cs u f)). lra.
Qed.

(* The hypotheses can be met, and the bound is reached: a bone of the length 1, twice as long. *)
Example reach_instance : let k := Link (Quat 1 0 0 0) (Vec 1 0 0) (Vec 2 2 2) in
  is_in_range k (Range 1 2) /\ norm (Vec 1 0 0) <= 1 /\ reach [Range 1 2] 1 = 3 /\ norm (image [k] (Vec 1 0 0)) = 3.
Proof.
  cbv zeta. unfold is_in_range, factors_within. cbn [turn translation scale length_ stretch vx vy vz].
  assert (A : Rabs 2 <= 2) by (rewrite Rabs_right; lra).
  assert (N : norm (Vec 1 0 0) = 1) by (apply norm_eq; vunfold; lra).
  repeat split; auto; try lra.
  - apply norm2_pos_inv. vunfold. lra.
  - cbn. lra.
  - apply norm_eq; [lra|]. unfold image, posed, scaled, rotate. cbn. vunfold. field.
Qed.
Example near_instance : let k := Link (Quat 1 0 0 0) (Vec 1 0 0) (Vec 2 2 2) in
  Forall2 is_in_range [k] [Range 1 2] /\ convex 1 [1] /\ Forall (fun x : vec R => norm x <= 1) [Vec 1 0 0] /\
  comb [1] [Quat 1 0 0 0] <> lzero.
Proof.
  cbv zeta. split; [|split; [|split]].
  - apply Forall2_cons; [apply reach_instance|constructor].
  - repeat split; [repeat constructor; lra|cbn; lra].
  - apply Forall_cons; [|constructor]. apply norm_le. vunfold. lra.
  - apply norm2_pos_inv. cbn. vunfold. lra.
Qed.
Example dual_instance : let c := Rigid (Quat 1 0 0 0) (Vec 1 0 0) in are_within 0 [c; c] /\ convex 2 [1 / 2; 1 / 2] /\
  Forall (fun c => norm (apply_rigid c (Vec 0 0 0)) <= 1) [c; c] /\
  Forall2 (fun p e => norm (apply_rigid (fst p) (Vec 0 0 0) - apply_rigid (snd p) (Vec 0 0 0)) <= e) (pairs [c; c]) [0] /\
  sum (map (fun e => e * e) [0]) <= 0 * 0.
Proof.
  cbv zeta. assert (I : apply_rigid (Rigid (Quat 1 0 0 0) (Vec 1 0 0)) (Vec 0 0 0) = Vec 1 0 0).
  { unfold apply_rigid, rotate. cbn [rotation quaternion.translation]. vunfold. f_equal; field. }
  split; [|split; [|split; [|split]]].
  - split; [lra|]. split; repeat constructor; cbn [fst snd rotation]; vunfold; lra.
  - repeat split; [repeat constructor; lra|cbn; lra].
  - apply Forall_cons; [|apply Forall_cons; [|constructor]]; rewrite I; apply norm_le; vunfold; lra.
  - cbn [pairs map app]. apply Forall2_cons; [|constructor]. cbn [fst snd]. rewrite I. apply norm_le. vunfold. lra.
  - cbn. lra.
Qed.
