(* SPDX-License-Identifier: MIT *)
(* Beyond the paper: where the control points are no bound, the cap of the rotations still is. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.t3_one_cap Refitlab.rotation_bound Refitlab.b2_control_hull_encloses.
Import ListNotations.

(* --- Statements --- *)

(* q'_k, c and kappa^2 are as in t3_one_cap with c not 0; or kappa^2 <= 1/2, and nothing is asked of them. *)
Definition cap_is_valid (qs : list (quat R)) (c : quat R) (kappa2 : R) :=
  kappa2 <= 1 / 2 \/ (c <> lzero /\ kappa2 <= 1 /\ Forall (in_cone c kappa2) qs).
Definition height (kappa2 : R) := Rmax (2 * kappa2 - 1) 0.

(* Every vertex v' = R_b x + sum u_k r'_k + y, with b not 0 and ||y|| <= r, is in the hull of the balls
   [r'_k + h R_c x, sqrt(1 - h^2) ||x|| + r]: in any convex set that holds them. *)
Definition cap_fallback : Prop :=
  forall (K : vec R -> Prop) (weight_vertices : list (quat R * vec R)) (c : quat R) (kappa2 : R) (x y : vec R) (r : R)
    (u : list R),
  let h := height kappa2 in let b := comb u (map fst weight_vertices) in
  convex_set K -> cap_is_valid (map fst weight_vertices) c kappa2 -> convex (length weight_vertices) u -> b <> lzero ->
    norm y <= r ->
  (forall q r', In (q, r') weight_vertices -> forall z,
     in_ball (Ball (r' + h *: rotate c x)%V (sqrt (1 - h * h) * norm x + r)) z -> K z) ->
  K (rotate b x + comb u (map snd weight_vertices) + y)%V.
(* If all (q'_k, q'_l) >= 0 and no q'_k is 0, all of them are strictly ahead of their sum. *)
Definition positive_pairs_are_ahead : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (qs : list E), let sum := comb (repeat 1 (length qs)) qs in
  (forall p q, In p qs -> In q qs -> p <> lzero /\ 0 <= dot p q) -> forall p, In p qs -> 0 < dot p sum.

(* --- Proofs --- *)

(* R_b x is within sqrt(1 - h^2) ||x|| of h R_c x. *)
Lemma fallback_step (qs : list (quat R)) c kappa2 b x : cap_is_valid qs c kappa2 -> in_hull qs b -> b <> lzero ->
  let h := height kappa2 in norm (rotate b x - h *: rotate c x) <= sqrt (1 - h * h) * norm x.
Proof.
  intros [V|(C & K & F)] B N h.
  - assert (h = 0) as -> by (unfold h, height; apply Rmax_right; lra).
    replace (rotate b x - 0 *: rotate c x)%V with (rotate b x) by vec_ring. rewrite rotate_norm by auto.
    replace (1 - 0 * 0) with 1 by ring. rewrite sqrt_1. lra.
  - destruct (Rle_lt_dec 0 kappa2) as [P|P].
    + apply rotation_in_cap_ball; auto; [lra|]. apply one_cap_rotated_holds; auto.
      now apply (one_cap_holds _ _ _ c kappa2 qs b).
    + assert (h = 0) as -> by (unfold h, height; apply Rmax_right; lra).
      replace (rotate b x - 0 *: rotate c x)%V with (rotate b x) by vec_ring. rewrite rotate_norm by auto.
      replace (1 - 0 * 0) with 1 by ring. rewrite sqrt_1. lra.
Qed.

Theorem cap_fallback_holds : cap_fallback.
Proof.
  intros K weight_vertices c kappa2 x y r u h b C V U N Y F.
  assert (B : in_hull (map fst weight_vertices) b) by (exists u; split; [now rewrite map_length|reflexivity]).
  pose proof (fallback_step _ c kappa2 b x V B N) as S. cbv zeta in S. fold h in S.
  replace (rotate b x + comb u (map snd weight_vertices) + y)%V with
    (comb u (map snd weight_vertices) + (h *: rotate c x + (rotate b x - h *: rotate c x) + y))%V by vec_ring.
  apply convex_set_around_balls with (ps := map snd weight_vertices); auto.
  - exists u. split; [now rewrite map_length|reflexivity].
  - intros p P. apply in_map_iff in P as ([q r'] & <- & I). cbn [snd]. apply (F q r' I). unfold in_ball. cbn [center radius].
    replace (_ - _)%V with ((rotate b x - h *: rotate c x) + y)%V by vec_ring.
    eapply Rle_trans; [apply norm_add|]. lra.
Qed.

Theorem positive_pairs_are_ahead_holds : positive_pairs_are_ahead.
Proof.
  intros E l e qs s H p I.
  assert (G : forall rs, (forall q, In q rs -> In q qs) -> 0 <= dot p (comb (repeat 1 (length rs)) rs) /\
    (In p rs -> 0 < dot p (comb (repeat 1 (length rs)) rs))).
  { induction rs as [|q rs IH]; intros A; cbn [length repeat comb].
    - rewrite dot_zero_r. split; [lra|intros []].
    - destruct IH as [IH1 IH2]; [intros r R; apply A; now right|]. rewrite dot_add_r, dot_scale_r.
      destruct (H p q I (A q (or_introl eq_refl))) as [N D]. split; [lra|]. intros [->|J]; [|specialize (IH2 J); lra].
      apply norm2_pos in N. unfold norm2 in N. lra. }
  apply G; auto.
Qed.

(* The hypotheses can be met: 1 and (4/5, 3/5, 0, 0) about 1 with kappa^2 = 16/25. *)
Example cap_fallback_instance : let weight_vertices := [(Quat 1 0 0 0, Vec 0 0 0); (Quat (4 / 5) (3 / 5) 0 0, Vec 0 0 0)] in
  cap_is_valid (map fst weight_vertices) (Quat 1 0 0 0) (16 / 25) /\ convex (length weight_vertices) [1 / 2; 1 / 2] /\
  comb [1 / 2; 1 / 2] (map fst weight_vertices) <> lzero.
Proof.
  cbv zeta. split; [|split].
  - right. split; [apply norm2_pos_inv; vunfold; lra|]. split; [lra|]. apply one_cap_instance.
  - repeat split; [repeat constructor; lra|cbn; lra].
  - apply norm2_pos_inv. cbn. vunfold. lra.
Qed.
Example positive_pairs_instance : let qs := [Quat 1 0 0 0; Quat 0 1 0 0] in
  forall p q, In p qs -> In q qs -> p <> lzero /\ 0 <= dot p q.
Proof. intros qs p q [<-|[<-|[]]] [<-|[<-|[]]]; (split; [apply norm2_pos_inv|]); vunfold; lra. Qed.
