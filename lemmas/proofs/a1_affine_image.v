(* SPDX-License-Identifier: MIT *)
(* Joints that scale and shear: what an affine map makes of a ball, a box, and a hull with a radius, and what linear blending of
   affine joints does. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex.
Import ListNotations.

(* --- Maps x -> A x + b, for numbers of any type --- *)

(* The columns of A. *)
Definition matrix T : Type := vec T * vec T * vec T.

Section Maps.
Context {T : Type} {o : Ops T}.
Definition turned_by (m : matrix T) (x : vec T) : vec T :=
  ladd (ladd (lscale (vx x) (fst (fst m))) (lscale (vy x) (snd (fst m)))) (lscale (vz x) (snd m)).
Definition affine_images (ms : list (matrix T)) (bs : list (vec T)) (x : vec T) : list (vec T) :=
  map (fun joint => ladd (turned_by (fst joint) x) (snd joint)) (combine ms bs).
End Maps.
Arguments turned_by {T o} m x%V.

(* --- Statements --- *)

(* s^2, the greatest sum of absolute values in a row of A^T A, and the numbers that are no less than s. *)
Definition row_sum (a : vec R) (m : matrix R) : R :=
  Rabs (dot a (fst (fst m))) + Rabs (dot a (snd (fst m))) + Rabs (dot a (snd m)).
Definition squared_stretch (m : matrix R) : R :=
  Rmax (row_sum (fst (fst m)) m) (Rmax (row_sum (snd (fst m)) m) (row_sum (snd m) m)).
Definition stretches (m : matrix R) (s : R) := 0 <= s /\ squared_stretch m <= s * s.

(* (i) *)
Definition ball_is_carried : Prop := forall m b c r v s, stretches m s -> in_ball (Ball c r) v ->
  in_ball (Ball (turned_by m c + b) (s * r))%V (turned_by m v + b)%V.
(* (ii): |A| e bounds A d coordinate by coordinate, and a slab of images is one of points. *)
Definition within (d e : vec R) := Rabs (vx d) <= vx e /\ Rabs (vy d) <= vy e /\ Rabs (vz d) <= vz e.
Definition box_is_carried : Prop := forall m d e, within d e ->
  let row f := Rabs (f (fst (fst m))) * vx e + Rabs (f (snd (fst m))) * vy e + Rabs (f (snd m)) * vz e in
  within (turned_by m d) (Vec (row vx) (row vy) (row vz)).
Definition slab_before : Prop := forall (m : matrix R) b n x,
  dot n (turned_by m x + b)%V = dot (Vec (dot n (fst (fst m))) (dot n (snd (fst m))) (dot n (snd m))) x + dot n b.
(* (iii) *)
Definition hull_is_carried : Prop := forall m b points w beside r s, stretches m s -> convex (length points) w ->
  norm (beside : vec R) <= r ->
  norm (turned_by m (comb w points + beside) + b - comb w (map (fun p => turned_by m p + b) points))%V <= s * r.
(* (v) at one weight vertex: by what the blend stretches, or by what the joints do. *)
Definition blend_is_in_control_ball : Prop := forall ms bs ss w c r v s, Forall2 stretches ms ss -> length bs = length ms ->
  Forall (Rle 0) w -> stretches (comb w ms) s \/ comb w ss <= s -> in_ball (Ball c r) v ->
  in_ball (Ball (comb w (affine_images ms bs c)) (s * r)) (comb w (affine_images ms bs v)).

(* The radius of a rigid joint. *)
Definition ball_is_carried_rigidly : Prop := forall m b c r v, in_ball (Ball c r) v ->
  in_ball (Ball (turned_by m c + b) r)%V (turned_by m v + b)%V.

(* --- Proofs --- *)

Lemma turned_by_sub m (x y : vec R) : (turned_by m x - turned_by m y)%V = turned_by m (x - y).
Proof. unfold turned_by. vring. Qed.
Lemma turned_by_linear (x : vec R) : linear (fun m : matrix R => turned_by m x).
Proof. unfold turned_by. repeat split; vring. Qed.

Lemma twice_product t x y : 2 * (x * y) * t <= Rabs t * (x * x + y * y).
Proof. unfold Rabs. destruct (Rcase_abs t); [pose proof (Rle_0_sqr (x + y))|pose proof (Rle_0_sqr (x - y))]; unfold Rsqr in *; nra. Qed.

Lemma turned_by_norm2 m (d : vec R) : norm2 (turned_by m d) <= squared_stretch m * norm2 d.
Proof.
  destruct m as [[a b] c]. unfold squared_stretch. cbn [fst snd]. set (g := Rmax _ _).
  assert (A : row_sum a (a, b, c) <= g) by apply Rmax_l.
  assert (B : row_sum b (a, b, c) <= g) by (eapply Rle_trans; [apply Rmax_l|apply Rmax_r]).
  assert (C : row_sum c (a, b, c) <= g) by (eapply Rle_trans; [apply Rmax_r|apply Rmax_r]).
  unfold row_sum in A, B, C. cbn [fst snd] in A, B, C. rewrite (dot_comm b a) in B. rewrite (dot_comm c a), (dot_comm c b) in C.
  destruct d as [x y z]. unfold turned_by. cbn [fst snd vx vy vz].
  replace (norm2 (x *: a + y *: b + z *: c)%V) with (x * x * dot a a + y * y * dot b b + z * z * dot c c +
    (2 * (x * y) * dot a b + 2 * (x * z) * dot a c + 2 * (y * z) * dot b c)) by (dots; ring).
  replace (norm2 (Vec x y z)) with (x * x + y * y + z * z) by (vunfold; ring).
  pose proof (twice_product (dot a b) x y). pose proof (twice_product (dot a c) x z). pose proof (twice_product (dot b c) y z).
  pose proof (Rle_abs (dot a a)). pose proof (Rle_abs (dot b b)). pose proof (Rle_abs (dot c c)).
  pose proof (Rle_0_sqr x) as X. pose proof (Rle_0_sqr y) as Y. pose proof (Rle_0_sqr z) as Z. unfold Rsqr in X, Y, Z.
  apply (Rmult_le_compat_l _ _ _ X) in A. apply (Rmult_le_compat_l _ _ _ Y) in B. apply (Rmult_le_compat_l _ _ _ Z) in C. nra.
Qed.
Lemma turned_by_norm m s (d : vec R) : stretches m s -> norm (turned_by m d) <= s * norm d.
Proof.
  intros [P S]. apply norm_le. pose proof (norm_nonneg d). split; [nra|]. eapply Rle_trans; [apply turned_by_norm2|].
  rewrite <- norm_sq. pose proof (Rle_0_sqr (norm d)) as Q. unfold Rsqr in Q. nra.
Qed.

Theorem ball_is_carried_holds : ball_is_carried.
Proof.
  intros m b c r v s S V. unfold in_ball in *. cbn [center radius] in *.
  replace (turned_by m v + b - (turned_by m c + b))%V with (turned_by m v - turned_by m c)%V by vec_ring.
  rewrite turned_by_sub. eapply Rle_trans; [apply turned_by_norm, S|]. destruct S. nra.
Qed.
Theorem box_is_carried_holds : box_is_carried.
Proof.
  intros [[a b] c] [x y z] [f g h] (X & Y & Z) row. unfold turned_by, within. subst row. cbn [fst snd vx vy vz] in *.
  assert (P : forall p q r, Rabs (x * p + y * q + z * r) <= Rabs p * f + Rabs q * g + Rabs r * h).
  { intros p q r. eapply Rle_trans; [apply Rabs_triang|]. eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang|].
    rewrite !Rabs_mult. pose proof (Rabs_pos p). pose proof (Rabs_pos q). pose proof (Rabs_pos r). nra. }
  repeat split; apply P.
Qed.
Theorem slab_before_holds : slab_before.
Proof. intros [[a b] c] t n x. unfold turned_by. vring. Qed.
Theorem hull_is_carried_holds : hull_is_carried.
Proof.
  intros m b points w beside r s S W B.
  assert (L : comb w (map (turned_by m) points) = turned_by m (comb w points)).
  { symmetry. apply comb_linear. unfold turned_by. repeat split; vring. }
  rewrite <- (map_map (turned_by m) (fun p => p + b)%V), comb_shift_convex, L by now rewrite map_length.
  replace (turned_by m (comb w points + beside) + b - (turned_by m (comb w points) + b))%V with
    (turned_by m (comb w points + beside) - turned_by m (comb w points))%V by vec_ring.
  rewrite turned_by_sub. replace (comb w points + beside - comb w points)%V with beside by vec_ring.
  eapply Rle_trans; [apply turned_by_norm, S|]. destruct S. nra.
Qed.

Lemma images_apart (ms : list (matrix R)) bs w (v c : vec R) : length bs = length ms ->
  (comb w (affine_images ms bs v) - comb w (affine_images ms bs c))%V = comb w (map (fun m => turned_by m (v - c)%V) ms).
Proof.
  unfold affine_images. revert bs w; induction ms as [|m ms IH]; intros [|b bs] [|u w] L; try discriminate; cbn [combine map comb fst snd];
    try (vec_ring; fail). specialize (IH bs w ltac:(auto)). rewrite <- IH, <- turned_by_sub. vec_ring.
Qed.
Lemma blend_by_joints ms ss w (d : vec R) : Forall2 stretches ms ss -> Forall (Rle 0) w ->
  0 <= comb w ss /\ norm (comb w (map (fun m => turned_by m d) ms)) <= comb w ss * norm d.
Proof.
  intros S W. revert w W; induction S as [|m s ms ss S _ IH]; intros w W; (destruct w as [|u w]); cbn [map comb];
    try (rewrite norm_zero; cbn; lra). apply Forall_cons_iff in W as [U W]. specialize (IH w W) as [N IH].
  pose proof (turned_by_norm m s d S). destruct S as [P _]. cbn [ladd lscale lin_num add mul ops_R]. split; [nra|].
  eapply Rle_trans; [apply norm_add|]. rewrite norm_scale by exact U. nra.
Qed.
Theorem blend_is_in_control_ball_holds : blend_is_in_control_ball.
Proof.
  intros ms bs ss w c r v s S L W By V. unfold in_ball in *. cbn [center radius] in *. rewrite images_apart by exact L.
  pose proof (norm_nonneg (v - c)%V). destruct By as [By|By].
  - rewrite <- (comb_linear (fun m : matrix R => turned_by m (v - c)%V) w ms (turned_by_linear _)).
    eapply Rle_trans; [apply turned_by_norm, By|]. destruct By. nra.
  - destruct (blend_by_joints ms ss w (v - c)%V S W). nra.
Qed.

(* A scale by 2. *)
Theorem ball_is_carried_rigidly_is_false : ~ ball_is_carried_rigidly.
Proof.
  intros H. assert (N : forall x : R, 0 <= x -> norm (Vec x 0 0) = x) by (intros x X; apply norm_eq; [exact X|vunfold; ring]).
  specialize (H (Vec 2 0 0, Vec 0 2 0, Vec 0 0 2) lzero lzero 1 (Vec 1 0 0)). unfold in_ball in H. cbn [center radius] in H.
  replace (Vec 1 0 0 - lzero)%V with (Vec 1 0 0) in H by vring. rewrite N in H by lra.
  replace (_ - _)%V with (Vec 2 0 0) in H by (unfold turned_by; vring). rewrite N in H by lra. lra.
Qed.

(* The hypotheses can be met: joints that scale by 2 along the first axis, and not at all. *)
Example affine_instance : let wide := (Vec 2 0 0, Vec 0 1 0, Vec 0 0 1) in let same := (Vec 1 0 0, Vec 0 1 0, Vec 0 0 1) in
  Forall2 stretches [wide; same] [2; 1] /\ length [lzero; lzero : vec R] = length [wide; same] /\ Forall (Rle 0) [1 / 2; 1 / 2] /\
  comb [1 / 2; 1 / 2] [2; 1] <= 3 / 2 /\ in_ball (Ball lzero 1) (Vec 0 1 0).
Proof.
  cbv zeta. split; [|split; [reflexivity|split; [repeat constructor; lra|split; [cbn; lra|]]]].
  - repeat apply Forall2_cons; try apply Forall2_nil; (split; [lra|]); unfold squared_stretch, row_sum; cbn [fst snd];
      vunfold; repeat apply Rmax_lub; rewrite !Rabs_pos_eq by lra; lra.
  - unfold in_ball. cbn [center radius]. apply norm_le. split; [lra|]. vunfold. lra.
Qed.
