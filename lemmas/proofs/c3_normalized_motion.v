(* SPDX-License-Identifier: MIT *)
(* How q = p / ||p|| and g = p / ||p||^2 move, by how p moves, in any real inner product space. The rule of Leibniz for ||p|| q = p and
   ||p||^2 g = p says what their derivatives are. That curves of quaternions have them is proved, too. *)
From Coq Require Import List Reals Lra Psatz Lia.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.curve.
Import ListNotations.

(* q, q', q'' for p, p', p''; (p, p') / ||p|| is the derivative of ||p||. *)
Definition is_normalized_moment {E} `{Euclid E} (p p' p'' q q' q'' : E) :=
  let n := norm p in let n' := dot p p' / n in let n'' := (norm2 p' + dot p p'' - n' * n') / n in
  (n *: q)%V = p /\ (n *: q' + n' *: q)%V = p' /\ (n *: q'' + (2 * n') *: q' + n'' *: q)%V = p''.
(* g, g', g'' for p, p', p''. *)
Definition is_inverse_moment {E} `{Euclid E} (p p' p'' g g' g'' : E) :=
  (norm2 p *: g)%V = p /\ (norm2 p *: g' + (2 * dot p p') *: g)%V = p' /\
  (norm2 p *: g'' + (4 * dot p p') *: g' + (2 * (norm2 p' + dot p p'')) *: g)%V = p''.

(* --- Statements --- *)

(* (i) *)
Definition normalized_moves : Prop := forall E (l : Lin R E) (H : Euclid E) (p p' p'' q q' q'' : E) (m L A : R),
  0 < m <= norm p -> norm p' <= L -> norm p'' <= A -> is_normalized_moment p p' p'' q q' q'' ->
  norm q <= 1 /\ norm q' <= L / m /\ norm q'' <= A / m + 37 / 32 * (L / m * (L / m)).
(* And so of a curve. *)
Definition normalized (p : quat R) : quat R := (/ norm p *: p)%V.
Definition normalized_motion (L A m : R) := Motion 1 (L / m) (A / m + 37 / 32 * (L / m * (L / m))).
Definition normalized_curve_moves : Prop := forall (p : R -> quat R) (s L A m a b : R), moves p (Motion s L A) a b ->
  0 < m -> (forall t, a <= t <= b -> m <= norm (p t)) -> moves (fun t => normalized (p t)) (normalized_motion L A m) a b.

(* (ii) *)
Definition inverse_moves : Prop := forall E (l : Lin R E) (H : Euclid E) (p p' p'' g g' g'' : E) (m L A : R),
  0 < m <= norm p -> norm p' <= L -> norm p'' <= A -> is_inverse_moment p p' p'' g g' g'' ->
  norm g <= 1 / m /\ norm g' <= L / (m * m) /\ norm g'' <= A / (m * m) + 2 * (L * L) / (m * m * m).

(* And so of a curve. *)
Definition inverse_of (p : quat R) : quat R := (/ norm2 p *: p)%V.
Definition inverse_motion (L A m : R) := Motion (1 / m) (L / (m * m)) (A / (m * m) + 2 * (L * L) / (m * m * m)).
Definition inverse_curve_moves : Prop := forall (p : R -> quat R) (s L A m a b : R), moves p (Motion s L A) a b ->
  0 < m -> (forall t, a <= t <= b -> m <= norm (p t)) -> moves (fun t => inverse_of (p t)) (inverse_motion L A m) a b.

(* (iii) *)
Definition blend_is_long_by_cosines : Prop := forall E (l : Lin R E) (H : Euclid E) (qs : list E) w (c d : R),
  convex (length qs) w -> Forall (fun q => d <= norm2 q) qs -> ForallOrdPairs (fun p q => c <= dot p q) qs -> c <= d ->
  c + (d - c) / INR (length qs) <= norm2 (comb w qs).

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

Theorem normalized_moves_holds : normalized_moves.
Proof.
  intros E l H p p' p'' q q' q'' m L A M V B (Q0 & Q1 & Q2).
  set (n := norm p) in *. assert (N : norm2 p = n * n) by (unfold n; now rewrite norm_sq).
  assert (P : 0 < n) by lra. set (d := dot p p') in *. set (b := dot p p'') in *. set (v := norm2 p') in *.
  assert (E0 : q = (/ n *: p)%V) by (rewrite <- Q0 at 1; vec_field; lra).
  assert (E1 : q' = (/ n *: (p' - (d / (n * n)) *: p))%V).
  { rewrite <- Q1 at 1. rewrite E0. clearbody d. vec_field. lra. }
  (* x^2 and y^2: the squared speed across p and along it. *)
  set (y2 := d * d / (n * n)). set (x2 := v - y2).
  assert (E2 : q'' = (/ n *: (p'' - (b / (n * n)) *: p) +
    ((- (2 * d) / (n * n * n)) *: p' + ((2 * y2 - x2) / (n * n * n)) *: p))%V).
  { rewrite <- Q2 at 1. rewrite E1, E0. unfold x2, y2. clearbody d b v. vec_field. lra. }
  assert (Y : 0 <= y2) by (unfold y2; apply Rmult_le_pos; [apply Rle_0_sqr|left; apply inv_pos; nra]).
  assert (X : 0 <= x2).
  { pose proof (cauchy p p') as C. fold d v in C. rewrite N in C. unfold x2, y2. apply Rmult_le_reg_l with (n * n); [nra|].
    replace (n * n * (v - d * d / (n * n))) with (n * n * v - d * d) by (field; lra). lra. }
  assert (L2 : x2 + y2 <= L * L).
  { unfold x2. replace (v - y2 + y2) with v by ring. unfold v. rewrite <- norm_sq. pose proof (norm_nonneg p'). nra. }
  assert (L0 : 0 <= L) by (eapply Rle_trans; [apply norm_nonneg|exact V]).
  split; [|split].
  - right. apply norm_eq; [lra|]. rewrite E0, norm2_scale, N. field. lra.
  - rewrite E1, norm_scale by (left; now apply inv_pos). replace (L / m) with (/ m * L) by (unfold Rdiv; ring).
    apply Rmult_le_compat; [left; now apply inv_pos|apply norm_nonneg|apply Rinv_le_contravar; lra|].
    apply norm_le. split; [exact L0|].
    replace (norm2 (p' - (d / (n * n)) *: p)) with (v - 2 * (d / (n * n)) * d + d / (n * n) * (d / (n * n)) * norm2 p)
      by (unfold v, d; dots; ring).
    rewrite N. replace (v - _ + _) with x2 by (unfold x2, y2; field; lra). lra.
  - rewrite E2. eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat.
    + rewrite norm_scale by (left; now apply inv_pos). replace (A / m) with (/ m * A) by (unfold Rdiv; ring).
      apply Rmult_le_compat; [left; now apply inv_pos|apply norm_nonneg|apply Rinv_le_contravar; lra|].
      apply norm_le. split; [eapply Rle_trans; [apply norm_nonneg|exact B]|].
      replace (norm2 (p'' - (b / (n * n)) *: p)) with (norm2 p'' - 2 * (b / (n * n)) * b + b / (n * n) * (b / (n * n)) * norm2 p)
        by (unfold b; dots; ring).
      rewrite N. replace (norm2 p'' - _ + _) with (norm2 p'' - b / n * (b / n)) by (field; lra).
      rewrite <- norm_sq. pose proof (norm_nonneg p''). pose proof (Rle_0_sqr (b / n)) as S. unfold Rsqr in S. nra.
    + apply Rle_trans with (37 / 32 * (L / n * (L / n))).
      * apply norm_le. split; [assert (0 <= L / n * (L / n)) by apply Rle_0_sqr; lra|].
        replace (norm2 ((- (2 * d) / (n * n * n)) *: p' + ((2 * y2 - x2) / (n * n * n)) *: p)) with
          (- (2 * d) / (n * n * n) * (- (2 * d) / (n * n * n)) * v +
           2 * (- (2 * d) / (n * n * n) * ((2 * y2 - x2) / (n * n * n))) * d +
           (2 * y2 - x2) / (n * n * n) * ((2 * y2 - x2) / (n * n * n)) * norm2 p) by (unfold v, d; dots; ring).
        rewrite N. replace (_ + _ + _) with (x2 * (4 * y2 + x2) / (n * n * (n * n))) by (unfold x2, y2; field; lra).
        replace (37 / 32 * (L / n * (L / n)) * (37 / 32 * (L / n * (L / n)))) with
          (37 / 32 * (37 / 32) * (L * L * (L * L)) / (n * n * (n * n))) by (field; lra).
        apply Rmult_le_compat_r; [left; apply inv_pos; repeat apply Rmult_lt_0_compat; exact P|].
        assert (x2 * (4 * y2 + x2) <= 4 / 3 * ((x2 + y2) * (x2 + y2)))
          by (pose proof (Rle_0_sqr (x2 - 2 * y2)) as S; unfold Rsqr in S; nra).
        assert ((x2 + y2) * (x2 + y2) <= L * L * (L * L)) by (apply Rmult_le_compat; lra). nra.
      * apply Rmult_le_compat_l; [lra|]. assert (0 <= L / n <= L / m).
        { split; [apply Rmult_le_pos; [exact L0|left; now apply inv_pos]|]. apply quotient_at_most; lra. }
        apply Rmult_le_compat; lra.
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

(* Curves of numbers. *)
Lemma derivative_of_numbers (f f' : R -> R) a b : (forall t, a <= t <= b -> derivable_pt_lim f t (f' t)) -> derivative f f' a b.
Proof.
  intros D e t T. cbn. replace (f' t * e) with (f' t * e + f t * 0) by ring.
  apply (derivable_pt_lim_mult f (fun _ => e)); [now apply D|apply derivable_pt_lim_const].
Qed.
Lemma numbers_of_derivative (f f' : R -> R) a b : derivative f f' a b -> forall t, a <= t <= b -> derivable_pt_lim f t (f' t).
Proof.
  intros D t T. specialize (D 1 t T). cbn in D. rewrite Rmult_1_r in D. apply (derivable_same (fun x => f x * 1)); [intros; ring|exact D].
Qed.
Lemma derivative_of_inverse (f f' : R -> R) a b : derivative f f' a b -> (forall t, a <= t <= b -> f t <> 0) ->
  derivative (fun t => / f t) (fun t => - f' t * (/ f t * / f t)) a b.
Proof.
  intros D N. apply derivative_of_numbers. intros t T. specialize (N t T).
  replace (- f' t * (/ f t * / f t)) with ((0 * f t - f' t * 1) / Rsqr (f t)) by (unfold Rsqr; field; exact N).
  apply (derivable_same (div_fct (fun _ => 1) f)); [intros y; unfold div_fct; lra|].
  apply derivable_pt_lim_div; [apply derivable_pt_lim_const|now apply (numbers_of_derivative f f' a b)|exact N].
Qed.

(* Both derivatives of 1 / ||p||. *)
Lemma derivatives_of_inverse_norm (p p' p'' : R -> quat R) a b : derivative p p' a b -> derivative p' p'' a b ->
  (forall t, a <= t <= b -> 0 < norm2 (p t)) ->
  let r t := / norm (p t) in let d t := dot (p t) (p' t) in let r' t := - d t * (r t * (r t * r t)) in
  derivative r r' a b /\ derivative r' (fun t => - (norm2 (p' t) + dot (p t) (p'' t)) * (r t * (r t * r t)) +
    - d t * (r' t * (r t * r t) + r t * (r' t * r t + r t * r' t))) a b.
Proof.
  intros D D' N r d r'.
  assert (Root : derivative (fun t => norm (p t)) (fun t => d t * r t) a b).
  { apply derivative_of_numbers. intros t T. specialize (N t T).
    pose proof (numbers_of_derivative _ _ a b (derivative_of_norm2 p p' a b D) t T) as S.
    replace (d t * r t) with (/ (2 * sqrt (norm2 (p t))) * (2 * d t)).
    - apply (derivable_pt_lim_comp (fun t => norm2 (p t)) sqrt t); [exact S|now apply derivable_pt_lim_sqrt].
    - unfold r, norm. field. apply Rgt_not_eq. now apply sqrt_lt_R0. }
  assert (Dr : derivative r r' a b).
  { eapply derivative_same; [reflexivity| |apply (derivative_of_inverse _ _ a b Root)].
    - intros t _. unfold r', r. ring.
    - intros t T. apply Rgt_not_eq. apply sqrt_lt_R0. now apply N. }
  split; [exact Dr|].
  assert (Dd : derivative (fun t => - d t) (fun t => - (norm2 (p' t) + dot (p t) (p'' t))) a b).
  { apply derivative_of_numbers. intros t T. apply (derivable_pt_lim_opp d). revert t T.
    apply (numbers_of_derivative d (fun t => norm2 (p' t) + dot (p t) (p'' t)) a b).
    exact (derivative_product (fun p q : quat R => dot p q) p p' p' p'' a b qdot_is_product D D'). }
  pose proof (derivative_product (fun s x : R => (s *: x)%V) r r' r r' a b scaling_is_product Dr Dr) as D2.
  pose proof (derivative_product (fun s x : R => (s *: x)%V) r r' _ _ a b scaling_is_product Dr D2) as D3.
  pose proof (derivative_product (fun s x : R => (s *: x)%V) _ _ _ _ a b scaling_is_product Dd D3) as D4.
  eapply derivative_same; [| |exact D4]; intros; cbv [lscale ladd lzero lin_num add mul zero ops_R]; unfold r'; ring.
Qed.

Theorem normalized_curve_moves_holds : normalized_curve_moves.
Proof.
  intros p s L A m a b (p' & p'' & D & D' & M) Pm Long.
  assert (N : forall t, a <= t <= b -> 0 < norm2 (p t)).
  { intros t T. rewrite <- norm_sq. specialize (Long t T). apply Rmult_lt_0_compat; lra. }
  destruct (derivatives_of_inverse_norm p p' p'' a b D D' N) as [Dr Dr'].
  set (r := fun t => / norm (p t)) in *. set (r' := fun t => - dot (p t) (p' t) * (r t * (r t * r t))) in *. cbv beta in Dr'.
  match type of Dr' with derivative _ ?f _ _ => set (r'' := f) in * end.
  apply (scaled_curve_moves r r' r'' p p' p'' _ a b Dr Dr' D D').
  intros t T. specialize (N t T). specialize (Long t T). destruct (M t T) as (_ & M1 & M2). cbn [size speed acceleration] in M1, M2.
  apply (normalized_moves_holds _ _ _ (p t) (p' t) (p'' t)); auto.
  unfold is_normalized_moment, normalized, r'', r', r. assert (P : 0 < norm (p t)) by lra. generalize dependent (norm (p t)).
  intros n _ P. generalize (dot (p t) (p' t)) (norm2 (p' t)) (dot (p t) (p'' t)). intros x y z. repeat split; vec_field; lra.
Qed.

Theorem inverse_curve_moves_holds : inverse_curve_moves.
Proof.
  intros p s L A m a b (p' & p'' & D & D' & M) Pm Long.
  assert (N : forall t, a <= t <= b -> norm2 (p t) <> 0).
  { intros t T. rewrite <- norm_sq. specialize (Long t T). assert (0 < norm (p t) * norm (p t)) by (apply Rmult_lt_0_compat; lra). lra. }
  pose (d := fun t => dot (p t) (p' t)). pose (d' := fun t => norm2 (p' t) + dot (p t) (p'' t)).
  pose (u := fun t => / norm2 (p t)). pose (u' := fun t => -2 * (d t * (u t * u t))).
  pose (u'' := fun t => -2 * (d' t * (u t * u t) + d t * (u' t * u t + u t * u' t))).
  assert (Du : derivative u u' a b).
  { eapply derivative_same; [reflexivity| |apply (derivative_of_inverse (fun t => norm2 (p t)) (fun t => 2 * d t)); [|exact N]].
    - intros t _. unfold u', u. ring.
    - exact (derivative_of_norm2 p p' a b D). }
  assert (Dd : derivative d d' a b).
  { exact (derivative_product (fun p q : quat R => dot p q) p p' p' p'' a b qdot_is_product D D'). }
  assert (Du' : derivative u' u'' a b).
  { pose proof (derivative_product (fun s x : R => (s *: x)%V) u u' u u' a b scaling_is_product Du Du) as Duu.
    pose proof (derivative_product (fun s x : R => (s *: x)%V) d d' _ _ a b scaling_is_product Dd Duu) as Dduu.
    pose proof (derivative_product (fun s x : R => (s *: x)%V) _ _ _ _ a b scaling_is_product (derivative_constant (-2) a b) Dduu) as Q.
    eapply derivative_same; [| |exact Q]; intros; unfold u'', u'; cbv [lscale ladd lzero lin_num add mul zero ops_R]; ring. }
  apply (scaled_curve_moves u u' u'' p p' p'' _ a b Du Du' D D').
  intros t T. specialize (N t T). specialize (Long t T). destruct (M t T) as (_ & M1 & M2). cbn [size speed acceleration] in M1, M2.
  apply (inverse_moves_holds _ _ _ (p t) (p' t) (p'' t)); auto.
  unfold is_inverse_moment, inverse_of, u'', u', u, d', d. generalize dependent (norm2 (p t)). intros n N.
  generalize (dot (p t) (p' t)) (norm2 (p' t)) (dot (p t) (p'' t)). intros x y z. repeat split; vec_field; exact N.
Qed.

Definition squares (w : list R) := sum (map Rsqr w).
Lemma squares_are_no_less (w : list R) : sum w * sum w <= INR (length w) * squares w.
Proof.
  unfold squares. induction w as [|a w IH]; [cbn; lra|]. cbn [length map]. rewrite S_INR, !sum_cons. set (q := sum (map Rsqr w)) in *.
  assert (Q : 0 <= q) by (apply sum_nonneg, Forall_map, Forall_forall; intros; apply Rle_0_sqr).
  pose proof (pos_INR (length w)) as P. unfold Rsqr. destruct w as [|b w]; [unfold q; cbn; lra|].
  assert (N : 0 < INR (length (b :: w))) by (apply lt_0_INR; cbn [length]; lia).
  set (n := INR (length (b :: w))) in *. set (s := sum (b :: w)) in *.
  apply Rmult_le_reg_l with n; [exact N|]. pose proof (Rle_0_sqr (n * a - s)) as Sq. unfold Rsqr in Sq. nra.
Qed.
Lemma dot_with_blend {E} `{Euclid E} (q : E) qs w c : length w = length qs -> Forall (Rle 0) w -> Forall (fun p => c <= dot q p) qs ->
  c * sum w <= dot q (comb w qs).
Proof.
  intros L P F. revert w L P. induction F as [|p qs D F IH]; intros [|a w] L P; try discriminate; cbn [comb].
  - rewrite dot_zero_r. cbn. lra.
  - apply Forall_cons_iff in P as [A P]. specialize (IH w ltac:(auto) P). rewrite sum_cons, dot_add_r, dot_scale_r. nra.
Qed.
Theorem blend_is_long_by_cosines_holds : blend_is_long_by_cosines.
Proof.
  intros E l H qs w c d (L & P & S) U F C.
  assert (G : c * (sum w * sum w) + (d - c) * squares w <= norm2 (comb w qs)).
  { unfold squares. clear S. revert w L P. induction F as [|q qs D F IH]; intros [|a w] L P; try discriminate; cbn [comb map].
    - rewrite norm2_zero. cbn. lra.
    - apply Forall_cons_iff in P as [A P]. apply Forall_cons_iff in U as [Uq U]. specialize (IH U w ltac:(auto) P).
      pose proof (dot_with_blend q qs w c ltac:(auto) P D) as B. rewrite !sum_cons. unfold Rsqr at 1.
      replace (norm2 (a *: q + comb w qs)) with (a * a * norm2 q + 2 * (a * dot q (comb w qs)) + norm2 (comb w qs)) by (dots; ring).
      apply (Rmult_le_compat_l (a * a)) in Uq; [|nra]. apply (Rmult_le_compat_l a) in B; [|exact A]. lra. }
  rewrite S in G. pose proof (squares_are_no_less w) as Q. rewrite S, L in Q.
  assert (N : 0 < INR (length qs)).
  { destruct qs; [|apply lt_0_INR; cbn [length]; lia]. destruct w; [cbn in S; lra|discriminate]. }
  assert (/ INR (length qs) <= squares w).
  { apply Rmult_le_reg_l with (INR (length qs)); [exact N|]. rewrite Rinv_r by lra. lra. }
  unfold Rdiv. nra.
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
Example normalized_instance : is_normalized_moment 1 0 1 1 0 0 /\ 0 < 1 <= norm 1 /\ norm 0 <= 0 /\ norm 1 <= 1.
Proof.
  assert (N : forall x : R, 0 <= x -> norm x = x) by (intros x X; apply norm_eq; [exact X|reflexivity]).
  unfold is_normalized_moment. rewrite !N by lra. unfold norm2. cbn. repeat split; lra.
Qed.
Example inverse_curve_instance : moves (fun _ => Quat 1 0 0 0) (Motion 1 0 0) 0 1 /\ 1 <= norm (Quat 1 0 0 0).
Proof.
  assert (N : norm (Quat 1 0 0 0) = 1) by (apply norm_unit; vunfold; ring). split; [|lra].
  exists (fun _ => lzero), (fun _ => lzero). split; [apply derivative_constant|]. split; [apply derivative_constant|].
  intros t _. cbn [size speed acceleration]. repeat split; rewrite ?N, ?norm_zero; lra.
Qed.
Example cosines_instance : convex 2 [1 / 2; 1 / 2] /\ Forall (fun q : R => 1 <= norm2 q) [1; 1] /\
  ForallOrdPairs (fun p q : R => 1 <= dot p q) [1; 1].
Proof.
  split; [repeat split; [repeat constructor; lra|cbn; lra]|]. split.
  - repeat apply Forall_cons; try apply Forall_nil; vunfold; lra.
  - apply FOP_cons; [apply Forall_cons; [cbn; lra|constructor]|]. apply FOP_cons; constructor.
Qed.
