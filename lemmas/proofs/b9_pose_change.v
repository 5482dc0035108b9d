(* SPDX-License-Identifier: MIT *)
(* Beyond the paper: how far a skinned vertex can be in another pose, from how far the joints are from where they were. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.b7_motion_bound.
Import ListNotations.

(* A joint in both poses: C_k and C'_k. *)
Notation joint := (rigid * rigid)%type.
Definition olds (js : list joint) := map fst js.
Definition nows (js : list joint) := map snd js.
Definition are_units (j : joint) := norm2 (rotation (fst j)) = 1 /\ norm2 (rotation (snd j)) = 1.
Definition turned_by (j : joint) := norm (rotation (snd j) - rotation (fst j)).
Definition moved_by (j : joint) (f : vec R) := norm (apply_rigid (snd j) f - apply_rigid (fst j) f).

(* --- Statements --- *)

(* (i), and how far a turn about an axis that is perpendicular to x moves it. *)
Definition moves_at_most : Prop := forall (j : joint) (a f : vec R) e, are_units j -> turned_by j <= e ->
  moved_by j f <= moved_by j a + 2 * e * norm (f - a).
Definition rotation_moves_at_most : Prop := forall (p q : quat R) (x : vec R) e, norm2 p = 1 -> norm2 q = 1 -> norm (q - p) <= e ->
  norm (rotate q x - rotate p x) <= 2 * e * norm x.
Definition rotation_reaches : Prop := forall (p q : quat R) (x : vec R), norm2 p = 1 -> norm2 q = 1 ->
  dot (im (qmul (conj p) q)) x = 0 ->
  norm2 (rotate q x - rotate p x) = norm2 (q - p) * (4 - norm2 (q - p)) * norm2 x.

(* (ii), for any images x_k in the old pose and y_k in the new one. *)
Definition spread (xs : list (vec R)) : R := total (fun p => norm2 (fst p - snd p)) (pairs xs).
Definition are_near (d : R) (xys : list (vec R * vec R)) := Forall (fun p => norm (snd p - fst p) <= d) xys.
Definition hull_moves_at_most : Prop := forall u (xys : list (vec R * vec R)) d, convex (length xys) u -> are_near d xys ->
  norm (comb u (map snd xys) - comb u (map fst xys)) <= d.
Definition spread_grows_at_most : Prop := forall (xys : list (vec R * vec R)) d A, are_near d xys -> 0 <= d -> 0 <= A ->
  spread (map fst xys) <= A * A ->
  let after := A + INR (length xys) * d in spread (map snd xys) <= after * after.
(* Two times m images reach it: m of them at h go one way, and m at -h go the other. *)
Definition opposed (m : nat) (h d : R) : list (vec R * vec R) :=
  repeat (Vec h 0 0, Vec (h + d) 0 0) m ++ repeat (Vec (- h) 0 0, Vec (- h - d) 0 0) m.
Definition spread_reaches : Prop := forall m h d, 0 <= h -> 0 <= d -> let xys := opposed m h d in let n := INR (length xys) in
  are_near d xys /\ spread (map fst xys) = (n * h) * (n * h) /\ spread (map snd xys) = (n * h + n * d) * (n * h + n * d).

(* (iii), whatever the signs of skinning. *)
Definition is_sign (s : R) := s = 1 \/ s = -1.
Definition cosine_falls_at_most : Prop := forall (j k : joint) s t e, are_units j -> are_units k -> is_sign s -> is_sign t ->
  turned_by j <= e -> turned_by k <= e ->
  s * t * dot (rotation (fst j)) (rotation (fst k)) - 2 * e <= s * t * dot (rotation (snd j)) (rotation (snd k)).

(* All that is asked of the joints: a is at least A(f) in the old pose. *)
Definition pose_change (c e d a : R) (f : vec R) (js : list joint) := are_within c (olds js) /\ 0 <= c - 2 * e /\ 0 <= e /\ 0 <= d /\
  Forall are_units js /\ Forall (fun j => turned_by j <= e) js /\ Forall (fun j => moved_by j f <= d) js /\
  0 <= a /\ squared_spread (olds js) f <= a * a.
Definition new_pose_is_within : Prop := forall c e d a f js, pose_change c e d a f js ->
  let after := a + INR (length js) * d in
  are_within (c - 2 * e) (nows js) /\ squared_spread (nows js) f <= after * after.

(* The skinned vertex: by dual quaternions with a share s of the first bound of b7_motion_bound, by linear blending, and spherically
   about the center f. *)
Definition dual_stays_near : Prop := forall c e d a f js u v s, pose_change c e d a f js -> convex (length js) u ->
  0 <= s -> 9 / 16 * (1 - (c - 2 * e)) <= s * s ->
  norm (dual_blend (nows js) u v - carried (olds js) u f) <= norm (v - f) + d + s * (a + INR (length js) * d).
Definition linear_stays_near : Prop := forall js u d (f v : vec R), convex (length js) u -> Forall are_units js ->
  Forall (fun j => moved_by j f <= d) js -> norm (carried (nows js) u v - carried (olds js) u f) <= norm (v - f) + d.
Definition spherical_stays_near : Prop := forall c e d a f js u v, pose_change c e d a f js -> convex (length js) u ->
  norm (skin_spherical (map rotation (nows js)) (map (fun t => apply_rigid t f) (nows js)) f u v - carried (olds js) u f)
    <= norm (v - f) + d.

(* (iv), of any numbers whose squares are at least the sharp shares, and what bounds need that were blown up by s before. *)
Definition sharp_share (c : R) : R := (1 - c) * (13 / 64 - 5 / 64 * c).
Definition share_grows_at_most : Prop := forall c e s t, c <= 1 -> 0 <= e -> 0 <= s -> 0 <= t ->
  sharp_share c <= s * s -> sharp_share (1 - 2 * e) <= t * t -> sharp_share (c - 2 * e) <= (s + t) * (s + t).
Definition dual_stays_in_grown_bound : Prop := forall c e d a f js u v s t s', pose_change c e d a f js -> convex (length js) u ->
  0 <= s -> 9 / 16 * (1 - c) <= s * s -> 0 <= t -> 9 / 16 * (1 - (1 - 2 * e)) <= t * t ->
  0 <= s' -> 9 / 16 * (1 - (c - 2 * e)) <= s' * s' ->
  norm (dual_blend (nows js) u v - carried (olds js) u f)
    <= norm (v - f) + s * a + (d + (t * a + s' * (INR (length js) * d))).

(* The share of b7_motion_bound is the sharp one down to 3/5 alone. So it grows by more where c passes that. *)
Definition share (c : R) : R := if Rle_dec (3 / 5) c then sharp_share c else 9 / 16 * (1 - c).
Definition share_grows_at_most_everywhere : Prop := forall c e s t, c <= 1 -> 0 <= e -> 0 <= s -> 0 <= t ->
  share c <= s * s -> share (1 - 2 * e) <= t * t -> share (c - 2 * e) <= (s + t) * (s + t).

(* What engines guess, which is so by linear blending alone: the old hull grown by d alone holds what was a vertex at f. *)
Definition hull_grown_by_d : Prop := forall c e d a f js u, pose_change c e d a f js -> convex (length js) u ->
  norm (dual_blend (nows js) u f - carried (olds js) u f) <= d.

(* --- Proofs: (i) --- *)

Lemma turn_in_dots (p q : quat R) (x : vec R) : norm2 p = 1 -> norm2 q = 1 ->
  norm2 (rotate q x - rotate p x) =
  norm2 (q - p) * (4 - norm2 (q - p)) * norm2 x - 4 * (dot (im (qmul (conj p) q)) x * dot (im (qmul (conj p) q)) x).
Proof.
  intros P Q. assert (Np := unit_not_zero p P). assert (Nq := unit_not_zero q Q).
  replace (norm2 (q - p)) with (2 - 2 * dot p q)
    by (replace (norm2 (q - p)) with (norm2 q - 2 * dot p q + norm2 p) by (dots; ring); rewrite P, Q; ring).
  replace (norm2 (rotate q x - rotate p x)) with (norm2 (rotate p x) - 2 * dot (rotate p x) (rotate q x) + norm2 (rotate q x))
    by (dots; ring).
  rewrite !rotate_norm2 by auto. unfold rotate. rewrite P, Q, Rinv_1, dot_scale_l, dot_scale_r, turned_dot, P, Q.
  unfold Rsqr. ring.
Qed.
Theorem rotation_reaches_holds : rotation_reaches.
Proof. intros p q x P Q O. rewrite (turn_in_dots p q x P Q), O. ring. Qed.
Theorem rotation_moves_at_most_holds : rotation_moves_at_most.
Proof.
  intros p q x e P Q E. apply norm_le in E as [E0 E]. pose proof (norm_nonneg x) as X. apply norm_le. split; [nra|].
  rewrite (turn_in_dots p q x P Q). replace (2 * e * norm x * (2 * e * norm x)) with (4 * (e * e) * (norm x * norm x)) by ring.
  rewrite norm_sq. pose proof (norm2_nonneg (q - p)%V) as N. pose proof (norm2_nonneg x) as X2.
  pose proof (Rle_0_sqr (dot (im (qmul (conj p) q)) x)) as S. unfold Rsqr in S.
  assert (norm2 (q - p) * (4 - norm2 (q - p)) <= 4 * (e * e)) by nra.
  assert (norm2 (q - p) * (4 - norm2 (q - p)) * norm2 x <= 4 * (e * e) * norm2 x) by (apply Rmult_le_compat_r; auto). lra.
Qed.
Theorem moves_at_most_holds : moves_at_most.
Proof.
  intros [c d] a f e [C D] E. unfold turned_by, moved_by in *. cbn [fst snd] in *.
  replace (apply_rigid d f - apply_rigid c f)%V with
    ((apply_rigid d a - apply_rigid c a) + (rotate (rotation d) (f - a) - rotate (rotation c) (f - a)))%V
    by (unfold apply_rigid; rewrite !rotate_sub; vec_ring).
  eapply Rle_trans; [apply norm_add|]. apply Rplus_le_compat_l. now apply rotation_moves_at_most_holds.
Qed.

(* --- Proofs: (ii) --- *)

Theorem hull_moves_at_most_holds : hull_moves_at_most.
Proof.
  intros u xys d W N.
  assert (Z : (comb u (map snd xys) - comb u (map fst xys))%V = comb u (map (fun p => snd p - fst p)%V xys)).
  { destruct W as (L & _). clear N. revert xys L. induction u as [|x u IH]; intros [|p xys] L; try discriminate; [cbn [map comb]; vec_ring|].
    cbn [map comb]. injection L as L. rewrite <- (IH xys L). vec_ring. }
  rewrite Z. assert (C : convex_set (in_ball (Ball (lzero : vec R) d))) by apply ball_convex.
  assert (O : forall x : vec R, norm (x - lzero) = norm x) by (intro x; f_equal; vec_ring).
  rewrite <- O. apply (convex_set_comb _ u _ C); [now rewrite map_length|]. apply Forall_map.
  eapply Forall_impl; [|exact N]. intros p P. unfold in_ball. cbn [center radius]. now rewrite O.
Qed.

(* n sum ||x_k||^2 - ||sum x_k||^2 *)
Lemma spread_of_sums (xs : list (vec R)) :
  spread xs = INR (length xs) * total norm2 xs - norm2 (total (fun x => x) xs).
Proof.
  unfold spread. induction xs as [|x xs IH]; [cbn [pairs total length]; rewrite norm2_zero; cbn; ring|].
  cbn [pairs total length]. rewrite total_app, IH, S_INR. clear IH.
  assert (M : total (fun p => norm2 (fst p - snd p)) (map (fun y => (x, y)) xs) =
    INR (length xs) * norm2 x - 2 * dot x (total (fun x => x) xs) + total norm2 xs).
  { induction xs as [|y ys IH]; cbn [map total length fst snd]; [rewrite dot_zero_r; cbn; ring|].
    rewrite IH, S_INR, dot_add_r. cbn [ladd lin_num add ops_R].
    replace (norm2 (x - y)) with (norm2 x - 2 * dot x y + norm2 y) by (dots; ring). ring. }
  rewrite M. replace (norm2 (x + total (fun x => x) xs)) with
    (norm2 x + 2 * dot x (total (fun x => x) xs) + norm2 (total (fun x => x) xs)) by (dots; ring).
  cbn [ladd lin_num add ops_R]. ring.
Qed.

(* The norm of stacked differences is a norm. *)
Lemma stacked_norms {X} (f g : X -> vec R) xs A B : 0 <= A -> 0 <= B ->
  total (fun x => norm2 (f x)) xs <= A * A -> total (fun x => norm2 (g x)) xs <= B * B ->
  total (fun x => norm2 (f x + g x)) xs <= (A + B) * (A + B).
Proof.
  intros A0 B0 F G.
  destruct (cauchy_of_total (fun x => dot (f x) (g x)) (fun x => norm2 (f x)) (fun x => norm2 (g x)) xs) as (F0 & G0 & C).
  - intros x. apply norm2_nonneg.
  - intros x. apply norm2_nonneg.
  - intros x _. pose proof (cauchy (f x) (g x)) as C. unfold norm2 at 1. exact C.
  - assert (E : total (fun x => norm2 (f x + g x)) xs =
      total (fun x => norm2 (f x)) xs + 2 * total (fun x => dot (f x) (g x)) xs + total (fun x => norm2 (g x)) xs).
    { clear. induction xs as [|x xs IH]; cbn [total]; [cbn; ring|]. rewrite IH. cbn [ladd lin_num add ops_R].
      replace (norm2 (f x + g x)) with (norm2 (f x) + 2 * dot (f x) (g x) + norm2 (g x)) by (dots; ring). ring. }
    rewrite E. revert F G F0 G0 C. generalize (total (fun x => norm2 (f x)) xs) (total (fun x => norm2 (g x)) xs).
    generalize (total (fun x => dot (f x) (g x)) xs). intros r p q F G F0 G0 C. unfold norm2 in C. cbn [dot euclid_R] in C.
    assert (r <= A * B); [|lra]. apply sq_le_inv; [now apply Rmult_le_pos|]. apply Rle_trans with (1 := C).
    replace (A * B * (A * B)) with (A * A * (B * B)) by ring. now apply Rmult_le_compat.
Qed.
Theorem spread_grows_at_most_holds : spread_grows_at_most.
Proof.
  intros xys d A N D A0 F. cbv zeta. set (n := INR (length xys)).
  assert (P : 0 <= n) by apply pos_INR. unfold spread in F |- *. rewrite pairs_map, total_map in F |- *. cbn [fst snd] in F |- *.
  set (way := fun p : vec R * vec R => (snd p - fst p)%V).
  assert (M : total (fun p => norm2 (way (fst p) - way (snd p))) (pairs xys) <= n * d * (n * d)).
  { pose proof (spread_of_sums (map way xys)) as S. unfold spread in S. rewrite pairs_map, total_map, map_length in S. cbn [fst snd] in S.
    rewrite S. pose proof (norm2_nonneg (total (fun x => x) (map way xys))) as T.
    assert (Q : total norm2 (map way xys) <= n * (d * d)).
    { unfold n. clear -N D. induction N as [|p xys Np N IH]; [cbn; lra|]. cbn [map total length]. rewrite S_INR.
      cbn [ladd lin_num add ops_R]. apply norm_le in Np as [_ Np]. unfold way at 1. lra. }
    fold n. nra. }
  pose proof (stacked_norms (fun p => fst (fst p) - fst (snd p))%V (fun p => way (fst p) - way (snd p))%V (pairs xys) A (n * d)
    A0 (Rmult_le_pos _ _ P D) F M) as G.
  eapply Rle_trans; [|exact G]. right. apply total_ext. intros p _. f_equal. unfold way. vec_ring.
Qed.

Lemma spread_of_opposed m h : let xs := repeat (Vec h 0 0) m ++ repeat (Vec (- h) 0 0) m in
  spread xs = INR (length xs) * h * (INR (length xs) * h).
Proof.
  cbv zeta. rewrite spread_of_sums, app_length, !repeat_length, !total_app.
  assert (Q : forall (v : vec R), total norm2 (repeat v m) = INR m * norm2 v).
  { intro v. induction m as [|k IH]; [cbn; ring|]. cbn [repeat total]. rewrite S_INR, IH. cbn [ladd lin_num add ops_R]. ring. }
  assert (T : forall (v : vec R), total (fun x => x) (repeat v m) = (INR m *: v)%V).
  { clear Q. intro v. induction m as [|k IH]; [cbn [repeat total INR]; vec_ring|]. cbn [repeat total]. rewrite S_INR, IH. vec_ring. }
  rewrite !Q, !T, plus_INR. generalize (INR m). intro k. vunfold. ring.
Qed.
Lemma map_of_repeat {X Y} (g : X -> Y) x m : map g (repeat x m) = repeat (g x) m.
Proof. induction m as [|m IH]; [reflexivity|]. cbn [repeat map]. now rewrite IH. Qed.
Theorem spread_reaches_holds : spread_reaches.
Proof.
  intros m h d H D xys n.
  assert (F : map fst xys = repeat (Vec h 0 0) m ++ repeat (Vec (- h) 0 0) m).
  { unfold xys, opposed. rewrite map_app, !map_of_repeat. reflexivity. }
  assert (G : map snd xys = repeat (Vec (h + d) 0 0) m ++ repeat (Vec (- (h + d)) 0 0) m).
  { unfold xys, opposed. rewrite map_app, !map_of_repeat. cbn [snd]. now replace (- (h + d)) with (- h - d) by ring. }
  split; [|split].
  - unfold are_near, xys, opposed. apply Forall_app.
    split; apply Forall_forall; intros p I; apply repeat_spec in I; subst p; cbn [fst snd];
      apply norm_le; (split; [auto|]); vunfold; nra.
  - rewrite F, spread_of_opposed, <- F, map_length. fold n. ring.
  - rewrite G, spread_of_opposed, <- G, map_length. fold n. ring.
Qed.

(* --- Proofs: (iii) --- *)

Theorem cosine_falls_at_most_holds : cosine_falls_at_most.
Proof.
  intros [a b] [c d] s t e [A B] [C D] S T E F. unfold turned_by in *. cbn [fst snd] in *.
  set (p := rotation a) in *. set (p' := rotation b) in *. set (q := rotation c) in *. set (q' := rotation d) in *.
  assert (X : dot p' q' - dot p q = dot (p' - p)%V q' + dot p (q' - q)%V) by (dots; ring).
  pose proof (dot_le_norms (p' - p)%V q'). pose proof (dot_ge_norms (p' - p)%V q').
  pose proof (dot_le_norms p (q' - q)%V). pose proof (dot_ge_norms p (q' - q)%V).
  rewrite (norm_unit q' D), (norm_unit p A) in *.
  destruct S as [-> | ->], T as [-> | ->]; lra.
Qed.

(* --- Proofs: the skinned vertex --- *)

Lemma spread_of_images (cs : list rigid) f : squared_spread cs f = spread (map (fun c => apply_rigid c f) cs).
Proof. unfold squared_spread, spread. rewrite pairs_map, total_map. reflexivity. Qed.
Definition both (f : vec R) (j : joint) := (apply_rigid (fst j) f, apply_rigid (snd j) f).
Lemma old_images f js : map fst (map (both f) js) = map (fun c => apply_rigid c f) (olds js).
Proof. unfold olds. now rewrite !map_map. Qed.
Lemma new_images f js : map snd (map (both f) js) = map (fun c => apply_rigid c f) (nows js).
Proof. unfold nows. now rewrite !map_map. Qed.
Lemma images_are_near d f js : Forall (fun j => moved_by j f <= d) js -> are_near d (map (both f) js).
Proof. intros M. unfold are_near. apply Forall_map. exact M. Qed.
Lemma carried_moves u d f js : convex (length js) u -> Forall (fun j => moved_by j f <= d) js ->
  norm (carried (nows js) u f - carried (olds js) u f) <= d.
Proof.
  intros W M. unfold carried. rewrite <- old_images, <- new_images.
  apply hull_moves_at_most_holds; [now rewrite map_length|now apply images_are_near].
Qed.

Theorem new_pose_is_within_holds : new_pose_is_within.
Proof.
  intros c e d a f js ((C0 & U & Cp) & Ce & E0 & D0 & Us & T & M & A0 & A). cbv zeta. split.
  - split; [exact Ce|]. split; [unfold nows; apply Forall_map; eapply Forall_impl; [|exact Us]; intros j J; apply J|].
    unfold nows, olds in *. rewrite pairs_map in *. apply Forall_map. apply Forall_forall. intros [j k] I. cbn [fst snd].
    rewrite Forall_map, Forall_forall in Cp. specialize (Cp _ I). cbn [fst snd] in Cp. apply in_pairs in I as [J K]. cbn [fst snd] in *.
    rewrite Forall_forall in Us, T. 
    pose proof (cosine_falls_at_most_holds j k 1 1 e (Us _ J) (Us _ K) (or_introl eq_refl) (or_introl eq_refl) (T _ J) (T _ K)). lra.
  - rewrite spread_of_images in *. rewrite <- old_images in A. rewrite <- new_images.
    pose proof (spread_grows_at_most_holds (map (both f) js) d a (images_are_near d f js M) D0 A0 A) as G.
    rewrite map_length in G. exact G.
Qed.

(* The blend of quaternions with dot products of 0 or more is not 0. *)
Lemma blend_is_not_zero c (cs : list rigid) u : are_within c cs -> convex (length cs) u -> comb u (map rotation cs) <> lzero.
Proof.
  intros (C0 & U & Cp) (L & P & S). apply norm2_pos_inv. rewrite comb_total, square_of_total. set (ts := combine u cs).
  assert (Ut : forall t, In t ts -> 0 <= fst t /\ norm2 (rotation (snd t)) = 1).
  { intros [w t] I. rewrite Forall_forall in U, P. split; [apply P; eapply in_combine_l, I|apply U; eapply in_combine_r, I]. }
  assert (Q : total (fun t => norm2 (fst t *: rotation (snd t))) ts = total (fun w => w * w) u).
  { transitivity (total (fun t : R * rigid => fst t * fst t) ts).
    - apply total_ext. intros t I. rewrite norm2_scale. destruct (Ut t I) as [_ ->]. ring.
    - rewrite <- (total_map (fun w : R => w * w) fst). unfold ts. now rewrite combine_fst. }
  assert (R : 0 <= total (fun p => dot (fst (fst p) *: rotation (snd (fst p))) (fst (snd p) *: rotation (snd (snd p)))) (pairs ts)).
  { assert (I : forall p, In p (pairs ts) -> 0 <= dot (fst (fst p) *: rotation (snd (fst p))) (fst (snd p) *: rotation (snd (snd p)))).
    { intros p I. rewrite dot_scale_l, dot_scale_r. rewrite Forall_forall in Cp.
      assert (D : c <= dot (rotation (snd (fst p))) (rotation (snd (snd p)))).
      { apply (Cp (snd (fst p), snd (snd p))). rewrite <- (combine_snd u cs L). rewrite pairs_map. apply in_map_iff. now exists p. }
      apply in_pairs in I as [I J]. destruct (Ut _ I) as [I0 _], (Ut _ J) as [J0 _].
      apply Rmult_le_pos; [auto|]. apply Rmult_le_pos; lra. }
    revert I. generalize (pairs ts). intros ps I. induction ps as [|p ps IH]; [cbn; lra|]. cbn [total ladd lin_num add ops_R].
    pose proof (I p (or_introl eq_refl)). assert (forall q, In q ps -> _) as J by (intros q K; exact (I q (or_intror K))).
    specialize (IH J). lra. }
  rewrite Q. assert (V : 0 < total (fun w => w * w) u); [|lra].
  assert (V0 : 0 <= total (fun w => w * w) u /\ (total (fun w => w * w) u <= 0 -> sum u = 0)).
  { clear. induction u as [|w u (IH0 & IH)]; [cbn; lra|]. cbn [total ladd lin_num add ops_R]. rewrite sum_cons.
    pose proof (Rle_0_sqr w) as Sq. unfold Rsqr in Sq. split; [lra|]. intros Z. rewrite IH by lra.
    assert (w * w = 0) as W by lra. apply Rmult_integral in W as [-> | ->]; ring. }
  destruct V0 as [V0 V1]. destruct (Rle_lt_dec (total (fun w => w * w) u) 0) as [Z|Z]; [|exact Z]. specialize (V1 Z). lra.
Qed.

Theorem dual_stays_near_holds : dual_stays_near.
Proof.
  intros c e d a f js u v s H W S0 S. pose proof (new_pose_is_within_holds c e d a f js H) as (Wi & Sp).
  destruct H as (_ & Ce & E0 & D0 & Us & _ & M & A0 & _). set (after := a + INR (length js) * d) in *.
  assert (W' : convex (length (nows js)) u) by (unfold nows; now rewrite map_length).
  destruct (vertex_by_steps_holds (nows js) u f v (blend_is_not_zero _ _ _ Wi W')) as (t & T & ->).
  pose proof (deviates_little_holds (nows js) (c - 2 * e) f u Wi W') as B.
  assert (P : 0 <= after) by (pose proof (pos_INR (length js)); unfold after; nra).
  assert (D : norm (dual_blend (nows js) u f - carried (nows js) u f) <= s * after).
  { apply norm_le. split; [now apply Rmult_le_pos|]. eapply Rle_trans; [exact B|].
    replace (s * after * (s * after)) with (s * s * (after * after)) by ring.
    assert (Q : 0 <= squared_spread (nows js) f).
    { unfold squared_spread. clear. induction (pairs (nows js)) as [|p l IH]; cbn [total ladd lin_num add ops_R]; [cbn; lra|].
      pose proof (norm2_nonneg (apply_rigid (fst p) f - apply_rigid (snd p) f)%V). lra. }
    apply Rle_trans with (s * s * squared_spread (nows js) f); [now apply Rmult_le_compat_r|].
    apply Rmult_le_compat_l; [nra|exact Sp]. }
  pose proof (carried_moves u d f js W M) as C.
  replace (carried (nows js) u f + t + (dual_blend (nows js) u f - carried (nows js) u f) - carried (olds js) u f)%V with
    (t + ((carried (nows js) u f - carried (olds js) u f) + (dual_blend (nows js) u f - carried (nows js) u f)))%V by vec_ring.
  eapply Rle_trans; [apply norm_add|]. rewrite T.
  pose proof (norm_add (carried (nows js) u f - carried (olds js) u f)%V (dual_blend (nows js) u f - carried (nows js) u f)%V). lra.
Qed.

Theorem share_grows_at_most_holds : share_grows_at_most.
Proof.
  unfold share_grows_at_most, sharp_share. intros c e s t C E S0 T0 S T.
  set (x := 1 - c) in *. set (y := 2 * e) in *. assert (X : 0 <= x) by (unfold x; lra). assert (Y : 0 <= y) by (unfold y; lra).
  replace c with (1 - x) in * by (unfold x; ring). replace (1 - (1 - x)) with x in * by ring.
  replace (1 - (1 - y)) with y in * by ring. replace (1 - (1 - x - y)) with (x + y) by ring. clearbody x y. clear C E c e.
  assert (Q : 5 / 64 * (x * y) <= s * t).
  { apply sq_le_inv; [now apply Rmult_le_pos|].
    replace (s * t * (s * t)) with ((s * s) * (t * t)) by ring.
    replace (5 / 64 * (x * y) * (5 / 64 * (x * y))) with ((5 / 64 * (x * x)) * (5 / 64 * (y * y))) by ring.
    apply Rmult_le_compat; nra. }
  nra.
Qed.
Theorem dual_stays_in_grown_bound_holds : dual_stays_in_grown_bound.
Proof.
  intros c e d a f js u v s t s' H W S0 S T0 T R0 R. pose proof H as (Cw & Ce & E0 & D0 & _ & _ & _ & A0 & _).
  pose proof (pos_INR (length js)) as N. set (nd := INR (length js) * d) in *. assert (P : 0 <= nd) by (unfold nd; nra).
  set (m := Rmin (s + t) s'). assert (M0 : 0 <= m) by (unfold m; apply Rmin_glb; lra).
  assert (M : 9 / 16 * (1 - (c - 2 * e)) <= m * m) by (unfold m, Rmin; destruct (Rle_dec (s + t) s'); nra).
  pose proof (dual_stays_near_holds c e d a f js u v m H W M0 M) as B. fold nd in B.
  assert (m <= s + t) by apply Rmin_l. assert (m <= s') by apply Rmin_r. nra.
Qed.
Theorem share_grows_at_most_everywhere_is_false : ~ share_grows_at_most_everywhere.
Proof.
  intros G. specialize (G (3 / 5) (1 / 20) (1 / 4) (1 / 8)). unfold share, sharp_share in G.
  destruct (Rle_dec (3 / 5) (3 / 5)) as [_|F]; [|lra]. destruct (Rle_dec (3 / 5) (1 - 2 * (1 / 20))) as [_|F]; [|lra].
  destruct (Rle_dec (3 / 5) (3 / 5 - 2 * (1 / 20))) as [F|_]; [lra|]. lra.
Qed.

Theorem linear_stays_near_holds : linear_stays_near.
Proof.
  intros js u d f v W Us M.
  assert (T : norm (carried (nows js) u v - carried (nows js) u f) <= norm (v - f)).
  { unfold carried, nows. rewrite !map_map.
    pose proof (hull_moves_at_most_holds u (map (fun j : joint => (apply_rigid (snd j) f, apply_rigid (snd j) v)) js) (norm (v - f))) as H.
    rewrite !map_map in H. apply H; [now rewrite map_length|]. unfold are_near. apply Forall_map.
    eapply Forall_impl; [|exact Us]. intros j [_ J]. cbn [fst snd]. right. rewrite <- (rotate_norm (rotation (snd j)) (v - f)%V).
    - f_equal. unfold apply_rigid. rewrite rotate_sub. vec_ring.
    - now apply unit_not_zero. }
  pose proof (carried_moves u d f js W M) as C.
  pose proof (norm_triangle (carried (nows js) u v) (carried (nows js) u f) (carried (olds js) u f)). lra.
Qed.

Theorem spherical_stays_near_holds : spherical_stays_near.
Proof.
  intros c e d a f js u v H W. pose proof (new_pose_is_within_holds c e d a f js H) as (Wi & _).
  destruct H as (_ & _ & _ & _ & _ & _ & M & _).
  assert (W' : convex (length (nows js)) u) by (unfold nows; now rewrite map_length).
  pose proof (carried_moves u d f js W M) as C. unfold skin_spherical. fold (carried (nows js) u f).
  replace (_ - _)%V with (rotate (comb u (map rotation (nows js))) (v - f) + (carried (nows js) u f - carried (olds js) u f))%V by vec_ring.
  eapply Rle_trans; [apply norm_add|]. rewrite rotate_norm by exact (blend_is_not_zero _ _ _ Wi W'). lra.
Qed.

(* Two joints carry y to (0, 0, 12/13) and (0, 0, -12/13), before and after they turn by the quaternions of the cosine 12/13. *)
Definition upper := Vec 0 0 (12 / 13).
Definition lower := Vec 0 0 (- 12 / 13).
Definition at_rest (x : vec R) := Rigid (Quat 1 0 0 0) (x - Vec 0 1 0)%V.
Definition upper_turned := Rigid (Quat (12 / 13) (5 / 13) 0 0) (upper - Vec 0 (119 / 169) (120 / 169))%V.
Definition lower_turned := Rigid (Quat (12 / 13) (- 5 / 13) 0 0) (lower - Vec 0 (119 / 169) (- 120 / 169))%V.
Theorem hull_grown_by_d_is_false : ~ hull_grown_by_d.
Proof.
  intros G. set (f := Vec 0 1 0). set (js := [(at_rest upper, upper_turned); (at_rest lower, lower_turned)]).
  assert (two : forall (P : joint -> Prop) j k, P j -> P k -> Forall P [j; k]) by (intros; repeat apply Forall_cons; auto; constructor).
  assert (I1 : apply_rigid (at_rest upper) f = upper) by (unfold apply_rigid, at_rest, rotate, upper, f; cbn [rotation translation]; vfield).
  assert (I2 : apply_rigid (at_rest lower) f = lower) by (unfold apply_rigid, at_rest, rotate, lower, f; cbn [rotation translation]; vfield).
  assert (I3 : apply_rigid upper_turned f = upper) by (unfold apply_rigid, upper_turned, rotate, upper, f; cbn [rotation translation]; vfield).
  assert (I4 : apply_rigid lower_turned f = lower) by (unfold apply_rigid, lower_turned, rotate, lower, f; cbn [rotation translation]; vfield).
  assert (H : pose_change 1 (2 / 5) 0 (24 / 13) f js).
  { unfold pose_change, js, olds, are_units, turned_by, moved_by. cbn [map fst snd].
    split; [|split; [lra|split; [lra|split; [lra|split; [|split; [|split; [|split; [lra|]]]]]]]].
    - split; [lra|]. split; repeat apply Forall_cons; try apply Forall_nil; cbn [map fst snd rotation at_rest]; vunfold; lra.
    - apply two; cbn [fst snd rotation at_rest upper_turned lower_turned]; split; vunfold; lra.
    - apply two; cbn [fst snd rotation at_rest upper_turned lower_turned]; apply norm_le; vunfold; lra.
    - apply two; cbn [fst snd]; rewrite ?I1, ?I2, ?I3, ?I4; apply norm_le; unfold upper, lower; vunfold; lra.
    - unfold squared_spread. cbn [map pairs app total fst snd]. rewrite I1, I2. unfold upper, lower. vunfold. lra. }
  specialize (G _ _ _ _ f js [1 / 2; 1 / 2] H). assert (W : convex (length js) [1 / 2; 1 / 2]).
  { repeat split; [repeat constructor; lra|cbn; lra]. }
  specialize (G W). apply norm_le in G as [_ G]. revert G.
  unfold carried, js, olds, nows. cbn [map fst snd comb]. rewrite I1, I2.
  unfold dual_blend, skin_dual, dual_of, upper_turned, lower_turned, upper, lower, f. cbn [map comb rotation translation].
  vunfold. intros G. field_simplify in G. lra.
Qed.

(* The hypotheses can be met: two joints at rest, of which the first turns by sqrt(2/13) and leaves the point where it is. *)
Example change_instance : let o := Vec 0 0 0 in let still := Rigid (Quat 1 0 0 0) o in
  let js := [(still, Rigid (Quat (12 / 13) (5 / 13) 0 0) o); (still, still)] in
  pose_change 1 (2 / 5) 0 0 o js /\ convex (length js) [1 / 2; 1 / 2] /\ 0 <= 3 / 4 /\ 9 / 16 * (1 - (1 - 2 * (2 / 5))) <= 3 / 4 * (3 / 4) /\
  9 / 16 * (1 - 1) <= 0 * 0.
Proof.
  assert (I : forall q : quat R, apply_rigid (Rigid q (Vec 0 0 0)) (Vec 0 0 0) = Vec 0 0 0).
  { intro q. unfold apply_rigid, rotate. cbn [rotation translation]. generalize (/ norm2 q). vring. }
  cbv zeta. split; [|split; [repeat split; [repeat constructor; lra|cbn; lra]|lra]]. unfold pose_change, olds, are_units, turned_by, moved_by.
  assert (two : forall (P : joint -> Prop) j k, P j -> P k -> Forall P [j; k]) by (intros; repeat apply Forall_cons; auto; constructor).
  split; [|split; [lra|split; [lra|split; [lra|split; [|split; [|split; [|split; [lra|]]]]]]]].
  - split; [lra|]. split; repeat apply Forall_cons; try apply Forall_nil; cbn [map fst snd rotation]; vunfold; lra.
  - apply two; cbn [fst snd rotation]; split; vunfold; lra.
  - apply two; cbn [fst snd rotation]; apply norm_le; vunfold; lra.
  - apply two; cbn [fst snd]; rewrite !I; apply norm_le; vunfold; lra.
  - unfold squared_spread. cbn [map pairs app total fst snd]. rewrite !I. vunfold. lra.
Qed.
Example share_instance : 4 / 5 <= 1 /\ 0 <= 1 / 10 /\ sharp_share (4 / 5) <= 1 / 4 * (1 / 4) /\
  sharp_share (1 - 2 * (1 / 10)) <= 1 / 4 * (1 / 4).
Proof. unfold sharp_share. lra. Qed.
Example turn_instance : let p := Quat 1 0 0 0 in let q := Quat (12 / 13) (5 / 13) 0 0 in
  norm2 p = 1 /\ norm2 q = 1 /\ norm (q - p) <= 2 / 5 /\ dot (im (qmul (conj p) q)) (Vec 0 1 0) = 0.
Proof. cbv zeta. repeat split; try (vunfold; lra). apply norm_le. vunfold. lra. Qed.
Example near_instance : let xys := opposed 1 1 1 in convex (length xys) [1 / 2; 1 / 2] /\ are_near 1 xys /\ 0 <= 1 /\ 0 <= 2 /\
  spread (map fst xys) <= 2 * 2.
Proof.
  cbv zeta. assert (H : 0 <= 1) by lra. destruct (spread_reaches_holds 1%nat 1 1 H H) as (N & S & _).
  split; [repeat split; [repeat constructor; lra|cbn; lra]|]. split; [exact N|]. split; [lra|]. split; [lra|]. rewrite S. cbn. lra.
Qed.
