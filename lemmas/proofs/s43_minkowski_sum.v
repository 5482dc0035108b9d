(* SPDX-License-Identifier: MIT *)
(* Section 4.3, turning a ball is turning its center: Q_w(S - r_c) = Q_w(p - r_c) (+) [0, r], a Minkowski sum. It holds as
   printed, for blends that are not 0. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.quaternion.

(* --- Statement --- *)

(* {R_q(v - c) : v in S} = {R_q(p - c) + y : ||y|| <= r} for the ball S = [p, r]. *)
Definition minkowski_sum_printed : Prop :=
  forall (q : quat R) (p c x : vec R) (r : R), q <> lzero ->
  ((exists v, in_ball (Ball p r) v /\ x = rotate q (v - c)) <->
   (exists y, norm y <= r /\ x = (rotate q (p - c) + y)%V)).

(* --- Proof --- *)

Lemma rotate_conj_norm (q : quat R) y : q <> lzero -> norm (rotate (conj q) y) = norm y.
Proof.
  intros N. apply rotate_norm. intros Z. apply N. apply norm2_zero_inv. rewrite <- norm2_conj, Z. apply norm2_zero.
Qed.

Theorem minkowski_sum_holds : minkowski_sum_printed.
Proof.
  intros q p c x r N. unfold in_ball. cbn [center radius]. split.
  - intros (v & V & ->). exists (rotate q (v - p)). split; [now rewrite rotate_norm|].
    rewrite <- rotate_add. f_equal. vec_ring.
  - intros (y & Y & ->). exists (p + rotate (conj q) y)%V. split.
    + replace (p + rotate (conj q) y - p)%V with (rotate (conj q) y) by vec_ring. now rewrite rotate_conj_norm.
    + replace (p + rotate (conj q) y - c)%V with ((p - c) + rotate (conj q) y)%V by vec_ring.
      now rewrite rotate_add, rotate_conj.
Qed.

(* The hypothesis can be met: half a turn. *)
Example minkowski_instance : Quat 0 1 0 0 <> lzero.
Proof. apply norm2_pos_inv. vunfold. lra. Qed.
