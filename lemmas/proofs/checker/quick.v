(* SPDX-License-Identifier: MIT *)
(* The checker of pairs made quicker, which is what is extracted: it accepts nothing that the plain one over exact numbers would not.
   Most corners are so far from a plane that their coordinates, rounded down to multiples of 2^-40, tell their side. The others are
   looked at exactly. Fractions are not brought to lowest terms, which takes longer than what it saves. *)
From Coq Require Import List Reals Lra Lia ZArith QArith Qreals Bool FMapPositive.
Require Import Refitlab.theory.linear Refitlab.checker.certificate Refitlab.checker.check Refitlab.checker.exact.
Require Import Refitlab.checker.sound Refitlab.checker.against Refitlab.checker.pairs Refitlab.checker.numbers.
Import ListNotations.

(* --- Fractions in any terms --- *)

Definition any_fraction_of (x : number) : Q :=
  match x with
  | Fraction q => q
  | Dyadic m e => if (0 <=? e)%Z then inject_Z (Z.shiftl m e) else Qmake m (Z.to_pos (Z.shiftl 1 (- e)))
  end.
Definition any_add (a b : number) : number :=
  match a, b with Dyadic _ _, Dyadic _ _ => number_add a b | _, _ => Fraction (any_fraction_of a + any_fraction_of b) end.
Definition any_sub (a b : number) : number :=
  match a, b with Dyadic _ _, Dyadic _ _ => number_sub a b | _, _ => Fraction (any_fraction_of a - any_fraction_of b) end.
Definition any_mul (a b : number) : number :=
  match a, b with Dyadic _ _, Dyadic _ _ => number_mul a b | _, _ => Fraction (any_fraction_of a * any_fraction_of b) end.
Definition any_leb (a b : number) : bool :=
  match a, b with Dyadic _ _, Dyadic _ _ => number_leb a b | _, _ => Qle_bool (any_fraction_of a) (any_fraction_of b) end.
Definition num_any : Num number :=
  {| num_ops := {| zero := Dyadic 0 0; one := Dyadic 1 0; add := any_add; sub := any_sub; mul := any_mul |};
     half_of_one := Dyadic 1 (-1); leb := any_leb |}.

(* --- The program --- *)

Definition places : Z := 40.
(* The whole multiple of 2^-40 that is not above it. *)
Definition floor_of (x : number) : Z :=
  match x with
  | Dyadic m e => Z.shiftl m (e + places)
  | Fraction q => (Z.shiftl (Qnum q) places / Zpos (Qden q))%Z
  end.
Definition spot := (Z * Z * Z)%type.
Definition spot_of (p : vec number) : spot := (floor_of (vx p), floor_of (vy p), floor_of (vz p)).

(* x 2^s, if that is whole. *)
Definition whole (s : Z) (x : number) : option Z :=
  match x with Dyadic m e => if (0 <=? e + s)%Z then Some (Z.shiftl m (e + s)) else None | Fraction _ => None end.
Definition digits (x : number) : Z := match x with Dyadic _ e => Z.max 0 (- e) | Fraction _ => 0%Z end.

(* A plane (a, b, c), and two offsets: where the spot is below the first, the corner is before the plane; where above the second,
   behind it. Each of a spot's coordinates is less than one below the corner's. *)
Definition quick_plane := (Z * Z * Z * Z * Z)%type.
Definition quick_plane_of (normal : vec number) (offset : number) : option quick_plane :=
  let s := Z.max (Z.max (digits (vx normal)) (digits (vy normal))) (Z.max (digits (vz normal)) (digits offset)) in
  match whole s (vx normal), whole s (vy normal), whole s (vz normal), whole (s + places) offset with
  | Some a, Some b, Some c, Some o =>
      Some (a, b, c, o - (Z.max 0 a + Z.max 0 b + Z.max 0 c), o + (Z.max 0 (- a) + Z.max 0 (- b) + Z.max 0 (- c)))%Z
  | _, _, _, _ => None
  end.
Definition along (plane : quick_plane) (p : spot) : Z :=
  let '(a, b, c, _, _) := plane in let '(x, y, z) := p in (a * x + b * y + c * z)%Z.
Definition surely_before (plane : quick_plane) (p : spot) : bool := let '(_, _, _, low, _) := plane in negb (low <=? along plane p)%Z.
Definition surely_behind (plane : quick_plane) (p : spot) : bool := let '(_, _, _, _, high) := plane in negb (along plane p <=? high)%Z.

Notation facet := (positive * list (vec number))%type.
(* A corner with its spot, which is found once for all triangles that have the corner. *)
Notation quick_facet := (positive * list (vec number * spot))%type.
Definition with_spot (p : vec number) : vec number * spot := (p, spot_of p).
Definition prepared (f : facet) : quick_facet := (fst f, map with_spot (snd f)).
Definition plain (f : quick_facet) : facet := (fst f, map fst (snd f)).

Definition check_quick_plane (normal : vec number) (offset : number) (before behind : list quick_facet) : bool :=
  match quick_plane_of normal offset with
  | Some plane =>
      all_corners (fun c => if surely_before plane (snd c) then true
                            else ltb (n := num_any) (vdot (o := @num_ops _ num_any) normal (fst c)) offset) before
      && all_corners (fun c => if surely_behind plane (snd c) then true
                               else ltb (n := num_any) offset (vdot (o := @num_ops _ num_any) normal (fst c))) behind
  | None => check_plane (n := num_any) normal offset (map plain before) (map plain behind)
  end.

(* As walk. *)
Fixpoint quick_walk (todo : list (list quick_facet * list quick_facet)) (ss : list (step number)) (cs : list (contact number)) : bool :=
  match ss, todo with
  | [], [] => match cs with [] => true | _ => false end
  | Plane normal offset :: ss', (xs, ys) :: rest => check_quick_plane normal offset xs ys && quick_walk rest ss' cs
  | Halve_first :: ss', (xs, ys) :: rest => let h := halves xs in quick_walk ((fst h, ys) :: (snd h, ys) :: rest) ss' cs
  | Halve_second :: ss', (xs, ys) :: rest => let h := halves ys in quick_walk ((xs, fst h) :: (xs, snd h) :: rest) ss' cs
  | Touch :: ss', ([a], [b]) :: rest =>
      match cs with c :: cs' => check_contact (n := num_any) (plain a) (plain b) c && quick_walk rest ss' cs' | [] => false end
  | _, _ => false
  end.
Definition quick_in_order (b : body number) (order : list positive) : option (list quick_facet) :=
  in_order (map with_spot (corners b)) (faces b) order.
Definition check_pairs_quickly (c : pairs number) : bool :=
  match quick_in_order (first c) (first_order c), quick_in_order (second c) (second_order c) with
  | Some xs, Some ys => quick_walk [(xs, ys)] (steps c) (contacts c)
  | _, _ => false
  end.

Definition quick_pairs_checker_is_sound : Prop := forall c, check_pairs_quickly c = true -> pairs_claim (pairs_map real c).

(* --- Proofs --- *)

Open Scope R_scope.

Lemma any_fraction_of_correct x : Q2R (any_fraction_of x) = real x.
Proof.
  rewrite <- fraction_of_correct. destruct x as [m e|q]; [|reflexivity]. cbn [any_fraction_of fraction_of].
  destruct (0 <=? e)%Z; [reflexivity|]. now rewrite lowest_correct.
Qed.
Lemma any_leb_correct a b : any_leb a b = true <-> real a <= real b.
Proof.
  assert (Q : Qle_bool (any_fraction_of a) (any_fraction_of b) = true <-> real a <= real b).
  { rewrite <- !any_fraction_of_correct, Qle_bool_iff. split; [apply Qle_Rle|apply Rle_Qle]. }
  destruct a, b; try exact Q. apply number_leb_correct.
Qed.
Definition exact_any : Exact (n := num_any) real.
Proof.
  constructor; [exact real_zero|exact real_one|exact real_half| | | |exact any_leb_correct].
  - intros [m e|p] [n f|q]; try apply number_add_correct; cbn [add num_any num_ops any_add real]; now rewrite Q2R_plus, !any_fraction_of_correct.
  - intros [m e|p] [n f|q]; try apply number_sub_correct; cbn [sub num_any num_ops any_sub real]; now rewrite Q2R_minus, !any_fraction_of_correct.
  - intros [m e|p] [n f|q]; try apply number_mul_correct; cbn [mul num_any num_ops any_mul real]; now rewrite Q2R_mult, !any_fraction_of_correct.
Qed.

Lemma floor_bounds m d : (0 < d)%Z -> IZR (m / d) * IZR d <= IZR m < (IZR (m / d) + 1) * IZR d.
Proof.
  intros D. rewrite <- plus_IZR, <- !mult_IZR. split; [apply IZR_le|apply IZR_lt].
  - rewrite Z.mul_comm. now apply Z.mul_div_le.
  - rewrite Z.mul_comm. now apply Z.mul_succ_div_gt.
Qed.
Lemma floor_of_correct x : IZR (floor_of x) <= real x * power2 places < IZR (floor_of x) + 1.
Proof.
  destruct x as [m e|q]; cbn [floor_of real].
  - rewrite Rmult_assoc, <- power2_add. set (k := (e + places)%Z). destruct (Z.le_gt_cases 0 k) as [K|K].
    + rewrite shift_correct by exact K. lra.
    + rewrite <- (Z.opp_involutive k), Z.shiftl_opp_r, Z.shiftr_div_pow2 by lia.
      assert (P : (0 < 2 ^ - k)%Z) by (apply Z.pow_pos_nonneg; lia).
      pose proof (floor_bounds m (2 ^ - k) P) as F. rewrite <- power2_nat in F by lia.
      pose proof (power2_pos (- k)) as Q. assert (E : power2 (- k) * power2 (- - k) = 1).
      { rewrite <- power2_add. replace (- k + - - k)%Z with 0%Z by lia. reflexivity. }
      pose proof (power2_pos (- - k)). destruct F as [L U]. apply Rmult_le_compat_r with (r := power2 (- - k)) in L; [|lra].
      apply Rmult_lt_compat_r with (r := power2 (- - k)) in U; [|lra]. rewrite Rmult_assoc, E in L, U. lra.
  - pose proof (floor_bounds (Z.shiftl (Qnum q) places) (Zpos (Qden q)) eq_refl) as F.
    rewrite shift_correct in F by (unfold places; lia). unfold Q2R.
    assert (D : 0 < IZR (Zpos (Qden q))) by now apply IZR_lt.
    assert (V : IZR (Qnum q) * / IZR (Zpos (Qden q)) * power2 places * IZR (Zpos (Qden q)) = IZR (Qnum q) * power2 places) by (field; lra).
    split; [apply Rmult_le_reg_r with (IZR (Zpos (Qden q)))|apply Rmult_lt_reg_r with (IZR (Zpos (Qden q)))]; lra.
Qed.
Lemma whole_correct s x z : whole s x = Some z -> IZR z = real x * power2 s.
Proof.
  destruct x as [m e|q]; [|discriminate]. cbn [whole real]. destruct (Z.leb_spec 0 (e + s)); [|discriminate]. intros [= <-].
  rewrite shift_correct, power2_add by auto. ring.
Qed.

(* Of a coordinate times 2^40 that is between the spot's and that plus one. *)
Lemma product_below a x y : IZR x <= y < IZR x + 1 -> IZR a * y <= IZR (a * x) + IZR (Z.max 0 a).
Proof.
  intros Y. rewrite mult_IZR. destruct (Z.max_spec 0 a) as [[A ->]|[A ->]].
  - apply IZR_lt in A. nra.
  - apply IZR_le in A. nra.
Qed.
Lemma product_above a x y : IZR x <= y < IZR x + 1 -> IZR (a * x) - IZR (Z.max 0 (- a)) <= IZR a * y.
Proof.
  intros Y. rewrite mult_IZR. destruct (Z.max_spec 0 (- a)) as [[A ->]|[A ->]].
  - apply IZR_lt in A. rewrite opp_IZR in *. nra.
  - apply IZR_le in A. rewrite opp_IZR in *. nra.
Qed.

Definition product (normal p : vec number) : R := real (vx normal) * real (vx p) + real (vy normal) * real (vy p) + real (vz normal) * real (vz p).
Lemma vdot_correct normal p : real (vdot (o := @num_ops _ num_any) normal p) = product normal p.
Proof.
  unfold vdot, product. now rewrite !(value_add (Exact := exact_any)), !(value_mul (Exact := exact_any)).
Qed.
Lemma ltb_correct a b : real a < real b -> ltb (n := num_any) a b = true.
Proof.
  intros L. unfold ltb. apply negb_true_iff. destruct (leb b a) eqn:F; [|reflexivity]. apply any_leb_correct in F. lra.
Qed.

(* Both sides of a plane are multiplied by 2^s and 2^40. *)
Lemma quick_plane_bounds normal offset plane p : quick_plane_of normal offset = Some plane ->
  (surely_before plane (spot_of p) = true -> product normal p < real offset) /\
  (surely_behind plane (spot_of p) = true -> real offset < product normal p).
Proof.
  unfold quick_plane_of. set (s := Z.max _ _).
  destruct (whole s (vx normal)) as [a|] eqn:A; [|discriminate]. destruct (whole s (vy normal)) as [b|] eqn:B; [|discriminate].
  destruct (whole s (vz normal)) as [c|] eqn:C; [|discriminate]. destruct (whole (s + places) offset) as [o|] eqn:O; [|discriminate].
  intros [= <-]. apply whole_correct in A, B, C, O. rewrite power2_add in O.
  pose proof (floor_of_correct (vx p)) as X. pose proof (floor_of_correct (vy p)) as Y. pose proof (floor_of_correct (vz p)) as Z.
  assert (E : (IZR a * (real (vx p) * power2 places) + IZR b * (real (vy p) * power2 places) + IZR c * (real (vz p) * power2 places)) =
              product normal p * (power2 s * power2 places)) by (rewrite A, B, C; unfold product; ring).
  assert (P : 0 < power2 s * power2 places) by (apply Rmult_lt_0_compat; apply power2_pos).
  unfold surely_before, surely_behind, along, spot_of. split; intros F; apply negb_true_iff, Z.leb_gt, IZR_lt in F.
  - apply (product_below a) in X. apply (product_below b) in Y. apply (product_below c) in Z.
    rewrite minus_IZR, !plus_IZR in F. apply Rmult_lt_reg_r with (power2 s * power2 places); [exact P|]. lra.
  - apply (product_above a) in X. apply (product_above b) in Y. apply (product_above c) in Z.
    rewrite !plus_IZR in F. apply Rmult_lt_reg_r with (power2 s * power2 places); [exact P|]. lra.
Qed.

Lemma quick_corners_sound quick exact set : (forall p, quick (spot_of p) = true -> exact p = true) ->
  all_corners (fun c => if quick (snd c) then true else exact (fst c)) (map prepared set) = true -> all_corners exact set = true.
Proof.
  intros S. unfold all_corners. rewrite !forallb_forall. intros A f I. specialize (A (prepared f) (in_map prepared set f I)).
  rewrite forallb_forall in A. apply forallb_forall. intros p J. specialize (A (with_spot p) (in_map with_spot (snd f) p J)).
  cbn [with_spot fst snd] in A. destruct (quick (spot_of p)) eqn:Q; [now apply S|exact A].
Qed.
Lemma plain_prepared f : plain (prepared f) = f.
Proof. destruct f as [k ps]. unfold plain, prepared. cbn [fst snd]. f_equal. rewrite map_map. apply map_id. Qed.
Lemma all_plain_prepared set : map plain (map prepared set) = set.
Proof. rewrite map_map, (map_ext _ (fun f => f)) by exact plain_prepared. apply map_id. Qed.
Lemma check_quick_plane_sound normal offset xs ys :
  check_quick_plane normal offset (map prepared xs) (map prepared ys) = true -> check_plane (n := num_any) normal offset xs ys = true.
Proof.
  unfold check_quick_plane. destruct (quick_plane_of normal offset) as [plane|] eqn:P; [|now rewrite !all_plain_prepared].
  rewrite andb_true_iff. intros [A B]. unfold check_plane. rewrite andb_true_iff.
  split; [refine (quick_corners_sound _ _ _ _ A)|refine (quick_corners_sound _ _ _ _ B)]; intros p Q; apply ltb_correct; rewrite vdot_correct;
    now apply (quick_plane_bounds normal offset plane p P).
Qed.

Lemma halves_prepared xs : halves (map prepared xs) = (map prepared (fst (halves xs)), map prepared (snd (halves xs))).
Proof. unfold halves. cbn [fst snd]. now rewrite map_length, firstn_map, skipn_map. Qed.
Definition prepared_pair (t : list facet * list facet) := (map prepared (fst t), map prepared (snd t)).
Lemma quick_walk_sound ss : forall todo cs, quick_walk (map prepared_pair todo) ss cs = true -> walk (n := num_any) todo ss cs = true.
Proof.
  induction ss as [|s ss IH]; intros [|[xs ys] rest] cs; cbn [map prepared_pair fst snd quick_walk walk]; try discriminate; auto;
    destruct s as [normal offset| | |]; try discriminate.
  - rewrite !andb_true_iff. intros [A B]. split; [now apply check_quick_plane_sound|now apply IH].
  - rewrite halves_prepared. cbn [fst snd]. intros A. now apply IH.
  - rewrite halves_prepared. cbn [fst snd]. intros A. now apply IH.
  - destruct xs as [|a [|? ?]]; try discriminate. destruct ys as [|b [|? ?]]; try discriminate. cbn [map].
    destruct cs as [|c cs]; [discriminate|]. rewrite !andb_true_iff, !plain_prepared. intros [A B]. split; [exact A|now apply IH].
Qed.

(* The order of corners that have spots is that of corners. *)
Lemma table_of_map {X Y} (f : X -> Y) xs k : PositiveMap.find k (numbered (map f xs)) = option_map f (PositiveMap.find k (numbered xs)).
Proof. rewrite !numbered_is. apply nth_error_map. Qed.
Lemma quick_in_order_is b order : quick_in_order b order = option_map (map prepared) (in_order (corners b) (faces b) order).
Proof.
  unfold quick_in_order, in_order. destruct (_ && _); [|reflexivity].
  induction order as [|k order IH]; cbn [map all_some option_map]; [reflexivity|]. rewrite IH.
  generalize (all_some (map (find_facet (numbered (corners b)) (numbered (faces b))) order)) as rest. intros rest. unfold find_facet.
  destruct (PositiveMap.find k (numbered (faces b))) as [[[i j] l]|]; [|reflexivity]. rewrite !table_of_map.
  destruct (PositiveMap.find i (numbered (corners b))); [|reflexivity]. destruct (PositiveMap.find j (numbered (corners b))); [|reflexivity].
  destruct (PositiveMap.find l (numbered (corners b))); [|reflexivity]. cbn [option_map].
  now destruct rest.
Qed.

Theorem quick_pairs_checker_is_sound_holds : quick_pairs_checker_is_sound.
Proof.
  intros c Q. apply (check_pairs_sound (n := num_any) real (ex := exact_any)). unfold check_pairs, check_pairs_quickly in *.
  rewrite !quick_in_order_is in Q.
  destruct (in_order _ _ (first_order c)) as [xs|]; [|discriminate].
  destruct (in_order _ _ (second_order c)) as [ys|]; [|discriminate].
  exact (quick_walk_sound (steps c) [(xs, ys)] (contacts c) Q).
Qed.

(* The hypotheses can be met, by corners that are told apart quickly and by one that is too near for that. *)
Example quick_pairs_instance :
  check_pairs_quickly (meeting_bodies (Dyadic 1 (-1))) = true /\ check_pairs_quickly (meeting_bodies (Dyadic 1 0)) = false /\
  check_pairs_quickly (meeting_bodies (Dyadic 1 (-60))) = true.
Proof. repeat split; vm_compute; reflexivity. Qed.
