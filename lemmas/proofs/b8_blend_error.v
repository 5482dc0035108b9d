(* SPDX-License-Identifier: MIT *)
(* Beyond the paper: how far off is what a blend makes of a point, if the blend is off. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.b7_motion_bound.
Import ListNotations.

(* --- Statements --- *)

(* t(q, d) = 2 Im(d q* ) / ||q||^2 *)
Definition moved (q d : quat R) : vec R := (2 / norm2 q *: im (qmul d (conj q)))%V.

Definition turns_by_error : Prop :=
  forall (q q' : quat R) (x : vec R) (e kappa : R), q' <> lzero -> 0 <= kappa -> 1 <= kappa * norm q -> norm (q' - q) <= e ->
  norm (rotate q' x - rotate q x) <= 2 * kappa * e * norm x.
Definition moves_by_error : Prop :=
  forall (q q' d d' : quat R) (e f l kappa : R), 0 <= kappa -> 1 <= kappa * norm q -> 1 <= kappa * norm q' ->
  norm (q' - q) <= e -> norm (d' - d) <= f -> norm d <= l ->
  norm (moved q' d' - moved q d) <= 2 * kappa * (f + kappa * e * l).
(* Spherical blending by rigid transforms about a center c. *)
Definition spherically_blended (cs : list rigid) (c : vec R) (w : list R) (v : vec R) : vec R :=
  skin_spherical (map rotation cs) (map (fun t => apply_rigid t c) cs) c w v.
Definition change (w w' : list R) : R := sum (map (fun p => Rabs (snd p - fst p)) (combine w w')).
Definition spherical_moves_by_error : Prop :=
  forall (cs : list rigid) (c v y o : vec R) (w w' : list R) (e a s kappa : R),
  Forall (fun t => norm2 (rotation t) = 1) cs -> convex (length cs) w -> convex (length cs) w' -> change w w' <= e ->
  0 <= kappa -> 1 <= kappa * norm (comb w (map rotation cs)) -> 1 <= kappa * norm (comb w' (map rotation cs)) ->
  Forall (fun t => norm (apply_rigid t v - o) <= a) cs -> Forall (fun t => norm (rotate (rotation t) (v - c) - y) <= s) cs ->
  norm (spherically_blended cs c w' v - spherically_blended cs c w v) <= e * (a + s * (1 + kappa + kappa * kappa)).
(* No smaller factor than 2 kappa will do. *)
Definition turns_by_less : Prop :=
  exists factor, factor < 2 /\ forall (q q' : quat R) (x : vec R) (e kappa : R), q' <> lzero -> 0 <= kappa ->
  1 <= kappa * norm q -> norm (q' - q) <= e -> norm (rotate q' x - rotate q x) <= factor * kappa * e * norm x.

(* --- Proofs --- *)

Lemma long_not_zero {E} `{Euclid E} (x : E) kappa : 1 <= kappa * norm x -> x <> lzero.
Proof. intros L ->. rewrite norm_zero in L. lra. Qed.

(* ||q||^2 (1 - (n, n')^2) is the squared distance of q from the line of q'. *)
Lemma distance_from_line {E} `{Euclid E} (p q : E) : 0 < norm2 p -> norm2 q - dot p q * dot p q / norm2 p <= norm2 (p - q).
Proof.
  intros P. replace (norm2 (p - q)) with (norm2 p - 2 * dot p q + norm2 q)
    by (unfold norm2; rewrite !dot_sub_l, !dot_sub_r, (dot_comm q p); ring).
  assert (D : norm2 p - 2 * dot p q + dot p q * dot p q / norm2 p = (norm2 p - dot p q) * (norm2 p - dot p q) / norm2 p)
    by (field; lra).
  assert (0 <= (norm2 p - dot p q) * (norm2 p - dot p q) / norm2 p); [|lra].
  apply Rmult_le_pos; [apply Rle_0_sqr|left; now apply inv_pos].
Qed.

Lemma norm2_of_unit {E} `{Euclid E} (x : E) : x <> lzero -> norm2 (/ norm x *: x) = 1.
Proof.
  intros N. rewrite norm2_scale, <- (norm_sq x). apply norm_pos in N. field. lra.
Qed.
Lemma unit_turns (q : quat R) x : q <> lzero -> rotate (/ norm q *: q) x = rotate q x.
Proof. intros N. apply rotate_of_multiple; [|exact N]. apply norm_pos, inv_pos in N. lra. Qed.

Theorem turns_by_error_holds : turns_by_error.
Proof.
  intros q q' x e kappa N K L E. assert (M := long_not_zero q kappa L).
  pose proof (turns_little_holds (/ norm q' *: q')%V (/ norm q *: q)%V x (norm2_of_unit q' N) (norm2_of_unit q M)) as T.
  rewrite !unit_turns, dot_scale_l, dot_scale_r in T by assumption.
  pose proof (distance_from_line q' q (norm2_pos q' N)) as D.
  assert (E0 : 0 <= e) by (pose proof (norm_nonneg (q' - q)%V); lra).
  pose proof (norm_sq (q' - q)%V) as S. pose proof (norm_nonneg (q' - q)%V). apply norm_pos in N as N', M as M'.
  pose proof (norm_sq q) as Sq. pose proof (norm_sq q') as Sq'. pose proof (norm_sq x) as Sx. pose proof (norm_nonneg x).
  set (g := dot q' q) in *. set (a := norm q) in *. set (b := norm q') in *.
  assert (C : (1 - / b * (/ a * g) * (/ b * (/ a * g))) * (a * a) <= e * e).
  { replace ((1 - / b * (/ a * g) * (/ b * (/ a * g))) * (a * a)) with (norm2 q - g * g / norm2 q')
      by (rewrite <- Sq, <- Sq'; field; lra). nra. }
  apply norm_le. split; [repeat apply Rmult_le_pos; lra|]. eapply Rle_trans; [exact T|]. rewrite <- Sx.
  set (c := 1 - / b * (/ a * g) * (/ b * (/ a * g))) in *.
  assert (B : c <= kappa * e * (kappa * e)).
  { assert (1 <= kappa * a * (kappa * a)) by nra. destruct (Rle_or_lt c 0) as [Z|Z]; [nra|].
    apply Rle_trans with (c * (kappa * a * (kappa * a))); [nra|].
    replace (c * (kappa * a * (kappa * a))) with (kappa * kappa * (c * (a * a))) by ring.
    replace (kappa * e * (kappa * e)) with (kappa * kappa * (e * e)) by ring. apply Rmult_le_compat_l; nra. }
  replace (2 * kappa * e * norm x * (2 * kappa * e * norm x)) with (4 * (kappa * e * (kappa * e)) * (norm x * norm x)) by ring.
  apply Rmult_le_compat_r; [nra|lra].
Qed.

(* Inverses. *)
Definition inverse_of (q : quat R) : quat R := (/ norm2 q *: conj q)%V.
Lemma norm_inverse q : q <> lzero -> norm (inverse_of q) = / norm q.
Proof.
  intros N. apply norm_pos in N as P. apply norm_eq; [left; now apply inv_pos|].
  unfold inverse_of. rewrite norm2_scale, norm2_conj, <- (norm_sq q). field. lra.
Qed.
Lemma norm_between_inverses p q : p <> lzero -> q <> lzero ->
  norm (inverse_of p - inverse_of q) = norm (p - q) * / norm p * / norm q.
Proof.
  intros P Q. apply norm_pos in P as P', Q as Q'. apply norm_eq.
  - repeat apply Rmult_le_pos; try apply norm_nonneg; left; now apply inv_pos.
  - replace (norm (p - q) * / norm p * / norm q * (norm (p - q) * / norm p * / norm q)) with
      (norm (p - q) * norm (p - q) / (norm p * norm p * (norm q * norm q))) by (field; lra).
    rewrite !norm_sq. apply norm2_pos in P, Q. unfold inverse_of. revert P Q.
    replace (norm2 (p - q)) with (norm2 p - 2 * dot p q + norm2 q)
      by (unfold norm2; rewrite !dot_sub_l, !dot_sub_r, (dot_comm q p); ring).
    replace (norm2 (/ norm2 p *: conj p - / norm2 q *: conj q)) with
      (/ norm2 p * / norm2 p * norm2 p - 2 * (/ norm2 p * / norm2 q * dot p q) + / norm2 q * / norm2 q * norm2 q)
      by (generalize (/ norm2 p) (/ norm2 q); intros; vring).
    intros P Q. field. lra.
Qed.

Lemma norm_im_le (a : quat R) : norm (im a) <= norm a.
Proof. apply norm_le. split; [apply norm_nonneg|]. rewrite norm_sq. apply norm2_im. Qed.

Lemma moved_by_inverse q d : moved q d = (2 *: im (qmul d (inverse_of q)))%V.
Proof. unfold moved, inverse_of, Rdiv. generalize (/ norm2 q). intros. vring. Qed.

Theorem moves_by_error_holds : moves_by_error.
Proof.
  intros q q' d d' e f l kappa K L L' E F D. assert (N := long_not_zero q kappa L). assert (N' := long_not_zero q' kappa L').
  rewrite !moved_by_inverse.
  replace (_ - _)%V with (2 *: im (qmul (d' - d) (inverse_of q') + qmul d (inverse_of q' - inverse_of q)))%V
    by (generalize (inverse_of q) (inverse_of q'); vring).
  rewrite norm_scale by lra. rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|].
  eapply Rle_trans; [apply norm_im_le|]. eapply Rle_trans; [apply norm_add|].
  rewrite !norm_qmul, norm_inverse, norm_between_inverses by assumption.
  apply norm_pos in N, N'. pose proof (norm_nonneg (q' - q)%V). pose proof (norm_nonneg (d' - d)%V). pose proof (norm_nonneg d).
  assert (I : 0 < / norm q <= kappa).
  { split; [now apply inv_pos|]. apply Rmult_le_reg_r with (norm q); [exact N|]. rewrite Rinv_l; lra. }
  assert (I' : 0 < / norm q' <= kappa).
  { split; [now apply inv_pos|]. apply Rmult_le_reg_r with (norm q'); [exact N'|]. rewrite Rinv_l; lra. }
  set (i := / norm q) in *. set (i' := / norm q') in *. clearbody i i'.
  rewrite Rmult_plus_distr_l. apply Rplus_le_compat.
  - rewrite (Rmult_comm kappa). apply Rmult_le_compat; lra.
  - replace (kappa * (kappa * e * l)) with (l * (e * kappa * kappa)) by ring.
    apply Rmult_le_compat; [lra| |lra|].
    + repeat apply Rmult_le_pos; lra.
    + apply Rmult_le_compat; try lra; [apply Rmult_le_pos; lra|apply Rmult_le_compat; lra].
Qed.

(* --- Spherical blending --- *)

Lemma comb_difference {E} `{Euclid E} (b : R) (w w' : list R) (xs : list E) :
  length w = length xs -> length w' = length xs -> Forall (fun x => norm x <= b) xs ->
  norm (comb w' xs - comb w xs) <= change w w' * b.
Proof.
  intros L L' F. revert w w' L L'. induction F as [|x xs X F IH]; intros [|a w] [|a' w'] L L'; try discriminate.
  - unfold change. cbn. replace (lzero - lzero)%V with (lzero : E) by vec_ring. rewrite norm_zero. lra.
  - specialize (IH w w' ltac:(auto) ltac:(auto)). rewrite !comb_cons.
    replace (a' *: x + comb w' xs - (a *: x + comb w xs))%V with ((a' - a) *: x + (comb w' xs - comb w xs))%V by vec_ring.
    eapply Rle_trans; [apply norm_add|]. rewrite norm_scale_abs. unfold change in *. cbn [combine map fst snd]. rewrite sum_cons.
    rewrite Rmult_plus_distr_r. apply Rplus_le_compat; [|exact IH]. apply Rmult_le_compat_l; [apply Rabs_pos|exact X].
Qed.
Lemma change_nonneg w w' : 0 <= change w w'.
Proof.
  unfold change. apply sum_nonneg. apply Forall_forall. intros x I. apply in_map_iff in I as (p & <- & _). apply Rabs_pos.
Qed.

(* The dual parts by which the turned x is beside y. *)
Definition beside (y x : vec R) (t : rigid) : quat R := (1 / 2 *: qmul (pure (rotate (rotation t) x - y)) (rotation t))%V.
Lemma norm_beside y x t s : norm2 (rotation t) = 1 -> norm (rotate (rotation t) x - y) <= s -> norm (beside y x t) <= s / 2.
Proof.
  intros U S. unfold beside. rewrite norm_scale, norm_qmul, (norm_unit (rotation t) U) by lra.
  replace (norm (pure (rotate (rotation t) x - y)%V)) with (norm (rotate (rotation t) x - y)) by (unfold norm; now rewrite norm2_pure).
  lra.
Qed.
Lemma comb_beside cs y x w : length w = length cs -> Forall (fun t => norm2 (rotation t) = 1) cs ->
  let q := comb w (map rotation cs) in
  (2 *: comb w (map (beside y x) cs))%V = (qmul q (pure x) - qmul (pure y) q)%V.
Proof.
  intros L U. cbv zeta. revert w L. induction U as [|t cs Ut U IH]; intros [|a w] L; try discriminate; cbn [map comb].
  - vring.
  - specialize (IH w ltac:(auto)).
    assert (B : (2 *: beside y x t)%V = (qmul (rotation t) (pure x) - qmul (pure y) (rotation t))%V).
    { unfold beside, rotate. rewrite Ut, Rinv_1. revert Ut. generalize (rotation t). intros q Ut.
      assert (G : qmul (pure (turned q x q)) q = (norm2 q *: qmul q (pure x))%V) by vring.
      replace (qmul (pure (1 *: turned q x q - y)%V) q) with (qmul (pure (turned q x q)) q - qmul (pure y) q)%V
        by (generalize (turned q x q); vring).
      rewrite G, Ut. generalize (qmul q (pure x)) (qmul (pure y) q). vfield. }
    replace (2 *: (a *: beside y x t + comb w (map (beside y x) cs)))%V with
      (a *: (2 *: beside y x t) + 2 *: comb w (map (beside y x) cs))%V by vec_ring.
    rewrite B, IH. generalize (comb w (map rotation cs)) (rotation t). vring.
Qed.
Lemma turned_by_moved cs y x w : length w = length cs -> Forall (fun t => norm2 (rotation t) = 1) cs ->
  let q := comb w (map rotation cs) in q <> lzero ->
  rotate q x = (y + moved q (comb w (map (beside y x) cs)))%V.
Proof.
  intros L U q N. apply norm2_quat_pos in N. pose proof (comb_beside cs y x w L U) as B. fold q in B. cbv zeta in B.
  unfold moved, rotate. revert B N. generalize (comb w (map (beside y x) cs)). intros d B N.
  assert (T : (2 *: im (qmul d (conj q)))%V = (turned q x q - norm2 q *: y)%V).
  { transitivity (im (qmul (2 *: d)%V (conj q))); [vring|]. rewrite B. vring. }
  replace (2 / norm2 q *: im (qmul d (conj q)))%V with (/ norm2 q *: (2 *: im (qmul d (conj q))))%V.
  2:{ unfold Rdiv. generalize (/ norm2 q). vring. }
  rewrite T. generalize (turned q x q). revert N. generalize (norm2 q). intros n N z. vec_field. lra.
Qed.

Lemma comb_map2 {X E} `{Euclid E} (f g : X -> E) w xs :
  comb w (map (fun x => f x - g x)%V xs) = (comb w (map f xs) - comb w (map g xs))%V.
Proof. revert xs. induction w as [|a w IH]; intros [|x xs]; cbn; try vec_ring. rewrite IH. vec_ring. Qed.
Lemma comb_map_sub {X} (f : X -> vec R) o w (xs : list X) : convex (length xs) w ->
  comb w (map (fun x => f x - o)%V xs) = (comb w (map f xs) - o)%V.
Proof.
  intros C. replace (map (fun x => f x - o)%V xs) with (map (fun x => x + (lzero - o))%V (map f xs)).
  - rewrite comb_shift_convex by now rewrite map_length. vec_ring.
  - rewrite map_map. apply map_ext. intros x. vec_ring.
Qed.

Lemma spherically_blended_parts cs c v y o w : Forall (fun t => norm2 (rotation t) = 1) cs -> convex (length cs) w ->
  let q := comb w (map rotation cs) in q <> lzero ->
  spherically_blended cs c w v =
  (moved q (comb w (map (beside y (v - c)%V) cs)) + comb w (map (fun t => apply_rigid t v - o)%V cs) -
   comb w (map (fun t => rotate (rotation t) (v - c) - y)%V cs) + o)%V.
Proof.
  intros U C q N. assert (L : length w = length cs) by apply C. unfold spherically_blended, skin_spherical. fold q.
  rewrite (turned_by_moved cs y (v - c)%V w L U N). fold q.
  replace (map (fun t => apply_rigid t c) cs) with (map (fun t => apply_rigid t v - rotate (rotation t) (v - c))%V cs)
    by (apply map_ext; intros t; unfold apply_rigid; rewrite rotate_sub; vec_ring).
  rewrite comb_map2, !comb_map_sub by exact C. vec_ring.
Qed.

Theorem spherical_moves_by_error_holds : spherical_moves_by_error.
Proof.
  intros cs c v y o w w' e a s kappa U C C' D K Q Q' A S.
  assert (N := long_not_zero _ kappa Q). assert (N' := long_not_zero _ kappa Q').
  rewrite (spherically_blended_parts cs c v y o w), (spherically_blended_parts cs c v y o w') by assumption.
  assert (L : length w = length cs) by apply C. assert (L' : length w' = length cs) by apply C'.
  assert (B : Forall (fun x => norm x <= s / 2) (map (beside y (v - c)%V) cs)).
  { apply Forall_map. revert U S. clear. rewrite !Forall_forall. intros U S t I. apply norm_beside; auto. }
  assert (E0 : 0 <= e) by (pose proof (change_nonneg w w'); lra).
  assert (S0 : 0 <= s).
  { destruct cs as [|t cs]; [destruct (convex_not_empty w C)|]. inversion S; subst. pose proof (norm_nonneg (rotate (rotation t) (v - c) - y)%V). lra. }
  assert (A0 : 0 <= a).
  { destruct cs as [|t cs]; [destruct (convex_not_empty w C)|]. inversion A; subst. pose proof (norm_nonneg (apply_rigid t v - o)%V). lra. }
  set (q := comb w (map rotation cs)) in *. set (q' := comb w' (map rotation cs)) in *.
  set (d := comb w (map (beside y (v - c)%V) cs)). set (d' := comb w' (map (beside y (v - c)%V) cs)).
  assert (R1 : norm (q' - q) <= e).
  { eapply Rle_trans; [apply (comb_difference 1)|]; rewrite ?map_length; auto.
    - apply Forall_map. eapply Forall_impl; [|exact U]. intros t Ut. cbn beta. rewrite (norm_unit _ Ut). lra.
    - lra. }
  assert (R2 : norm (d' - d) <= e * (s / 2)).
  { eapply Rle_trans; [apply (comb_difference (s / 2))|]; rewrite ?map_length; auto. apply Rmult_le_compat_r; lra. }
  assert (R3 : norm d <= s / 2).
  { assert (I : in_ball (Ball lzero (s / 2)) d).
    { apply (convex_set_comb (in_ball (Ball lzero (s / 2))) w (map (beside y (v - c)%V) cs)).
      - apply ball_convex.
      - rewrite map_length. exact C.
      - eapply Forall_impl; [|exact B]. intros x X. unfold in_ball. cbn [center radius].
        replace (x - lzero)%V with x by vec_ring. exact X. }
    unfold in_ball in I. cbn [center radius] in I. replace (d - lzero)%V with d in I by vec_ring. exact I. }
  pose proof (moves_by_error_holds q q' d d' e (e * (s / 2)) (s / 2) kappa K Q Q' R1 R2 R3) as M.
  assert (R4 : norm (comb w' (map (fun t => apply_rigid t v - o)%V cs) - comb w (map (fun t => apply_rigid t v - o)%V cs)) <= e * a).
  { eapply Rle_trans; [apply (comb_difference a)|]; rewrite ?map_length; auto.
    - apply Forall_map. exact A.
    - apply Rmult_le_compat_r; lra. }
  assert (R5 : norm (comb w (map (fun t => rotate (rotation t) (v - c) - y)%V cs) -
                     comb w' (map (fun t => rotate (rotation t) (v - c) - y)%V cs)) <= e * s).
  { rewrite norm_opposite. eapply Rle_trans; [apply (comb_difference s)|]; rewrite ?map_length; auto.
    - apply Forall_map. exact S.
    - apply Rmult_le_compat_r; lra. }
  match goal with |- norm (?m' + ?i' - ?r' + o - (?m + ?i - ?r + o)) <= _ =>
    replace (m' + i' - r' + o - (m + i - r + o))%V with ((m' - m) + ((i' - i) + (r - r')))%V by vec_ring end.
  eapply Rle_trans; [apply norm_add|]. eapply Rle_trans; [apply Rplus_le_compat; [exact M|]|].
  - eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat; [exact R4|exact R5].
  - right. field.
Qed.

(* q' is the nearest to q of those that turn by twice the angle of cosine 4/5, and x is perpendicular to the axis. *)
Theorem turns_by_less_is_false : ~ turns_by_less.
Proof.
  intros (factor & Less & H).
  set (q := Quat 1 0 0 0 : quat R). set (q' := Quat (16 / 25) (12 / 25) 0 0 : quat R). set (x := Vec 0 1 0 : vec R).
  assert (A : norm q = 1) by (apply norm_eq; [lra|unfold q; vunfold; lra]).
  assert (B : norm (q' - q)%V = 3 / 5) by (apply norm_eq; [lra|unfold q, q'; vunfold; lra]).
  assert (C : norm x = 1) by (apply norm_eq; [lra|unfold x; vunfold; lra]).
  assert (D : norm (rotate q' x - rotate q x)%V = 6 / 5).
  { apply norm_eq; [lra|]. unfold rotate.
    replace (norm2 q') with (16 / 25) by (unfold q'; vunfold; lra). replace (norm2 q) with 1 by (unfold q; vunfold; lra).
    unfold q, q', x. vunfold. field. }
  assert (N : q' <> lzero) by (apply norm2_pos_inv; unfold q'; vunfold; lra).
  specialize (H q q' x (3 / 5) 1 N). rewrite A, B, C, D in H. lra.
Qed.

(* The hypotheses can be met. *)
Example blend_error_instance : let q := Quat 1 0 0 0 : quat R in let q' := Quat 1 (1 / 10) 0 0 : quat R in
  q' <> lzero /\ 1 <= 1 * norm q /\ 1 <= 1 * norm q' /\ norm (q' - q) <= 1 / 10 /\ norm (q' - q') <= 0 /\ norm q <= 1.
Proof.
  cbv zeta. assert (A : norm (Quat 1 0 0 0 : quat R) = 1) by (apply norm_eq; [lra|vunfold; lra]).
  split; [apply norm2_pos_inv; vunfold; lra|]. rewrite A. split; [lra|]. split; [|split; [|split; [|lra]]].
  - rewrite Rmult_1_l. apply sq_le_inv; [apply norm_nonneg|]. rewrite norm_sq. vunfold. lra.
  - apply norm_le. split; [lra|]. vunfold. lra.
  - apply norm_le. split; [lra|]. vunfold. lra.
Qed.
Example spherical_instance :
  let cs := [Rigid (Quat 1 0 0 0) lzero; Rigid (Quat (4 / 5) (3 / 5) 0 0) lzero] in let v := Vec 1 0 0 : vec R in
  let w := [1 / 2; 1 / 2] in let w' := [3 / 5; 2 / 5] in
  Forall (fun t => norm2 (rotation t) = 1) cs /\ convex (length cs) w /\ convex (length cs) w' /\ change w w' <= 1 / 5 /\
  1 <= 2 * norm (comb w (map rotation cs)) /\ 1 <= 2 * norm (comb w' (map rotation cs)) /\
  Forall (fun t => norm (apply_rigid t v - lzero) <= 1) cs /\ Forall (fun t => norm (rotate (rotation t) (v - lzero)%V - lzero) <= 1) cs.
Proof.
  cbv zeta. split; [repeat constructor; cbn [rotation]; vunfold; field|]. split; [|split; [|split]].
  - repeat split; [repeat constructor; lra|cbn; lra].
  - repeat split; [repeat constructor; lra|cbn; lra].
  - unfold change. cbn. rewrite Rabs_pos_eq, Rabs_left by lra. lra.
  - assert (Half : forall q : quat R, 1 / 4 <= norm2 q -> 1 <= 2 * norm q).
    { intros q Q. pose proof (norm_nonneg q). pose proof (norm_sq q). nra. }
    split; [apply Half; cbn [map comb rotation]; vunfold; lra|]. split; [apply Half; cbn [map comb rotation]; vunfold; lra|].
    split; repeat apply Forall_cons; try apply Forall_nil; apply norm_le; (split; [lra|]);
      unfold apply_rigid, rotate; cbn [rotation translation]; vunfold; right; field.
Qed.
