(* SPDX-License-Identifier: MIT *)
(* Volumes that joints carry, and the radii by which they must grow to hold linearly skinned vertices. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.s44_joint_sets.
Import ListNotations.

(* A joint C, a point p of its volume, no nearer to the vertex than distance_, and by how much the volume grows. *)
Record volume := Volume { joint : rigid; held : vec R; distance_ : R; growth : R }.
Definition is_at (v : vec R) (k : volume) := rotation (joint k) <> lzero /\ norm (v - held k) <= distance_ k.
Definition carried (k : volume) : vec R := apply_rigid (joint k) (held k).
Definition blended (ks : list volume) (w : list R) (v : vec R) : vec R := comb w (map (fun k => apply_rigid (joint k) v) ks).
Definition mean_of (w : list R) (xs : list R) : R := comb w xs.

(* --- Statements --- *)

Definition volumes_hypotheses (ks : list volume) (w : list R) (v : vec R) := convex (length ks) w /\ Forall (is_at v) ks /\
  mean_of w (map distance_ ks) <= mean_of w (map growth ks).
(* The vertex is in the ball of the mean radius about the mean of the carried points. *)
Definition stays_in_mean_ball : Prop := forall ks w v, volumes_hypotheses ks w v ->
  in_ball (Ball (comb w (map carried ks)) (mean_of w (map growth ks))) (blended ks w v).
(* No direction shows it beyond all of the grown volumes. *)
Definition stays_below_reach : Prop := forall ks w v e m, volumes_hypotheses ks w v ->
  Forall (fun k => dot (carried k) e + norm e * growth k <= m) ks -> dot (blended ks w v) e <= m.
(* Volumes that do not grow, as if it were enough that some joint's volume has the vertex. *)
Definition stays_with_its_own_joint : Prop := forall ks w v e m, convex (length ks) w -> Forall (is_at v) ks ->
  Exists (fun k => distance_ k = 0) ks -> Forall (fun k => dot (carried k) e <= m) ks -> dot (blended ks w v) e <= m.

(* --- Proofs --- *)

Lemma strays_by_mean (ks : list volume) (w : list R) (v : vec R) : length w = length ks -> Forall (Rle 0) w ->
  Forall (is_at v) ks -> norm (blended ks w v - comb w (map carried ks)) <= mean_of w (map distance_ ks).
Proof.
  unfold blended, mean_of. revert w. induction ks as [|k ks IH]; intros [|a w] L P F; try discriminate; cbn [map comb].
  - replace (lzero - lzero)%V with (lzero : vec R) by vec_ring. rewrite norm_zero. apply Rle_refl.
  - apply Forall_cons_iff in P as [A P]. apply Forall_cons_iff in F as [[N D] F]. specialize (IH w ltac:(auto) P F).
    unfold carried at 1.
    assert (E : (apply_rigid (joint k) v - apply_rigid (joint k) (held k))%V = rotate (rotation (joint k)) (v - held k))
      by (unfold apply_rigid; rewrite rotate_sub; vec_ring).
    replace (_ - _)%V with (a *: (apply_rigid (joint k) v - apply_rigid (joint k) (held k)) +
      (comb w (map (fun k => apply_rigid (joint k) v) ks) - comb w (map carried ks)))%V by vec_ring.
    rewrite E. eapply Rle_trans; [apply norm_add|]. rewrite norm_scale, rotate_norm by auto.
    apply Rplus_le_compat; [|exact IH]. now apply Rmult_le_compat_l.
Qed.

Theorem stays_in_mean_ball_holds : stays_in_mean_ball.
Proof.
  intros ks w v ((L & P & _) & F & M). unfold in_ball. cbn [center radius].
  eapply Rle_trans; [now apply strays_by_mean|exact M].
Qed.

Lemma mean_reach (ks : list volume) (w : list R) (e : vec R) : length w = length ks ->
  mean_of w (map (fun k => dot (carried k) e + norm e * growth k) ks) =
  dot (comb w (map carried ks)) e + norm e * mean_of w (map growth ks).
Proof.
  unfold mean_of. revert w. induction ks as [|k ks IH]; intros [|a w] L; try discriminate; cbn [map comb].
  - unfold lzero at 1 3. cbn. rewrite ?dot_comm, ?dot_zero_r. cbn. ring.
  - rewrite (IH w) by auto. rewrite !(dot_comm _ e), dot_add_r, dot_scale_r. cbn. ring.
Qed.

Theorem stays_below_reach_holds : stays_below_reach.
Proof.
  intros ks w v e m H F. pose proof (stays_in_mean_ball_holds _ _ _ H) as B. destruct H as ((L & P & S) & _ & _).
  unfold in_ball in B. cbn [center radius] in B.
  pose proof (dot_le_norms (blended ks w v - comb w (map carried ks))%V e) as D.
  assert (U : mean_of w (map (fun k => dot (carried k) e + norm e * growth k) ks) <= m).
  { unfold mean_of. replace m with (m * sum w) by (rewrite S; ring). apply comb_at_most; auto.
    - now rewrite map_length.
    - now apply Forall_map. }
  rewrite mean_reach in U by auto.
  assert (X : dot (blended ks w v - comb w (map carried ks))%V e = dot (blended ks w v) e - dot (comb w (map carried ks)) e).
  { rewrite !(dot_comm _ e), dot_sub_r. reflexivity. }
  rewrite X in D. pose proof (norm_nonneg e) as E.
  assert (norm (blended ks w v - comb w (map carried ks))%V * norm e <= mean_of w (map growth ks) * norm e)
    by now apply Rmult_le_compat_r.
  lra.
Qed.

(* A vertex in the volume of a joint at rest, to three quarters, and of one that comes nearer by 4: it is pulled along by 1. *)
Definition at_rest := Rigid (Quat 1 0 0 0) (Vec 0 0 0).
Definition coming := Rigid (Quat 1 0 0 0) (Vec 4 0 0).
Definition pulled (growth : R) := [Volume at_rest (Vec 0 0 0) 0 growth; Volume coming (Vec (-4) 0 0) 4 growth].

Lemma pulled_is_convex : convex 2 [3 / 4; 1 / 4].
Proof. split; [reflexivity|split; [repeat constructor; lra|cbn; lra]]. Qed.
Lemma pulled_is_at (g : R) : Forall (is_at (Vec 0 0 0)) (pulled g).
Proof.
  apply Forall_cons; [|apply Forall_cons; [|apply Forall_nil]]; unfold is_at; cbn [joint held distance_ rotation at_rest coming];
    (split; [apply norm2_pos_inv; vunfold; lra|apply norm_le; split; [lra|vunfold; lra]]).
Qed.
Lemma pulled_by_one (g : R) : dot (blended (pulled g) [3 / 4; 1 / 4] (Vec 0 0 0)) (Vec 1 0 0) = 1.
Proof. unfold blended, apply_rigid, rotate, turned. cbn. field. Qed.

Theorem stays_with_its_own_joint_is_false : ~ stays_with_its_own_joint.
Proof.
  intros H. specialize (H (pulled 0) [3 / 4; 1 / 4] (Vec 0 0 0) (Vec 1 0 0) 0 pulled_is_convex (pulled_is_at 0)).
  rewrite pulled_by_one in H. enough (1 <= 0) by lra. apply H.
  - now apply Exists_cons_hd.
  - apply Forall_cons; [|apply Forall_cons; [|apply Forall_nil]]; unfold carried, apply_rigid, rotate, turned; cbn; apply Req_le;
      field.
Qed.

(* The hypotheses can be met, and the bound is reached: grown by 1 the volumes reach as far as the vertex. *)
Example volumes_instance : volumes_hypotheses (pulled 1) [3 / 4; 1 / 4] (Vec 0 0 0) /\
  Forall (fun k => dot (carried k) (Vec 1 0 0) + norm (Vec 1 0 0 : vec R) * growth k <= 1) (pulled 1).
Proof.
  split; [split; [exact pulled_is_convex|split; [exact (pulled_is_at 1)|unfold mean_of; cbn; lra]]|].
  assert (N : norm (Vec 1 0 0 : vec R) = 1) by (apply norm_eq; [lra|vunfold; lra]).
  apply Forall_cons; [|apply Forall_cons; [|apply Forall_nil]]; rewrite N; unfold carried, apply_rigid, rotate, turned; cbn;
    apply Req_le; field.
Qed.
