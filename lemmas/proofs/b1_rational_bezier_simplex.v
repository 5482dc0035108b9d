(* SPDX-License-Identifier: MIT *)
(* Beyond the paper: blend skinning is a rational Bezier simplex in the weights. *)
From Coq Require Import List Reals Lra Psatz Lia.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Import ListNotations.

(* --- Multi-indices: those that begin with the first weight vertex, then the others, and so on. Each sorted multi-index
   I comes once, with B_I(u), the product of its u times the number of its orderings. --- *)

Fixpoint bernstein2 (u : list R) : list R :=
  match u with [] => [] | a :: v => a * a :: map (Rmult (2 * a)) v ++ bernstein2 v end.
Fixpoint bernstein3 (u : list R) : list R :=
  match u with
  | [] => []
  | a :: v => a * a * a :: map (Rmult (3 * (a * a))) v ++ map (Rmult (3 * a)) (bernstein2 v) ++ bernstein3 v
  end.
(* f at the weight vertices of each multi-index, in the same order. *)
Fixpoint indices2 {X Y} (f : X -> X -> Y) (xs : list X) : list Y :=
  match xs with [] => [] | x :: ys => f x x :: map (f x) ys ++ indices2 f ys end.
Fixpoint indices3 {X Y} (f : X -> X -> X -> Y) (xs : list X) : list Y :=
  match xs with [] => [] | x :: ys => f x x x :: map (f x x) ys ++ indices2 (f x) ys ++ indices3 f ys end.

(* --- Control points (N_I, W_I) --- *)

(* P_kl = Im(q_k x q_l* + q_l x q_k* ) / 2 *)
Definition mixed (a b : quat R) (x : vec R) : vec R := (1 / 2 *: (turned a x b + turned b x a))%V.
Arguments mixed (a b x)%V.
(* Degree 2: dual quaternions q_k + eps d_k. W_kl = (q_k, q_l), N_kl = P_kl + Im(d_k q_l* + d_l q_k* ). *)
Definition dual_point (p : vec R) (a b : quat R * quat R) : vec R * R :=
  let '(qa, da) := a in let '(qb, db) := b in
  ((mixed qa qb p + (im (qmul da (conj qb)) + im (qmul db (conj qa))))%V, dot qa qb).
(* Degree 3: weight vertices (q'_k, r'_k). W_jkl = (W_jk + W_kl + W_jl) / 3,
   N_jkl = (P_jk + P_kl + P_jl) / 3 + (r'_j W_kl + r'_k W_jl + r'_l W_jk) / 3. *)
Definition spherical_point (x : vec R) (a b c : quat R * vec R) : vec R * R :=
  let '(qa, ra) := a in let '(qb, rb) := b in let '(qc, rc) := c in
  let wab := dot qa qb in let wbc := dot qb qc in let wac := dot qa qc in
  ((1 / 3 *: (mixed qa qb x + mixed qb qc x + mixed qa qc x) + 1 / 3 *: (wbc *: ra + wac *: rb + wab *: rc))%V,
   (wab + wbc + wac) / 3).

(* --- Statements: v'(u) = sum_I B_I(u) N_I / sum_I B_I(u) W_I --- *)

(* Degree 1, linear blending: W_k = 1, N_k = p_k. *)
Definition linear_is_bezier : Prop :=
  forall (u : list R) (ps : list (vec R)), length u = length ps -> sum u = 1 ->
  comb u (map (fun p => (p, 1)) ps) = (comb u ps, 1).
(* Degree 2: numerator and denominator are those of dual quaternion blending. *)
Definition dual_is_bezier : Prop :=
  forall (u : list R) (p : vec R) (weight_vertices : list (quat R * quat R)), length u = length weight_vertices ->
  let q := comb u (map fst weight_vertices) in let d := comb u (map snd weight_vertices) in
  comb (bernstein2 u) (indices2 (dual_point p) weight_vertices) =
  ((turned q p q + 2 *: im (qmul d (conj q)))%V, norm2 q).
(* Degree 3: those of Equation (1), x = p - r_c. *)
Definition spherical_is_bezier : Prop :=
  forall (u : list R) (x : vec R) (weight_vertices : list (quat R * vec R)), length u = length weight_vertices -> sum u = 1 ->
  let q := comb u (map fst weight_vertices) in let r := comb u (map snd weight_vertices) in
  comb (bernstein3 u) (indices3 (spherical_point x) weight_vertices) =
  ((turned q x q + norm2 q *: r)%V, norm2 q).
(* Where the blend is not 0, N / W is what the skinning makes. *)
Definition dual_is_skinning : Prop :=
  forall (u : list R) (p : vec R) (weight_vertices : list (quat R * quat R)), length u = length weight_vertices ->
  comb u (map fst weight_vertices) <> lzero ->
  let '(n, w) := comb (bernstein2 u) (indices2 (dual_point p) weight_vertices) in
  0 < w /\ (/ w *: n)%V = skin_dual (map fst weight_vertices) (map snd weight_vertices) u p.
Definition spherical_is_skinning : Prop :=
  forall (u : list R) (p rotation_center : vec R) (weight_vertices : list (quat R * vec R)),
  length u = length weight_vertices -> sum u = 1 -> comb u (map fst weight_vertices) <> lzero ->
  let '(n, w) := comb (bernstein3 u) (indices3 (spherical_point (p - rotation_center)%V) weight_vertices) in
  0 < w /\ (/ w *: n)%V = skin_spherical (map fst weight_vertices) (map snd weight_vertices) rotation_center u p.
(* The B_I(u) are convex coefficients if the u are. *)
Definition bernstein_is_convex : Prop :=
  forall u m, convex m u ->
  (Forall (Rle 0) (bernstein2 u) /\ sum (bernstein2 u) = 1) /\ (Forall (Rle 0) (bernstein3 u) /\ sum (bernstein3 u) = 1).

(* --- Proofs: symmetric multilinear forms --- *)

Definition bilinear {X Y} {lx : Lin R X} {ly : Lin R Y} (f : X -> X -> Y) :=
  (forall y, linear (fun x => f x y)) /\ (forall x, linear (f x)) /\ (forall x y, f x y = f y x).
Definition trilinear {X Y} {lx : Lin R X} {ly : Lin R Y} (f : X -> X -> X -> Y) :=
  (forall x, bilinear (f x)) /\ (forall x y z, f x y z = f y x z).

Section Forms.
Context {X Y : Type} {lx : Lin R X} {ly : Lin R Y} {ey : Euclid Y}.

Lemma sum2_is_form (f : X -> X -> Y) u xs : bilinear f -> length u = length xs ->
  comb (bernstein2 u) (indices2 f xs) = f (comb u xs) (comb u xs).
Proof.
  intros (L1 & L2 & S). revert xs; induction u as [|a u IH]; intros [|x xs] L; try discriminate.
  - destruct (L2 lzero) as (Z & _). symmetry. exact Z.
  - cbn [bernstein2 indices2 comb]. rewrite comb_app by (now rewrite !map_length; auto).
    rewrite IH by auto. rewrite comb_scale. rewrite <- (comb_linear (f x) u xs (L2 x)).
    set (y := comb u xs). destruct (L1 (a *: x + y)%V) as (_ & A1 & S1). rewrite A1, S1.
    destruct (L2 x) as (_ & A2 & S2). destruct (L2 y) as (_ & A3 & S3). rewrite A2, S2, A3, S3, (S y x). vec_ring.
Qed.

Lemma indices2_length (f : X -> X -> Y) u xs : length u = length xs -> length (bernstein2 u) = length (indices2 f xs).
Proof.
  revert xs; induction u as [|a u IH]; intros [|x xs] L; try discriminate; [reflexivity|].
  cbn [bernstein2 indices2 length]. rewrite !app_length, !map_length, (IH xs) by auto. cbn in L. lia.
Qed.

Lemma sum3_is_form (f : X -> X -> X -> Y) u xs : trilinear f -> length u = length xs ->
  comb (bernstein3 u) (indices3 f xs) = f (comb u xs) (comb u xs) (comb u xs).
Proof.
  intros (B & S). revert xs; induction u as [|a u IH]; intros [|x xs] L; try discriminate.
  - destruct (B lzero) as (_ & L2 & _). destruct (L2 lzero) as (Z & _). symmetry. exact Z.
  - cbn [bernstein3 indices3 comb]. rewrite comb_app by (now rewrite !map_length; auto).
    rewrite comb_app by (rewrite map_length; apply indices2_length; auto).
    rewrite IH, !comb_scale by auto.
    assert (B' := B x). rewrite (sum2_is_form (f x) u xs B') by auto.
    destruct (B x) as (_ & L2x & Sx). rewrite <- (comb_linear (f x x) u xs (L2x x)).
    set (y := comb u xs). destruct (B y) as (_ & L2y & Sy).
    assert (A0 : forall p q, f (a *: x + y)%V p q = (a *: f x p q + f y p q)%V).
    { intros p q. rewrite (S (a *: x + y)%V p q). destruct (B p) as (L1 & _). destruct (L1 q) as (_ & A & M).
      rewrite A, M, (S p x), (S p y). reflexivity. }
    assert (A1 : forall p q, f p (a *: x + y)%V q = (a *: f p x q + f p y q)%V).
    { intros p q. destruct (B p) as (L1 & _). destruct (L1 q) as (_ & A & M). now rewrite A, M. }
    assert (A2 : forall p q, f p q (a *: x + y)%V = (a *: f p q x + f p q y)%V).
    { intros p q. destruct (B p) as (_ & L2 & _). destruct (L2 q) as (_ & A & M). now rewrite A, M. }
    rewrite A0, !A1, !A2. rewrite (Sx y x), (S y x x), (Sx y x), (S y x y), (Sy y x), (S y x y). vec_ring.
Qed.
End Forms.

Ltac vdestruct_pairs := repeat match goal with p : (_ * _)%type |- _ => destruct p end.

(* P is bilinear and symmetric; so the control points are multilinear. *)
Lemma turned_linear_l x b : linear (fun a => turned a x b).
Proof. split; [|split]; vring. Qed.
Lemma turned_linear_r x a : linear (fun b => turned a x b).
Proof. split; [|split]; vring. Qed.
Lemma mixed_swap x a b : mixed a b x = mixed b a x.
Proof. unfold mixed. vec_ring. Qed.
Lemma mixed_linear x a : linear (fun b => mixed a b x).
Proof.
  destruct (turned_linear_l x a) as (Z1 & A1 & S1), (turned_linear_r x a) as (Z2 & A2 & S2).
  unfold mixed. split; [|split]; intros; rewrite ?Z1, ?Z2, ?A1, ?A2, ?S1, ?S2; vec_ring.
Qed.
Lemma mixed_zero x a : mixed a lzero x = lzero.
Proof. destruct (mixed_linear x a) as (Z & _). exact Z. Qed.
Lemma mixed_add x a b c : mixed a (b + c)%V x = (mixed a b x + mixed a c x)%V.
Proof. destruct (mixed_linear x a) as (_ & A & _). apply A. Qed.
Lemma mixed_scale x a s b : mixed a (s *: b)%V x = (s *: mixed a b x)%V.
Proof. destruct (mixed_linear x a) as (_ & _ & S). apply S. Qed.
Lemma mixed_same x q : mixed q q x = turned q x q.
Proof. unfold mixed. vec_field. Qed.

(* Im(d e* ) is linear in d and in e. *)
Lemma dual_part_linear_l e : linear (fun d => im (qmul d (conj e))).
Proof. split; [|split]; vring. Qed.
Lemma dual_part_linear_r d : linear (fun e => im (qmul d (conj e))).
Proof. split; [|split]; vring. Qed.

Lemma pair_equal {X Y} (x1 x2 : X) (y1 y2 : Y) : x1 = x2 -> y1 = y2 -> (x1, y1) = (x2, y2).
Proof. congruence. Qed.

Lemma dual_point_swap p a b : dual_point p a b = dual_point p b a.
Proof.
  destruct a, b. cbv [dual_point]. rewrite mixed_swap, dot_comm. apply pair_equal; [vec_ring|reflexivity].
Qed.
Lemma dual_point_linear p a : linear (dual_point p a).
Proof.
  destruct a as [qa da].
  destruct (dual_part_linear_l qa) as (Z1 & A1 & S1), (dual_part_linear_r da) as (Z2 & A2 & S2).
  split; [|split]; intros; vdestruct_pairs; unfold dual_point; cbn [ladd lscale lzero lin_pair fst snd];
    apply pair_equal; rewrite ?mixed_zero, ?mixed_add, ?mixed_scale, ?Z1, ?Z2, ?A1, ?A2, ?S1, ?S2; try vec_ring;
    dots; reflexivity.
Qed.
Lemma dual_point_bilinear p : bilinear (dual_point p).
Proof.
  split; [|split; [apply dual_point_linear|apply dual_point_swap]].
  intros b. destruct (dual_point_linear p b) as (Z & A & S).
  split; [|split]; intros; rewrite !(dual_point_swap p _ b); auto.
Qed.

(* Degree 3 with a 1 in front of each weight vertex, which takes the place of the quaternion. *)
Definition spherical_form (x : vec R) (a b c : R * (quat R * vec R)) : vec R * R :=
  let '(ha, (qa, ra)) := a in let '(hb, (qb, rb)) := b in let '(hc, (qc, rc)) := c in
  let wab := dot qa qb in let wbc := dot qb qc in let wac := dot qa qc in
  ((1 / 3 *: (hc *: mixed qa qb x + ha *: mixed qb qc x + hb *: mixed qa qc x)
    + 1 / 3 *: (wbc *: ra + wac *: rb + wab *: rc))%V,
   (hc * wab + ha * wbc + hb * wac) / 3).

Lemma spherical_form_swap x a b c : spherical_form x a b c = spherical_form x b a c.
Proof.
  destruct a as [ha [qa ra]], b as [hb [qb rb]], c as [hc [qc rc]]. cbv [spherical_form].
  rewrite (mixed_swap x qb qa), (dot_comm qb qa). apply pair_equal; [vec_ring|field].
Qed.
Lemma spherical_form_swap_last x a b c : spherical_form x a b c = spherical_form x a c b.
Proof.
  destruct a as [ha [qa ra]], b as [hb [qb rb]], c as [hc [qc rc]]. cbv [spherical_form].
  rewrite (mixed_swap x qc qb), (dot_comm qc qb). apply pair_equal; [vec_ring|field].
Qed.
Lemma spherical_form_linear x a b : linear (spherical_form x a b).
Proof.
  destruct a as [ha [qa ra]], b as [hb [qb rb]].
  split; [|split]; intros; vdestruct_pairs; cbv [spherical_form]; cbn [ladd lscale lzero lin_pair fst snd];
    apply pair_equal; rewrite ?mixed_zero, ?mixed_add, ?mixed_scale;
    cbn [lzero ladd lscale lin_num zero add mul ops_R]; try vec_field; dots; field.
Qed.
Lemma spherical_form_trilinear x : trilinear (spherical_form x).
Proof.
  split; [|apply spherical_form_swap]. intros a. split; [|split; [|apply spherical_form_swap_last]].
  - intros c. destruct (spherical_form_linear x a c) as (Z & A & S).
    split; [|split]; intros; rewrite !(spherical_form_swap_last x a _ c); auto.
  - apply spherical_form_linear.
Qed.
Lemma indices2_with_one {X Y} (f : R * X -> R * X -> Y) xs :
  indices2 f (with_one xs) = indices2 (fun a b => f (1, a) (1, b)) xs.
Proof. induction xs as [|x xs IH]; cbn; [reflexivity|]. unfold with_one in *. now rewrite IH, map_map. Qed.
Lemma indices3_with_one {X Y} (f : R * X -> R * X -> R * X -> Y) xs :
  indices3 f (with_one xs) = indices3 (fun a b c => f (1, a) (1, b) (1, c)) xs.
Proof.
  unfold with_one. induction xs as [|x xs IH]; cbn; [reflexivity|]. rewrite IH, map_map.
  change (map (fun x => (1, x)) xs) with (with_one xs). now rewrite indices2_with_one.
Qed.
Lemma indices2_ext {X Y} (f g : X -> X -> Y) xs : (forall a b, f a b = g a b) -> indices2 f xs = indices2 g xs.
Proof. intros E. induction xs as [|x xs IH]; cbn; [reflexivity|]. now rewrite IH, E, (map_ext (f x) (g x)) by auto. Qed.
Lemma indices3_ext {X Y} (f g : X -> X -> X -> Y) xs : (forall a b c, f a b c = g a b c) -> indices3 f xs = indices3 g xs.
Proof.
  intros E. induction xs as [|x xs IH]; cbn; [reflexivity|]. rewrite IH, E.
  rewrite (map_ext (f x x) (g x x)), (indices2_ext (f x) (g x)); auto.
Qed.
Lemma spherical_form_point x a b c : spherical_form x (1, a) (1, b) (1, c) = spherical_point x a b c.
Proof. destruct a, b, c. cbv [spherical_form spherical_point]. apply pair_equal; [vec_ring|field]. Qed.
Lemma comb_with_one_sum {X} {l : Lin R X} u (xs : list X) : length u = length xs -> comb u (with_one xs) = (sum u, comb u xs).
Proof.
  revert xs; induction u as [|a u IH]; intros [|x xs] L; try discriminate; [reflexivity|].
  cbn. unfold with_one in IH. rewrite IH by auto. cbn. now rewrite Rmult_1_r.
Qed.

Theorem linear_is_bezier_holds : linear_is_bezier.
Proof.
  intros u ps L S. rewrite comb_pair, !map_map. cbn [fst snd]. rewrite map_id. apply pair_equal; [reflexivity|].
  replace (map (fun _ => 1) ps) with (repeat 1 (length ps)) by (clear; induction ps; cbn; congruence).
  now rewrite comb_ones.
Qed.

Lemma dual_point_at_blend p q d :
  dual_point p (q, d) (q, d) = ((turned q p q + 2 *: im (qmul d (conj q)))%V, norm2 q).
Proof.
  cbv [dual_point]. rewrite mixed_same. apply pair_equal; [vec_ring|reflexivity].
Qed.
Lemma spherical_point_at_blend x q r :
  spherical_point x (q, r) (q, r) (q, r) = ((turned q x q + norm2 q *: r)%V, norm2 q).
Proof. cbv [spherical_point]. rewrite mixed_same. change (dot q q) with (norm2 q). apply pair_equal; [vec_field|field]. Qed.

Theorem dual_is_bezier_holds : dual_is_bezier.
Proof.
  intros u p weight_vertices L q d. rewrite (sum2_is_form _ _ _ (dual_point_bilinear p) L), comb_pair.
    apply dual_point_at_blend.
Qed.

Theorem spherical_is_bezier_holds : spherical_is_bezier.
Proof.
  intros u x weight_vertices L S q r.
  rewrite <- (indices3_ext _ _ weight_vertices (spherical_form_point x)), <- indices3_with_one.
  rewrite (sum3_is_form _ _ _ (spherical_form_trilinear x)) by (unfold with_one; now rewrite map_length).
  rewrite comb_with_one_sum, S, spherical_form_point, comb_pair by auto. apply spherical_point_at_blend.
Qed.

Theorem dual_is_skinning_holds : dual_is_skinning.
Proof.
  intros u p weight_vertices L N. rewrite dual_is_bezier_holds by auto. cbv zeta. split; [now apply norm2_pos|reflexivity].
Qed.
Theorem spherical_is_skinning_holds : spherical_is_skinning.
Proof.
  intros u p c weight_vertices L S N. rewrite spherical_is_bezier_holds by auto. cbv zeta. apply norm2_pos in N.
  split; [exact N|]. unfold skin_spherical, rotate. set (q := comb u (map fst weight_vertices)) in *.
  revert N. generalize (turned q (p - c) q) (norm2 q) (comb u (map snd weight_vertices)). intros t n r N. vec_field. lra.
Qed.

Lemma bernstein2_nonneg u : Forall (Rle 0) u -> Forall (Rle 0) (bernstein2 u).
Proof.
  induction 1 as [|a u A U IH]; cbn; constructor; [nra|]. apply Forall_app. split; auto. apply scale_nonneg; auto. lra.
Qed.
Lemma bernstein3_nonneg u : Forall (Rle 0) u -> Forall (Rle 0) (bernstein3 u).
Proof.
  induction 1 as [|a u A U IH]; cbn; constructor; [apply Rmult_le_pos; nra|]. rewrite !Forall_app.
  split; [|split]; auto; apply scale_nonneg; auto using bernstein2_nonneg; nra.
Qed.
Lemma sum_bernstein2 u : sum (bernstein2 u) = sum u * sum u.
Proof. induction u as [|a u IH]; cbn [bernstein2]; [cbn; ring|]. rewrite !sum_cons, sum_app, sum_scale, IH. ring. Qed.
Lemma sum_bernstein3 u : sum (bernstein3 u) = sum u * sum u * sum u.
Proof.
  induction u as [|a u IH]; cbn [bernstein3]; [cbn; ring|].
  rewrite !sum_cons, !sum_app, !sum_scale, sum_bernstein2, IH. ring.
Qed.
Theorem bernstein_is_convex_holds : bernstein_is_convex.
Proof.
  intros u m (_ & P & S). rewrite sum_bernstein2, sum_bernstein3, S.
  repeat split; auto using bernstein2_nonneg, bernstein3_nonneg; ring.
Qed.

(* The hypotheses can be met: two weight vertices half-way. *)
Example bezier_instance : let weight_vertices := [(Quat 1 0 0 0, Vec 0 0 0); (Quat (3 / 5) (4 / 5) 0 0, Vec 1 0 0)] in
  let u := [1 / 2; 1 / 2] in length u = length weight_vertices /\ sum u = 1 /\ comb u (map fst weight_vertices) <> lzero.
Proof.
  cbv zeta. split; [reflexivity|]. split; [cbn; field|]. apply norm2_pos_inv. cbn. vunfold. lra.
Qed.
