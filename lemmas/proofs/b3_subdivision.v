(* Beyond the paper: halving a simplex of weights at an edge tightens its control points as far as wanted. *)
From Coq Require Import List Reals Lra Psatz Lia.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.b1_rational_bezier_simplex Refitlab.b2_control_hull_encloses.
Import ListNotations.

(* --- Statements --- *)

(* The half at the edge (k, l) that keeps corner k has the middle in place of corner l. *)
Fixpoint set_nth {X} (k : nat) (y : X) (xs : list X) : list X :=
  match xs, k with [], _ => [] | _ :: t, O => y :: t | x :: t, S k => x :: set_nth k y t end.
Definition half {E} {l : Lin R E} (kept replaced : nat) (xs : list E) : list E :=
  set_nth replaced (1 / 2 *: (nth kept xs lzero + nth replaced xs lzero))%V xs.

(* 1. Cover: every blend of the whole is one of a half, and the other way round. *)
Definition halves_cover : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (xs : list E) (i j : nat) (x : E),
  (i < length xs)%nat -> (j < length xs)%nat -> i <> j ->
  (in_hull xs x <-> in_hull (half i j xs) x \/ in_hull (half j i xs) x).
(* 2. Rate. Halving the longest edge (a, b) leaves the new edges, from its middle to c, at most sqrt(3)/2 of it. *)
Definition new_edge_is_shorter : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (a b c : E), norm (a - c) <= norm (a - b) -> norm (b - c) <= norm (a - b) ->
  norm (1 / 2 *: (a + b) - c) <= sqrt 3 / 2 * norm (a - b).
(* 3. Sign: W_kl is positive if and only if the blend in the middle is longer than half the edge. *)
Definition positive_if_middle_is_long : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (p q : E),
  dot p q = norm2 (1 / 2 *: (p + q)) - norm2 (1 / 2 *: (p - q)) /\
  (0 < dot p q <-> norm (1 / 2 *: (p - q)) < norm (1 / 2 *: (p + q))).
(* For quaternions of equal length, both parts of an edge are positive after one halving, unless the blend in its middle
   is 0. *)
Definition halving_makes_positive : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (p q : E), norm2 p = norm2 q -> let m := (1 / 2 *: (p + q))%V in
  m <> lzero -> 0 < dot p m /\ 0 < dot q m.

(* --- Proofs --- *)

Lemma set_nth_length {X} k (y : X) xs : length (set_nth k y xs) = length xs.
Proof. revert k; induction xs; intros [|k]; cbn; auto. Qed.
Lemma half_length {E} {l : Lin R E} i j (xs : list E) : length (half i j xs) = length xs.
Proof. apply set_nth_length. Qed.
Lemma set_nth_sum k a u : (k < length u)%nat -> sum (set_nth k a u) = sum u - nth k u 0 + a.
Proof.
  revert k; induction u as [|x u IH]; intros [|k] H; cbn [set_nth nth length] in *; try lia; rewrite !sum_cons; [ring|].
  rewrite IH by lia. ring.
Qed.
Lemma set_nth_nonneg k a u : 0 <= a -> Forall (Rle 0) u -> Forall (Rle 0) (set_nth k a u).
Proof. intros A U. revert k; induction U; intros [|k]; cbn; auto. Qed.
Lemma set_nth_nth_other {X} j k (y d : X) xs : j <> k -> nth j (set_nth k y xs) d = nth j xs d.
Proof. revert j k; induction xs; intros [|j] [|k] H; cbn; auto; lia. Qed.
Lemma set_nth_nth_same {X} k (y d : X) xs : (k < length xs)%nat -> nth k (set_nth k y xs) d = y.
Proof. revert k; induction xs; intros [|k] H; cbn in *; auto; try lia. apply IHxs. lia. Qed.
Lemma nth_nonneg k u : Forall (Rle 0) u -> 0 <= nth k u 0.
Proof. intros U; revert k; induction U; intros [|k]; cbn; auto; lra. Qed.

Section Halves.
Context {E : Type} `{Euclid E}.

Lemma comb_set_coefficient k a u (xs : list E) : (k < length u)%nat -> length u = length xs ->
  comb (set_nth k a u) xs = (comb u xs + (a - nth k u 0) *: nth k xs lzero)%V.
Proof.
  revert k xs; induction u as [|b u IH]; intros [|k] [|x xs] K L; cbn [set_nth nth comb length] in *; try lia; try vec_ring.
  rewrite IH by lia. vec_ring.
Qed.
Lemma comb_set_point k y u (xs : list E) : (k < length u)%nat -> length u = length xs ->
  comb u (set_nth k y xs) = (comb u xs + nth k u 0%R *: (y - nth k xs lzero))%V.
Proof.
  revert k xs; induction u as [|b u IH]; intros [|k] [|x xs] K L; cbn [set_nth nth comb length] in *; try lia; try vec_ring.
  rewrite IH by lia. vec_ring.
Qed.

(* u_i x_i + u_j x_j = (u_i - u_j) x_i + 2 u_j (x_i + x_j) / 2 for u_j <= u_i *)
Lemma half_of_whole (xs : list E) i j u : (i < length xs)%nat -> (j < length xs)%nat -> i <> j ->
  convex (length xs) u -> nth j u 0 <= nth i u 0 -> in_hull (half i j xs) (comb u xs).
Proof.
  intros I J N (L & P & S) O. exists (set_nth i (nth i u 0 - nth j u 0) (set_nth j (2 * nth j u 0) u)).
  pose proof (nth_nonneg j u P). rewrite half_length. split; [split; [|split]|].
  - now rewrite !set_nth_length.
  - repeat apply set_nth_nonneg; auto; lra.
  - rewrite set_nth_sum, set_nth_sum, set_nth_nth_other by (rewrite ?set_nth_length; auto; lia). lra.
  - unfold half. rewrite comb_set_point, comb_set_coefficient, comb_set_coefficient by (rewrite ?set_nth_length; lia).
    rewrite !set_nth_nth_other, set_nth_nth_same by (auto; lia). vec_field.
Qed.
Lemma whole_of_half (xs : list E) i j x : (i < length xs)%nat -> (j < length xs)%nat -> i <> j ->
  in_hull (half i j xs) x -> in_hull xs x.
Proof.
  intros I J N (u & (L & P & S) & ->). rewrite half_length in L.
  exists (set_nth i (nth i u 0 + nth j u 0 / 2) (set_nth j (nth j u 0 / 2) u)).
  pose proof (nth_nonneg j u P). pose proof (nth_nonneg i u P). split; [split; [|split]|].
  - now rewrite !set_nth_length.
  - repeat apply set_nth_nonneg; auto; lra.
  - rewrite set_nth_sum, set_nth_sum, set_nth_nth_other by (rewrite ?set_nth_length; auto; lia). lra.
  - unfold half. rewrite comb_set_point, !comb_set_coefficient by (rewrite ?set_nth_length; lia).
    rewrite !set_nth_nth_other by auto. vec_field.
Qed.
End Halves.

Theorem halves_cover_holds : halves_cover.
Proof.
  intros E l e xs i j x I J N. split.
  - intros (u & U & ->). destruct (Rle_lt_dec (nth j u 0) (nth i u 0)) as [O|O]; [left|right]; apply half_of_whole; auto; lra.
  - intros [X|X]; [apply whole_of_half with i j|apply whole_of_half with j i]; auto.
Qed.

Theorem new_edge_is_shorter_holds : new_edge_is_shorter.
Proof.
  intros E l e a b c A B. assert (S : sqrt 3 * sqrt 3 = 3) by (apply sqrt_sqrt; lra). pose proof (sqrt_pos 3).
  pose proof (norm_nonneg (a - b)%V). apply norm_le. split; [nra|].
  replace (sqrt 3 / 2 * norm (a - b) * (sqrt 3 / 2 * norm (a - b))) with (sqrt 3 * sqrt 3 / 4 * (norm (a - b) * norm (a - b)))
    by field.
  rewrite S. replace (norm2 (1 / 2 *: (a + b) - c)) with ((2 * norm2 (a - c) + 2 * norm2 (b - c) - norm2 (a - b)) / 4)
    by (dots; field).
  rewrite <- !norm_sq. pose proof (norm_nonneg (a - c)%V). pose proof (norm_nonneg (b - c)%V). nra.
Qed.

Theorem positive_if_middle_is_long_holds : positive_if_middle_is_long.
Proof.
  intros E l e p q.
  assert (D : dot p q = norm2 (1 / 2 *: (p + q)) - norm2 (1 / 2 *: (p - q))) by (dots; field).
  split; [exact D|]. rewrite D, <- !norm_sq. pose proof (norm_nonneg (1 / 2 *: (p + q))%V).
  pose proof (norm_nonneg (1 / 2 *: (p - q))%V). split; nra.
Qed.

Theorem halving_makes_positive_holds : halving_makes_positive.
Proof.
  intros E l e p q Q m N. apply norm2_pos in N.
  assert (M : norm2 m = (norm2 p + 2 * dot p q + norm2 q) / 4) by (unfold m; dots; field).
  replace (dot p m) with ((norm2 p + dot p q) / 2) by (unfold m; dots; field).
  replace (dot q m) with ((norm2 q + dot p q) / 2) by (unfold m; dots; field). lra.
Qed.

(* The hypotheses can be met: an edge of two quaternions of unit length, and a third corner between them. *)
Example halving_instance : let p := Quat 1 0 0 0 in let q := Quat (3 / 5) (4 / 5) 0 0 in
  norm2 p = norm2 q /\ (1 / 2 *: (p + q))%V <> lzero /\ (0 < length [p; q])%nat /\ (1 < length [p; q])%nat /\ 0%nat <> 1%nat.
Proof. cbv zeta. repeat split; try (cbn; lia); [vunfold; field|apply norm2_pos_inv; vunfold; lra]. Qed.
Example longest_edge_instance : let a := Quat 1 0 0 0 in let b := Quat (-1) 0 0 0 in let c := Quat 0 1 0 0 in
  norm (a - c) <= norm (a - b) /\ norm (b - c) <= norm (a - b).
Proof.
  cbv zeta. rewrite (norm_eq (Quat 1 0 0 0 - Quat (-1) 0 0 0)%V 2) by (try lra; vunfold; ring).
  split; apply norm_le; (split; [lra|]); vunfold; lra.
Qed.
