(* SPDX-License-Identifier: MIT *)
(* Beyond the paper: how far a vertex can be, from the transforms of its joints alone. *)
From Coq Require Import List Reals Lra Psatz Lia.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.refit_dual_quaternion.
Import ListNotations.

(* --- Statements: rigid transforms C_k with unit quaternions q_k --- *)

(* All pairs of a list, each once, and the sum of vectors. *)
Fixpoint pairs {X} (xs : list X) : list (X * X) :=
  match xs with [] => [] | x :: ys => map (fun y => (x, y)) ys ++ pairs ys end.
Fixpoint total {X E} {l : Lin R E} (f : X -> E) (xs : list X) : E :=
  match xs with [] => lzero | x :: ys => (f x + total f ys)%V end.

(* L = sum u_k C_k f, B the dual quaternion blend, A(f)^2 = sum_{k<l} ||C_k f - C_l f||^2. *)
Definition carried (cs : list rigid) (u : list R) (f : vec R) := comb u (map (fun c => apply_rigid c f) cs).
Definition dual_blend (cs : list rigid) (u : list R) (f : vec R) := skin_dual (map rotation cs) (map dual_of cs) u f.
Definition squared_spread (cs : list rigid) (f : vec R) : R :=
  total (fun p => norm2 (apply_rigid (fst p) f - apply_rigid (snd p) f)) (pairs cs).
Definition are_within (c : R) (cs : list rigid) :=
  0 <= c /\ Forall (fun t => norm2 (rotation t) = 1) cs /\
  Forall (fun p => c <= dot (rotation (fst p)) (rotation (snd p))) (pairs cs).

(* The first bound: ||B - L||^2 <= 9/16 (1 - c) A(f)^2. *)
Definition deviates_little : Prop :=
  forall (cs : list rigid) (c : R) (f : vec R) (u : list R), are_within c cs -> convex (length cs) u ->
  norm2 (dual_blend cs u f - carried cs u f) <= 9 / 16 * (1 - c) * squared_spread cs f.
(* The identity of its proof: with X_kl = C_k f - C_l f, g_k = (q_k, q) and m_kl = Im(q_k q_l* ),
   ||q||^2 (B - L) = sum_{k<l} u_k u_l ((g_k - g_l) X_kl + X_kl x m_kl), where ||m_kl||^2 = 1 - (q_k, q_l)^2 and the two
   vectors of a pair are perpendicular. *)
Definition pair_vector (f : vec R) (q : quat R) (s t : rigid) : vec R :=
  let X := (apply_rigid s f - apply_rigid t f)%V in
  ((dot (rotation s) q - dot (rotation t) q) *: X + cross X (im (qmul (rotation s) (conj (rotation t)))))%V.
Definition deviates_by_pairs : Prop :=
  forall (cs : list rigid) (f : vec R) (u : list R),
  Forall (fun t => norm2 (rotation t) = 1) cs -> convex (length cs) u -> let q := comb u (map rotation cs) in q <> lzero ->
  (norm2 q *: (dual_blend cs u f - carried cs u f))%V =
  total (fun p => (fst (fst p) * fst (snd p)) *: pair_vector f q (snd (fst p)) (snd (snd p)))%V (pairs (combine u cs)).
Definition pair_is_perpendicular : Prop :=
  forall (p q : quat R) (X : vec R) (g : R), norm2 p = 1 -> norm2 q = 1 ->
  norm2 (im (qmul p (conj q))) = 1 - dot p q * dot p q /\ dot (g *: X) (cross X (im (qmul p (conj q)))) = 0.
(* v' = L + (a vector of length ||v - f||) + (B - L), for dual quaternions. *)
Definition vertex_by_steps : Prop :=
  forall (cs : list rigid) (u : list R) (f v : vec R), comb u (map rotation cs) <> lzero ->
  exists turned, norm turned = norm (v - f) /\
  dual_blend cs u v = (carried cs u f + turned + (dual_blend cs u f - carried cs u f))%V.
(* Of weights with products u_k u_l whose sum is at most P and whose squares' sum is at most Q:
   ||B - L||^2 <= 2 (1 - c) Q / (1 - 2 (1 - c) P)^2 A(f)^2. *)
Definition products (u : list R) : R := total (fun p => fst p * snd p) (pairs u).
Definition squared_products (u : list R) : R := total (fun p => (fst p * snd p) * (fst p * snd p)) (pairs u).
Definition deviates_by_products : Prop :=
  forall (cs : list rigid) (c : R) (f : vec R) (u : list R) (P Q : R), are_within c cs -> convex (length cs) u ->
  products u <= P -> squared_products u <= Q -> 2 * (1 - c) * P < 1 ->
  norm2 (dual_blend cs u f - carried cs u f) * ((1 - 2 * (1 - c) * P) * (1 - 2 * (1 - c) * P)) <=
  2 * (1 - c) * Q * squared_spread cs f.
(* Weights u_k >= m_k carry a point into the hull of sum_l m_l x_l + (1 - sum m) x_k: with weights t, u_k = m_k + (1 - sum m) t_k. *)
Definition carried_by_least : Prop :=
  forall (xs : list (vec R)) (m t : list R), length m = length xs -> convex (length xs) t ->
  let rest := 1 - sum m in
  comb (map (fun p => fst p + rest * snd p) (combine m t)) xs = comb t (map (fun x => comb m xs + rest *: x)%V xs).
(* ||R_k x - R_l x|| <= 2 sqrt(1 - (q_k, q_l)^2) ||x|| *)
Definition turns_little : Prop :=
  forall (p q : quat R) (x : vec R), norm2 p = 1 -> norm2 q = 1 ->
  norm2 (rotate p x - rotate q x) <= 4 * (1 - dot p q * dot p q) * norm2 x.

(* --- Proofs: sums over pairs --- *)

Lemma total_app {X E} `{Euclid E} (f : X -> E) xs ys : total f (xs ++ ys) = (total f xs + total f ys)%V.
Proof. induction xs as [|x xs IH]; cbn [app total]; [vec_ring|]. rewrite IH. vec_ring. Qed.

Section Sums.
Context {X E : Type} `{Euclid E}.
Implicit Types (f : X -> E).

Lemma dot_total f xs y : dot (total f xs) y = total (fun x => dot (f x) y) xs.
Proof. induction xs as [|x xs IH]; cbn [total]; [apply dot_zero_l|]. now rewrite dot_add_l, IH. Qed.

(* ||sum f||^2 = sum ||f||^2 + 2 sum over pairs (f_k, f_l) *)
Lemma square_of_total f xs :
  norm2 (total f xs) = total (fun x => norm2 (f x)) xs + 2 * total (fun p => dot (f (fst p)) (f (snd p))) (pairs xs).
Proof.
  induction xs as [|x xs IH]; cbn [total pairs]; [unfold norm2; rewrite dot_zero_l; vunfold; ring|].
  rewrite total_app.
  assert (M : total (fun p => dot (f (fst p)) (f (snd p))) (map (fun y => (x, y)) xs) = dot (f x) (total f xs)).
  { clear IH. induction xs as [|y ys IH]; cbn [map total fst snd]; [now rewrite dot_zero_r|].
    rewrite IH, dot_add_r. reflexivity. }
  rewrite M. replace (norm2 (f x + total f xs)) with (norm2 (f x) + 2 * dot (f x) (total f xs) + norm2 (total f xs)) by (dots; ring).
  rewrite IH. cbn [ladd lin_num add ops_R]. ring.
Qed.

(* Cauchy and Schwarz: ||sum f||^2 <= (sum A) (sum B) if all ||f||^2 <= A B. *)
Lemma cauchy_of_total f (A B : X -> R) xs : (forall x, 0 <= A x) -> (forall x, 0 <= B x) ->
  (forall x, In x xs -> norm2 (f x) <= A x * B x) ->
  0 <= total A xs /\ 0 <= total B xs /\ norm2 (total f xs) <= total A xs * total B xs.
Proof.
  intros A0 B0. induction xs as [|x xs IH]; intros F; cbn [total].
  - unfold norm2. rewrite dot_zero_l. cbn. lra.
  - destruct IH as (A1 & B1 & N); [intros y Y; apply F; now right|]. specialize (F x (or_introl eq_refl)).
    specialize (A0 x). specialize (B0 x). cbn [ladd lin_num add ops_R]. split; [lra|]. split; [lra|].
    replace (norm2 (f x + total f xs)) with (norm2 (f x) + 2 * dot (f x) (total f xs) + norm2 (total f xs)) by (dots; ring).
    assert (D : 2 * dot (f x) (total f xs) <= A x * total B xs + total A xs * B x).
    { apply sq_le_inv; [nra|]. pose proof (cauchy (f x) (total f xs)) as C. pose proof (norm2_nonneg (f x)).
      pose proof (norm2_nonneg (total f xs)).
      assert (norm2 (f x) * norm2 (total f xs) <= A x * B x * (total A xs * total B xs)) by (apply Rmult_le_compat; auto).
      replace (2 * dot (f x) (total f xs) * (2 * dot (f x) (total f xs))) with (4 * (dot (f x) (total f xs) * dot (f x) (total f xs))) by ring.
      pose proof (Rle_0_sqr (A x * total B xs - total A xs * B x)) as Sq. unfold Rsqr in Sq. nra. }
    nra.
Qed.
End Sums.

Lemma total_le {X} (f g : X -> R) xs : (forall x, In x xs -> f x <= g x) -> total f xs <= total g xs.
Proof.
  induction xs as [|x xs IH]; intros F; cbn [total]; [lra|]. cbn [ladd lin_num add ops_R].
  specialize (IH (fun y Y => F y (or_intror Y))). specialize (F x (or_introl eq_refl)). lra.
Qed.
Lemma total_scale {X} (f : X -> R) a xs : total (fun x => a * f x) xs = a * total f xs.
Proof. induction xs as [|x xs IH]; cbn [total]; [cbn; ring|]. rewrite IH. cbn [ladd lin_num add ops_R]. ring. Qed.
Lemma total_ext {X E} {l : Lin R E} (f g : X -> E) xs : (forall x, In x xs -> f x = g x) -> total f xs = total g xs.
Proof.
  induction xs as [|x xs IH]; intros F; cbn [total]; [reflexivity|]. rewrite IH, (F x); auto; [now left|].
  intros y Y. apply F. now right.
Qed.
Lemma pairs_map {X Y} (g : X -> Y) xs : pairs (map g xs) = map (fun p => (g (fst p), g (snd p))) (pairs xs).
Proof. induction xs as [|x xs IH]; cbn [pairs map]; [reflexivity|]. now rewrite map_app, !map_map, IH. Qed.
Lemma total_map {X Y E} {l : Lin R E} (f : Y -> E) (g : X -> Y) xs : total f (map g xs) = total (fun x => f (g x)) xs.
Proof. induction xs as [|x xs IH]; cbn [total map]; [reflexivity|]. now rewrite IH. Qed.
Lemma in_pairs {X} (xs : list X) p : In p (pairs xs) -> In (fst p) xs /\ In (snd p) xs.
Proof.
  induction xs as [|x xs IH]; [intros []|]. cbn [pairs]. intros I. apply in_app_or in I as [I|I].
  - apply in_map_iff in I as (y & <- & I). split; [now left|now right].
  - destruct (IH I). split; now right.
Qed.

(* Weighted transforms. *)
Lemma comb_total {X E} `{Euclid E} (g : X -> E) u xs :
  comb u (map g xs) = total (fun t => fst t *: g (snd t))%V (combine u xs).
Proof.
  revert xs; induction u as [|a u IH]; intros [|x xs]; cbn [map comb combine total fst snd]; try reflexivity. now rewrite IH.
Qed.
Lemma combine_snd {X} (u : list R) (xs : list X) : length u = length xs -> map snd (combine u xs) = xs.
Proof.
  revert xs; induction u as [|a u IH]; intros [|x xs] L; try discriminate; cbn; [reflexivity|]. rewrite IH; auto.
Qed.
Lemma combine_fst {X} (u : list R) (xs : list X) : length u = length xs -> map fst (combine u xs) = u.
Proof.
  revert xs; induction u as [|a u IH]; intros [|x xs] L; try discriminate; cbn; [reflexivity|]. rewrite IH; auto.
Qed.

(* --- The identity --- *)

(* Im(x_k q_k q_l* ) of both orders. *)
Lemma both_orders (x y : vec R) (p q : quat R) :
  (im (qmul (qmul (pure x) p) (conj q)) + im (qmul (qmul (pure y) q) (conj p)))%V =
  (dot p q *: x + dot p q *: y + cross (x - y) (im (qmul p (conj q))))%V.
Proof. vring. Qed.
Lemma same_order (x : vec R) (p : quat R) : im (qmul (qmul (pure x) p) (conj p)) = (norm2 p *: x)%V.
Proof. vring. Qed.

Lemma im_product_add_l (a b c : quat R) : im (qmul (a + b)%V (conj c)) = (im (qmul a (conj c)) + im (qmul b (conj c)))%V.
Proof. vring. Qed.
Lemma im_product_add_r (a b c : quat R) : im (qmul a (conj (b + c)%V)) = (im (qmul a (conj b)) + im (qmul a (conj c)))%V.
Proof. vring. Qed.
Lemma im_product_scale (a b : quat R) s t : im (qmul (s *: a)%V (conj (t *: b)%V)) = (s * t *: im (qmul a (conj b)))%V.
Proof. vring. Qed.
Lemma im_product_zero_l (a : quat R) : im (qmul lzero (conj a)) = lzero.
Proof. vring. Qed.
Lemma im_product_zero_r (a : quat R) : im (qmul a (conj lzero)) = lzero.
Proof. vring. Qed.

Section Identity.
Variable f : vec R.
Implicit Types (ts : list (R * rigid)).
Definition weight (t : R * rigid) := fst t.
Definition image (t : R * rigid) := apply_rigid (snd t) f.
Definition turn (t : R * rigid) := rotation (snd t).

(* S sum u g x - (sum u g) (sum u x) = sum over pairs u_k u_l (g_k - g_l) (x_k - x_l), for any g. *)
Lemma covariance_by_pairs (g : R * rigid -> R) ts :
  (total weight ts *: total (fun t => (weight t * g t) *: image t) ts -
   total (fun t => weight t * g t) ts *: total (fun t => weight t *: image t) ts)%V =
  total (fun p => (weight (fst p) * weight (snd p) * (g (fst p) - g (snd p))) *: (image (fst p) - image (snd p)))%V (pairs ts).
Proof.
  induction ts as [|t ts IH]; cbn [total pairs]; [cbn [lzero lin_num zero ops_R]; vec_ring|].
  rewrite total_app, <- IH. clear IH.
  assert (M : total (fun p => (weight (fst p) * weight (snd p) * (g (fst p) - g (snd p))) *: (image (fst p) - image (snd p)))%V
      (map (fun s => (t, s)) ts) =
    (weight t *: (g t * total weight ts *: image t - g t *: total (fun t => weight t *: image t) ts
      - total (fun t => weight t * g t) ts *: image t + total (fun t => (weight t * g t) *: image t) ts))%V).
  { induction ts as [|s ts IH]; cbn [map total fst snd]; [cbn [lzero lin_num zero ops_R]; vec_ring|].
    rewrite IH. cbn [ladd lin_num add ops_R]. vec_ring. }
  rewrite M. cbn [ladd lin_num add ops_R]. vec_ring.
Qed.

Definition moved (t : R * rigid) : quat R := qmul (pure (image t)) (turn t).
Definition blended ts := total (fun t => weight t *: turn t)%V ts.
Lemma total_dot_add ts (a b : quat R) :
  total (fun s => (weight s * dot (turn s) (a + b)) *: image s)%V ts =
  (total (fun s => (weight s * dot (turn s) a) *: image s) ts + total (fun s => (weight s * dot (turn s) b) *: image s) ts)%V.
Proof. induction ts as [|s ts IH]; cbn [total]; [vec_ring|]. rewrite IH, dot_add_r. vec_ring. Qed.
(* Im((sum u x q) q* ) = sum u_k (q_k, q) x_k + sum over pairs u_k u_l X_kl x m_kl *)
Lemma blend_by_pairs ts :
  im (qmul (total (fun t => weight t *: moved t)%V ts) (conj (blended ts))) =
  (total (fun t => (weight t * dot (turn t) (blended ts)) *: image t) ts +
   total (fun p => (weight (fst p) * weight (snd p)) *:
     cross (image (fst p) - image (snd p)) (im (qmul (turn (fst p)) (conj (turn (snd p)))))) (pairs ts))%V.
Proof.
  unfold blended. induction ts as [|t ts IH]; cbn [total pairs]; [rewrite im_product_zero_l; vec_ring|].
  rewrite !im_product_add_l, !im_product_add_r, IH, total_app, !im_product_scale. clear IH.
  set (Q := total (fun t => weight t *: turn t)%V ts).
  assert (M : (im (qmul (weight t *: moved t)%V (conj Q)) + im (qmul (total (fun t => weight t *: moved t)%V ts) (conj (weight t *: turn t)%V)))%V =
    ((weight t * dot (turn t) Q) *: image t + total (fun s => (weight s * dot (turn s) (weight t *: turn t)) *: image s) ts +
     total (fun p => (weight (fst p) * weight (snd p)) *:
       cross (image (fst p) - image (snd p)) (im (qmul (turn (fst p)) (conj (turn (snd p))))))
       (map (fun s => (t, s)) ts))%V).
  { unfold Q. clear Q. induction ts as [|s ts IH]; cbn [total map fst snd].
    - rewrite im_product_zero_l, im_product_zero_r, dot_zero_r. vec_ring.
    - rewrite im_product_add_l, im_product_add_r, !im_product_scale. 
      set (b1 := im (qmul (weight t *: moved t)%V (conj (total (fun t => weight t *: turn t)%V ts)))) in *.
      set (b2 := im (qmul (total (fun t => weight t *: moved t)%V ts) (conj (weight t *: turn t)%V))) in *.
      pose proof (both_orders (image t) (image s) (turn t) (turn s)) as O.
      fold (moved t) (moved s) in O. rewrite dot_add_r, !dot_scale_r.
      apply dot_ext. intros z. apply (f_equal (fun y => dot y z)) in IH, O. cbv beta in IH, O. autorewrite with dots in IH, O |- *.
      rewrite (dot_comm (turn s) (turn t)).
      replace (weight t * weight s * dot (im (qmul (moved t) (conj (turn s)))) z + dot b1 z +
        (weight s * weight t * dot (im (qmul (moved s) (conj (turn t)))) z + dot b2 z)) with
        (weight t * weight s * (dot (im (qmul (moved t) (conj (turn s)))) z + dot (im (qmul (moved s) (conj (turn t)))) z)
         + (dot b1 z + dot b2 z)) by ring.
      rewrite O, IH. ring. }
  assert (S : im (qmul (moved t) (conj (turn t))) = (norm2 (turn t) *: image t)%V) by apply same_order.
  rewrite S.
  rewrite (total_dot_add ts (weight t *: turn t)%V Q). apply dot_ext. intros z. apply (f_equal (fun y => dot y z)) in M. cbv beta in M.
  unfold norm2. autorewrite with dots in M |- *.
  apply Rminus_diag_uniq. apply Rminus_diag_eq in M. rewrite <- M. ring.
Qed.
End Identity.

(* D B = Im((sum u_k x_k q_k) q* ) for units, since x_k q_k = q_k f + 2 d_k (unit_moves). *)
Lemma scaled_dual_blend cs u f : length u = length cs -> Forall (fun t => norm2 (rotation t) = 1) cs ->
  let q := comb u (map rotation cs) in q <> lzero ->
  (norm2 q *: dual_blend cs u f)%V =
  im (qmul (total (fun t => weight t *: moved f t)%V (combine u cs)) (conj q)).
Proof.
  intros L U q N. apply norm2_pos in N. unfold dual_blend, skin_dual. cbv zeta. fold q.
  assert (E : total (fun t => weight t *: moved f t)%V (combine u cs) = (qmul q (pure f) + 2 *: comb u (map dual_of cs))%V).
  { unfold q. clear N q. revert u L. induction U as [|t cs Ut U IH]; intros [|a u] L; try discriminate; cbn [combine total map comb].
    - vring.
    - rewrite IH by auto. unfold moved, image, turn, weight. cbn [fst snd]. rewrite <- unit_moves by exact Ut.
      generalize (comb u (map rotation cs)) (comb u (map dual_of cs)) (rotation t) (dual_of t). vring. }
  rewrite E. replace (im (qmul (qmul q (pure f) + 2 *: comb u (map dual_of cs)) (conj q)))%V with
    (turned q f q + 2 *: im (qmul (comb u (map dual_of cs)) (conj q)))%V by (generalize q (comb u (map dual_of cs)); vring).
  revert N. generalize (norm2 q) (turned q f q + 2 *: im (qmul (comb u (map dual_of cs)) (conj q)))%V. intros n x N. vec_field. lra.
Qed.

Theorem deviates_by_pairs_holds : deviates_by_pairs.
Proof.
  intros cs f u U (L & P & S) q N. set (ts := combine u cs).
  assert (Q : blended ts = q) by (unfold blended, q; rewrite comb_total; reflexivity).
  assert (C : carried cs u f = total (fun t => weight t *: image f t)%V ts) by (unfold carried; rewrite comb_total; reflexivity).
  assert (One : total weight ts = 1).
  { rewrite <- S. unfold ts. clear -L. revert cs L; induction u as [|a u IH]; intros [|c cs] L; try discriminate; [reflexivity|].
    cbn [combine total weight fst]. rewrite sum_cons, IH by auto. reflexivity. }
  set (g := fun t : R * rigid => dot (turn t) q).
  assert (G : total (fun t => weight t * g t) ts = norm2 q).
  { transitivity (dot (blended ts) q); [|now rewrite Q]. unfold blended. rewrite dot_total. apply total_ext. intros t _.
    unfold g. now rewrite dot_scale_l. }
  pose proof (scaled_dual_blend cs u f L U N) as B. fold q ts in B. rewrite <- Q in B at 2. rewrite blend_by_pairs, Q in B.
  pose proof (covariance_by_pairs f g ts) as V. rewrite One, G, <- C in V. fold g in B.
  replace (norm2 q *: (dual_blend cs u f - carried cs u f))%V with (norm2 q *: dual_blend cs u f - norm2 q *: carried cs u f)%V by vec_ring.
  rewrite B. replace (total (fun t => (weight t * dot (turn t) q) *: image f t)%V ts) with
    (1 *: total (fun t => (weight t * g t) *: image f t) ts)%V by (unfold g; vec_ring).
  match goal with |- (?a + ?b - ?c)%V = _ => replace (a + b - c)%V with ((a - c) + b)%V by vec_ring end.
  rewrite V. clear. generalize (pairs ts). intros ps. induction ps as [|p ps IH]; cbn [total]; [vec_ring|].
  rewrite <- IH. unfold pair_vector, g, image, turn, weight. vec_ring.
Qed.

Theorem pair_is_perpendicular_holds : pair_is_perpendicular.
Proof.
  intros p q X g P Q. split; [|vring].
  replace (norm2 (im (qmul p (conj q)))) with (norm2 p * norm2 q - dot p q * dot p q) by vring. rewrite P, Q. ring.
Qed.

Theorem vertex_by_steps_holds : vertex_by_steps.
Proof.
  intros cs u f v N. exists (rotate (comb u (map rotation cs)) (v - f)). split; [now apply rotate_norm|].
  unfold dual_blend. rewrite (Refitlab.b2_control_hull_encloses.skin_dual_moves _ _ u f v). vec_ring.
Qed.

Theorem turns_little_holds : turns_little.
Proof.
  intros p q x P Q. assert (Np := unit_not_zero p P). assert (Nq := unit_not_zero q Q).
  replace (norm2 (rotate p x - rotate q x)) with (norm2 (rotate p x) - 2 * dot (rotate p x) (rotate q x) + norm2 (rotate q x))
    by (dots; ring).
  rewrite !rotate_norm2 by auto. unfold rotate. rewrite P, Q, Rinv_1, dot_scale_l, dot_scale_r, turned_dot, P, Q.
  pose proof (Rle_0_sqr (dot (im (qmul (conj p) q)) x)). lra.
Qed.

(* --- The first bound --- *)

Lemma cross_norm2 (x m : vec R) : norm2 (cross x m) <= norm2 x * norm2 m.
Proof.
  replace (norm2 (cross x m)) with (norm2 x * norm2 m - dot x m * dot x m) by vring.
  pose proof (Rle_0_sqr (dot x m)) as S. unfold Rsqr in S. lra.
Qed.

(* With x = sum u^2 and D >= x + c (1 - x): x^2 (1 - x) (1 + c + 2 D) / (2 D^2) <= 9/16. *)
Lemma nine_sixteenths (x c D : R) : 0 <= x <= 1 -> 0 <= c -> x + c * (1 - x) <= D ->
  8 * (x * x * (1 - x)) * (1 + c + 2 * D) <= 9 * (D * D).
Proof.
  intros X C Dl. set (d := x + c * (1 - x)) in *. assert (X0 : 0 <= 1 - x) by lra.
  assert (D0 : 0 <= c * (1 - x)) by (apply Rmult_le_pos; lra).
  assert (A : 0 <= 9 * (d * d) - 8 * (x * x * (1 - x)) * (1 + c + 2 * d)).
  { replace (9 * (d * d) - 8 * (x * x * (1 - x)) * (1 + c + 2 * d)) with
      (x * x * ((1 - 4 * x) * (1 - 4 * x)) + 2 * (x * (c * (1 - x))) * (9 - 12 * x + 8 * (x * x)) + 9 * (c * (1 - x) * (c * (1 - x))))
      by (unfold d; ring).
    assert (0 <= x * x * ((1 - 4 * x) * (1 - 4 * x))) by (apply Rmult_le_pos; apply Rle_0_sqr).
    assert (0 <= x * (c * (1 - x)) * (9 - 12 * x + 8 * (x * x))) 
      by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|]; pose proof (Rle_0_sqr (x - 3 / 4)) as Sq; unfold Rsqr in Sq; lra).
    assert (0 <= c * (1 - x) * (c * (1 - x))) by apply Rle_0_sqr. lra. }
  assert (M : x * x * (1 - x) <= x) by nra. assert (x <= d) by (unfold d; lra).
  assert (0 <= (D - d) * (9 * (D + d) - 16 * (x * x * (1 - x)))) by (apply Rmult_le_pos; lra). nra.
Qed.

(* sum u^4 >= (sum u^2)^3 for convex u, by the tangent of the cube. *)
Lemma fourth_powers u : Forall (Rle 0) u -> sum u = 1 ->
  let x := total (fun a => a * a) u in x * x * x <= total (fun a => a * a * (a * a)) u.
Proof.
  intros P S x. assert (X : 0 <= x).
  { unfold x. clear. induction u as [|a u IH]; cbn [total ladd lin_num add ops_R]; [cbn; lra|nra]. }
  assert (G : (x * x * x - 3 * (x * x) * x) * sum u + 3 * (x * x) * total (fun a => a * a) u <= total (fun a => a * a * (a * a)) u).
  { clearbody x. clear S. induction P as [|a u A P IH]; cbn [total ladd lin_num add ops_R]; [cbn; lra|]. rewrite sum_cons.
    assert (0 <= a * ((a - x) * (a - x) * (a + 2 * x))) 
      by (apply Rmult_le_pos; [auto|apply Rmult_le_pos; [apply Rle_0_sqr|lra]]). lra. }
  rewrite S in G. fold x in G. lra.
Qed.

Lemma pair_bracket (f : vec R) (q : quat R) (s t : rigid) (c : R) : norm2 (rotation s) = 1 -> norm2 (rotation t) = 1 ->
  0 <= c <= dot (rotation s) (rotation t) ->
  norm2 (pair_vector f q s t) <=
  norm2 (apply_rigid s f - apply_rigid t f) * ((1 - c) * (1 + c + 2 * norm2 q)).
Proof.
  intros Us Ut C. unfold pair_vector. set (X := (apply_rigid s f - apply_rigid t f)%V). set (p := rotation s) in *. set (r := rotation t) in *.
  set (g := dot p q - dot r q). destruct (pair_is_perpendicular_holds p r X g Us Ut) as [M O].
  set (m := im (qmul p (conj r))) in *.
  replace (norm2 (g *: X + cross X m)) with (g * g * norm2 X + 2 * dot (g *: X) (cross X m) + norm2 (cross X m)) by (dots; ring).
  rewrite O. pose proof (cross_norm2 X m) as Cr. rewrite M in Cr. pose proof (norm2_nonneg X) as Xn.
  assert (G : g * g <= 2 * (1 - dot p r) * norm2 q).
  { unfold g. rewrite <- dot_sub_l. pose proof (cauchy (p - r)%V q) as Ca.
    replace (norm2 (p - r)) with (norm2 p - 2 * dot p r + norm2 r) in Ca by (dots; ring). rewrite Us, Ut in Ca. lra. }
  assert (K : dot p r <= 1).
  { pose proof (cauchy p r) as Ca. rewrite Us, Ut in Ca. nra. }
  pose proof (norm2_nonneg q) as Q.
  assert (B : g * g + (1 - dot p r * dot p r) <= (1 - c) * (1 + c + 2 * norm2 q)) by nra.
  apply Rle_trans with (norm2 X * (g * g + (1 - dot p r * dot p r))); [lra|]. apply Rmult_le_compat_l; auto.
Qed.

Lemma total_weights u (cs : list rigid) (g : R -> R) : length u = length cs ->
  total (fun t => g (weight t)) (combine u cs) = total g u.
Proof. intros L. rewrite <- (total_map g weight). unfold weight. now rewrite combine_fst. Qed.
Lemma total_identity u : total (fun a : R => a) u = sum u.
Proof. induction u as [|a u IH]; [reflexivity|]. cbn [total]. rewrite sum_cons, IH. reflexivity. Qed.

(* What is said of transforms and of convex weights, of both together. *)
Lemma weighted_transforms cs c f u : are_within c cs -> convex (length cs) u -> let ts := combine u cs in
  (forall t, In t ts -> norm2 (turn t) = 1) /\ (forall t, In t ts -> 0 <= weight t) /\
  (forall p, In p (pairs ts) -> c <= dot (turn (fst p)) (turn (snd p))) /\
  squared_spread cs f = total (fun p => norm2 (image f (fst p) - image f (snd p))) (pairs ts) /\ total weight ts = 1.
Proof.
  intros (C0 & U & Cp) (L & P & S) ts. repeat split.
  - intros t I. rewrite Forall_forall in U. apply U. destruct t as [a r]. eapply in_combine_r, I.
  - intros t I. rewrite Forall_forall in P. apply P. destruct t as [a r]. eapply in_combine_l, I.
  - intros p I. rewrite Forall_forall in Cp. apply (Cp (snd (fst p), snd (snd p))).
    rewrite <- (combine_snd u cs L). rewrite pairs_map. apply in_map_iff. now exists p.
  - unfold squared_spread. rewrite <- (combine_snd u cs L) at 1. rewrite pairs_map, total_map. reflexivity.
  - rewrite <- S, <- (total_identity u). exact (total_weights u cs (fun a => a) L).
Qed.

Theorem deviates_little_holds : deviates_little.
Proof.
  intros cs c f u (C0 & U & Cp) W. assert (W' := W). destruct W' as (L & P & S).
  set (ts := combine u cs). set (q := comb u (map rotation cs)). set (x := total (fun a => a * a) u).
  destruct (weighted_transforms cs c f u (Logic.conj C0 (Logic.conj U Cp)) W) as (Ut & Pt & Cs & Sp & T1). fold ts in Ut, Pt, Cs, Sp, T1.
  (* The sums of the proof. *)
  set (P2 := total (fun p => weight (fst p) * weight (snd p)) (pairs ts)).
  set (p2 := total (fun p => (weight (fst p) * weight (snd p)) * (weight (fst p) * weight (snd p))) (pairs ts)).
  assert (T2 : total (fun t => weight t * weight t) ts = x) by exact (total_weights u cs (fun a => a * a) L).
  assert (T4 : total (fun t => weight t * weight t * (weight t * weight t)) ts = total (fun a => a * a * (a * a)) u)
    by exact (total_weights u cs (fun a => a * a * (a * a)) L).
  assert (Q1 : 1 = x + 2 * P2).
  { pose proof (square_of_total weight ts) as G. rewrite T1 in G. unfold norm2 in G. cbn [dot euclid_R] in G.
    rewrite T2 in G. fold P2 in G. lra. }
  assert (Q2 : x * x = total (fun a => a * a * (a * a)) u + 2 * p2).
  { pose proof (square_of_total (fun t => weight t * weight t) ts) as G. rewrite T2 in G. unfold norm2 in G.
    cbn [dot euclid_R] in G. rewrite T4 in G. rewrite G. f_equal. f_equal. unfold p2. apply total_ext. intros p _. ring. }
  assert (Pn : 0 <= P2).
  { unfold P2. replace 0 with (total (fun _ : (R * rigid) * (R * rigid) => 0) (pairs ts)).
    - apply total_le. intros p I. apply in_pairs in I as [I J]. apply Rmult_le_pos; auto.
    - generalize (pairs ts). induction l as [|p l IH]; [reflexivity|]. cbn [total]. rewrite IH. cbn. ring. }
  assert (Qd : x + c * (1 - x) <= norm2 q).
  { unfold q. rewrite comb_total. fold ts. pose proof (square_of_total (fun t => weight t *: turn t)%V ts) as G.
    assert (G1 : total (fun t => norm2 (weight t *: turn t)) ts = x).
    { rewrite <- T2. apply total_ext. intros t I. rewrite norm2_scale, (Ut t I). ring. }
    assert (G2 : c * P2 <= total (fun p => dot (weight (fst p) *: turn (fst p)) (weight (snd p) *: turn (snd p))) (pairs ts)).
    { unfold P2. rewrite <- total_scale. apply total_le. intros p I. rewrite dot_scale_l, dot_scale_r. specialize (Cs p I).
      apply in_pairs in I as [I J]. pose proof (Pt _ I). pose proof (Pt _ J).
      assert (0 <= weight (fst p) * weight (snd p)) by (apply Rmult_le_pos; auto). nra. }
    unfold weight, turn in *. rewrite G, G1. replace (1 - x) with (2 * P2) by lra. lra. }
  assert (X : 0 <= x <= 1).
  { split; [|lra]. unfold x. clear. induction u as [|a u IH]; cbn [total ladd lin_num add ops_R]; [cbn; lra|nra]. }
  pose proof (fourth_powers u P S) as F4. cbv zeta in F4. fold x in F4.
  destruct (pairs ts) as [|p0 ps] eqn:Ps.
  { (* One joint. *)
    rewrite Sp. cbn [total]. cbn [total] in Q1. unfold P2 in Q1. cbn in Q1.
    assert (X1 : x = 1) by lra. rewrite X1 in Qd. assert (Nq : q <> lzero) by (apply norm2_pos_inv; lra).
    pose proof (deviates_by_pairs_holds cs f u U W Nq) as I. fold q ts in I. rewrite Ps in I. cbn [total] in I.
    apply (f_equal norm2) in I. rewrite norm2_scale, norm2_zero in I. apply norm2_pos in Nq.
    cbn [lzero lin_num zero ops_R]. apply Rmult_integral in I as [I|I]; [|lra]. apply Rmult_integral in I as [I|I]; lra. }
  assert (C1 : c <= 1).
  { assert (I : In p0 (p0 :: ps)) by now left. pose proof (Cs p0 I) as D. rewrite <- Ps in I. apply in_pairs in I as [I J].
    pose proof (cauchy (turn (fst p0)) (turn (snd p0))) as Ca. rewrite (Ut _ I), (Ut _ J) in Ca. nra. }
  assert (Xp : 0 < x).
  { destruct (Rle_lt_or_eq_dec _ _ (proj1 X)) as [|Z]; auto. exfalso. unfold x in Z.
    assert (A : sum u = 0); [|lra]. clear - Z P. induction P as [|a u A P IH]; [reflexivity|]. cbn [total ladd lin_num add ops_R] in Z.
    assert (0 <= total (fun a => a * a) u) by (clear; induction u as [|b u IH]; cbn [total ladd lin_num add ops_R]; [cbn; lra|nra]).
    rewrite sum_cons, IH by nra. nra. }
  assert (Nq : q <> lzero) by (apply norm2_pos_inv; nra).
  pose proof (deviates_by_pairs_holds cs f u U W Nq) as I. fold q ts in I. rewrite Ps in I.
  set (K := (1 - c) * (1 + c + 2 * norm2 q)).
  assert (K0 : 0 <= K) by (pose proof (norm2_nonneg q); apply Rmult_le_pos; lra).
  destruct (cauchy_of_total (fun p => (fst (fst p) * fst (snd p)) *: pair_vector f q (snd (fst p)) (snd (snd p)))%V
    (fun p => norm2 (image f (fst p) - image f (snd p)))
    (fun p => K * ((weight (fst p) * weight (snd p)) * (weight (fst p) * weight (snd p)))) (p0 :: ps)) as (_ & _ & B).
  - intros p. apply norm2_nonneg.
  - intros p. apply Rmult_le_pos; auto. apply Rle_0_sqr.
  - intros p J. specialize (Cs p J). rewrite <- Ps in J. apply in_pairs in J as [J1 J2].
    rewrite norm2_scale. fold (weight (fst p)) (weight (snd p)).
    pose proof (pair_bracket f q (snd (fst p)) (snd (snd p)) c (Ut _ J1) (Ut _ J2) (Logic.conj C0 Cs)) as Br. fold K in Br.
    pose proof (Rle_0_sqr (weight (fst p) * weight (snd p))) as Sq. unfold Rsqr in Sq. unfold image. nra.
  - rewrite <- I, norm2_scale, <- Sp, total_scale in B. fold p2 in B.
    pose proof (nine_sixteenths x c (norm2 q) X C0 Qd) as N9. apply norm2_pos in Nq.
    assert (Sp0 : 0 <= squared_spread cs f).
    { rewrite Sp. clear. induction (p0 :: ps) as [|p l IH]; cbn [total ladd lin_num add ops_R]; [cbn; lra|].
      pose proof (norm2_nonneg (image f (fst p) - image f (snd p))%V). lra. }
    set (y := norm2 (dual_blend cs u f - carried cs u f)) in *. set (A2 := squared_spread cs f) in *.
    assert (p2b : 2 * p2 <= x * x * (1 - x)) by nra.
    assert (E : K * p2 <= 9 / 16 * (1 - c) * (norm2 q * norm2 q)).
    { unfold K. assert (0 <= 1 + c + 2 * norm2 q) by lra.
      assert ((1 + c + 2 * norm2 q) * p2 <= 9 / 16 * (norm2 q * norm2 q)) by nra.
      replace ((1 - c) * (1 + c + 2 * norm2 q) * p2) with ((1 - c) * ((1 + c + 2 * norm2 q) * p2)) by ring.
      replace (9 / 16 * (1 - c) * (norm2 q * norm2 q)) with ((1 - c) * (9 / 16 * (norm2 q * norm2 q))) by ring.
      apply Rmult_le_compat_l; lra. }
    apply Rmult_le_reg_l with (norm2 q * norm2 q); [nra|].
    apply Rle_trans with (1 := B). apply Rle_trans with (A2 * (9 / 16 * (1 - c) * (norm2 q * norm2 q))); [|right; ring].
    apply Rmult_le_compat_l; auto.
Qed.

(* --- The bound by products of weights --- *)

Lemma both_listed {X} (xs : list X) s t : In s xs -> In t xs -> s = t \/ In (s, t) (pairs xs) \/ In (t, s) (pairs xs).
Proof.
  induction xs as [|x xs IH]; [intros []|]. cbn [pairs]. intros [->|S] [->|T].
  - now left.
  - right. left. apply in_or_app. left. apply in_map_iff. now exists t.
  - right. right. apply in_or_app. left. apply in_map_iff. now exists s.
  - destruct (IH S T) as [E|[I|I]]; [now left|right; left|right; right]; apply in_or_app; now right.
Qed.

(* The g_k are in [c, 1], so that the bracket of a pair is at most 2 (1 - c). *)
Lemma near_bracket (f : vec R) (q : quat R) (s t : rigid) (c : R) : norm2 (rotation s) = 1 -> norm2 (rotation t) = 1 ->
  0 <= c <= dot (rotation s) (rotation t) -> c <= dot (rotation s) q <= 1 -> c <= dot (rotation t) q <= 1 ->
  norm2 (pair_vector f q s t) <= norm2 (apply_rigid s f - apply_rigid t f) * (2 * (1 - c)).
Proof.
  intros Us Ut C Gs Gt. unfold pair_vector. set (X := (apply_rigid s f - apply_rigid t f)%V).
  set (p := rotation s) in *. set (r := rotation t) in *. set (g := dot p q - dot r q).
  destruct (pair_is_perpendicular_holds p r X g Us Ut) as [M O]. set (m := im (qmul p (conj r))) in *.
  replace (norm2 (g *: X + cross X m)) with (g * g * norm2 X + 2 * dot (g *: X) (cross X m) + norm2 (cross X m)) by (dots; ring).
  rewrite O. pose proof (cross_norm2 X m) as Cr. rewrite M in Cr. pose proof (norm2_nonneg X) as Xn.
  assert (G : g * g <= (1 - c) * (1 - c)) by (unfold g; nra).
  apply Rle_trans with (norm2 X * (g * g + (1 - dot p r * dot p r))); [lra|]. apply Rmult_le_compat_l; [auto|nra].
Qed.

(* A mean of numbers in [c, 1] is in [c, 1]. *)
Lemma mean_within (ts : list (R * rigid)) (h : R * rigid -> R) c : total weight ts = 1 -> (forall t, In t ts -> 0 <= weight t) ->
  (forall t, In t ts -> c <= h t <= 1) -> c <= total (fun t => weight t * h t) ts <= 1.
Proof.
  intros T P H.
  assert (A : total (fun t => c * weight t) ts <= total (fun t => weight t * h t) ts).
  { apply total_le. intros t I. specialize (P t I). specialize (H t I). nra. }
  assert (B : total (fun t => weight t * h t) ts <= total weight ts).
  { apply total_le. intros t I. specialize (P t I). specialize (H t I). nra. }
  rewrite total_scale, T in A. lra.
Qed.

Theorem deviates_by_products_holds : deviates_by_products.
Proof.
  intros cs c f u P Q (C0 & U & Cp) W HP HQ D0. assert (W' := W). destruct W' as (L & Pu & S).
  set (ts := combine u cs). set (q := comb u (map rotation cs)).
  destruct (weighted_transforms cs c f u (Logic.conj C0 (Logic.conj U Cp)) W) as (Ut & Pt & Cs & Sp & T1). fold ts in Ut, Pt, Cs, Sp, T1.
  set (P2 := total (fun p => weight (fst p) * weight (snd p)) (pairs ts)).
  set (p2 := total (fun p => (weight (fst p) * weight (snd p)) * (weight (fst p) * weight (snd p))) (pairs ts)).
  assert (E2 : P2 <= P /\ p2 <= Q).
  { split; [replace P2 with (products u)|replace p2 with (squared_products u)]; auto;
      unfold P2, p2, products, squared_products; rewrite <- (combine_fst u cs L) at 1; rewrite pairs_map, total_map; reflexivity. }
  destruct E2 as [LP LQ].
  destruct (pairs ts) as [|p0 ps] eqn:Ps.
  { (* One joint, or none: the blend is what that joint does. *)
    assert (One : exists t, cs = [t]).
    { destruct cs as [|t [|t' cs]]; [destruct u; [cbn in S; lra|discriminate]|now exists t|].
      destruct u as [|a [|b u]]; try discriminate. }
    destruct One as [t ->]. destruct u as [|a [|b u]]; try discriminate. cbn in S.
    assert (A1 : a = 1) by lra. subst a. inversion U as [|? ? Un _]; subst.
    assert (Nq : q <> lzero).
    { apply norm2_pos_inv. unfold q. cbn [map comb]. replace (1 *: rotation t + lzero)%V with (rotation t) by vec_ring. lra. }
    pose proof (deviates_by_pairs_holds [t] f [1] U W Nq) as I. fold q ts in I. rewrite Ps in I. cbn [total] in I.
    apply (f_equal norm2) in I. rewrite norm2_scale, norm2_zero in I. apply norm2_pos in Nq.
    apply Rmult_integral in I as [I|I]; [apply Rmult_integral in I as [I|I]; lra|]. rewrite I, Sp. cbn. lra. }
  assert (C1 : c <= 1).
  { assert (I : In p0 (p0 :: ps)) by now left. pose proof (Cs p0 I) as D. rewrite <- Ps in I. apply in_pairs in I as [I J].
    pose proof (cauchy (turn (fst p0)) (turn (snd p0))) as Ca. rewrite (Ut _ I), (Ut _ J) in Ca. nra. }
  assert (Cd : forall s t, In s ts -> In t ts -> c <= dot (turn s) (turn t) <= 1).
  { intros s t Is It. split.
    - destruct (both_listed ts s t Is It) as [<-|[I|I]]; [unfold turn; pose proof (Ut s Is) as N; unfold norm2, turn in N; lra| |];
        rewrite Ps in I; specialize (Cs _ I); cbn [fst snd] in Cs; [auto|rewrite dot_comm; auto].
    - pose proof (cauchy (turn s) (turn t)) as Ca. rewrite (Ut _ Is), (Ut _ It) in Ca. nra. }
  assert (Gd : forall t, In t ts -> c <= dot (turn t) q <= 1).
  { intros t It. replace (dot (turn t) q) with (total (fun s => weight s * dot (turn t) (turn s)) ts).
    - apply mean_within; auto.
    - unfold q. rewrite comb_total. fold ts. rewrite dot_comm, dot_total. apply total_ext. intros s _.
      rewrite dot_scale_l, dot_comm. reflexivity. }
  (* D = sum u^2 + 2 sum p (q_k, q_l) >= 1 - 2 (1 - c) sum p. *)
  assert (Q1 : 1 = total (fun t => weight t * weight t) ts + 2 * P2).
  { pose proof (square_of_total weight ts) as G. rewrite T1, Ps in G. unfold norm2 in G. cbn [dot euclid_R] in G. fold P2 in G. lra. }
  assert (Qd : 1 - 2 * (1 - c) * P2 <= norm2 q).
  { unfold q. rewrite comb_total. fold ts. pose proof (square_of_total (fun t => weight t *: turn t)%V ts) as G. rewrite Ps in G.
    assert (G1 : total (fun t => norm2 (weight t *: turn t)) ts = total (fun t => weight t * weight t) ts).
    { apply total_ext. intros t I. rewrite norm2_scale, (Ut t I). ring. }
    assert (G2 : c * P2 <= total (fun p => dot (weight (fst p) *: turn (fst p)) (weight (snd p) *: turn (snd p))) (p0 :: ps)).
    { unfold P2. rewrite <- total_scale. apply total_le. intros p I. rewrite dot_scale_l, dot_scale_r. specialize (Cs p I).
      rewrite <- Ps in I. apply in_pairs in I as [I J]. pose proof (Pt _ I). pose proof (Pt _ J).
      assert (0 <= weight (fst p) * weight (snd p)) by (apply Rmult_le_pos; auto). nra. }
    unfold weight, turn in *. rewrite G, G1. lra. }
  assert (Dd : 1 - 2 * (1 - c) * P <= norm2 q) by nra.
  assert (Nq : q <> lzero) by (apply norm2_pos_inv; lra).
  pose proof (deviates_by_pairs_holds cs f u U W Nq) as I. fold q ts in I. rewrite Ps in I.
  destruct (cauchy_of_total (fun p => (fst (fst p) * fst (snd p)) *: pair_vector f q (snd (fst p)) (snd (snd p)))%V
    (fun p => norm2 (image f (fst p) - image f (snd p)))
    (fun p => 2 * (1 - c) * ((weight (fst p) * weight (snd p)) * (weight (fst p) * weight (snd p)))) (p0 :: ps)) as (A0 & _ & B).
  - intros p. apply norm2_nonneg.
  - intros p. apply Rmult_le_pos; [lra|apply Rle_0_sqr].
  - intros p J. specialize (Cs p J). rewrite <- Ps in J. apply in_pairs in J as [J1 J2].
    rewrite norm2_scale. fold (weight (fst p)) (weight (snd p)).
    pose proof (near_bracket f q (snd (fst p)) (snd (snd p)) c (Ut _ J1) (Ut _ J2) (Logic.conj C0 Cs) (Gd _ J1) (Gd _ J2)) as Br.
    pose proof (Rle_0_sqr (weight (fst p) * weight (snd p))) as Sq. unfold Rsqr in Sq. unfold image. nra.
  - rewrite <- I, norm2_scale, <- Sp, total_scale in B. fold p2 in B. rewrite <- Sp in A0.
    set (y := norm2 (dual_blend cs u f - carried cs u f)) in *. set (A2 := squared_spread cs f) in *.
    assert (y0 : 0 <= y) by apply norm2_nonneg.
    assert (DD : (1 - 2 * (1 - c) * P) * (1 - 2 * (1 - c) * P) <= norm2 q * norm2 q) by nra.
    assert (y * ((1 - 2 * (1 - c) * P) * (1 - 2 * (1 - c) * P)) <= y * (norm2 q * norm2 q)) by (apply Rmult_le_compat_l; auto).
    assert (A2 * (2 * (1 - c) * p2) <= A2 * (2 * (1 - c) * Q)) by (apply Rmult_le_compat_l; [auto|nra]).
    lra.
Qed.

Theorem carried_by_least_holds : carried_by_least.
Proof.
  intros xs m t L (Lt & _ & S) rest.
  assert (A : comb t (map (fun x => comb m xs + rest *: x)%V xs) = (sum t *: comb m xs + rest *: comb t xs)%V).
  { generalize (comb m xs). intros y. clear L S. revert t Lt. induction xs as [|x xs IH]; intros [|a t] Lt; try discriminate;
      cbn [map comb]; [replace (sum []) with 0 by reflexivity; vec_ring|]. rewrite IH by auto. rewrite sum_cons. vec_ring. }
  rewrite A, S. clear A S. clearbody rest. revert m t L Lt. induction xs as [|x xs IH]; intros [|b m] [|a t] L Lt; try discriminate;
    cbn [combine map comb fst snd]; [vec_ring|]. rewrite IH by auto. vec_ring.
Qed.

(* The hypotheses can be met: two unit quaternions at the cosine 4/5. *)
Example reach_instance : let cs := [Rigid (Quat 1 0 0 0) (Vec 0 0 0); Rigid (Quat (4 / 5) (3 / 5) 0 0) (Vec 1 0 0)] in
  are_within (4 / 5) cs /\ convex (length cs) [1 / 2; 1 / 2] /\ comb [1 / 2; 1 / 2] (map rotation cs) <> lzero.
Proof.
  cbv zeta. split; [|split].
  - split; [lra|]. split; repeat apply Forall_cons; try apply Forall_nil; cbn [fst snd rotation]; vunfold; lra.
  - repeat split; [repeat constructor; lra|cbn; lra].
  - apply norm2_pos_inv. cbn. vunfold. lra.
Qed.
