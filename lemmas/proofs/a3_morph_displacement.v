(* SPDX-License-Identifier: MIT *)
(* Vertices displaced by morph targets, in any real inner product space. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex.
Import ListNotations.

(* v_0 + sum m_k d_k, and the ball about c + sum m_k c_k. *)
Definition displaced {E} `{Euclid E} (v0 : E) (m : list R) (ds : list E) := (v0 + comb m ds)%V.
Fixpoint more_radius {E} `{Euclid E} (m : list R) (balls : list (ball E)) : R :=
  match m, balls with a :: m, b :: balls => Rabs a * radius b + more_radius m balls | _, _ => 0 end.
Definition displaced_ball {E} `{Euclid E} (b : ball E) (m : list R) (balls : list (ball E)) : ball E :=
  Ball (center b + comb m (map center balls))%V (radius b + more_radius m balls).

(* --- Statement --- *)

(* (i) *)
Definition stays_in_displaced_ball : Prop := forall E (l : Lin R E) (H : Euclid E) (b : ball E) (balls : list (ball E)) v0 ds m,
  in_ball b v0 -> Forall2 in_ball balls ds -> length m = length balls ->
  in_ball (displaced_ball b m balls) (displaced v0 m ds).

(* What a refit that does not know of displacements takes is false. *)
Definition stays_in_reference_somewhere : Prop := forall (b : ball R) (v0 d m : R), in_ball b v0 -> in_ball b (v0 + m * d).

(* --- Proof --- *)

Lemma norm_scale_any {E} `{Euclid E} (a : R) (x : E) : norm (a *: x) = Rabs a * norm x.
Proof.
  apply norm_eq; [apply Rmult_le_pos; [apply Rabs_pos|apply norm_nonneg]|]. rewrite norm2_scale.
  assert (Q : Rabs a * norm x * (Rabs a * norm x) = Rabs a * Rabs a * norm2 x) by (rewrite <- (norm_sq x); ring).
  rewrite Q. f_equal. rewrite <- Rabs_mult. symmetry. apply Rabs_right, Rle_ge, Rle_0_sqr.
Qed.

Lemma combinations_apart {E} `{Euclid E} (balls : list (ball E)) ds m : Forall2 in_ball balls ds -> length m = length balls ->
  norm (comb m ds - comb m (map center balls)) <= more_radius m balls.
Proof.
  intros F. revert m. induction F as [|b d balls ds I F IH]; intros [|a m] L; try discriminate.
  - cbn [comb map more_radius]. replace (lzero - lzero)%V with (0 *: (lzero : E))%V by vec_ring. rewrite norm_scale by lra. lra.
  - cbn [comb map more_radius].
    replace ((a *: d + comb m ds) - (a *: center b + comb m (map center balls)))%V with
      (a *: (d - center b) + (comb m ds - comb m (map center balls)))%V by vec_ring.
    eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; [|apply IH; now injection L].
    rewrite norm_scale_any. apply Rmult_le_compat_l; [apply Rabs_pos|exact I].
Qed.

Theorem stays_in_displaced_ball_holds : stays_in_displaced_ball.
Proof.
  intros E l H b balls v0 ds m V F L. unfold in_ball, displaced_ball, displaced. cbn [center radius].
  replace ((v0 + comb m ds) - (center b + comb m (map center balls)))%V with
    ((v0 - center b) + (comb m ds - comb m (map center balls)))%V by vec_ring.
  eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; [exact V|now apply combinations_apart].
Qed.

Theorem stays_in_reference_is_false : ~ stays_in_reference_somewhere.
Proof.
  intros F. assert (I : in_ball (Ball 0 1) 0).
  { unfold in_ball. cbn. apply norm_le. unfold norm2. cbn. lra. }
  specialize (F (Ball 0 1) 0 2 1 I). unfold in_ball in F. cbn in F. apply norm_le in F as [_ F]. unfold norm2 in F. cbn in F. lra.
Qed.

(* The hypotheses can be met: the number 1 in [0, 1], displaced by 2 in [1, 2]. *)
Example morph_instance : in_ball (Ball (1 / 2) (1 / 2)) 1 /\ Forall2 in_ball [Ball (3 / 2) (1 / 2)] [2].
Proof.
  split; [|constructor; [|constructor]]; unfold in_ball; cbn; apply norm_le; unfold norm2; cbn; lra.
Qed.
