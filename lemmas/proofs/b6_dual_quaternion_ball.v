(* SPDX-License-Identifier: MIT *)
(* Beyond the paper: a ball around what dual quaternions make of a point, as long as their blends keep away from 0. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.t3_one_cap.
Import ListNotations.

(* --- Statements: weight vertices (q_k, d_k) of any length --- *)

(* E_k = 2 d_k + q_k p - f q_k, with p and f as pure quaternions. *)
Definition reach_at (p f : vec R) (weight_vertex : quat R * quat R) : quat R :=
  (2 *: snd weight_vertex + qmul (fst weight_vertex) (pure p) - qmul (pure f) (fst weight_vertex))%V.
(* Of a weight vertex that is not 0: its image of p. *)
Definition weight_vertex_image (p : vec R) (weight_vertex : quat R * quat R) : vec R :=
  skin_dual [fst weight_vertex] [snd weight_vertex] [1] p.

(* If all (q_k, a) > 0, no blend is 0, and all v'(u) are in the ball about f of radius ||a|| max ||E_k|| / (q_k, a): of any
   radius that is no less. *)
Definition dual_quaternion_ball : Prop :=
  forall (weight_vertices : list (quat R * quat R)) (a : quat R) (p f : vec R) (r : R) (u : list R),
  (forall c, In c weight_vertices -> 0 < dot (fst c) a /\ norm a * (norm (reach_at p f c) / dot (fst c) a) <= r) ->
  convex (length weight_vertices) u ->
  comb u (map fst weight_vertices) <> lzero /\ in_ball (Ball f r)
    (skin_dual (map fst weight_vertices) (map snd weight_vertices) u p).
(* ||E_k||^2 = ||q_k||^2 ||v'_k - f||^2 + 4 (d_k, q_k)^2 / ||q_k||^2 *)
Definition reach_is_distance : Prop :=
  forall (c : quat R * quat R) (p f : vec R), fst c <> lzero ->
  norm2 (reach_at p f c) =
  norm2 (fst c) * norm2 (weight_vertex_image p c - f) + 4 * (dot (snd c) (fst c) * dot (snd c) (fst c)) / norm2 (fst c).
(* If an axis is there, 0 is not in the hull of the q_k. *)
Definition axis_excludes_zero : Prop :=
  forall (qs : list (quat R)) (a : quat R), (forall q, In q qs -> 0 < dot q a) -> ~ in_hull qs lzero.
(* Without one there may be no ball: near a blend that is 0 vertices are carried as far as wanted. *)
Definition no_ball_near_zero : Prop :=
  exists (weight_vertices : list (quat R * quat R)) (p : vec R), forall b : ball (vec R), exists u,
  convex (length weight_vertices) u /\ comb u (map fst weight_vertices) <> lzero /\
  ~ in_ball b (skin_dual (map fst weight_vertices) (map snd weight_vertices) u p).

(* --- Proofs --- *)

Lemma qmul_linear_l b : linear (fun a : quat R => qmul a b).
Proof. split; [|split]; vring. Qed.
Lemma qmul_linear_r a : linear (fun b : quat R => qmul a b).
Proof. split; [|split]; vring. Qed.
Lemma reach_linear p f : linear (reach_at p f).
Proof.
  destruct (qmul_linear_l (pure p)) as (Z1 & A1 & S1), (qmul_linear_r (pure f)) as (Z2 & A2 & S2). unfold reach_at.
  split; [|split]; intros; cbn [fst snd lzero ladd lscale lin_pair]; rewrite ?Z1, ?Z2, ?A1, ?A2, ?S1, ?S2; vec_ring.
Qed.

(* Im(E q* ) = ||q||^2 (v' - f), as f is pure. *)
Lemma reach_times_conj p f (q d : quat R) :
  im (qmul (reach_at p f (q, d)) (conj q)) = ((turned q p q + 2 *: im (qmul d (conj q))) - norm2 q *: f)%V.
Proof. unfold reach_at. cbn [fst snd]. vring. Qed.
Lemma reach_real_part p f (q d : quat R) : qw (qmul (reach_at p f (q, d)) (conj q)) = 2 * dot d q.
Proof. unfold reach_at. cbn [fst snd]. vring. Qed.

Lemma skin_dual_from p f qs ds u : let q := comb u qs in q <> lzero ->
  (skin_dual qs ds u p - f)%V = (/ norm2 q *: im (qmul (reach_at p f (q, comb u ds)) (conj q)))%V.
Proof.
  intros q N. apply norm2_pos in N. rewrite reach_times_conj. unfold skin_dual. cbv zeta. fold q.
  revert N. generalize (norm2 q) (turned q p q + 2 *: im (qmul (comb u ds) (conj q)))%V. intros n t N. vec_field. lra.
Qed.

Theorem dual_quaternion_ball_holds : dual_quaternion_ball.
Proof.
  intros weight_vertices a p f r u B U. set (qs := map fst weight_vertices). set (ds := map snd weight_vertices).
  assert (N : 0 < dot (comb u qs) a /\ comb u qs <> lzero).
  { apply (blend_not_zero_holds _ _ _ a qs).
    - apply Forall_map, Forall_forall. intros c I. apply (B c I).
    - exists u. split; [unfold qs; now rewrite map_length|reflexivity]. }
  destruct N as [D N]. split; [exact N|]. set (q := comb u qs) in *.
  assert (A : 0 < norm a).
  { pose proof (dot_le_norms q a). pose proof (norm_nonneg a).
    destruct (Rle_lt_or_eq_dec _ _ (norm_nonneg a)) as [|Z]; auto. rewrite <- Z in *. lra. }
  assert (R0 : 0 <= r).
  { destruct weight_vertices as [|c cs]; [now apply convex_not_empty in U|]. destruct (B c (or_introl eq_refl)) as [Dc Bc].
    eapply Rle_trans; [|exact Bc]. apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [apply norm_nonneg|left; now apply inv_pos]. }
  assert (C : norm (reach_at p f (q, comb u ds)) * norm a <= r * dot q a).
  { unfold q, qs, ds. rewrite <- comb_pair, (comb_linear _ u weight_vertices (reach_linear p f)), dot_comb, map_map.
    destruct U as (L & P & _). clear - B L P A. revert u L P; induction weight_vertices as [|c weight_vertices IH];
      intros [|x u] L P; try discriminate.
    - cbn [map comb]. rewrite norm_zero. cbn. lra.
    - apply Forall_cons_iff in P as [X P]. cbn [map comb].
      destruct (B c (or_introl eq_refl)) as [Dc Bc]. specialize (IH (fun k K => B k (or_intror K)) u ltac:(auto) P).
      assert (norm a * norm (reach_at p f c) <= r * dot (fst c) a).
      { apply Rmult_le_compat_r with (r := dot (fst c) a) in Bc; [|lra].
        replace (norm a * (norm (reach_at p f c) / dot (fst c) a) * dot (fst c) a) with (norm a * norm (reach_at p f c)) in Bc
          by (field; lra). exact Bc. }
      pose proof (norm_add (x *: reach_at p f c)%V (comb u (map (reach_at p f) weight_vertices))) as T.
      rewrite norm_scale in T by auto. cbn [ladd lscale lin_num add mul ops_R] in *.
      apply Rmult_le_compat_r with (r := norm a) in T; [|lra]. nra. }
  unfold in_ball. cbn [center radius]. rewrite skin_dual_from by exact N. fold q.
  pose proof (norm_pos q N) as Q. rewrite norm_scale by (left; apply inv_pos; now apply norm2_pos).
  apply Rmult_le_reg_l with (norm2 q); [now apply norm2_pos|]. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l by (apply norm2_pos in N; lra).
  set (E := reach_at p f (q, comb u ds)) in *.
  assert (I : norm (im (qmul E (conj q))) <= norm E * norm q).
  { apply norm_le. split; [apply Rmult_le_pos; apply norm_nonneg|]. eapply Rle_trans; [apply norm2_im|].
    rewrite norm2_qmul, norm2_conj, <- !norm_sq. right. ring. }
  assert (G : norm E <= r * norm q).
  { apply Rmult_le_reg_r with (1 := A). eapply Rle_trans; [exact C|]. pose proof (dot_le_norms q a) as DL.
    apply Rmult_le_compat_l with (r := r) in DL; auto. lra. }
  rewrite <- norm_sq. apply Rle_trans with (1 := I). replace (norm q * norm q * r) with (r * norm q * norm q) by ring.
  apply Rmult_le_compat_r; lra.
Qed.

Theorem reach_is_distance_holds : reach_is_distance.
Proof.
  intros [q d] p f N. cbn [fst snd] in *. unfold weight_vertex_image. cbn [fst snd].
  assert (Z : comb [1] [q] = q) by (cbn [comb]; vec_ring). assert (Zd : comb [1] [d] = d) by (cbn [comb]; vec_ring).
  rewrite skin_dual_from by (now rewrite Z). rewrite Z, Zd, norm2_scale. apply norm2_pos in N.
  assert (S : norm2 (reach_at p f (q, d)) * norm2 q = norm2 (im (qmul (reach_at p f (q, d)) (conj q))) + 4 * (dot d q * dot d q)).
  { rewrite <- (norm2_conj q), <- norm2_qmul.
    replace (4 * (dot d q * dot d q)) with (2 * dot d q * (2 * dot d q)) by ring. rewrite <- (reach_real_part p f q d).
    generalize (qmul (reach_at p f (q, d)) (conj q)). clear. vring. }
  apply Rmult_eq_reg_r with (norm2 q); [|lra]. rewrite S. field. lra.
Qed.

Theorem axis_excludes_zero_holds : axis_excludes_zero.
Proof.
  intros qs a F H. apply Forall_forall in F. destruct (blend_not_zero_holds _ _ _ a qs lzero F H) as [_ N]. now apply N.
Qed.

(* No motion and a translation by (2, 0, 0), of opposite signs: with the weights (1 + t) / 2 and (1 - t) / 2 the origin is
   carried to (1 - 1 / t, 0, 0). *)
Theorem no_ball_near_zero_holds : no_ball_near_zero.
Proof.
  set (weight_vertices := [(Quat 1 0 0 0, Quat 0 0 0 0); (Quat (-1) 0 0 0, Quat 0 (-1) 0 0)]).
  exists weight_vertices, (Vec 0 0 0). intros [c r]. set (m := Rmax (vx c - 1 + Rabs r) 0 + 1).
  assert (M : 1 <= m /\ vx c - 1 + Rabs r < m) by (unfold m, Rmax; destruct (Rle_dec _ _); lra).
  set (t := - / (m + 1)). assert (T : (m + 1) * / (m + 1) = 1) by (apply Rinv_r; lra).
  assert (T0 : 0 < / (m + 1)) by (apply inv_pos; lra). assert (T1 : t <> 0) by (unfold t; lra).
  exists [(1 + t) / 2; (1 - t) / 2]. split; [|split].
  - repeat split; [|cbn; lra]. repeat apply Forall_cons; try apply Forall_nil; unfold t; nra.
  - apply norm2_pos_inv. cbn. vunfold. nra.
  - intros B. unfold in_ball in B. cbn [center radius] in B.
    replace (skin_dual _ _ _ _) with (Vec (2 + m) 0 0) in B.
    + apply norm_le in B as [R0 B]. rewrite Rabs_pos_eq in M by auto. destruct c as [x y z]. cbn [vx] in M. vunfold. nra.
    + unfold skin_dual, weight_vertices. cbn [map fst snd comb].
      replace (((1 + t) / 2) *: Quat 1 0 0 0 + (((1 - t) / 2) *: Quat (-1) 0 0 0 + lzero))%V with (Quat t 0 0 0)
        by (vunfold; f_equal; field).
      replace (((1 + t) / 2) *: Quat 0 0 0 0 + (((1 - t) / 2) *: Quat 0 (-1) 0 0 + lzero))%V with (Quat 0 (- (1 - t) / 2) 0 0)
        by (vunfold; f_equal; field).
      cbv zeta. replace (norm2 (Quat t 0 0 0)) with (t * t) by (vunfold; ring).
      replace (2 + m) with (1 - / t) by (unfold t; rewrite Rinv_opp, Rinv_inv; ring).
      vunfold. f_equal; field; auto.
Qed.

(* The hypotheses can be met: a turn by 74 degrees, about the axis 1. *)
Example dual_ball_instance : let weight_vertices := [(Quat 1 0 0 0, Quat 0 0 0 0);
  (Quat (4 / 5) (3 / 5) 0 0, Quat 0 0 0 0)] in
  let a := Quat 1 0 0 0 in let f := Vec 0 0 0 in
  exists r, forall c, In c weight_vertices -> 0 < dot (fst c) a /\
    norm a * (norm (reach_at (Vec 0 1 0) f c) / dot (fst c) a) <= r.
Proof.
  cbv zeta. set (g := fun c => norm (Quat 1 0 0 0) * (norm (reach_at (Vec 0 1 0) (Vec 0 0 0) c) / dot (fst c) (Quat 1 0 0 0))).
  set (c1 := (Quat 1 0 0 0, Quat 0 0 0 0)). set (c2 := (Quat (4 / 5) (3 / 5) 0 0, Quat 0 0 0 0)). exists (Rmax (g c1) (g c2)).
  intros c [<-|[<-|[]]]; (split; [cbn; vunfold; lra|]); [apply Rmax_l|apply Rmax_r].
Qed.
