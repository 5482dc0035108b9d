(* SPDX-License-Identifier: MIT *)
(* How p / ||p||^2 moves, by how p moves, in any real inner product space. Its derivatives g', g'' are those that
   ||p||^2 g = p has, by the rule of Leibniz. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex.
Import ListNotations.

(* g, g', g'' for p, p', p''. *)
Definition is_inverse_moment {E} `{Euclid E} (p p' p'' g g' g'' : E) :=
  (norm2 p *: g)%V = p /\ (norm2 p *: g' + (2 * dot p p') *: g)%V = p' /\
  (norm2 p *: g'' + (4 * dot p p') *: g' + (2 * (norm2 p' + dot p p'')) *: g)%V = p''.

(* --- Statements --- *)

(* (ii) *)
Definition inverse_moves : Prop := forall E (l : Lin R E) (H : Euclid E) (p p' p'' g g' g'' : E) (m L A : R),
  0 < m <= norm p -> norm p' <= L -> norm p'' <= A -> is_inverse_moment p p' p'' g g' g'' ->
  norm g <= 1 / m /\ norm g' <= L / (m * m) /\ norm g'' <= A / (m * m) + 2 * (L * L) / (m * m * m).

(* (iv) *)
Definition blend_is_long_by_axis : Prop := forall E (l : Lin R E) (H : Euclid E) (ps : list E) u (axis : E) (k : R),
  convex (length ps) u -> Forall (fun p => k <= dot p axis) ps -> k <= norm (comb u ps) * norm axis.

(* --- Proofs --- *)

Lemma quotient_at_most (x X y m : R) : 0 <= x <= X -> 0 < m <= y -> x / y <= X / m.
Proof.
  intros Hx Hy. unfold Rdiv. apply Rmult_le_compat; try lra.
  - left. apply Rinv_0_lt_compat. lra.
  - apply Rinv_le_contravar; lra.
Qed.

Theorem inverse_moves_holds : inverse_moves.
Proof.
  intros E l H p p' p'' g g' g'' m L A M V B (G0 & G1 & G2).
  set (n := norm p) in *. assert (N : norm2 p = n * n) by (unfold n; now rewrite norm_sq).
  assert (P : 0 < n) by lra. assert (P2 : 0 < n * n) by (apply Rmult_lt_0_compat; lra).
  assert (P3 : 0 < n * n * n) by (apply Rmult_lt_0_compat; lra).
  assert (M2 : 0 < m * m) by (apply Rmult_lt_0_compat; lra). assert (M3 : 0 < m * m * m) by (apply Rmult_lt_0_compat; lra).
  assert (L2 : m * m <= n * n) by nra. assert (L3 : m * m * m <= n * n * n) by nra.
  rewrite N in *. set (s := dot p p') in *. set (b := dot p p'') in *. set (v := norm2 p') in *.
  assert (E0 : g = (/ (n * n) *: p)%V) by (rewrite <- G0 at 1; vec_field; lra).
  assert (E1 : g' = (/ (n * n) *: p' - (2 * s / (n * n * (n * n))) *: p)%V).
  { rewrite <- G1 at 1. rewrite E0. clearbody s. vec_field. lra. }
  assert (E2 : g'' = (/ (n * n) *: (p'' - (2 * b / (n * n)) *: p) +
    ((- (4 * s) / (n * n * (n * n))) *: p' + ((8 * (s * s) / (n * n) - 2 * v) / (n * n * (n * n))) *: p))%V).
  { rewrite <- G2 at 1. rewrite E1, E0. clearbody s b v. vec_field. lra. }
  split; [|split].
  - replace (norm g) with (1 / n); [apply quotient_at_most; lra|]. symmetry. apply norm_eq; [apply Rlt_le, Rdiv_lt_0_compat; lra|].
    rewrite E0, norm2_scale, N. field. lra.
  - replace (norm g') with (norm p' / (n * n)).
    { apply quotient_at_most; [split; [apply norm_nonneg|exact V]|lra]. }
    symmetry. apply norm_eq; [apply Rmult_le_pos; [apply norm_nonneg|left; now apply Rinv_0_lt_compat]|].
    replace (norm p' / (n * n) * (norm p' / (n * n))) with (norm p' * norm p' / (n * n * (n * n))) by (field; lra).
    rewrite norm_sq, E1. fold v.
    replace (norm2 (/ (n * n) *: p' - (2 * s / (n * n * (n * n))) *: p)) with
      (/ (n * n) * / (n * n) * v - 2 * (/ (n * n) * (2 * s / (n * n * (n * n)))) * s +
       2 * s / (n * n * (n * n)) * (2 * s / (n * n * (n * n))) * norm2 p) by (unfold v, s; dots; ring).
    rewrite N. field. lra.
  - rewrite E2. eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat.
    + replace (norm (/ (n * n) *: (p'' - (2 * b / (n * n)) *: p))) with (norm p'' / (n * n)).
      { apply quotient_at_most; [split; [apply norm_nonneg|exact B]|lra]. }
      symmetry. apply norm_eq; [apply Rmult_le_pos; [apply norm_nonneg|left; now apply Rinv_0_lt_compat]|].
      replace (norm p'' / (n * n) * (norm p'' / (n * n))) with (norm p'' * norm p'' / (n * n * (n * n))) by (field; lra).
      rewrite norm_sq, norm2_scale.
      replace (norm2 (p'' - (2 * b / (n * n)) *: p)) with
        (norm2 p'' - 2 * (2 * b / (n * n)) * b + 2 * b / (n * n) * (2 * b / (n * n)) * norm2 p) by (unfold b; dots; ring).
      rewrite N. field. lra.
    + match goal with |- norm ?x <= _ => replace (norm x) with (2 * v / (n * n * n)) end.
      { apply quotient_at_most; [|lra]. pose proof (norm2_nonneg p') as Q. fold v in Q.
        assert (v = norm p' * norm p') by (unfold v; now rewrite norm_sq). pose proof (norm_nonneg p'). nra. }
      symmetry. apply norm_eq.
      { pose proof (norm2_nonneg p') as Q. fold v in Q. apply Rmult_le_pos; [lra|left; now apply Rinv_0_lt_compat]. }
      match goal with |- norm2 (?c *: p' + ?d *: p) = _ =>
        replace (norm2 (c *: p' + d *: p)) with (c * c * v + 2 * (c * d) * s + d * d * norm2 p) by (unfold v, s; dots; ring) end.
      rewrite N. field. lra.
Qed.

Theorem blend_is_long_by_axis_holds : blend_is_long_by_axis.
Proof.
  intros E l H ps u axis k U F. eapply Rle_trans; [|apply dot_le_norms].
  apply (convex_set_comb (fun x => k <= dot x axis)); auto. intros t x y T X Y. rewrite dot_add_l, !dot_scale_l. nra.
Qed.
Example axis_instance : convex 2 [1 / 2; 1 / 2] /\ Forall (fun p => 1 <= dot p 1) [1; 2].
Proof.
  split; [repeat split; [repeat constructor; lra|cbn; lra]|].
  repeat apply Forall_cons; try apply Forall_nil; cbn; lra.
Qed.

(* The hypotheses can be met, and the bounds reached: a number that rises through 1 / 2 at the speed 1. *)
Example inverse_instance : 0 < 1 / 2 <= norm (1 / 2) /\ norm 1 <= 1 /\ norm 0 <= 0 /\ is_inverse_moment (1 / 2) 1 0 2 (-4) 16.
Proof.
  assert (N : forall x : R, 0 <= x -> norm x = x) by (intros x X; apply norm_eq; [exact X|reflexivity]).
  rewrite !N by lra. unfold is_inverse_moment, norm2. cbn. repeat split; lra.
Qed.
