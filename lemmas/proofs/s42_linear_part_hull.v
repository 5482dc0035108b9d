(* SPDX-License-Identifier: MIT *)
(* Section 4.2, the linear part is a hull: the blends of given points are the hull of their blends at the corners. For
   quaternions also section 4.3. It holds as printed. *)
From Coq Require Import List Reals Lra Psatz Lia.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.s41_weight_vertices_span.
Import ListNotations.

(* --- Statement --- *)

(* r'_k = sum_i c_ki r_i (Equation 5). *)
Definition corner_images {E} `{Euclid E} (corners : list (list R)) (points : list E) : list E :=
  map (fun c => comb c points) corners.

(* {sum_i w_i r_i : w in W'} = CH(r'_1, ..., r'_m) *)
Definition linear_part_hull_printed : Prop :=
  forall E (l : Lin R E) (e : Euclid E) bounds corners (points : list E) (x : E),
  lists_corners bounds corners ->
  ((exists w, admits bounds w /\ x = comb w points) <-> in_hull (corner_images corners points) x).

(* --- Proof: swap the sums --- *)

Lemma comb_first {E} `{Euclid E} (w : list R) (p : E) ps : comb w (p :: ps) = (nth 0 w 0%R *: p + comb (tl w) ps)%V.
Proof. destruct w; cbn [comb nth tl]; [vec_ring|reflexivity]. Qed.

(* The operations of R as a vector space are those of R. *)
Ltac numbers := cbn [lzero ladd lsub lscale lin_num zero one add sub mul ops_R].

Lemma swap_sums {E} `{Euclid E} (u : list R) (corners : list (list R)) (w : list R) (points : list E) :
  (forall i, nth i w 0 = comb u (map (fun c => nth i c 0) corners)) ->
  comb w points = comb u (corner_images corners points).
Proof.
  revert w corners; induction points as [|p points IH]; intros w corners W; unfold corner_images in *.
  - destruct w; cbn [comb]; clear - H; revert corners; induction u as [|a u IH]; intros [|c corners]; cbn [map comb];
      try reflexivity; rewrite <- IH; destruct c; cbn [comb]; vec_ring.
  - rewrite comb_first, (W 0%nat), (IH (tl w) (map (@tl R) corners)).
    + rewrite map_map. clear - H. revert corners; induction u as [|a u IH]; intros [|c corners]; cbn [map comb];
        numbers; try vec_ring. rewrite comb_first. specialize (IH corners).
      rewrite <- (IH : _ = comb u (map (fun c => comb c (p :: points)) corners)). vec_ring.
    + intros i. rewrite map_map. specialize (W (S i)). replace (nth i (tl w) 0) with (nth (S i) w 0) by (now destruct w, i).
      rewrite W. f_equal. apply map_ext. intros c. now destruct c, i.
Qed.

(* The weights that convex coefficients make. *)
Lemma combined_weights (u : list R) (corners : list (list R)) n : (forall c, In c corners -> length c = n) ->
  exists w, length w = n /\ forall i, nth i w 0 = comb u (map (fun c => nth i c 0) corners).
Proof.
  intros L. set (f := fun i => comb u (map (fun c => nth i c 0) corners)). exists (map f (seq 0 n)).
  split; [now rewrite map_length, seq_length|]. intros i. destruct (Nat.lt_ge_cases i n) as [I|I].
  - rewrite (nth_indep _ 0 (f 0%nat)) by (now rewrite map_length, seq_length). rewrite map_nth, seq_nth by auto. reflexivity.
  - rewrite nth_overflow by (now rewrite map_length, seq_length). symmetry.
    clear f. revert corners L; induction u as [|a u IH]; intros [|c corners] L; try reflexivity. cbn [map comb].
    rewrite IH by (intros d D; apply L; now right). rewrite nth_overflow by (rewrite (L c); [auto|now left]).
    cbn. ring.
Qed.

Theorem linear_part_hull_holds : linear_part_hull_printed.
Proof.
  intros E l e bounds corners points x C. split.
  - intros (w & W & ->). apply (corners_span_repaired_holds bounds corners w C) in W as (u & U & Q);
      [|apply admits_length in W; congruence].
    exists u. split; [unfold corner_images; now rewrite map_length|]. now apply swap_sums.
  - intros (u & U & ->). unfold corner_images in U. rewrite map_length in U.
    destruct (combined_weights u corners (length bounds)) as (w & L & Q).
    { intros c I. apply C, admits_length in I. congruence. }
    exists w. split; [|symmetry; now apply swap_sums]. apply (corners_span_repaired_holds bounds corners w C L). now exists u.
Qed.

(* The hypothesis can be met: corners_instance. *)
Example linear_part_instance : exists bounds corners, lists_corners bounds corners.
Proof. do 2 eexists. exact corners_instance. Qed.
