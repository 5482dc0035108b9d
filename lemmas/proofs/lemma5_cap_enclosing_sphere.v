(* SPDX-License-Identifier: MIT *)
(* Lemma 5: the smallest ball that encloses a cap. Appendix of the paper; section 4.3 and line 15 of Algorithm 1. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.cap.

(* --- Statements --- *)

(* Center c + k (a - c) and radius sqrt(1 - k^2) r, with k = max(cos alpha, 0) and r = ||a - c||. *)
Definition cap_ball {E} `{Euclid E} (c a : E) (t : R) : ball E :=
  let k := Rmax t 0 in Ball (c + k *: (a - c))%V (sqrt (1 - k * k) * norm (a - c)).

(* It encloses the cap. *)
Definition encloses_repaired : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c a x : E) (t : R), t <= 1 -> in_cap c a t x -> in_ball (cap_ball c a t) x.

(* No other ball that small does, in at least two dimensions. *)
Definition smallest_repaired : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c a : E) (t : R) (b : ball E), at_least_plane E -> -1 <= t <= 1 ->
  (forall x, in_cap c a t x -> in_ball b x) ->
  radius (cap_ball c a t) <= radius b /\ (radius b = radius (cap_ball c a t) -> center b = center (cap_ball c a t)).

(* Printed: for c = 0, the ball with center a cos alpha and radius ||a|| sin alpha encloses the cap, for all angles of
   [0, pi]. *)
Definition encloses_printed (E : Type) `{Euclid E} : Prop :=
  forall (a x : E) (t : R), -1 <= t <= 1 -> in_cap lzero a t x ->
  in_ball (Ball (t *: a)%V (norm a * sqrt (1 - t * t))) x.
(* It is false in every space that is not a single point. *)
Definition encloses_printed_somewhere : Prop := exists E (l : Lin R E) (e : Euclid E),
  (exists a : E, a <> lzero) /\ encloses_printed E.
(* Printed: the ball is the smallest, whatever the dimension. On a line it is not. *)
Definition smallest_printed_on_line : Prop :=
  forall (a t : R) (b : ball R), -1 <= t <= 1 -> (forall x, in_cap 0 a t x -> in_ball b x) ->
  norm a * sqrt (1 - t * t) <= radius b.

(* --- Proofs --- *)

(* The inequality of the paper's proof: the cap's farthest point from c + k (a - c). *)
Lemma cap_distance {E} `{Euclid E} (c a x : E) (t k : R) : 0 <= k -> k * k <= k * t -> in_cap c a t x ->
  norm2 (x - (c + k *: (a - c))) <= (1 - k * k) * norm2 (a - c).
Proof.
  intros K KT [S D].
  replace (norm2 (x - (c + k *: (a - c)))) with
    (norm2 (x - c) - 2 * k * dot (x - c) (a - c) + k * k * norm2 (a - c)) by (dots; ring).
  rewrite S. pose proof (norm2_nonneg (a - c)%V). set (n := norm2 (a - c)) in *.
  assert (k * (t * n) <= k * dot (x - c) (a - c)) by (apply Rmult_le_compat_l; auto).
  assert (k * k * n <= k * t * n) by (apply Rmult_le_compat_r; auto). lra.
Qed.

Lemma height_bounds t : t <= 1 -> 0 <= Rmax t 0 <= 1 /\ Rmax t 0 * Rmax t 0 <= Rmax t 0 * t.
Proof. unfold Rmax; destruct (Rle_dec t 0); nra. Qed.

Lemma cap_ball_squares {E} `{Euclid E} (c a : E) t : t <= 1 ->
  0 <= radius (cap_ball c a t) /\
  radius (cap_ball c a t) * radius (cap_ball c a t) = (1 - Rmax t 0 * Rmax t 0) * norm2 (a - c).
Proof.
  intros T. destruct (height_bounds t T) as [K _]. cbn. set (k := Rmax t 0) in *. split.
  - apply Rmult_le_pos; [apply sqrt_pos|apply norm_nonneg].
  - replace (_ * _) with ((sqrt (1 - k * k) * sqrt (1 - k * k)) * (norm (a - c) * norm (a - c))) by ring.
    rewrite sqrt_sqrt, norm_sq by nra. ring.
Qed.

Theorem encloses_repaired_holds : encloses_repaired.
Proof.
  intros E l e c a x t T C. destruct (cap_ball_squares c a t T) as [R0 R2]. destruct (height_bounds t T) as [K KT].
  unfold in_ball. apply norm_le. split; [exact R0|]. rewrite R2. apply (cap_distance c a x t); auto. apply K.
Qed.

(* A ball that holds both ends of a diameter of another is no smaller, and if it is no larger, it is the same. *)
Lemma diameter_decides {E} `{Euclid E} (m h : E) (b : ball E) : in_ball b (m + h) -> in_ball b (m - h) ->
  norm h <= radius b /\ (radius b = norm h -> center b = m).
Proof.
  unfold in_ball. intros A B. apply norm_le in A as [R0 A], B as [_ B].
  assert (P : norm2 (m - center b) + norm2 h <= radius b * radius b).
  { replace (norm2 (m + h - center b)) with (norm2 (m - center b) + 2 * dot (m - center b) h + norm2 h) in A by (dots; ring).
    replace (norm2 (m - h - center b)) with (norm2 (m - center b) - 2 * dot (m - center b) h + norm2 h) in B by (dots; ring).
    lra. }
  pose proof (norm2_nonneg (m - center b)%V). pose proof (norm_nonneg h). rewrite <- (norm_sq h) in P. split; [nra|].
  intros Q. rewrite Q in P. assert (Z : (m - center b)%V = lzero) by (apply norm2_zero_inv; lra).
  apply dot_ext. intros z. pose proof (f_equal (fun y => dot y z) Z) as G. cbv beta in G. dots_in G. lra.
Qed.

Theorem smallest_repaired_holds : smallest_repaired.
Proof.
  intros E l e c a t b D T B. destruct (D (a - c)%V) as (v & V & N). destruct (height_bounds t) as [K KT]; [lra|].
  set (k := Rmax t 0) in *.
  set (h := (sqrt (1 - k * k) *: v)%V).
  assert (Q : sqrt (1 - k * k) * sqrt (1 - k * k) = 1 - k * k) by (apply sqrt_sqrt; nra).
  assert (H : norm h = radius (cap_ball c a t)).
  { unfold h. rewrite norm_scale by apply sqrt_pos. cbn. fold k. unfold norm. now rewrite N. }
  rewrite <- H. cbn. fold k.
  assert (S : forall s, s * s = 1 - k * k -> in_cap c a t (c + k *: (a - c) + s *: v)).
  { intros s Z. split.
    - replace (norm2 (c + k *: (a - c) + s *: v - c)) with
        (k * k * norm2 (a - c) + 2 * k * s * dot v (a - c) + s * s * norm2 v) by (dots; ring).
      rewrite V, N, Z. ring.
    - replace (dot (c + k *: (a - c) + s *: v - c) (a - c)) with (k * norm2 (a - c) + s * dot v (a - c)) by (dots; ring).
      rewrite V. pose proof (norm2_nonneg (a - c)%V). assert (t <= k) by apply Rmax_l. nra. }
  apply diameter_decides; apply B.
  - now apply S.
  - unfold h. replace (c + k *: (a - c) - sqrt (1 - k * k) *: v)%V with (c + k *: (a - c) + (- sqrt (1 - k * k)) *: v)%V
      by vec_ring. apply S. rewrite <- Q at 3. ring.
Qed.

(* alpha = pi: the printed ball is the point -a, and the cap is the whole surface. *)
Theorem encloses_printed_is_false : ~ encloses_printed_somewhere.
Proof.
  intros (E & l & e & (a & N) & P). specialize (P a a (-1)). apply norm2_pos in N.
  assert (B : in_ball (Ball (-1 *: a)%V (norm a * sqrt (1 - -1 * -1))) a).
  { apply P; [lra|]. split; [reflexivity|]. dots. unfold norm2 in N. lra. }
  unfold in_ball in B. cbn in B. replace (1 - -1 * -1) with 0 in B by ring. rewrite sqrt_0 in B.
  apply norm_le in B as [_ B]. replace (norm2 (a - -1 *: a)) with (4 * norm2 a) in B by (dots; ring). nra.
Qed.

(* The cap {1} of angle pi/2 in R^1: the point ball holds it, the printed ball is [-1, 1]. *)
Theorem smallest_printed_is_false : ~ smallest_printed_on_line.
Proof.
  intros P. specialize (P 1 0 (Ball 1 0)). cbn in P.
  replace (1 - 0 * 0) with 1 in P by ring. rewrite sqrt_1, (norm_unit 1) in P by (vunfold; ring).
  assert (1 * 1 <= 0); [|lra]. apply P; [lra|]. intros x [S D]. unfold in_ball. cbn. apply norm_le. vunfold. nra.
Qed.

(* The hypotheses can be met: a cap of the plane with cos alpha = 3/5 holds a point of its rim. *)
Example encloses_instance : 3 / 5 <= 1 /\ in_cap (0, 0) (1, 0) (3 / 5) (3 / 5, 4 / 5).
Proof. split; [lra|]. split; vunfold; lra. Qed.
Example smallest_instance : at_least_plane plane /\ -1 <= 3 / 5 <= 1 /\
  forall x : plane, in_cap (0, 0) (1, 0) (3 / 5) x -> in_ball (Ball (0, 0) 1) x.
Proof.
  split; [apply plane_is_plane|]. split; [lra|]. intros [x y] [S D]. unfold in_ball. apply norm_le. cbn [center radius].
  split; [lra|]. vunfold. lra.
Qed.
