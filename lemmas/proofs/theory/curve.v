(* SPDX-License-Identifier: MIT *)
(* Curves in real inner product spaces: their derivatives, and how long they are, how fast, and how much they bend. A curve is
   differentiable where each of its dot products with a vector is. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex.
Import ListNotations.

(* f' is the derivative of f throughout [a, b], from both sides also at its ends: a piece of a clip is continued by its own formula. *)
Definition derivative {E} `{Euclid E} (f f' : R -> E) (a b : R) :=
  forall e t, a <= t <= b -> derivable_pt_lim (fun x => dot (f x) e) t (dot (f' t) e).

(* x, x', x'' are no longer than s, s', s''. *)
Definition moves_within {E} `{Euclid E} (x x' x'' : E) (s s' s'' : R) := norm x <= s /\ norm x' <= s' /\ norm x'' <= s''.

(* lemmas/vocabulary/motion.hpp *)
Record motion := Motion { size : R; speed : R; acceleration : R }.
Definition at_rest (s : R) := Motion s 0 0.
Definition sum_of_motions (m n : motion) :=
  Motion (size m + size n) (speed m + speed n) (acceleration m + acceleration n).
Definition product_of_motions (m n : motion) := Motion (size m * size n) (speed m * size n + size m * speed n)
  (acceleration m * size n + 2 * speed m * speed n + size m * acceleration n).
Definition moves {E} `{Euclid E} (f : R -> E) (m : motion) (a b : R) := exists f' f'', derivative f f' a b /\ derivative f' f'' a b /\
  forall t, a <= t <= b -> moves_within (f t) (f' t) (f'' t) (size m) (speed m) (acceleration m).

(* --- Products that are linear in both factors: their dot products are sums of products of dot products. --- *)

Definition sum_of_products {X Y} `{Euclid X} `{Euclid Y} (terms : list (X * Y)) (x : X) (y : Y) :=
  fold_right (fun p s => dot x (fst p) * dot y (snd p) + s) 0 terms.
Definition is_product {X Y Z} `{Euclid X} `{Euclid Y} `{Euclid Z} (B : X -> Y -> Z) :=
  forall e, exists terms, forall x y, dot (B x y) e = sum_of_products terms x y.
Definition has_adjoint {X Y} `{Euclid X} `{Euclid Y} (L : X -> Y) := forall e, exists e', forall x, dot (L x) e = dot x e'.

Lemma scaling_is_product {E} `{Euclid E} : is_product (fun (s : R) (x : E) => (s *: x)%V).
Proof. intros e. exists [(1, e)]. intros s x. cbn. rewrite dot_scale_l. ring. Qed.
Lemma qdot_is_product : is_product (fun p q : quat R => dot p q).
Proof.
  intros e. exists [(Quat e 0 0 0, Quat 1 0 0 0); (Quat 0 e 0 0, Quat 0 1 0 0); (Quat 0 0 e 0, Quat 0 0 1 0); (Quat 0 0 0 e, Quat 0 0 0 1)].
  intros [pw px py pz] [qw qx qy qz]. cbn. vunfold. ring.
Qed.
Lemma qmul_is_product : is_product (fun p q : quat R => qmul p q).
Proof.
  intros [w x y z]. exists [(Quat 1 0 0 0, Quat w x y z); (Quat 0 1 0 0, Quat x (- w) z (- y));
    (Quat 0 0 1 0, Quat y (- z) (- w) x); (Quat 0 0 0 1, Quat z y (- x) (- w))].
  intros [pw px py pz] [qw qx qy qz]. cbn. vunfold. ring.
Qed.
Lemma scaled_is_product : is_product scaled.
Proof.
  intros [x y z]. exists [(Vec x 0 0, Vec 1 0 0); (Vec 0 y 0, Vec 0 1 0); (Vec 0 0 z, Vec 0 0 1)].
  intros [sx sy sz] [px py pz]. unfold scaled. cbn. vunfold. ring.
Qed.
Lemma scaling_has_adjoint {E} `{Euclid E} (s : R) : has_adjoint (fun x : E => (s *: x)%V).
Proof. intros e. exists (s *: e)%V. intros x. now rewrite dot_scale_l, dot_scale_r. Qed.
Lemma conj_has_adjoint : has_adjoint (fun q : quat R => conj q).
Proof. intros e. exists (conj e). vring. Qed.
Lemma pure_has_adjoint : has_adjoint (fun v : vec R => pure v).
Proof. intros e. exists (im e). vring. Qed.
Lemma im_has_adjoint : has_adjoint (fun q : quat R => im q).
Proof. intros e. exists (pure e). vring. Qed.

(* --- Rules --- *)

Lemma derivable_same (f g : R -> R) (x l : R) : (forall y, f y = g y) -> derivable_pt_lim f x l -> derivable_pt_lim g x l.
Proof. intros S D e E. destruct (D e E) as [d P]. exists d. intros h N C. rewrite <- !S. now apply P. Qed.

Section Rules.
Context {X Y Z : Type} `{Euclid X} `{Euclid Y} `{Euclid Z}.
Implicit Types (f g : R -> X) (a b : R).

Lemma derivative_constant (x : X) a b : derivative (fun _ => x) (fun _ => lzero) a b.
Proof. intros e t _. rewrite dot_zero_l. apply derivable_pt_lim_const. Qed.
Lemma derivative_sum f f' g g' a b : derivative f f' a b -> derivative g g' a b ->
  derivative (fun t => f t + g t)%V (fun t => f' t + g' t)%V a b.
Proof.
  intros F G e t T. rewrite dot_add_l. apply (derivable_same (fun t => dot (f t) e + dot (g t) e)); [intros; now rewrite dot_add_l|].
  apply (derivable_pt_lim_plus (fun t => dot (f t) e) (fun t => dot (g t) e)); auto.
Qed.
Lemma derivative_map (L : X -> Y) f f' a b : has_adjoint L -> derivative f f' a b ->
  derivative (fun t => L (f t)) (fun t => L (f' t)) a b.
Proof.
  intros A F e t T. destruct (A e) as [e' Q]. rewrite Q. apply (derivable_same (fun t => dot (f t) e')); [intros; now rewrite Q|auto].
Qed.
Lemma derivative_product (B : X -> Y -> Z) f f' (g g' : R -> Y) a b : is_product B -> derivative f f' a b -> derivative g g' a b ->
  derivative (fun t => B (f t) (g t)) (fun t => B (f' t) (g t) + B (f t) (g' t))%V a b.
Proof.
  intros P F G e t T. destruct (P e) as [terms Q]. rewrite dot_add_l, !Q.
  apply (derivable_same (fun t => sum_of_products terms (f t) (g t))); [intros; now rewrite Q|]. clear Q.
  induction terms as [|p terms IH].
  - cbn. rewrite Rplus_0_r. apply derivable_pt_lim_const.
  - cbn [sum_of_products fold_right]. fold (sum_of_products terms (f' t) (g t)) (sum_of_products terms (f t) (g' t)).
    replace (dot (f' t) (fst p) * dot (g t) (snd p) + sum_of_products terms (f' t) (g t) +
      (dot (f t) (fst p) * dot (g' t) (snd p) + sum_of_products terms (f t) (g' t))) with
      ((dot (f' t) (fst p) * dot (g t) (snd p) + dot (f t) (fst p) * dot (g' t) (snd p)) +
      (sum_of_products terms (f' t) (g t) + sum_of_products terms (f t) (g' t))) by ring.
    apply (derivable_pt_lim_plus (fun t => dot (f t) (fst p) * dot (g t) (snd p)) (fun t => sum_of_products terms (f t) (g t)));
      [|exact IH].
    apply (derivable_pt_lim_mult (fun t => dot (f t) (fst p)) (fun t => dot (g t) (snd p))); auto.
Qed.
End Rules.

(* The same curve, and the same derivative. *)
Lemma derivative_same {E} `{Euclid E} (f g f' g' : R -> E) a b : (forall t, f t = g t) -> (forall t, a <= t <= b -> f' t = g' t) ->
  derivative f f' a b -> derivative g g' a b.
Proof.
  intros S S' D e t T. rewrite <- S' by exact T. apply (derivable_same (fun t => dot (f t) e)); [intros; now rewrite S|auto].
Qed.

(* Both derivatives of a product, by the rule of Leibniz. *)
Lemma second_derivative_of_product {X Y Z} `{Euclid X} `{Euclid Y} `{Euclid Z} (B : X -> Y -> Z) (f f' f'' : R -> X)
  (g g' g'' : R -> Y) (a b : R) : is_product B -> derivative f f' a b -> derivative f' f'' a b ->
  derivative g g' a b -> derivative g' g'' a b ->
  derivative (fun t => B (f' t) (g t) + B (f t) (g' t))%V
    (fun t => B (f'' t) (g t) + 2 *: B (f' t) (g' t) + B (f t) (g'' t))%V a b.
Proof.
  intros P F F' G G'. eapply derivative_same; [reflexivity| |apply derivative_sum; apply derivative_product; eassumption].
  intros t _. vec_ring.
Qed.

(* A curve times a number that moves, too. *)
Lemma scaled_curve_moves {E} `{Euclid E} (u u' u'' : R -> R) (p p' p'' : R -> E) (m : motion) (a b : R) :
  derivative u u' a b -> derivative u' u'' a b -> derivative p p' a b -> derivative p' p'' a b ->
  (forall t, a <= t <= b -> moves_within (u t *: p t)%V (u' t *: p t + u t *: p' t)%V
    (u'' t *: p t + 2 *: (u' t *: p' t) + u t *: p'' t)%V (size m) (speed m) (acceleration m)) ->
  moves (fun t => u t *: p t)%V m a b.
Proof.
  intros U U' D D' M. eexists _, _. split; [exact (derivative_product (fun (s : R) (x : E) => (s *: x)%V) u u' p p' a b scaling_is_product U D)|].
  split; [exact (second_derivative_of_product (fun (s : R) (x : E) => (s *: x)%V) u u' u'' p p' p'' a b scaling_is_product U U' D D')|exact M].
Qed.
(* The squared length of a curve. *)
Lemma derivative_of_norm2 (p p' : R -> quat R) (a b : R) : derivative p p' a b ->
  derivative (fun t => norm2 (p t)) (fun t => 2 * dot (p t) (p' t)) a b.
Proof.
  intros D. eapply derivative_same; [reflexivity| |exact (derivative_product (fun p q : quat R => dot p q) p p' p p' a b qdot_is_product D D)].
  intros t _. cbv beta. rewrite (dot_comm (p' t) (p t)). cbn. ring.
Qed.
