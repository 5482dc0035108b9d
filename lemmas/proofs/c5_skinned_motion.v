(* SPDX-License-Identifier: MIT *)
(* How fast a skinned vertex goes, and how much it bends, by how its joints move: of linear, spherical and dual quaternion skinning
   with constant weights. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion Refitlab.theory.curve.
Require Import Refitlab.b6_dual_quaternion_ball Refitlab.c3_normalized_motion Refitlab.c4_chain_motion.
Import ListNotations.

(* What curves are at a moment. *)
Definition at_moment {E} (t : R) (curves : list (R -> E)) := map (fun f => f t) curves.

(* --- Statements --- *)

(* (i) *)
Definition linear_moves : Prop := forall E (l : Lin R E) (H : Euclid E) (images : list (R -> E)) w (m : motion) a b,
  convex (length images) w -> Forall (fun x => moves x m a b) images -> moves (fun t => comb w (at_moment t images)) m a b.
(* Each joint is a chain above its bind pose, with what its links and a point below them do. *)
Record chained := Chained {
  links : list link; their_motions : list link_motion; bind : rigid; below : R -> vec R; its_motion : motion }.
Definition moves_by_chain (a b : R) (wide : motion) (j : chained) := Forall2 (link_moves a b) (links j) (their_motions j) /\
  moves (below j) (its_motion j) a b /\ is_wider wide (carried_motion (chain (their_motions j)) (its_motion j)).
Definition by_linear (joints : list chained) w t := comb w (map (fun j => image (links j) (below j) t) joints).
Definition linear_moves_by_chains : Prop := forall (joints : list chained) w (wide : motion) a b,
  convex (length joints) w -> Forall (moves_by_chain a b wide) joints ->
  moves (by_linear joints w) wide a b.
(* (ii) *)
Definition spherical_moves : Prop := forall (turns : list (R -> quat R)) (images : list (R -> vec R)) w center v L A (m d a b : R)
  (of_images : motion), convex (length turns) w -> length images = length turns ->
  Forall (fun q => moves q (Motion 1 L A) a b) turns -> Forall (fun x => moves x of_images a b) images ->
  0 < m -> (forall t, a <= t <= b -> m <= norm (comb w (at_moment t turns))) -> norm (v - center) <= d ->
  moves (fun t => skin_spherical (at_moment t turns) (at_moment t images) center w v)
    (sum_of_motions (product_of_motions (product_of_motions (Motion 1 L A) (inverse_motion L A m)) (at_rest d)) of_images) a b.
(* Where nothing is known of how long the blend is, a vertex is as far from the hull of the center's images as from the center. *)
Definition spherical_near_images : Prop := forall (qs : list (quat R)) (images : list (vec R)) w center v, convex (length images) w ->
  comb w qs <> lzero -> exists y, in_hull images y /\ norm (skin_spherical qs images center w v - y) = norm (v - center).
(* What a chain's joint turns by; a sign that skinning gives it is that of the bind pose's quaternion. *)
Definition turn_of (j : chained) (t : R) : quat R := qmul (turn_of_chain (links j) t) (rotation (bind j)).
Definition turns_by_chain (wide : motion) (j : chained) :=
  norm2 (rotation (bind j)) = 1 /\ is_wider wide (of_rotation (chain (their_motions j))).
(* The points below are the images of the center in the bind poses. *)
Definition by_spherical (joints : list chained) center w v t :=
  skin_spherical (map (fun j => turn_of j t) joints) (map (fun j => image (links j) (below j) t) joints) center w v.
Definition spherical_moves_by_chains : Prop := forall (joints : list chained) w center v L A (m d a b : R) (of_images : motion),
  convex (length joints) w -> Forall (moves_by_chain a b of_images) joints -> Forall (turns_by_chain (Motion 1 L A)) joints ->
  0 < m -> (forall t, a <= t <= b -> m <= norm (comb w (map (fun j => turn_of j t) joints))) -> norm (v - center) <= d ->
  moves (by_spherical joints center w v)
    (sum_of_motions (product_of_motions (product_of_motions (Motion 1 L A) (inverse_motion L A m)) (at_rest d)) of_images) a b.
(* (iii), as seen from f, of joints that are curves of transforms. They need to be rigid in [a, b] alone, where the skinned vertex is on
   a curve that moves within this. *)
Definition dual_moves : Prop := forall (joints : list (R -> rigid)) w v f L A (m a b s : R) (reach : motion),
  convex (length joints) w ->
  (forall j t, In j joints -> a <= t <= b -> norm2 (rotation (j t)) = 1) ->
  Forall (fun j => moves (fun t => rotation (j t)) (Motion s L A) a b /\ exists of_image of_turn,
    moves (fun t => apply_rigid (j t) v - f)%V of_image a b /\
    moves (fun t => rotation (j t)) of_turn a b /\ is_wider reach (product_of_motions of_image of_turn)) joints ->
  0 < m -> (forall t, a <= t <= b -> m <= norm (comb w (map rotation (at_moment t joints)))) ->
  exists vertex, moves vertex (product_of_motions reach (inverse_motion L A m)) a b /\ forall t, a <= t <= b ->
    vertex t = (skin_dual (map rotation (at_moment t joints)) (map dual_of (at_moment t joints)) w v - f)%V.
(* The transform of a chain whose links are rigid, at all moments, to which a piece is continued by its own formula. *)
Definition transform_of (j : chained) (t : R) : rigid := Rigid (turn_of j t) (image (links j) (fun _ => quaternion.translation (bind j)) t).
Definition by_dual (joints : list chained) w v t :=
  skin_dual (map (fun j => turn_of j t) joints) (map (fun j => dual_of (transform_of j t)) joints) w v.
Definition is_rigid_link (k : link) := forall t, norm2 (turn k t) = 1 /\ scale k t = Vec 1 1 1.
(* A vertex that is at most r from f at these moments, carried by the joint. *)
Definition reaches_by_chain (a b : R) (v f : vec R) (reach : motion) (j : chained) := Forall2 (link_moves a b) (links j) (their_motions j) /\
  Forall is_rigid_link (links j) /\ exists r, (forall t, a <= t <= b -> norm (apply_rigid (transform_of j t) v - f) <= r) /\
  let carried := carried_motion (chain (their_motions j)) (at_rest (norm (apply_rigid (bind j) v))) in
  is_wider reach (product_of_motions (Motion r (speed carried) (acceleration carried)) (of_rotation (chain (their_motions j)))).
Definition dual_moves_by_chains : Prop := forall (joints : list chained) w v f L A (m a b : R) (reach : motion),
  convex (length joints) w -> Forall (turns_by_chain (Motion 1 L A)) joints -> Forall (reaches_by_chain a b v f reach) joints ->
  0 < m -> (forall t, a <= t <= b -> m <= norm (comb w (map (fun j => turn_of j t) joints))) ->
  exists vertex, moves vertex (product_of_motions reach (inverse_motion L A m)) a b /\
    forall t, a <= t <= b -> vertex t = (by_dual joints w v t - f)%V.
(* The motion that all joints share: links above those of each joint carry what is skinned without them. So it moves as `chain_moves` of
   c4_chain_motion says of a curve. For spherical and dual quaternion skinning these links are rigid. *)
Definition under (shared : list link) (j : chained) := Chained (shared ++ links j) (their_motions j) (bind j) (below j) (its_motion j).
Definition shared_motion_carries : Prop := forall (shared : list link) (joints : list chained) center w v t, convex (length joints) w ->
  by_linear (map (under shared) joints) w t = image shared (by_linear joints w) t /\
  (Forall is_rigid_link shared ->
   by_spherical (map (under shared) joints) center w v t = image shared (by_spherical joints center w v) t /\
   (comb w (map (fun j => turn_of j t) joints) <> lzero ->
    by_dual (map (under shared) joints) w v t = image shared (by_dual joints w v) t)).

(* --- Proofs --- *)

Theorem linear_moves_holds : linear_moves.
Proof.
  intros E l H images w m a b (L & P & S) F.
  assert (G : moves (fun t => comb w (at_moment t images)) (Motion (sum w * size m) (sum w * speed m) (sum w * acceleration m)) a b).
  { clear S. revert w L P. induction F as [|x images X F IH]; intros [|u w] L P; try discriminate.
    - apply (moves_same (fun _ => lzero) _ (at_rest 0)); [reflexivity|apply motion_eq; cbn; ring|].
      apply constant_moves. rewrite norm_zero. lra.
    - apply Forall_cons_iff in P as [U P]. specialize (IH w ltac:(auto) P).
      assert (Y : moves (fun t => u *: x t)%V (Motion (u * size m) (u * speed m) (u * acceleration m)) a b).
      { destruct X as (x' & x'' & D & D' & M). exists (fun t => u *: x' t)%V, (fun t => u *: x'' t)%V.
        pose proof (scaling_has_adjoint (E := E) u).
        split; [now apply (derivative_map (fun y => (u *: y)%V))|]. split; [now apply (derivative_map (fun y => (u *: y)%V))|].
        intros t T. destruct (M t T) as (M0 & M1 & M2). cbn [size speed acceleration].
        split; [|split]; rewrite norm_scale by exact U; apply Rmult_le_compat_l; assumption. }
      pose proof (curves_add_holds _ _ _ _ _ _ _ a b Y IH) as Z. eapply moves_same; [| |exact Z]; [reflexivity|].
      rewrite sum_cons. apply motion_eq; cbn [size speed acceleration sum_of_motions]; ring. }
  rewrite S in G. eapply moves_same; [| |exact G]; [reflexivity|]. apply motion_eq; cbn [size speed acceleration]; ring.
Qed.

Theorem linear_moves_by_chains_holds : linear_moves_by_chains.
Proof.
  intros joints w wide a b W F.
  apply (moves_same (fun t => comb w (at_moment t (map (fun j => image (links j) (below j)) joints))) _ wide); [|reflexivity|].
  - intros t. unfold at_moment, by_linear. now rewrite map_map.
  - apply linear_moves_holds; [now rewrite map_length|]. apply Forall_map, (Forall_impl _ (P := _)) with (2 := F).
    intros j (L & B & Wide). apply (moves_wider _ _ _ a b Wide). now apply chain_moves_holds.
Qed.

(* The blend and its inverse. *)
Lemma rotate_by_inverse (q : quat R) x : rotate q x = turned q x (inverse_of q).
Proof. unfold rotate, inverse_of. generalize (/ norm2 q). vring. Qed.

Theorem spherical_moves_holds : spherical_moves.
Proof.
  intros turns images w center v L A m d a b Y W N Q X Pm Long D.
  pose proof (linear_moves_holds _ _ _ turns w _ a b W Q) as B.
  pose proof (inverse_curve_moves_holds _ _ _ _ m a b B Pm Long) as G.
  pose proof (turned_moves _ _ _ _ _ _ a b B G (constant_moves (v - center)%V d a b D)) as T.
  rewrite <- N in W. pose proof (linear_moves_holds _ _ _ images w _ a b W X) as I.
  pose proof (curves_add_holds _ _ _ _ _ _ _ a b T I) as Z. eapply moves_same; [| |exact Z].
  - intros t. unfold skin_spherical. now rewrite rotate_by_inverse.
  - unfold inverse_motion. destruct Y. motions.
Qed.

(* A chain's quaternion times that of the bind pose moves as the chain's. *)
Lemma turn_of_moves (j : chained) a b : norm2 (rotation (bind j)) = 1 -> Forall2 (link_moves a b) (links j) (their_motions j) ->
  moves (turn_of j) (of_rotation (chain (their_motions j))) a b.
Proof.
  intros U L. destruct (chain_moves_holds _ _ (fun _ => lzero) (at_rest 0) a b L) as [_ Q].
  { apply constant_moves. rewrite norm_zero. lra. }
  assert (N : norm (rotation (bind j)) <= 1) by (right; now apply norm_unit).
  pose proof (curves_multiply_holds _ _ _ _ _ _ _ _ _ _ _ (fun _ => rotation (bind j)) _ _ a b qmul_is_product quaternions_are_short_holds
    Q (constant_moves (rotation (bind j)) 1 a b N)) as M.
  eapply moves_same; [| |exact M]; [reflexivity|]. apply motion_eq; cbn [size speed acceleration product_of_motions at_rest]; ring.
Qed.

Theorem spherical_moves_by_chains_holds : spherical_moves_by_chains.
Proof.
  intros joints w center v L A m d a b Y W C Q Pm Long D.
  pose (turns := map turn_of joints). pose (images := map (fun j => image (links j) (below j)) joints).
  assert (ET : forall t, at_moment t turns = map (fun j => turn_of j t) joints) by (intros t; unfold at_moment, turns; now rewrite map_map).
  assert (EI : forall t, at_moment t images = map (fun j => image (links j) (below j) t) joints).
  { intros t. unfold at_moment, images. now rewrite map_map. }
  eapply moves_same; [|reflexivity|apply (spherical_moves_holds turns images w center v L A m d a b Y)].
  - intros t. unfold by_spherical. now rewrite ET, EI.
  - unfold turns. now rewrite map_length.
  - unfold turns, images. now rewrite !map_length.
  - apply Forall_map, Forall_forall. intros j I. rewrite Forall_forall in C, Q. destruct (C j I) as (K & _). destruct (Q j I) as (U & Wide).
    apply (moves_wider _ _ _ a b Wide). now apply turn_of_moves.
  - apply Forall_map, (Forall_impl _ (P := moves_by_chain a b Y)) with (2 := C). intros j (K & B & Wide).
    apply (moves_wider _ _ _ a b Wide). now apply chain_moves_holds.
  - exact Pm.
  - intros t T. rewrite ET. now apply Long.
  - exact D.
Qed.

(* A chain of rigid links is rigid. *)
Lemma rigid_chain_turns ks t : Forall is_rigid_link ks -> norm2 (turn_of_chain ks t) = 1.
Proof.
  induction 1 as [|k ks K _ IH]; [cbn; vunfold; ring|]. cbn [turn_of_chain fold_right]. fold (turn_of_chain ks t).
  destruct (K t) as [U _]. rewrite norm2_qmul, U, IH. ring.
Qed.
Lemma rotate_unit (q : quat R) x : norm2 q = 1 -> rotate q x = turned q x q.
Proof. intros U. unfold rotate. rewrite U, Rinv_1. generalize (turned q x q). vring. Qed.
Lemma scaled_by_ones (x : vec R) : scaled (Vec 1 1 1) x = x.
Proof. destruct x. unfold scaled. cbn. f_equal; ring. Qed.
Lemma rigid_chain_is (j : chained) v t : Forall is_rigid_link (links j) -> norm2 (rotation (bind j)) = 1 ->
  apply_rigid (transform_of j t) v = image (links j) (fun _ => apply_rigid (bind j) v) t.
Proof.
  intros F U. unfold transform_of, turn_of, apply_rigid. cbn [rotation quaternion.translation].
  induction F as [|k ks K F IH].
  - cbn [turn_of_chain image fold_right].
    replace (qmul (Quat 1 0 0 0) (rotation (bind j))) with (rotation (bind j)) by (destruct (rotation (bind j)); vring). reflexivity.
  - cbn [turn_of_chain image fold_right]. fold (turn_of_chain ks t). unfold image in IH. rewrite <- IH. destruct (K t) as [V S].
    pose proof (rigid_chain_turns ks t F) as Q. unfold posed. rewrite S, !scaled_by_ones.
    assert (E : qmul (qmul (turn k t) (turn_of_chain ks t)) (rotation (bind j)) =
                qmul (turn k t) (qmul (turn_of_chain ks t) (rotation (bind j)))) by vring.
    rewrite E. assert (N : norm2 (qmul (turn_of_chain ks t) (rotation (bind j))) = 1) by (rewrite norm2_qmul, Q, U; ring).
    revert N. generalize (qmul (turn_of_chain ks t) (rotation (bind j))) as q. intros q N.
    rewrite (rotate_unit q) by exact N. rewrite rotate_unit by (rewrite norm2_qmul, V, N; ring).
    replace (turned (qmul (turn k t) q) v (qmul (turn k t) q)) with (turned (turn k t) (turned q v q) (turn k t)) by vring.
    generalize (turned q v q) (fold_right (fun k y => posed k y t) (quaternion.translation (bind j)) ks) (turn k t) (translation k t). vring.
Qed.

Theorem spherical_near_images_holds : spherical_near_images.
Proof.
  intros qs images w center v W N. exists (comb w images). split; [now exists w|]. unfold skin_spherical.
  replace (rotate (comb w qs) (v - center) + comb w images - comb w images)%V with (rotate (comb w qs) (v - center)) by vec_ring.
  now apply rotate_norm.
Qed.

(* E_k = (x_k - f) q_k. *)
Lemma reach_of_joint (c : rigid) v f : norm2 (rotation c) = 1 ->
  reach_at v f (rotation c, dual_of c) = qmul (pure (apply_rigid c v - f)%V) (rotation c).
Proof.
  intros U. unfold reach_at. cbn [fst snd].
  replace (qmul (pure (apply_rigid c v - f)%V) (rotation c)) with
    (qmul (pure (apply_rigid c v)) (rotation c) - qmul (pure f) (rotation c))%V by (generalize (apply_rigid c v) (rotation c); vring).
  rewrite <- (unit_moves c v U). vec_ring.
Qed.

Theorem dual_moves_holds : dual_moves.
Proof.
  intros joints w v f L A m a b s reach W U F Pm Long.
  pose (E := fun t => comb w (at_moment t (map (fun j t => qmul (pure (apply_rigid (j t) v - f)%V) (rotation (j t))) joints))).
  pose (q := fun t => comb w (map rotation (at_moment t joints))).
  assert (ME : moves E reach a b).
  { apply linear_moves_holds; [now rewrite map_length|]. apply Forall_map, (Forall_impl _ (P := _)) with (2 := F).
    intros j [_ (X & Q & MX & MQ & Wide)]. apply (moves_wider _ _ _ a b Wide).
    apply (curves_multiply_holds _ _ _ _ _ _ _ _ _ _ (fun t => pure (apply_rigid (j t) v - f)%V) (fun t => rotation (j t)) X Q a b
      qmul_is_product quaternions_are_short_holds); [|exact MQ].
    apply (curve_mapped (fun x : vec R => pure x)); [exact pure_has_adjoint|exact pure_norm|exact MX]. }
  assert (Mq : moves q (Motion s L A) a b).
  { apply (moves_same (fun t => comb w (at_moment t (map (fun j t => rotation (j t)) joints))) _ (Motion s L A)); [|reflexivity|].
    - intros t. unfold q, at_moment. now rewrite !map_map.
    - apply linear_moves_holds; [now rewrite map_length|].
      apply Forall_map, (Forall_impl _ (P := _)) with (2 := F). now intros j [Q _]. }
  pose proof (inverse_curve_moves_holds q s L A m a b Mq Pm Long) as MG.
  exists (fun t => im (qmul (E t) (conj (inverse_of (q t))))). split.
  - apply (curve_mapped (fun q : quat R => im q)); [exact im_has_adjoint|exact im_norm|].
    apply (curves_multiply_holds _ _ _ _ _ _ _ _ _ _ E (fun t => conj (inverse_of (q t))) _ _ a b
      qmul_is_product quaternions_are_short_holds ME).
    apply (curve_mapped (fun q : quat R => conj q) (fun t => inverse_of (q t))); [exact conj_has_adjoint|exact conj_norm|exact MG].
  - intros t T. rewrite skin_dual_from.
    2: { apply norm2_pos_inv. rewrite <- norm_sq. specialize (Long t T). apply Rmult_lt_0_compat; lra. }
    change (comb w (map rotation (at_moment t joints))) with (q t). unfold inverse_of.
    replace (E t) with (reach_at v f (q t, comb w (map dual_of (at_moment t joints)))).
    + generalize (/ norm2 (q t)) (reach_at v f (q t, comb w (map dual_of (at_moment t joints)))) (q t). vring.
    + unfold q, E, at_moment. rewrite !map_map.
      replace (map (fun j => rotation (j t)) joints) with (map fst (map (fun j : R -> rigid => (rotation (j t), dual_of (j t))) joints))
        by (rewrite map_map; reflexivity).
      replace (map (fun j => dual_of (j t)) joints) with (map snd (map (fun j : R -> rigid => (rotation (j t), dual_of (j t))) joints))
        by (rewrite map_map; reflexivity).
      rewrite <- comb_pair, (comb_linear _ w _ (reach_linear v f)), map_map. f_equal. apply map_ext_in.
      intros j I. apply reach_of_joint. now apply U.
Qed.

(* What stays near f moves as far as it reaches from there. *)
Lemma moves_from {E} `{Euclid E} (x : R -> E) f r m a b : moves x m a b -> (forall t, a <= t <= b -> norm (x t - f)%V <= r) ->
  moves (fun t => x t - f)%V (Motion r (speed m) (acceleration m)) a b.
Proof.
  intros (x' & x'' & D & D' & M) N. exists x', x''. split; [|split; [exact D'|]].
  - intros e t T. apply (derivable_same (fun t => dot (x t) e - dot f e)); [intros; now rewrite dot_sub_l|].
    replace (dot (x' t) e) with (dot (x' t) e - 0) by ring.
    apply (derivable_pt_lim_minus (fun t => dot (x t) e) (fun _ => dot f e)); [auto|apply derivable_pt_lim_const].
  - intros t T. destruct (M t T) as (_ & M1 & M2). split; [|split]; auto.
Qed.

Theorem dual_moves_by_chains_holds : dual_moves_by_chains.
Proof.
  intros joints w v f L A m a b reach W Q F Pm Long. pose (transforms := map transform_of joints).
  assert (ER : forall t, map rotation (at_moment t transforms) = map (fun j => turn_of j t) joints).
  { intros t. unfold at_moment, transforms. now rewrite !map_map. }
  assert (ED : forall t, map dual_of (at_moment t transforms) = map (fun j => dual_of (transform_of j t)) joints).
  { intros t. unfold at_moment, transforms. now rewrite !map_map. }
  rewrite Forall_forall in Q, F.
  destruct (dual_moves_holds transforms w v f L A m a b 1 reach) as (vertex & M & V).
  - unfold transforms. now rewrite map_length.
  - intros c t I _. apply in_map_iff in I as (j & <- & I). destruct (Q j I) as (U & _). destruct (F j I) as (_ & Ri & _).
    cbn [transform_of rotation]. unfold turn_of. rewrite norm2_qmul, (rigid_chain_turns _ t Ri), U. ring.
  - apply Forall_map, Forall_forall. intros j I. destruct (Q j I) as (U & Wide). destruct (F j I) as (K & Ri & r & Near & Reach).
    pose proof (turn_of_moves j a b U K) as T. split; [exact (moves_wider _ _ _ a b Wide T)|].
    eexists (Motion r _ _), _. split; [|split; [exact T|exact Reach]].
    apply moves_from; [|exact Near].
    destruct (chain_moves_holds _ _ (fun _ => apply_rigid (bind j) v) (at_rest (norm (apply_rigid (bind j) v))) a b K) as [X _].
    { apply constant_moves. lra. }
    eapply moves_same; [|reflexivity|exact X]. intros t. symmetry. now apply rigid_chain_is.
  - exact Pm.
  - intros t T. rewrite ER. now apply Long.
  - exists vertex. split; [exact M|]. intros t T. rewrite (V t T). unfold by_dual. now rewrite ER, ED.
Qed.

(* Links are an affine map, which is the same for all that is below. *)
Definition carried (ks : list link) (t : R) (y : vec R) := fold_right (fun k y => posed k y t) y ks.
Lemma image_of_shared shared ks x t : image (shared ++ ks) x t = carried shared t (image ks x t).
Proof. unfold image, carried. apply fold_right_app. Qed.
Lemma carried_is_affine ks t : exists f : vec R -> vec R, linear f /\ forall y, carried ks t y = (f y + carried ks t lzero)%V.
Proof.
  exists (fun y => linear_image ks (fun _ => y) t). split; [|intros y; exact (image_is_affine ks (fun _ => y) t)].
  induction ks as [|k ks (Z & A & S)]; [repeat split|]. cbn [linear_image fold_right]. fold (linear_image ks).
  split; [|split; [intros x y|intros a x]]; unfold linear_image in *; rewrite ?Z, ?A, ?S; generalize (turn k t) (scale k t); unfold scaled;
    repeat match goal with |- context [fold_right ?g ?y ks] => generalize (fold_right g y ks) end; vring.
Qed.
Lemma carried_comb ks t (f : vec R -> vec R) w ys : convex (length ys) w -> linear f ->
  (forall y, carried ks t y = (f y + carried ks t lzero)%V) -> comb w (map (carried ks t) ys) = carried ks t (comb w ys).
Proof.
  intros W L E. rewrite (E (comb w ys)), (comb_linear f w ys L), (map_ext (carried ks t) _ E), <- map_map with (f := f) (g := fun x => (x + carried ks t lzero)%V).
  apply comb_shift_convex. now rewrite map_length.
Qed.
Lemma rigid_carries ks t y : Forall is_rigid_link ks ->
  carried ks t y = (turned (turn_of_chain ks t) y (turn_of_chain ks t) + carried ks t lzero)%V.
Proof.
  induction 1 as [|k ks K _ IH]; [cbn; destruct y; vring|]. cbn [carried turn_of_chain fold_right].
  fold (carried ks t y) (carried ks t lzero) (turn_of_chain ks t). destruct (K t) as [_ S]. rewrite IH. unfold posed. rewrite S, !scaled_by_ones.
  generalize (turn k t) (turn_of_chain ks t) (carried ks t lzero) (translation k t). vring.
Qed.
Lemma turn_of_shared shared j t : turn_of (under shared j) t = qmul (turn_of_chain shared t) (turn_of j t).
Proof.
  unfold turn_of. cbn [under links bind]. induction shared as [|k ks IH].
  - change (turn_of_chain [] t) with (Quat 1 0 0 0). cbn [app]. generalize (qmul (turn_of_chain (links j) t) (rotation (bind j))). vring.
  - cbn [app turn_of_chain fold_right]. fold (turn_of_chain (ks ++ links j) t) (turn_of_chain ks t).
    transitivity (qmul (turn k t) (qmul (turn_of_chain (ks ++ links j) t) (rotation (bind j)))).
    + generalize (turn k t) (turn_of_chain (ks ++ links j) t) (rotation (bind j)). vring.
    + rewrite IH. generalize (turn k t) (turn_of_chain ks t) (qmul (turn_of_chain (links j) t) (rotation (bind j))). vring.
Qed.
Lemma qmul_linear (p : quat R) : linear (fun q : quat R => qmul p q).
Proof. repeat split; intros; vring. Qed.
Lemma turned_twice (p q : quat R) x : norm2 p = 1 -> rotate (qmul p q) x = turned p (rotate q x) p.
Proof.
  intros U. unfold rotate. rewrite norm2_qmul, U, Rmult_1_l. generalize (/ norm2 q). intros n. vring.
Qed.

Theorem shared_motion_carries_holds : shared_motion_carries.
Proof.
  intros shared joints center w v t W.
  assert (EI : map (fun j => image (links j) (below j) t) (map (under shared) joints) =
    map (carried shared t) (map (fun j => image (links j) (below j) t) joints)).
  { rewrite !map_map. apply map_ext. intros j. apply image_of_shared. }
  assert (WI : convex (length (map (fun j => image (links j) (below j) t) joints)) w) by now rewrite map_length.
  destruct (carried_is_affine shared t) as (f & L & E). split.
  { unfold by_linear. rewrite EI. now apply (carried_comb shared t f). }
  intros F. pose proof (rigid_chain_turns shared t F) as U. set (Q := turn_of_chain shared t) in *.
  assert (ET : map (fun j => turn_of j t) (map (under shared) joints) = map (qmul Q) (map (fun j => turn_of j t) joints)).
  { rewrite !map_map. apply map_ext. intros j. apply turn_of_shared. }
  split.
  - unfold by_spherical at 1, skin_spherical. rewrite EI, ET, (carried_comb shared t f) by auto. rewrite <- (comb_linear _ w _ (qmul_linear Q)).
    change (image shared (by_spherical joints center w v) t) with (carried shared t (by_spherical joints center w v t)).
    rewrite (rigid_carries shared t (comb w _)), (rigid_carries shared t (by_spherical _ _ _ _ _)) by exact F. fold Q.
    unfold by_spherical, skin_spherical. rewrite (turned_twice Q) by exact U.
    generalize (carried shared t lzero) (rotate (comb w (map (fun j => turn_of j t) joints)) (v - center)%V)
      (comb w (map (fun j => image (links j) (below j) t) joints)). vring.
  - intros N. apply norm2_pos in N. set (p := carried shared t lzero).
    pose (g := fun c : quat R * quat R => (qmul Q (snd c) + 1 / 2 *: qmul (pure p) (qmul Q (fst c)))%V).
    assert (G : linear g) by (unfold g; repeat split; intros; cbn [fst snd]; vring).
    assert (ED : map (fun j => dual_of (transform_of j t)) (map (under shared) joints) =
      map g (map (fun j => (turn_of j t, dual_of (transform_of j t))) joints)).
    { rewrite !map_map. apply map_ext. intros j. unfold g, dual_of, transform_of. cbn [fst snd rotation quaternion.translation].
      rewrite turn_of_shared. fold Q. cbn [under links bind]. rewrite image_of_shared, (rigid_carries shared t _ F). fold Q p.
      generalize (turn_of j t) (image (links j) (fun _ => quaternion.translation (bind j)) t). clear - U. clearbody Q p. intros q b.
      assert (B : qmul (pure (turned Q b Q)) Q = (norm2 Q *: qmul Q (pure b))%V) by vring. rewrite U in B.
      replace (qmul (pure (turned Q b Q + p)%V) (qmul Q q)) with (qmul (qmul (pure (turned Q b Q)) Q) q + qmul (pure p) (qmul Q q))%V
        by (generalize (turned Q b Q); vring).
      rewrite B. vring. }
    change (image shared (by_dual joints w v) t) with (carried shared t (by_dual joints w v t)). rewrite (rigid_carries _ _ _ F). fold Q p.
    unfold by_dual, skin_dual. cbv zeta. rewrite ED, ET, <- (comb_linear g w _ G), <- (comb_linear _ w _ (qmul_linear Q)), comb_pair, !map_map.
    cbn [fst snd]. unfold g. cbn [fst snd]. rewrite norm2_qmul, U, Rmult_1_l.
    revert N. generalize (comb w (map (fun j => turn_of j t) joints)) (comb w (map (fun j => dual_of (transform_of j t)) joints)).
    clear - U. clearbody Q p. intros q d N.
    assert (P : (2 *: im (qmul (qmul Q d + 1 / 2 *: qmul (pure p) (qmul Q q))%V (conj (qmul Q q))))%V =
                (turned Q (2 *: im (qmul d (conj q))) Q + norm2 (qmul Q q) *: p)%V) by vfield.
    rewrite P, norm2_qmul, U, Rmult_1_l.
    replace (turned (qmul Q q) v (qmul Q q)) with (turned Q (turned q v q) Q) by vring.
    revert N. generalize (norm2 q) (turned q v q) (2 *: im (qmul d (conj q)))%V. intros n x y N.
    transitivity (/ n *: turned Q (x + y) Q + (/ n * n) *: p)%V; [vring|]. rewrite Rinv_l by lra. generalize (/ n). vring.
Qed.

(* The hypotheses can be met: a joint at rest. *)
Example skinned_instance : let c := Rigid (Quat 1 0 0 0) (Vec 1 0 0) in let still := fun _ : R => rotation c in
  let there := fun _ : R => Vec 1 0 0 in convex (length [still]) [1] /\ moves still (Motion 1 0 0) 0 1 /\
  moves there (at_rest 1) 0 1 /\ (forall t, 1 <= norm (comb [1] (at_moment t [still]))) /\ norm2 (rotation c) = 1 /\
  moves (fun _ => apply_rigid c (Vec 0 0 0) - Vec 1 0 0)%V (at_rest 0) 0 1.
Proof.
  cbv zeta. cbn [rotation]. split; [repeat split; [repeat constructor; lra|cbn; lra]|].
  split; [apply (constant_moves (Quat 1 0 0 0) 1), norm_le; vunfold; lra|].
  split; [apply constant_moves, norm_le; vunfold; lra|]. split.
  - intros t. right. symmetry. apply norm_unit. cbn. vunfold. ring.
  - split; [vunfold; ring|]. apply (moves_same (fun _ => lzero) _ (at_rest 0)); [|reflexivity|].
    + intros t. unfold apply_rigid, rotate. cbn. vunfold. f_equal; field.
    + apply constant_moves. rewrite norm_zero. lra.
Qed.
(* And one joint with no links above it. *)
Example chained_instance : let j := Chained [] [] (Rigid (Quat 1 0 0 0) (Vec 1 0 0)) (fun _ => Vec 1 0 0) (at_rest 1) in convex 1 [1] /\
  moves_by_chain 0 1 (at_rest 1) j /\ turns_by_chain (Motion 1 0 0) j /\
  reaches_by_chain 0 1 (Vec 0 0 0) (Vec 1 0 0) (at_rest 0) j /\ (forall t, 1 <= norm (comb [1] (map (fun j => turn_of j t) [j]))).
Proof.
  cbv zeta. split; [repeat split; [repeat constructor; lra|cbn; lra]|]. split.
  { split; [constructor|]. split; [apply constant_moves, norm_le; vunfold; lra|]. unfold is_wider. cbn. lra. }
  split; [split; [cbn; vunfold; ring|unfold is_wider; cbn; lra]|]. split.
  - split; [constructor|]. split; [constructor|]. exists 0. split.
    + intros t _. apply norm_le. split; [lra|]. unfold apply_rigid, rotate. cbn. vunfold. right. field.
    + unfold is_wider. cbn. lra.
  - intros t. right. symmetry. apply norm_unit. cbn. vunfold. ring.
Qed.
