(* SPDX-License-Identifier: MIT *)
(* Lemma 1: the two definitions of a cap are the same. Section 4.3 and appendix of the paper. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.cap.

(* --- Statements --- *)

(* The surface has a point in the half-space. *)
Definition meets {E} `{Euclid E} (c : E) (r : R) (d : E) (D : R) := exists x, on_surface c r x /\ in_half_space d D x.

(* (i) -> (ii): what surface and half-space have in common is exactly the cap with apex c + s d and
   cos alpha = max(-1, s (D - (c, d)) / r^2), where s > 0 and ||s d|| = r. It is the cosine of an angle. *)
Definition half_space_is_cap_repaired : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c d : E) (r D s : R), d <> lzero -> 0 < r -> meets c r d D ->
  0 < s -> norm (s *: d) = r ->
  let t := Rmax (-1) (s * (D - dot c d) / (r * r)) in
  -1 <= t <= 1 /\ norm (c + s *: d - c) = r /\
  forall x, (on_surface c r x /\ in_half_space d D x) <-> in_cap c (c + s *: d) t x.

(* There is such an s. *)
Definition scale_exists : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (d : E) (r : R), d <> lzero -> 0 < r -> exists s, 0 < s /\ norm (s *: d) = r.

(* (ii) -> (i): the half-space with d = a - c and D = r^2 cos alpha + (c, d) meets the surface and has exactly the cap in
   common with it. *)
Definition cap_is_half_space_repaired : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (c a : E) (t : R), a <> c -> t <= 1 ->
  let d := (a - c)%V in let r := norm (a - c) in let D := r * r * t + dot c d in
  d <> lzero /\ meets c r d D /\
  forall x, in_cap c a t x <-> (on_surface c r x /\ in_half_space d D x).

(* Printed: some d in R^n may be multiplied by a scalar to reach the surface. It may be 0. *)
Definition scale_exists_printed (E : Type) `{Euclid E} : Prop :=
  forall (c d : E) (r D : R), 0 < r -> meets c r d D -> exists k, k <> 0 /\ norm (k *: d) = r.
(* Printed: by any non-zero scalar. A negative one turns the half-space round. *)
Definition any_scalar_printed (E : Type) `{Euclid E} : Prop :=
  forall (c d : E) (r D k : R), 0 < r -> meets c r d D -> k <> 0 -> norm (k *: d) = r ->
  forall x, on_surface c r x -> (in_half_space d D x <-> k * (D - dot c d) <= dot (x - c) (k *: d)).
(* Printed: the plane of a half-space that meets the surface is at most r from the center, so that there is an angle. *)
Definition has_angle_printed (E : Type) `{Euclid E} : Prop :=
  forall (c d : E) (r D k : R), 0 < r -> meets c r d D -> 0 < k -> norm (k *: d) = r ->
  -(r * r) <= k * (D - dot c d) <= r * r.
(* All three are false in every space that is not a single point. *)
Definition somewhere (statement : forall E (l : Lin R E), Euclid E -> Prop) : Prop :=
  exists E (l : Lin R E) (e : Euclid E), (exists a : E, a <> lzero) /\ statement E l e.
Definition scale_exists_printed_somewhere := somewhere (@scale_exists_printed).
Definition any_scalar_printed_somewhere := somewhere (@any_scalar_printed).
Definition has_angle_printed_somewhere := somewhere (@has_angle_printed).

(* --- Proofs --- *)

Lemma half_space_from_center {E} `{Euclid E} (c d x : E) (D s : R) : 0 < s ->
  D <= dot x d <-> s * (D - dot c d) <= dot (x - c) (s *: d).
Proof.
  intros S. replace (dot (x - c) (s *: d)) with (s * (dot x d - dot c d)) by (dots; ring).
  split; intros A; [apply Rmult_le_compat_l; lra|]. apply Rmult_le_reg_l in A; lra.
Qed.

Lemma on_surface_norm2 {E} `{Euclid E} (c x : E) r : 0 < r -> on_surface c r x <-> norm2 (x - c) = r * r.
Proof.
  intros P. unfold on_surface. split; [intros <-; symmetry; apply norm_sq|]. intros Q. apply norm_eq; lra.
Qed.

(* The right side is between -r^2 and r^2. *)
Lemma dot_on_surface {E} `{Euclid E} (c a x : E) r : norm (x - c) = r -> norm (a - c) = r ->
  -(r * r) <= dot (x - c) (a - c) <= r * r.
Proof.
  intros X A. pose proof (dot_le_norms (x - c)%V (a - c)%V). pose proof (dot_ge_norms (x - c)%V (a - c)%V).
  rewrite X, A in *. lra.
Qed.

Lemma add_sub {E} `{Euclid E} (c d : E) : (c + d - c)%V = d.
Proof. vec_ring. Qed.

(* Below -r^2 the offset may be raised to it. *)
Lemma raised_offset (q n y : R) : 0 < n -> - n <= y -> (Rmax (-1) (q / n) * n <= y <-> q <= y).
Proof.
  intros N Y. assert (Q : q / n * n = q) by (field; lra).
  unfold Rmax. destruct (Rle_dec (-1) (q / n)) as [A|A]; [rewrite Q; tauto|].
  assert (q / n * n <= -1 * n) by (apply Rmult_le_compat_r; lra). rewrite Q in *. split; lra.
Qed.

Theorem half_space_is_cap_repaired_holds : half_space_is_cap_repaired.
Proof.
  intros E l e c d r D s N P (y & Y & YH) S A t.
  assert (A' : norm (c + s *: d - c) = r) by (now rewrite add_sub).
  assert (R2 : 0 < r * r) by nra.
  assert (B : forall x, on_surface c r x -> -(r * r) <= dot (x - c) (s *: d) <= r * r).
  { intros x X. pose proof (dot_on_surface c (c + s *: d)%V x r X A') as B. now rewrite add_sub in B. }
  assert (I : forall x, on_surface c r x -> (in_half_space d D x <-> t * (r * r) <= dot (x - c) (s *: d))).
  { intros x X. unfold in_half_space. rewrite (half_space_from_center c d x D s S). unfold t. symmetry.
    apply raised_offset; auto. apply B, X. }
  split; [split; [apply Rmax_l|]|split; [exact A'|]].
  - apply Rmult_le_reg_r with (1 := R2). apply (I y Y) in YH. specialize (B y Y). lra.
  - intros x. unfold in_cap. rewrite <- (norm_sq (c + s *: d - c)%V), A', add_sub, <- (on_surface_norm2 c x r P).
    split; intros [X XH]; split; auto; now apply (I x X).
Qed.

Theorem scale_exists_holds : scale_exists.
Proof.
  intros E l e d r N P. pose proof (norm_pos d N) as D. exists (r / norm d).
  assert (0 < r / norm d) by (apply Rmult_lt_0_compat; auto using inv_pos).
  split; auto. rewrite norm_scale by lra. field. lra.
Qed.

Theorem cap_is_half_space_repaired_holds : cap_is_half_space_repaired.
Proof.
  intros E l e c a t N T d r D.
  assert (Nd : d <> lzero).
  { intros Z. apply N. apply dot_ext. intros z. pose proof (f_equal (fun y => dot y z) Z) as G. cbv beta in G.
    unfold d in G. autorewrite with dots in G. lra. }
  assert (P : 0 < r) by (apply norm_pos; exact Nd).
  assert (Q : norm2 d = r * r) by (symmetry; apply norm_sq).
  assert (I : forall x, in_half_space d D x <-> t * norm2 (a - c) <= dot (x - c) (a - c)).
  { intros x. fold d. rewrite Q. unfold in_half_space, D. rewrite dot_sub_l. split; lra. }
  split; [exact Nd|]. split.
  - exists a. split; [reflexivity|]. apply I. fold d. change (dot d d) with (norm2 d). pose proof (norm2_nonneg d). nra.
  - intros x. unfold in_cap. rewrite I, (on_surface_norm2 c x r P), <- Q. tauto.
Qed.

Lemma unit_vector {E} `{Euclid E} : (exists a : E, a <> lzero) -> exists n : E, norm2 n = 1.
Proof.
  intros (a & N). pose proof (norm_pos a N) as P. exists (/ norm a *: a)%V.
  rewrite norm2_scale, <- norm_sq. field. lra.
Qed.

(* d = 0: {x : 0 <= 0} is all of the space, and no scalar stretches 0. *)
Theorem scale_exists_printed_is_false : ~ scale_exists_printed_somewhere.
Proof.
  intros (E & l & e & A & S). destruct (unit_vector A) as (n & U). specialize (S lzero lzero 1 0).
  destruct S as (k & _ & K).
  - lra.
  - exists n. unfold on_surface, in_half_space. replace (n - lzero)%V with n by vec_ring. rewrite dot_zero_r.
    split; [now apply norm_unit|lra].
  - replace (k *: lzero)%V with (lzero : E) in K by vec_ring. rewrite norm_zero in K. lra.
Qed.

(* The scalar -1 turns x >= 0 into x <= 0. *)
Theorem any_scalar_printed_is_false : ~ any_scalar_printed_somewhere.
Proof.
  intros (E & l & e & A & S). destruct (unit_vector A) as (n & U).
  assert (O : forall x : E, norm2 x = 1 -> on_surface lzero 1 x).
  { intros x X. unfold on_surface. replace (x - lzero)%V with x by vec_ring. now apply norm_unit. }
  destruct (fun P1 P2 P3 P4 => S lzero n 1 0 (-1) P1 P2 P3 P4 n (O n U)) as [B _].
  - lra.
  - exists n. split; auto. unfold in_half_space. change (dot n n) with (norm2 n). lra.
  - lra.
  - apply norm_unit. rewrite norm2_scale, U. ring.
  - assert (C : in_half_space n 0 n) by (unfold in_half_space; change (dot n n) with (norm2 n); lra).
    apply B in C. autorewrite with dots in C. change (dot n n) with (norm2 n) in C. lra.
Qed.

(* x >= -2 holds the whole unit sphere, and no angle has the cosine -2. *)
Theorem has_angle_printed_is_false : ~ has_angle_printed_somewhere.
Proof.
  intros (E & l & e & A & S). destruct (unit_vector A) as (n & U). specialize (S lzero n 1 (-2) 1).
  rewrite dot_zero_l in S. destruct S as [B _]; [lra| |lra| |lra].
  - exists n. unfold on_surface, in_half_space. replace (n - lzero)%V with n by vec_ring.
    split; [now apply norm_unit|]. change (dot n n) with (norm2 n). lra.
  - apply norm_unit. rewrite norm2_scale, U. ring.
Qed.

(* The hypotheses can be met: the right half of the unit circle; a cap with cos alpha = 3/5. *)
Example half_space_instance : ((1, 0) : plane) <> lzero /\ meets (0, 0) 1 (1, 0) 0 /\ norm (1 *: ((1, 0) : plane))%V = 1.
Proof.
  split; [|split].
  - intros Z. apply (f_equal fst) in Z. vunfold. lra.
  - exists (1, 0). split; [apply norm_unit|unfold in_half_space]; vunfold; lra.
  - apply norm_unit. vunfold. ring.
Qed.
Example cap_instance : ((1, 0) : plane) <> (0, 0) /\ 3 / 5 <= 1.
Proof. split; [|lra]. intros Z. apply (f_equal fst) in Z. cbn in Z. lra. Qed.
