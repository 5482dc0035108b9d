(* SPDX-License-Identifier: MIT *)
(* Section 4.4, adding the bounds: the sum of the linear and the spherical part is in one ball of equal balls. Line 16 of
   Algorithm 1. It holds as printed. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex.
Import ListNotations.

(* --- Statements: the r'_k are linear, F = [f, s] is spherical --- *)

(* A ball [g, R] that encloses the m equal balls r'_k (+) F. *)
Definition encloses_equal_balls {E} `{Euclid E} (b spherical : ball E) (linear : list E) :=
  forall r, In r linear -> holds_ball b (Ball (r + center spherical)%V (radius spherical)).
Definition inflate {E} (b : ball E) (r : R) := Ball (center b) (radius b + r).

(* Every sum of a point of the hull of the r'_k, a point of F and an offset of at most r is in [g, R + r]. *)
Definition sum_of_bounds_printed : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (b spherical : ball E) (linear : list E) (r : R) (x y offset : E),
  encloses_equal_balls b spherical linear -> in_hull linear x -> in_ball spherical y -> norm offset <= r ->
  in_ball (inflate b r) (x + y + offset)%V.
(* CH(r'_1 (+) F, ..., r'_m (+) F) = CH(r'_1, ..., r'_m) (+) F. *)
Definition hull_of_balls_is_sum : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (spherical : ball E) (linear : list E) (z : E), linear <> [] ->
  ((exists u ps, convex (length linear) u /\ z = comb u ps /\
      Forall2 (fun r p => in_ball (Ball (r + center spherical)%V (radius spherical)) p) linear ps) <->
   (exists x y, in_hull linear x /\ in_ball spherical y /\ z = (x + y)%V)).
(* A ball encloses [x, s] if and only if it encloses all of its points; if there is a unit vector, holds_ball says so. *)
Definition farthest_point_decides : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (b inner : ball E), (exists n : E, norm2 n = 1) -> 0 <= radius inner ->
  (holds_ball b inner <-> forall x, in_ball inner x -> in_ball b x).

(* --- Proofs --- *)

Theorem sum_of_bounds_holds : sum_of_bounds_printed.
Proof.
  intros E l e b F linear r x y offset B X Y O. unfold in_ball, inflate in *. cbn [center radius].
  assert (G : in_ball (Ball (center b - center F)%V (radius b - radius F)) x).
  { apply (hull_in_convex_set _ linear); auto using ball_convex. apply Forall_forall. intros p I. specialize (B p I).
    unfold holds_ball in B. cbn [center radius] in B. unfold in_ball. cbn [center radius].
    replace (p - (center b - center F))%V with (p + center F - center b)%V by vec_ring. lra. }
  unfold in_ball in G. cbn [center radius] in G.
  replace (x + y + offset - center b)%V with ((x - (center b - center F)) + (y - center F) + offset)%V by vec_ring.
  pose proof (norm_add ((x - (center b - center F)) + (y - center F))%V offset).
  pose proof (norm_add (x - (center b - center F))%V (y - center F)%V). lra.
Qed.

Lemma comb_sub {E} `{Euclid E} u (ps rs : list E) : length ps = length rs ->
  comb u (map (fun p => fst p - snd p)%V (combine ps rs)) = (comb u ps - comb u rs)%V.
Proof.
  revert ps rs; induction u as [|a u IH]; intros [|p ps] [|r rs] L; try discriminate; cbn [combine map comb fst snd];
    try vec_ring. rewrite IH by auto. vec_ring.
Qed.

Lemma Forall2_length {A B} (P : A -> B -> Prop) xs ys : Forall2 P xs ys -> length xs = length ys.
Proof. induction 1; cbn; congruence. Qed.

Theorem hull_of_balls_is_sum_holds : hull_of_balls_is_sum.
Proof.
  intros E l e F linear z N. split.
  - intros (u & ps & U & -> & P). assert (L := Forall2_length _ _ _ P). exists (comb u linear), (comb u ps - comb u linear)%V.
    split; [exists u; auto|]. split; [|vec_ring]. rewrite <- comb_sub by auto.
    apply convex_set_comb; auto using ball_convex.
    + rewrite map_length, combine_length, <- L, Nat.min_id. exact U.
    + clear - P. induction P as [|r p rs ps I P IH]; cbn [combine map fst snd]; constructor; auto.
      unfold in_ball in *. cbn [center radius] in *. replace (p - r - center F)%V with (p - (r + center F))%V by vec_ring. lra.
  - intros (x & y & (u & U & ->) & Y & ->). exists u, (map (fun r => r + y)%V linear). split; [auto|]. split.
    + symmetry. now apply comb_shift_convex.
    + clear - Y. induction linear as [|r rs IH]; cbn [map]; constructor; auto.
      unfold in_ball in *. cbn [center radius] in *. replace (r + y - (r + center F))%V with (y - center F)%V by vec_ring. lra.
Qed.

Theorem farthest_point_decides_holds : farthest_point_decides.
Proof.
  intros E l e b inner (n & U) P. split; [intros B x X; now apply holds_ball_point with inner|]. intros A.
  unfold holds_ball. set (d := (center inner - center b)%V).
  assert (X : exists m, norm2 m = 1 /\ norm (d + radius inner *: m) = norm d + radius inner).
  { destruct (Rle_lt_or_eq_dec _ _ (norm_nonneg d)) as [D|D].
    - exists (/ norm d *: d)%V. split; [rewrite norm2_scale, <- norm_sq; field; lra|].
      replace (d + radius inner *: (/ norm d *: d))%V with ((1 + radius inner * / norm d) *: d)%V by vec_ring.
      rewrite norm_scale; [field; lra|]. assert (0 <= radius inner * / norm d); [|lra].
      apply Rmult_le_pos; auto. left. now apply inv_pos.
    - exists n. split; auto. assert (Z : d = lzero) by (apply norm2_zero_inv; rewrite <- norm_sq, <- D; ring).
      rewrite Z, norm_zero. replace (lzero + radius inner *: n)%V with (radius inner *: n)%V by vec_ring.
      rewrite norm_scale, (norm_unit n) by auto. ring. }
  destruct X as (m & M & <-). specialize (A (center inner + radius inner *: m)%V). unfold in_ball in A.
  unfold d. replace (center inner - center b + radius inner *: m)%V with (center inner + radius inner *: m - center b)%V by vec_ring.
  apply A. replace (center inner + radius inner *: m - center inner)%V with (radius inner *: m)%V by vec_ring.
  rewrite norm_scale, (norm_unit m) by auto. lra.
Qed.

(* The hypotheses can be met, and the bound is reached: r'_1 = 0, r'_2 = (2, 0, 0), F = [0, 1], r = 1, the vertex
   (4, 0, 0). *)
Example sum_of_bounds_instance : let b := Ball (Vec 1 0 0) 2 in let F := Ball (Vec 0 0 0) 1 in
  let linear := [Vec 0 0 0; Vec 2 0 0] in
  encloses_equal_balls b F linear /\ in_hull linear (Vec 2 0 0) /\ in_ball F (Vec 1 0 0) /\ norm (Vec 1 0 0) <= 1 /\
  norm ((Vec 2 0 0 + Vec 1 0 0 + Vec 1 0 0)%V - center b) = radius (inflate b 1).
Proof.
  assert (N : norm (Vec 1 0 0) = 1) by (apply norm_unit; vunfold; ring). cbv zeta. repeat split.
  - intros r [<-|[<-|[]]]; unfold holds_ball; cbn [center radius]; rewrite (norm_unit (_ - _)%V) by (vunfold; ring); lra.
  - exists [0; 1]. split; [repeat split; [repeat constructor; lra|cbn; lra]|]. cbn. vunfold. f_equal; ring.
  - unfold in_ball. apply norm_le. cbn [center radius]. split; vunfold; lra.
  - lra.
  - apply norm_eq; cbn [inflate center radius]; [lra|]. vunfold. ring.
Qed.
