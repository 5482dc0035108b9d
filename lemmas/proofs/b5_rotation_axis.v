(* SPDX-License-Identifier: MIT *)
(* Beyond the paper: on a twist only the distance from the axis moves. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.b1_rational_bezier_simplex Refitlab.rotation_bound Refitlab.b4_cap_fallback.
Import ListNotations.

(* --- Statements --- *)

(* Im q is parallel to n. *)
Definition turns_about (n : vec R) (q : quat R) := cross (im q) n = lzero.
(* x is split into its part along n and its part across. *)
Definition along (n x : vec R) : vec R := (dot n x / norm2 n *: n)%V.
Definition across (n x : vec R) : vec R := (x - along n x)%V.

(* For every blend b that is not 0, R_b x = a + R_b p, with R_b p perpendicular to n. *)
Definition twist_keeps_axis : Prop :=
  forall (n x : vec R) (qs : list (quat R)) (b : quat R), n <> lzero -> Forall (turns_about n) qs -> in_hull qs b -> b <> lzero ->
  rotate b x = (along n x + rotate b (across n x))%V /\ dot (rotate b (across n x)) n = 0.
(* With a cap about c, a rotation about n too, R_b x is in the ball [a + h R_c p, sqrt(1 - h^2) ||p||]. *)
Definition twist_ball : Prop :=
  forall (n x : vec R) (qs : list (quat R)) (c b : quat R) (kappa2 : R), n <> lzero -> Forall (turns_about n) qs ->
  cap_is_valid qs c kappa2 -> in_hull qs b -> b <> lzero ->
  let h := height kappa2 in
  in_ball (Ball (along n x + h *: rotate c (across n x))%V (sqrt (1 - h * h) * norm (across n x))) (rotate b x).
(* The paper's has the radius sqrt(1 - h^2) ||x||: larger by ||x|| / ||p||, which has no bound. *)
Definition paper_is_looser : Prop :=
  forall n : vec R, n <> lzero -> forall factor : R, exists x, factor * norm (across n x) < norm x.
(* The control points keep the part along the axis too: P_kl(x) - W_kl a = P_kl(p) is perpendicular to n. *)
Definition control_points_keep_axis : Prop :=
  forall (n x : vec R) (p q : quat R), n <> lzero -> turns_about n p -> turns_about n q ->
  (mixed p q x - dot p q *: along n x)%V = mixed p q (across n x) /\ dot (mixed p q (across n x)) n = 0.

(* --- Proofs --- *)

(* Quaternions about n are s + t n. *)
Definition about (s t : R) (n : vec R) : quat R := Quat s (t * vx n) (t * vy n) (t * vz n).
Lemma turns_about_parallel n q : n <> lzero -> turns_about n q -> exists t, q = about (qw q) t n.
Proof.
  intros N C. apply norm2_pos in N. unfold turns_about in C. destruct q as [w x y z], n as [a b c].
  injection C as C1 C2 C3. vunfold. exists ((x * a + y * b + z * c) / (a * a + b * b + c * c)).
  assert (G : forall u v, u * (a * a + b * b + c * c) = (x * a + y * b + z * c) * v ->
    u = (x * a + y * b + z * c) / (a * a + b * b + c * c) * v).
  { intros u v E. apply Rmult_eq_reg_r with (a * a + b * b + c * c); [|lra]. rewrite E. field. lra. }
  unfold about. cbn. f_equal; apply G; apply Rminus_diag_uniq.
  - replace (_ - _) with (b * (x * b - y * a) - c * (z * a - x * c)) by ring. rewrite C2, C3. ring.
  - replace (_ - _) with (c * (y * c - z * b) - a * (x * b - y * a)) by ring. rewrite C1, C3. ring.
  - replace (_ - _) with (a * (z * a - x * c) - b * (y * c - z * b)) by ring. rewrite C1, C2. ring.
Qed.
Lemma turns_about_cone n : cone (turns_about n).
Proof.
  unfold turns_about. split; [vring|intros x y X Y|intros a x _ X].
  - replace (cross (im (x + y)%V) n) with (cross (im x) n + cross (im y) n)%V by vring. rewrite X, Y. vring.
  - replace (cross (im (a *: x)%V) n) with (a *: cross (im x) n)%V by vring. rewrite X. vring.
Qed.

(* They commute with n, and turn a vector across n into one across n. *)
Lemma mixed_along s t s' t' n k : mixed (about s t n) (about s' t' n) (k *: n) =
  (dot (about s t n) (about s' t' n) *: (k *: n))%V.
Proof. unfold mixed. replace (1 / 2) with (/ 2) by field. unfold about. vfield. Qed.
Lemma mixed_across s t s' t' n x : dot (mixed (about s t n) (about s' t' n) x) n =
  (s * s' + t * t' * norm2 n) * dot x n.
Proof. unfold mixed. replace (1 / 2) with (/ 2) by field. unfold about. vfield. Qed.

Lemma across_perpendicular n x : n <> lzero -> dot (across n x) n = 0.
Proof.
  intros N. apply norm2_pos in N. unfold across, along. rewrite dot_sub_l, dot_scale_l. change (dot n n) with (norm2 n).
  rewrite (dot_comm n x). field. lra.
Qed.
Lemma mixed_linear_in_x p q : linear (mixed p q).
Proof. unfold mixed. split; [|split]; intros; generalize (1 / 2); vring. Qed.

Theorem control_points_keep_axis_holds : control_points_keep_axis.
Proof.
  intros n x p q N P Q. destruct (turns_about_parallel n p N P) as (t & Ep). destruct (turns_about_parallel n q N Q) as (t' & Eq).
  rewrite Ep, Eq. split; [|rewrite mixed_across, across_perpendicular by exact N; ring].
  unfold along at 1. rewrite <- mixed_along.
  destruct (mixed_linear_in_x (about (qw p) t n) (about (qw q) t' n)) as (_ & A & S).
  replace x with (across n x + along n x)%V at 1 by (unfold across; vec_ring). rewrite A. unfold along. vec_ring.
Qed.

Theorem twist_keeps_axis_holds : twist_keeps_axis.
Proof.
  intros n x qs b N F (u & (L & P & S) & B) Nb.
  assert (T : turns_about n b) by (rewrite B; apply comb_in_cone; auto; apply turns_about_cone).
  destruct (control_points_keep_axis_holds n x b b N T T) as [K O]. rewrite !mixed_same in *. apply norm2_pos in Nb.
  unfold rotate. split.
  - rewrite <- K. change (dot b b) with (norm2 b). revert Nb. generalize (norm2 b) (turned b x b) (along n x).
    intros m y a Nb. vec_field. lra.
  - rewrite dot_scale_l, O. ring.
Qed.

Theorem twist_ball_holds : twist_ball.
Proof.
  intros n x qs c b kappa2 N F V B Nb h. destruct (twist_keeps_axis_holds n x qs b N F B Nb) as [-> _].
  unfold in_ball. cbn [center radius].
  replace (_ - _)%V with (rotate b (across n x) - h *: rotate c (across n x))%V by vec_ring.
  now apply (fallback_step qs c kappa2 b (across n x)).
Qed.

(* x on the axis: ||p|| = 0. *)
Theorem paper_is_looser_holds : paper_is_looser.
Proof.
  intros n N factor. exists n. replace (across n n) with (lzero : vec R).
  - rewrite norm_zero, Rmult_0_r. now apply norm_pos.
  - unfold across, along. change (dot n n) with (norm2 n). apply norm2_pos in N.
    replace (norm2 n / norm2 n) with 1 by (field; lra). vec_ring.
Qed.

(* The hypotheses can be met: a twist about the x axis with the cap cos alpha = 7/25. *)
Example twist_instance : let n := Vec 1 0 0 in let qs := [Quat (4 / 5) (3 / 5) 0 0; Quat (4 / 5) (- (3 / 5)) 0 0] in
  n <> lzero /\ Forall (turns_about n) qs /\ cap_is_valid qs (Quat 1 0 0 0) (16 / 25) /\ in_hull qs (Quat (4 / 5) 0 0 0).
Proof.
  cbv zeta. split; [apply norm2_pos_inv; vunfold; lra|]. split; [|split].
  - repeat apply Forall_cons; try apply Forall_nil; unfold turns_about; vunfold; f_equal; ring.
  - right. split; [apply norm2_pos_inv; vunfold; lra|]. split; [lra|].
    repeat apply Forall_cons; try apply Forall_nil; split; vunfold; lra.
  - exists [1 / 2; 1 / 2]. split; [repeat split; [repeat constructor; lra|cbn; lra]|]. cbn. vunfold. f_equal; field.
Qed.
