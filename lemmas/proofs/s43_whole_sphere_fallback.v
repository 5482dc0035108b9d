(* SPDX-License-Identifier: MIT *)
(* Section 4.3, the paragraph before Equation 6: when to fall back on the whole of S_3. Lines 12 to 15 of Algorithm 1. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.lemma4_quaternion_hull Refitlab.s43_distance_range Refitlab.s43_rotated_cap.
Import ListNotations.

(* --- Statements: N = 1 + ||c||^2 - r^2 is hull_offset c r, and d_H = N / (2 ||c||) is hull_distance c r --- *)

(* If N > 0, then c is not 0, no b is 0, and b / ||b|| is in the cap of S_3 with apex c / ||c|| and cosine d_H > 0; so
   R_b v is within the angle with cosine 2 d_H^2 - 1 of R_c v. *)
Definition cap_if_positive : Prop :=
  forall (c : quat R) (r : R) (ns : list (quat R)) (b : quat R),
  0 < hull_offset c r -> units_in_ball c r ns -> in_hull ns b ->
  c <> lzero /\ b <> lzero /\ 0 < hull_distance c r <= 1 /\ within_angle c b (hull_distance c r) /\
  forall v, (2 * (hull_distance c r * hull_distance c r) - 1) * norm2 v <= dot (rotate b v) (rotate c v).
(* In any case the cosine -1 is a bound for the blends that are not 0. *)
Definition sphere_otherwise : Prop :=
  forall (a b : quat R) (v : vec R), a <> lzero -> b <> lzero -> -1 * norm2 v <= dot (rotate b v) (rotate a v).

(* Printed: the whole of S_3 is needed as soon as r_E >= 1: the cosine d_H is no bound then. *)
Definition fallback_is_needed_printed : Prop :=
  forall (c : quat R) (r : R) (ns : list (quat R)), units_in_ball c r ns -> 1 <= r ->
  ~ (0 < hull_distance c r /\ forall b, in_hull ns b -> b <> lzero /\ within_angle c b (hull_distance c r)).
(* Line 15 as printed, with no fallback: c_E is not 0, and the radius sin(2 arccos d_H) ||u||, which has the sign of d_H,
   is not negative. E is the mean ball of the units. *)
Definition line_15_makes_ball_printed : Prop :=
  forall (ns : list (quat R)) (r : R), let c := (/ INR (length ns) *: comb (repeat 1 (length ns)) ns)%V in
  units_in_ball c r ns -> (exists n, In n ns /\ norm (n - c) = r) -> c <> lzero /\ 0 <= hull_distance c r.
(* The same where c_E is not 0. *)
Definition line_15_radius_printed : Prop :=
  forall (ns : list (quat R)) (r : R), let c := (/ INR (length ns) *: comb (repeat 1 (length ns)) ns)%V in
  units_in_ball c r ns -> (exists n, In n ns /\ norm (n - c) = r) -> c <> lzero -> 0 <= hull_distance c r.

(* --- Proofs --- *)

Lemma hull_distance_offset {E} `{Euclid E} (c : E) r : c <> lzero -> hull_distance c r * norm c = hull_offset c r / 2.
Proof. intros N. apply norm_pos in N. unfold hull_distance, hull_offset. field. lra. Qed.

Theorem cap_if_positive_holds : cap_if_positive.
Proof.
  intros c r ns b O U B. destruct (lemma4_not_zero_holds _ _ _ c r ns b O U B) as [Nb Nc].
  pose proof (radius_nonneg c r ns b U B) as P. destruct (hull_facts c r ns b U B) as [D L].
  pose proof (hull_distance_offset c r Nc) as Q. pose proof (norm_pos c Nc) as C. pose proof (norm_pos b Nb) as Bp.
  assert (H : 0 < hull_distance c r) by nra.
  assert (W : within_angle c b (hull_distance c r)).
  { unfold within_angle. rewrite (dot_comm c b). nra. }
  split; [exact Nc|]. split; [exact Nb|]. split; [|split; [exact W|]].
  - split; [exact H|]. unfold within_angle in W. pose proof (dot_le_norms c b) as G.
    apply Rmult_le_reg_r with (norm c * norm b); [nra|]. lra.
  - intros v. apply rotation_bound_squared_holds; auto. rewrite (dot_comm b c), (Rmult_comm (norm2 b)).
    apply within_angle_squared; auto. lra.
Qed.

Theorem sphere_otherwise_holds : sphere_otherwise.
Proof.
  intros a b v A B. pose proof (dot_ge_norms (rotate b v) (rotate a v)) as G. rewrite !rotate_norm, norm_sq in G by auto. lra.
Qed.

(* 1 and (-7/25, 24/25, 0, 0) in their mean ball with 1 three times, r_E = 6/5: d_H^2 = 1/325. *)
Theorem fallback_is_needed_is_false : ~ fallback_is_needed_printed.
Proof.
  intros P. destruct lemma4_instance as [O U]. apply (P _ _ _ U); [lra|].
  assert (X : exists b, in_hull [Quat 1 0 0 0; Quat (- 7 / 25) (24 / 25) 0 0] b).
  { exists (comb [1 / 2; 1 / 2] [Quat 1 0 0 0; Quat (- 7 / 25) (24 / 25) 0 0]), [1 / 2; 1 / 2].
    split; [repeat split; [repeat constructor; lra|cbn; lra]|reflexivity]. }
  split.
  - destruct X as (b & B). apply (cap_if_positive_holds _ _ _ b O U B).
  - intros b B. split; apply (cap_if_positive_holds _ _ _ b O U B).
Qed.

(* The mean of a quaternion and its negative is 0. *)
Theorem line_15_makes_ball_is_false : ~ line_15_makes_ball_printed.
Proof.
  intros P. specialize (P [Quat 1 0 0 0; Quat (-1) 0 0 0] 1). cbv zeta in P.
  replace (/ INR _ *: _)%V with (lzero : quat R) in P by (cbn; vunfold; f_equal; field).
  destruct P as [N _]; [| |now apply N].
  - units_in_ball_by_numbers.
  - exists (Quat 1 0 0 0). split; [now left|]. apply norm_eq; [lra|]. vunfold. ring.
Qed.

(* 1, 1, 1 and (-4/5, 3/5, 0, 0): r_E^2 = 81/40, and N = -7/10. *)
Theorem line_15_radius_is_false : ~ line_15_radius_printed.
Proof.
  intros P. set (far := Quat (- 4 / 5) (3 / 5) 0 0). set (n := Quat 1 0 0 0).
  specialize (P [n; n; n; far] (sqrt (81 / 40))). cbv zeta in P.
  replace (/ INR _ *: _)%V with (Quat (11 / 20) (3 / 20) 0 0) in P by (unfold n, far; cbn; vunfold; f_equal; field).
  assert (S : sqrt (81 / 40) * sqrt (81 / 40) = 81 / 40) by (apply sqrt_sqrt; lra). pose proof (sqrt_pos (81 / 40)) as S0.
  set (c := Quat (11 / 20) (3 / 20) 0 0) in *.
  assert (N : c <> lzero) by (apply norm2_pos_inv; unfold c; vunfold; lra).
  assert (D : 0 <= hull_distance c (sqrt (81 / 40))).
  { apply P; auto.
    - repeat apply Forall_cons; try apply Forall_nil; (split; [unfold n, far; vunfold; lra|]);
        apply norm_le; cbn [center radius]; rewrite S; (split; [exact S0|]); unfold n, far, c; vunfold; lra.
    - exists far. split; [cbn; tauto|]. apply norm_eq; auto. rewrite S. unfold far, c. vunfold. field. }
  pose proof (hull_distance_offset c (sqrt (81 / 40)) N) as Q. unfold hull_offset in Q. rewrite S in Q.
  replace (norm2 c) with (13 / 40) in Q by (unfold c; vunfold; field). pose proof (norm_pos c N). nra.
Qed.

(* The hypotheses can be met: lemma4_instance has N = 2/25, and the two units have blends. *)
Example fallback_instance : exists c r ns b, 0 < hull_offset (c : quat R) r /\ units_in_ball c r ns /\ in_hull ns b.
Proof.
  destruct lemma4_instance as [O U]. do 3 eexists. exists (comb [1 / 2; 1 / 2] [Quat 1 0 0 0; Quat (- 7 / 25) (24 / 25) 0 0]).
  split; [exact O|]. split; [exact U|]. exists [1 / 2; 1 / 2].
  split; [repeat split; [repeat constructor; lra|cbn; lra]|reflexivity].
Qed.
