(* SPDX-License-Identifier: MIT *)
(* About the checker over any exact numbers: a certificate that it accepts claims what is true. *)
From Coq Require Import List Reals Lra Lia Bool PeanoNat.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.b1_rational_bezier_simplex Refitlab.b2_control_hull_encloses Refitlab.b3_subdivision.
Require Import Refitlab.b4_cap_fallback Refitlab.b6_dual_quaternion_ball Refitlab.t3_one_cap.
Require Import Refitlab.s41_weight_vertices_span Refitlab.s42_linear_part_hull Refitlab.a1_affine_image.
Require Import Refitlab.checker.certificate Refitlab.checker.check Refitlab.checker.exact Refitlab.checker.bounds.
Import ListNotations.

(* --- The tables are those of all pairs and triples --- *)

Lemma triples_of_row {X Y Z} (pair : X -> X -> Y) (triple : X -> X -> X -> Y -> Y -> Y -> Z) a xs :
  triples_of triple a (row pair a xs) (rows pair xs) =
  indices2 (fun b c => triple a b c (pair a b) (pair b c) (pair a c)) xs.
Proof.
  assert (M : forall b ys, map (fun both : (X * Y) * (X * Y) =>
      triple a b (fst (fst both)) (pair a b) (snd (snd both)) (snd (fst both))) (combine (row pair a ys) (row pair b ys)) =
    map (fun c => triple a b c (pair a b) (pair b c) (pair a c)) ys).
  { intros b ys. unfold row. induction ys as [|c ys IH]; cbn; [reflexivity|]. now rewrite IH. }
  induction xs as [|b xs IH]; [reflexivity|]. cbn [rows triples_of indices2].
  change (row pair a (b :: xs)) with ((b, pair a b) :: row pair a xs) at 1. cbn [triples_of].
  change ((b, pair a b) :: row pair a xs) with (row pair a (b :: xs)). rewrite M, IH. reflexivity.
Qed.
Lemma triples_of_rows {X Y Z} (pair : X -> X -> Y) (triple : X -> X -> X -> Y -> Y -> Y -> Z) xs :
  triples triple (rows pair xs) = indices3 (fun a b c => triple a b c (pair a b) (pair b c) (pair a c)) xs.
Proof.
  induction xs as [|a xs IH]; [reflexivity|]. cbn [rows triples].
  change (match row pair a (a :: xs) with (b, _) :: _ => _ | [] => [] end) with
    (triples_of triple a (row pair a (a :: xs)) (rows pair (a :: xs))).
  rewrite triples_of_row, IH. cbn [indices2 indices3]. now rewrite <- !app_comm_cons, app_assoc.
Qed.

Lemma indices2_transfer {X Y Z W} (f : X -> X -> Z) (g : Y -> Y -> W) (h : X -> Y) (P : Z -> Prop) (Q : W -> Prop) xs :
  (forall a b, P (f a b) -> Q (g (h a) (h b))) -> Forall P (indices2 f xs) -> Forall Q (indices2 g (map h xs)).
Proof.
  intros I. induction xs as [|a xs IH]; cbn [indices2 map]; [constructor|]. rewrite !Forall_cons_iff, !Forall_app.
  intros (A & B & C). repeat split; auto. rewrite map_map. apply Forall_map. apply -> Forall_map in B.
  eapply Forall_impl; [|exact B]. auto.
Qed.
Lemma indices3_transfer {X Y Z W} (f : X -> X -> X -> Z) (g : Y -> Y -> Y -> W) (h : X -> Y) (P : Z -> Prop) (Q : W -> Prop) xs :
  (forall a b c, P (f a b c) -> Q (g (h a) (h b) (h c))) -> Forall P (indices3 f xs) -> Forall Q (indices3 g (map h xs)).
Proof.
  intros I. induction xs as [|a xs IH]; cbn [indices3 map]; [constructor|]. rewrite !Forall_cons_iff, !Forall_app.
  intros (A & B & C & D). repeat split; auto.
  - rewrite map_map. apply Forall_map. apply -> Forall_map in B. eapply Forall_impl; [|exact B]. auto.
  - revert C. apply indices2_transfer. auto.
Qed.
(* All entries of the rows of pairs are those of degree 2. *)
Lemma rows_all {X Y} (pair : X -> X -> Y) (test : Y -> bool) xs :
  forallb (forallb (fun entry => test (snd entry))) (rows pair xs) = true -> Forall (fun y => test y = true) (indices2 pair xs).
Proof.
  induction xs as [|a xs IH]; cbn [rows forallb indices2]; [constructor|]. rewrite !andb_true_iff. intros [A B].
  unfold row in A. cbn [map forallb snd] in A. apply andb_true_iff in A as [A C].
  apply Forall_cons; [exact A|]. apply Forall_app. split; [|now apply IH].
  apply Forall_map, Forall_forall. rewrite forallb_forall in C. intros b I.
  apply (C (b, pair a b)). apply in_map_iff. now exists b.
Qed.

Lemma turned_swap (a b : quat R) (x : vec R) : turned a x b = turned b x a.
Proof. vring. Qed.
Lemma mixed_is_turned a b x : mixed a b x = turned a x b.
Proof. unfold mixed. rewrite (turned_swap b a). vec_field. Qed.

Section Soundness.
Context {T : Type} {n : Num T} (value : T -> R) {ex : Exact value}.
Notation vmap := (vmap value). Notation qmap := (qmap value).
Definition smap (p : quat T * vec T) : quat R * vec R := (qmap (fst p), vmap (snd p)).
Definition dmap (p : quat T * quat T) : quat R * quat R := (qmap (fst p), qmap (snd p)).

Hint Rewrite (value_zero (Exact := ex)) (value_one (Exact := ex)) (value_half (Exact := ex)) (value_add (Exact := ex))
  (value_sub (Exact := ex)) (value_mul (Exact := ex)) (value_two value) (value_max value) (value_qdot value)
  (value_qnorm2 value) (value_vnorm2 value) (vmap_add value) (vmap_sub value) (vmap_scale value) (qmap_add value)
  (qmap_sub value) (qmap_scale value) (qmap_mul value) (qmap_conj value) (qmap_pure value) (vmap_im value)
  (vmap_turned value) (vmap_zero value) (qmap_zero value) : values.

(* --- Bounds --- *)

Lemma check_inside_sound c s point : check_inside c s point = true ->
  point_inside (vmap c) (value s) (vmap (fst point), value (snd point)).
Proof.
  unfold check_inside, point_inside. rewrite andb_true_iff. intros [A B]. apply (leb_sound value) in A, B.
  autorewrite with values in A, B. cbn [fst snd]. apply norm_le. split; assumption.
Qed.
Lemma check_ball_inside_sound f r2 c s : check_ball_inside f r2 c s = true ->
  ball_is_inside (vmap f) (value r2) (vmap c) (value s).
Proof.
  unfold check_ball_inside, ball_is_inside. rewrite !andb_true_iff. intros [[A B] C]. apply (leb_sound value) in A, B, C.
  autorewrite with values in A, B, C. cbv zeta. repeat split; lra.
Qed.

Lemma spherical_control_sound x c s xs :
  check_spherical x c s Control xs = true -> all_blends (spherical_good (vmap x) (vmap c) (value s)) (map smap xs).
Proof.
  cbn [check_spherical]. rewrite andb_true_iff. intros [_ H]. apply spherical_control_good.
  unfold spherical_control_points in H. rewrite triples_of_rows in H. unfold spherical_points.
  rewrite forallb_forall in H. apply Forall_forall in H.
  revert H. apply indices3_transfer. intros a b d I. apply check_inside_sound in I.
  unfold spherical_control_point, spherical_pair in I. cbn [fst snd] in I. autorewrite with values in I.
  unfold spherical_point, smap. rewrite !mixed_is_turned. revert I.
  generalize (turned (qmap (fst a)) (vmap x) (qmap (fst b))) (turned (qmap (fst b)) (vmap x) (qmap (fst d)))
    (turned (qmap (fst a)) (vmap x) (qmap (fst d))) (dot (qmap (fst a)) (qmap (fst b))) (dot (qmap (fst b)) (qmap (fst d)))
    (dot (qmap (fst a)) (qmap (fst d))) (vmap (snd a)) (vmap (snd b)) (vmap (snd d)). clear.
  unfold point_inside. cbn [fst snd]. intros tab tbd tad ab bd ad ra rb rd I.
  replace (1 / 3 *: (tab + tbd + tad) + 1 / 3 *: (bd *: ra + ad *: rb + ab *: rd) - ((ab + bd + ad) / 3) *: vmap c)%V with
    (1 / 3 *: (tab + tbd + tad + (bd *: ra + ad *: rb + ab *: rd) - (ab + bd + ad)%R *: vmap c))%V by vec_field.
  rewrite norm_scale by lra. lra.
Qed.
Lemma dual_control_sound x c s xs :
  check_dual x c s Control xs = true -> all_blends (dual_good (vmap x) (vmap c) (value s)) (map dmap xs).
Proof.
  cbn [check_dual]. intros H. apply dual_control_good.
  apply (rows_all (dual_control_point x) (fun y => ltb zero (snd y) && check_inside c s y)) in H.
  unfold dual_points. revert H. apply indices2_transfer. intros a b I. apply andb_true_iff in I as [_ I].
  apply check_inside_sound in I. unfold dual_control_point in I. cbn [fst snd] in I. autorewrite with values in I.
  unfold dual_point, dmap. now rewrite mixed_is_turned.
Qed.

(* The least fraction is one that each is no less than. *)
Lemma squared_cap_cosine_sound a qs num den : (forall q, In q qs -> 0 < dot (qmap q) (qmap a)) -> squared_cap_cosine a qs = (num, den) ->
  0 < value den /\ 0 <= value num / value den <= 1 /\ forall q, In q qs -> in_cone (qmap a) (value num / value den) (qmap q).
Proof.
  revert num den. induction qs as [|q qs IH]; intros num den A E; cbn [squared_cap_cosine map fold_right] in E.
  - injection E as <- <-. autorewrite with values. split; [lra|]. split; [lra|intros q []].
  - specialize (IH (fst (squared_cap_cosine a qs)) (snd (squared_cap_cosine a qs)) (fun p I => A p (or_intror I)) (surjective_pairing _)).
    destruct IH as (D & [L U] & C). change (fold_right lesser _ _) with (squared_cap_cosine a qs) in E.
    set (least := squared_cap_cosine a qs) in *. clearbody least.
    specialize (A q (or_introl eq_refl)).
    assert (N : 0 < norm2 (qmap q) * norm2 (qmap a)) by (pose proof (cauchy (qmap q) (qmap a)); nra).
    set (g := dot (qmap q) (qmap a)) in *. set (norms := norm2 (qmap q) * norm2 (qmap a)) in *.
    (* Less in fractions is less in products. *)
    assert (Less : forall x y z w, 0 < y -> 0 < w -> x * w <= z * y -> x / y <= z / w).
    { intros x y z w Y W X. apply Rmult_le_reg_r with (y * w); [now apply Rmult_lt_0_compat|].
      replace (x / y * (y * w)) with (x * w) by (field; lra). replace (z / w * (y * w)) with (z * y) by (field; lra). exact X. }
    assert (Wider : forall p t t', in_cone (qmap a) t p -> t' <= t -> in_cone (qmap a) t' p).
    { intros p t t' [P K] M. split; [exact P|]. eapply Rle_trans; [|exact K]. apply Rmult_le_compat_r; auto.
      apply Rmult_le_pos; apply norm2_nonneg. }
    assert (Own : in_cone (qmap a) (g * g / norms) (qmap q)).
    { split; [fold g; lra|]. fold norms. fold g. replace (g * g / norms * norms) with (g * g) by (field; lra). lra. }
    unfold lesser in E. cbn [fst snd] in E.
    destruct (leb (mul (mul (qdot q a) (qdot q a)) (snd least)) (mul (fst least) (mul (qnorm2 q) (qnorm2 a)))) eqn:F.
    + injection E as <- <-. apply (leb_sound value) in F. autorewrite with values in F. autorewrite with values. fold g norms in F. fold g norms.
      assert (M : g * g / norms <= value (fst least) / value (snd least)) by now apply Less.
      split; [exact N|]. split; [split; [|lra]|].
      * apply Rmult_le_pos; [nra|left; now apply inv_pos].
      * intros p [<-|I]; [exact Own|]. eapply Wider; [now apply C|exact M].
    + subst least. cbn [fst snd] in *. split; [exact D|]. split; [lra|].
      assert (M : value num / value den <= g * g / norms).
      { apply Less; auto. destruct (Rle_or_lt (value num * norms) (g * g * value den)) as [|G]; auto. exfalso.
        assert (Wrong : leb (mul (mul (qdot q a) (qdot q a)) den) (mul num (mul (qnorm2 q) (qnorm2 a))) = true);
          [|congruence]. apply value_leb. autorewrite with values. fold g norms. lra. }
      intros p [<-|I]; [eapply Wider; [exact Own|exact M]|now apply C].
Qed.

Lemma spherical_cap_sound x c s a xs :
  check_spherical x c s (Cap a) xs = true -> all_blends (spherical_good (vmap x) (vmap c) (value s)) (map smap xs).
Proof.
  cbn [check_spherical]. rewrite andb_true_iff, forallb_forall. intros [A C].
  assert (P : forall p, In p xs -> 0 < dot (qmap (fst p)) (qmap a)).
  { intros p I. apply A, (ltb_sound value) in I. now autorewrite with values in I. }
  destruct xs as [|x0 xs0]. { intros z (u & U & _). now apply convex_not_empty in U. }
  set (xs := x0 :: xs0) in *.
  destruct (squared_cap_cosine a (map fst xs)) as [num den] eqn:E. rewrite forallb_forall in C.
  destruct (squared_cap_cosine_sound a (map fst xs) num den) as (D & K & F); [|exact E|].
  { intros q I. apply in_map_iff in I as (p & <- & I). now apply P. }
  apply (cap_good _ _ _ (qmap a) (value num / value den)); auto.
  - intros Z. specialize (P x0 (or_introl eq_refl)). rewrite Z, dot_zero_r in P. lra.
  - intros p I. apply in_map_iff in I as (p' & <- & I). apply F, in_map, I.
  - intros p I. apply in_map_iff in I as (p' & <- & I). apply C, check_ball_inside_sound in I.
    autorewrite with values in I. unfold height. set (h := Rmax (2 * (value num / value den) - 1) 0).
    assert (H : Rmax (2 * value num - value den) 0 = value den * h).
    { unfold h. replace (2 * value num - value den) with (value den * (2 * (value num / value den) - 1)) by (field; lra).
      rewrite <- (Rmult_0_r (value den)) at 1. apply RmaxRmult. lra. }
    rewrite H in I. cbn [smap fst snd]. set (a2 := norm2 (qmap a)) in *. apply (ball_is_inside_scaled (value den)); [exact D|].
    replace (value den *: (a2 *: vmap (snd p') + h *: turned (qmap a) (vmap x) (qmap a)))%V with
      ((value den * a2) *: vmap (snd p') + (value den * h) *: turned (qmap a) (vmap x) (qmap a))%V by vec_ring.
    replace (value den * value den * ((1 - h * h) * norm2 (vmap x) * (a2 * a2))) with
      ((value den * value den - value den * h * (value den * h)) * norm2 (vmap x) * (a2 * a2)) by ring.
    replace (value den *: (a2 *: vmap c))%V with ((value den * a2) *: vmap c)%V by vec_ring.
    replace (value den * (a2 * value s)) with (value den * a2 * value s) by ring. exact I.
Qed.
Lemma spherical_all_sound x c s xs :
  check_spherical x c s All_rotations xs = true -> all_blends (spherical_good (vmap x) (vmap c) (value s)) (map smap xs).
Proof.
  cbn [check_spherical]. rewrite forallb_forall. intros C. apply all_rotations_good. intros p I.
  apply in_map_iff in I as (p' & <- & I). apply C, check_ball_inside_sound in I. autorewrite with values in I.
  apply ball_is_inside_norm in I; [exact I|apply norm2_nonneg].
Qed.
Lemma dual_reach_sound x c s a f xs :
  check_dual x c s (MotionBound a f) xs = true -> all_blends (dual_good (vmap x) (vmap c) (value s)) (map dmap xs).
Proof.
  cbn [check_dual]. rewrite forallb_forall. intros C. apply (reach_good _ _ _ (qmap a) (vmap f)). intros p I.
  apply in_map_iff in I as (p' & <- & I). apply C, andb_true_iff in I as [A B].
  apply (ltb_sound value) in A. apply check_ball_inside_sound in B. unfold reach_error in B.
  autorewrite with values in A, B. split; assumption.
Qed.

Lemma middle_of_sound {X Y} {lx : Lin T X} {ly : Lin R Y} (f : X -> Y) i j xs : keeps_sums value f ->
  f (middle_of i j xs) = lscale (1 / 2) (ladd (nth i (map f xs) lzero) (nth j (map f xs) lzero)).
Proof. intros (Z & A & S). unfold middle_of. now rewrite S, A, (value_half (Exact := ex)), <- Z, !map_nth. Qed.
Lemma map_set_nth {X Y} (f : X -> Y) k y xs : map f (set_nth k y xs) = set_nth k (f y) (map f xs).
Proof. revert k; induction xs as [|x xs IH]; intros [|k]; cbn; auto. now rewrite IH. Qed.
Lemma check_bound_sound {X Y} {lx : Lin T X} {ly : Lin R Y} {ey : Euclid Y} (f : X -> Y) (good : Y -> Prop) step :
  keeps_sums value f -> (forall b xs, step b xs = true -> all_blends good (map f xs)) ->
  forall b xs, check_bound step b xs = true -> all_blends good (map f xs).
Proof.
  intros F H b. induction b as [| | | |i j b1 IH1 b2 IH2|of_joints of_blends]; intros xs; cbn [check_bound]; try apply H.
  rewrite !andb_true_iff, !Nat.ltb_lt. intros [[[I J] A] B]. apply IH1 in A. apply IH2 in B.
  rewrite map_set_nth, (middle_of_sound f) in A, B by exact F.
  apply (halves_good good (map f xs) i j); rewrite ?map_length; auto.
Qed.
Lemma spherical_sound x c s b xs : check_bound (check_spherical x c s) b xs = true ->
  all_blends (spherical_good (vmap x) (vmap c) (value s)) (map smap xs).
Proof.
  apply check_bound_sound.
  { exact (pair_keeps_sums value qmap vmap (qmap_keeps_sums value) (vmap_keeps_sums value)). }
  clear b xs. intros [|a| |a f|k l b1 b2|of_joints of_blends] ys H; try discriminate.
  - now apply spherical_control_sound.
  - now apply spherical_cap_sound with a.
  - now apply spherical_all_sound.
Qed.
Lemma dual_sound x c s b xs : check_bound (check_dual x c s) b xs = true ->
  all_blends (dual_good (vmap x) (vmap c) (value s)) (map dmap xs).
Proof.
  apply check_bound_sound.
  { exact (pair_keeps_sums value qmap qmap (qmap_keeps_sums value) (qmap_keeps_sums value)). }
  clear b xs. intros [|a| |a f|k l b1 b2|of_joints of_blends] ys H; try discriminate.
  - now apply dual_control_sound.
  - now apply dual_reach_sound with a f.
Qed.

(* --- Pieces --- *)

Lemma check_weight_vertices_sound joints data ws : check_weight_vertices joints data ws = true ->
  data = joints /\ forall w, In w ws -> Forall (Rle 0) (map value w).
Proof.
  unfold check_weight_vertices. rewrite andb_true_iff, Nat.eqb_eq, forallb_forall. intros [D W]. split; [exact D|].
    intros w I.
  apply W in I. unfold check_weights in I. rewrite !andb_true_iff, forallb_forall in I. destruct I as [[_ I] _].
  apply Forall_map, Forall_forall. intros x X. apply I, (leb_sound value) in X. now rewrite (value_zero (Exact := ex)) in X.
Qed.

Lemma joint_images_map qs ts p :
  map vmap (joint_images qs ts p) = joint_images (map qmap qs) (map vmap ts) (vmap p).
Proof.
  unfold joint_images. revert ts; induction qs as [|q qs IH]; intros [|t ts]; cbn [combine map]; try reflexivity.
  f_equal; [|apply IH]. cbn [fst snd]. unfold joint_image.
  repeat rewrite ?(vmap_add value), ?(vmap_scale value), ?(vmap_cross value), ?(vmap_im value), ?(value_add (Exact := ex)),
    ?(value_one (Exact := ex)). reflexivity.
Qed.
Lemma growths_map qs : map value (map growth qs) = map linear_growth (map qmap qs).
Proof.
  rewrite !map_map. apply map_ext. intros q. unfold growth, linear_growth. cbv zeta. autorewrite with values. reflexivity.
Qed.

Lemma absolute_sound x : value (absolute x) = Rabs (value x).
Proof.
  unfold absolute. autorewrite with values. unfold Rmax, Rabs. destruct (Rle_dec _ _), (Rcase_abs _); lra.
Qed.
Lemma value_dot (a b : vec T) : value (vdot a b) = dot (vmap a) (vmap b).
Proof. unfold vdot. autorewrite with values. reflexivity. Qed.
Lemma check_stretch_sound m s : check_stretch m s = true -> stretches (matrix_map value m) (value s).
Proof.
  destruct m as [[a b] c]. unfold check_stretch. rewrite !andb_true_iff. intros [[[P A] B] C].
  apply (leb_sound value) in P, A, B, C. autorewrite with values in P, A, B, C. rewrite !absolute_sound, !value_dot in *.
  split; [exact P|]. unfold squared_stretch, row_sum. cbn [matrix_map fst snd].
  rewrite (dot_comm (vmap b) (vmap a)), (dot_comm (vmap c) (vmap a)), (dot_comm (vmap c) (vmap b)).
  fold (norm2 (vmap a)) (norm2 (vmap b)) (norm2 (vmap c)). rewrite !(Rabs_pos_eq (norm2 _)) by apply norm2_nonneg.
  repeat apply Rmax_lub; assumption.
Qed.
Lemma check_both_sound {X Y} (test : X -> Y -> bool) xs ys : check_both test xs ys = true ->
  Forall2 (fun x y => test x y = true) xs ys.
Proof.
  revert ys; induction xs as [|x xs IH]; intros [|y ys]; cbn [check_both]; try discriminate; [constructor|].
  rewrite andb_true_iff. intros [A B]. constructor; auto.
Qed.
Lemma affine_images_map ms bs p :
  map vmap (affine_images ms bs p) = affine_images (map (matrix_map value) ms) (map vmap bs) (vmap p).
Proof.
  unfold affine_images. revert bs; induction ms as [|m ms IH]; intros [|b bs]; cbn [combine map]; try reflexivity.
  f_equal; [|apply IH]. cbn [fst snd]. unfold turned_by, matrix_map. cbn [fst snd].
  rewrite !(vmap_add value), !(vmap_scale value). reflexivity.
Qed.
Lemma matrix_keeps_sums : keeps_sums value (matrix_map value).
Proof.
  pose proof (vmap_keeps_sums value) as V.
  exact (pair_keeps_sums value _ _ (pair_keeps_sums value _ _ V V) V).
Qed.
(* At each weight vertex. *)
Lemma check_affine_sound ms bs p r c s of_joints of_weight_vertices ws v : length bs = length ms ->
  check_affine ms bs p r c s of_joints of_weight_vertices ws = true ->
  in_ball (Ball (vmap p) (value r)) v -> forall w, In w ws -> Forall (Rle 0) (map value w) ->
  in_ball (Ball (vmap c) (value s)) (comb (map value w) (affine_images (map (matrix_map value) ms) (map vmap bs) v)).
Proof.
  unfold check_affine. rewrite andb_true_iff. intros L [J W] V w I Pos. apply check_both_sound in J, W.
  assert (S : Forall2 stretches (map (matrix_map value) ms) (map value of_joints)).
  { clear - J ex. induction J; cbn [map]; constructor; auto. now apply check_stretch_sound. }
  assert (E : exists stretch, (leb (comb w of_joints) stretch || check_stretch (comb w ms) stretch)
    && check_ball_inside (comb w (affine_images ms bs p)) zero c (sub s (mul r stretch)) = true).
  { clear - W I. induction W as [|x y xs ys H _ IH]; [destruct I|destruct I as [->|I]; eauto]. }
  destruct E as (stretch & E). apply andb_true_iff in E as [By B]. apply check_ball_inside_sound, ball_is_inside_norm in B;
    rewrite (value_zero (Exact := ex)) in *; [|lra].
  rewrite sqrt_0, (comb_map value _ w _ (vmap_keeps_sums value)), affine_images_map in B.
  rewrite (value_sub (Exact := ex)), (value_mul (Exact := ex)) in B.
  pose proof (blend_is_in_control_ball_holds (map (matrix_map value) ms) (map vmap bs) (map value of_joints) (map value w)
    (vmap p) (value r) v (value stretch) S) as H.
  rewrite !map_length in H. specialize (H L Pos).
  assert (G : stretches (comb (map value w) (map (matrix_map value) ms)) (value stretch) \/
    comb (map value w) (map value of_joints) <= value stretch).
  { apply orb_true_iff in By as [By|By].
    - right. apply (leb_sound value) in By. now rewrite (comb_map value _ w _ (value_keeps_sums value)) in By.
    - left. apply check_stretch_sound in By. now rewrite (comb_map value _ w _ matrix_keeps_sums) in By. }
  specialize (H G V). unfold in_ball in *. cbn [center radius] in *.
  eapply Rle_trans; [apply norm_triangle with (y := comb (map value w) (affine_images (map (matrix_map value) ms) (map vmap bs) (vmap p)))|].
  lra.
Qed.

(* Weight vertices that are chosen, and what they make of something that is combined. *)
Lemma chosen_in_hull {X} {l : Lin R X} {e : Euclid X} (f : list R -> X) (all chosen : list (list R)) u :
  (forall w, In w chosen -> In w all) -> convex (length chosen) u -> in_hull (map f all) (comb u (map f chosen)).
Proof.
  intros I U. apply convex_set_comb; [apply hull_convex|now rewrite map_length|].
  apply Forall_map, Forall_forall. intros w W. apply hull_point, in_map, I, W.
Qed.

(* What a piece that is checked says of weights that are a combination of some of its weight vertices. *)
Lemma check_piece_sound sets b p : check_piece sets b p = true ->
  exists js, nth_error sets (set_of_piece p) = Some js /\
  forall chosen u w v, (forall c, In c chosen -> In c (map (map value) (weight_vertices p))) -> convex (length chosen) u ->
  (forall i, nth i w 0 = comb u (map (fun c => nth i c 0) chosen)) ->
  in_ball (as_ball (sphere_map value (reference p))) v -> is_skinned (joint_set_map value js) w ->
  in_ball (as_ball (sphere_map value b)) (skin (joint_set_map value js) w v).
Proof.
  unfold check_piece. rewrite andb_true_iff. intros [R0 H]. destruct (nth_error sets (set_of_piece p)) as [js|]; [|discriminate].
  exists js. split; [reflexivity|]. intros chosen u w v Ch U Q V S. unfold in_ball in *. cbn [as_ball center radius sphere_map middle reach] in *.
  assert (Sub : value (sub (reach b) (reach (reference p))) = value (reach b) - value (reach (reference p)))
    by apply value_sub.
  destruct js as [qs images rotation_center|qs ds|qs ts|ms bs]; cbn [joint_set_map skin is_skinned] in *; rewrite !andb_true_iff in H.
  - destruct H as [_ H]. apply spherical_sound in H. rewrite (vmap_sub value), Sub in H.
    set (f := fun w => (comb w (map qmap qs), comb w (map vmap images)) : quat R * vec R).
    assert (E : map smap (map (fun w => (comb w qs, comb w images)) (weight_vertices p)) = map f
      (map (map value) (weight_vertices p))).
    { rewrite !map_map. apply map_ext. intros c. unfold smap, f. cbn [fst snd].
      now rewrite (comb_map value _ c qs (qmap_keeps_sums value)), (comb_map value _ c images (vmap_keeps_sums value)). }
    rewrite E in H.
    assert (B : comb u (map f chosen) = f w).
    { rewrite comb_pair, !map_map. unfold f. cbn [fst snd]. now rewrite !(swap_sums u chosen w). }
    pose proof (chosen_in_hull f _ chosen u Ch U) as Z. rewrite B in Z. apply H in Z.
    unfold skin_spherical. exact (spherical_ball _ _ _ _ _ v (f w) Z V S).
  - destruct H as [_ H]. apply dual_sound in H. rewrite Sub in H.
    set (f := fun w => (comb w (map qmap qs), comb w (map qmap ds)) : quat R * quat R).
    assert (E : map dmap (map (fun w => (comb w qs, comb w ds)) (weight_vertices p)) = map f
      (map (map value) (weight_vertices p))).
    { rewrite !map_map. apply map_ext. intros c. unfold dmap, f. cbn [fst snd].
      now rewrite !(comb_map value _ c _ (qmap_keeps_sums value)). }
    rewrite E in H.
    assert (B : comb u (map f chosen) = f w).
    { rewrite comb_pair, !map_map. unfold f. cbn [fst snd]. now rewrite !(swap_sums u chosen w). }
    pose proof (chosen_in_hull f _ chosen u Ch U) as Z. rewrite B in Z. apply H in Z.
    unfold skin_dual. exact (dual_ball _ _ _ _ v (f w) Z V S).
  - destruct H as [C H]. apply check_weight_vertices_sound in C as [L W]. destruct (why p); try discriminate.
    rewrite (swap_sums u chosen w _ Q). unfold weight_vertex_images.
    apply (convex_set_comb (in_ball (Ball (vmap (middle b)) (value (reach b))))); [apply ball_convex|now rewrite map_length|].
    apply Forall_map, Forall_forall. intros c I. apply Ch, in_map_iff in I as (c' & <- & I).
    unfold check_linear in H. rewrite forallb_forall in H. specialize (H c' I). specialize (W c' I).
    apply check_ball_inside_sound, ball_is_inside_norm in H; rewrite (value_zero (Exact := ex)) in *; [|lra].
    rewrite sqrt_0, (comb_map value _ c' _ (vmap_keeps_sums value)), joint_images_map in H.
    rewrite (value_sub (Exact := ex)), (value_mul (Exact := ex)), (comb_map value _ c' _ (value_keeps_sums value)), growths_map in H.
    unfold in_ball. cbn [center radius].
    assert (D := images_difference (map qmap qs) (map vmap ts) (map value c') (vmap (middle (reference p))) v W).
    rewrite !map_length in D. specialize (D L).
    set (iv := comb (map value c') (joint_images (map qmap qs) (map vmap ts) v)) in *.
    set (ip := comb (map value c') (joint_images (map qmap qs) (map vmap ts) (vmap (middle (reference p))))) in *.
    pose proof (norm_triangle iv ip (vmap (middle b))).
    assert (G : 0 <= comb (map value c') (map linear_growth (map qmap qs))).
    { rewrite <- (Rmult_0_l (sum (map value c'))) at 1. clear - W. revert W. generalize (map value c') as l, (map qmap qs) as m.
      induction l as [|a l IH]; intros [|q m] W; cbn [map comb sum fold_right]; try (cbn; lra).
      apply Forall_cons_iff in W as [A W]. specialize (IH m W). cbn [ladd lscale lin_num add mul ops_R].
      pose proof (linear_growth_nonneg q). rewrite Rmult_0_l in *. nra. }
    nra.
  - destruct H as [C H]. apply check_weight_vertices_sound in C as [L W]. destruct (why p); try discriminate.
    rewrite (swap_sums u chosen w _ Q). unfold weight_vertex_images.
    apply (convex_set_comb (in_ball (Ball (vmap (middle b)) (value (reach b))))); [apply ball_convex|now rewrite map_length|].
    apply Forall_map, Forall_forall. intros c I. apply Ch, in_map_iff in I as (c' & <- & I).
    eapply check_affine_sound; eauto.
Qed.

(* --- Vertices --- *)

Lemma nth_map_value w i : value (nth i w zero) = nth i (map value w) 0.
Proof. rewrite <- (value_zero (Exact := ex)). now rewrite map_nth. Qed.

Lemma check_vertex_sound ps v : check_vertex ps v = true ->
  exists p chosen u, nth_error ps (piece_of_vertex v) = Some p /\
  (forall c, In c chosen -> In c (map (map value) (weight_vertices p))) /\ convex (length chosen) u /\
  (forall i, nth i (map value (weights v)) 0 = comb u (map (fun c => nth i c 0) chosen)) /\
  (0 <= value (reach (reference p)) -> in_ball (as_ball (sphere_map value (reference p))) (vmap (position v))).
Proof.
  unfold check_vertex. destruct (nth_error ps (piece_of_vertex v)) as [p|]; [|discriminate]. cbv zeta.
  set (chosen := map (fun k => nth k (weight_vertices p) []) (places v)). set (total := sum_of (shares v)).
  rewrite !andb_true_iff, !forallb_forall, Nat.eqb_eq. intros [[[[[[B K] L] P] S] C] Q].
  apply (ltb_sound value) in S. rewrite (value_zero (Exact := ex)) in S. pose proof (inv_pos _ S) as I.
  exists p, (map (map value) chosen), (map (Rmult (/ value total)) (map value (shares v))). split; [reflexivity|].
  assert (Pos : Forall (Rle 0) (map value (shares v))).
  { apply Forall_map, Forall_forall. intros x X. apply P, (leb_sound value) in X. now rewrite (value_zero (Exact := ex)) in X. }
  split; [|split; [|split]].
  - intros c X. apply in_map_iff in X as (w & <- & X). apply in_map. unfold chosen in X.
    apply in_map_iff in X as (k & <- & X). apply nth_In, Nat.ltb_lt, K, X.
  - split; [|split].
    + unfold chosen. rewrite !map_length. exact L.
    + apply scale_nonneg; [lra|exact Pos].
    + rewrite sum_scale, <- (value_sum value). fold total. apply Rinv_l. lra.
  - intros i. rewrite comb_scale, map_map. destruct (Nat.lt_ge_cases i (length (weights v))) as [J|J].
    + assert (E : In i (seq 0 (length (weights v)))) by (apply in_seq; lia). apply Q, (eqb_sound value) in E.
      rewrite (value_mul (Exact := ex)), (comb_map value _ _ _ (value_keeps_sums value)), nth_map_value, map_map in E.
      rewrite (map_ext _ (fun w => nth i (map value w) 0)) in E by (intros; apply nth_map_value).
      rewrite <- E. cbn [lscale lin_num mul ops_R]. field. lra.
    + rewrite nth_overflow by (now rewrite map_length).
      assert (Z : map (fun w => nth i (map value w) 0) chosen = repeat 0 (length chosen)).
      { clear - C J. induction chosen as [|w chosen IH]; cbn [map repeat length]; [reflexivity|].
        rewrite IH by (intros x X; apply C; now right).
        specialize (C w (or_introl eq_refl)). apply Nat.eqb_eq in C. rewrite nth_overflow; [reflexivity|].
        rewrite map_length. lia. }
      rewrite Z, comb_same by (unfold chosen; rewrite !map_length; exact L). cbn. ring.
  - intros R0. apply (leb_sound value) in B. autorewrite with values in B. unfold in_ball.
    cbn [as_ball sphere_map middle reach center radius]. apply norm_le. split; [exact R0|exact B].
Qed.

(* --- The certificate --- *)

Lemma check_is_sound (c : certificate T) : check c = true -> claim (certificate_map value c).
Proof.
  unfold check. rewrite andb_true_iff, !forallb_forall. intros [P V].
  split; [intros v I|intros p I]; cbn [certificate_map vertices pieces] in I;
    apply in_map_iff in I as (x & <- & I).
  - specialize (V x I). destruct (check_vertex_sound (pieces c) x V) as (p & chosen & u & N & Ch & U & Q & B).
    apply nth_error_In in N as In_p. specialize (P p In_p). pose proof P as P'.
    destruct (check_piece_sound (joint_sets c) (enclosing c) p P') as (js & J & H).
    exists (joint_set_map value js). split.
    + unfold set_at. cbn [certificate_map pieces joint_sets vertex_map piece_of_vertex].
      rewrite (map_nth_error _ _ _ N). cbn [piece_map set_of_piece]. now apply map_nth_error.
    + intros S. apply (H chosen u); auto. apply B. unfold check_piece in P. apply andb_true_iff in P as [P _].
      apply (leb_sound value) in P. now rewrite (value_zero (Exact := ex)) in P.
  - specialize (P x I). destruct (check_piece_sound (joint_sets c) (enclosing c) x P) as (js & J & H).
    exists (joint_set_map value js). split; [now apply map_nth_error|].
    intros w v (u & U & Q) B S. apply (H (map (map value) (weight_vertices x)) u); auto.
Qed.
End Soundness.
