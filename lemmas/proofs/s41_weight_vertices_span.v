(* SPDX-License-Identifier: MIT *)
(* Section 4.1, weight vertices span W' (Equation 4). *)
From Coq Require Import List Reals Lra Psatz Lia.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex.
Import ListNotations.

(* --- Statements --- *)

(* Weight bounds <l_i, h_i> as a list of pairs. They cut W' out of the plane of affine weights. *)
Definition within (b : R * R) (x : R) := fst b <= x <= snd b.
Definition admits (bounds : list (R * R)) (w : list R) := Forall2 within bounds w /\ sum w = 1.
(* A point of W' that has at most one coordinate off its bounds: a weight vertex. *)
Definition tight (b : R * R) (x : R) := x = fst b \/ x = snd b.
Definition at_most_one_off (bounds : list (R * R)) (w : list R) :=
  exists i, forall k, (k < length w)%nat -> k <> i -> tight (nth k bounds (0, 0)) (nth k w 0).
(* The list holds points of W' only, and each weight vertex. *)
Definition lists_weight_vertices (bounds : list (R * R)) (weight_vertices : list (list R)) :=
  (forall c, In c weight_vertices -> admits bounds c) /\
  (forall w, admits bounds w -> at_most_one_off bounds w -> In w weight_vertices).
(* w_i = sum_k u_k c_ki with u in W_m *)
Definition is_weight_vertex_combination (weight_vertices : list (list R)) (w : list R) :=
  exists u, convex (length weight_vertices) u /\ forall i, nth i w 0 = comb u (map (fun c => nth i c 0) weight_vertices).

(* Every w of W' is a convex combination of the list, and every convex combination of the list is in W'. *)
Definition weight_vertices_span_repaired : Prop :=
  forall bounds weight_vertices w, lists_weight_vertices bounds weight_vertices -> length w = length bounds ->
  (admits bounds w <-> is_weight_vertex_combination weight_vertices w).
(* W' has weight vertices if and only if l_i <= h_i and sum l <= 1 <= sum h. *)
Definition weight_vertices_exist_repaired : Prop :=
  forall bounds, bounds <> [] ->
  ((exists w, admits bounds w /\ at_most_one_off bounds w) <->
   Forall (fun b => fst b <= snd b) bounds /\ sum (map fst bounds) <= 1 <= sum (map snd bounds)).

(* Printed: whatever the bounds, W' is the hull of its weight vertices, m >= 1 of them. *)
Definition weight_vertices_exist_printed : Prop := forall bounds, exists w, admits bounds w /\ at_most_one_off bounds w.

(* --- Proofs --- *)

(* t x + (1 - t) y, of two lists of weights. *)
Definition mix (t : R) (x y : list R) := map (fun p => t * fst p + (1 - t) * snd p) (combine x y).
Lemma mix_length t x y : length x = length y -> length (mix t x y) = length x.
Proof. intros L. unfold mix. rewrite map_length, combine_length, L. apply Nat.min_id. Qed.
Lemma nth_mix t x y i : length x = length y -> nth i (mix t x y) 0 = t * nth i x 0 + (1 - t) * nth i y 0.
Proof.
  revert y i; induction x as [|a x IH]; intros [|b y] i L; try discriminate; destruct i; cbn; try ring. apply IH. auto.
Qed.
Lemma mix_same t x : mix t x x = x.
Proof. unfold mix. induction x as [|a x IH]; cbn; [reflexivity|]. rewrite IH. f_equal. ring. Qed.

(* Weight vertices as a type of lists: all coordinates at a bound, or one anywhere between. *)
Inductive weight_vertex : list (R * R) -> list R -> Prop :=
| weight_vertex_nil : weight_vertex [] []
| weight_vertex_tight : forall b x bs v, within b x -> tight b x -> weight_vertex bs v -> weight_vertex (b :: bs) (x :: v)
| weight_vertex_off : forall b x bs v, within b x -> Forall2 (fun b x => within b x /\ tight b x) bs v ->
  weight_vertex (b :: bs) (x :: v).

Lemma tight_weight_vertex bs v : Forall2 (fun b x => within b x /\ tight b x) bs v -> weight_vertex bs v.
Proof. induction 1 as [|b x bs v [W T] F IH]; constructor; auto. Qed.

(* A weight vertex behind one more coordinate that is off its bounds: moving weight between this and the one that is
   off, until a bound stops it, both ways. *)
Definition closed_under_mix (P : list R -> Prop) :=
  forall t x y, length x = length y -> 0 <= t <= 1 -> P x -> P y -> P (mix t x y).

Lemma split_pair (b c : R * R) (x y : R) : within b x -> within c y ->
  exists p q t, 0 <= p /\ 0 <= q /\ 0 <= t <= 1 /\ t * p = (1 - t) * q /\
  (within b (x + p) /\ within c (y - p) /\ (tight b (x + p) \/ tight c (y - p))) /\
  (within b (x - q) /\ within c (y + q) /\ (tight b (x - q) \/ tight c (y + q))).
Proof.
  intros [B1 B2] [C1 C2]. unfold within, tight.
  set (p := Rmin (snd b - x) (y - fst c)). set (q := Rmin (x - fst b) (snd c - y)).
  assert (P : 0 <= p /\ (p = snd b - x /\ p <= y - fst c \/ p = y - fst c /\ p <= snd b - x))
    by (unfold p, Rmin; destruct (Rle_dec _ _); lra).
  assert (Q : 0 <= q /\ (q = x - fst b /\ q <= snd c - y \/ q = snd c - y /\ q <= x - fst b))
    by (unfold q, Rmin; destruct (Rle_dec _ _); lra).
  clearbody p q.
  assert (T : exists t, 0 <= t <= 1 /\ t * p = (1 - t) * q).
  { destruct (Rle_lt_dec (p + q) 0) as [Z|Z].
    - exists 0. assert (p = 0) by lra. assert (q = 0) by lra. subst. split; lra.
    - assert (I : 0 < / (p + q)) by (apply inv_pos; lra). assert (E : (p + q) * / (p + q) = 1) by (apply Rinv_r; lra).
      exists (q * / (p + q)). assert (0 <= q * / (p + q)) by (apply Rmult_le_pos; lra).
      assert (0 <= p * / (p + q)) by (apply Rmult_le_pos; lra). split; [lra|].
      replace (1 - q * / (p + q)) with (p * / (p + q)) by lra. ring. }
  destruct T as (t & T & E). exists p, q, t.
  destruct P as [P0 [[Pe P1]|[Pe P1]]], Q as [Q0 [[Qe Q1]|[Qe Q1]]]; repeat split; try lra;
    first [left; right; lra | left; left; lra | right; left; lra | right; right; lra].
Qed.

(* P holds of all weight vertices with the sum of w, and passes from two lists to those between them: then it holds of w. *)
Lemma weight_vertices_suffice bs w : Forall2 within bs w -> forall P, closed_under_mix P ->
  (forall v, weight_vertex bs v -> sum v = sum w -> P v) -> P w.
Proof.
  induction 1 as [|b x bs w X F IH]; intros P M C; [apply C; [constructor|reflexivity]|].
  apply (IH (fun v => P (x :: v))).
  - intros t u v L T U V. replace (x :: mix t u v) with (mix t (x :: u) (x :: v)).
    + apply M; cbn; auto.
    + unfold mix. cbn. f_equal. ring.
  - intros v Cv Sv. clear IH F. rewrite sum_cons in C. rewrite <- Sv in C. clear Sv w.
    (* One coordinate of v may be off; x may be off too. *)
    revert P M C. induction Cv as [|c y cs v Y T Cv IH|c y cs v Y F]; intros P M C.
    + apply C; [|reflexivity]. apply weight_vertex_off; [exact X|constructor].
    + apply (IH (fun u => P (match u with a :: u => a :: y :: u | [] => [] end))).
      * intros t u1 u2 L T12 U1 U2. destruct u1 as [|a1 u1], u2 as [|a2 u2]; try discriminate; [exact U1|].
        replace (match mix t (a1 :: u1) (a2 :: u2) with [] => [] | a :: u => a :: y :: u end)
          with (mix t (a1 :: y :: u1) (a2 :: y :: u2)).
        -- apply M; cbn in *; auto.
        -- unfold mix. cbn. repeat f_equal. ring.
      * intros u U S. destruct u as [|a u]; [inversion U|]. apply C.
        -- inversion U; subst; [apply weight_vertex_tight; auto; apply weight_vertex_tight; auto|].
           apply weight_vertex_off; auto.
        -- rewrite !sum_cons in *. lra.
    + destruct (split_pair b c x y X Y) as (p & q & t & P0 & Q0 & T & E & (B1 & C1 & O1) & (B2 & C2 & O2)).
      replace (x :: y :: v) with (mix t (x + p :: y - p :: v) (x - q :: y + q :: v)).
      * apply M; auto; apply C; try (rewrite !sum_cons; ring).
        -- destruct O1 as [O|O]; [apply weight_vertex_tight; auto; now apply weight_vertex_off|apply weight_vertex_off; auto].
        -- destruct O2 as [O|O]; [apply weight_vertex_tight; auto; now apply weight_vertex_off|apply weight_vertex_off; auto].
      * unfold mix. cbn. fold (mix t v v). rewrite mix_same. repeat f_equal; lra.
Qed.

Lemma weight_vertex_within bs v : weight_vertex bs v -> Forall2 within bs v.
Proof.
  induction 1 as [|b x bs v X T C IH|b x bs v X F]; constructor; auto. clear -F. induction F as [|b x bs v [W _] F IH]; constructor; auto.
Qed.
Lemma tight_nth bs v k : Forall2 (fun b x => within b x /\ tight b x) bs v -> (k < length v)%nat ->
  tight (nth k bs (0, 0)) (nth k v 0).
Proof.
  intros F; revert k; induction F as [|b x bs v [_ T] F IH]; intros [|k] L; cbn in *; auto; try lia. apply IH. lia.
Qed.
Lemma weight_vertex_at_most_one_off bs v : weight_vertex bs v -> at_most_one_off bs v.
Proof.
  induction 1 as [|b x bs v X T C (i & IH)|b x bs v X F].
  - exists 0%nat. cbn. lia.
  - exists (S i). intros [|k] K N; cbn in *; auto. apply IH; lia.
  - exists 0%nat. intros [|k] K N; cbn in *; [lia|]. apply tight_nth; auto. lia.
Qed.

Lemma Forall2_nth {A B} (P : A -> B -> Prop) xs ys a b : Forall2 P xs ys <->
  length xs = length ys /\ forall i, (i < length ys)%nat -> P (nth i xs a) (nth i ys b).
Proof.
  split.
  - induction 1 as [|x y xs ys I F [L IH]]; cbn; [split; auto; lia|]. split; [lia|]. intros [|i] K; auto. apply IH. lia.
  - revert ys; induction xs as [|x xs IH]; intros [|y ys] [L F]; try discriminate; constructor.
    + apply (F 0%nat). cbn. lia.
    + apply IH. split; [auto|]. intros i K. apply (F (S i)). cbn. lia.
Qed.

(* sum_i of sum_k u_k c_ki *)
Lemma sum_of_combinations (u : list R) (weight_vertices : list (list R)) (w : list R) n : length w = n ->
  (forall i, nth i w 0 = comb u (map (fun c => nth i c 0) weight_vertices)) ->
  (forall c, In c weight_vertices -> length c = n) -> sum w = comb u (map sum weight_vertices).
Proof.
  revert n weight_vertices; induction w as [|a w IH]; intros n weight_vertices L W C.
  - cbn in L. subst n. clear W. symmetry. revert weight_vertices C; induction u as [|b u IH];
    intros [|c weight_vertices] C; try reflexivity.
    cbn [map comb]. rewrite IH by (intros d D; apply C; now right).
    rewrite (proj1 (length_zero_iff_nil c)) by (apply C; now left). cbn. ring.
  - destruct n as [|n]; [discriminate|].
    assert (A : a = comb u (map (hd 0) weight_vertices)).
    { specialize (W 0%nat). cbn [nth] in W. rewrite W. f_equal. apply map_ext. now intros [|]. }
    rewrite sum_cons, (IH n (map (@tl R) weight_vertices)).
    + rewrite A. clear -C. revert weight_vertices C; induction u as [|b u IH]; intros [|c weight_vertices] C;
      cbn [map comb]; try (cbn; ring).
      assert (sum c = hd 0 c + sum (tl c)) as ->.
      { specialize (C c (or_introl eq_refl)). destruct c; [discriminate|]. reflexivity. }
      specialize (IH weight_vertices ltac:(intros d D; apply C; now right)).
      cbn [ladd lscale lin_num add mul ops_R] in *. lra.
    + cbn in L. lia.
    + intros i. rewrite map_map. specialize (W (S i)). cbn in W. rewrite W. f_equal. apply map_ext.
      intros [|]; [now destruct i|reflexivity].
    + intros c I. apply in_map_iff in I as (d & <- & D). apply C in D. destruct d; cbn in *; lia.
Qed.

Lemma admits_length bounds w : admits bounds w -> length bounds = length w.
Proof. intros [F _]. apply (Forall2_nth _ _ _ (0, 0) 0) in F. apply F. Qed.

Theorem weight_vertices_span_repaired_holds : weight_vertices_span_repaired.
Proof.
  intros bounds weight_vertices w [Adm Comp] Lw. split.
  - intros [F S].
    apply (weight_vertices_suffice bounds w F (fun w => is_weight_vertex_combination weight_vertices w)).
    + intros t x y L T (u & (Lu & Pu & Su) & U) (v & (Lv & Pv & Sv) & V).
      exists (mix t u v). split.
      * split; [rewrite mix_length; congruence|]. split.
        -- unfold mix. apply Forall_map, Forall_forall. intros [a b] I.
           rewrite Forall_forall in Pu, Pv. pose proof (Pu a (in_combine_l _ _ _ _ I)). pose proof (Pv b (in_combine_r _ _ _ _ I)).
           cbn. nra.
        -- unfold mix. assert (G : length u = length v) by congruence. clear - G Su Sv.
           assert (H : forall u v, length u = length v -> sum (map (fun p => t * fst p + (1 - t) * snd p) (combine u v)) =
             t * sum u + (1 - t) * sum v).
           { clear. induction u as [|a u IH]; intros [|b v] L; try discriminate; cbn [combine map fst snd]; [cbn; ring|].
             rewrite !sum_cons, IH by auto. ring. }
           rewrite H, Su, Sv by auto. ring.
      * intros i. rewrite nth_mix, U, V by auto. assert (G : length u = length v) by congruence. clear - G.
        generalize (map (fun c => nth i c 0) weight_vertices). intros l. unfold mix.
        revert v l G; induction u as [|a u IH]; intros [|b v] [|c l] G; try discriminate; cbn [combine map comb fst snd];
          try (cbn; ring). rewrite <- IH by auto. cbn. ring.
    + intros v C Sv. assert (I : In v weight_vertices).
      { apply Comp; [|now apply weight_vertex_at_most_one_off]. split; [now apply weight_vertex_within|congruence]. }
      apply in_split in I as (l1 & l2 & ->).
      exists (repeat 0 (length l1) ++ 1 :: repeat 0 (length l2)).
      assert (Z : forall n, Forall (Rle 0) (repeat 0 n)) by (intro k; apply Forall_forall; intros x X; apply repeat_spec in X; lra).
      assert (Sz : forall n, sum (repeat 0 n) = 0) by (induction n; cbn; [reflexivity|]; unfold sum in *; lra).
      assert (Cz : forall (xs : list R) n, comb (repeat 0 n) xs = 0).
      { induction xs as [|x xs IH]; intros [|n]; cbn; auto. rewrite IH. ring. }
      split; [split; [|split]|].
      * rewrite !app_length. cbn. now rewrite !repeat_length.
      * apply Forall_app. split; [apply Z|]. constructor; [lra|apply Z].
      * rewrite sum_app, sum_cons, !Sz. ring.
      * intros i. rewrite map_app. cbn [map]. rewrite comb_app by (now rewrite repeat_length, map_length). cbn [comb].
        rewrite !Cz. cbn. ring.
  - intros (u & (L & P & S) & U).
    assert (Lc : forall c, In c weight_vertices -> length c = length bounds).
    { intros c I. apply Adm, admits_length in I. congruence. }
    split.
    + apply (Forall2_nth _ _ _ (0, 0) 0). split; [auto|]. intros i I. rewrite U. unfold within.
      assert (G : forall c, In c weight_vertices -> within (nth i bounds (0, 0)) (nth i c 0)).
      { intros c C. specialize (Lc c C). apply Adm in C as [F _]. apply (Forall2_nth _ _ _ (0, 0) 0) in F as [_ F]. apply F. lia. }
      split.
      * replace (fst _) with (fst (nth i bounds (0, 0)) * sum u) by (rewrite S; ring).
        apply comb_at_least; [now rewrite map_length|auto|]. apply Forall_map, Forall_forall. intros c C. apply (G c C).
      * replace (snd _) with (snd (nth i bounds (0, 0)) * sum u) by (rewrite S; ring).
        apply comb_at_most; [now rewrite map_length|auto|]. apply Forall_map, Forall_forall. intros c C. apply (G c C).
    + rewrite (sum_of_combinations u weight_vertices w (length bounds) Lw U Lc).
      replace (map sum weight_vertices) with (repeat 1 (length weight_vertices)); [now rewrite comb_ones, S|].
      clear - Adm. induction weight_vertices as [|c weight_vertices IH]; [reflexivity|]. cbn. f_equal.
      * symmetry. apply (Adm c). now left.
      * apply IH. intros d D. apply Adm. now right.
Qed.

(* Every sum between those of the low and the high bounds is that of some weights. *)
Lemma weights_of_sum bounds s : Forall (fun b => fst b <= snd b) bounds -> sum (map fst bounds) <= s <= sum (map snd bounds) ->
  exists w, Forall2 within bounds w /\ sum w = s.
Proof.
  intros F; revert s; induction F as [|b bounds B F IH]; intros s S; cbn [map] in S.
  - exists []. cbn in *. split; [constructor|lra].
  - rewrite !sum_cons in S. set (x := Rmax (fst b) (s - sum (map snd bounds))).
    assert (X : fst b <= x <= snd b /\ s - sum (map snd bounds) <= x /\ x <= s - sum (map fst bounds)).
    { assert (sum (map fst bounds) <= sum (map snd bounds)).
      { clear -F. induction F as [|b bounds B F IH]; cbn [map]; [lra|]. rewrite !sum_cons. lra. }
      unfold x, Rmax. destruct (Rle_dec _ _); lra. }
    destruct (IH (s - x)) as (w & W & Sw); [lra|]. exists (x :: w). rewrite sum_cons. split; [constructor; auto; split; lra|lra].
Qed.

Theorem weight_vertices_exist_repaired_holds : weight_vertices_exist_repaired.
Proof.
  intros bounds N. split.
  - intros (w & [F S] & _). clear N. rewrite <- S. clear S.
    induction F as [|b x bounds w [B1 B2] F [IH1 [IH2 IH3]]]; cbn [map]; [split; [constructor|cbn; lra]|].
    rewrite !sum_cons. split; [constructor; auto; lra|lra].
  - intros [F S]. destruct (weights_of_sum bounds 1 F S) as (w & W & Sw).
    apply (weight_vertices_suffice bounds w W (fun _ => exists w, admits bounds w /\ at_most_one_off bounds w)).
    + intros t x y _ _ A _. exact A.
    + intros v C V. exists v. split; [split; [now apply weight_vertex_within|congruence]|now apply
      weight_vertex_at_most_one_off].
Qed.

(* Low bounds whose sum exceeds 1. *)
Theorem weight_vertices_exist_printed_is_false : ~ weight_vertices_exist_printed.
Proof.
  intros P. destruct (P [(3 / 4, 1); (3 / 4, 1)]) as (w & [F S] & _).
  inversion F as [|b x bs v X F1]; subst. inversion F1 as [|c y cs u Y F2]; subst. inversion F2; subst.
  cbn in S. unfold within in *. cbn in *. lra.
Qed.

(* The hypotheses can be met: two joints without bounds, with both ends listed. *)
Example weight_vertices_instance : lists_weight_vertices [(0, 1); (0, 1)] [[1; 0]; [0; 1]].
Proof.
  split.
  - intros c [<-|[<-|[]]]; (split; [repeat constructor; unfold within; cbn; lra|cbn; lra]).
  - intros w [F S] (i & T).
    inversion F as [|b x bs v X F1]; subst. inversion F1 as [|c y cs u Y F2]; subst. inversion F2; subst.
    cbn in S. assert (C : tight (0, 1) x \/ tight (0, 1) y).
    { destruct i as [|i]; [right; apply (T 1%nat)|left; apply (T 0%nat)]; cbn; lia. }
    unfold tight in C. cbn in C.
    assert (x = 1 /\ y = 0 \/ x = 0 /\ y = 1) as [[-> ->]|[-> ->]] by lra; cbn; auto.
Qed.
