(* SPDX-License-Identifier: MIT *)
(* The rule of Leibniz for bounds: of a product whose length is at most that of its factors. Quaternions are an instance. *)
From Coq Require Import Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.quaternion.

(* x, x', x'' are no longer than s, s', s''. *)
Definition moves_within {E} `{Euclid E} (x x' x'' : E) (s s' s'' : R) := norm x <= s /\ norm x' <= s' /\ norm x'' <= s''.
Definition short_product {X Y Z} `{Euclid X} `{Euclid Y} `{Euclid Z} (B : X -> Y -> Z) :=
  forall x y, norm (B x y) <= norm x * norm y.

(* --- Statements --- *)

(* What a product's derivatives are by the rule of Leibniz moves within the product of the bounds. *)
Definition product_moves : Prop := forall X Y Z (lx : Lin R X) (ly : Lin R Y) (lz : Lin R Z) (ex : Euclid X) (ey : Euclid Y)
  (ez : Euclid Z) (B : X -> Y -> Z) (x x' x'' : X) (y y' y'' : Y) (s s' s'' t t' t'' : R),
  short_product B -> moves_within x x' x'' s s' s'' -> moves_within y y' y'' t t' t'' ->
  moves_within (B x y) (B x' y + B x y')%V (B x'' y + 2 *: B x' y' + B x y'')%V
    (s * t) (s' * t + s * t') (s'' * t + 2 * s' * t' + s * t'').
Definition quaternions_are_short : Prop := short_product (fun a b : quat R => qmul a b).
(* A sum moves within the sum. *)
Definition sum_moves : Prop := forall X (lx : Lin R X) (ex : Euclid X) (x x' x'' y y' y'' : X) (s s' s'' t t' t'' : R),
  moves_within x x' x'' s s' s'' -> moves_within y y' y'' t t' t'' ->
  moves_within (x + y)%V (x' + y')%V (x'' + y'')%V (s + t) (s' + t') (s'' + t'').

(* --- Proofs --- *)

Lemma short_product_at_most {X Y Z} `{Euclid X} `{Euclid Y} `{Euclid Z} (B : X -> Y -> Z) x y (s t : R) :
  short_product B -> norm x <= s -> norm y <= t -> norm (B x y) <= s * t.
Proof.
  intros Sh S T. eapply Rle_trans; [apply Sh|]. pose proof (norm_nonneg x). pose proof (norm_nonneg y).
  apply Rmult_le_compat; lra.
Qed.

Theorem product_moves_holds : product_moves.
Proof.
  intros X Y Z lx ly lz ex ey ez B x x' x'' y y' y'' s s' s'' t t' t'' Sh (S0 & S1 & S2) (T0 & T1 & T2).
  pose proof (fun a b k l => short_product_at_most B a b k l Sh) as P. split; [|split]; [auto| |].
  - eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; auto.
  - eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; auto.
    eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; auto. rewrite norm_scale by lra.
    pose proof (P x' y' s' t' S1 T1). lra.
Qed.

Theorem quaternions_are_short_holds : quaternions_are_short.
Proof.
  intros a b. apply Req_le. apply norm_eq; [apply Rmult_le_pos; apply norm_nonneg|].
  replace (norm a * norm b * (norm a * norm b)) with (norm a * norm a * (norm b * norm b)) by ring.
  rewrite (norm_sq a), (norm_sq b). clear. vring.
Qed.

Theorem sum_moves_holds : sum_moves.
Proof.
  intros X lx ex x x' x'' y y' y'' s s' s'' t t' t'' (S0 & S1 & S2) (T0 & T1 & T2).
  split; [|split]; (eapply Rle_trans; [apply norm_add|]); lra.
Qed.

(* The hypotheses can be met: a quaternion that turns at the speed 1. *)
Example motion_instance : moves_within (Quat 1 0 0 0) (Quat 0 0 0 1) (Quat (-1) 0 0 0) 1 1 1.
Proof. split; [|split]; apply Req_le, norm_eq; vunfold; lra. Qed.
