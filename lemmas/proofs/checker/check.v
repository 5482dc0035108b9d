(* SPDX-License-Identifier: MIT *)
(* The checker: a program over any numbers that are exact. It is extracted, and run in Coq's kernel; sound.v proves it. *)
From Coq Require Import List Bool PeanoNat.
Require Import Refitlab.theory.linear Refitlab.b3_subdivision Refitlab.a1_affine_image Refitlab.checker.certificate.
Import ListNotations.

(* What the checker computes with. There is no division. *)
Class Num (T : Type) := { num_ops :> Ops T; half_of_one : T; leb : T -> T -> bool }.

(* --- Pairs and triples of weight vertices. What is made of a pair is made once: it stands in tables. --- *)

Section Tables.
Context {X Y Z : Type} (pair : X -> X -> Y) (triple : X -> X -> X -> Y -> Y -> Y -> Z).

(* A row for each weight vertex: itself and those that follow it, with what is made of the pairs. *)
Definition row (a : X) (xs : list X) : list (X * Y) := map (fun b => (b, pair a b)) xs.
Fixpoint rows (xs : list X) : list (list (X * Y)) :=
  match xs with [] => [] | a :: t => row a xs :: rows t end.
(* Of the triples (a, b, c) in order that begin with a: the row of a, and the rows of b. *)
Fixpoint triples_of (a : X) (row_a : list (X * Y)) (table : list (list (X * Y))) : list Z :=
  match row_a, table with
  | (b, ab) :: others, row_b :: table' =>
      map (fun both => triple a b (fst (fst both)) ab (snd (snd both)) (snd (fst both))) (combine row_a row_b)
      ++ triples_of a others table'
  | _, _ => []
  end.
Fixpoint triples (table : list (list (X * Y))) : list Z :=
  match table with
  | [] => []
  | row_a :: table' => match row_a with (a, _) :: _ => triples_of a row_a table | [] => [] end ++ triples table'
  end.
End Tables.

Section Check.
Context {T : Type} {n : Num T}.

Definition ltb (a b : T) := negb (leb b a).
Definition eqb (a b : T) := leb a b && leb b a.
Definition two : T := add one one.
Definition maxb (a b : T) := if leb a b then b else a.
Definition vnorm2 (v : vec T) : T := vdot v v.
Definition qnorm2 (q : quat T) : T := qdot q q.

(* --- Balls --- *)

(* The point (numerator / weight) is in the ball [c, s]; the weight is positive. *)
Definition check_inside (c : vec T) (s : T) (point : vec T * T) : bool :=
  let t := mul s (snd point) in
  leb zero t && leb (vnorm2 (lsub (fst point) (lscale (snd point) c))) (mul t t).
(* The ball [f, sqrt r2] is in [c, s], squared twice. *)
Definition check_ball_inside (f : vec T) (r2 : T) (c : vec T) (s : T) : bool :=
  let apart := vnorm2 (lsub c f) in
  let rest := sub (sub (mul s s) apart) r2 in
  leb zero s && leb zero rest && leb (mul (mul (mul two two) apart) r2) (mul rest rest).

(* --- Bounds: all blends of the weight vertices carry a point x into the ball [c, s] --- *)

(* Control points, times 3 where the degree is 3. *)
Definition dual_control_point (x : vec T) (a b : quat T * quat T) : vec T * T :=
  (ladd (turned (fst a) x (fst b)) (ladd (im (qmul (snd a) (conj (fst b)))) (im (qmul (snd b) (conj (fst a))))),
   qdot (fst a) (fst b)).
Definition spherical_pair (x : vec T) (a b : quat T * vec T) : vec T * T :=
  (turned (fst a) x (fst b), qdot (fst a) (fst b)).
Definition spherical_control_point (a b c : quat T * vec T) (ab bc ac : vec T * T) : vec T * T :=
  (ladd (ladd (ladd (fst ab) (fst bc)) (fst ac))
     (ladd (ladd (lscale (snd bc) (snd a)) (lscale (snd ac) (snd b))) (lscale (snd ab) (snd c))),
   add (add (snd ab) (snd bc)) (snd ac)).
Definition spherical_control_points (table : list (list ((quat T * vec T) * (vec T * T)))) : list (vec T * T) :=
  triples spherical_control_point table.

(* kappa^2 as a numerator and a denominator: the least (q, a)^2 / (||q||^2 ||a||^2), and no more than 1. *)
Definition lesser (k least : T * T) : T * T := if leb (mul (fst k) (snd least)) (mul (fst least) (snd k)) then k else least.
Definition squared_cap_cosine (a : quat T) (qs : list (quat T)) : T * T :=
  fold_right lesser (one, one) (map (fun q => let g := qdot q a in (mul g g, mul (qnorm2 q) (qnorm2 a))) qs).

Definition check_spherical (x c : vec T) (s : T) (b : bound T) (xs : list (quat T * vec T)) : bool :=
  match b with
  | Control =>
      let table := rows (spherical_pair x) xs in
      forallb (forallb (fun entry => ltb zero (snd (snd entry)))) table
      && forallb (check_inside c s) (spherical_control_points table)
  | All_rotations => forallb (fun p => check_ball_inside (snd p) (vnorm2 x) c s) xs
  | Cap a =>
      forallb (fun p => ltb zero (qdot (fst p) a)) xs &&
      (let (num, den) := squared_cap_cosine a (map fst xs) in
       let h := maxb (sub (mul two num) den) zero in  (* times the denominator, as all that follows *)
       let a2 := qnorm2 a in
       let scale := mul den a2 in
       let turned_x := lscale h (turned a x a) in
       let r2 := mul (mul (sub (mul den den) (mul h h)) (vnorm2 x)) (mul a2 a2) in
       forallb (fun p => check_ball_inside (ladd (lscale scale (snd p)) turned_x) r2 (lscale scale c) (mul scale s)) xs)
  | _ => false
  end.

(* E = 2 d + q x - f q *)
Definition reach_error (x f : vec T) (p : quat T * quat T) : quat T :=
  lsub (ladd (lscale two (snd p)) (qmul (fst p) (pure x))) (qmul (pure f) (fst p)).
Definition check_dual (x c : vec T) (s : T) (b : bound T) (xs : list (quat T * quat T)) : bool :=
  match b with
  | Control => forallb (forallb (fun entry => ltb zero (snd (snd entry)) && check_inside c s (snd entry)))
                 (rows (dual_control_point x) xs)
  | MotionBound a f =>
      forallb (fun p =>
        let g := qdot (fst p) a in
        ltb zero g && check_ball_inside (lscale g f) (mul (qnorm2 (reach_error x f p)) (qnorm2 a)) (lscale g c) (mul g s)) xs
  | _ => false
  end.

(* Halves of halves, down to the bounds of one step. *)
Definition middle_of {X} {l : Lin T X} (i j : nat) (xs : list X) : X :=
  lscale half_of_one (ladd (nth i xs lzero) (nth j xs lzero)).
Fixpoint check_bound {X} {l : Lin T X} (check_step : bound T -> list X -> bool) (b : bound T) (xs : list X) : bool :=
  match b with
  | Halves i j first second =>
      let m := middle_of i j xs in
      (i <? length xs) && (j <? length xs)
      && check_bound check_step first (set_nth i m xs) && check_bound check_step second (set_nth j m xs)
  | _ => check_step b xs
  end.

(* Linear blending makes differences at most this many times as long: ||q||^2 + |1 - ||q||^2|. *)
Definition growth (q : quat T) : T := let e := sub one (qnorm2 q) in add (qnorm2 q) (maxb e (sub zero e)).
Definition check_linear (qs : list (quat T)) (ts : list (vec T)) (p : vec T) (r : T) (c : vec T) (s : T)
  (ws : list (list T)) : bool :=
  let images := joint_images qs ts p in
  let growths := map growth qs in
  forallb (fun w => check_ball_inside (comb w images) zero c (sub s (mul r (comb w growths)))) ws.

(* So do affine joints, and their blend at a weight vertex, by the greatest sum of absolute values in a row of A^T A; the blend also
   by no more than the joints do. *)
Definition absolute (x : T) : T := maxb x (sub zero x).
Definition check_stretch (m : matrix T) (s : T) : bool :=
  let '(a, b, c) := m in
  let ab := absolute (vdot a b) in
  let ac := absolute (vdot a c) in
  let bc := absolute (vdot b c) in
  let squared := mul s s in
  leb zero s && leb (add (add (vnorm2 a) ab) ac) squared && leb (add (add ab (vnorm2 b)) bc) squared
  && leb (add (add ac bc) (vnorm2 c)) squared.
Fixpoint check_both {X Y} (test : X -> Y -> bool) (xs : list X) (ys : list Y) : bool :=
  match xs, ys with
  | [], [] => true
  | x :: xs', y :: ys' => test x y && check_both test xs' ys'
  | _, _ => false
  end.
Definition check_affine (ms : list (matrix T)) (bs : list (vec T)) (p : vec T) (r : T) (c : vec T) (s : T)
  (of_joints of_weight_vertices : list T) (ws : list (list T)) : bool :=
  let images := affine_images ms bs p in
  check_both check_stretch ms of_joints
  && check_both (fun w stretch => (leb (comb w of_joints) stretch || check_stretch (comb w ms) stretch)
                                  && check_ball_inside (comb w images) zero c (sub s (mul r stretch))) ws of_weight_vertices.

(* --- Pieces, vertices, certificates --- *)

Definition sum_of (ws : list T) : T := fold_right add zero ws.
Definition check_weights (joints : nat) (w : list T) : bool :=
  (length w =? joints) && forallb (leb zero) w && eqb (sum_of w) one.
Definition check_weight_vertices (joints data : nat) (ws : list (list T)) : bool :=
  (data =? joints) && forallb (check_weights joints) ws.

Definition check_piece (sets : list (joint_set T)) (b : sphere T) (p : piece T) : bool :=
  let v := middle (reference p) in
  let r := reach (reference p) in
  let c := middle b in
  let s := sub (reach b) r in
  leb zero r &&
  match nth_error sets (set_of_piece p) with
  | None => false
  | Some (Spherical qs images rotation_center) =>
      check_weight_vertices (length qs) (length images) (weight_vertices p) && leb zero s &&
      check_bound (check_spherical (lsub v rotation_center) c s) (why p)
        (map (fun w => (comb w qs, comb w images)) (weight_vertices p))
  | Some (Dual_quaternion qs ds) =>
      check_weight_vertices (length qs) (length ds) (weight_vertices p) && leb zero s &&
      check_bound (check_dual v c s) (why p) (map (fun w => (comb w qs, comb w ds)) (weight_vertices p))
  | Some (Linear qs ts) =>
      check_weight_vertices (length qs) (length ts) (weight_vertices p) &&
      match why p with Control => check_linear qs ts v r c (reach b) (weight_vertices p) | _ => false end
  | Some (Affine ms bs) =>
      check_weight_vertices (length ms) (length bs) (weight_vertices p) &&
      match why p with
      | Stretch of_joints of_weight_vertices => check_affine ms bs v r c (reach b) of_joints of_weight_vertices (weight_vertices p)
      | _ => false
      end
  end.

(* The vertex is in the reference ball, and its weights in the hull of the weight vertices. *)
Definition check_vertex (ps : list (piece T)) (v : vertex T) : bool :=
  match nth_error ps (piece_of_vertex v) with
  | None => false
  | Some p =>
      let r := reach (reference p) in
      let chosen := map (fun k => nth k (weight_vertices p) []) (places v) in
      let total := sum_of (shares v) in
      leb (vnorm2 (lsub (position v) (middle (reference p)))) (mul r r)
      && forallb (fun k => k <? length (weight_vertices p)) (places v)
      && (length (shares v) =? length (places v)) && forallb (leb zero) (shares v) && ltb zero total
      && forallb (fun w => length w =? length (weights v)) chosen
      && forallb (fun i => eqb (mul total (nth i (weights v) zero)) (comb (shares v) (map (fun w => nth i w zero) chosen)))
           (seq 0 (length (weights v)))
  end.

Definition check (c : certificate T) : bool :=
  forallb (check_piece (joint_sets c) (enclosing c)) (pieces c) && forallb (check_vertex (pieces c)) (vertices c).
End Check.
