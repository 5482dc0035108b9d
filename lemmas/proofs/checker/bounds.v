(* SPDX-License-Identifier: MIT *)
(* Over the reals: what is checked of the weight vertices of a piece holds all of their blends. *)
From Coq Require Import List Reals Lra Psatz Lia.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.b1_rational_bezier_simplex Refitlab.b2_control_hull_encloses Refitlab.b3_subdivision.
Require Import Refitlab.b4_cap_fallback Refitlab.b6_dual_quaternion_ball Refitlab.t3_one_cap.
Require Import Refitlab.checker.certificate.
Import ListNotations.

(* All blends of the weight vertices are good. *)
Definition all_blends {X} {l : Lin R X} (good : X -> Prop) (xs : list X) := forall z, in_hull xs z -> good z.

(* Where the blend (q, r) or (q, d) is not 0, it carries x into the ball [c, s]. *)
Definition spherical_good (x c : vec R) (s : R) (z : quat R * vec R) :=
  fst z <> lzero -> norm (rotate (fst z) x + snd z - c) <= s.
Definition dual_image (x : vec R) (z : quat R * quat R) : vec R :=
  (/ norm2 (fst z) *: (turned (fst z) x (fst z) + 2 *: im (qmul (snd z) (conj (fst z)))))%V.
Definition dual_good (x c : vec R) (s : R) (z : quat R * quat R) := fst z <> lzero -> norm (dual_image x z - c) <= s.
Arguments spherical_good x%V c%V s%R z.

(* --- A ball in a ball, squared twice --- *)

Definition ball_is_inside (f : vec R) (r2 : R) (c : vec R) (s : R) :=
  let rest := s * s - norm2 (c - f) - r2 in 0 <= s /\ 0 <= rest /\ 4 * norm2 (c - f) * r2 <= rest * rest.
Arguments ball_is_inside f%V r2%R c%V s%R.
Lemma ball_is_inside_norm f r2 c s : 0 <= r2 -> ball_is_inside f r2 c s -> norm (f - c) + sqrt r2 <= s.
Proof.
  intros N (S & A & B). rewrite norm_opposite. rewrite <- (norm_sq (c - f)%V) in A, B. pose proof (sqrt_sqrt r2 N) as Q.
  pose proof (sqrt_pos r2). pose proof (norm_nonneg (c - f)%V). rewrite <- Q in A, B. clear Q N.
  set (a := norm (c - f)) in *. set (b := sqrt r2) in *. clearbody a b.
  assert (2 * (a * b) <= s * s - a * a - b * b) by (apply sq_le_inv; nra). apply sq_le_inv; nra.
Qed.

(* Both balls times a positive number. *)
Lemma ball_is_inside_scaled m f r2 c s : 0 < m -> ball_is_inside (m *: f) (m * m * r2) (m *: c) (m * s) -> ball_is_inside f r2 c s.
Proof.
  unfold ball_is_inside. intros M (S & A & B). replace (m *: c - m *: f)%V with (m *: (c - f))%V in A, B by vec_ring.
  rewrite norm2_scale in A, B. set (apart := norm2 (c - f)) in *. set (rest := s * s - apart - r2) in *.
  replace (m * s * (m * s) - m * m * apart - m * m * r2) with (m * m * rest) in A, B by (unfold rest; ring).
  assert (M2 : 0 < m * m) by now apply Rmult_lt_0_compat. repeat split.
  - apply Rmult_le_reg_l with m; lra.
  - apply Rmult_le_reg_l with (m * m); lra.
  - apply Rmult_le_reg_l with (m * m * (m * m)); [now apply Rmult_lt_0_compat|]. lra.
Qed.

(* --- Control points (b1, b2) --- *)

(* The point N / W is in the ball [c, s]. *)
Definition point_inside (c : vec R) (s : R) (point : vec R * R) := norm (fst point - snd point *: c) <= s * snd point.
Lemma point_inside_cone c s : cone (point_inside c s).
Proof.
  unfold point_inside. split; [|intros [a v] [b w] A B|intros k [a v] K A]; cbn [fst snd lzero ladd lscale lin_pair lin_num zero add mul ops_R] in *.
  - replace (lzero - 0 *: c)%V with (lzero : vec R) by vec_ring. rewrite norm_zero. lra.
  - replace (a + b - (v + w)%R *: c)%V with ((a - v *: c) + (b - w *: c))%V by vec_ring.
    eapply Rle_trans; [apply norm_add|]. lra.
  - replace (k *: a - (k * v)%R *: c)%V with (k *: (a - v *: c))%V by vec_ring.
    rewrite norm_scale by auto. nra.
Qed.
(* From what is multiplied by the squared norm. *)
Lemma unscaled_inside (m : R) (v c : vec R) s : 0 < m -> point_inside c s (v, m) -> norm (/ m *: v - c) <= s.
Proof.
  unfold point_inside. cbn [fst snd]. intros M I. replace (/ m *: v - c)%V with (/ m *: (v - m *: c))%V by (vec_field; lra).
  rewrite norm_scale by (left; now apply inv_pos). apply Rmult_le_reg_l with (1 := M).
  rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by lra. lra.
Qed.

Lemma spherical_control_good x c s xs :
  Forall (point_inside c s) (spherical_points x xs) -> all_blends (spherical_good x c s) xs.
Proof.
  intros F z (u & U & ->) N. rewrite comb_pair in *. cbn [fst snd] in *.
  pose proof (spherical_in_cone_holds _ xs x u (point_inside_cone c s) U F) as H. cbv zeta in H.
  apply unscaled_inside in H; [|now apply norm2_pos]. unfold rotate. apply norm2_pos in N. revert H N.
  generalize (norm2 (comb u (map fst xs))). intros m H N.
  replace (/ m *: turned (comb u (map fst xs)) x (comb u (map fst xs)) + comb u (map snd xs) - c)%V with
    (/ m *: (turned (comb u (map fst xs)) x (comb u (map fst xs)) + m *: comb u (map snd xs)) - c)%V; [exact H|].
  generalize (turned (comb u (map fst xs)) x (comb u (map fst xs))) (comb u (map snd xs)). intros. vec_field. lra.
Qed.
Lemma dual_control_good x c s xs : Forall (point_inside c s) (dual_points x xs) -> all_blends (dual_good x c s) xs.
Proof.
  intros F z (u & U & ->) N. rewrite comb_pair in *. cbn [fst snd] in *.
  pose proof (dual_in_cone_holds _ xs x u (point_inside_cone c s) U F) as H. cbv zeta in H.
  apply unscaled_inside in H; [exact H|now apply norm2_pos].
Qed.

(* --- The cap, or all rotations (t3, lemma 5, b4) --- *)

Lemma fallback_good x c s a kappa2 xs : let h := height kappa2 in cap_is_valid (map fst xs) a kappa2 ->
  (forall p, In p xs -> norm (snd p + h *: rotate a x - c) + sqrt (1 - h * h) * norm x <= s) ->
  all_blends (spherical_good x c s) xs.
Proof.
  intros h V B z (u & U & ->) N. rewrite comb_pair in *. cbn [fst snd] in *.
  pose proof (cap_fallback_holds (in_ball (Ball c s)) xs a kappa2 x lzero 0 u (ball_convex _) V U N) as H. cbv zeta in H.
  fold h in H. replace (rotate (comb u (map fst xs)) x + comb u (map snd xs) + lzero)%V with
    (rotate (comb u (map fst xs)) x + comb u (map snd xs))%V in H by vec_ring.
  apply H; [rewrite norm_zero; lra|]. intros q r' I y. apply holds_ball_point. unfold holds_ball. cbn [center radius].
  specialize (B (q, r') I). cbn [snd] in B. lra.
Qed.
Lemma all_rotations_good x c s xs : (forall p, In p xs -> norm (snd p - c) + norm x <= s) ->
  all_blends (spherical_good x c s) xs.
Proof.
  intros B. apply (fallback_good x c s (Quat 1 0 0 0) 0); [left; lra|]. intros p I. specialize (B p I).
  assert (height 0 = 0) as -> by (unfold height; apply Rmax_right; lra).
  replace (snd p + 0 *: rotate (Quat 1 0 0 0) x - c)%V with (snd p - c)%V by vec_ring.
  replace (1 - 0 * 0) with 1 by ring. rewrite sqrt_1. lra.
Qed.
(* All balls times ||a||^2, so that nothing is divided by it. *)
Lemma cap_good x c s (a : quat R) kappa2 xs : a <> lzero -> 0 <= kappa2 <= 1 ->
  (forall p, In p xs -> in_cone a kappa2 (fst p)) ->
  let h := height kappa2 in let a2 := norm2 a in
  (forall p, In p xs ->
     ball_is_inside (a2 *: snd p + h *: turned a x a) ((1 - h * h) * norm2 x * (a2 * a2)) (a2 *: c) (a2 * s)) ->
  all_blends (spherical_good x c s) xs.
Proof.
  intros A K Q h a2 B. apply (fallback_good x c s a kappa2).
  - right. split; [exact A|]. split; [lra|]. apply Forall_map, Forall_forall. exact Q.
  - fold h. intros p I. specialize (B p I). apply norm2_pos in A. fold a2 in A.
    assert (H : 0 <= h <= 1) by (unfold h, height, Rmax; destruct (Rle_dec _ _); lra).
    assert (D : 0 <= (1 - h * h)) by nra. pose proof (norm2_nonneg x).
    apply ball_is_inside_norm in B; [|repeat apply Rmult_le_pos; auto; lra].
    rewrite !sqrt_mult_alt in B by (try apply Rmult_le_pos; auto). rewrite sqrt_square in B by lra.
    change (sqrt (norm2 x)) with (norm x) in B.
    replace (a2 *: snd p + h *: turned a x a - a2 *: c)%V with (a2 *: (snd p + h *: rotate a x - c))%V in B
      by (unfold rotate; fold a2; generalize (turned a x a); intros; vec_field; lra).
    rewrite norm_scale in B by lra. apply Rmult_le_reg_l with (1 := A). lra.
Qed.

(* --- MotionBound (b6), all balls times (q, a) --- *)

Lemma reach_good x c s (a : quat R) (f : vec R) xs :
  (forall p, In p xs -> let g := dot (fst p) a in
     0 < g /\ ball_is_inside (g *: f) (norm2 (reach_at x f p) * norm2 a) (g *: c) (g * s)) ->
  all_blends (dual_good x c s) xs.
Proof.
  intros B z (u & U & ->) N. set (r := s - norm (f - c)).
  destruct (dual_quaternion_ball_holds xs a x f r u) as [_ H]; [|exact U|].
  - intros p I. destruct (B p I) as [G D]. split; [exact G|]. pose proof (norm2_nonneg (reach_at x f p)). pose proof (norm2_nonneg a).
    apply ball_is_inside_norm in D; [|now apply Rmult_le_pos]. rewrite sqrt_mult_alt in D by auto.
    change (sqrt (norm2 (reach_at x f p))) with (norm (reach_at x f p)) in D. change (sqrt (norm2 a)) with (norm a) in D.
    set (g := dot (fst p) a) in *.
    replace (g *: f - g *: c)%V with (g *: (f - c))%V in D by vec_ring. rewrite norm_scale in D by lra.
    apply Rmult_le_reg_l with (1 := G).
    replace (g * (norm a * (norm (reach_at x f p) / g))) with (norm (reach_at x f p) * norm a) by (field; lra).
    unfold r. lra.
  - unfold in_ball in H. cbn [center radius] in H. rewrite comb_pair. unfold dual_image. cbn [fst snd].
    unfold skin_dual in H. cbv zeta in H. eapply Rle_trans; [apply (norm_triangle _ f)|]. unfold r in H. lra.
Qed.

(* --- Halves (b3) --- *)

Lemma set_nth_same {E} {l : Lin R E} i (xs : list E) : set_nth i (nth i xs lzero) xs = xs.
Proof. revert i; induction xs as [|x xs IH]; intros [|i]; cbn; auto. now rewrite IH. Qed.
Lemma halves_good {E} `{Euclid E} (good : E -> Prop) (xs : list E) i j : (i < length xs)%nat -> (j < length xs)%nat ->
  let m := (1 / 2 *: (nth i xs lzero + nth j xs lzero))%V in
  all_blends good (set_nth i m xs) -> all_blends good (set_nth j m xs) -> all_blends good xs.
Proof.
  intros I J m A B z Z. destruct (Nat.eq_dec i j) as [<-|N].
  - apply A. unfold m. replace (1 / 2 *: (nth i xs lzero + nth i xs lzero))%V with (nth i xs lzero) by vec_field.
    now rewrite set_nth_same.
  - apply (halves_cover_holds E _ _ xs i j z I J N) in Z as [Z|Z]; unfold half in Z; fold m in Z; auto.
    apply A. unfold m. replace (nth i xs lzero + nth j xs lzero)%V with (nth j xs lzero + nth i xs lzero)%V by vec_ring.
    exact Z.
Qed.

(* --- Rigid blends take a ball to a ball --- *)

Lemma spherical_ball p c s r rotation_center v z : spherical_good (p - rotation_center) c (s - r) z -> norm (v - p) <= r ->
  fst z <> lzero -> norm (rotate (fst z) (v - rotation_center) + snd z - c) <= s.
Proof.
  intros G V N. specialize (G N).
  replace (rotate (fst z) (v - rotation_center) + snd z - c)%V with
    (rotate (fst z) (v - p) + (rotate (fst z) (p - rotation_center) + snd z - c))%V by (rewrite !rotate_sub; vec_ring).
  eapply Rle_trans; [apply norm_add|]. rewrite rotate_norm by auto. lra.
Qed.
Lemma dual_ball p c s r v z : dual_good p c (s - r) z -> norm (v - p) <= r -> fst z <> lzero ->
  norm (dual_image v z - c) <= s.
Proof.
  intros G V N. specialize (G N).
  replace (dual_image v z - c)%V with (rotate (fst z) (v - p) + (dual_image p z - c))%V.
  - eapply Rle_trans; [apply norm_add|]. rewrite rotate_norm by auto. lra.
  - unfold dual_image, rotate. destruct z as [q d]. cbn [fst snd]. generalize (/ norm2 q). vring.
Qed.

(* --- Linear blending (s42) --- *)

Definition linear_growth (q : quat R) := norm2 q + Rmax (1 - norm2 q) (0 - (1 - norm2 q)).
Lemma linear_growth_nonneg q : 0 <= linear_growth q.
Proof. unfold linear_growth, Rmax. pose proof (norm2_nonneg q). destruct (Rle_dec _ _); lra. Qed.

Lemma joint_difference (q : quat R) (t p v : vec R) :
  norm (joint_image q t v - joint_image q t p) <= linear_growth q * norm (v - p).
Proof.
  replace (joint_image q t v - joint_image q t p)%V with (turned q (v - p) q + (1 - norm2 q) *: (v - p))%V
    by (unfold joint_image; vring).
  set (y := (v - p)%V). eapply Rle_trans; [apply norm_add|]. unfold linear_growth. rewrite Rmult_plus_distr_r.
  apply Rplus_le_compat; apply norm_le; (split; [apply Rmult_le_pos; [|apply norm_nonneg]|]).
  - apply norm2_nonneg.
  - rewrite turned_norm2, <- (norm_sq y). right. ring.
  - unfold Rmax. destruct (Rle_dec _ _); lra.
  - rewrite norm2_scale, <- (norm_sq y). set (e := 1 - norm2 q). set (l := norm y).
    assert (E : Rmax e (0 - e) * Rmax e (0 - e) = e * e) by (unfold Rmax; destruct (Rle_dec _ _); ring).
    replace (Rmax e (0 - e) * l * (Rmax e (0 - e) * l)) with (Rmax e (0 - e) * Rmax e (0 - e) * (l * l)) by ring.
    rewrite E. right. ring.
Qed.
Lemma images_difference (qs : list (quat R)) (ts : list (vec R)) w p v : Forall (Rle 0) w -> length ts = length qs ->
  norm (comb w (joint_images qs ts v) - comb w (joint_images qs ts p)) <=
  norm (v - p) * comb w (map linear_growth qs).
Proof.
  intros W. unfold joint_images. revert qs ts. induction W as [|a w A W IH]; intros [|q qs] [|t ts] L; try discriminate;
    cbn [combine map comb fst snd]; try (replace (lzero - lzero)%V with (lzero : vec R) by vec_ring; rewrite norm_zero; cbn; lra).
  specialize (IH qs ts ltac:(auto)). pose proof (joint_difference q t p v) as D.
  match goal with |- norm (a *: ?x + ?y - (a *: ?z + ?k)) <= _ =>
    replace (a *: x + y - (a *: z + k))%V with (a *: (x - z) + (y - k))%V by vec_ring end.
  eapply Rle_trans; [apply norm_add|]. rewrite norm_scale by auto. cbn [ladd lscale lin_num add mul ops_R]. nra.
Qed.
