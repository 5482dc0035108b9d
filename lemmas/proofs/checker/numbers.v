(* SPDX-License-Identifier: MIT *)
(* The checkers over exact numbers, m 2^e where that is enough and fractions in lowest terms elsewhere, and the theorems about
   them. *)
From Coq Require Import List Reals Lra Lia ZArith QArith Qreals.
Require Import Refitlab.theory.linear Refitlab.checker.certificate Refitlab.checker.check Refitlab.checker.exact.
Require Import Refitlab.checker.sound Refitlab.checker.against Refitlab.checker.pairs.
Import ListNotations.

Inductive number := Dyadic (m e : Z) | Fraction (q : Q).

(* --- The program --- *)

(* Lowest terms by Z.gcd, which extraction maps to Zarith's. *)
Definition lowest (q : Q) : Q :=
  let g := Z.gcd (Qnum q) (Zpos (Qden q)) in Qmake (Qnum q / g) (Z.to_pos (Zpos (Qden q) / g)).
Definition fraction_of (x : number) : Q :=
  match x with
  | Fraction q => q
  | Dyadic m e => if (0 <=? e)%Z then inject_Z (Z.shiftl m e) else lowest (Qmake m (Z.to_pos (Z.shiftl 1 (- e))))
  end.

Definition number_add (a b : number) : number :=
  match a, b with
  | Dyadic m e, Dyadic n f =>
      if (e <=? f)%Z then Dyadic (m + Z.shiftl n (f - e)) e else Dyadic (Z.shiftl m (e - f) + n) f
  | _, _ => Fraction (lowest (fraction_of a + fraction_of b))
  end.
Definition number_sub (a b : number) : number :=
  match a, b with
  | Dyadic m e, Dyadic n f =>
      if (e <=? f)%Z then Dyadic (m - Z.shiftl n (f - e)) e else Dyadic (Z.shiftl m (e - f) - n) f
  | _, _ => Fraction (lowest (fraction_of a - fraction_of b))
  end.
Definition number_mul (a b : number) : number :=
  match a, b with
  | Dyadic m e, Dyadic n f => Dyadic (m * n) (e + f)
  | _, _ => Fraction (lowest (fraction_of a * fraction_of b))
  end.
Definition number_leb (a b : number) : bool :=
  match a, b with
  | Dyadic _ _, Dyadic _ _ => match number_sub a b with Dyadic m _ => (m <=? 0)%Z | Fraction _ => false end
  | _, _ => Qle_bool (fraction_of a) (fraction_of b)
  end.
Definition number_ops : Ops number :=
  {| zero := Dyadic 0 0; one := Dyadic 1 0; add := number_add; sub := number_sub; mul := number_mul |}.
#[global] Instance num_exact : Num number := {| num_ops := number_ops; half_of_one := Dyadic 1 (-1); leb := number_leb |}.

Definition check_exactly (c : certificate number) : bool := check (n := num_exact) c.
Definition check_exactly_against (m : model number) : named number -> bool := check_against (n := num_exact) m.
(* This is what the kernel computes; quick.v has what is extracted. *)
Definition check_pairs_exactly (c : pairs number) : bool := check_pairs (n := num_exact) c.

(* --- The real numbers that they stand for --- *)

Definition power2 (e : Z) : R := powerRZ 2 e.
Definition real (x : number) : R := match x with Dyadic m e => (IZR m * power2 e)%R | Fraction q => Q2R q end.

(* What these programs accept is true. *)
Definition exact_checker_is_sound : Prop := forall c, check_exactly c = true -> claim (certificate_map real c).
Definition exact_checker_against_is_sound : Prop :=
  forall m c, check_exactly_against m c = true -> node_is_held (model_map real m) (named_map real c).
Definition pairs_checker_is_sound : Prop := forall c, check_pairs_exactly c = true -> pairs_claim (pairs_map real c).

(* --- Proofs --- *)

Open Scope R_scope.

Lemma lowest_correct q : Q2R (lowest q) = Q2R q.
Proof.
  apply Qeq_eqR. destruct q as [a d]. unfold lowest, Qeq. cbn [Qnum Qden].
  assert (G : (0 < Z.gcd a (Zpos d))%Z).
  { pose proof (Z.gcd_nonneg a (Zpos d)).
    assert (Z.gcd a (Zpos d) <> 0%Z) by (intros H0; apply Z.gcd_eq_0_r in H0; discriminate). lia. }
  destruct (Z.gcd_divide_l a (Zpos d)) as [x X]. destruct (Z.gcd_divide_r a (Zpos d)) as [y Y].
  set (g := Z.gcd a (Zpos d)) in *. assert (0 < y)%Z by nia.
  rewrite Y at 2. rewrite X at 1. rewrite Y at 1. rewrite !Z.div_mul by lia. rewrite Z2Pos.id by lia. rewrite X. ring.
Qed.

Lemma power2_add a b : power2 (a + b) = power2 a * power2 b.
Proof. apply powerRZ_add. lra. Qed.
Lemma power2_pos e : 0 < power2 e.
Proof. apply powerRZ_lt. lra. Qed.
Lemma power2_nat k : (0 <= k)%Z -> power2 k = IZR (2 ^ k).
Proof.
  intros K. rewrite <- (Z2Nat.id k K) at 1 2. unfold power2. generalize (Z.to_nat k). clear. intros k.
  rewrite <- pow_powerRZ, pow_IZR. reflexivity.
Qed.
Lemma shift_correct m k : (0 <= k)%Z -> IZR (Z.shiftl m k) = IZR m * power2 k.
Proof. intros K. now rewrite Z.shiftl_mul_pow2, mult_IZR, power2_nat. Qed.

Lemma fraction_of_correct x : Q2R (fraction_of x) = real x.
Proof.
  destruct x as [m e|q]; [|reflexivity]. cbn [fraction_of real]. destruct (Z.leb_spec 0 e).
  - unfold Q2R, inject_Z. cbn [Qnum Qden]. rewrite shift_correct by auto. lra.
  - rewrite lowest_correct. unfold Q2R. cbn [Qnum Qden].
    assert (P : (0 < Z.shiftl 1 (- e))%Z) by (rewrite Z.shiftl_mul_pow2 by lia; nia).
    rewrite Z2Pos.id by exact P. rewrite shift_correct by lia. pose proof (power2_pos (- e)). rewrite Rmult_1_l. f_equal.
    apply Rmult_eq_reg_r with (power2 (- e)); [|lra]. rewrite Rinv_l, <- power2_add by lra.
    replace (e + - e)%Z with 0%Z by lia. reflexivity.
Qed.

Lemma number_add_correct a b : real (number_add a b) = real a + real b.
Proof.
  destruct a as [m e|p], b as [n f|q]; cbn [number_add];
    try (cbn [real]; rewrite lowest_correct, Q2R_plus, !fraction_of_correct; reflexivity).
  destruct (Z.leb_spec e f); cbn [real]; rewrite plus_IZR, shift_correct by lia.
  - replace f with (f - e + e)%Z at 2 by lia. rewrite power2_add. ring.
  - replace e with (e - f + f)%Z at 2 by lia. rewrite power2_add. ring.
Qed.
Lemma number_sub_correct a b : real (number_sub a b) = real a - real b.
Proof.
  destruct a as [m e|p], b as [n f|q]; cbn [number_sub];
    try (cbn [real]; rewrite lowest_correct, Q2R_minus, !fraction_of_correct; reflexivity).
  destruct (Z.leb_spec e f); cbn [real]; rewrite minus_IZR, shift_correct by lia.
  - replace f with (f - e + e)%Z at 2 by lia. rewrite power2_add. ring.
  - replace e with (e - f + f)%Z at 2 by lia. rewrite power2_add. ring.
Qed.
Lemma number_mul_correct a b : real (number_mul a b) = real a * real b.
Proof.
  destruct a as [m e|p], b as [n f|q]; cbn [number_mul];
    try (cbn [real]; rewrite lowest_correct, Q2R_mult, !fraction_of_correct; reflexivity).
  cbn [real]. rewrite mult_IZR, power2_add. ring.
Qed.
Lemma number_leb_correct a b : number_leb a b = true <-> real a <= real b.
Proof.
  assert (Q : Qle_bool (fraction_of a) (fraction_of b) = true <-> real a <= real b).
  { rewrite <- !fraction_of_correct, Qle_bool_iff. split; [apply Qle_Rle|apply Rle_Qle]. }
  destruct a as [m e|p], b as [n f|q]; try exact Q. cbn [number_leb].
  pose proof (number_sub_correct (Dyadic m e) (Dyadic n f)) as S. cbn [number_sub] in *.
  assert (G : forall k g, IZR k * power2 g = real (Dyadic m e) - real (Dyadic n f) ->
    (k <=? 0)%Z = true <-> real (Dyadic m e) <= real (Dyadic n f)).
  { intros k g E. rewrite Z.leb_le. pose proof (power2_pos g). split; intros L.
    - apply IZR_le in L. nra.
    - apply le_IZR. nra. }
  destruct (e <=? f)%Z; now apply G in S.
Qed.
Lemma real_zero : real (Dyadic 0 0) = 0.
Proof. cbn. ring. Qed.
Lemma real_one : real (Dyadic 1 0) = 1.
Proof. unfold real, power2, powerRZ. ring. Qed.
Lemma real_half : real (Dyadic 1 (-1)) = 1 / 2.
Proof. unfold real, power2, powerRZ. cbn [Pos.to_nat Pos.iter_op]. rewrite pow_1. field. Qed.

#[global] Instance exact_numbers : Exact (n := num_exact) real.
Proof.
  constructor; [exact real_zero|exact real_one|exact real_half| | | |exact number_leb_correct].
  - apply number_add_correct.
  - apply number_sub_correct.
  - apply number_mul_correct.
Qed.

Theorem exact_checker_is_sound_holds : exact_checker_is_sound.
Proof. intros c. exact (check_is_sound (n := num_exact) real (ex := exact_numbers) c). Qed.
Theorem exact_checker_against_is_sound_holds : exact_checker_against_is_sound.
Proof. intros m c. exact (check_against_sound (n := num_exact) real (ex := exact_numbers) m c). Qed.
Theorem pairs_checker_is_sound_holds : pairs_checker_is_sound.
Proof. intros c. exact (check_pairs_sound (n := num_exact) real (ex := exact_numbers) c). Qed.

(* The hypotheses can be met: two joints, a turn by 74 degrees between them, and a vertex of equal weights. With the ball a
   little smaller it is not accepted. *)
Definition turned_pair (radius : number) : certificate number := (
  let n z := Dyadic z 0 in let zero := Vec (n 0) (n 0) (n 0) in
  Certificate (Sphere zero radius)
    [Spherical [Quat (n 1) (n 0) (n 0) (n 0); Quat (n 4) (n 3) (n 0) (n 0)] [zero; zero] zero]
    [Piece 0%nat (Sphere (Vec (n 0) (n 1) (n 0)) (n 1)) [[n 1; n 0]; [n 0; n 1]] (Cap (Quat (n 3) (n 1) (n 0) (n 0)))]
    [Vertex 0%nat (Vec (n 0) (n 2) (n 0)) [Dyadic 1 (-1); Dyadic 1 (-1)] [0; 1]%nat [n 1; n 1]])%Z.
Example exact_instance : check_exactly (turned_pair (Dyadic 3 0)) = true /\ check_exactly (turned_pair (Dyadic 1 0)) = false.
Proof. split; vm_compute; reflexivity. Qed.
(* A model of that vertex, in a triangle with itself, and one where it weighs otherwise. *)
Definition turned_model (weight other : number) : model number :=
  let n z := Dyadic z 0 in
  Model [Point (Vec (n 0%Z) (n 2%Z) (n 0%Z)) [4; 7]%nat [weight; other]] [(1, 1, 1)%positive] [(0, 1)%nat].
Definition named_pair := Named (turned_pair (Dyadic 3 0)) 0 [1%positive] [[4; 7]%nat].
Example against_instance :
  check_exactly_against (turned_model (Dyadic 1 (-1)) (Dyadic 2 (-2))) named_pair = true /\
  check_exactly_against (turned_model (Dyadic 1 (-2)) (Dyadic 3 (-2))) named_pair = false.
Proof. split; vm_compute; reflexivity. Qed.
(* Two triangles of the first body and one of the second, which meets the first of them in its edge's third. With a plane that
   does not part the other two it is not accepted. *)
Definition meeting_bodies (offset : number) : pairs number := (
  let n z := Dyadic z 0 in let third z := Fraction (Qmake z 3) in
  Pairs
    (Body [Vec (n 0) (n 0) (n 0); Vec (n 3) (n 0) (n 0); Vec (n 0) (n 3) (n 0); Vec (n 0) (n 0) (n (-3))]
      [(1, 2, 3); (1, 4, 3)]%positive)
    (Body [Vec (n 1) (n 0) (n 0); Vec (n 1) (n 0) (n 2); Vec (n 2) (n (-1)) (n 2)] [(1, 2, 3)]%positive)
    [2; 1]%positive [1]%positive [Halve_first; Plane (Vec (n 1) (n 0) (n 0)) offset; Touch]
    [Contact (1, 1)%positive [third 2; third 1; n 0] [n 1; n 0; n 0]])%Z.
Example pairs_instance :
  check_pairs_exactly (meeting_bodies (Dyadic 1 (-1))) = true /\ check_pairs_exactly (meeting_bodies (Dyadic 1 0)) = false.
Proof. split; vm_compute; reflexivity. Qed.
