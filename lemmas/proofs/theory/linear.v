(* SPDX-License-Identifier: MIT *)
(* Vectors of R^3, quaternions and linear combinations. They are polymorphic in the number type, so that a program that
   is extracted from Coq can compute with the very definitions that the theorems are about. *)
From Coq Require Import List Reals.
Import ListNotations.

(* What a number type has to bring. *)
Class Ops (T : Type) := { zero : T; one : T; add : T -> T -> T; sub : T -> T -> T; mul : T -> T -> T }.

(* The operations of a vector space over T. *)
Class Lin (T X : Type) := { lzero : X; ladd : X -> X -> X; lsub : X -> X -> X; lscale : T -> X -> X }.

Declare Scope lin_scope.
Delimit Scope lin_scope with V.
Notation "x + y" := (ladd x%V y%V) : lin_scope.
Notation "x - y" := (lsub x%V y%V) : lin_scope.
Notation "a *: x" := (lscale a%R x%V) (at level 40, left associativity) : lin_scope.
Arguments ladd {T X Lin} (x y)%V.
Arguments lsub {T X Lin} (x y)%V.

Record vec (T : Type) := Vec { vx : T; vy : T; vz : T }.
Record quat (T : Type) := Quat { qw : T; qx : T; qy : T; qz : T }.
Arguments Vec {T}. Arguments vx {T}. Arguments vy {T}. Arguments vz {T}.
Arguments Quat {T}. Arguments qw {T}. Arguments qx {T}. Arguments qy {T}. Arguments qz {T}.

Section Definitions.
Context {T : Type} {o : Ops T}.

Global Instance lin_num : Lin T T := {| lzero := zero; ladd := add; lsub := sub; lscale := mul |}.
Global Instance lin_vec : Lin T (vec T) := {|
  lzero := Vec zero zero zero;
  ladd a b := Vec (add (vx a) (vx b)) (add (vy a) (vy b)) (add (vz a) (vz b));
  lsub a b := Vec (sub (vx a) (vx b)) (sub (vy a) (vy b)) (sub (vz a) (vz b));
  lscale s a := Vec (mul s (vx a)) (mul s (vy a)) (mul s (vz a)) |}.
Global Instance lin_quat : Lin T (quat T) := {|
  lzero := Quat zero zero zero zero;
  ladd a b := Quat (add (qw a) (qw b)) (add (qx a) (qx b)) (add (qy a) (qy b)) (add (qz a) (qz b));
  lsub a b := Quat (sub (qw a) (qw b)) (sub (qx a) (qx b)) (sub (qy a) (qy b)) (sub (qz a) (qz b));
  lscale s a := Quat (mul s (qw a)) (mul s (qx a)) (mul s (qy a)) (mul s (qz a)) |}.
Global Instance lin_pair (X Y : Type) {lx : Lin T X} {ly : Lin T Y} : Lin T (X * Y) := {|
  lzero := (lzero, lzero);
  ladd a b := (ladd (fst a) (fst b), ladd (snd a) (snd b));
  lsub a b := (lsub (fst a) (fst b), lsub (snd a) (snd b));
  lscale s a := (lscale s (fst a), lscale s (snd a)) |}.

(* sum_k u_k x_k *)
Fixpoint comb {X : Type} {l : Lin T X} (u : list T) (xs : list X) : X :=
  match u, xs with a :: u', x :: xs' => ladd (lscale a x) (comb u' xs') | _, _ => lzero end.

Definition vdot (a b : vec T) := add (add (mul (vx a) (vx b)) (mul (vy a) (vy b))) (mul (vz a) (vz b)).
Definition cross (a b : vec T) := Vec
  (sub (mul (vy a) (vz b)) (mul (vz a) (vy b)))
  (sub (mul (vz a) (vx b)) (mul (vx a) (vz b)))
  (sub (mul (vx a) (vy b)) (mul (vy a) (vx b))).

Definition qdot (a b : quat T) :=
  add (add (add (mul (qw a) (qw b)) (mul (qx a) (qx b))) (mul (qy a) (qy b))) (mul (qz a) (qz b)).
Definition qmul (a b : quat T) := Quat
  (sub (sub (sub (mul (qw a) (qw b)) (mul (qx a) (qx b))) (mul (qy a) (qy b))) (mul (qz a) (qz b)))
  (sub (add (add (mul (qw a) (qx b)) (mul (qx a) (qw b))) (mul (qy a) (qz b))) (mul (qz a) (qy b)))
  (add (add (sub (mul (qw a) (qy b)) (mul (qx a) (qz b))) (mul (qy a) (qw b))) (mul (qz a) (qx b)))
  (add (sub (add (mul (qw a) (qz b)) (mul (qx a) (qy b))) (mul (qy a) (qx b))) (mul (qz a) (qw b))).
Definition conj (a : quat T) :=
  Quat (qw a) (sub zero (qx a)) (sub zero (qy a)) (sub zero (qz a)).
Definition pure (v : vec T) := Quat zero (vx v) (vy v) (vz v).
Definition im (a : quat T) := Vec (qx a) (qy a) (qz a).
(* Im(a x b-conjugate): for a = b = q it is ||q||^2 times the rotated x. *)
Definition turned (a : quat T) (x : vec T) (b : quat T) := im (qmul (qmul a (pure x)) (conj b)).
End Definitions.

Arguments vdot {T o} (a b)%V.
Arguments cross {T o} (a b)%V.
Arguments qdot {T o} (a b)%V.
Arguments turned {T o} a%V x%V b%V.

(* --- The reals --- *)
Open Scope R_scope.
#[global] Instance ops_R : Ops R := {| zero := 0; one := 1; add := Rplus; sub := Rminus; mul := Rmult |}.
