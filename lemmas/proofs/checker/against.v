(* SPDX-License-Identifier: MIT *)
(* A certificate against the document of its model: an accepted one is about all vertices of a node's triangles, as the model
   has them. The program, what it claims, and the proof over any exact numbers. *)
From Coq Require Import List Reals Lia Bool PeanoNat PArith FMapPositive.
Require Import Refitlab.theory.linear Refitlab.theory.euclid.
Require Import Refitlab.checker.certificate Refitlab.checker.check Refitlab.checker.exact Refitlab.checker.sound.
Import ListNotations.

(* --- The documents. Vertices are numbered from 1. --- *)

Record point T := Point { place : vec T; influences : list nat; masses : list T }.
Arguments Point {T}. Arguments place {T}. Arguments influences {T}. Arguments masses {T}.
(* By node, the first of its triangles and how many there are. *)
Record model T := Model { points : list (point T); triangles : list (positive * positive * positive); nodes : list (nat * nat) }.
Arguments Model {T}. Arguments points {T}. Arguments triangles {T}. Arguments nodes {T}.
(* The numbers of the certificate's vertices, and of the joints of its joint-sets. *)
Record named T := Named { stated : certificate T; node : nat; numbers : list positive; joints : list (list nat) }.
Arguments Named {T}. Arguments stated {T}. Arguments node {T}. Arguments numbers {T}. Arguments joints {T}.

Definition triangles_of {T} (m : model T) (range : nat * nat) := firstn (snd range) (skipn (fst range) (triangles m)).
Definition is_vertex_of (k : positive) (t : positive * positive * positive) := k = fst (fst t) \/ k = snd (fst t) \/ k = snd t.

(* --- The program --- *)

Fixpoint list_eqb {X} (same : X -> X -> bool) (xs ys : list X) : bool :=
  match xs, ys with
  | [], [] => true
  | x :: xs', y :: ys' => same x y && list_eqb same xs' ys'
  | _, _ => false
  end.
(* Every second element of a list, from the first on, and then the others. *)
Fixpoint alternate {X} (xs : list X) : list X * list X :=
  match xs with [] => ([], []) | x :: t => let others := alternate t in (x :: snd others, fst others) end.
(* A list as a table by number: the even numbers are left of 1, and the odd ones right. *)
Fixpoint table_of_depth {X} (depth : nat) (xs : list X) : PositiveMap.t X :=
  match depth, xs with
  | S d, x :: t => let rest := alternate t in
      PositiveMap.Node (table_of_depth d (fst rest)) (Some x) (table_of_depth d (snd rest))
  | _, _ => PositiveMap.empty X
  end.
Definition numbered {X} (xs : list X) : PositiveMap.t X := table_of_depth (length xs) xs.
(* The numbers of a list as a set. *)
Definition set_of (ks : list positive) : PositiveMap.t unit := fold_right (fun k => PositiveMap.add k tt) (PositiveMap.empty unit) ks.

Section Against.
Context {T : Type} {n : Num T}.

Definition vec_eqb (a b : vec T) : bool := eqb (vx a) (vx b) && eqb (vy a) (vy b) && eqb (vz a) (vz b).
(* The vertex is that of the model, and the joint-set of its piece is of the joints that it has there. *)
Definition check_named (table : PositiveMap.t (point T)) (c : named T) (listed : positive * vertex T) : bool :=
  match PositiveMap.find (fst listed) table, nth_error (pieces (stated c)) (piece_of_vertex (snd listed)) with
  | Some p, Some pc =>
      match nth_error (joints c) (set_of_piece pc) with
      | Some js => list_eqb Nat.eqb js (influences p) && vec_eqb (position (snd listed)) (place p)
                   && list_eqb eqb (weights (snd listed)) (masses p)
      | None => false
      end
  | _, _ => false
  end.
(* The table of a model serves all certificates that are checked against it. *)
Definition check_against (m : model T) : named T -> bool :=
  let table := numbered (points m) in fun c =>
  let listed := combine (numbers c) (vertices (stated c)) in
  let known := set_of (map fst listed) in
  match nth_error (nodes m) (node c) with
  | None => false
  | Some range =>
      check (stated c) && forallb (check_named table c) listed
      && forallb (fun t => PositiveMap.mem (fst (fst t)) known && PositiveMap.mem (snd (fst t)) known
                           && PositiveMap.mem (snd t) known) (triangles_of m range)
  end.
End Against.

(* --- The claim --- *)

(* The ball holds each vertex of the node's triangles, skinned exactly by its position, joints and weights in the model. *)
Definition node_is_held (m : model R) (c : named R) : Prop :=
  exists range, nth_error (nodes m) (node c) = Some range /\
  forall t k, In t (triangles_of m range) -> is_vertex_of k t ->
  exists p i js, nth_error (points m) (Pos.to_nat k - 1) = Some p /\ nth_error (joints c) i = Some (influences p) /\
  nth_error (joint_sets (stated c)) i = Some js /\
  (is_skinned js (masses p) -> in_ball (as_ball (enclosing (stated c))) (skin js (masses p) (place p))).

Section Values.
Context {T : Type} (value : T -> R).
Definition point_map (p : point T) : point R := Point (vmap value (place p)) (influences p) (map value (masses p)).
Definition model_map (m : model T) : model R := Model (map point_map (points m)) (triangles m) (nodes m).
Definition named_map (c : named T) : named R := Named (certificate_map value (stated c)) (node c) (numbers c) (joints c).
End Values.

(* --- Proof --- *)

Lemma alternate_is {X} (xs : list X) :
  (forall i, nth_error (fst (alternate xs)) i = nth_error xs (2 * i)) /\
  (forall i, nth_error (snd (alternate xs)) i = nth_error xs (S (2 * i))) /\
  (length (fst (alternate xs)) <= length xs)%nat /\ (length (snd (alternate xs)) <= length xs)%nat.
Proof.
  induction xs as [|x xs (Even & Odd & Lf & Ls)]; cbn [alternate fst snd length].
  - repeat split; intros; try lia; destruct i; reflexivity.
  - split; [|split; [|split; lia]]; intros i.
    + destruct i as [|i]; [reflexivity|]. cbn [nth_error]. rewrite Odd. now replace (2 * S i)%nat with (S (S (2 * i))) by lia.
    + now rewrite Even.
Qed.
Lemma table_of_depth_is {X} d (xs : list X) k : (length xs <= d)%nat ->
  PositiveMap.find k (table_of_depth d xs) = nth_error xs (Pos.to_nat k - 1).
Proof.
  revert xs k; induction d as [|d IH]; intros [|x t] k L; cbn [table_of_depth];
    try (rewrite PositiveMap.gempty; now destruct (_ - _)%nat).
  destruct (alternate_is t) as (Even & Odd & Lf & Ls). cbn [length] in L. pose proof (fun k => Pos2Nat.is_pos k) as P.
  destruct k as [k|k|]; cbn [PositiveMap.find]; [| |reflexivity]; rewrite IH by lia; specialize (P k).
  - rewrite Odd, Pos2Nat.inj_xI. now replace (S (2 * Pos.to_nat k) - 1)%nat with (S (S (2 * (Pos.to_nat k - 1)))) by lia.
  - rewrite Even, Pos2Nat.inj_xO. now replace (2 * Pos.to_nat k - 1)%nat with (S (2 * (Pos.to_nat k - 1))) by lia.
Qed.
Lemma numbered_is {X} (xs : list X) k : PositiveMap.find k (numbered xs) = nth_error xs (Pos.to_nat k - 1).
Proof. now apply table_of_depth_is. Qed.
Lemma set_of_sound ks k : PositiveMap.mem k (set_of ks) = true -> In k ks.
Proof.
  unfold set_of. rewrite PositiveMap.mem_find. induction ks as [|j ks IH]; cbn [fold_right]; [rewrite PositiveMap.gempty; discriminate|].
  destruct (Pos.eq_dec k j) as [->|N]; [now left|]. rewrite PositiveMap.gso by exact N. intros F. right. now apply IH.
Qed.

Section Soundness.
Context {T : Type} {n : Num T} (value : T -> R) {ex : Exact value}.

Lemma numbers_equal xs ys : list_eqb eqb xs ys = true -> map value xs = map value ys.
Proof.
  revert ys; induction xs as [|x xs IH]; intros [|y ys]; cbn [list_eqb map]; try discriminate; [reflexivity|].
  rewrite andb_true_iff. intros [A B]. apply (eqb_sound value) in A. now rewrite A, (IH ys).
Qed.
Lemma joints_equal xs ys : list_eqb Nat.eqb xs ys = true -> xs = ys.
Proof.
  revert ys; induction xs as [|x xs IH]; intros [|y ys]; cbn [list_eqb]; try discriminate; [reflexivity|].
  rewrite andb_true_iff, Nat.eqb_eq. intros [-> B]. now rewrite (IH ys).
Qed.
Lemma vec_equal a b : vec_eqb a b = true -> vmap value a = vmap value b.
Proof.
  unfold vec_eqb, vmap. rewrite !andb_true_iff. intros [[A B] C]. apply (eqb_sound value) in A, B, C. now rewrite A, B, C.
Qed.

Lemma check_against_sound (m : model T) (c : named T) :
  check_against m c = true -> node_is_held (model_map value m) (named_map value c).
Proof.
  unfold check_against, node_is_held. cbn [model_map named_map nodes node points joints stated].
  destruct (nth_error (nodes m) (node c)) as [range|]; [|discriminate]. rewrite !andb_true_iff, !forallb_forall.
  intros [[C V] K]. exists range. split; [reflexivity|]. intros t k It Ik.
  apply (check_is_sound value) in C as [H _]. cbn [certificate_map vertices joint_sets] in H.
  assert (M : exists v, In (k, v) (combine (numbers c) (vertices (stated c)))).
  { specialize (K t It). rewrite !andb_true_iff in K. destruct K as [[A B] D].
    assert (J : In k (map fst (combine (numbers c) (vertices (stated c))))).
    { apply set_of_sound. destruct Ik as [->|[->| ->]]; assumption. }
    apply in_map_iff in J as ([j v] & <- & J). now exists v. }
  destruct M as (v & I). specialize (V _ I). unfold check_named in V. cbn [fst snd] in V.
  destruct (PositiveMap.find k (numbered (points m))) as [p|] eqn:F; [|discriminate].
  destruct (nth_error (pieces (stated c)) (piece_of_vertex v)) as [pc|] eqn:P; [|discriminate].
  destruct (nth_error (joints c) (set_of_piece pc)) as [js|] eqn:J; [|discriminate].
  rewrite !andb_true_iff in V. destruct V as [[A B] W].
  apply joints_equal in A. apply vec_equal in B. apply numbers_equal in W. subst js.
  rewrite numbered_is in F.
  apply in_combine_r in I. apply (in_map (vertex_map value)) in I. destruct (H _ I) as (js & S & G).
  unfold set_at in S. cbn [certificate_map pieces joint_sets vertex_map piece_of_vertex] in S.
  rewrite (map_nth_error (piece_map value) _ _ P) in S. cbn [piece_map set_of_piece] in S.
  exists (point_map value p), (set_of_piece pc), js. split; [now apply map_nth_error|]. split; [exact J|].
  split; [exact S|]. cbn [point_map masses place]. rewrite <- B, <- W. exact G.
Qed.
End Soundness.
