(* SPDX-License-Identifier: MIT *)
(* Real inner product spaces: R^d for every d at once. Statements about R^d are proved for any of them; R, R^3, the
   quaternions (R^4) and products of them are instances, and so is every R^d as a product of d times R. *)
From Coq Require Import List Reals Lra Psatz.
Require Import Refitlab.theory.linear.
Import ListNotations.

Class Euclid (E : Type) {l : Lin R E} := {
  dot : E -> E -> R;
  dot_comm : forall x y, dot x y = dot y x;
  dot_zero_l : forall z, dot lzero z = 0;
  dot_add_l : forall x y z, dot (ladd x y) z = dot x z + dot y z;
  dot_sub_l : forall x y z, dot (lsub x y) z = dot x z - dot y z;
  dot_scale_l : forall a x z, dot (lscale a x) z = a * dot x z;
  dot_nonneg : forall x, 0 <= dot x x;
  (* Vectors are equal if all of their dot products are. *)
  dot_ext : forall x y, (forall z, dot x z = dot y z) -> x = y }.
Arguments dot {E l Euclid} (x y)%V.

Definition norm2 {E} `{Euclid E} (x : E) := dot x x.
Definition norm {E} `{Euclid E} (x : E) := sqrt (norm2 x).
Arguments norm2 {E l H} x%V.
Arguments norm {E l H} x%V.

(* --- Tactics --- *)

(* Into coordinates, where a polynomial identity is left. *)
Ltac vunfold :=
  cbv [norm2 dot turned pure im conj qmul qdot vdot cross lin_num lin_vec lin_quat lin_pair lzero ladd lsub lscale
       qw qx qy qz vx vy vz fst snd zero one add sub mul ops_R] in *.
Ltac vdestruct := repeat match goal with
  | v : vec R |- _ => destruct v | q : quat R |- _ => destruct q | p : (_ * _)%type |- _ => destruct p end.
Ltac veq := match goal with |- @eq R _ _ => ring | |- _ => progress f_equal; veq end.
Ltac vring := intros; vdestruct; vunfold; veq.
Ltac vfield_ := match goal with |- @eq R _ _ => field; try lra; auto | |- _ => progress f_equal; vfield_ end.
Ltac vfield := intros; vdestruct; vunfold; vfield_.

(* The axioms of the instances are lemmas of their own, so that computing does not look into their proofs. *)
Lemma vec_ext (x y : vec R) : (forall z, vdot x z = vdot y z) -> x = y.
Proof.
  destruct x as [a b c], y as [d e f]. intros H. pose proof (H (Vec 1 0 0)). pose proof (H (Vec 0 1 0)).
  pose proof (H (Vec 0 0 1)). vunfold. f_equal; lra.
Qed.
Lemma quat_ext (x y : quat R) : (forall z, qdot x z = qdot y z) -> x = y.
Proof.
  destruct x as [a b c g], y as [d e f h]. intros H. pose proof (H (Quat 1 0 0 0)). pose proof (H (Quat 0 1 0 0)).
  pose proof (H (Quat 0 0 1 0)). pose proof (H (Quat 0 0 0 1)). vunfold. f_equal; lra.
Qed.

#[global] Instance euclid_R : Euclid R.
Proof.
  refine {| dot := Rmult |}; abstract first [vring | intros; nra | intros x y H; specialize (H 1); lra].
Defined.
#[global] Instance euclid_vec : Euclid (vec R).
Proof. refine {| dot := vdot |}; abstract first [vring | exact vec_ext | intros []; vunfold; nra]. Defined.
#[global] Instance euclid_quat : Euclid (quat R).
Proof. refine {| dot := qdot |}; abstract first [vring | exact quat_ext | intros []; vunfold; nra]. Defined.

Section Pairs.
Context {X Y : Type} {lx : Lin R X} {ly : Lin R Y} {ex : Euclid X} {ey : Euclid Y}.
Definition pdot (p q : X * Y) := dot (fst p) (fst q) + dot (snd p) (snd q).
Lemma pair_ext (p q : X * Y) : (forall z, pdot p z = pdot q z) -> p = q.
Proof.
  destruct p as [a b], q as [c d]. unfold pdot. cbn. intros H. f_equal; apply dot_ext; intro z.
  - specialize (H (z, lzero)). cbn in H. rewrite !(dot_comm _ lzero), !dot_zero_l in H. lra.
  - specialize (H (lzero, z)). cbn in H. rewrite !(dot_comm _ lzero), !dot_zero_l in H. lra.
Qed.
Lemma pdot_nonneg (p : X * Y) : 0 <= pdot p p.
Proof. unfold pdot. pose proof (dot_nonneg (fst p)). pose proof (dot_nonneg (snd p)). lra. Qed.
End Pairs.
#[global] Instance euclid_pair (X Y : Type) {lx : Lin R X} {ly : Lin R Y} {ex : Euclid X} {ey : Euclid Y} :
  Euclid (X * Y).
Proof.
  refine {| dot := pdot; dot_nonneg := pdot_nonneg; dot_ext := pair_ext |}; intros; unfold pdot; cbn;
    abstract (rewrite ?(dot_comm (fst x) (fst y)), ?(dot_comm (snd x) (snd y)), ?dot_zero_l, ?dot_add_l, ?dot_sub_l,
      ?dot_scale_l; ring).
Defined.

Ltac vunfold ::=
  cbv [norm2 dot euclid_R euclid_vec euclid_quat euclid_pair pdot
       turned pure im conj qmul qdot vdot cross lin_num lin_vec lin_quat lin_pair lzero ladd lsub lscale
       qw qx qy qz vx vy vz fst snd zero one add sub mul ops_R] in *.

(* The plane, where most counterexamples live. *)
Notation plane := (R * R)%type.

Section Facts.
Context {E : Type} `{Euclid E}.
Implicit Types x y z v w : E.

Lemma dot_zero_r x : dot x lzero = 0.
Proof. rewrite dot_comm. apply dot_zero_l. Qed.
Lemma dot_add_r x y z : dot x (y + z) = dot x y + dot x z.
Proof. now rewrite dot_comm, dot_add_l, (dot_comm y), (dot_comm z). Qed.
Lemma dot_sub_r x y z : dot x (y - z) = dot x y - dot x z.
Proof. now rewrite dot_comm, dot_sub_l, (dot_comm y), (dot_comm z). Qed.
Lemma dot_scale_r a x y : dot x (a *: y) = a * dot x y.
Proof. now rewrite dot_comm, dot_scale_l, dot_comm. Qed.
End Facts.

#[global] Hint Rewrite @dot_zero_l @dot_zero_r @dot_add_l @dot_add_r @dot_sub_l @dot_sub_r @dot_scale_l @dot_scale_r : dots.

(* Dot products of sums are sums of dot products; of dot x y and dot y x only one is left. *)
Ltac dots_sort := repeat match goal with
  | |- context [dot ?x ?y] => match goal with
    | |- context [dot y x] => tryif constr_eq x y then fail else rewrite (dot_comm y x) end end.
Ltac dots := unfold norm2; autorewrite with dots; dots_sort.
Ltac dots_sort_in H := repeat match type of H with
  | context [dot ?x ?y] => match type of H with
    | context [dot y x] => tryif constr_eq x y then fail else rewrite (dot_comm y x) in H end end.
Ltac dots_in H := unfold norm2 in H; autorewrite with dots in H; dots_sort_in H.
(* Equality of vectors of any space. *)
Ltac vec_ring := apply dot_ext; let z := fresh "z" in intro z; dots; ring.
Ltac vec_field := apply dot_ext; let z := fresh "z" in intro z; dots; field.

Lemma sq_le_inv (a b : R) : 0 <= b -> a * a <= b * b -> a <= b.
Proof. intros; nra. Qed.
Lemma sq_eq_inv (a b : R) : 0 <= a -> 0 <= b -> a * a = b * b -> a = b.
Proof. intros; nra. Qed.
Lemma inv_pos (a : R) : 0 < a -> 0 < / a.
Proof. apply Rinv_0_lt_compat. Qed.

Section Norms.
Context {E : Type} `{Euclid E}.
Implicit Types x y z v w c : E.

Lemma norm2_nonneg x : 0 <= norm2 x.
Proof. apply dot_nonneg. Qed.
Lemma norm_nonneg x : 0 <= norm x.
Proof. apply sqrt_pos. Qed.
Lemma norm_sq x : norm x * norm x = norm2 x.
Proof. apply sqrt_sqrt, norm2_nonneg. Qed.

Lemma cauchy x y : dot x y * dot x y <= norm2 x * norm2 y.
Proof.
  pose proof (norm2_nonneg x) as X. pose proof (norm2_nonneg y) as Y.
  destruct (Rle_lt_or_eq_dec _ _ Y) as [P|Z].
  - pose proof (norm2_nonneg (norm2 y *: x - dot x y *: y)%V) as G.
    replace (norm2 (norm2 y *: x - dot x y *: y)) with (norm2 y * (norm2 x * norm2 y - dot x y * dot x y)) in G
      by (dots; ring). nra.
  - destruct (Req_dec (dot x y) 0) as [->|N]; [nra|]. exfalso.
    set (s := (norm2 x + 1) / (dot x y * dot x y)).
    pose proof (norm2_nonneg (x - (s * dot x y) *: y)%V) as G.
    replace (norm2 (x - (s * dot x y) *: y)) with
      (norm2 x - 2 * (s * (dot x y * dot x y)) + s * dot x y * (s * dot x y) * norm2 y) in G by (dots; ring).
    rewrite <- Z in G. replace (s * (dot x y * dot x y)) with (norm2 x + 1) in G by (unfold s; field; auto). lra.
Qed.

Lemma norm2_zero : norm2 (lzero : E) = 0.
Proof. unfold norm2. apply dot_zero_l. Qed.
Lemma norm_zero : norm (lzero : E) = 0.
Proof. unfold norm. now rewrite norm2_zero, sqrt_0. Qed.
Lemma norm2_zero_inv x : norm2 x = 0 -> x = lzero.
Proof.
  intros Z. apply dot_ext. intro z. rewrite dot_zero_l. pose proof (cauchy x z) as C. rewrite Z in C. nra.
Qed.
Lemma norm2_pos x : x <> lzero -> 0 < norm2 x.
Proof.
  intros N. destruct (Rle_lt_or_eq_dec _ _ (norm2_nonneg x)) as [|Z]; auto. exfalso. apply N. now apply norm2_zero_inv.
Qed.
Lemma norm2_pos_inv x : 0 < norm2 x -> x <> lzero.
Proof. intros P ->. rewrite norm2_zero in P. lra. Qed.
Lemma norm_pos x : x <> lzero -> 0 < norm x.
Proof. intros N. now apply sqrt_lt_R0, norm2_pos. Qed.

(* ||x|| <= t without a root. *)
Lemma norm_le x t : norm x <= t <-> 0 <= t /\ norm2 x <= t * t.
Proof. rewrite <- norm_sq. pose proof (norm_nonneg x). split; [intros; split|intros []]; nra. Qed.
Lemma norm_eq x t : 0 <= t -> norm2 x = t * t -> norm x = t.
Proof. intros T N. apply sq_eq_inv; auto using norm_nonneg. now rewrite norm_sq. Qed.
Lemma norm_unit x : norm2 x = 1 -> norm x = 1.
Proof. intros U. apply norm_eq; lra. Qed.

Lemma dot_le_norms x y : dot x y <= norm x * norm y.
Proof.
  apply sq_le_inv; [apply Rmult_le_pos; apply norm_nonneg|].
  replace (norm x * norm y * (norm x * norm y)) with ((norm x * norm x) * (norm y * norm y)) by ring.
  rewrite !norm_sq. apply cauchy.
Qed.
Lemma dot_ge_norms x y : - (norm x * norm y) <= dot x y.
Proof.
  cut (- dot x y <= norm x * norm y); [lra|]. apply sq_le_inv; [apply Rmult_le_pos; apply norm_nonneg|].
  replace (norm x * norm y * (norm x * norm y)) with ((norm x * norm x) * (norm y * norm y)) by ring.
  rewrite !norm_sq. replace (- dot x y * - dot x y) with (dot x y * dot x y) by ring. apply cauchy.
Qed.

Lemma norm_add x y : norm (x + y) <= norm x + norm y.
Proof.
  apply norm_le. pose proof (norm_nonneg x). pose proof (norm_nonneg y). split; [lra|].
  replace (norm2 (x + y)) with (norm2 x + 2 * dot x y + norm2 y) by (dots; ring).
  rewrite <- !norm_sq. pose proof (dot_le_norms x y). nra.
Qed.
Lemma norm2_scale a x : norm2 (a *: x) = a * a * norm2 x.
Proof. dots. ring. Qed.
Lemma norm_scale a x : 0 <= a -> norm (a *: x) = a * norm x.
Proof.
  intros A. apply norm_eq; [apply Rmult_le_pos; auto using norm_nonneg|]. rewrite norm2_scale, <- norm_sq. ring.
Qed.
Lemma norm_scale_abs a x : norm (a *: x) = Rabs a * norm x.
Proof.
  apply norm_eq; [apply Rmult_le_pos; auto using Rabs_pos, norm_nonneg|]. rewrite norm2_scale, <- norm_sq.
  transitivity (Rabs a * Rabs a * (norm x * norm x)); [|ring]. now rewrite <- Rabs_mult, (Rabs_pos_eq (a * a)) by apply Rle_0_sqr.
Qed.
Lemma norm_opposite x y : norm (x - y) = norm (y - x).
Proof. unfold norm. f_equal. dots. ring. Qed.
Lemma norm_sub x y : norm (x - y) <= norm x + norm y.
Proof.
  apply norm_le. pose proof (norm_nonneg x). pose proof (norm_nonneg y). split; [lra|].
  replace (norm2 (x - y)) with (norm2 x - 2 * dot x y + norm2 y) by (dots; ring).
  rewrite <- !norm_sq. pose proof (dot_ge_norms x y). nra.
Qed.
(* From x to z by way of y. *)
Lemma norm_triangle x y z : norm (x - z) <= norm (x - y) + norm (y - z).
Proof. replace (x - z)%V with ((x - y) + (y - z))%V by vec_ring. apply norm_add. Qed.
Lemma unit_not_zero x : norm2 x = 1 -> x <> lzero.
Proof. intros U. apply norm2_pos_inv. lra. Qed.
End Norms.

(* --- A vector with a factor of its own for each axis --- *)

Definition scaled (s y : vec R) := Vec (vx s * vx y) (vy s * vy y) (vz s * vz y).
(* No factor is greater than f. *)
Definition factors_within (s : vec R) (f : R) := Rabs (vx s) <= f /\ Rabs (vy s) <= f /\ Rabs (vz s) <= f.
Lemma factor_nonneg s f : factors_within s f -> 0 <= f.
Proof. intros (F & _). pose proof (Rabs_pos (vx s)). lra. Qed.
Lemma scaled_sub (s x y : vec R) : (scaled s x - scaled s y)%V = scaled s (x - y)%V.
Proof. unfold scaled. vring. Qed.
Lemma square_of_factor (a f x : R) : Rabs a <= f -> a * x * (a * x) <= f * f * (x * x).
Proof.
  intros A. assert (B : a * a <= f * f).
  { pose proof (Rabs_pos a). assert (Rabs a * Rabs a <= f * f) by nra. rewrite <- Rabs_mult in *.
    pose proof (Rle_abs (a * a)). lra. }
  pose proof (Rle_0_sqr x) as X. unfold Rsqr in X. nra.
Qed.
Lemma scaled_norm (s y : vec R) (f : R) : factors_within s f -> norm (scaled s y) <= f * norm y.
Proof.
  intros (X & Y & Z). pose proof (factor_nonneg s f (Logic.conj X (Logic.conj Y Z))) as F. apply norm_le.
  split; [apply Rmult_le_pos; [exact F|apply norm_nonneg]|].
  assert (Q : f * norm y * (f * norm y) = f * f * norm2 y) by (rewrite <- (norm_sq y); ring). rewrite Q. clear Q.
  pose proof (square_of_factor _ f (vx y) X). pose proof (square_of_factor _ f (vy y) Y). pose proof (square_of_factor _ f (vz y) Z).
  destruct s, y. unfold scaled. vunfold. lra.
Qed.

(* --- Balls --- *)

Record ball (E : Type) := Ball { center : E; radius : R }.
Arguments Ball {E}. Arguments center {E}. Arguments radius {E}.

Definition in_ball {E} `{Euclid E} (b : ball E) (x : E) := norm (x - center b) <= radius b.
Arguments in_ball {E l H} b x%V.
(* The ball holds another one. *)
Definition holds_ball {E} `{Euclid E} (b inner : ball E) := norm (center inner - center b) + radius inner <= radius b.

Lemma holds_ball_point {E} `{Euclid E} (b inner : ball E) x : holds_ball b inner -> in_ball inner x -> in_ball b x.
Proof.
  unfold holds_ball, in_ball. intros A B. pose proof (norm_triangle x (center inner) (center b)). lra.
Qed.
