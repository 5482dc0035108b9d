(* SPDX-License-Identifier: MIT *)
(* Numbers that are exact: what the checker makes of them is what it would make of the real numbers that they stand for. *)
From Coq Require Import List Reals Lra Bool.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.a1_affine_image Refitlab.checker.certificate Refitlab.checker.check.
Import ListNotations.

Class Exact {T} {n : Num T} (value : T -> R) := {
  value_zero : value zero = 0; value_one : value one = 1; value_half : value half_of_one = 1 / 2;
  value_add : forall a b, value (add a b) = value a + value b;
  value_sub : forall a b, value (sub a b) = value a - value b;
  value_mul : forall a b, value (mul a b) = value a * value b;
  value_leb : forall a b, leb a b = true <-> value a <= value b }.

(* --- The same document over the reals --- *)

Section Values.
Context {T : Type} (value : T -> R).
Definition vmap (v : vec T) : vec R := Vec (value (vx v)) (value (vy v)) (value (vz v)).
Definition qmap (q : quat T) : quat R := Quat (value (qw q)) (value (qx q)) (value (qy q)) (value (qz q)).
Definition matrix_map (m : matrix T) : matrix R := (vmap (fst (fst m)), vmap (snd (fst m)), vmap (snd m)).
Definition sphere_map (s : sphere T) : sphere R := Sphere (vmap (middle s)) (value (reach s)).
Fixpoint bound_map (b : bound T) : bound R :=
  match b with
  | Control => Control | All_rotations => All_rotations | Cap a => Cap (qmap a) | MotionBound a f => MotionBound (qmap a) (vmap f)
  | Halves k l first second => Halves k l (bound_map first) (bound_map second)
  | Stretch of_joints of_weight_vertices => Stretch (map value of_joints) (map value of_weight_vertices)
  end.
Definition joint_set_map (js : joint_set T) : joint_set R :=
  match js with
  | Spherical qs images c => Spherical (map qmap qs) (map vmap images) (vmap c)
  | Dual_quaternion qs ds => Dual_quaternion (map qmap qs) (map qmap ds)
  | Linear qs ts => Linear (map qmap qs) (map vmap ts)
  | Affine ms bs => Affine (map matrix_map ms) (map vmap bs)
  end.
Definition piece_map (p : piece T) : piece R :=
  Piece (set_of_piece p) (sphere_map (reference p)) (map (map value) (weight_vertices p)) (bound_map (why p)).
Definition vertex_map (v : vertex T) : vertex R :=
  Vertex (piece_of_vertex v) (vmap (position v)) (map value (weights v)) (places v) (map value (shares v)).
Definition certificate_map (c : certificate T) : certificate R :=
  Certificate (sphere_map (enclosing c)) (map joint_set_map (joint_sets c)) (map piece_map (pieces c)) (map vertex_map (vertices c)).
End Values.

(* --- Each operation of the checker --- *)

Section Homomorphism.
Context {T : Type} {n : Num T} (value : T -> R) {ex : Exact value}.
Notation vmap := (vmap value). Notation qmap := (qmap value).

Hint Rewrite (value_zero (Exact := ex)) (value_one (Exact := ex)) (value_half (Exact := ex)) (value_add (Exact := ex))
  (value_sub (Exact := ex)) (value_mul (Exact := ex)) : values.

Lemma value_two : value two = 2.
Proof. unfold two. autorewrite with values. lra. Qed.

Lemma leb_sound a b : leb a b = true -> value a <= value b.
Proof. apply value_leb. Qed.
Lemma ltb_sound a b : ltb a b = true -> value a < value b.
Proof.
  unfold ltb. rewrite negb_true_iff. intros F. destruct (Rlt_le_dec (value a) (value b)) as [|L]; auto.
  apply value_leb in L. congruence.
Qed.
Lemma eqb_sound a b : eqb a b = true -> value a = value b.
Proof. unfold eqb. rewrite andb_true_iff. intros [A B]. apply leb_sound in A, B. lra. Qed.
Lemma value_max a b : value (maxb a b) = Rmax (value a) (value b).
Proof.
  unfold maxb, Rmax. destruct (leb a b) eqn:L; destruct (Rle_dec (value a) (value b)) as [H|H]; auto.
  - apply value_leb in L. contradiction.
  - apply value_leb in H. congruence.
Qed.

Lemma vmap_zero : vmap lzero = lzero.
Proof. unfold exact.vmap. cbn. now autorewrite with values. Qed.
Lemma vmap_add a b : vmap (a + b)%V = (vmap a + vmap b)%V.
Proof. unfold exact.vmap. cbn. now autorewrite with values. Qed.
Lemma vmap_sub a b : vmap (a - b)%V = (vmap a - vmap b)%V.
Proof. unfold exact.vmap. cbn. now autorewrite with values. Qed.
Lemma vmap_scale s a : vmap (lscale s a) = (value s *: vmap a)%V.
Proof. unfold exact.vmap. cbn. now autorewrite with values. Qed.
Lemma qmap_zero : qmap lzero = lzero.
Proof. unfold exact.qmap. cbn. now autorewrite with values. Qed.
Lemma qmap_add a b : qmap (a + b)%V = (qmap a + qmap b)%V.
Proof. unfold exact.qmap. cbn. now autorewrite with values. Qed.
Lemma qmap_sub a b : qmap (a - b)%V = (qmap a - qmap b)%V.
Proof. unfold exact.qmap. cbn. now autorewrite with values. Qed.
Lemma qmap_scale s a : qmap (lscale s a) = (value s *: qmap a)%V.
Proof. unfold exact.qmap. cbn. now autorewrite with values. Qed.
Lemma qmap_mul a b : qmap (qmul a b) = qmul (qmap a) (qmap b).
Proof. unfold exact.qmap. cbn. now autorewrite with values. Qed.
Lemma qmap_conj a : qmap (conj a) = conj (qmap a).
Proof. unfold exact.qmap. cbn. autorewrite with values. reflexivity. Qed.
Lemma qmap_pure v : qmap (pure v) = pure (vmap v).
Proof. unfold exact.qmap. cbn. now autorewrite with values. Qed.
Lemma vmap_im a : vmap (im a) = im (qmap a).
Proof. reflexivity. Qed.
Lemma vmap_cross a b : vmap (cross a b) = cross (vmap a) (vmap b).
Proof. unfold exact.vmap. cbn. now autorewrite with values. Qed.
Lemma vmap_turned a x b : vmap (turned a x b) = turned (qmap a) (vmap x) (qmap b).
Proof. unfold turned. now rewrite vmap_im, !qmap_mul, qmap_pure, qmap_conj. Qed.
Lemma value_qdot a b : value (qdot a b) = dot (qmap a) (qmap b).
Proof. cbn. unfold qdot. autorewrite with values. reflexivity. Qed.
Lemma value_qnorm2 a : value (qnorm2 a) = norm2 (qmap a).
Proof. apply value_qdot. Qed.
Lemma value_vnorm2 a : value (vnorm2 a) = norm2 (vmap a).
Proof. unfold vnorm2, norm2. cbn. unfold vdot. autorewrite with values. reflexivity. Qed.

(* Combinations, under any map that keeps sums and multiples. *)
Definition keeps_sums {X Y} {lx : Lin T X} {ly : Lin R Y} (f : X -> Y) :=
  f lzero = lzero /\ (forall a b, f (ladd a b) = ladd (f a) (f b)) /\ (forall s a, f (lscale s a) = lscale (value s) (f a)).
Lemma vmap_keeps_sums : keeps_sums vmap.
Proof. split; [apply vmap_zero|]. split; [apply vmap_add|apply vmap_scale]. Qed.
Lemma qmap_keeps_sums : keeps_sums qmap.
Proof. split; [apply qmap_zero|]. split; [apply qmap_add|apply qmap_scale]. Qed.
Lemma value_keeps_sums : keeps_sums value.
Proof. split; [apply value_zero|]. split; [apply value_add|apply value_mul]. Qed.
Lemma pair_keeps_sums {X1 X2 Y1 Y2} {lx1 : Lin T X1} {lx2 : Lin T X2} {ly1 : Lin R Y1} {ly2 : Lin R Y2}
  (f : X1 -> Y1) (g : X2 -> Y2) : keeps_sums f -> keeps_sums g -> keeps_sums (fun p => (f (fst p), g (snd p))).
Proof.
  intros (Z1 & A1 & S1) (Z2 & A2 & S2).
  split; [|split]; intros; cbn [fst snd lzero ladd lscale lin_pair]; now rewrite ?Z1, ?Z2, ?A1, ?A2, ?S1, ?S2.
Qed.
Lemma comb_map {X Y} {lx : Lin T X} {ly : Lin R Y} (f : X -> Y) w xs :
  keeps_sums f -> f (comb w xs) = comb (map value w) (map f xs).
Proof.
  intros (Z & A & S). revert xs; induction w as [|a w IH]; intros [|x xs]; cbn [comb map]; auto. now rewrite A, S, IH.
Qed.
Lemma value_sum ws : value (sum_of ws) = sum (map value ws).
Proof.
  unfold sum_of, sum. induction ws as [|a ws IH]; cbn [fold_right map]; [apply value_zero|]. now rewrite value_add, IH.
Qed.
End Homomorphism.
