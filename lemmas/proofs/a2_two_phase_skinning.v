(* SPDX-License-Identifier: MIT *)
(* Scales before rotations: the blend of a vertex's images by all joints is in any convex set that holds them. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex.
Import ListNotations.

(* --- Statements --- *)

(* (i), for any maps. *)
Definition scaled_in_convex_set : Prop := forall E (l : Lin R E) (H : Euclid E) (K : E -> Prop) (scales : list (E -> E)) w v,
  convex_set K -> convex (length scales) w -> Forall (fun s => K (s v)) scales -> K (comb w (map (fun s => s v) scales)).
(* (ii): B holds what the rigid skinning makes of every point of K. *)
Definition two_phases_in_bound : Prop := forall E (l : Lin R E) (H : Euclid E) (K B : E -> Prop) (scales : list (E -> E)) w v (rigid : E -> E),
  convex_set K -> convex (length scales) w -> Forall (fun s => K (s v)) scales -> (forall x, K x -> B (rigid x)) ->
  B (rigid (comb w (map (fun s => s v) scales))).

(* --- Proofs --- *)

Theorem scaled_in_convex_set_holds : scaled_in_convex_set.
Proof.
  intros E l H K scales w v C W F. apply convex_set_comb; auto.
  - now rewrite map_length.
  - now apply Forall_map.
Qed.

Theorem two_phases_in_bound_holds : two_phases_in_bound.
Proof. intros E l H K B scales w v rigid C W F D. now apply D, scaled_in_convex_set_holds. Qed.

(* The hypotheses can be met: a joint that scales by 3, and one that does not, in the ball about 0 of the radius 3. *)
Example two_phase_instance : let scales := [(fun x : R => x); (fun x => 3 * x)] in
  convex_set (in_ball (Ball 0 3)) /\ convex (length scales) [1 / 2; 1 / 2] /\ Forall (fun s => in_ball (Ball 0 3) (s 1)) scales.
Proof.
  cbv zeta. split; [apply ball_convex|]. split; [repeat split; [repeat constructor; lra|cbn; lra]|].
  assert (N : forall x : R, - 3 <= x <= 3 -> in_ball (Ball 0 3) x).
  { intros x X. unfold in_ball. cbn. apply norm_le. unfold norm2. cbn. split; [lra|nra]. }
  repeat apply Forall_cons; try apply Forall_nil; apply N; lra.
Qed.
