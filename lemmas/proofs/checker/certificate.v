(* SPDX-License-Identifier: MIT *)
(* Certificates of refitted balls (algorithms/certificate/certificate.hpp), and what an accepted one claims. *)
From Coq Require Import List Reals.
Require Import Refitlab.theory.linear Refitlab.theory.euclid Refitlab.theory.convex Refitlab.theory.quaternion.
Require Import Refitlab.s41_weight_vertices_span Refitlab.a1_affine_image.
Import ListNotations.

(* --- The document, with numbers of any type T --- *)

(* Why a ball holds a piece. The halves have the middle of an edge in place of its first weight vertex, and of its second. Of affine
   joints it is by how much each joint, and their blend at each weight vertex, makes differences longer at most. *)
Inductive bound T := Control | Cap (axis : quat T) | All_rotations | MotionBound (axis : quat T) (center : vec T)
  | Halves (k l : nat) (first second : bound T) | Stretch (of_joints of_weight_vertices : list T).
Arguments Control {T}. Arguments Cap {T}. Arguments All_rotations {T}. Arguments MotionBound {T}. Arguments Halves {T}.
Arguments Stretch {T}.

(* Joints in one pose, in lists by joint. *)
Inductive joint_set T :=
  | Spherical (rotations : list (quat T)) (center_images : list (vec T)) (rotation_center : vec T)
  | Dual_quaternion (rotations duals : list (quat T))
  | Linear (rotations : list (quat T)) (translations : list (vec T))
  | Affine (maps : list (matrix T)) (offsets : list (vec T)).
Arguments Spherical {T}. Arguments Dual_quaternion {T}. Arguments Linear {T}. Arguments Affine {T}.

Record sphere T := Sphere { middle : vec T; reach : T }.
Arguments Sphere {T}. Arguments middle {T}. Arguments reach {T}.

Record piece T := Piece { set_of_piece : nat; reference : sphere T; weight_vertices : list (list T); why : bound T }.
Arguments Piece {T}. Arguments set_of_piece {T}. Arguments reference {T}. Arguments weight_vertices {T}. Arguments why {T}.

(* The weights are the weight vertices of these places, each times its share, divided by the sum of the shares. *)
Record vertex T := Vertex { piece_of_vertex : nat; position : vec T; weights : list T; places : list nat; shares : list T }.
Arguments Vertex {T}. Arguments piece_of_vertex {T}. Arguments position {T}. Arguments weights {T}. Arguments places {T}.
Arguments shares {T}.

Record certificate T := Certificate {
  enclosing : sphere T; joint_sets : list (joint_set T); pieces : list (piece T); vertices : list (vertex T) }.
Arguments Certificate {T}. Arguments enclosing {T}. Arguments joint_sets {T}. Arguments pieces {T}. Arguments vertices {T}.

(* --- Linear blending by quaternions of any length, as the program has it --- *)

Section Linear.
Context {T : Type} {o : Ops T}.
(* v + 2 (s u x v + u x (u x v)) + t for the quaternion s + u. *)
Definition joint_image (q : quat T) (t v : vec T) : vec T :=
  let u := im q in
  ladd (ladd v (lscale (add one one) (ladd (lscale (qw q) (cross u v)) (cross u (cross u v))))) t.
Definition joint_images (qs : list (quat T)) (ts : list (vec T)) (v : vec T) : list (vec T) :=
  map (fun joint => joint_image (fst joint) (snd joint) v) (combine qs ts).
End Linear.

(* --- The claim --- *)

(* What skinning makes of a point v with weights w; its rotation is that of a quaternion that is not 0. *)
Definition skin (js : joint_set R) (w : list R) (v : vec R) : vec R :=
  match js with
  | Spherical qs images c => skin_spherical qs images c w v
  | Dual_quaternion qs ds => skin_dual qs ds w v
  | Linear qs ts => comb w (joint_images qs ts v)
  | Affine ms bs => comb w (affine_images ms bs v)
  end.
Definition is_skinned (js : joint_set R) (w : list R) : Prop :=
  match js with Spherical qs _ _ | Dual_quaternion qs _ => comb w qs <> lzero | Linear _ _ | Affine _ _ => True end.
Definition as_ball (s : sphere R) : ball (vec R) := Ball (middle s) (reach s).

(* The joint-set that a place in the list of pieces has. *)
Definition set_at {T} (c : certificate T) (place : nat) : option (joint_set T) :=
  match nth_error (pieces c) place with Some p => nth_error (joint_sets c) (set_of_piece p) | None => None end.

(* Of a listed vertex: the ball holds it as it is skinned exactly, by its own position and weights. *)
Definition vertex_is_held (c : certificate R) (v : vertex R) : Prop :=
  exists js, set_at c (piece_of_vertex v) = Some js /\
  (is_skinned js (weights v) -> in_ball (as_ball (enclosing c)) (skin js (weights v) (position v))).
(* Of a piece: the ball holds whatever is in its reference ball and has weights in the hull of its weight vertices. *)
Definition piece_is_held (c : certificate R) (p : piece R) : Prop :=
  exists js, nth_error (joint_sets c) (set_of_piece p) = Some js /\
  forall w v, is_weight_vertex_combination (weight_vertices p) w -> in_ball (as_ball (reference p)) v -> is_skinned js w ->
  in_ball (as_ball (enclosing c)) (skin js w v).
Definition claim (c : certificate R) : Prop :=
  (forall v, In v (vertices c) -> vertex_is_held c v) /\ (forall p, In p (pieces c) -> piece_is_held c p).
