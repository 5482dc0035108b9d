(* SPDX-License-Identifier: MIT *)
(* Beyond the paper: one lemma in place of Lemmas 2 to 4, for quaternions of any length. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.s43_rotated_cap.
Import ListNotations.

(* --- Statements --- *)

(* (q, c) >= 0 and kappa^2 ||q||^2 ||c||^2 <= (q, c)^2 *)
Definition in_cone {E} `{Euclid E} (c : E) (kappa2 : R) (q : E) :=
  0 <= dot q c /\ kappa2 * (norm2 q * norm2 c) <= dot q c * dot q c.

(* Every convex combination of such q_k is one too. *)
Definition one_cap : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c : E) (kappa2 : R) (qs : list E) (b : E),
  0 <= kappa2 -> Forall (in_cone c kappa2) qs -> in_hull qs b -> in_cone c kappa2 b.
(* If neither b nor c is 0, R_b v is within the angle with cosine 2 kappa^2 - 1 of R_c v. *)
Definition one_cap_rotated : Prop :=
  forall (c b : quat R) (kappa2 : R) (v : vec R), c <> lzero -> b <> lzero -> in_cone c kappa2 b ->
  (2 * kappa2 - 1) * norm2 v <= dot (rotate b v) (rotate c v).
(* If all (q_k, c) > 0, then b is not 0. *)
Definition blend_not_zero : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c : E) (qs : list E) (b : E),
  Forall (fun q => 0 < dot q c) qs -> in_hull qs b -> 0 < dot b c /\ b <> lzero.
(* The best kappa^2 for q_k and c that are not 0 is the least (q_k, c)^2 / (||q_k||^2 ||c||^2). *)
Definition best_kappa2 : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c : E) (kappa2 : R) (qs : list E),
  c <> lzero -> Forall (fun q => q <> lzero /\ 0 <= dot q c) qs ->
  (Forall (in_cone c kappa2) qs <-> Forall (fun q => kappa2 <= dot q c * dot q c / (norm2 q * norm2 c)) qs).

(* --- Proofs --- *)

(* In roots: kappa ||q|| ||c|| <= (q, c). *)
Lemma in_cone_norm {E} `{Euclid E} (c q : E) kappa2 : 0 <= kappa2 ->
  in_cone c kappa2 q <-> sqrt kappa2 * norm q * norm c <= dot q c.
Proof.
  intros K. unfold in_cone. pose proof (sqrt_sqrt kappa2 K) as S. pose proof (sqrt_pos kappa2).
  pose proof (norm_nonneg q). pose proof (norm_nonneg c). rewrite <- (norm_sq q), <- (norm_sq c).
  set (k := sqrt kappa2) in *. assert (P : 0 <= k * norm q * norm c) by (repeat apply Rmult_le_pos; auto).
  replace (kappa2 * (norm q * norm q * (norm c * norm c))) with ((k * norm q * norm c) * (k * norm q * norm c))
    by (rewrite <- S; ring).
  split; [intros [A B]; now apply sq_le_inv|]. intros A. split; [lra|]. apply Rmult_le_compat; auto.
Qed.

Lemma in_cone_is_cone {E} `{Euclid E} (c : E) kappa2 : 0 <= kappa2 -> cone (in_cone c kappa2).
Proof.
  intros K. pose proof (sqrt_pos kappa2) as P. pose proof (norm_nonneg c) as N. set (k := sqrt kappa2) in *.
  split; [|intros x y|intros a x A]; rewrite !in_cone_norm by auto; fold k.
  - rewrite norm_zero, dot_zero_l. lra.
  - intros X Y. rewrite dot_add_l. pose proof (norm_add x y).
    assert (k * norm (x + y) * norm c <= k * (norm x + norm y) * norm c)
      by (apply Rmult_le_compat_r; auto; apply Rmult_le_compat_l; auto). lra.
  - intros X. rewrite dot_scale_l, norm_scale by auto.
    replace (k * (a * norm x) * norm c) with (a * (k * norm x * norm c)) by ring. now apply Rmult_le_compat_l.
Qed.

Theorem one_cap_holds : one_cap.
Proof. intros E l e c kappa2 qs b K F (u & (_ & P & _) & ->). apply comb_in_cone; auto. now apply in_cone_is_cone. Qed.

Theorem one_cap_rotated_holds : one_cap_rotated.
Proof.
  intros c b kappa2 v C B [_ K]. apply (rotation_bound_squared_holds b c v kappa2); auto.
Qed.

Theorem blend_not_zero_holds : blend_not_zero.
Proof.
  intros E l e c qs b F (u & (L & P & S) & ->).
  assert (D : 0 < dot (comb u qs) c).
  { rewrite dot_comb. apply comb_positive; [now rewrite map_length|auto|lra|]. now apply Forall_map. }
  split; [exact D|]. intros Z. rewrite Z, dot_zero_l in D. lra.
Qed.

Theorem best_kappa2_holds : best_kappa2.
Proof.
  intros E l e c kappa2 qs C N. apply norm2_pos in C.
  assert (I : forall q, q <> lzero -> 0 <= dot q c ->
    (in_cone c kappa2 q <-> kappa2 <= dot q c * dot q c / (norm2 q * norm2 c))).
  { intros q Q D. apply norm2_pos in Q. assert (P : 0 < norm2 q * norm2 c) by nra. unfold in_cone. split.
    - intros [_ B]. apply Rmult_le_reg_r with (1 := P). unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
    - intros B. split; auto. apply Rmult_le_compat_r with (r := norm2 q * norm2 c) in B; [|lra].
      unfold Rdiv in B. rewrite Rmult_assoc, Rinv_l in B; lra. }
  rewrite Forall_forall in N. split; intros F; apply Forall_forall; intros q Q; rewrite Forall_forall in F;
    destruct (N q Q); apply I; auto.
Qed.

(* The hypotheses can be met: 1 and (4/5, 3/5, 0, 0) about 1 with kappa^2 = 16/25. *)
Example one_cap_instance : let qs := [Quat 1 0 0 0; Quat (4 / 5) (3 / 5) 0 0] in
  Forall (in_cone (Quat 1 0 0 0) (16 / 25)) qs /\ Forall (fun q => 0 < dot q (Quat 1 0 0 0)) qs.
Proof. split; repeat constructor; vunfold; lra. Qed.
