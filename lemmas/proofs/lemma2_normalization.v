(* SPDX-License-Identifier: MIT *)
(* Lemma 2: normalising the generators keeps the directions, and so the rotations, of a convex hull. Appendix of the
   paper; section 4.3 and line 9 of Algorithm 1. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Import ListNotations.

(* --- Statements --- *)

(* The vectors q_i / f_i. *)
Definition divided {E} `{Euclid E} (fs : list R) (qs : list E) : list E :=
  map (fun fq => (/ fst fq *: snd fq)%V) (combine fs qs).

(* For every w in W_m there are u in W_m and k > 0 with k sum u_i q_i / f_i = sum w_i q_i. *)
Definition same_rays_there : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (fs : list R) (qs : list E) (w : list R),
  length fs = length qs -> Forall (Rlt 0) fs -> convex (length qs) w ->
  exists u k, convex (length qs) u /\ 0 < k /\ (k *: comb u (divided fs qs))%V = comb w qs.
(* The same the other way round. *)
Definition same_rays_back : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (fs : list R) (qs : list E) (w : list R),
  length fs = length qs -> Forall (Rlt 0) fs -> convex (length qs) w ->
  exists u k, convex (length qs) u /\ 0 < k /\ (k *: comb u qs)%V = comb w (divided fs qs).
(* The one hull holds 0 if and only if the other does. *)
Definition zero_together : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (fs : list R) (qs : list E),
  length fs = length qs -> Forall (Rlt 0) fs -> (in_hull qs lzero <-> in_hull (divided fs qs) lzero).
(* In R^4 each element of the hull that is not 0 is the same rotation as an element of the other: of the unit
   quaternions q_i / ||q_i||. *)
Definition same_rotations_repaired : Prop :=
  forall (qs : list (quat R)) (q : quat R), Forall (fun q => q <> lzero) qs -> in_hull qs q -> q <> lzero ->
  Forall (fun n => norm2 n = 1) (divided (map norm qs) qs) /\
  exists p, in_hull (divided (map norm qs) qs) p /\ p <> lzero /\ forall x, rotate p x = rotate q x.

(* Printed: every element of the hull is a rotation that the normalised hull has too. It may be 0, which is none. *)
Definition same_rotations_printed : Prop :=
  forall (qs : list (quat R)) (q : quat R), Forall (fun q => q <> lzero) qs -> in_hull qs q -> q <> lzero.

(* --- Proofs --- *)

Lemma divided_length {E} `{Euclid E} fs (qs : list E) : length fs = length qs -> length (divided fs qs) = length qs.
Proof. intros L. unfold divided. rewrite map_length, combine_length, L. apply Nat.min_id. Qed.

(* sum w_i f_i p_i with p_i = q_i / f_i *)
Lemma comb_divided {E} `{Euclid E} fs (qs : list E) w : length fs = length qs -> Forall (Rlt 0) fs ->
  comb (map (fun p => fst p * snd p) (combine w fs)) (divided fs qs) = comb w qs.
Proof.
  intros L F; revert qs L w; induction F as [|f fs P F IH]; intros [|q qs] L [|a w]; try discriminate; try reflexivity.
  unfold divided in *. cbn [combine map fst snd comb]. rewrite IH by auto. vec_field. lra.
Qed.
Lemma comb_multiplied {E} `{Euclid E} fs (qs : list E) w : length fs = length qs ->
  comb (map (fun p => snd p * fst p) (combine fs w)) qs =
  comb w (map (fun fq => (fst fq *: snd fq)%V) (combine fs qs)).
Proof.
  revert qs w; induction fs as [|f fs IH]; intros [|q qs] [|a w] L; try discriminate; try reflexivity.
  cbn [combine map fst snd comb]. rewrite IH by auto. vec_ring.
Qed.

(* w_i f_i / k with k = sum w_j f_j is convex again. *)
Lemma reweighted (w fs : list R) : length fs = length w -> Forall (Rlt 0) fs -> Forall (Rle 0) w -> sum w = 1 ->
  let v := map (fun p => fst p * snd p) (combine w fs) in
  0 < sum v /\ convex (length w) (map (Rmult (/ sum v)) v).
Proof.
  intros L F W S v.
  assert (V : sum v = comb w fs).
  { unfold v. clear. revert fs; induction w as [|a w IH]; intros [|f fs]; try reflexivity.
    cbn [combine map comb]. rewrite sum_cons, IH. reflexivity. }
  assert (P : 0 < sum v) by (rewrite V; apply comb_positive; auto; lra).
  split; [exact P|]. split; [|split].
  - unfold v. rewrite !map_length, combine_length, L. apply Nat.min_id.
  - apply scale_nonneg; [left; now apply inv_pos|]. unfold v. apply Forall_map, Forall_forall. intros [a f] I.
    apply Rmult_le_pos; cbn.
    + rewrite Forall_forall in W. apply W. eapply in_combine_l, I.
    + rewrite Forall_forall in F. left. apply F. eapply in_combine_r, I.
  - rewrite sum_scale. apply Rinv_l. lra.
Qed.

Theorem same_rays_there_holds : same_rays_there.
Proof.
  intros E l e fs qs w L F (Lw & W & S). destruct (reweighted w fs) as [P C]; auto; [congruence|].
  set (v := map _ (combine w fs)) in *. exists (map (Rmult (/ sum v)) v), (sum v).
  split; [now rewrite <- Lw|]. split; [exact P|].
  rewrite comb_scale. unfold v. rewrite comb_divided by auto. fold v. vec_field. lra.
Qed.

Lemma divided_twice {E} `{Euclid E} fs (qs : list E) : length fs = length qs -> Forall (Rlt 0) fs ->
  divided (map Rinv fs) (divided fs qs) = qs.
Proof.
  intros L F; revert qs L; induction F as [|f fs P F IH]; intros [|q qs] L; try discriminate; [reflexivity|].
  unfold divided in *. cbn. f_equal; auto. vec_field. lra.
Qed.

Theorem same_rays_back_holds : same_rays_back.
Proof.
  intros E l e fs qs w L F C.
  destruct (same_rays_there_holds E l e (map Rinv fs) (divided fs qs) w) as (u & k & U & K & Q).
  - now rewrite map_length, divided_length.
  - apply Forall_map. eapply Forall_impl; [|exact F]. apply inv_pos.
  - now rewrite divided_length.
  - rewrite divided_twice in Q by auto. rewrite divided_length in U by auto. eauto.
Qed.

Lemma scale_to_zero {E} `{Euclid E} k (x : E) : 0 < k -> (k *: x)%V = lzero -> x = lzero.
Proof.
  intros K Z. apply norm2_zero_inv. apply (f_equal norm2) in Z. rewrite norm2_scale, norm2_zero in Z.
  apply Rmult_integral in Z as [Z|Z]; [nra|exact Z].
Qed.

Theorem zero_together_holds : zero_together.
Proof.
  intros E l e fs qs L F. unfold in_hull. rewrite divided_length by auto. split; intros (w & W & Z).
  - destruct (same_rays_there_holds E l e fs qs w L F W) as (u & k & U & K & Q). exists u. split; auto.
    rewrite <- Z in Q. symmetry. now apply scale_to_zero with k.
  - destruct (same_rays_back_holds E l e fs qs w L F W) as (u & k & U & K & Q). exists u. split; auto.
    rewrite <- Z in Q. symmetry. now apply scale_to_zero with k.
Qed.

Lemma unit_direction {E} `{Euclid E} (q : E) : q <> lzero -> norm2 (/ norm q *: q) = 1.
Proof. intros N. apply norm_pos in N. rewrite norm2_scale, <- norm_sq. field. lra. Qed.

Lemma divided_by_norms {E} `{Euclid E} (qs : list E) : divided (map norm qs) qs = map (fun q => (/ norm q *: q)%V) qs.
Proof. unfold divided. induction qs as [|q qs IH]; cbn; [reflexivity|]. now rewrite IH. Qed.

Theorem same_rotations_repaired_holds : same_rotations_repaired.
Proof.
  intros qs q N (w & W & Q) Nq. split.
  - rewrite divided_by_norms. apply Forall_map. eapply Forall_impl; [|exact N]. intros n. apply unit_direction.
  - destruct (same_rays_there_holds _ _ _ (map norm qs) qs w) as (u & k & U & K & P); auto.
    + apply map_length.
    + apply Forall_map. eapply Forall_impl; [|exact N]. intros n. apply norm_pos.
    + exists (comb u (divided (map norm qs) qs)). split.
      { exists u. now rewrite divided_length by apply map_length. }
      assert (M : comb u (divided (map norm qs) qs) <> lzero).
      { intros Z. apply Nq. rewrite Q, <- P, Z. vring. }
      split; [exact M|]. intros x. rewrite Q, <- P. symmetry. apply rotate_of_multiple; auto. lra.
Qed.

(* 1 and -1 blend to 0. *)
Theorem same_rotations_printed_is_false : ~ same_rotations_printed.
Proof.
  intros P. apply (P [Quat 1 0 0 0; Quat (-1) 0 0 0] lzero); [| |reflexivity].
  - repeat constructor; intros Z; apply (f_equal qw) in Z; cbn in Z; vunfold; lra.
  - exists [1 / 2; 1 / 2]. split; [repeat split; [repeat constructor; lra|cbn; lra]|]. cbn. vunfold. f_equal; field.
Qed.

(* The hypotheses can be met: two quaternions of different lengths, half-way. *)
Example rays_instance : Forall (Rlt 0) [1; 2] /\ convex 2 [1 / 2; 1 / 2].
Proof. repeat split; repeat constructor; cbn; lra. Qed.
Example rotations_instance : let qs := [Quat 1 0 0 0; Quat 0 2 0 0] in let q := Quat (1 / 2) 1 0 0 in
  Forall (fun q => q <> lzero) qs /\ in_hull qs q /\ q <> lzero.
Proof.
  split; [|split].
  - repeat constructor; intros Z; [apply (f_equal qw) in Z|apply (f_equal qx) in Z]; cbn in Z; vunfold; lra.
  - exists [1 / 2; 1 / 2]. split; [repeat split; [repeat constructor; lra|cbn; lra]|]. cbn. vunfold. f_equal; field.
  - intros Z. apply (f_equal qx) in Z. cbn in Z. vunfold. lra.
Qed.
