(* SPDX-License-Identifier: MIT *)
(* How fast a channel of a clip goes between two keys, and how much it bends, in any real inner product space. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.curve Refitlab.c1_chord_bound.
Import ListNotations.

(* The channels, at the time t after the first key, for keys that are T apart. *)
Definition line {E} `{Euclid E} (f g : R -> E) (T t : R) := ((1 - t / T) *: f t + (t / T) *: g t)%V.
Definition linear_channel {E} `{Euclid E} (a b : E) (T t : R) := line (fun _ => a) (fun _ => b) T t.
(* By de Casteljau's algorithm. *)
Definition quadratic {E} `{Euclid E} (p q r : E) (T t : R) := line (linear_channel p q T) (linear_channel q r T) T t.
Definition cubic_channel {E} `{Euclid E} (p q r s : E) (T t : R) := line (quadratic p q r T) (quadratic q r s T) T t.
(* A spline by its keys and its tangents, which are per unit of time: out of the first key, and into the second. *)
Definition spline {E} `{Euclid E} (a out into b : E) (T t : R) := let s := t / T in
  ((2 * s * s * s - 3 * s * s + 1) *: a + (T * (s * s * s - 2 * s * s + s)) *: out +
   (3 * s * s - 2 * s * s * s) *: b + (T * (s * s * s - s * s)) *: into)%V.
(* From a to b, whose angle is theta. *)
Definition slerp {E} `{Euclid E} (a b : E) (theta T t : R) :=
  ((sin (theta - t / T * theta) / sin theta) *: a + (sin (t / T * theta) / sin theta) *: b)%V.
(* The tangent of half an angle, from that of the angle; and a bound of the angle, from the tangent of its half. *)
Definition half_tangent (t : R) := t / (1 + sqrt (1 + t * t)).
Definition angle_by_half_tangent (t : R) := 16 * half_tangent (half_tangent (half_tangent t)).

(* --- Statements --- *)

(* n is no less than the lengths of both ends. (Of scales these are about each factor, and scale_by_axes of c4_chain_motion puts them
   together.) *)
Definition linear_moves : Prop := forall E (l : Lin R E) (H : Euclid E) (a b : E) (T n : R), 0 < T -> norm a <= n -> norm b <= n ->
  moves (linear_channel a b T) (Motion n (norm (b - a) / T) 0) 0 T.
(* 3 / T (q - p) and so on are the points of the velocity, and 6 / T^2 (p - 2 q + r) those of the acceleration. *)
Definition cubic_moves : Prop := forall E (l : Lin R E) (H : Euclid E) (p q r s : E) (T n v a : R), 0 < T ->
  Forall (fun x => norm x <= n) [p; q; r; s] ->
  Forall (fun x => norm ((3 / T) *: x) <= v) [q - p; r - q; s - r]%V ->
  Forall (fun x => norm ((6 / (T * T)) *: x) <= a) [p - 2 *: q + r; q - 2 *: r + s]%V ->
  moves (cubic_channel p q r s T) (Motion n v a) 0 T.
Definition spline_is_cubic : Prop := forall E (l : Lin R E) (H : Euclid E) (a out into b : E) (T t : R), T <> 0 ->
  spline a out into b T t = cubic_channel a (a + (T / 3) *: out)%V (b - (T / 3) *: into)%V b T t.
(* A slerp is on a circle of radius 1, at a constant speed, from a to b. *)
Definition slerp_moves : Prop := forall E (l : Lin R E) (H : Euclid E) (a b : E) (theta T : R), 0 < T -> 0 < theta < PI ->
  norm2 a = 1 -> norm2 b = 1 -> dot a b = cos theta ->
  moves (slerp a b theta T) (Motion 1 (theta / T) (theta * theta / (T * T))) 0 T /\
  (forall t, norm2 (slerp a b theta T t) = 1) /\ slerp a b theta T 0 = a /\ slerp a b theta T T = b.
Definition angle_is_bounded : Prop := forall E (l : Lin R E) (H : Euclid E) (a b : E) (theta : R), 0 <= theta < PI ->
  norm2 a = 1 -> norm2 b = 1 -> dot a b = cos theta ->
  norm (b - a) / norm (b + a) = tan (theta / 2) /\ theta <= angle_by_half_tangent (norm (b - a) / norm (b + a)).
(* The shorter way goes to b or -b, and by at most a right angle, where the bound is little too great. *)
Definition shorter_way : Prop := forall E (l : Lin R E) (H : Euclid E) (a b : E), norm2 a = 1 -> norm2 b = 1 ->
  (0 <= dot a b \/ 0 <= dot a (lscale (-1) b)) /\ forall theta, 0 <= theta < PI -> dot a b = cos theta -> 0 <= dot a b ->
  theta <= PI / 2 /\ angle_by_half_tangent (norm (b - a) / norm (b + a)) <= 101 / 100 * theta.

(* --- Proofs: linear and cubic channels --- *)

Section Lines.
Context {E : Type} `{Euclid E}.
Implicit Types (f g : R -> E) (T : R).

Lemma share_derivative T a b : derivative (fun t => t / T) (fun _ => 1 / T) a b.
Proof.
  intros e t _. cbn. replace (1 / T * e) with ((/ T * e) * 1) by (unfold Rdiv; ring).
  apply (derivable_same (fun t => (/ T * e) * t)); [intros; unfold Rdiv; ring|]. apply derivable_pt_lim_scal, derivable_pt_lim_id.
Qed.
Lemma rest_derivative T a b : derivative (fun t => 1 - t / T) (fun _ => - (1 / T)) a b.
Proof.
  intros e t _. cbn. replace (- (1 / T) * e) with ((- / T * e) * 1 + 0) by (unfold Rdiv; ring).
  apply (derivable_same (fun t => (- / T * e) * t + e)); [intros; unfold Rdiv; ring|].
  apply (derivable_pt_lim_plus (fun t => (- / T * e) * t) (fun _ => e)); [|apply derivable_pt_lim_const].
  apply derivable_pt_lim_scal, derivable_pt_lim_id.
Qed.
Lemma line_derivative f f' g g' T a b : derivative f f' a b -> derivative g g' a b ->
  derivative (line f g T) (fun t => (1 / T) *: (g t - f t) + line f' g' T t)%V a b.
Proof.
  intros F G. pose proof (derivative_product (fun (s : R) (x : E) => (s *: x)%V) _ _ f f' a b scaling_is_product (rest_derivative T a b) F) as P.
  pose proof (derivative_product (fun (s : R) (x : E) => (s *: x)%V) _ _ g g' a b scaling_is_product (share_derivative T a b) G) as Q.
  eapply derivative_same; [| |exact (derivative_sum _ _ _ _ a b P Q)]; intros; unfold line; [reflexivity|vec_ring].
Qed.
(* On a line between two points no longer than n. *)
Lemma line_norm f g T t n : 0 <= t <= T -> 0 < T -> norm (f t) <= n -> norm (g t) <= n -> norm (line f g T t) <= n.
Proof.
  intros I P F G. assert (0 <= t / T) by (apply Rmult_le_pos; [lra|left; now apply inv_pos]).
  assert (t / T <= 1) by (apply Rmult_le_reg_r with T; [exact P|]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra).
  unfold line. eapply Rle_trans; [apply norm_add|]. rewrite !norm_scale by lra. nra.
Qed.
Lemma linear_derivative (p q : E) T a b : derivative (linear_channel p q T) (fun _ => (1 / T) *: (q - p))%V a b.
Proof.
  eapply derivative_same; [reflexivity| |exact (line_derivative _ _ _ _ T a b (derivative_constant p a b) (derivative_constant q a b))].
  intros t _. unfold line, Rdiv. cbv beta. vec_ring.
Qed.
Lemma quadratic_derivative (p q r : E) T a b :
  derivative (quadratic p q r T) (linear_channel ((2 / T) *: (q - p)) ((2 / T) *: (r - q)) T)%V a b.
Proof.
  eapply derivative_same; [reflexivity| |exact (line_derivative _ _ _ _ T a b (linear_derivative p q T a b) (linear_derivative q r T a b))].
  intros t _. unfold linear_channel, line, Rdiv. cbv beta. vec_ring.
Qed.
Lemma cubic_derivative (p q r s : E) T a b :
  derivative (cubic_channel p q r s T) (quadratic ((3 / T) *: (q - p)) ((3 / T) *: (r - q)) ((3 / T) *: (s - r)) T)%V a b.
Proof.
  eapply derivative_same; [reflexivity| |exact (line_derivative _ _ _ _ T a b (quadratic_derivative p q r T a b) (quadratic_derivative q r s T a b))].
  intros t _. unfold quadratic, linear_channel, line, Rdiv. cbv beta. vec_ring.
Qed.
End Lines.

Theorem linear_moves_holds : linear_moves.
Proof.
  intros E l H a b T n P A B. exists (fun _ => (1 / T) *: (b - a))%V, (fun _ => lzero). split; [apply linear_derivative|].
  split; [apply derivative_constant|]. intros t I. cbn [size speed acceleration]. split; [now apply line_norm|]. split; [|rewrite norm_zero; lra].
  rewrite norm_scale by (left; apply Rdiv_lt_0_compat; lra). unfold Rdiv. lra.
Qed.

Theorem cubic_moves_holds : cubic_moves.
Proof.
  intros E l H p q r s T n v a P N V A. repeat match goal with F : Forall _ (_ :: _) |- _ => apply Forall_cons_iff in F as [? F] end.
  exists (quadratic ((3 / T) *: (q - p)) ((3 / T) *: (r - q)) ((3 / T) *: (s - r)) T)%V,
    (linear_channel ((6 / (T * T)) *: (p - 2 *: q + r)) ((6 / (T * T)) *: (q - 2 *: r + s)) T)%V.
  split; [apply cubic_derivative|]. split.
  - eapply derivative_same; [reflexivity| |apply quadratic_derivative]. intros t _. unfold linear_channel, line. vec_field. lra.
  - intros t I. cbn [size speed acceleration]. unfold cubic_channel, quadratic, linear_channel. split; [|split]; repeat apply line_norm; assumption.
Qed.

Theorem spline_is_cubic_holds : spline_is_cubic.
Proof.
  intros E l H a out into b T t P. unfold spline, cubic_channel, quadratic, linear_channel, line. cbv zeta beta. vec_field. exact P.
Qed.

(* --- Proofs: slerps --- *)

Section Circles.
Context {E : Type} `{Euclid E}.

(* A circle about the origin, at the speed k. *)
Definition circle (x y : E) (k t : R) := (cos (k * t) *: x + sin (k * t) *: y)%V.
Lemma cosine_derivative k a b : derivative (fun t => cos (k * t)) (fun t => - (k * sin (k * t))) a b.
Proof.
  intros e t _. cbn. replace (- (k * sin (k * t)) * e) with (e * (- sin (k * t) * (k * 1))) by ring.
  apply (derivable_same (fun t => e * cos (k * t))); [intros; ring|]. apply (derivable_pt_lim_scal (fun t => cos (k * t))).
  apply (derivable_pt_lim_comp (fun t => k * t) cos t); [|apply derivable_pt_lim_cos]. apply derivable_pt_lim_scal, derivable_pt_lim_id.
Qed.
Lemma sine_derivative k a b : derivative (fun t => sin (k * t)) (fun t => k * cos (k * t)) a b.
Proof.
  intros e t _. cbn. replace (k * cos (k * t) * e) with (e * (cos (k * t) * (k * 1))) by ring.
  apply (derivable_same (fun t => e * sin (k * t))); [intros; ring|]. apply (derivable_pt_lim_scal (fun t => sin (k * t))).
  apply (derivable_pt_lim_comp (fun t => k * t) sin t); [|apply derivable_pt_lim_sin]. apply derivable_pt_lim_scal, derivable_pt_lim_id.
Qed.
Lemma circle_derivative (x y : E) k a b : derivative (circle x y k) (fun t => k *: circle y (-1 *: x) k t)%V a b.
Proof.
  pose proof (derivative_product (fun (s : R) (x : E) => (s *: x)%V) _ _ _ _ a b scaling_is_product (cosine_derivative k a b) (derivative_constant x a b)) as P.
  pose proof (derivative_product (fun (s : R) (x : E) => (s *: x)%V) _ _ _ _ a b scaling_is_product (sine_derivative k a b) (derivative_constant y a b)) as Q.
  eapply derivative_same; [| |exact (derivative_sum _ _ _ _ a b P Q)]; intros; unfold circle; [reflexivity|vec_ring].
Qed.
Lemma circle_norm2 (x y : E) k t : norm2 x = 1 -> norm2 y = 1 -> dot x y = 0 -> norm2 (circle x y k t) = 1.
Proof.
  intros X Y D. unfold circle. replace (norm2 _) with (cos (k * t) * cos (k * t) * norm2 x + 2 * (cos (k * t) * sin (k * t)) * dot x y +
    sin (k * t) * sin (k * t) * norm2 y) by (dots; ring).
  rewrite X, Y, D. pose proof (sin2_cos2 (k * t)) as S. unfold Rsqr in S. lra.
Qed.
Lemma circle_moves (x y : E) k a b : 0 <= k -> norm2 x = 1 -> norm2 y = 1 -> dot x y = 0 -> moves (circle x y k) (Motion 1 k (k * k)) a b.
Proof.
  intros K X Y D. assert (X' : norm2 (-1 *: x) = 1) by (rewrite norm2_scale; lra).
  exists (fun t => k *: circle y (-1 *: x) k t)%V, (fun t => k *: (k *: circle (-1 *: x) (-1 *: y) k t))%V.
  split; [apply circle_derivative|]. split.
  - apply (derivative_map (fun x : E => (k *: x)%V)); [apply scaling_has_adjoint|apply circle_derivative].
  - intros t _. cbn [size speed acceleration].
    assert (Y' : norm2 (-1 *: y) = 1) by (rewrite norm2_scale; lra).
    assert (D1 : dot y (-1 *: x) = 0) by (rewrite dot_scale_r, dot_comm; lra).
    assert (D2 : dot (-1 *: x) (-1 *: y) = 0) by (rewrite dot_scale_l, dot_scale_r; lra).
    repeat split; rewrite ?norm_scale by exact K; (rewrite norm_unit by (now apply circle_norm2)); lra.
Qed.
End Circles.

Theorem slerp_moves_holds : slerp_moves.
Proof.
  intros E l H a b theta T P A Na Nb D. assert (S : 0 < sin theta) by (apply sin_gt_0; lra).
  pose (e := (/ sin theta *: (b - cos theta *: a))%V).
  pose proof (sin2_cos2 theta) as Q. unfold Rsqr in Q.
  assert (Ne : norm2 e = 1).
  { unfold e. rewrite norm2_scale. replace (norm2 (b - cos theta *: a)) with (norm2 b - 2 * cos theta * dot a b + cos theta * cos theta * norm2 a) by (dots; ring).
    rewrite Na, Nb, D. replace (1 - _ + _) with (sin theta * sin theta) by lra. field. lra. }
  assert (De : dot a e = 0) by (unfold e; rewrite dot_scale_r, dot_sub_r, dot_scale_r, D; unfold norm2 in Na; rewrite Na; ring).
  assert (C : forall t, circle a e (theta / T) t = slerp a b theta T t).
  { intros t. unfold circle, slerp, e. replace (t / T * theta) with (theta / T * t) by (unfold Rdiv; ring). rewrite sin_minus.
    generalize (sin (theta / T * t)) (cos (theta / T * t)). intros s c. vec_field. lra. }
  split; [|split; [|split]].
  - destruct (circle_moves a e (theta / T) 0 T) as (f' & f'' & F & F' & M); auto; [left; apply Rdiv_lt_0_compat; lra|].
    exists f', f''. split; [apply (derivative_same _ _ f' f' 0 T C); [reflexivity|exact F]|]. split; [exact F'|]. intros t I. rewrite <- C.
    replace (theta * theta / (T * T)) with (theta / T * (theta / T)) by (field; lra). now apply M.
  - intros t. rewrite <- C. now apply circle_norm2.
  - rewrite <- C. unfold circle. rewrite Rmult_0_r, cos_0, sin_0. vec_ring.
  - unfold slerp. replace (T / T * theta) with theta by (field; lra). replace (theta - theta) with 0 by ring. rewrite sin_0. vec_field. lra.
Qed.

(* --- Proofs: the angle --- *)

Lemma angle_below_tangent x : 0 <= x < PI / 2 -> x <= tan x.
Proof.
  intros X. assert (C : 0 < cos x) by (apply cos_gt_0; lra). unfold tan. apply Rmult_le_reg_r with (cos x); [exact C|].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  pose proof (not_falling (fun x => sin x - x * cos x) (fun x => x * sin x) 0 x ltac:(lra)) as N. cbv beta in N.
  rewrite sin_0, Rmult_0_l in N. cut (0 - 0 <= sin x - x * cos x); [lra|]. apply N.
  - intros y _. replace (y * sin y) with (cos y - (1 * cos y + y * - sin y)) by ring.
    apply (derivable_pt_lim_minus sin (fun y => y * cos y)); [apply derivable_pt_lim_sin|].
    apply (derivable_pt_lim_mult id cos); [apply derivable_pt_lim_id|apply derivable_pt_lim_cos].
  - intros y Y. apply Rmult_le_pos; [lra|]. apply sin_ge_0; lra.
Qed.
Lemma half_tangent_is x : 0 <= x < PI / 2 -> half_tangent (tan x) = tan (x / 2).
Proof.
  intros X. assert (C : 0 < cos x) by (apply cos_gt_0; lra). assert (Ch : 0 < cos (x / 2)) by (apply cos_gt_0; lra).
  assert (R : sqrt (1 + tan x * tan x) = / cos x).
  { apply sqrt_lem_1; [pose proof (Rle_0_sqr (tan x)) as S; unfold Rsqr in S; lra|left; now apply inv_pos|].
    unfold tan. pose proof (sin2_cos2 x) as Q. unfold Rsqr in Q. apply Rmult_eq_reg_r with (cos x * cos x); [|nra].
    replace ((1 + sin x / cos x * (sin x / cos x)) * (cos x * cos x)) with (sin x * sin x + cos x * cos x) by (field; lra).
    rewrite Q. field. lra. }
  unfold half_tangent. rewrite R. unfold tan.
  assert (Sx : sin x = 2 * sin (x / 2) * cos (x / 2)) by (rewrite <- sin_2a; f_equal; field).
  assert (Cx : cos x = 2 * cos (x / 2) * cos (x / 2) - 1) by (rewrite <- cos_2a_cos; f_equal; field).
  replace (sin x / cos x / (1 + / cos x)) with (sin x / (cos x + 1)) by (field; lra).
  rewrite Sx, Cx. field. split; nra.
Qed.

Theorem angle_is_bounded_holds : angle_is_bounded.
Proof.
  intros E l H a b theta A Na Nb D. pose proof (PI_RGT_0) as Pi.
  assert (C : 0 < cos (theta / 2)) by (apply cos_gt_0; lra). assert (S : 0 <= sin (theta / 2)) by (apply sin_ge_0; lra).
  assert (Cx : cos theta = 2 * cos (theta / 2) * cos (theta / 2) - 1) by (rewrite <- cos_2a_cos; f_equal; field).
  pose proof (sin2_cos2 (theta / 2)) as Q. unfold Rsqr in Q.
  assert (M : norm (b - a) = 2 * sin (theta / 2)).
  { apply norm_eq; [lra|]. replace (norm2 (b - a)) with (norm2 b - 2 * dot a b + norm2 a) by (dots; ring). rewrite Na, Nb, D, Cx. nra. }
  assert (P : norm (b + a) = 2 * cos (theta / 2)).
  { apply norm_eq; [lra|]. replace (norm2 (b + a)) with (norm2 b + 2 * dot a b + norm2 a) by (dots; ring). rewrite Na, Nb, D, Cx. nra. }
  assert (T : norm (b - a) / norm (b + a) = tan (theta / 2)) by (rewrite M, P; unfold tan; field; lra).
  split; [exact T|]. rewrite T. unfold angle_by_half_tangent. rewrite !half_tangent_is by lra.
  pose proof (angle_below_tangent (theta / 2 / 2 / 2 / 2) ltac:(lra)). lra.
Qed.

Lemma tangent_of_little x : 0 <= x <= 1 / 8 -> tan x <= 101 / 100 * x.
Proof.
  intros X. assert (S : forall y, 0 <= y -> - y <= sin y <= y).
  { intros y Y. pose proof (not_falling (fun y => y - sin y) (fun y => 1 - cos y) 0 y Y) as N.
    pose proof (not_falling (fun y => y + sin y) (fun y => 1 + cos y) 0 y Y) as M. cbv beta in N, M. rewrite sin_0 in N, M.
    assert (0 - 0 <= y - sin y).
    { apply N; intros z _; [|pose proof (COS_bound z); lra].
      apply (derivable_pt_lim_minus id sin); [apply derivable_pt_lim_id|apply derivable_pt_lim_sin]. }
    assert (0 + 0 <= y + sin y).
    { apply M; intros z _; [|pose proof (COS_bound z); lra].
      apply (derivable_pt_lim_plus id sin); [apply derivable_pt_lim_id|apply derivable_pt_lim_sin]. }
    lra. }
  assert (C : 1 - x * x / 2 <= cos x).
  { replace (cos x) with (1 - 2 * sin (x / 2) * sin (x / 2)) by (rewrite <- cos_2a_sin; f_equal; field).
    pose proof (S (x / 2) ltac:(lra)). nra. }
  assert (P : 127 / 128 <= cos x) by nra. pose proof (S x ltac:(lra)) as T. unfold tan, Rdiv.
  apply Rmult_le_reg_r with (cos x); [lra|]. rewrite Rmult_assoc, Rinv_l by lra. nra.
Qed.
Theorem shorter_way_holds : shorter_way.
Proof.
  intros E l H a b A B. split; [rewrite dot_scale_r; lra|]. intros theta T D O.
  assert (R : theta <= PI / 2).
  { apply Rnot_lt_le. intros G. pose proof (cos_lt_0 theta ltac:(lra) ltac:(lra)). lra. }
  split; [exact R|]. destruct (angle_is_bounded_holds E l H a b theta T A B D) as [-> _]. unfold angle_by_half_tangent.
  rewrite !half_tangent_is by lra. pose proof (tangent_of_little (theta / 2 / 2 / 2 / 2)) as G. pose proof PI_4. lra.
Qed.

(* The hypotheses can be met: a quarter of a turn. *)
Example slerp_instance : 0 < PI / 2 < PI /\ norm2 ((1, 0) : plane) = 1 /\ norm2 ((0, 1) : plane) = 1 /\
  dot ((1, 0) : plane) (0, 1) = cos (PI / 2).
Proof.
  pose proof PI_RGT_0. rewrite cos_PI2. repeat split; try lra; vunfold; lra.
Qed.
Example cubic_instance : Forall (fun x => norm x <= 1) [0; 0; 0; 1] /\ Forall (fun x => norm ((3 / 1) *: x) <= 3) [0; 0; 1] /\
  Forall (fun x => norm ((6 / (1 * 1)) *: x) <= 6) [0; 1].
Proof.
  assert (N : forall x : R, 0 <= x -> norm x = x) by (intros x X; apply norm_eq; [exact X|reflexivity]).
  repeat split; repeat apply Forall_cons; try apply Forall_nil; rewrite N; cbn; lra.
Qed.
