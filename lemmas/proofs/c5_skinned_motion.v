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
(* Each joint is a chain, with what its links and the vertex below it do. *)
Record chained := Chained { links : list link; their_motions : list link_motion; below : R -> vec R; its_motion : motion }.
Definition moves_by_chain (a b : R) (wide : motion) (j : chained) := Forall2 (link_moves a b) (links j) (their_motions j) /\
  moves (below j) (its_motion j) a b /\ is_wider wide (carried_motion (chain (their_motions j)) (its_motion j)).
Definition linear_moves_by_chains : Prop := forall (joints : list chained) w (wide : motion) a b,
  convex (length joints) w -> Forall (moves_by_chain a b wide) joints ->
  moves (fun t => comb w (map (fun j => image (links j) (below j) t) joints)) wide a b.
(* (ii) *)
Definition spherical_moves : Prop := forall (turns : list (R -> quat R)) (images : list (R -> vec R)) w center v L A (m d a b : R)
  (of_images : motion), convex (length turns) w -> length images = length turns ->
  Forall (fun q => moves q (Motion 1 L A) a b) turns -> Forall (fun x => moves x of_images a b) images ->
  0 < m -> (forall t, a <= t <= b -> m <= norm (comb w (at_moment t turns))) -> norm (v - center) <= d ->
  moves (fun t => skin_spherical (at_moment t turns) (at_moment t images) center w v)
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
  - intros t. unfold at_moment. now rewrite map_map.
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
Example chained_instance : convex 1 [1] /\ moves_by_chain 0 1 (at_rest 1) (Chained [] [] (fun _ => Vec 1 0 0) (at_rest 1)).
Proof.
  split; [repeat split; [repeat constructor; lra|cbn; lra]|]. split; [constructor|].
  split; [apply constant_moves, norm_le; vunfold; lra|]. unfold is_wider. cbn. lra.
Qed.
