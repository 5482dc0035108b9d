(* SPDX-License-Identifier: MIT *)
(* Beyond the paper: how far the determinant of four points can be off, if their coordinates are. *)
From Coq Require Import Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid.

(* Four points a, b, c, d, and the determinant of the differences p = b - a, q = c - a, r = d - a. *)
Record points := Points { pa : vec R; pb : vec R; pc : vec R; pd : vec R }.
Definition p_of m := (pb m - pa m)%V.
Definition q_of m := (pc m - pa m)%V.
Definition r_of m := (pd m - pa m)%V.
Definition triple (p q r : vec R) := dot (cross p q) r.
Arguments triple (p q r)%V.
Definition determinant (m : points) := triple (p_of m) (q_of m) (r_of m).

(* The points n are those of m, but for at most h in each coordinate, or for h in each. *)
Definition all_coordinates (ok : R -> Prop) (v : vec R) := ok (vx v) /\ ok (vy v) /\ ok (vz v).
Arguments all_coordinates ok v%V.
Definition all_differ (ok : R -> Prop) (m n : points) := all_coordinates ok (pa n - pa m) /\ all_coordinates ok (pb n - pb m) /\
  all_coordinates ok (pc n - pc m) /\ all_coordinates ok (pd n - pd m).
Definition off_by (h : R) := all_differ (fun t => Rabs t <= h).
Definition off_by_just (h : R) := all_differ (fun t => Rabs t = h).
(* No coordinate of the differences is larger than x, y and z. *)
Definition within (x y z : R) (v : vec R) := Rabs (vx v) <= x /\ Rabs (vy v) <= y /\ Rabs (vz v) <= z.
Definition extents (x y z : R) (m : points) := within x y z (p_of m) /\ within x y z (q_of m) /\ within x y z (r_of m).

(* The bounds of the first order, and of the second and the third. *)
Definition one_norm (v : vec R) := Rabs (vx v) + Rabs (vy v) + Rabs (vz v).
Arguments one_norm v%V.
Definition sum_of_slopes (by_b by_c by_d : vec R) :=
  one_norm by_b + one_norm by_c + one_norm by_d + one_norm (by_b + by_c + by_d).
Definition slopes (m : points) :=
  sum_of_slopes (cross (q_of m) (r_of m)) (cross (r_of m) (p_of m)) (cross (p_of m) (q_of m)).
Definition first_order (e x y z : R) := 4 * e * (x * y + y * z + z * x).
Definition higher_orders (e x y z : R) := 3 * e * e * (x + y + z) + 2 * e * e * e.

(* --- Statements --- *)

(* (i) *)
Definition changes_by_extents : Prop := forall m n h x y z, off_by h m n -> extents x y z m -> let e := 2 * h in
  Rabs (determinant n - determinant m) <= first_order e x y z + higher_orders e x y z.
(* (ii) *)
Definition changes_by_slopes : Prop := forall m n h x y z, off_by h m n -> extents x y z m ->
  Rabs (determinant n - determinant m) <= h * slopes m + higher_orders (2 * h) x y z.
(* (iii) *)
Definition slopes_are_never_looser : Prop := forall m h x y z, 0 <= h -> extents x y z m ->
  h * slopes m <= first_order (2 * h) x y z.
(* (iv): the slopes are reached to first order, for all points, and the bound by extents is reached, for all extents. *)
Definition slopes_are_reached : Prop := forall m h x y z, 0 <= h -> extents x y z m -> exists n, off_by_just h m n /\
  h * slopes m - higher_orders (2 * h) x y z <= determinant n - determinant m.
Definition extents_are_reached : Prop := forall h x y z, 0 <= h -> 0 <= x -> 0 <= y -> 0 <= z -> let e := 2 * h in
  exists m n, off_by_just h m n /\ extents x y z m /\ determinant n - determinant m = first_order e x y z + higher_orders e x y z.
(* What programs use: a determinant that is computed, and has lost at most so much, has the sign of the true one. *)
Definition sign_is_kept : Prop := forall m n h x y z computed lost, off_by h m n -> extents x y z m ->
  Rabs (computed - determinant m) <= lost -> let most := h * slopes m + higher_orders (2 * h) x y z + lost in
  (most < computed -> 0 < determinant n) /\ (computed < - most -> determinant n < 0).

(* What is guessed: that small errors need no more than the slopes. *)
Definition slopes_suffice : Prop := forall m n h, off_by h m n -> Rabs (determinant n - determinant m) <= h * slopes m.

(* --- Proofs --- *)

Lemma abs_le t s : Rabs t <= s <-> - s <= t <= s.
Proof. split; [intros H|intros [H G]; now apply Rabs_le]. split; unfold Rabs in H; destruct (Rcase_abs t); lra. Qed.
Lemma abs_nonneg_of t s : Rabs t <= s -> 0 <= s.
Proof. pose proof (Rabs_pos t). lra. Qed.
Lemma abs_times t u s : Rabs t <= s -> Rabs (t * u) <= s * Rabs u.
Proof. intros H. rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos|exact H]. Qed.
Lemma abs_product t u s v : Rabs t <= s -> Rabs u <= v -> Rabs (t * u) <= s * v.
Proof. intros H G. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. Qed.

(* Twice the area of a triangle in a rectangle is at most that of the rectangle. Its sides are 2 s and 2 t. *)
Lemma triangle_in_rectangle a1 a2 b1 b2 c1 c2 s t : Rabs a1 <= s -> Rabs b1 <= s -> Rabs c1 <= s ->
  Rabs a2 <= t -> Rabs b2 <= t -> Rabs c2 <= t -> Rabs ((b1 - a1) * (c2 - a2) - (b2 - a2) * (c1 - a1)) <= 4 * s * t.
Proof.
  intros A B C D E F. pose proof (abs_nonneg_of _ _ A) as S.
  replace ((b1 - a1) * (c2 - a2) - (b2 - a2) * (c1 - a1)) with (a1 * (b2 - c2) + b1 * (c2 - a2) + c1 * (a2 - b2)) by ring.
  assert (Rabs (b2 - c2) + Rabs (c2 - a2) + Rabs (a2 - b2) <= 4 * t) as W.
  { apply abs_le in D, E, F. unfold Rabs. destruct (Rcase_abs _), (Rcase_abs _), (Rcase_abs _); lra. }
  pose proof (abs_times _ (b2 - c2) _ A). pose proof (abs_times _ (c2 - a2) _ B). pose proof (abs_times _ (a2 - b2) _ C).
  pose proof (Rabs_triang (a1 * (b2 - c2) + b1 * (c2 - a2)) (c1 * (a2 - b2))).
  pose proof (Rabs_triang (a1 * (b2 - c2)) (b1 * (c2 - a2))). nra.
Qed.

(* Two of the errors of p, q, r: each is off by what b, c or d is off, less what a is. *)
Lemma cross_of_errors a b c h : all_coordinates (fun t => Rabs t <= h) a -> all_coordinates (fun t => Rabs t <= h) b ->
  all_coordinates (fun t => Rabs t <= h) c -> all_coordinates (fun t => Rabs t <= 4 * h * h) (cross (b - a) (c - a)).
Proof.
  destruct a as [a1 a2 a3], b as [b1 b2 b3], c as [c1 c2 c3]. unfold all_coordinates. vunfold.
  intros (A1 & A2 & A3) (B1 & B2 & B3) (C1 & C2 & C3). repeat split; now apply triangle_in_rectangle.
Qed.
Lemma dot_within u v s : all_coordinates (fun t => Rabs t <= s) u -> Rabs (dot u v) <= s * one_norm v.
Proof.
  destruct u as [u1 u2 u3], v as [v1 v2 v3]. unfold all_coordinates, one_norm. vunfold. intros (A & B & C).
  pose proof (abs_times _ v1 _ A). pose proof (abs_times _ v2 _ B). pose proof (abs_times _ v3 _ C).
  pose proof (Rabs_triang (u1 * v1 + u2 * v2) (u3 * v3)). pose proof (Rabs_triang (u1 * v1) (u2 * v2)). lra.
Qed.
Lemma one_norm_within x y z v : within x y z v -> one_norm v <= x + y + z.
Proof. intros (X & Y & Z). unfold one_norm. lra. Qed.

(* The parts of the change, with the errors a, b, c, d of the points. *)
Definition first_part (m : points) (a b c d : vec R) :=
  dot b (cross (q_of m) (r_of m)) + dot c (cross (r_of m) (p_of m)) + dot d (cross (p_of m) (q_of m)) -
  dot a (cross (q_of m) (r_of m) + cross (r_of m) (p_of m) + cross (p_of m) (q_of m)).
Definition second_part (m : points) (a b c d : vec R) :=
  triple (b - a) (c - a) (r_of m) + triple (c - a) (d - a) (p_of m) + triple (d - a) (b - a) (q_of m).
Definition moved (m : points) (a b c d : vec R) := Points (pa m + a)%V (pb m + b)%V (pc m + c)%V (pd m + d)%V.
Lemma change_in_parts m a b c d : determinant (moved m a b c d) - determinant m =
  first_part m a b c d + second_part m a b c d + triple (b - a) (c - a) (d - a).
Proof.
  destruct m as [m n k l]. unfold determinant, first_part, second_part, triple, p_of, q_of, r_of, moved. cbn [pa pb pc pd].
  vdestruct. vunfold. ring.
Qed.

Definition are_errors (h : R) (a b c d : vec R) :=
  let ok := all_coordinates (fun t => Rabs t <= h) in ok a /\ ok b /\ ok c /\ ok d.
Lemma first_part_within m a b c d h : are_errors h a b c d -> Rabs (first_part m a b c d) <= h * slopes m.
Proof.
  intros (A & B & C & D). unfold first_part, slopes, sum_of_slopes.
  pose proof (dot_within _ (cross (q_of m) (r_of m)) _ B). pose proof (dot_within _ (cross (r_of m) (p_of m)) _ C).
  pose proof (dot_within _ (cross (p_of m) (q_of m)) _ D).
  pose proof (dot_within _ (cross (q_of m) (r_of m) + cross (r_of m) (p_of m) + cross (p_of m) (q_of m))%V _ A) as S.
  apply abs_le in S. revert S. rewrite !Rmult_plus_distr_l.
  generalize (dot a (cross (q_of m) (r_of m) + cross (r_of m) (p_of m) + cross (p_of m) (q_of m))).
  intros t S. repeat match goal with H : Rabs _ <= _ |- _ => apply abs_le in H end. apply abs_le. lra.
Qed.
Lemma second_part_within m a b c d h x y z : are_errors h a b c d -> extents x y z m ->
  Rabs (second_part m a b c d) <= 3 * (4 * h * h) * (x + y + z).
Proof.
  intros (A & B & C & D) (P & Q & R). unfold second_part, triple.
  pose proof (dot_within _ (r_of m) _ (cross_of_errors _ _ _ _ A B C)).
  pose proof (dot_within _ (p_of m) _ (cross_of_errors _ _ _ _ A C D)).
  pose proof (dot_within _ (q_of m) _ (cross_of_errors _ _ _ _ A D B)).
  apply one_norm_within in P, Q, R. assert (0 <= 4 * h * h) as H4 by nra.
  pose proof (Rmult_le_compat_l _ _ _ H4 P). pose proof (Rmult_le_compat_l _ _ _ H4 Q).
  pose proof (Rmult_le_compat_l _ _ _ H4 R).
  repeat match goal with H : Rabs _ <= _ |- _ => apply abs_le in H end. apply abs_le. lra.
Qed.
(* The third part is linear in the first coordinates of the errors. Its slopes are twice the areas of four triangles in a square
   of the side 2 h. *)
Lemma third_part_within a b c d h : are_errors h a b c d -> Rabs (triple (b - a) (c - a) (d - a)) <= 16 * h * h * h.
Proof.
  destruct a as [a1 a2 a3], b as [b1 b2 b3], c as [c1 c2 c3], d as [d1 d2 d3].
  unfold are_errors, all_coordinates, triple. vunfold.
  intros ((A1 & A2 & A3) & (B1 & B2 & B3) & (C1 & C2 & C3) & (D1 & D2 & D3)).
  pose proof (abs_product _ _ _ _ A1 (triangle_in_rectangle _ _ _ _ _ _ _ _ B2 C2 D2 B3 C3 D3)).
  pose proof (abs_product _ _ _ _ B1 (triangle_in_rectangle _ _ _ _ _ _ _ _ A2 C2 D2 A3 C3 D3)).
  pose proof (abs_product _ _ _ _ C1 (triangle_in_rectangle _ _ _ _ _ _ _ _ A2 D2 B2 A3 D3 B3)).
  pose proof (abs_product _ _ _ _ D1 (triangle_in_rectangle _ _ _ _ _ _ _ _ A2 B2 C2 A3 B3 C3)).
  repeat match goal with H : Rabs (_ * (_ - _)) <= _ |- _ => apply abs_le in H end. apply abs_le. lra.
Qed.

Lemma errors_of h m n : off_by h m n -> exists a b c d, are_errors h a b c d /\ n = moved m a b c d.
Proof.
  intros H. exists (pa n - pa m)%V, (pb n - pb m)%V, (pc n - pc m)%V, (pd n - pd m)%V. split; [exact H|].
  destruct m as [ma mb mc md], n as [na nb nc nd]. unfold moved. cbn [pa pb pc pd]. f_equal; vring.
Qed.
Lemma higher_parts_within m a b c d h x y z : are_errors h a b c d -> extents x y z m ->
  Rabs (second_part m a b c d + triple (b - a) (c - a) (d - a)) <= higher_orders (2 * h) x y z.
Proof.
  intros E X. pose proof (second_part_within _ _ _ _ _ _ _ _ _ E X). pose proof (third_part_within _ _ _ _ _ E).
  pose proof (Rabs_triang (second_part m a b c d) (triple (b - a) (c - a) (d - a))). unfold higher_orders. lra.
Qed.

Theorem changes_by_slopes_holds : changes_by_slopes.
Proof.
  intros m n h x y z H X. destruct (errors_of _ _ _ H) as (a & b & c & d & E & ->). rewrite change_in_parts.
  pose proof (first_part_within m _ _ _ _ _ E). pose proof (higher_parts_within _ _ _ _ _ _ _ _ _ E X).
  pose proof (Rabs_triang (first_part m a b c d) (second_part m a b c d + triple (b - a) (c - a) (d - a))).
  rewrite Rplus_assoc. lra.
Qed.

(* One coordinate of the four slopes. A signed sum of k, l, m and k + l + m is twice one, two or three of k, l and m. *)
Lemma four_areas p1 p2 q1 q2 r1 r2 y z :
  Rabs p1 <= y -> Rabs q1 <= y -> Rabs r1 <= y -> Rabs p2 <= z -> Rabs q2 <= z -> Rabs r2 <= z ->
  let k := q1 * r2 - q2 * r1 in let l := r1 * p2 - r2 * p1 in let m := p1 * q2 - p2 * q1 in
  Rabs k + Rabs l + Rabs m + Rabs (k + l + m) <= 8 * (y * z).
Proof.
  intros P Q R P' Q' R'. cbv zeta.
  pose proof (triangle_in_rectangle _ _ _ _ _ _ _ _ P Q R P' Q' R') as All.
  assert (forall u1 u2 v1 v2, Rabs u1 <= y -> Rabs v1 <= y -> Rabs u2 <= z -> Rabs v2 <= z ->
    Rabs (u1 * v2 - u2 * v1) <= 2 * (y * z)) as One.
  { intros u1 u2 v1 v2 U V U' V'. pose proof (abs_product _ _ _ _ U V') as S. pose proof (abs_product _ _ _ _ V U') as T.
    apply abs_le in S, T. apply abs_le. lra. }
  pose proof (One _ _ _ _ Q R Q' R'). pose proof (One _ _ _ _ R P R' P'). pose proof (One _ _ _ _ P Q P' Q').
  clear One P Q R P' Q' R'.
  apply abs_le in All. repeat match goal with H : Rabs _ <= _ |- _ => apply abs_le in H end.
  unfold Rabs. destruct (Rcase_abs _), (Rcase_abs _), (Rcase_abs _), (Rcase_abs _); lra.
Qed.
Lemma slopes_within m x y z : extents x y z m -> slopes m <= 8 * (x * y + y * z + z * x).
Proof.
  unfold extents, slopes. destruct (p_of m) as [p1 p2 p3], (q_of m) as [q1 q2 q3], (r_of m) as [r1 r2 r3].
  intros ((P1 & P2 & P3) & (Q1 & Q2 & Q3) & (R1 & R2 & R3)). unfold sum_of_slopes, one_norm. vunfold.
  pose proof (four_areas _ _ _ _ _ _ _ _ P2 Q2 R2 P3 Q3 R3). pose proof (four_areas _ _ _ _ _ _ _ _ P3 Q3 R3 P1 Q1 R1).
  pose proof (four_areas _ _ _ _ _ _ _ _ P1 Q1 R1 P2 Q2 R2). cbv zeta in *. lra.
Qed.
Theorem slopes_are_never_looser_holds : slopes_are_never_looser.
Proof.
  intros m h x y z H X. apply slopes_within in X. unfold first_order. pose proof (Rmult_le_compat_l _ _ _ H X). lra.
Qed.
Theorem changes_by_extents_holds : changes_by_extents.
Proof.
  intros m n h x y z H X. pose proof (changes_by_slopes_holds _ _ _ _ _ _ H X).
  assert (0 <= h) as P by (destruct H as ((A & _) & _); exact (abs_nonneg_of _ _ A)).
  pose proof (slopes_are_never_looser_holds _ _ _ _ _ P X). cbv zeta. lra.
Qed.

(* The errors that follow the signs of the slopes. *)
Definition toward (h t : R) := if Rle_dec 0 t then h else - h.
Definition steepest (h : R) (v : vec R) := Vec (toward h (vx v)) (toward h (vy v)) (toward h (vz v)).
Arguments steepest h v%V.
Lemma toward_is_just h t : 0 <= h -> Rabs (toward h t) = h.
Proof. intros H. unfold toward. destruct (Rle_dec 0 t); [|rewrite Rabs_Ropp]; now apply Rabs_pos_eq. Qed.
Lemma toward_times h t : toward h t * t = h * Rabs t.
Proof.
  unfold toward. destruct (Rle_dec 0 t); [rewrite Rabs_pos_eq by auto; ring|]. rewrite Rabs_left by lra. ring.
Qed.
Lemma steepest_dot h v : dot (steepest h v) v = h * one_norm v.
Proof.
  destruct v as [v1 v2 v3]. unfold steepest, one_norm. vunfold. rewrite !Rmult_plus_distr_l, <- !toward_times. reflexivity.
Qed.
Lemma steepest_is_just h v : 0 <= h -> all_coordinates (fun t => Rabs t = h) (steepest h v).
Proof. intros H. repeat split; now apply toward_is_just. Qed.
Lemma just_is_off h v : all_coordinates (fun t => Rabs t = h) v -> all_coordinates (fun t => Rabs t <= h) v.
Proof. intros (X & Y & Z). repeat split; now right. Qed.
Lemma moved_by m a b c d (ok : R -> Prop) : all_coordinates ok a -> all_coordinates ok b -> all_coordinates ok c ->
  all_coordinates ok d -> all_differ ok m (moved m a b c d).
Proof.
  intros A B C D. unfold all_differ, moved. cbn [pa pb pc pd].
  repeat split; match goal with |- ok (_ (?x + ?e - ?x)%V) => replace (x + e - x)%V with e by vring end; firstorder.
Qed.
Theorem slopes_are_reached_holds : slopes_are_reached.
Proof.
  intros m h x y z H X.
  set (u := cross (q_of m) (r_of m)). set (v := cross (r_of m) (p_of m)). set (w := cross (p_of m) (q_of m)).
  set (a := (lzero - steepest h (u + v + w))%V). set (b := steepest h u). set (c := steepest h v). set (d := steepest h w).
  assert (A : all_coordinates (fun t => Rabs t = h) a).
  { destruct (steepest_is_just h (u + v + w)%V H) as (A1 & A2 & A3). unfold a. revert A1 A2 A3.
    destruct (steepest h (u + v + w)) as [a1 a2 a3]. cbn [vx vy vz]. intros A1 A2 A3. unfold all_coordinates. vunfold.
    repeat split; rewrite Rminus_0_l, Rabs_Ropp; auto. }
  pose proof (steepest_is_just h u H) as B. pose proof (steepest_is_just h v H) as C. pose proof (steepest_is_just h w H) as D.
  exists (moved m a b c d). split; [now apply moved_by|]. rewrite change_in_parts.
  assert (E : are_errors h a b c d) by (repeat split; apply just_is_off; assumption).
  pose proof (higher_parts_within _ _ _ _ _ _ _ _ _ E X) as T. apply abs_le in T.
  assert (F : first_part m a b c d = h * slopes m); [|lra].
  unfold first_part, slopes, sum_of_slopes. fold u v w. rewrite !Rmult_plus_distr_l, <- !steepest_dot. fold b c d.
  unfold a. rewrite dot_sub_l, dot_zero_l. lra.
Qed.

(* Three corners of a box that have one minus each, and errors that make the differences' other coordinates longer. *)
Definition corners (x y z : R) := Points (Vec 0 0 0) (Vec (- x) y z) (Vec x (- y) z) (Vec x y (- z)).
Definition grown (h x y z : R) := Points (Vec (- h) (- h) (- h)) (Vec (- x - h) (y + h) (z + h)) (Vec (x + h) (- y - h) (z + h))
  (Vec (x + h) (y + h) (- z - h)).
Lemma corners_are_within x y z : 0 <= x -> 0 <= y -> 0 <= z -> extents x y z (corners x y z).
Proof.
  intros X Y Z. unfold extents, within, p_of, q_of, r_of, corners. cbn [pa pb pc pd]. vunfold. repeat split; apply abs_le; lra.
Qed.
Lemma grown_is_off h x y z : 0 <= h -> off_by_just h (corners x y z) (grown h x y z).
Proof.
  intros H. assert (forall s t, s - t = h \/ s - t = - h -> Rabs (s - t) = h) as G.
  { intros s t [-> | ->]; [|rewrite Rabs_Ropp]; now apply Rabs_pos_eq. }
  unfold off_by_just, all_differ, all_coordinates, corners, grown. cbn [pa pb pc pd]. vunfold.
  repeat split; apply G; first [left; ring | right; ring].
Qed.
Theorem extents_are_reached_holds : extents_are_reached.
Proof.
  intros h x y z H X Y Z. exists (corners x y z), (grown h x y z).
  split; [now apply grown_is_off|]. split; [now apply corners_are_within|].
  unfold determinant, triple, p_of, q_of, r_of, corners, grown, first_order, higher_orders. cbn [pa pb pc pd]. vunfold. ring.
Qed.

Theorem sign_is_kept_holds : sign_is_kept.
Proof.
  intros m n h x y z computed lost H X L. pose proof (changes_by_slopes_holds _ _ _ _ _ _ H X) as C. apply abs_le in C, L.
  cbv zeta. split; lra.
Qed.

(* Where all points are one, slopes are 0. *)
Theorem slopes_suffice_is_false : ~ slopes_suffice.
Proof.
  intros G. assert (I : 0 <= 1) by lra. pose proof (grown_is_off 1 0 0 0 I) as J.
  assert (O : off_by 1 (corners 0 0 0) (grown 1 0 0 0))
    by (destruct J as (A & B & C & D); repeat split; apply just_is_off; assumption).
  specialize (G _ _ _ O). revert G.
  replace (slopes (corners 0 0 0)) with 0.
  - replace (determinant (grown 1 0 0 0) - determinant (corners 0 0 0)) with 16.
    + rewrite Rabs_pos_eq; lra.
    + unfold determinant, triple, p_of, q_of, r_of, corners, grown. cbn [pa pb pc pd]. vunfold. ring.
  - pose proof (slopes_within _ _ _ _ (corners_are_within 0 0 0 (Rle_refl 0) (Rle_refl 0) (Rle_refl 0))) as S.
    assert (0 <= slopes (corners 0 0 0)); [|lra]. unfold slopes, sum_of_slopes, one_norm.
    repeat apply Rplus_le_le_0_compat; apply Rabs_pos.
Qed.

(* The hypotheses can be met: the corners of a cube, and a computed determinant that is nearly theirs. *)
Example errors_instance : off_by (1 / 10) (corners 1 1 1) (grown (1 / 10) 1 1 1) /\ extents 1 1 1 (corners 1 1 1) /\ 0 <= 1 / 10.
Proof.
  assert (H : 0 <= 1 / 10) by lra. split; [|split; [apply corners_are_within; lra|exact H]].
  destruct (grown_is_off (1 / 10) 1 1 1 H) as (A & B & C & D). repeat split; apply just_is_off; assumption.
Qed.
Example sign_instance : let m := corners 1 1 1 in let n := grown (1 / 100) 1 1 1 in
  off_by (1 / 100) m n /\ extents 1 1 1 m /\ Rabs (3 - determinant m) <= 1 /\
  (1 / 100) * slopes m + higher_orders (2 * (1 / 100)) 1 1 1 + 1 < 3.
Proof.
  assert (H : 0 <= 1 / 100) by lra. assert (X : extents 1 1 1 (corners 1 1 1)) by (apply corners_are_within; lra).
  cbv zeta. split; [|split; [exact X|split]].
  - destruct (grown_is_off (1 / 100) 1 1 1 H) as (A & B & C & D). repeat split; apply just_is_off; assumption.
  - replace (determinant (corners 1 1 1)) with 4
      by (unfold determinant, triple, p_of, q_of, r_of, corners; cbn [pa pb pc pd]; vunfold; ring).
    apply abs_le. lra.
  - pose proof (slopes_within _ _ _ _ X). unfold higher_orders. lra.
Qed.
