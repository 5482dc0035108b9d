(* SPDX-License-Identifier: MIT *)
(* Convex combinations, convex sets, hulls and cones. *)
From Coq Require Import List Reals Lra Psatz Lia.
Require Import Refitlab.theory.linear Refitlab.theory.euclid.
Import ListNotations.

Definition sum (u : list R) := fold_right Rplus 0 u.
(* u in W_m: m numbers, none negative, of sum 1. *)
Definition convex (m : nat) (u : list R) := length u = m /\ Forall (Rle 0) u /\ sum u = 1.

Lemma sum_cons a u : sum (a :: u) = a + sum u.
Proof. reflexivity. Qed.
Lemma sum_app a b : sum (a ++ b) = sum a + sum b.
Proof. unfold sum; induction a as [|x a IH]; cbn; [ring|]. rewrite IH. ring. Qed.
Lemma sum_scale s a : sum (map (Rmult s) a) = s * sum a.
Proof. unfold sum; induction a as [|x a IH]; cbn; [ring|]. rewrite IH. ring. Qed.
Lemma sum_nonneg u : Forall (Rle 0) u -> 0 <= sum u.
Proof. unfold sum; induction 1; cbn; lra. Qed.
Lemma scale_nonneg s u : 0 <= s -> Forall (Rle 0) u -> Forall (Rle 0) (map (Rmult s) u).
Proof. intros S U. apply Forall_map. eapply Forall_impl; [|exact U]. intros; now apply Rmult_le_pos. Qed.
Lemma convex_not_empty u : ~ convex 0 u.
Proof. intros (L & _ & S). destruct u; [|discriminate]. cbn in S. lra. Qed.

(* --- Linear combinations --- *)

Definition linear {X Y} {lx : Lin R X} {ly : Lin R Y} (f : X -> Y) :=
  f lzero = lzero /\ (forall x y, f (x + y)%V = (f x + f y)%V) /\ (forall a x, f (a *: x)%V = (a *: f x)%V).

Lemma comb_linear {X Y} {lx : Lin R X} {ly : Lin R Y} (f : X -> Y) u xs :
  linear f -> f (comb u xs) = comb u (map f xs).
Proof.
  intros (Z & A & S). revert xs; induction u as [|a u IH]; intros [|x xs]; cbn; auto. now rewrite A, S, IH.
Qed.
Lemma comb_fst {X Y} {lx : Lin R X} {ly : Lin R Y} u (xs : list (X * Y)) : fst (comb u xs) = comb u (map fst xs).
Proof. apply comb_linear. repeat split. Qed.
Lemma comb_snd {X Y} {lx : Lin R X} {ly : Lin R Y} u (xs : list (X * Y)) : snd (comb u xs) = comb u (map snd xs).
Proof. apply comb_linear. repeat split. Qed.
Lemma comb_pair {X Y} {lx : Lin R X} {ly : Lin R Y} u (xs : list (X * Y)) :
  comb u xs = (comb u (map fst xs), comb u (map snd xs)).
Proof. rewrite <- comb_fst, <- comb_snd. apply surjective_pairing. Qed.

Section Combinations.
Context {E : Type} `{Euclid E}.
Implicit Types (u : list R) (xs : list E).

Lemma dot_linear (z : E) : linear (fun x => dot x z).
Proof. repeat split; intros; autorewrite with dots; reflexivity. Qed.
Lemma dot_comb u xs z : dot (comb u xs) z = comb u (map (fun x => dot x z) xs).
Proof. apply (comb_linear _ u xs (dot_linear z)). Qed.
Lemma comb_cons a u x xs : comb (a :: u) (x :: xs) = (a *: x + comb u xs)%V.
Proof. reflexivity. Qed.
Lemma comb_scale s u xs : comb (map (Rmult s) u) xs = (s *: comb u xs)%V.
Proof.
  revert xs; induction u as [|a u IH]; intros [|x xs]; cbn; try vec_ring. rewrite IH. vec_ring.
Qed.
Lemma comb_app u v xs ys : length u = length xs -> comb (u ++ v) (xs ++ ys) = (comb u xs + comb v ys)%V.
Proof.
  revert xs; induction u as [|a u IH]; intros [|x xs] L; try discriminate; cbn; [vec_ring|].
  rewrite IH by auto. vec_ring.
Qed.
(* The same vector added to all, or taken from all. *)
Lemma comb_shift u xs c : length u = length xs ->
  comb u (map (fun x => x + c)%V xs) = (comb u xs + sum u *: c)%V.
Proof.
  revert xs; induction u as [|a u IH]; intros [|x xs] L; try discriminate; cbn; [vec_ring|].
  rewrite IH by auto. fold (sum u). vec_ring.
Qed.
Lemma comb_shift_convex u xs c : convex (length xs) u ->
  comb u (map (fun x => x + c)%V xs) = (comb u xs + c)%V.
Proof. intros (L & _ & S). rewrite comb_shift, S by auto. vec_ring. Qed.
Lemma comb_map_scale u xs s : comb u (map (lscale s) xs) = (s *: comb u xs)%V.
Proof. symmetry. apply comb_linear. repeat split; intros; vec_ring. Qed.
Lemma comb_same u (x : E) n : length u = n -> comb u (repeat x n) = (sum u *: x)%V.
Proof.
  revert n; induction u as [|a u IH]; intros n <-; cbn; [vec_ring|]. rewrite IH by auto. fold (sum u). vec_ring.
Qed.
End Combinations.

Lemma comb_ones u n : length u = n -> comb u (repeat 1 n) = sum u.
Proof. intros L. rewrite (comb_same u 1 n L). vunfold. ring. Qed.
(* Numbers that are all at least m combine to at least m times the sum of the coefficients. *)
Lemma comb_at_least m u (ys : list R) : length u = length ys -> Forall (Rle 0) u -> Forall (Rle m) ys ->
  m * sum u <= comb u ys.
Proof.
  intros L U; revert ys L; induction U as [|a u A U IH]; intros [|y ys] L Y; try discriminate; cbn; [lra|].
  apply Forall_cons_iff in Y as [Y Ys]. specialize (IH ys ltac:(auto) ltac:(auto)). fold (sum u). nra.
Qed.
Lemma comb_at_most m u (ys : list R) : length u = length ys -> Forall (Rle 0) u -> Forall (fun y => y <= m) ys ->
  comb u ys <= m * sum u.
Proof.
  intros L U; revert ys L; induction U as [|a u A U IH]; intros [|y ys] L Y; try discriminate; cbn; [lra|].
  apply Forall_cons_iff in Y as [Y Ys]. specialize (IH ys ltac:(auto) ltac:(auto)). fold (sum u). nra.
Qed.
Lemma comb_positive u (ys : list R) : length u = length ys -> Forall (Rle 0) u -> 0 < sum u -> Forall (Rlt 0) ys ->
  0 < comb u ys.
Proof.
  intros L U; revert ys L; induction U as [|a u A U IH]; intros [|y ys] L S Y; try discriminate; cbn in *; [lra|].
  apply Forall_cons_iff in Y as [Y Ys]. fold (sum u) in *.
  assert (G : 0 <= comb u ys).
  { replace 0 with (0 * sum u) by ring. apply comb_at_least; auto. eapply Forall_impl; [|eassumption]. intros; now left. }
  destruct (Rle_lt_or_eq_dec 0 a A) as [P|Z]; [nra|]. subst a. rewrite Rplus_0_l in S.
  specialize (IH ys ltac:(auto) S Ys). lra.
Qed.

(* --- Convex sets and hulls --- *)

Definition convex_set {E} {l : Lin R E} (K : E -> Prop) :=
  forall t x y, 0 <= t <= 1 -> K x -> K y -> K (t *: x + (1 - t) *: y)%V.

(* x is a convex combination of the points. *)
Definition in_hull {E} {l : Lin R E} (ps : list E) (x : E) := exists u, convex (length ps) u /\ x = comb u ps.

Lemma convex_set_comb {E} `{Euclid E} (K : E -> Prop) u ps :
  convex_set K -> convex (length ps) u -> Forall K ps -> K (comb u ps).
Proof.
  intros C (L & P & S) F.
  assert (G : forall u ps, length u = length ps -> Forall (Rle 0) u -> Forall K ps ->
    0 < sum u -> K (/ sum u *: comb u ps)%V).
  { clear - H C. induction u as [|a u IH]; intros [|p ps] L P F S; try discriminate; [cbn in S; lra|].
    apply Forall_cons_iff in P as [A P]. apply Forall_cons_iff in F as [X F]. rewrite sum_cons in *.
    pose proof (sum_nonneg u P) as N.
    destruct (Rle_lt_or_eq_dec _ _ N) as [B|Z].
    - specialize (IH ps ltac:(auto) ltac:(auto) ltac:(auto) B).
      replace (/ (a + sum u) *: comb (a :: u) (p :: ps))%V with
        ((a / (a + sum u)) *: p + (1 - a / (a + sum u)) *: (/ sum u *: comb u ps))%V
        by (rewrite comb_cons; vec_field; split; lra).
      apply C; auto. split; [apply Rmult_le_pos; auto; left; apply inv_pos; lra|].
      apply Rmult_le_reg_r with (a + sum u); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
    - assert (comb u ps = lzero) as U.
      { clear - H Z P. revert ps; induction P as [|b u B U IH]; intros [|p ps]; try reflexivity.
        rewrite sum_cons in Z. pose proof (sum_nonneg u U). cbn. rewrite IH by lra.
        replace b with 0 by lra. vec_ring. }
      rewrite <- Z in *. replace (/ (a + 0) *: comb (a :: u) (p :: ps))%V with p; auto.
      rewrite comb_cons, U. vec_field. lra. }
  specialize (G u ps L P F). rewrite S in G. replace (comb u ps) with (/ 1 *: comb u ps)%V by (vec_field). apply G; lra.
Qed.

Lemma hull_in_convex_set {E} `{Euclid E} (K : E -> Prop) ps x : convex_set K -> Forall K ps -> in_hull ps x -> K x.
Proof. intros C F (u & U & ->). now apply convex_set_comb. Qed.

(* The points are in their hull, which is convex. *)
Lemma hull_point {E} `{Euclid E} (ns : list E) n : In n ns -> in_hull ns n.
Proof.
  intros I. destruct (in_split _ _ I) as (l1 & l2 & ->). exists (repeat 0 (length l1) ++ 1 :: repeat 0 (length l2)).
  assert (Z : forall n, Forall (Rle 0) (repeat 0 n)) by (intro k; apply Forall_forall; intros x X; apply repeat_spec in X; lra).
  assert (S : forall n, sum (repeat 0 n) = 0) by (induction n0; cbn; [reflexivity|]; unfold sum in *; lra).
  assert (C : forall xs : list E, comb (repeat 0 (length xs)) xs = lzero).
  { induction xs as [|x xs IH]; cbn; [reflexivity|]. rewrite IH. vec_ring. }
  split; [split; [|split]|].
  - rewrite !app_length. cbn. now rewrite !repeat_length.
  - apply Forall_app. split; [apply Z|]. constructor; [lra|apply Z].
  - rewrite sum_app, sum_cons, !S. ring.
  - rewrite comb_app by apply repeat_length. cbn [comb]. rewrite !C. vec_ring.
Qed.
Lemma hull_convex {E} `{Euclid E} (ns : list E) : convex_set (in_hull ns).
Proof.
  intros t x y T (u & (Lu & Pu & Su) & ->) (v & (Lv & Pv & Sv) & ->).
  exists (map (fun p => t * fst p + (1 - t) * snd p) (combine u v)).
  assert (G : forall ns u v, length u = length ns -> length v = length ns -> Forall (Rle 0) u -> Forall (Rle 0) v ->
    let w := map (fun p => t * fst p + (1 - t) * snd p) (combine u v) in
    length w = length ns /\ Forall (Rle 0) w /\ sum w = t * sum u + (1 - t) * sum v /\
    comb w ns = (t *: comb u ns + (1 - t) *: comb v ns)%V).
  { clear - H T. induction ns as [|n ns IH]; intros [|a u] [|b v] Lu Lv Pu Pv; try discriminate.
    - cbn. repeat split; auto; [ring|vec_ring].
    - apply Forall_cons_iff in Pu as [A Pu], Pv as [B Pv].
      destruct (IH u v) as (L & P & S & C); auto. cbn [combine map comb length fst snd]. rewrite !sum_cons.
      split; [now rewrite L|]. split; [constructor; auto; nra|]. split; [rewrite S; ring|]. rewrite C. vec_ring. }
  destruct (G ns u v Lu Lv Pu Pv) as (L & P & S & C). rewrite C. repeat split; auto. rewrite S, Su, Sv. ring.
Qed.

Lemma ball_convex {E} `{Euclid E} (b : ball E) : convex_set (in_ball b).
Proof.
  intros t x y T X Y. unfold in_ball in *.
  replace (t *: x + (1 - t) *: y - center b)%V with (t *: (x - center b) + (1 - t) *: (y - center b))%V by vec_ring.
  eapply Rle_trans; [apply norm_add|]. rewrite !norm_scale by lra. nra.
Qed.

(* --- Convex cones --- *)

Record cone {X : Type} {l : Lin R X} (C : X -> Prop) : Prop := {
  cone_zero : C lzero;
  cone_add : forall x y, C x -> C y -> C (x + y)%V;
  cone_scale : forall a x, 0 <= a -> C x -> C (a *: x)%V }.

Lemma comb_in_cone {X} {l : Lin R X} (C : X -> Prop) u xs :
  cone C -> Forall (Rle 0) u -> Forall C xs -> C (comb u xs).
Proof.
  intros [Z A S] Hu; revert xs; induction Hu as [|a u Ha Hu IH]; intros xs Hx; [exact Z|].
  destruct Hx as [|x xs Hx Hxs]; [exact Z|]. cbn; auto.
Qed.

(* (1, x_k) for the x_k: a combination of them knows the sum of its coefficients. *)
Definition with_one {X} (xs : list X) : list (R * X) := map (fun x => (1, x)) xs.
Lemma comb_with_one {X} {l : Lin R X} u (xs : list X) :
  convex (length xs) u -> comb u (with_one xs) = (1, comb u xs).
Proof.
  intros (L & _ & S). rewrite <- S. clear S. revert xs L; induction u as [|a u IH]; intros [|x xs] L; try discriminate.
  - reflexivity.
  - cbn. unfold with_one in IH. rewrite IH by auto. cbn. now rewrite Rmult_1_r.
Qed.
