(* SPDX-License-Identifier: MIT *)
(* Section 4.2, the linear part is a hull: the blends of given points are the hull of their blends at the weight vertices. For
   quaternions also section 4.3. It holds as printed. *)
From Coq Require Import List Reals Lra Psatz Lia.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.s41_weight_vertices_span.
Import ListNotations.

(* --- Statement --- *)

(* r'_k = sum_i c_ki r_i (Equation 5). *)
Definition weight_vertex_images {E} `{Euclid E} (weight_vertices : list (list R)) (points : list E) : list E :=
  map (fun c => comb c points) weight_vertices.

(* {sum_i w_i r_i : w in W'} = CH(r'_1, ..., r'_m) *)
Definition linear_part_hull_printed : Prop :=
  forall E (l : Lin R E) (e : Euclid E) bounds weight_vertices (points : list E) (x : E),
  lists_weight_vertices bounds weight_vertices ->
  ((exists w, admits bounds w /\ x = comb w points) <-> in_hull (weight_vertex_images weight_vertices points) x).

(* --- Proof: swap the sums --- *)

Lemma comb_first {E} `{Euclid E} (w : list R) (p : E) ps : comb w (p :: ps) = (nth 0 w 0%R *: p + comb (tl w) ps)%V.
Proof. destruct w; cbn [comb nth tl]; [vec_ring|reflexivity]. Qed.

(* The operations of R as a vector space are those of R. *)
Ltac numbers := cbn [lzero ladd lsub lscale lin_num zero one add sub mul ops_R].

Lemma swap_sums {E} `{Euclid E} (u : list R) (weight_vertices : list (list R)) (w : list R) (points : list E) :
  (forall i, nth i w 0 = comb u (map (fun c => nth i c 0) weight_vertices)) ->
  comb w points = comb u (weight_vertex_images weight_vertices points).
Proof.
  revert w weight_vertices; induction points as [|p points IH]; intros w weight_vertices W; unfold weight_vertex_images in *.
  - destruct w; cbn [comb]; clear - H; revert weight_vertices; induction u as [|a u IH]; intros [|c weight_vertices];
    cbn [map comb];
      try reflexivity; rewrite <- IH; destruct c; cbn [comb]; vec_ring.
  - rewrite comb_first, (W 0%nat), (IH (tl w) (map (@tl R) weight_vertices)).
    + rewrite map_map. clear - H. revert weight_vertices; induction u as [|a u IH]; intros [|c weight_vertices];
      cbn [map comb];
        numbers; try vec_ring. rewrite comb_first. specialize (IH weight_vertices).
      rewrite <- (IH : _ = comb u (map (fun c => comb c (p :: points)) weight_vertices)). vec_ring.
    + intros i. rewrite map_map. specialize (W (S i)). replace (nth i (tl w) 0) with (nth (S i) w 0) by (now destruct w, i).
      rewrite W. f_equal. apply map_ext. intros c. now destruct c, i.
Qed.

(* The weights that convex coefficients make. *)
Lemma combined_weights (u : list R) (weight_vertices : list (list R)) n : (forall c, In c weight_vertices -> length c = n) ->
  exists w, length w = n /\ forall i, nth i w 0 = comb u (map (fun c => nth i c 0) weight_vertices).
Proof.
  intros L. set (f := fun i => comb u (map (fun c => nth i c 0) weight_vertices)). exists (map f (seq 0 n)).
  split; [now rewrite map_length, seq_length|]. intros i. destruct (Nat.lt_ge_cases i n) as [I|I].
  - rewrite (nth_indep _ 0 (f 0%nat)) by (now rewrite map_length, seq_length). rewrite map_nth, seq_nth by auto. reflexivity.
  - rewrite nth_overflow by (now rewrite map_length, seq_length). symmetry.
    clear f. revert weight_vertices L; induction u as [|a u IH]; intros [|c weight_vertices] L; try reflexivity.
      cbn [map comb].
    rewrite IH by (intros d D; apply L; now right). rewrite nth_overflow by (rewrite (L c); [auto|now left]).
    cbn. ring.
Qed.

Theorem linear_part_hull_holds : linear_part_hull_printed.
Proof.
  intros E l e bounds weight_vertices points x C. split.
  - intros (w & W & ->). apply (weight_vertices_span_repaired_holds bounds weight_vertices w C) in W as (u & U & Q);
      [|apply admits_length in W; congruence].
    exists u. split; [unfold weight_vertex_images; now rewrite map_length|]. now apply swap_sums.
  - intros (u & U & ->). unfold weight_vertex_images in U. rewrite map_length in U.
    destruct (combined_weights u weight_vertices (length bounds)) as (w & L & Q).
    { intros c I. apply C, admits_length in I. congruence. }
    exists w. split; [|symmetry; now apply swap_sums]. apply (weight_vertices_span_repaired_holds bounds weight_vertices
      w C L). now exists u.
Qed.

(* The hypothesis can be met: weight_vertices_instance. *)
Example linear_part_instance : exists bounds weight_vertices, lists_weight_vertices bounds weight_vertices.
Proof. do 2 eexists. exact weight_vertices_instance. Qed.
