(* SPDX-License-Identifier: MIT *)
(* Where a point below a chain of joints can be in any pose, from lengths and scales alone. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.quaternion.
Import ListNotations.

(* y -> t + R (s y), and how long t is and how much s stretches at most. *)
Record link := Link { turn : quat R; translation : vec R; scale : vec R }.
Record range := Range { length_ : R; stretch : R }.
Definition scaled (s y : vec R) := Vec (vx s * vx y) (vy s * vy y) (vz s * vz y).
Definition posed (k : link) (y : vec R) := (translation k + rotate (turn k) (scaled (scale k) y))%V.
Definition is_in_range (k : link) (r : range) := turn k <> lzero /\ norm (translation k) <= length_ r /\
  Rabs (vx (scale k)) <= stretch r /\ Rabs (vy (scale k)) <= stretch r /\ Rabs (vz (scale k)) <= stretch r.

(* The first link first. *)
Definition image (links : list link) (x : vec R) := fold_right posed x links.
Definition reach (ranges : list range) (d : R) := fold_right (fun r d => stretch r * d + length_ r) d ranges.

(* --- Statement --- *)

Definition stays_in_reach : Prop := forall links ranges x d,
  Forall2 is_in_range links ranges -> norm x <= d -> norm (image links x) <= reach ranges d.

(* --- Proof --- *)

Lemma square_of_factor (a f x : R) : Rabs a <= f -> a * x * (a * x) <= f * f * (x * x).
Proof.
  intros A. assert (B : a * a <= f * f).
  { pose proof (Rabs_pos a). assert (Rabs a * Rabs a <= f * f) by nra. rewrite <- Rabs_mult in *.
    pose proof (Rle_abs (a * a)). lra. }
  pose proof (Rle_0_sqr x) as X. unfold Rsqr in X. nra.
Qed.
Lemma scaled_norm (s y : vec R) (f : R) : Rabs (vx s) <= f -> Rabs (vy s) <= f -> Rabs (vz s) <= f ->
  norm (scaled s y) <= f * norm y.
Proof.
  intros X Y Z. assert (F : 0 <= f) by (pose proof (Rabs_pos (vx s)); lra). apply norm_le.
  split; [apply Rmult_le_pos; [exact F|apply norm_nonneg]|].
  assert (Q : f * norm y * (f * norm y) = f * f * norm2 y) by (rewrite <- (norm_sq y); ring). rewrite Q. clear Q.
  pose proof (square_of_factor _ f (vx y) X). pose proof (square_of_factor _ f (vy y) Y). pose proof (square_of_factor _ f (vz y) Z).
  destruct s, y. unfold scaled. vunfold. lra.
Qed.

Theorem stays_in_reach_holds : stays_in_reach.
Proof.
  intros links ranges x d F X. induction F as [|k r links ranges (N & T & A & B & C) F IH]; [exact X|].
  cbn [image reach fold_right]. fold (image links x) (reach ranges d). unfold posed.
  pose proof (norm_add (translation k) (rotate (turn k) (scaled (scale k) (image links x)))) as P.
  rewrite rotate_norm in P by exact N. pose proof (scaled_norm (scale k) (image links x) (stretch r) A B C) as Q.
  assert (S : 0 <= stretch r) by (pose proof (Rabs_pos (vx (scale k))); lra).
  assert (stretch r * norm (image links x) <= stretch r * reach ranges d) by (apply Rmult_le_compat_l; auto). lra.
Qed.

(* The hypotheses can be met, and the bound is reached: a bone of the length 1, twice as long. *)
Example reach_instance : let k := Link (Quat 1 0 0 0) (Vec 1 0 0) (Vec 2 2 2) in
  is_in_range k (Range 1 2) /\ norm (Vec 1 0 0) <= 1 /\ reach [Range 1 2] 1 = 3 /\ norm (image [k] (Vec 1 0 0)) = 3.
Proof.
  cbv zeta. unfold is_in_range. cbn [turn translation scale length_ stretch vx vy vz].
  assert (A : Rabs 2 <= 2) by (rewrite Rabs_right; lra).
  assert (N : norm (Vec 1 0 0) = 1) by (apply norm_eq; vunfold; lra).
  repeat split; auto; try lra.
  - apply norm2_pos_inv. vunfold. lra.
  - cbn. lra.
  - apply norm_eq; [lra|]. unfold image, posed, scaled, rotate. cbn. vunfold. field.
Qed.
