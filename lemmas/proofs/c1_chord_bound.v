(* SPDX-License-Identifier: MIT *)
(* A curve with a bounded second derivative against its chord, in any real inner product space. *)
From Coq Require Import Reals Lra Psatz.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.curve.

Definition within {E} `{Euclid E} (f : R -> E) (m a b : R) := forall t, a <= t <= b -> norm (f t) <= m.

(* The chord at the share s. *)
Definition between {E} `{Euclid E} (x y : E) (s : R) := ((1 - s) *: x + s *: y)%V.
Arguments between {E l H} (x y)%V s.

(* --- Statements --- *)

(* (i) ||f - c|| <= M s (1 - s) h^2 / 2. *)
Definition chord_bound : Prop := forall E (l : Lin R E) (H : Euclid E) (f f' f'' : R -> E) (a b m s : R),
  a < b -> derivative f f' a b -> derivative f' f'' a b -> within f'' m a b -> 0 <= s <= 1 ->
  norm (f (a + s * (b - a))%R - between (f a) (f b) s) <= m * (s * (1 - s)) * ((b - a) * (b - a)) / 2.

(* And so <= M h^2 / 8. *)
Definition chord_slack : Prop := forall E (l : Lin R E) (H : Euclid E) (f f' f'' : R -> E) (a b m s : R),
  a < b -> derivative f f' a b -> derivative f' f'' a b -> within f'' m a b -> 0 <= s <= 1 ->
  norm (f (a + s * (b - a))%R - between (f a) (f b) s) <= m * ((b - a) * (b - a)) / 8.

(* (ii) ||f - c|| <= 2 s (1 - s) h L. *)
Definition chord_first_order : Prop := forall E (l : Lin R E) (H : Euclid E) (f f' : R -> E) (a b m s : R),
  a < b -> derivative f f' a b -> within f' m a b -> 0 <= s <= 1 ->
  norm (f (a + s * (b - a))%R - between (f a) (f b) s) <= 2 * (s * (1 - s)) * (b - a) * m.

(* What engines assume, that f is on its chord, is false. *)
Definition on_chord_somewhere : Prop := forall (f f' f'' : R -> R) (a b s : R),
  a < b -> derivative f f' a b -> derivative f' f'' a b -> 0 <= s <= 1 ->
  f (a + s * (b - a))%R = between (f a) (f b) s.

(* --- Proofs --- *)

(* A function whose derivative is not negative does not fall. (The mean value theorem of the library rests on an axiom more.) *)
Lemma not_falling (g g' : R -> R) (a b : R) : a <= b ->
  (forall x, a <= x <= b -> derivable_pt_lim g x (g' x)) -> (forall x, a <= x <= b -> 0 <= g' x) -> g a <= g b.
Proof.
  intros AB D P. apply Rnot_lt_le. intros F.
  assert (N : a < b) by (destruct AB as [|<-]; [assumption|lra]).
  pose (e := (g a - g b) / (2 * (b - a))). assert (E : 0 < e) by (apply Rdiv_lt_0_compat; lra).
  (* With a slope of e more it rises near every moment, and still ends lower. *)
  pose (h := fun x => g x + e * (x - a)).
  assert (Hb : h b < h a).
  { unfold h. replace (e * (b - a)) with ((g a - g b) / 2) by (unfold e; field; lra). replace (a - a) with 0 by ring. lra. }
  assert (Local : forall x, a <= x <= b -> exists d, 0 < d /\
    forall y, a <= y <= b -> Rabs (y - x) < d -> (x <= y -> h x <= h y) /\ (y <= x -> h y <= h x)).
  { intros x X. destruct (D x X e E) as [d Q]. exists d. split; [apply cond_pos|]. intros y Y C.
    destruct (Req_dec y x) as [->|Ne]; [split; lra|].
    specialize (Q (y - x) ltac:(lra) C). replace (x + (y - x)) with y in Q by ring. apply Rabs_def2 in Q as [_ Q].
    assert (R1 : - e < (g y - g x) / (y - x)) by (specialize (P x X); lra).
    assert (G : (g y - g x) / (y - x) * (y - x) = g y - g x) by (field; lra). unfold h. split; intros O.
    - assert (0 <= ((g y - g x) / (y - x) + e) * (y - x)) by (apply Rmult_le_pos; lra). lra.
    - assert (0 <= ((g y - g x) / (y - x) + e) * (x - y)) by (apply Rmult_le_pos; lra). lra. }
  (* The last moment at which it is not lower than at the start. *)
  pose (S := fun x => a <= x <= b /\ h a <= h x).
  destruct (completeness S) as [c [Up Least]].
  { exists b. intros x [X _]. lra. }
  { exists a. split; lra. }
  assert (Ca : a <= c) by (apply Up; split; lra).
  assert (Cb : c <= b) by (apply Least; intros x [X _]; lra).
  destruct (Local c (Logic.conj Ca Cb)) as (d & Dp & L).
  assert (Hc : h a <= h c).
  { apply Rnot_lt_le. intros Low. assert (U : c <= c - d / 2); [|lra]. apply Least. intros x [X Hx].
    apply Rnot_lt_le. intros Near. assert (x <= c) by (apply Up; split; auto).
    destruct (L x X ltac:(apply Rabs_def1; lra)) as [_ B]. specialize (B ltac:(lra)). lra. }
  assert (Lt : c < b) by (destruct Cb as [Cb| ->]; [assumption|lra]).
  pose (y := Rmin b (c + d / 2)). assert (Y : c < y <= b /\ y <= c + d / 2) by (unfold y, Rmin; destruct (Rle_dec b (c + d / 2)); lra).
  destruct (L y ltac:(lra) ltac:(apply Rabs_def1; lra)) as [B _]. specialize (B ltac:(lra)).
  assert (y <= c) by (apply Up; split; lra). lra.
Qed.

Lemma line_derivative (k x : R) : derivable_pt_lim (fun z => k * z) x k.
Proof. pose proof (derivable_pt_lim_scal id k x 1 (derivable_pt_lim_id x)) as D. now rewrite Rmult_1_r in D. Qed.

(* It rises by no more than its derivative's bound. *)
Lemma rises_at_most (g g' : R -> R) (a b k : R) : a <= b ->
  (forall x, a <= x <= b -> derivable_pt_lim g x (g' x)) -> (forall x, a <= x <= b -> g' x <= k) -> g b - g a <= k * (b - a).
Proof.
  intros AB D P. cut (k * a - g a <= k * b - g b); [lra|].
  apply (not_falling (fun x => k * x - g x) (fun x => k - g' x)); [exact AB| |intros x X; specialize (P x X); lra].
  intros x X. apply (derivable_pt_lim_minus (fun x => k * x) g); [apply line_derivative|now apply D].
Qed.
Lemma rises_at_least (g g' : R -> R) (a b k : R) : a <= b ->
  (forall x, a <= x <= b -> derivable_pt_lim g x (g' x)) -> (forall x, a <= x <= b -> k <= g' x) -> k * (b - a) <= g b - g a.
Proof.
  intros AB D P. cut (g a - k * a <= g b - k * b); [lra|].
  apply (not_falling (fun x => g x - k * x) (fun x => g' x - k)); [exact AB| |intros x X; specialize (P x X); lra].
  intros x X. apply (derivable_pt_lim_minus g (fun x => k * x)); [now apply D|apply line_derivative].
Qed.

(* A function with the second derivative at least -k, against its chord: with k / 2 x^2 it is convex. *)
Lemma scalar_chord (g g' g'' : R -> R) (a b k t : R) : a <= t <= b ->
  (forall x, a <= x <= b -> derivable_pt_lim g x (g' x)) -> (forall x, a <= x <= b -> derivable_pt_lim g' x (g'' x)) ->
  (forall x, a <= x <= b -> - k <= g'' x) ->
  (g t - g a) * (b - t) - (g b - g t) * (t - a) <= k / 2 * ((t - a) * (b - t)) * (b - a).
Proof.
  intros T D1 D2 B. pose (h := fun x => g x + k / 2 * (x * x)). pose (h' := fun x => g' x + k * x).
  assert (P : forall x, derivable_pt_lim (fun x => k / 2 * (x * x)) x (k * x)).
  { intros x. replace (k * x) with (k / 2 * (1 * x + x * 1)) by field.
    apply (derivable_pt_lim_scal (fun x => x * x) (k / 2) x). apply (derivable_pt_lim_mult id id); apply derivable_pt_lim_id. }
  assert (H1 : forall x, a <= x <= b -> derivable_pt_lim h x (h' x)).
  { intros x X. apply (derivable_pt_lim_plus g (fun x => k / 2 * (x * x))); auto. }
  assert (H2 : forall x, a <= x <= b -> derivable_pt_lim h' x (g'' x + k)).
  { intros x X. apply (derivable_pt_lim_plus g' (fun x => k * x)); auto using line_derivative. }
  assert (Rising : forall x y, a <= x <= y -> y <= b -> h' x <= h' y).
  { intros x y X Y. apply (not_falling h' (fun z => g'' z + k)); [lra|intros; apply H2; lra|].
    intros z Z. assert (- k <= g'' z) by (apply B; lra). lra. }
  assert (C : h t - h a <= h' t * (t - a)).
  { apply (rises_at_most h h'); [lra|intros; apply H1; lra|intros x X; apply Rising; lra]. }
  assert (D : h' t * (b - t) <= h b - h t).
  { apply (rises_at_least h h'); [lra|intros; apply H1; lra|intros x X; apply Rising; lra]. }
  assert (G : (h t - h a) * (b - t) <= (h b - h t) * (t - a)).
  { assert ((h t - h a) * (b - t) <= h' t * (t - a) * (b - t)) by (apply Rmult_le_compat_r; lra).
    assert (h' t * (b - t) * (t - a) <= (h b - h t) * (t - a)) by (apply Rmult_le_compat_r; lra). lra. }
  unfold h in G. lra.
Qed.

Section Curves.
Context {E : Type} `{Euclid E}.

Lemma norm_by_itself (x : E) (k : R) : 0 <= k -> norm2 x <= norm x * k -> norm x <= k.
Proof.
  intros K X. rewrite <- norm_sq in X. pose proof (norm_nonneg x).
  destruct (Req_dec (norm x) 0) as [Z|N]; [lra|]. apply Rmult_le_reg_l with (norm x); lra.
Qed.
Lemma dot_at_most (x y : E) (m : R) : norm x <= m -> dot x y <= m * norm y.
Proof. intros X. pose proof (dot_le_norms x y). pose proof (norm_nonneg y). nra. Qed.
End Curves.

Theorem chord_bound_holds : chord_bound.
Proof.
  intros E l H f f' f'' a b m s AB D1 D2 B S. set (t := a + s * (b - a)).
  assert (T : a <= t <= b) by (unfold t; nra).
  assert (M : 0 <= m) by (eapply Rle_trans; [apply norm_nonneg|apply (B a); lra]).
  set (e := (f t - between (f a) (f b) s)%V). apply norm_by_itself.
  - assert (0 <= s * (1 - s)) by (apply Rmult_le_pos; lra). assert (0 <= (b - a) * (b - a)) by (apply Rle_0_sqr).
    assert (0 <= m * (s * (1 - s)) * ((b - a) * (b - a))) by (repeat apply Rmult_le_pos; lra). lra.
  - pose proof (scalar_chord (fun x => dot (f x) e) (fun x => dot (f' x) e) (fun x => dot (f'' x) e) a b (m * norm e) t T) as G.
    cbv beta in G. lapply G; [clear G; intro G|intros; now apply D1]. lapply G; [clear G; intro G|intros; now apply D2].
    lapply G; [clear G; intro G|].
    + assert (F : (b - a) * norm2 e = (dot (f t) e - dot (f a) e) * (b - t) - (dot (f b) e - dot (f t) e) * (t - a)).
      { unfold norm2. transitivity ((b - a) * dot (f t - between (f a) (f b) s) e); [reflexivity|].
        clearbody e. unfold between. autorewrite with dots. unfold t. clear. ring_simplify. ring. }
      assert (Q : m * norm e / 2 * ((t - a) * (b - t)) * (b - a) =
        (b - a) * (norm e * (m * (s * (1 - s)) * ((b - a) * (b - a)) / 2))) by (unfold t; field).
      apply Rmult_le_reg_l with (b - a); [lra|]. rewrite F. lra.
    + intros x X. assert (N : norm (-1 *: f'' x) <= m).
      { replace (norm (-1 *: f'' x)) with (norm (f'' x)); [now apply B|]. unfold norm. f_equal. dots. ring. }
      pose proof (dot_at_most _ e m N) as P. rewrite dot_scale_l in P. lra.
Qed.

Theorem chord_slack_holds : chord_slack.
Proof.
  intros E l H f f' f'' a b m s AB D1 D2 B S. eapply Rle_trans; [exact (chord_bound_holds E l H f f' f'' a b m s AB D1 D2 B S)|].
  assert (M : 0 <= m) by (eapply Rle_trans; [apply norm_nonneg|apply (B a); lra]).
  assert (s * (1 - s) <= 1 / 4) by (pose proof (Rle_0_sqr (s - 1 / 2)) as Q; unfold Rsqr in Q; lra).
  assert (0 <= m * ((b - a) * (b - a))) by (apply Rmult_le_pos; [exact M|apply Rle_0_sqr]).
  set (k := m * ((b - a) * (b - a))) in *. replace (m * (s * (1 - s)) * ((b - a) * (b - a)) / 2) with (k * (s * (1 - s)) / 2) by (unfold k; field).
  assert (0 <= k * (1 / 4 - s * (1 - s))) by (apply Rmult_le_pos; lra). lra.
Qed.

Theorem chord_first_order_holds : chord_first_order.
Proof.
  intros E l H f f' a b m s AB D B S. set (t := a + s * (b - a)).
  assert (T : a <= t <= b) by (unfold t; nra).
  assert (M : 0 <= m) by (eapply Rle_trans; [apply norm_nonneg|apply (B a); lra]).
  assert (Step : forall x y e, a <= x <= y -> y <= b -> dot (f y - f x) e <= m * (y - x) * norm e).
  { intros x y e X Y. rewrite dot_sub_l. replace (m * (y - x) * norm e) with (m * norm e * (y - x)) by ring.
    apply (rises_at_most (fun z => dot (f z) e) (fun z => dot (f' z) e)); [lra|intros; apply D; lra|].
    intros z Z. apply dot_at_most, B. lra. }
  set (e := (f t - between (f a) (f b) s)%V). apply norm_by_itself.
  - assert (0 <= s * (1 - s)) by (apply Rmult_le_pos; lra). repeat apply Rmult_le_pos; lra.
  - pose proof (Step a t e ltac:(lra) ltac:(lra)) as P. pose proof (Step t b (-1 *: e)%V ltac:(lra) ltac:(lra)) as Q.
    replace (norm (-1 *: e)) with (norm e) in Q by (unfold norm; f_equal; dots; ring). rewrite dot_scale_r in Q.
    assert (F : norm2 e = (1 - s) * dot (f t - f a) e + s * (-1 * dot (f b - f t) e)).
    { unfold norm2. transitivity (dot (f t - between (f a) (f b) s) e); [reflexivity|].
      clearbody e. unfold between. autorewrite with dots. ring. }
    rewrite F. replace (t - a) with (s * (b - a)) in P by (unfold t; ring).
    replace (b - t) with ((1 - s) * (b - a)) in Q by (unfold t; ring).
    assert ((1 - s) * dot (f t - f a) e <= (1 - s) * (m * (s * (b - a)) * norm e)) by (apply Rmult_le_compat_l; lra).
    assert (s * (-1 * dot (f b - f t) e) <= s * (m * ((1 - s) * (b - a)) * norm e)) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(* The square over [0, 1], half-way. *)
Definition square (x : R) := x * x.
Lemma square_derivative : derivative square (fun x => 2 * x) 0 1.
Proof.
  intros e t _. unfold square. cbn. replace (2 * t * e) with ((1 * t + t * 1) * e + t * t * 0) by ring.
  apply (derivable_pt_lim_mult (fun x => x * x) (fun _ => e) t); [|apply derivable_pt_lim_const].
  apply (derivable_pt_lim_mult id id); apply derivable_pt_lim_id.
Qed.
Lemma square_bend : derivative (fun x => 2 * x) (fun _ => 2) 0 1.
Proof.
  intros e t _. cbn. replace (2 * e) with ((0 * t + 2 * 1) * e + 2 * t * 0) by ring.
  apply (derivable_pt_lim_mult (fun x => 2 * x) (fun _ => e) t); [|apply derivable_pt_lim_const].
  apply (derivable_pt_lim_mult (fun _ => 2) id); [apply derivable_pt_lim_const|apply derivable_pt_lim_id].
Qed.

Theorem on_chord_is_false : ~ on_chord_somewhere.
Proof.
  intros F. specialize (F square (fun x => 2 * x) (fun _ => 2) 0 1 (1 / 2) ltac:(lra) square_derivative square_bend ltac:(lra)).
  unfold square, between in F. cbn in F. lra.
Qed.

(* The hypotheses can be met: by the square, which bends by 2. *)
Example chord_instance : derivative square (fun x => 2 * x) 0 1 /\ derivative (fun x => 2 * x) (fun _ => 2) 0 1 /\
  within (fun _ : R => 2) 2 0 1 /\ within (fun x => 2 * x) 2 0 1.
Proof.
  repeat split; [exact square_derivative|exact square_bend| |]; intros t T; unfold norm, norm2; cbn.
  - replace 2 with (sqrt (2 * 2)) at 3 by (apply sqrt_square; lra). lra.
  - replace 2 with (sqrt (2 * 2)) at 3 by (apply sqrt_square; lra). apply sqrt_le_1_alt. nra.
Qed.
