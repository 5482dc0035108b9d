(* SPDX-License-Identifier: MIT *)
(* Beyond the paper: the smallest ball of points on the unit sphere gives the smallest cap, and is a nearest-point
   problem. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex.
Import ListNotations.

(* --- Statements --- *)

(* c is the point of the hull nearest to 0. *)
Definition is_nearest_point {E} `{Euclid E} (ns : list E) (c : E) :=
  in_hull ns c /\ forall x, in_hull ns x -> norm c <= norm x.
(* That is so if and only if no n_k is on the near side of the plane through c. *)
Definition nearest_point_by_dots : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (ns : list E) (c : E), in_hull ns c ->
  (is_nearest_point ns c <-> forall n, In n ns -> norm2 c <= dot n c).

(* The smallest ball that encloses the n_k has center c and squared radius 1 - ||c||^2; there is no other that small. *)
Definition smallest_ball : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (ns : list E) (c : E),
  (forall n, In n ns -> norm2 n = 1) -> is_nearest_point ns c ->
  let r := sqrt (1 - norm2 c) in
  r * r = 1 - norm2 c /\ (forall n, In n ns -> in_ball (Ball c r) n) /\
  (forall b, (forall n, In n ns -> in_ball b n) -> r <= radius b /\ (radius b = r -> center b = c)).
(* The smallest cap that holds them has apex c / ||c|| and cosine ||c|| = min_k (n_k, c) / ||c||. *)
Definition smallest_cap : Prop :=
  forall E (l : Lin R E) (e : Euclid E) (ns : list E) (c : E),
  (forall n, In n ns -> norm2 n = 1) -> is_nearest_point ns c -> c <> lzero ->
  (forall n, In n ns -> norm c <= dot n (/ norm c *: c)) /\
  (exists n, In n ns /\ dot n (/ norm c *: c) = norm c) /\
  (forall a t, norm2 a = 1 -> (forall n, In n ns -> t <= dot n a) -> t <= norm c).

(* --- Proofs --- *)

(* If (n, c) < ||c||^2, a step from c towards n comes nearer to 0. *)
Lemma nearer_step {E} `{Euclid E} (c n : E) : dot n c < norm2 c ->
  exists t, 0 <= t <= 1 /\ norm2 (t *: n + (1 - t) *: c) < norm2 c.
Proof.
  intros D. set (g := norm2 c - dot n c). set (q := norm2 (n - c)).
  assert (Q : 0 <= q) by apply norm2_nonneg. assert (G : 0 < g) by (unfold g; lra).
  assert (P : forall t, norm2 (t *: n + (1 - t) *: c) = norm2 c - 2 * t * g + t * t * q) by (intros t; unfold g, q; dots; ring).
  exists (g / (g + q)). rewrite P.
  assert (T : 0 < g / (g + q)) by (apply Rmult_lt_0_compat; [lra|apply inv_pos; lra]).
  assert (T1 : g / (g + q) * (g + q) = g) by (field; lra). set (t := g / (g + q)) in *.
  split; [nra|]. assert (t * q <= g) by nra. assert (t * (t * q) <= t * g) by (apply Rmult_le_compat_l; lra).
  assert (0 < t * g) by nra. lra.
Qed.

Theorem nearest_point_by_dots_holds : nearest_point_by_dots.
Proof.
  intros E l e ns c C. split.
  - intros [_ N] n I. destruct (Rle_lt_dec (norm2 c) (dot n c)) as [|D]; auto. exfalso.
    destruct (nearer_step c n D) as (t & T & S).
    specialize (N (t *: n + (1 - t) *: c)%V (hull_convex ns t n c T (hull_point ns n I) C)).
    pose proof (norm_nonneg c). rewrite <- !norm_sq in S. nra.
  - intros D. split; auto. intros x (u & (L & P & S) & ->).
    assert (A : norm2 c <= dot (comb u ns) c).
    { rewrite dot_comb. replace (norm2 c) with (norm2 c * sum u) by (rewrite S; ring).
      apply comb_at_least; [now rewrite map_length|auto|]. apply Forall_map, Forall_forall. exact D. }
    pose proof (dot_le_norms (comb u ns) c). rewrite <- norm_sq in A. pose proof (norm_nonneg c).
    pose proof (norm_nonneg (comb u ns)). nra.
Qed.

Lemma nearest_short {E} `{Euclid E} (ns : list E) c : (forall n, In n ns -> norm2 n = 1) -> is_nearest_point ns c ->
  norm2 c <= 1.
Proof.
  intros U [(u & W & Q) N]. destruct ns as [|n ns]; [now apply convex_not_empty in W|].
  specialize (N n (hull_point _ n (in_eq n ns))). rewrite (norm_unit n) in N by (apply U; now left).
  rewrite <- norm_sq. pose proof (norm_nonneg c). nra.
Qed.

(* sum_k u_k ||n_k - g||^2 = 1 - ||c||^2 + ||g - c||^2 *)
Lemma mean_square_distance {E} `{Euclid E} (ns : list E) u g : (forall n, In n ns -> norm2 n = 1) -> convex (length ns) u ->
  comb u (map (fun n => norm2 (n - g)) ns) = 1 - norm2 (comb u ns) + norm2 (g - comb u ns).
Proof.
  intros U (L & _ & S).
  assert (G : comb u (map (fun n => norm2 (n - g)) ns) = sum u * (1 + norm2 g) - 2 * dot (comb u ns) g).
  { clear S. revert u L; induction ns as [|n ns IH]; intros [|a u] L; try discriminate.
    - cbn. rewrite dot_zero_l. ring.
    - cbn [map comb]. rewrite IH, sum_cons by (auto; intros m I; apply U; now right).
      replace (norm2 (n - g)) with (norm2 n - 2 * dot n g + norm2 g) by (dots; ring).
      rewrite (U n) by (now left). cbn [ladd lscale lin_num add mul ops_R]. rewrite !dot_add_l, !dot_scale_l. ring. }
  rewrite G, S. set (c := comb u ns). dots. ring.
Qed.

Theorem smallest_ball_holds : smallest_ball.
Proof.
  intros E l e ns c U N r. pose proof (nearest_short ns c U N) as C1.
  assert (R : r * r = 1 - norm2 c) by (apply sqrt_sqrt; lra). assert (R0 : 0 <= r) by apply sqrt_pos.
  split; [exact R|]. pose proof (proj1 (nearest_point_by_dots_holds E l e ns c (proj1 N)) N) as D. split.
  - intros n I. unfold in_ball. cbn [center radius]. apply norm_le. split; auto. rewrite R.
    replace (norm2 (n - c)) with (norm2 n - 2 * dot n c + norm2 c) by (dots; ring). rewrite (U n I). specialize (D n I). lra.
  - intros b B. destruct N as [(u & W & Q) _]. pose proof (mean_square_distance ns u (center b) U W) as M. rewrite <- Q in M.
    assert (P : 1 - norm2 c + norm2 (center b - c) <= radius b * radius b).
    { rewrite <- M. destruct W as (L & Pu & S). replace (radius b * radius b) with (radius b * radius b * sum u) by (rewrite S; ring).
      apply comb_at_most; [now rewrite map_length|auto|]. apply Forall_map, Forall_forall. intros n I.
      specialize (B n I). unfold in_ball in B. now apply norm_le in B as [_ B]. }
    assert (B0 : 0 <= radius b).
    { destruct ns as [|n ns]; [now apply convex_not_empty in W|]. specialize (B n (in_eq n ns)).
      unfold in_ball in B. pose proof (norm_nonneg (n - center b)%V). lra. }
    pose proof (norm2_nonneg (center b - c)%V). split; [nra|]. intros Z. rewrite Z, R in P.
    assert (G : (center b - c)%V = lzero) by (apply norm2_zero_inv; lra).
    apply dot_ext. intros z. apply (f_equal (fun y => dot y z)) in G. cbv beta in G. autorewrite with dots in G. lra.
Qed.

Theorem smallest_cap_holds : smallest_cap.
Proof.
  intros E l e ns c U N Nz. pose proof (norm_pos c Nz) as P. pose proof (norm_sq c) as Q.
  pose proof (proj1 (nearest_point_by_dots_holds E l e ns c (proj1 N)) N) as D.
  assert (A : forall n, In n ns -> norm c <= dot n (/ norm c *: c)).
  { intros n I. rewrite dot_scale_r. apply Rmult_le_reg_l with (1 := P). rewrite <- Rmult_assoc, Rinv_r by lra.
    specialize (D n I). lra. }
  destruct N as [(u & (L & Pu & S) & C) N]. split; [exact A|]. split.
  - assert (X : forall a t, (forall n, In n ns -> t < dot n a) -> t < dot c a).
    { intros a t T. rewrite C, dot_comb.
      cut (0 < comb u (map (fun n => dot n a - t) ns)).
      - intros G. assert (Z : comb u (map (fun n => dot n a - t) ns) = comb u (map (fun n => dot n a) ns) - t * sum u).
        { clear - L. revert u L; induction ns as [|n ns IH]; intros [|x u] L; try discriminate; cbn [map comb].
          - cbn. ring.
          - rewrite IH, sum_cons by auto. vunfold. ring. }
        rewrite Z, S in G. lra.
      - apply comb_positive; [now rewrite map_length|auto|lra|]. apply Forall_map, Forall_forall. intros n I.
        specialize (T n I). lra. }
    set (a := (/ norm c *: c)%V) in *.
    assert (Y : dot c a = norm c).
    { unfold a. rewrite dot_scale_r. change (dot c c) with (norm2 c). rewrite <- Q. field. lra. }
    destruct (Exists_dec (fun n => dot n a <= norm c) ns (fun n => Rle_dec (dot n a) (norm c))) as [F|F].
    + apply Exists_exists in F as (n & I & F). exists n. split; auto. specialize (A n I). lra.
    + exfalso. specialize (X a (norm c)). rewrite Y in X. apply (Rlt_irrefl (norm c)), X. intros n I.
      apply Rnot_le_lt. intros G. apply F, Exists_exists. eauto.
  - intros a t Ua T. assert (B : t <= dot c a).
    { rewrite C, dot_comb. replace t with (t * sum u) by (rewrite S; ring).
      apply comb_at_least; [now rewrite map_length|auto|]. apply Forall_map, Forall_forall. exact T. }
    pose proof (dot_le_norms c a). rewrite (norm_unit a Ua) in *. lra.
Qed.

(* The hypotheses can be met: (3/5, 4/5) and (3/5, -4/5), with c = (3/5, 0) half-way. *)
Example nearest_instance : let ns := [((3 / 5, 4 / 5) : plane); (3 / 5, - (4 / 5))] in let c := ((3 / 5, 0) : plane) in
  (forall n, In n ns -> norm2 n = 1) /\ is_nearest_point ns c /\ c <> lzero.
Proof.
  cbv zeta. split; [|split].
  - intros n [<-|[<-|[]]]; vunfold; lra.
  - apply nearest_point_by_dots_holds.
    + exists [1 / 2; 1 / 2]. split; [repeat split; [repeat constructor; lra|cbn; lra]|]. cbn. vunfold. f_equal; field.
    + intros n [<-|[<-|[]]]; vunfold; lra.
  - apply norm2_pos_inv. vunfold. lra.
Qed.
