(* SPDX-License-Identifier: MIT *)
(* How fast a point goes below a chain of joints, and how much it bends: the rule of Leibniz for bounds, of a product whose length
   is at most that of its factors, link by link. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.quaternion Refitlab.theory.curve.
Require Import Refitlab.c2_channel_motion.
Import ListNotations.

Definition short_product {X Y Z} `{Euclid X} `{Euclid Y} `{Euclid Z} (B : X -> Y -> Z) :=
  forall x y, norm (B x y) <= norm x * norm y.

Definition is_wider (wide m : motion) := size m <= size wide /\ speed m <= speed wide /\ acceleration m <= acceleration wide.

(* A link carries y to t + q (s y) q*, which turns by the quaternion q where its length is 1: three curves, and their bounds. A scale
   is measured by its greatest factor. *)
Record link := Link { turn : R -> quat R; translation : R -> vec R; scale : R -> vec R }.
Record link_motion := LinkMotion { of_turn : motion; of_translation : motion; of_scale : motion }.
Definition posed (k : link) (y : vec R) (t : R) := (translation k t + turned (turn k t) (scaled (scale k t) y) (turn k t))%V.
Definition scale_moves (s : R -> vec R) (m : motion) (a b : R) := exists s' s'', derivative s s' a b /\ derivative s' s'' a b /\
  forall t, a <= t <= b ->
    factors_within (s t) (size m) /\ factors_within (s' t) (speed m) /\ factors_within (s'' t) (acceleration m).
Definition link_moves (a b : R) (k : link) (m : link_motion) :=
  moves (turn k) (of_turn m) a b /\ moves (translation k) (of_translation m) a b /\ scale_moves (scale k) (of_scale m) a b.

(* The bounds of a chain's linear part, offset and rotation, the first link first; and a point that moves below it. *)
Record chain_motion := ChainMotion { linear_part : motion; offset : motion; of_rotation : motion }.
Definition no_links := ChainMotion (at_rest 1) (at_rest 0) (at_rest 1).
Definition chain_of (m : link_motion) := ChainMotion
  (product_of_motions (product_of_motions (of_turn m) (of_turn m)) (of_scale m)) (of_translation m) (of_turn m).
Definition compose (outer inner : chain_motion) := ChainMotion (product_of_motions (linear_part outer) (linear_part inner))
  (sum_of_motions (product_of_motions (linear_part outer) (offset inner)) (offset outer))
  (product_of_motions (of_rotation outer) (of_rotation inner)).
Definition chain (motions : list link_motion) := fold_left (fun c m => compose c (chain_of m)) motions no_links.
Definition carried_motion (c : chain_motion) (point : motion) := sum_of_motions (product_of_motions (linear_part c) point) (offset c).
Definition image (links : list link) (x : R -> vec R) (t : R) := fold_right (fun k y => posed k y t) (x t) links.
Definition linear_image (links : list link) (x : R -> vec R) (t : R) :=
  fold_right (fun k y => turned (turn k t) (scaled (scale k t) y) (turn k t)) (x t) links.
Definition turn_of_chain (links : list link) (t : R) := fold_right (fun k q => qmul (turn k t) q) (Quat 1 0 0 0) links.

(* --- Statements --- *)

(* A scale moves as its three factors do. *)
Definition scale_by_axes : Prop := forall (s : R -> vec R) m a b, moves (fun t => vx (s t)) m a b -> moves (fun t => vy (s t)) m a b ->
  moves (fun t => vz (s t)) m a b -> scale_moves s m a b.

(* A link between two keys, by linear channels and a slerp. *)
Definition channels_move_a_link : Prop := forall (q r : quat R) (t u s v : vec R) (theta T n f g : R), 0 < T -> 0 < theta < PI ->
  norm2 q = 1 -> norm2 r = 1 -> dot q r = cos theta -> norm t <= n -> norm u <= n ->
  factors_within s f -> factors_within v f -> factors_within (v - s)%V (g * T) ->
  link_moves 0 T (Link (slerp q r theta T) (linear_channel t u T) (linear_channel s v T))
    (LinkMotion (Motion 1 (theta / T) (theta * theta / (T * T))) (Motion n (norm (u - t) / T) 0) (Motion f g 0)).
(* What a product's derivatives are by the rule of Leibniz moves within the product of the bounds. *)
Definition product_moves : Prop := forall X Y Z (lx : Lin R X) (ly : Lin R Y) (lz : Lin R Z) (ex : Euclid X) (ey : Euclid Y)
  (ez : Euclid Z) (B : X -> Y -> Z) (x x' x'' : X) (y y' y'' : Y) (s s' s'' t t' t'' : R),
  short_product B -> moves_within x x' x'' s s' s'' -> moves_within y y' y'' t t' t'' ->
  moves_within (B x y) (B x' y + B x y')%V (B x'' y + 2 *: B x' y' + B x y'')%V
    (s * t) (s' * t + s * t') (s'' * t + 2 * s' * t' + s * t'').
(* So the product of two curves moves within the product. *)
Definition curves_multiply : Prop := forall X Y Z (lx : Lin R X) (ly : Lin R Y) (lz : Lin R Z) (ex : Euclid X) (ey : Euclid Y)
  (ez : Euclid Z) (B : X -> Y -> Z) (f : R -> X) (g : R -> Y) (m n : motion) (a b : R),
  is_product B -> short_product B -> moves f m a b -> moves g n a b ->
  moves (fun t => B (f t) (g t)) (product_of_motions m n) a b.
Definition quaternions_are_short : Prop := short_product (fun a b : quat R => qmul a b).
(* A sum moves within the sum. *)
Definition curves_add : Prop := forall X (lx : Lin R X) (ex : Euclid X) (f g : R -> X) (m n : motion) (a b : R),
  moves f m a b -> moves g n a b -> moves (fun t => f t + g t)%V (sum_of_motions m n) a b.
(* A point below a chain of joints, and what the chain turns by. *)
Definition chain_moves : Prop := forall links motions (x : R -> vec R) (point : motion) (a b : R),
  Forall2 (link_moves a b) links motions -> moves x point a b ->
  moves (image links x) (carried_motion (chain motions) point) a b /\ moves (turn_of_chain links) (of_rotation (chain motions)) a b.
(* The same of A and b by themselves, for A x + b. *)
Definition chain_parts_move : Prop := forall links motions (a b : R), Forall2 (link_moves a b) links motions ->
  (forall (x : R -> vec R) point, moves x point a b ->
    moves (linear_image links x) (product_of_motions (linear_part (chain motions)) point) a b) /\
  moves (image links (fun _ => lzero)) (offset (chain motions)) a b /\
  forall x t, image links x t = (linear_image links x t + image links (fun _ => lzero) t)%V.
(* A hinge at a constant speed reaches them: its quaternion goes at h, and a point at the distance r of the axis at 2 h r. *)
Definition hinge (h : R) := Link (fun t => Quat (cos (h * t)) (sin (h * t)) 0 0) (fun _ => Vec 0 0 0) (fun _ => Vec 1 1 1).
Definition hinge_motion (h : R) := LinkMotion (Motion 1 h (h * h)) (at_rest 0) (at_rest 1).
Definition hinge_reaches_bounds : Prop := forall h r a b : R, 0 <= h -> 0 <= r -> link_moves a b (hinge h) (hinge_motion h) /\
  let bound := carried_motion (chain [hinge_motion h]) (at_rest r) in
  exists f' f'', derivative (image [hinge h] (fun _ => Vec 0 r 0)) f' a b /\ derivative f' f'' a b /\
  forall t, norm (image [hinge h] (fun _ => Vec 0 r 0) t) = size bound /\ norm (f' t) = speed bound /\ norm (f'' t) = acceleration bound.

(* --- Proofs --- *)

Lemma short_product_at_most {X Y Z} `{Euclid X} `{Euclid Y} `{Euclid Z} (B : X -> Y -> Z) x y (s t : R) :
  short_product B -> norm x <= s -> norm y <= t -> norm (B x y) <= s * t.
Proof.
  intros Sh S T. eapply Rle_trans; [apply Sh|]. pose proof (norm_nonneg x). pose proof (norm_nonneg y).
  apply Rmult_le_compat; lra.
Qed.

Theorem product_moves_holds : product_moves.
Proof.
  intros X Y Z lx ly lz ex ey ez B x x' x'' y y' y'' s s' s'' t t' t'' Sh (S0 & S1 & S2) (T0 & T1 & T2).
  pose proof (fun a b k l => short_product_at_most B a b k l Sh) as P. split; [|split]; [auto| |].
  - eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; auto.
  - eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; auto.
    eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; auto. rewrite norm_scale by lra.
    pose proof (P x' y' s' t' S1 T1). lra.
Qed.

Theorem curves_multiply_holds : curves_multiply.
Proof.
  intros X Y Z lx ly lz ex ey ez B f g m n a b P Sh (f' & f'' & F & F' & M) (g' & g'' & G & G' & N).
  exists (fun t => B (f' t) (g t) + B (f t) (g' t))%V, (fun t => B (f'' t) (g t) + 2 *: B (f' t) (g' t) + B (f t) (g'' t))%V.
  split; [now apply derivative_product|]. split; [now apply second_derivative_of_product|].
  intros t T. exact (product_moves_holds _ _ _ _ _ _ _ _ _ B _ _ _ _ _ _ _ _ _ _ _ _ Sh (M t T) (N t T)).
Qed.

Theorem quaternions_are_short_holds : quaternions_are_short.
Proof. intros a b. apply Req_le, norm_qmul. Qed.

Theorem curves_add_holds : curves_add.
Proof.
  intros X lx ex f g m n a b (f' & f'' & F & F' & M) (g' & g'' & G & G' & N).
  exists (fun t => f' t + g' t)%V, (fun t => f'' t + g'' t)%V.
  split; [now apply derivative_sum|]. split; [now apply derivative_sum|]. intros t T.
  destruct (M t T) as (M0 & M1 & M2). destruct (N t T) as (N0 & N1 & N2). cbn [size speed acceleration sum_of_motions].
  split; [|split]; (eapply Rle_trans; [apply norm_add|]); lra.
Qed.

Lemma moves_wider {E} `{Euclid E} (f : R -> E) (m wide : motion) a b : is_wider wide m -> moves f m a b -> moves f wide a b.
Proof.
  intros (W0 & W1 & W2) (f' & f'' & F & F' & M). exists f', f''. split; [exact F|]. split; [exact F'|]. intros t T.
  destruct (M t T) as (M0 & M1 & M2). split; [|split]; lra.
Qed.
(* A linear map that makes nothing longer. *)
Lemma curve_mapped {X Y} `{Euclid X} `{Euclid Y} (L : X -> Y) (f : R -> X) m a b : has_adjoint L -> (forall x, norm (L x) <= norm x) ->
  moves f m a b -> moves (fun t => L (f t)) m a b.
Proof.
  intros A Sh (f' & f'' & F & F' & M). exists (fun t => L (f' t)), (fun t => L (f'' t)).
  split; [now apply derivative_map|]. split; [now apply derivative_map|]. intros t T. destruct (M t T) as (M0 & M1 & M2).
  split; [|split]; (eapply Rle_trans; [apply Sh|]); assumption.
Qed.
Lemma moves_same {X} `{Euclid X} (f g : R -> X) (m n : motion) a b : (forall t, f t = g t) -> m = n -> moves f m a b -> moves g n a b.
Proof.
  intros S <- (f' & f'' & F & F' & M). exists f', f''. split; [now apply (derivative_same f g f' f')|]. split; [exact F'|].
  intros t T. rewrite <- S. now apply M.
Qed.
Lemma constant_moves {X} `{Euclid X} (x : X) s a b : norm x <= s -> moves (fun _ => x) (at_rest s) a b.
Proof.
  intros N. exists (fun _ => lzero), (fun _ => lzero). split; [apply derivative_constant|]. split; [apply derivative_constant|].
  intros t _. cbn [size speed acceleration at_rest]. repeat split; rewrite ?norm_zero; lra.
Qed.

(* --- A link --- *)

Lemma norm_of_number (x : R) : norm x = Rabs x.
Proof. apply norm_eq; [apply Rabs_pos|]. unfold norm2. cbn. rewrite <- Rabs_mult. symmetry. apply Rabs_pos_eq, Rle_0_sqr. Qed.
Lemma derivative_by_axes (s s' : R -> vec R) a b : derivative (fun t => vx (s t)) (fun t => vx (s' t)) a b ->
  derivative (fun t => vy (s t)) (fun t => vy (s' t)) a b -> derivative (fun t => vz (s t)) (fun t => vz (s' t)) a b -> derivative s s' a b.
Proof.
  intros X Y Z e t T. specialize (X (vx e) t T). specialize (Y (vy e) t T). specialize (Z (vz e) t T). cbn in *. unfold vdot. cbn.
  exact (derivable_pt_lim_plus _ _ _ _ _ (derivable_pt_lim_plus _ _ _ _ _ X Y) Z).
Qed.
Theorem scale_by_axes_holds : scale_by_axes.
Proof.
  intros s m a b (x' & x'' & X & X' & Mx) (y' & y'' & Y & Y' & My) (z' & z'' & Z & Z' & Mz).
  exists (fun t => Vec (x' t) (y' t) (z' t)), (fun t => Vec (x'' t) (y'' t) (z'' t)).
  split; [now apply derivative_by_axes|]. split; [now apply derivative_by_axes|].
  intros t T. unfold factors_within. cbn [vx vy vz]. rewrite <- !norm_of_number.
  destruct (Mx t T) as (? & ? & ?), (My t T) as (? & ? & ?), (Mz t T) as (? & ? & ?). auto.
Qed.

Lemma conj_norm (q : quat R) : norm (conj q) <= norm q.
Proof. unfold norm. rewrite norm2_conj. lra. Qed.
Lemma pure_norm (x : vec R) : norm (pure x) <= norm x.
Proof. unfold norm. rewrite norm2_pure. lra. Qed.
Lemma im_norm (q : quat R) : norm (im q) <= norm q.
Proof. apply sqrt_le_1_alt, norm2_im. Qed.
Theorem channels_move_a_link_holds : channels_move_a_link.
Proof.
  intros q r t u s v theta T n f g P A Uq Ur D Nt Nu S V G. split; [|split]; cbn [turn translation scale of_turn of_translation of_scale].
  - now apply slerp_moves_holds.
  - now apply linear_moves_holds.
  - destruct S as (S0 & S1 & S2), V as (V0 & V1 & V2), G as (G0 & G1 & G2).
    assert (One : forall x y : R, Rabs x <= f -> Rabs y <= f -> Rabs (y - x) <= g * T -> moves (linear_channel x y T) (Motion f g 0) 0 T).
    { intros x y X Y Z. pose proof (linear_moves_holds R _ _ x y T f P) as M. rewrite !norm_of_number in M.
      apply (moves_wider _ _ _ 0 T) with (2 := M X Y). split; [apply Rle_refl|]. split; [|apply Rle_refl]. cbn [speed].
      apply Rmult_le_reg_r with T; [exact P|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. exact Z. }
    apply scale_by_axes_holds; now apply One.
Qed.
(* Im(a x b-conjugate). *)
Lemma turned_moves (p q : R -> quat R) (x : R -> vec R) (l m n : motion) a b : moves p l a b -> moves q n a b -> moves x m a b ->
  moves (fun t => turned (p t) (x t) (q t)) (product_of_motions (product_of_motions l m) n) a b.
Proof.
  intros P Q X. unfold turned. apply (curve_mapped (fun q : quat R => im q) (fun t => qmul (qmul (p t) (pure (x t))) (conj (q t))));
    [exact im_has_adjoint|exact im_norm|].
  apply (curves_multiply_holds _ _ _ _ _ _ _ _ _ _ (fun t => qmul (p t) (pure (x t))) (fun t => conj (q t)) _ _ a b
    qmul_is_product quaternions_are_short_holds).
  - apply (curves_multiply_holds _ _ _ _ _ _ _ _ _ _ p (fun t => pure (x t)) _ _ a b
      qmul_is_product quaternions_are_short_holds P).
    apply (curve_mapped (fun x : vec R => pure x) x); [exact pure_has_adjoint|exact pure_norm|exact X].
  - apply (curve_mapped (fun q : quat R => conj q) q); [exact conj_has_adjoint|exact conj_norm|exact Q].
Qed.
Lemma scaled_moves (s x : R -> vec R) (m n : motion) a b : scale_moves s m a b -> moves x n a b ->
  moves (fun t => scaled (s t) (x t)) (product_of_motions m n) a b.
Proof.
  intros (s' & s'' & S & S' & M) (x' & x'' & X & X' & N).
  exists (fun t => scaled (s' t) (x t) + scaled (s t) (x' t))%V,
    (fun t => scaled (s'' t) (x t) + 2 *: scaled (s' t) (x' t) + scaled (s t) (x'' t))%V.
  split; [exact (derivative_product scaled _ _ _ _ a b scaled_is_product S X)|].
  split; [exact (second_derivative_of_product scaled _ _ _ _ _ _ a b scaled_is_product S S' X X')|].
  intros t T. destruct (M t T) as (M0 & M1 & M2). destruct (N t T) as (N0 & N1 & N2). cbn [size speed acceleration product_of_motions].
  assert (P : forall s x f n, factors_within s f -> norm x <= n -> norm (scaled s x) <= f * n).
  { intros u x0 f n0 U X0. eapply Rle_trans; [apply (scaled_norm _ _ f U)|].
    apply Rmult_le_compat_l; [now apply factor_nonneg with u|exact X0]. }
  split; [|split].
  - now apply P.
  - eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; now apply P.
  - eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; [|now apply P].
    eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; [now apply P|]. rewrite norm_scale by lra.
    pose proof (P (s' t) (x' t) _ _ M1 N1). lra.
Qed.

(* --- Chains --- *)

Lemma motion_eq (m n : motion) : size m = size n -> speed m = speed n -> acceleration m = acceleration n -> m = n.
Proof. destruct m, n. cbn. now intros -> -> ->. Qed.
Ltac motions := intros; repeat match goal with m : motion |- _ => destruct m end; apply motion_eq;
  cbv [size speed acceleration sum_of_motions product_of_motions at_rest]; ring.
Lemma chain_eq (c d : chain_motion) : linear_part c = linear_part d -> offset c = offset d -> of_rotation c = of_rotation d -> c = d.
Proof. destruct c, d. cbn. now intros -> -> ->. Qed.
Lemma compose_associative c d e : compose c (compose d e) = compose (compose c d) e.
Proof.
  destruct c as [c0 c1 c2], d as [d0 d1 d2], e as [e0 e1 e2]. apply chain_eq; cbn [compose linear_part offset of_rotation]; motions.
Qed.
Lemma compose_none_l c : compose no_links c = c.
Proof. destruct c. apply chain_eq; cbn [compose no_links linear_part offset of_rotation]; motions. Qed.
Lemma compose_none_r c : compose c no_links = c.
Proof. destruct c. apply chain_eq; cbn [compose no_links linear_part offset of_rotation]; motions. Qed.
Lemma chain_cons m motions : chain (m :: motions) = compose (chain_of m) (chain motions).
Proof.
  unfold chain. cbn [fold_left]. rewrite compose_none_l.
  assert (G : forall ms c d, fold_left (fun c m => compose c (chain_of m)) ms (compose c d) =
    compose c (fold_left (fun c m => compose c (chain_of m)) ms d)).
  { induction ms as [|n ms IH]; intros c d; [reflexivity|]. cbn [fold_left]. rewrite <- IH. f_equal.
    symmetry. apply compose_associative. }
  rewrite <- G. now rewrite compose_none_r.
Qed.

Theorem chain_moves_holds : chain_moves.
Proof.
  intros links motions x point a b F X. induction F as [|k m links motions (Q & T & S) F [IH IHq]].
  - split.
    + apply (moves_same x _ point); [reflexivity| |exact X]. unfold chain, carried_motion.
      cbn [fold_left no_links linear_part offset]. motions.
    + apply (constant_moves (Quat 1 0 0 0) 1). apply Req_le, norm_unit. vunfold. ring.
  - rewrite chain_cons. split.
    + pose proof (scaled_moves _ _ _ _ a b S IH) as Y. pose proof (turned_moves _ _ _ _ _ _ a b Q Q Y) as Z.
      pose proof (curves_add_holds _ _ _ _ _ _ _ a b T Z) as W. eapply moves_same; [| |exact W]; [reflexivity|].
      destruct (chain motions), m. unfold carried_motion.
      cbn [compose chain_of linear_part offset of_turn of_translation of_scale]. motions.
    + exact (curves_multiply_holds _ _ _ _ _ _ _ _ _ _ _ _ _ _ a b qmul_is_product quaternions_are_short_holds Q IHq).
Qed.

Lemma image_is_affine ks x t : image ks x t = (linear_image ks x t + image ks (fun _ => lzero) t)%V.
Proof.
  induction ks as [|k ks IH]; cbn [image linear_image fold_right]; [vec_ring|].
  fold (image ks x t) (linear_image ks x t) (image ks (fun _ => lzero) t). rewrite IH. unfold posed, scaled.
  generalize (turn k t) (scale k t) (translation k t) (linear_image ks x t) (image ks (fun _ => lzero) t). vring.
Qed.
Theorem chain_parts_move_holds : chain_parts_move.
Proof.
  intros links motions a b F. split; [|split].
  - intros x point X. induction F as [|k m links motions (Q & T & S) F IH].
    + apply (moves_same x _ point); [reflexivity| |exact X]. unfold chain. cbn [fold_left no_links linear_part]. motions.
    + rewrite chain_cons. pose proof (scaled_moves _ _ _ _ a b S IH) as Y. pose proof (turned_moves _ _ _ _ _ _ a b Q Q Y) as Z.
      eapply moves_same; [| |exact Z]; [reflexivity|]. destruct (chain motions), m.
      cbn [compose chain_of linear_part of_turn of_scale]. motions.
  - destruct (chain_moves_holds links motions (fun _ => lzero) (at_rest 0) a b F) as [M _].
    { apply constant_moves. rewrite norm_zero. lra. }
    eapply moves_same; [| |exact M]; [reflexivity|]. unfold carried_motion. destruct (chain motions). cbn [linear_part offset]. motions.
  - intros x t. apply image_is_affine.
Qed.

(* A circle's derivatives are circles. *)
Lemma second_circle_derivative {E} `{Euclid E} (x y : E) k a b :
  derivative (fun t => k *: circle y (-1 *: x) k t)%V (fun t => (k * k * -1) *: circle x y k t)%V a b.
Proof.
  eapply derivative_same; [reflexivity| |apply (derivative_map (fun z => (k *: z)%V)); [apply scaling_has_adjoint|apply circle_derivative]].
  intros t _. unfold circle. vec_ring.
Qed.
Theorem hinge_reaches_bounds_holds : hinge_reaches_bounds.
Proof.
  intros h r a b Ph Pr. split.
  - split; [|split]; cbn [hinge hinge_motion turn translation scale of_turn of_translation of_scale].
    + pose (x := Quat 1 0 0 0). pose (y := Quat 0 1 0 0).
      assert (N : forall u v : quat R, norm2 u = 1 -> norm2 v = 1 -> dot u v = 0 -> forall t, norm (circle u v h t) = 1).
      { intros u v U V O t. apply norm_unit. now apply circle_norm2. }
      apply (moves_same (circle x y h) _ (Motion 1 h (h * h))); [|reflexivity|].
      * intros t. unfold circle, x, y. vunfold. f_equal; ring.
      * exists (fun t => h *: circle y (-1 *: x) h t)%V, (fun t => (h * h * -1) *: circle x y h t)%V.
        split; [apply circle_derivative|]. split; [apply second_circle_derivative|]. intros t _. cbn [size speed acceleration].
        assert (Ny : norm2 (-1 *: x)%V = 1 /\ dot y (-1 *: x)%V = 0) by (unfold x, y; vunfold; split; ring).
        split; [|split].
        -- right. apply N; unfold x, y; vunfold; ring.
        -- rewrite norm_scale by exact Ph. rewrite N; [lra|unfold y; vunfold; ring|apply Ny|apply Ny].
        -- replace (h * h * -1) with (- (h * h)) by ring. rewrite norm_scale_abs, Rabs_Ropp, Rabs_pos_eq by nra.
           rewrite N; [lra| | |]; unfold x, y; vunfold; ring.
    + apply constant_moves, norm_le. vunfold. lra.
    + exists (fun _ => lzero), (fun _ => lzero). split; [apply derivative_constant|]. split; [apply derivative_constant|].
      intros t _. unfold factors_within. vunfold. cbn [size speed acceleration at_rest]. rewrite Rabs_R0, Rabs_pos_eq; lra.
  - cbv zeta.
    pose (x := Vec 0 1 0). pose (y := Vec 0 0 1). exists (fun t => r *: (2 * h *: circle y (-1 *: x) (2 * h) t))%V,
      (fun t => r *: ((2 * h * (2 * h) * -1) *: circle x y (2 * h) t))%V.
    assert (N : forall u v : vec R, norm2 u = 1 -> norm2 v = 1 -> dot u v = 0 -> forall t, norm (circle u v (2 * h) t) = 1).
    { intros u v U V O t. apply norm_unit. now apply circle_norm2. }
    assert (Ny : norm2 (-1 *: x)%V = 1 /\ dot y (-1 *: x)%V = 0) by (unfold x, y; vunfold; split; ring).
    assert (I : forall t, image [hinge h] (fun _ => Vec 0 r 0) t = (r *: circle x y (2 * h) t)%V).
    { intros t. cbn [image fold_right]. unfold posed, scaled, circle, x, y. cbn [hinge turn translation scale].
      replace (2 * h * t) with (2 * (h * t)) by ring. rewrite cos_2a, sin_2a. generalize (cos (h * t)) (sin (h * t)). intros c s.
      vunfold. f_equal; ring. }
    split; [|split].
    + eapply derivative_same; [intros t; symmetry; apply I|intros; reflexivity|].
      apply (derivative_map (fun z => (r *: z)%V)); [apply scaling_has_adjoint|apply circle_derivative].
    + apply (derivative_map (fun z => (r *: z)%V)); [apply scaling_has_adjoint|apply second_circle_derivative].
    + intros t. rewrite I. unfold chain, carried_motion, hinge_motion, no_links, chain_of, compose, product_of_motions, sum_of_motions, at_rest.
      cbn [fold_left linear_part offset of_rotation of_turn of_translation of_scale size speed acceleration].
      rewrite !norm_scale by lra. replace (2 * h * (2 * h) * -1) with (- (2 * h * (2 * h))) by ring.
      rewrite norm_scale_abs, Rabs_Ropp, Rabs_pos_eq by nra.
      rewrite !N; try apply Ny; unfold x, y; try (vunfold; ring). split; [|split]; ring.
Qed.

(* The hypotheses can be met: a link that is at rest, twice as long, and a point in it. *)
Example chain_instance : let k := Link (fun _ => Quat 1 0 0 0) (fun _ => Vec 1 0 0) (fun _ => Vec 2 2 2) in
  Forall2 (link_moves 0 1) [k] [LinkMotion (at_rest 1) (at_rest 1) (at_rest 2)] /\ moves (fun _ => Vec 1 0 0) (at_rest 1) 0 1.
Proof.
  assert (N : norm (Vec 1 0 0) <= 1) by (apply norm_le; vunfold; lra).
  split; [|now apply constant_moves]. apply Forall2_cons; [|constructor].
  split; [|split]; cbn [of_turn of_translation of_scale turn translation scale].
  - apply constant_moves, norm_le. vunfold. lra.
  - now apply constant_moves.
  - exists (fun _ => lzero), (fun _ => lzero). split; [apply derivative_constant|]. split; [apply derivative_constant|].
    intros t _. unfold factors_within. vunfold. cbn [size speed acceleration at_rest]. rewrite Rabs_R0, Rabs_pos_eq; lra.
Qed.
Example channels_instance : let q := Quat 1 0 0 0 in let r := Quat 0 1 0 0 in let s := Vec 1 1 1 in let v := Vec 1 1 2 in
  0 < PI / 2 < PI /\ norm2 q = 1 /\ norm2 r = 1 /\ dot q r = cos (PI / 2) /\ norm (Vec 1 0 0) <= 1 /\
  factors_within s 2 /\ factors_within v 2 /\ factors_within (v - s)%V (1 * 1).
Proof.
  assert (A : forall x b : R, - b <= x <= b -> Rabs x <= b) by (intros x b X; now apply Rabs_le).
  pose proof PI_RGT_0. cbv zeta. rewrite cos_PI2. unfold factors_within. vunfold.
  repeat split; try lra; try (apply A; lra). apply norm_le. vunfold. lra.
Qed.
