(* SPDX-License-Identifier: MIT *)
(* How a joint moves in a crossfade of two clips: translations, scales, and rotations that are blended and normalised, or blended by slerp in
   the weight. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.curve.
Require Import Refitlab.c2_channel_motion Refitlab.c3_normalized_motion Refitlab.c4_chain_motion.
Import ListNotations.

Definition faded {E} `{Euclid E} (x y : E) (w : R) := ((1 - w) *: x + w *: y)%V.

(* --- Statements --- *)

(* (i), in the time of the first clip; in that of the second with w in place of 1 - w. *)
Definition fades_by_time : Prop := forall E (l : Lin R E) (H : Euclid E) (f : R -> E) (y : E) (m : motion) (n w share a b : R),
  moves f m a b -> norm y <= n -> 0 <= w <= 1 -> 1 - w <= share ->
  moves (fun t => faded (f t) y w) (Motion (Rmax (size m) n) (share * speed m) (share * acceleration m)) a b.
(* (i), in the weight. *)
Definition fades_by_weight : Prop := forall E (l : Lin R E) (H : Euclid E) (x y : E) (n g : R),
  norm x <= n -> norm y <= n -> norm (y - x) <= g -> moves (faded x y) (Motion n g 0) 0 1.
(* (ii) *)
Definition blend_of_units : Prop := forall E (l : Lin R E) (H : Euclid E) (p q : E) (c w : R),
  norm2 p = 1 -> norm2 q = 1 -> c <= dot p q -> c <= 1 -> 0 <= w <= 1 ->
  norm (q - p) <= sqrt (2 - 2 * c) /\ sqrt ((1 + c) / 2) <= norm (faded p q w).
Definition nlerp_moves : Prop := forall (p q : quat R) (c : R),
  norm2 p = 1 -> norm2 q = 1 -> c <= dot p q -> -1 < c <= 1 ->
  moves (fun w => normalized (faded p q w)) (normalized_motion (sqrt (2 - 2 * c)) 0 (sqrt ((1 + c) / 2))) 0 1.
(* And in the time of the first clip, or of the second. *)
Definition nlerp_moves_by_time : Prop := forall (p : R -> quat R) (q : quat R) (s L A c w share a b : R), moves p (Motion s L A) a b ->
  (forall t, a <= t <= b -> norm2 (p t) = 1 /\ c <= dot (p t) q) -> norm2 q = 1 -> -1 < c <= 1 -> 0 <= w <= 1 -> 1 - w <= share ->
  moves (fun t => normalized (faded (p t) q w)) (normalized_motion (share * L) (share * A) (sqrt ((1 + c) / 2))) a b.
(* (iii) and (iv), in the weight: the angle of p and q is beta, and theta is that of a bound of its cosine. *)
Definition slerp_fades_by_weight : Prop := forall E (l : Lin R E) (H : Euclid E) (p q : E) (beta theta : R), 0 < beta < PI -> 0 <= theta <= PI ->
  norm2 p = 1 -> norm2 q = 1 -> dot p q = cos beta -> cos theta <= dot p q ->
  moves (slerp p q beta 1) (Motion 1 theta (theta * theta)) 0 1.

(* --- Proofs --- *)

Theorem fades_by_time_holds : fades_by_time.
Proof.
  intros E l H f y m n w share a b (f' & f'' & F & F' & M) Y W S.
  assert (Fade : forall g g', derivative g g' a b -> derivative (fun t => (1 - w) *: g t)%V (fun t => (1 - w) *: g' t)%V a b).
  { intros g g' G. apply (derivative_map (fun x : E => ((1 - w) *: x)%V)); [apply scaling_has_adjoint|exact G]. }
  exists (fun t => (1 - w) *: f' t)%V, (fun t => (1 - w) *: f'' t)%V. split; [|split; [now apply Fade|]].
  - eapply derivative_same; [| |exact (derivative_sum _ _ _ _ a b (Fade f f' F) (derivative_constant (w *: y)%V a b))].
    + intros t. unfold faded. vec_ring.
    + intros t _. vec_ring.
  - intros t T. destruct (M t T) as (M0 & M1 & M2). cbn [size speed acceleration].
    pose proof (norm_nonneg (f' t)). pose proof (norm_nonneg (f'' t)). split; [|split].
    + unfold faded. eapply Rle_trans; [apply norm_add|]. rewrite !norm_scale by lra.
      pose proof (Rmax_l (size m) n). pose proof (Rmax_r (size m) n). nra.
    + rewrite norm_scale by lra. apply Rmult_le_compat; lra.
    + rewrite norm_scale by lra. apply Rmult_le_compat; lra.
Qed.

Theorem fades_by_weight_holds : fades_by_weight.
Proof.
  intros E l H x y n g X Y G. pose proof (linear_moves_holds E l H x y 1 n ltac:(lra) X Y) as (f' & f'' & F & F' & M).
  assert (S : forall t, linear_channel x y 1 t = faded x y t).
  { intros t. unfold linear_channel, line, faded. now replace (t / 1) with t by field. }
  exists f', f''. split; [now apply (derivative_same _ _ f' f' 0 1 S)|]. split; [exact F'|]. intros t T. rewrite <- S.
  destruct (M t T) as (M0 & M1 & M2). cbn [size speed acceleration] in *. repeat split; lra.
Qed.

Theorem blend_of_units_holds : blend_of_units.
Proof.
  intros E l H p q c w P Q D C W. split.
  - apply sqrt_le_1_alt. replace (norm2 (q - p)) with (norm2 q - 2 * dot p q + norm2 p) by (dots; ring). lra.
  - apply sqrt_le_1_alt. unfold faded.
    replace (norm2 _) with ((1 - w) * (1 - w) * norm2 p + 2 * ((1 - w) * w) * dot p q + w * w * norm2 q) by (dots; ring).
    rewrite P, Q. assert (0 <= (1 - w) * w) by nra. assert ((1 - w) * w * c <= (1 - w) * w * dot p q) by (apply Rmult_le_compat_l; lra).
    pose proof (Rle_0_sqr (w - 1 / 2)) as S. unfold Rsqr in S. nra.
Qed.

Theorem slerp_fades_by_weight_holds : slerp_fades_by_weight.
Proof.
  intros E l H p q beta theta B T P Q D C. destruct (slerp_moves_holds E l H p q beta 1 ltac:(lra) B P Q D) as (M & _).
  assert (A : beta <= theta).
  { apply Rnot_lt_le. intros G. pose proof (cos_decreasing_1 theta beta ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) G). lra. }
  apply (moves_wider _ _ _ 0 1) with (2 := M). unfold is_wider. cbn [size speed acceleration]. unfold Rdiv. rewrite !Rmult_1_r, Rinv_1.
  split; [lra|]. split; [lra|]. rewrite Rmult_1_r. apply Rmult_le_compat; lra.
Qed.

Theorem nlerp_moves_holds : nlerp_moves.
Proof.
  intros p q c P Q D C. assert (G : norm (q - p) <= sqrt (2 - 2 * c)).
  { apply (blend_of_units_holds _ _ _ p q c 0); auto; lra. }
  apply (normalized_curve_moves_holds _ 1).
  - apply fades_by_weight_holds; [apply Req_le, norm_unit, P|apply Req_le, norm_unit, Q|exact G].
  - apply sqrt_lt_R0. lra.
  - intros w W. apply (blend_of_units_holds _ _ _ p q c w); auto; lra.
Qed.

Theorem nlerp_moves_by_time_holds : nlerp_moves_by_time.
Proof.
  intros p q s L A c w share a b M U Q C W S.
  apply (normalized_curve_moves_holds _ (Rmax s 1)); [|apply sqrt_lt_R0; lra|].
  - apply (fades_by_time_holds _ _ _ p q (Motion s L A) 1 w share a b M); auto. apply Req_le, norm_unit, Q.
  - intros t T. destruct (U t T) as [N D]. apply (blend_of_units_holds _ _ _ (p t) q c w); auto; lra.
Qed.

(* The hypotheses can be met: two quaternions at a right angle, and a clip that rests. *)
Example crossfade_instance : norm2 (Quat 1 0 0 0) = 1 /\ norm2 (Quat 0 1 0 0) = 1 /\ 0 <= dot (Quat 1 0 0 0) (Quat 0 1 0 0) /\
  moves (fun _ => Quat 1 0 0 0) (at_rest 1) 0 1.
Proof. repeat split; try (vunfold; lra). apply constant_moves, norm_le. vunfold. lra. Qed.
Example slerp_fade_instance : 0 < PI / 2 < PI /\ 0 <= PI / 2 <= PI /\ dot (Quat 1 0 0 0) (Quat 0 1 0 0) = cos (PI / 2) /\
  cos (PI / 2) <= dot (Quat 1 0 0 0) (Quat 0 1 0 0).
Proof. pose proof PI_RGT_0. rewrite cos_PI2. repeat split; try lra; vunfold; lra. Qed.
