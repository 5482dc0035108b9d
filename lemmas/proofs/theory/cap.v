(* SPDX-License-Identifier: MIT *)
(* Surfaces of spheres, half-spaces, and caps, as section 4.3 of the paper defines them. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid.

(* The surface of the sphere with center c and radius r. *)
Definition on_surface {E} `{Euclid E} (c : E) (r : R) (x : E) := norm (x - c) = r.
(* {x : (x, d) >= D} *)
Definition in_half_space {E} `{Euclid E} (d : E) (D : R) (x : E) := D <= dot x d.
(* The cap of the sphere around c with apex a and angle arccos t, for t <= 1: points as far from c as a is, within the
   angle of a. *)
Definition in_cap {E} `{Euclid E} (c a : E) (t : R) (x : E) :=
  norm2 (x - c) = norm2 (a - c) /\ t * norm2 (a - c) <= dot (x - c) (a - c).

Arguments on_surface {E l H} c%V r x%V.
Arguments in_half_space {E l H} d%V D x%V.
Arguments in_cap {E l H} c%V a%V t x%V.

(* There is a second dimension: every vector has one at a right angle to it that is as long. *)
Definition at_least_plane (E : Type) `{Euclid E} := forall a : E, exists v : E, dot v a = 0 /\ norm2 v = norm2 a.

Lemma plane_is_plane : at_least_plane plane.
Proof. intros [x y]. exists (- y, x). split; vunfold; ring. Qed.
Lemma quat_is_plane : at_least_plane (quat R).
Proof. intros [w x y z]. exists (Quat (- x) w (- z) y). split; vunfold; ring. Qed.
Lemma vec_is_plane : at_least_plane (vec R).
Proof.
  intros [x y z]. destruct (Req_dec (x * x + y * y) 0) as [Z|N].
  - assert (x = 0) by nra. assert (y = 0) by nra. subst. exists (Vec z 0 0). split; vunfold; ring.
  - pose proof (Rle_0_sqr z) as Zn. unfold Rsqr in Zn.
    assert (P : 0 < x * x + y * y) by nra.
    set (s := sqrt ((x * x + y * y + z * z) / (x * x + y * y))). exists (Vec (- (s * y)) (s * x) 0).
    assert (Q : s * s = (x * x + y * y + z * z) / (x * x + y * y)).
    { apply sqrt_sqrt. apply Rmult_le_pos; [nra|]. left. now apply inv_pos. }
    split; vunfold; [ring|]. replace (_ + _ + _) with (s * s * (x * x + y * y)) by ring. rewrite Q. field. lra.
Qed.
