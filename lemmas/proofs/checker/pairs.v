(* SPDX-License-Identifier: MIT *)
(* Certificates of which triangles of two posed characters meet (algorithms/certificate/pairs_certificate.hpp): the document,
   what an accepted one claims, the program, and the proof over any exact numbers. *)
From Coq Require Import List Permutation FinFun Reals Lra Lia Bool PeanoNat PArith FMapPositive SetoidList.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex.
Require Import Refitlab.checker.certificate Refitlab.checker.check Refitlab.checker.exact Refitlab.checker.sound.
Require Import Refitlab.checker.against.
Import ListNotations.

(* --- The document. Vertices and triangles are numbered from 1. --- *)

Record body T := Body { corners : list (vec T); faces : list (positive * positive * positive) }.
Arguments Body {T}. Arguments corners {T}. Arguments faces {T}.

(* A triangle of each body, and the weights of the corners of each that make the same point. *)
Record contact T := Contact { meeting : positive * positive; first_weights : list T; second_weights : list T }.
Arguments Contact {T}. Arguments meeting {T}. Arguments first_weights {T}. Arguments second_weights {T}.

(* What to do with a set of triangles of the first body and one of the second. Before a plane are all points x with
   (normal, x) < offset; it parts the two sets if one is before it and the other is behind. *)
Inductive step T := Plane (normal : vec T) (offset : T) | Halve_first | Halve_second | Touch.
Arguments Plane {T}. Arguments Halve_first {T}. Arguments Halve_second {T}. Arguments Touch {T}.

(* The orders say how the triangles are halved. *)
Record pairs T := Pairs {
  first : body T; second : body T; first_order : list positive; second_order : list positive; steps : list (step T);
  contacts : list (contact T) }.
Arguments Pairs {T}. Arguments first {T}. Arguments second {T}. Arguments first_order {T}. Arguments second_order {T}.
Arguments steps {T}. Arguments contacts {T}.

(* --- The claim --- *)

(* The corners of a triangle, if it and they are there. *)
Definition corner_at {T} (b : body T) (k : positive) : option (vec T) := nth_error (corners b) (Pos.to_nat k - 1).
Definition face_at {T} (b : body T) (k : positive) := nth_error (faces b) (Pos.to_nat k - 1).
Definition triangle_at {T} (b : body T) (k : positive) : option (list (vec T)) :=
  match face_at b k with
  | Some (i, j, l) =>
      match corner_at b i, corner_at b j, corner_at b l with Some p, Some q, Some r => Some [p; q; r] | _, _, _ => None end
  | None => None
  end.
(* The triangles have a point in common. *)
Definition meet (s t : list (vec R)) : Prop := exists x, in_hull s x /\ in_hull t x.

(* All corners of all triangles are there, and those pairs of triangles meet that are listed, each once, and no others. *)
Definition has_all_corners (b : body R) : Prop := forall k, face_at b k <> None -> triangle_at b k <> None.
Definition listed {T} (c : pairs T) : list (positive * positive) := map meeting (contacts c).
Definition pairs_claim (c : pairs R) : Prop :=
  has_all_corners (first c) /\ has_all_corners (second c) /\ NoDup (listed c) /\
  forall i j, In (i, j) (listed c) <->
    exists s t, triangle_at (first c) i = Some s /\ triangle_at (second c) j = Some t /\ meet s t.

(* --- The program --- *)

Section Program.
Context {T : Type} {n : Num T}.

Notation facet := (positive * list (vec T))%type.

(* All of a list, if all are there. *)
Fixpoint all_some {X} (xs : list (option X)) : option (list X) :=
  match xs with
  | [] => Some []
  | Some x :: t => match all_some t with Some ys => Some (x :: ys) | None => None end
  | None :: _ => None
  end.
(* The triangles of a body, each once, in this order. *)
Definition find_facet {X} (spots : PositiveMap.t X) (table : PositiveMap.t (positive * positive * positive)) (k : positive)
  : option (positive * list X) :=
  match PositiveMap.find k table with
  | Some (i, j, l) =>
      match PositiveMap.find i spots, PositiveMap.find j spots, PositiveMap.find l spots with
      | Some p, Some q, Some r => Some (k, [p; q; r])
      | _, _, _ => None
      end
  | None => None
  end.
Definition in_order {X} (spots : list X) (triangles : list (positive * positive * positive)) (order : list positive)
  : option (list (positive * list X)) :=
  if (length order =? length triangles) && (length order <=? PositiveMap.cardinal (set_of order))
  then all_some (map (find_facet (numbered spots) (numbered triangles)) order) else None.

Definition all_corners {X} (test : X -> bool) (set : list (positive * list X)) : bool := forallb (fun f => forallb test (snd f)) set.
Definition check_plane (normal : vec T) (offset : T) (before behind : list facet) : bool :=
  all_corners (fun p => ltb (vdot normal p) offset) before && all_corners (fun p => ltb offset (vdot normal p)) behind.
Definition check_contact (a b : facet) (c : contact T) : bool :=
  Pos.eqb (fst a) (fst (meeting c)) && Pos.eqb (fst b) (snd (meeting c))
  && check_weights (length (snd a)) (first_weights c) && check_weights (length (snd b)) (second_weights c)
  && vec_eqb (comb (first_weights c) (snd a)) (comb (second_weights c) (snd b)).

Definition halves {X} (xs : list X) : list X * list X :=
  let k := Nat.div2 (length xs) in (firstn k xs, skipn k xs).
(* Each step is about the first of the pairs of sets that are left. The contacts are in the order in which they are come to. *)
Fixpoint walk (todo : list (list facet * list facet)) (ss : list (step T)) (cs : list (contact T)) : bool :=
  match ss, todo with
  | [], [] => match cs with [] => true | _ => false end
  | Plane normal offset :: ss', (xs, ys) :: rest => check_plane normal offset xs ys && walk rest ss' cs
  | Halve_first :: ss', (xs, ys) :: rest => let h := halves xs in walk ((fst h, ys) :: (snd h, ys) :: rest) ss' cs
  | Halve_second :: ss', (xs, ys) :: rest => let h := halves ys in walk ((xs, fst h) :: (xs, snd h) :: rest) ss' cs
  | Touch :: ss', ([a], [b]) :: rest => match cs with c :: cs' => check_contact a b c && walk rest ss' cs' | [] => false end
  | _, _ => false
  end.

Definition check_pairs (c : pairs T) : bool :=
  match in_order (corners (first c)) (faces (first c)) (first_order c), in_order (corners (second c)) (faces (second c)) (second_order c) with
  | Some xs, Some ys => walk [(xs, ys)] (steps c) (contacts c)
  | _, _ => false
  end.
End Program.

(* --- The same document over the reals --- *)

Section Values.
Context {T : Type} (value : T -> R).
Definition body_map (b : body T) : body R := Body (map (vmap value) (corners b)) (faces b).
Definition contact_map (c : contact T) : contact R :=
  Contact (meeting c) (map value (first_weights c)) (map value (second_weights c)).
Definition step_map (s : step T) : step R :=
  match s with
  | Plane normal offset => Plane (vmap value normal) (value offset)
  | Halve_first => Halve_first | Halve_second => Halve_second | Touch => Touch
  end.
Definition pairs_map (c : pairs T) : pairs R :=
  Pairs (body_map (first c)) (body_map (second c)) (first_order c) (second_order c) (map step_map (steps c))
    (map contact_map (contacts c)).
End Values.

(* --- Proof --- *)

(* A plane parts two hulls. *)
Lemma before_plane (normal : vec R) (offset : R) ps x :
  Forall (fun p => dot normal p < offset) ps -> in_hull ps x -> dot normal x < offset.
Proof.
  intros F I. apply (hull_in_convex_set (fun p => dot normal p < offset) ps x); auto.
  intros t y z [T0 T1] Y Z. autorewrite with dots. destruct (Req_dec t 0) as [->|N]; nra.
Qed.
Lemma behind_plane (normal : vec R) (offset : R) ps x :
  Forall (fun p => offset < dot normal p) ps -> in_hull ps x -> offset < dot normal x.
Proof.
  intros F I. apply (hull_in_convex_set (fun p => offset < dot normal p) ps x); auto.
  intros t y z [T0 T1] Y Z. autorewrite with dots. destruct (Req_dec t 0) as [->|N]; nra.
Qed.

Lemma all_some_sound {X Y} (f : X -> option Y) xs ys : all_some (map f xs) = Some ys ->
  (forall x, In x xs -> exists y, f x = Some y /\ In y ys) /\ (forall y, In y ys -> exists x, In x xs /\ f x = Some y).
Proof.
  revert ys; induction xs as [|x xs IH]; intros ys; cbn [map all_some].
  - intros [= <-]. split; [intros ? []|intros ? []].
  - destruct (f x) as [y|] eqn:F; [|discriminate]. destruct (all_some (map f xs)) as [zs|]; [|discriminate].
    intros [= <-]. destruct (IH zs eq_refl) as [A B]. split.
    + intros z [<-|I]; [exists y; split; [auto|now left]|]. destruct (A z I) as (w & ? & ?). exists w. split; [auto|now right].
    + intros z [<-|I]; [exists x; split; [now left|auto]|]. destruct (B z I) as (w & ? & ?). exists w. split; [now right|auto].
Qed.
Lemma all_some_keys {X Y} (f : X -> option Y) (key : Y -> X) xs ys : (forall x y, f x = Some y -> key y = x) ->
  all_some (map f xs) = Some ys -> map key ys = xs.
Proof.
  intros K. revert ys; induction xs as [|x xs IH]; intros ys; cbn [map all_some]; [now intros [= <-]|].
  destruct (f x) as [y|] eqn:F; [|discriminate]. destruct (all_some (map f xs)) as [zs|]; [|discriminate].
  intros [= <-]. cbn [map]. now rewrite (K x y F), (IH zs eq_refl).
Qed.
(* Lists in which nothing is twice. *)
Lemma nodup_app {X} (a b : list X) : NoDup (a ++ b) <-> NoDup a /\ NoDup b /\ forall x, In x a -> ~ In x b.
Proof.
  induction a as [|x a IH]; cbn [app].
  - split; [intros N; repeat split; auto using NoDup_nil; intros ? []|tauto].
  - rewrite !NoDup_cons_iff, IH, in_app_iff. cbn. split.
    + intros (N & A & B & D). split; [tauto|]. split; [auto|]. intros y [<-|I]; [tauto|auto].
    + intros ((N & A) & B & D). split; [intros [I|I]; [tauto|apply (D x); auto]|]. auto.
Qed.
Lemma nodup_products {X Y} (xs : list X) (ys : list Y) : NoDup xs -> NoDup ys -> NoDup (list_prod xs ys).
Proof.
  intros A B. induction A as [|x xs N A IH]; cbn [list_prod]; [constructor|]. apply nodup_app. split; [|split; [exact IH|]].
  - apply Injective_map_NoDup; [intros y z [= ->]; reflexivity|exact B].
  - intros (u, v) I J. apply in_map_iff in I as (w & [= <- _] & _). apply in_prod_iff in J as [J _]. contradiction.
Qed.
Lemma products_of_first_parts {X Y} (a b : list X) (ys : list Y) : list_prod (a ++ b) ys = list_prod a ys ++ list_prod b ys.
Proof. induction a as [|x a IH]; cbn [app list_prod]; [reflexivity|]. now rewrite IH, app_assoc. Qed.
Lemma products_of_second_parts {X Y} (xs : list X) (a b : list Y) :
  Permutation (list_prod xs (a ++ b)) (list_prod xs a ++ list_prod xs b).
Proof.
  induction xs as [|x xs IH]; cbn [list_prod]; [constructor|]. rewrite map_app, <- !app_assoc.
  apply Permutation_app_head. rewrite IH, !app_assoc. apply Permutation_app_tail, Permutation_app_comm.
Qed.
(* As many different numbers as numbers: none is there twice. *)
Lemma named_nodup (order : list positive) :
  (length order <= PositiveMap.cardinal (set_of order))%nat -> NoDup order.
Proof.
  rewrite PositiveMap.cardinal_1. intros L. apply (NoDup_incl_NoDup (l := map fst (PositiveMap.elements (set_of order)))).
  - clear L. pose proof (PositiveMap.elements_3w (set_of order)) as N. induction N as [|[k []] es N _ IH]; [constructor|].
    cbn [map fst]. constructor; [|exact IH]. intros I. apply N. apply in_map_iff in I as ([j []] & E & I). cbn in E. subst j.
    apply InA_alt. exists (k, tt). now split.
  - now rewrite map_length.
  - intros k I. apply in_map_iff in I as ([j []] & E & I). cbn in E. subst j. apply PositiveMap.elements_complete in I.
    apply set_of_sound. now rewrite PositiveMap.mem_find, I.
Qed.
(* k different numbers, none above k, are all of 1 to k. *)
Lemma order_is_all (order : list positive) k : NoDup order -> length order = k ->
  (forall j, In j order -> (Pos.to_nat j <= k)%nat) -> forall j, (Pos.to_nat j <= k)%nat -> In j order.
Proof.
  intros N L A j J. assert (Q : length (map Pos.of_succ_nat (seq 0 k)) = k) by now rewrite map_length, seq_length.
  apply (NoDup_length_incl (l := order) (l' := map Pos.of_succ_nat (seq 0 k)) N); [lia| |].
  - intros i I. apply A in I. pose proof (Pos2Nat.is_pos i). apply in_map_iff. exists (Pos.to_nat i - 1)%nat. split; [|apply in_seq; lia].
    apply Pos2Nat.inj. rewrite SuccNat2Pos.id_succ. lia.
  - pose proof (Pos2Nat.is_pos j). apply in_map_iff. exists (Pos.to_nat j - 1)%nat. split; [|apply in_seq; lia].
    apply Pos2Nat.inj. rewrite SuccNat2Pos.id_succ. lia.
Qed.

Section Soundness.
Context {T : Type} {n : Num T} (value : T -> R) {ex : Exact value}.
Notation vmap := (vmap value).
Notation spots f := (map vmap (snd f)) (only parsing).

Lemma value_vdot a b : value (vdot a b) = dot (vmap a) (vmap b).
Proof. cbn. unfold vdot. cbn. now rewrite !value_add, !value_mul. Qed.

Lemma find_facet_is (b : body T) k : find_facet (numbered (corners b)) (numbered (faces b)) k =
  match triangle_at b k with Some ps => Some (k, ps) | None => None end.
Proof.
  unfold find_facet, triangle_at, face_at, corner_at. rewrite numbered_is.
  destruct (nth_error (faces b) (Pos.to_nat k - 1)) as [[[i j] l]|]; [|reflexivity]. rewrite !numbered_is.
  destruct (nth_error (corners b) (Pos.to_nat i - 1)); [|reflexivity].
  destruct (nth_error (corners b) (Pos.to_nat j - 1)); [|reflexivity].
  destruct (nth_error (corners b) (Pos.to_nat l - 1)); reflexivity.
Qed.
(* The list has all triangles of the body, each once. *)
Lemma in_order_sound (b : body T) order fs : in_order (corners b) (faces b) order = Some fs ->
  (forall k, face_at b k <> None -> triangle_at b k <> None) /\ NoDup (map fst fs) /\
  forall k ps, In (k, ps) fs <-> triangle_at b k = Some ps.
Proof.
  unfold in_order. destruct (_ && _) eqn:C; [|discriminate]. apply andb_true_iff in C as [N C].
  apply Nat.eqb_eq in N. apply Nat.leb_le, named_nodup in C. intros A.
  assert (K : map fst fs = order).
  { apply (all_some_keys _ fst _ _) in A; [exact A|]. intros k f. rewrite find_facet_is.
    destruct (triangle_at b k); [now intros [= <-]|discriminate]. }
  rewrite K. apply all_some_sound in A as [A B].
  assert (L : forall k, In k order -> exists ps, triangle_at b k = Some ps /\ In (k, ps) fs).
  { intros k I. destruct (A k I) as (f & F & If). rewrite find_facet_is in F.
    destruct (triangle_at b k) as [ps|]; [|discriminate]. injection F as <-. now exists ps. }
  assert (O : forall k, face_at b k <> None -> In k order).
  { intros k F. apply (order_is_all order _ C N); [|unfold face_at in F; rewrite nth_error_Some in F; lia].
    intros j I. apply L in I as (ps & I & _). unfold triangle_at, face_at in I.
    destruct (nth_error (faces b) (Pos.to_nat j - 1)) as [f|] eqn:E; [|discriminate].
    assert (Q : nth_error (faces b) (Pos.to_nat j - 1) <> None) by congruence. rewrite nth_error_Some in Q. lia. }
  split.
  - intros k F. apply O, L in F as (ps & F & _). congruence.
  - split; [exact C|]. intros k ps. split.
    + intros I. destruct (B _ I) as (j & _ & F). rewrite find_facet_is in F.
      destruct (triangle_at b j) as [qs|] eqn:E; [|discriminate]. now injection F as -> ->.
    + intros F. assert (G : face_at b k <> None) by (unfold triangle_at in F; destruct (face_at b k); congruence).
      apply O, L in G as (qs & G & I). congruence.
Qed.

Lemma all_corners_sound test (P : vec R -> Prop) set :
  (forall p, test p = true -> P (vmap p)) -> all_corners test set = true ->
  forall f, In f set -> Forall P (spots f).
Proof.
  intros S C f I. unfold all_corners in C. rewrite forallb_forall in C. specialize (C f I). rewrite forallb_forall in C.
  apply Forall_map, Forall_forall. auto.
Qed.
Lemma check_plane_sound normal offset xs ys a b : check_plane normal offset xs ys = true -> In a xs -> In b ys ->
  ~ meet (spots a) (spots b).
Proof.
  unfold check_plane. rewrite andb_true_iff. intros [A B] Ia Ib (x & Xa & Xb).
  apply (all_corners_sound _ (fun p => dot (vmap normal) p < value offset)) with (f := a) in A; auto.
  2: { intros p L. apply (ltb_sound value) in L. now rewrite value_vdot in L. }
  apply (all_corners_sound _ (fun p => value offset < dot (vmap normal) p)) with (f := b) in B; auto.
  2: { intros p L. apply (ltb_sound value) in L. now rewrite value_vdot in L. }
  apply before_plane with (x := x) in A; auto. apply behind_plane with (x := x) in B; auto. lra.
Qed.
Lemma check_weights_convex k w : check_weights k w = true -> convex k (map value w).
Proof.
  unfold check_weights. rewrite !andb_true_iff, Nat.eqb_eq, forallb_forall. intros [[L P] S]. apply (eqb_sound value) in S.
  rewrite (value_sum value), (value_one (Exact := ex)) in S. split; [now rewrite map_length|]. split; [|exact S].
  apply Forall_map, Forall_forall. intros x I. apply P, (leb_sound value) in I. now rewrite (value_zero (Exact := ex)) in I.
Qed.
Lemma check_contact_sound a b c : check_contact a b c = true ->
  meeting c = (fst a, fst b) /\ meet (spots a) (spots b).
Proof.
  unfold check_contact. rewrite !andb_true_iff, !Pos.eqb_eq. intros [[[[A B] U] W] E].
  apply (vec_equal value) in E. rewrite !(comb_map value vmap) in E by apply (vmap_keeps_sums value).
  apply check_weights_convex in U, W. split; [rewrite A, B; apply surjective_pairing|].
  exists (comb (map value (first_weights c)) (spots a)). split.
  - exists (map value (first_weights c)). rewrite map_length. now split.
  - exists (map value (second_weights c)). rewrite map_length. now split.
Qed.

Lemma in_halves {X} (x : X) xs : In x xs <-> In x (fst (halves xs)) \/ In x (snd (halves xs)).
Proof. unfold halves. cbn [fst snd]. rewrite <- in_app_iff, firstn_skipn. reflexivity. Qed.

Definition are_in (todo : list (list (positive * list (vec T)) * list (positive * list (vec T)))) a b : Prop :=
  exists xs ys, In (xs, ys) todo /\ In a xs /\ In b ys.
Lemma are_in_cons xs ys todo a b : are_in ((xs, ys) :: todo) a b <-> In a xs /\ In b ys \/ are_in todo a b.
Proof.
  unfold are_in. split.
  - intros (us & vs & [[= <- <-]|I] & A & B); [now left|right; eauto].
  - intros [[A B]|(us & vs & I & A & B)]; [exists xs, ys; cbn; auto|exists us, vs; cbn; auto].
Qed.
(* Those of the pairs that meet are those of the contacts. *)
Lemma walk_sound ss todo cs : walk todo ss cs = true ->
  forall p, In p (map meeting cs) <->
    exists a b, are_in todo a b /\ p = (fst a, fst b) /\ meet (spots a) (spots b).
Proof.
  revert todo cs; induction ss as [|s ss IH]; intros todo cs W p.
  - destruct todo as [|[xs ys] todo]; [|discriminate]. destruct cs; [|discriminate]. cbn. split; [intros []|].
    intros (a & b & (xs & ys & [] & _) & _).
  - destruct s as [normal offset| | |]; destruct todo as [|[xs ys] todo]; try discriminate W; cbn [walk] in W.
    + apply andb_true_iff in W as [C W]. rewrite (IH _ _ W p). setoid_rewrite are_in_cons.
      split; [intros (a & b & I & E & M); exists a, b; auto|].
      intros (a & b & [[A B]|I] & E & M); [|exists a, b; auto].
      exfalso. now apply (check_plane_sound _ _ _ _ _ _ C A B).
    + rewrite (IH _ _ W p). setoid_rewrite are_in_cons. setoid_rewrite are_in_cons.
      split; intros (a & b & I & E & M); exists a, b; (split; [|auto]); pose proof (in_halves a xs); tauto.
    + rewrite (IH _ _ W p). setoid_rewrite are_in_cons. setoid_rewrite are_in_cons.
      split; intros (a & b & I & E & M); exists a, b; (split; [|auto]); pose proof (in_halves b ys); tauto.
    + destruct xs as [|a [|? ?]]; try discriminate W. destruct ys as [|b [|? ?]]; try discriminate W.
      destruct cs as [|c cs]; [discriminate W|]. apply andb_true_iff in W as [C W].
      apply check_contact_sound in C as [C M]. cbn [map In]. rewrite (IH _ _ W p), C. setoid_rewrite are_in_cons. split.
      * intros [<-|(a' & b' & I & E & N)]; [exists a, b|exists a', b']; cbn; auto 6.
      * intros (a' & b' & [[[<-|[]] [<-|[]]]|I] & E & N); [now left|right; exists a', b'; auto].
Qed.

(* Pairs that are left are each there once, and so then are those of the contacts. *)
Definition left_over (todo : list (list (positive * list (vec T)) * list (positive * list (vec T)))) : list (positive * positive) :=
  flat_map (fun sets => list_prod (map fst (fst sets)) (map fst (snd sets))) todo.
Lemma walk_once ss todo cs : walk todo ss cs = true -> NoDup (left_over todo) -> NoDup (map meeting cs).
Proof.
  revert todo cs; induction ss as [|s ss IH]; intros todo cs W N.
  - destruct todo as [|[xs ys] todo]; [|discriminate]. destruct cs; [constructor|discriminate].
  - destruct s as [normal offset| | |]; destruct todo as [|[xs ys] todo]; try discriminate W; cbn [walk] in W;
      unfold left_over in N; cbn [flat_map fst snd] in N; fold (left_over todo) in N.
    + apply andb_true_iff in W as [_ W]. apply nodup_app in N as (_ & N & _). now apply (IH _ _ W).
    + apply (IH _ _ W). unfold left_over, halves. cbn [flat_map fst snd]. fold (left_over todo).
      rewrite app_assoc, <- products_of_first_parts, <- map_app, firstn_skipn. exact N.
    + apply (IH _ _ W). unfold left_over, halves. cbn [flat_map fst snd]. fold (left_over todo).
      rewrite app_assoc, <- products_of_second_parts, <- map_app, firstn_skipn. exact N.
    + destruct xs as [|a [|? ?]]; try discriminate W. destruct ys as [|b [|? ?]]; try discriminate W.
      destruct cs as [|c cs]; [discriminate W|]. apply andb_true_iff in W as [C W]. cbn in N. apply NoDup_cons_iff in N as [O N].
      cbn [map]. apply NoDup_cons_iff. split; [|now apply (IH _ _ W)]. apply check_contact_sound in C as [-> _].
      rewrite (walk_sound _ _ _ W). intros (a' & b' & (xs & ys & I & A & B) & E & _). rewrite E in O. apply O.
      apply in_flat_map. exists (xs, ys). split; [exact I|]. apply in_prod; now apply in_map.
Qed.

Lemma triangle_at_map (b : body T) k : triangle_at (body_map value b) k = option_map (map vmap) (triangle_at b k).
Proof.
  unfold triangle_at, face_at, corner_at. cbn [body_map faces corners].
  destruct (nth_error (faces b) (Pos.to_nat k - 1)) as [[[i j] l]|]; [|reflexivity]. rewrite !nth_error_map.
  destruct (nth_error (corners b) (Pos.to_nat i - 1)); [|reflexivity].
  destruct (nth_error (corners b) (Pos.to_nat j - 1)); [|reflexivity].
  destruct (nth_error (corners b) (Pos.to_nat l - 1)); reflexivity.
Qed.

Lemma check_pairs_sound (c : pairs T) : check_pairs c = true -> pairs_claim (pairs_map value c).
Proof.
  unfold check_pairs. destruct (in_order _ _ (first_order c)) as [xs|] eqn:X; [|discriminate].
  destruct (in_order _ _ (second_order c)) as [ys|] eqn:Y; [|discriminate]. intros W.
  apply in_order_sound in X as (CX & NX & X). apply in_order_sound in Y as (CY & NY & Y).
  assert (H : forall b : body T, (forall k, face_at b k <> None -> triangle_at b k <> None) -> has_all_corners (body_map value b)).
  { intros b C k F. rewrite triangle_at_map. apply C in F. destruct (triangle_at b k); [discriminate|contradiction]. }
  split; [now apply H|]. split; [now apply H|].
  assert (L : listed (pairs_map value c) = listed c) by (unfold listed; cbn [pairs_map contacts]; now rewrite map_map).
  rewrite L. unfold listed. split.
  { apply (walk_once _ _ _ W). cbn. rewrite app_nil_r. now apply nodup_products. }
  intros i j. cbn [pairs_map first second]. rewrite (walk_sound _ _ _ W (i, j)). split.
  - intros ([i' s] & [j' t] & I & E & M). cbn [fst snd] in E, M. injection E as <- <-. apply are_in_cons in I.
    destruct I as [[A B]|(? & ? & [] & _)]. apply X in A. apply Y in B. exists (map vmap s), (map vmap t).
    now rewrite !triangle_at_map, A, B.
  - intros (s & t & A & B & M). rewrite triangle_at_map in A, B.
    destruct (triangle_at (first c) i) as [s'|] eqn:A'; [|discriminate].
    destruct (triangle_at (second c) j) as [t'|] eqn:B'; [|discriminate]. injection A as <-. injection B as <-.
    exists (i, s'), (j, t'). split; [apply are_in_cons; left; split; [now apply X|now apply Y]|]. now split.
Qed.
End Soundness.
