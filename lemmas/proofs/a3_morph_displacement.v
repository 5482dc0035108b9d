(* SPDX-License-Identifier: MIT *)
(* Vertices displaced by morph targets, in any real inner product space. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.curve.
Require Import Refitlab.c4_chain_motion.
Import ListNotations.

(* v_0 + sum m_k d_k, and the ball about c + sum m_k c_k. *)
Definition displaced {E} `{Euclid E} (v0 : E) (m : list R) (ds : list E) := (v0 + comb m ds)%V.
Fixpoint more_radius {E} `{Euclid E} (m : list R) (balls : list (ball E)) : R :=
  match m, balls with a :: m, b :: balls => Rabs a * radius b + more_radius m balls | _, _ => 0 end.
Definition displaced_ball {E} `{Euclid E} (b : ball E) (m : list R) (balls : list (ball E)) : ball E :=
  Ball (center b + comb m (map center balls))%V (radius b + more_radius m balls).

(* --- Statements --- *)

(* (i) *)
Definition stays_in_displaced_ball : Prop := forall E (l : Lin R E) (H : Euclid E) (b : ball E) (balls : list (ball E)) v0 ds m,
  in_ball b v0 -> Forall2 in_ball balls ds -> length m = length balls ->
  in_ball (displaced_ball b m balls) (displaced v0 m ds).

(* (ii): a weight of the range [low, high] is at most half its width from its middle. lengths are no less than those of the centers. *)
Definition range : Type := R * R.
Definition is_in_range (m : R) (r : range) := fst r <= m <= snd r.
Definition middle (r : range) := (fst r + snd r) / 2.
Definition half (r : range) := (snd r - fst r) / 2.
Definition greatest (r : range) := Rmax (Rabs (fst r)) (Rabs (snd r)).
Definition is_no_shorter {E} `{Euclid E} (length : R) (b : ball E) := norm (center b) <= length.
Fixpoint more_radius_of_ranges {E} `{Euclid E} (ranges : list range) (lengths : list R) (balls : list (ball E)) : R :=
  match ranges, lengths, balls with
  | r :: ranges, l :: lengths, b :: balls => half r * l + greatest r * radius b + more_radius_of_ranges ranges lengths balls
  | _, _, _ => 0
  end.
Definition ball_of_ranges {E} `{Euclid E} (b : ball E) ranges lengths (balls : list (ball E)) : ball E :=
  Ball (center b + comb (map middle ranges) (map center balls))%V (radius b + more_radius_of_ranges ranges lengths balls).
Definition stays_in_ball_of_ranges : Prop := forall E (l : Lin R E) (H : Euclid E) (b : ball E) (balls : list (ball E)) v0 ds m ranges
  lengths, in_ball b v0 -> Forall2 in_ball balls ds -> Forall2 is_in_range m ranges -> Forall2 is_no_shorter lengths balls ->
  length m = length balls -> in_ball (ball_of_ranges b ranges lengths balls) (displaced v0 m ds).

(* (iii) *)
Definition product_of_ranges (a b : range) : range :=
  let p := fst a * fst b in let q := fst a * snd b in let r := snd a * fst b in let s := snd a * snd b in
  (Rmin (Rmin p q) (Rmin r s), Rmax (Rmax p q) (Rmax r s)).
Fixpoint displaced_slab (reference : range) (ranges displacements : list range) : range :=
  match ranges, displacements with
  | r :: ranges, d :: displacements => let more := product_of_ranges r d in
      displaced_slab (fst reference + fst more, snd reference + snd more) ranges displacements
  | _, _ => reference
  end.
Definition stays_in_displaced_slab : Prop := forall E (l : Lin R E) (H : Euclid E) (direction v0 : E) ds m reference ranges displacements,
  is_in_range (dot direction v0) reference -> Forall2 is_in_range m ranges ->
  Forall2 (fun d => is_in_range (dot direction d)) ds displacements -> length m = length ds ->
  is_in_range (dot direction (displaced v0 m ds)) (displaced_slab reference ranges displacements).

(* (iv): lengths are no less than those of the displacements. *)
Fixpoint displaced_motion (size : R) (lengths : list R) (weights : list motion) : motion :=
  match lengths, weights with
  | l :: lengths, w :: weights => sum_of_motions (product_of_motions w (at_rest l)) (displaced_motion size lengths weights)
  | _, _ => at_rest size
  end.
Definition displaced_moves : Prop := forall E (l : Lin R E) (H : Euclid E) (v0 : E) ds (m : list (R -> R)) size lengths weights a b,
  norm v0 <= size -> Forall2 (fun f w => moves f w a b) m weights -> Forall2 (fun k d => norm d <= k) lengths ds ->
  length m = length ds -> moves (fun t => displaced v0 (map (fun f => f t) m) ds) (displaced_motion size lengths weights) a b.

(* What a refit without displacements assumes is false. *)
Definition stays_in_reference_somewhere : Prop := forall (b : ball R) (v0 d m : R), in_ball b v0 -> in_ball b (v0 + m * d).

(* --- Proof --- *)


Lemma combinations_apart {E} `{Euclid E} (balls : list (ball E)) ds m : Forall2 in_ball balls ds -> length m = length balls ->
  norm (comb m ds - comb m (map center balls)) <= more_radius m balls.
Proof.
  intros F. revert m. induction F as [|b d balls ds I F IH]; intros [|a m] L; try discriminate.
  - cbn [comb map more_radius]. replace (lzero - lzero)%V with (0 *: (lzero : E))%V by vec_ring. rewrite norm_scale by lra. lra.
  - cbn [comb map more_radius].
    replace ((a *: d + comb m ds) - (a *: center b + comb m (map center balls)))%V with
      (a *: (d - center b) + (comb m ds - comb m (map center balls)))%V by vec_ring.
    eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; [|apply IH; now injection L].
    rewrite norm_scale_abs. apply Rmult_le_compat_l; [apply Rabs_pos|exact I].
Qed.

Theorem stays_in_displaced_ball_holds : stays_in_displaced_ball.
Proof.
  intros E l H b balls v0 ds m V F L. unfold in_ball, displaced_ball, displaced. cbn [center radius].
  replace ((v0 + comb m ds) - (center b + comb m (map center balls)))%V with
    ((v0 - center b) + (comb m ds - comb m (map center balls)))%V by vec_ring.
  eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; [exact V|now apply combinations_apart].
Qed.

Lemma range_around (m : R) (r : range) : is_in_range m r -> Rabs (m - middle r) <= half r /\ Rabs m <= greatest r.
Proof.
  intros [L U]. unfold middle, half, greatest. split; [apply Rabs_le; lra|]. pose proof (Rle_abs (snd r)). pose proof (Rle_abs (- fst r)).
  rewrite Rabs_Ropp in *. pose proof (Rmax_l (Rabs (fst r)) (Rabs (snd r))). pose proof (Rmax_r (Rabs (fst r)) (Rabs (snd r))).
  apply Rabs_le. lra.
Qed.
Lemma combinations_of_ranges_apart {E} `{Euclid E} (balls : list (ball E)) ds m ranges lengths : Forall2 in_ball balls ds ->
  Forall2 is_in_range m ranges -> Forall2 is_no_shorter lengths balls -> length m = length balls ->
  norm (comb m ds - comb (map middle ranges) (map center balls)) <= more_radius_of_ranges ranges lengths balls.
Proof.
  intros F. revert m ranges lengths. induction F as [|b d balls ds I F IH]; intros m ranges lengths M N L.
  - destruct M; [|discriminate]. cbn [comb map more_radius_of_ranges]. replace (lzero - lzero)%V with (0 *: (lzero : E))%V by vec_ring.
    rewrite norm_scale by lra. lra.
  - destruct M as [|a r m ranges A M]; [discriminate|]. inversion N as [|k b' lengths' balls' K N']; subst.
    cbn [comb map more_radius_of_ranges]. destruct (range_around a r A) as [Near Small].
    replace (_ - _)%V with ((a - middle r) *: center b + a *: (d - center b) +
      (comb m ds - comb (map middle ranges) (map center balls)))%V by vec_ring.
    eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; [|apply IH; auto].
    eapply Rle_trans; [apply norm_add|]. rewrite !norm_scale_abs.
    apply Rplus_le_compat; apply Rmult_le_compat; auto using Rabs_pos, norm_nonneg.
Qed.
Theorem stays_in_ball_of_ranges_holds : stays_in_ball_of_ranges.
Proof.
  intros E l H b balls v0 ds m ranges lengths V F M N L. unfold in_ball, ball_of_ranges, displaced. cbn [center radius].
  replace (_ - _)%V with ((v0 - center b) + (comb m ds - comb (map middle ranges) (map center balls)))%V by vec_ring.
  eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; [exact V|now apply combinations_of_ranges_apart].
Qed.

(* A product is between those of the ends of one factor, and so are these. *)
Lemma between_ends (x low high y : R) : low <= x <= high -> Rmin (low * y) (high * y) <= x * y <= Rmax (low * y) (high * y).
Proof.
  intros X. destruct (Rle_lt_dec 0 y).
  - rewrite Rmin_left, Rmax_right by nra. nra.
  - rewrite Rmin_right, Rmax_left by nra. nra.
Qed.
Lemma product_in_range (x y : R) (a b : range) : is_in_range x a -> is_in_range y b -> is_in_range (x * y) (product_of_ranges a b).
Proof.
  intros X Y. unfold is_in_range, product_of_ranges. cbn [fst snd]. destruct (between_ends x (fst a) (snd a) y X) as [L U].
  destruct (between_ends y (fst b) (snd b) (fst a) Y) as [L1 U1]. destruct (between_ends y (fst b) (snd b) (snd a) Y) as [L2 U2].
  rewrite !(Rmult_comm y), !(Rmult_comm (fst b)), !(Rmult_comm (snd b)) in L1, U1, L2, U2.
  split; [eapply Rle_trans; [|exact L]; apply Rmin_glb|eapply Rle_trans; [exact U|]; apply Rmax_lub].
  - eapply Rle_trans; [apply Rmin_l|apply L1].
  - eapply Rle_trans; [apply Rmin_r|apply L2].
  - eapply Rle_trans; [apply U1|apply Rmax_l].
  - eapply Rle_trans; [apply U2|apply Rmax_r].
Qed.
Theorem stays_in_displaced_slab_holds : stays_in_displaced_slab.
Proof.
  intros E l H direction v0 ds m reference ranges displacements V M. unfold displaced. revert v0 reference ds displacements V.
  induction M as [|a r m ranges A M IH]; intros v0 reference ds displacements V D L; destruct D as [|d s ds displacements S D];
    try discriminate; cbn [comb displaced_slab].
  - now replace (v0 + lzero)%V with v0 by vec_ring.
  - replace (v0 + (a *: d + comb m ds))%V with ((v0 + a *: d) + comb m ds)%V by vec_ring. apply IH; auto.
    pose proof (product_in_range a _ r s A S) as P. rewrite dot_add_r, dot_scale_r. unfold is_in_range in *. cbn [fst snd]. lra.
Qed.

Lemma scaling_is_short {E} `{Euclid E} : short_product (fun (s : R) (x : E) => (s *: x)%V).
Proof.
  intros s x. rewrite norm_scale_abs, norm_of_number. lra.
Qed.
Theorem displaced_moves_holds : displaced_moves.
Proof.
  intros E l H v0 ds m size lengths weights a b V M. revert ds lengths.
  induction M as [|f w m weights F M IH]; intros ds lengths K L; destruct K as [|k d lengths ds D K]; try discriminate.
  - apply (moves_same (fun _ => v0) _ (at_rest size)); [intros; unfold displaced; cbn [map comb]; vec_ring|reflexivity|].
    now apply constant_moves.
  - cbn [displaced_motion]. specialize (IH ds lengths K ltac:(now injection L)).
    pose proof (curves_multiply_holds _ _ _ _ _ _ _ _ _ (fun (s : R) (x : E) => (s *: x)%V) f (fun _ => d) w _ a b
      scaling_is_product scaling_is_short F (constant_moves d k a b D)) as P.
    pose proof (curves_add_holds _ _ _ _ _ _ _ a b P IH) as Q. eapply moves_same; [| |exact Q]; [|reflexivity].
    intros t. unfold displaced. cbn [map comb]. vec_ring.
Qed.

Theorem stays_in_reference_is_false : ~ stays_in_reference_somewhere.
Proof.
  intros F. assert (I : in_ball (Ball 0 1) 0).
  { unfold in_ball. cbn. apply norm_le. unfold norm2. cbn. lra. }
  specialize (F (Ball 0 1) 0 2 1 I). unfold in_ball in F. cbn in F. apply norm_le in F as [_ F]. unfold norm2 in F. cbn in F. lra.
Qed.

(* The hypotheses can be met: the number 1 in [0, 1], displaced by 2 in [1, 2]. *)
Example morph_instance : in_ball (Ball (1 / 2) (1 / 2)) 1 /\ Forall2 in_ball [Ball (3 / 2) (1 / 2)] [2].
Proof.
  split; [|constructor; [|constructor]]; unfold in_ball; cbn; apply norm_le; unfold norm2; cbn; lra.
Qed.
Example ranges_instance : let b := Ball (3 / 2) (1 / 2) in in_ball (Ball (1 / 2) (1 / 2)) 1 /\ Forall2 in_ball [b] [2] /\ Forall2 is_in_range [2] [(1, 3)] /\ Forall2 is_no_shorter [3 / 2] [b] /\
  is_in_range (dot 1 1) (0, 1) /\ Forall2 (fun d => is_in_range (dot 1 d)) [2] [(1, 2)] /\ moves (fun _ : R => 2) (at_rest 2) 0 1.
Proof.
  cbv zeta. split; [apply morph_instance|]. split; [apply morph_instance|].
  unfold is_in_range, is_no_shorter. cbn [center radius fst snd]. repeat split; try (cbn; lra).
  - apply Forall2_cons; [cbn; lra|constructor].
  - apply Forall2_cons; [|constructor]. apply norm_le. unfold norm2. cbn. lra.
  - apply Forall2_cons; [cbn; lra|constructor].
  - apply constant_moves, norm_le. unfold norm2. cbn. lra.
Qed.
