(* SPDX-License-Identifier: MIT *)
(* Certificates, models and poses from JSON: exactly the members that the format has (algorithms/certificate). *)
module Integer = Z
module Rational = Q
open Canonical
open Checker

let most_digits, most_bits, most_work, most_halvings = 400, 8192, 500_000, 32
let steps_a_unit = 1024

let int = function `Int i when abs i < 1_000_000_000 -> i | _ -> raise (Rejected "no integer of at most 9 digits")
let index v = let i = int v in require (i >= 0) "an index is below 0"; i
let text = function `String s -> s | _ -> raise (Rejected "no text")
let list read = function `List (_ :: _ as l) -> List.map read l | _ -> raise (Rejected "no list of something")

(* The values of an object that has these keys, sorted, and no others. *)
let members keys = function
  | `Assoc l when List.map fst l = keys -> List.map snd l
  | _ -> raise (Rejected ("an object has not the members " ^ String.concat ", " keys))

let digest v =
  let s = text v in
  require (String.length s = 64 && String.for_all (fun c -> (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f')) s) "no SHA-256";
  s

(* --- Fractions. What is read says how long the numbers are. --- *)

(* The common denominator of all numbers is 2^twos times odd. Of those whose denominators are powers of two, 2^t, excess is the greatest
   number of bits less t; the others are kept. Of a document that the caller chose, numbers may be of any length. *)
type lengths = {
  mutable twos : int; mutable odd : Integer.t; mutable excess : int; mutable others : Rational.t list; is_limited : bool }
let no_numbers () = { twos = 0; odd = Integer.one; excess = min_int / 2; others = []; is_limited = true }
let of_any_length () = { (no_numbers ()) with is_limited = false }

let bits_of_scale n = Integer.numbits n.odd + n.twos
(* The bits of the longest of the numbers over the common denominator. *)
let longest n =
  let scale = Integer.shift_left n.odd n.twos in
  let length q = Integer.numbits (Rational.num q) + Integer.numbits (Integer.divexact scale (Rational.den q)) in
  List.fold_left (fun most q -> max most (length q)) (max 0 (n.excess + bits_of_scale n)) n.others
let widen n twos odd =
  n.twos <- max n.twos twos;
  if not (Integer.divisible n.odd odd) then n.odd <- Integer.lcm n.odd odd;
  require (bits_of_scale n <= most_bits) "the common denominator has more than 8192 bits"

let rec end_of_digits s i = if i < String.length s && s.[i] >= '0' && s.[i] <= '9' then end_of_digits s (i + 1) else i
(* So many digits are an int for sure. *)
let digits_of_int = 18
let rec int_of_digits s i last value = if i = last then value else int_of_digits s (i + 1) last ((10 * value) + Char.code s.[i] - 48)
let integer_of_digits s first last =
  if last - first <= digits_of_int then Integer.of_int (int_of_digits s first last 0)
  else Integer.of_substring s ~pos:first ~len:(last - first)

(* m / 2^twos in lowest terms. *)
let dyadic n m twos =
  let shared = if Integer.sign m = 0 then twos else min twos (Integer.trailing_zeros m) in
  let m = Integer.shift_right m shared and twos = twos - shared in
  if n.is_limited then begin
    if twos > n.twos then widen n twos Integer.one;
    n.excess <- max n.excess (Integer.numbits m - twos)
  end;
  Dyadic (m, Integer.of_int (-twos))
let fraction n num den =
  let q = Rational.make num den in
  let num, den = Rational.num q, Rational.den q in
  let twos = Integer.trailing_zeros den in
  if twos = Integer.numbits den - 1 then dyadic n num twos
  else begin
    if n.is_limited then begin
      widen n twos (Integer.shift_right den twos);
      n.others <- q :: n.others
    end;
    Fraction { qnum = num; qden = den }
  end

let number n v =
  let s = text v in
  let length = String.length s in
  let first = if length > 0 && s.[0] = '-' then 1 else 0 in
  let line = end_of_digits s first in
  let are_digits first last = last > first && last - first <= most_digits in
  require
    (are_digits first line
     && (line = length
         || (s.[line] = '/' && are_digits (line + 1) length && s.[line + 1] <> '0' && end_of_digits s (line + 1) = length)))
    "no fraction of at most 400 digits each";
  let size = integer_of_digits s first line in
  let num = if first = 1 then Integer.neg size else size in
  if line = length then dyadic n num 0
  else
    let den = integer_of_digits s (line + 1) length in
    let twos = Integer.trailing_zeros den in
    if twos = Integer.numbits den - 1 then dyadic n num twos else fraction n num den

let vec n v = match list (number n) v with [ vx; vy; vz ] -> { vx; vy; vz } | _ -> raise (Rejected "no point")
let quat n v = match list (number n) v with
  | [ qw; qx; qy; qz ] -> { qw; qx; qy; qz } | _ -> raise (Rejected "no quaternion")
let sphere n v = match members [ "center"; "radius" ] v with
  | [ c; r ] -> { middle = vec n c; reach = number n r } | _ -> assert false

(* --- Joint-sets and bounds, by skinning --- *)

let joint_set n skinning v = match skinning with
  | "spherical" -> (match members [ "center_images"; "joints"; "rotation_center"; "rotations" ] v with
      | [ images; joints; center; q ] -> list int joints, Spherical (list (quat n) q, list (vec n) images, vec n center)
      | _ -> assert false)
  | "dual_quaternion" -> (match members [ "duals"; "joints"; "rotations" ] v with
      | [ d; joints; q ] -> list int joints, Dual_quaternion (list (quat n) q, list (quat n) d)
      | _ -> assert false)
  | "linear" -> (match members [ "joints"; "rotations"; "translations" ] v with
      | [ joints; q; t ] -> list int joints, Linear (list (quat n) q, list (vec n) t)
      | _ -> assert false)
  | "affine" -> (match members [ "columns"; "joints"; "offsets" ] v with
      | [ columns; joints; offsets ] ->
          let matrix v = match list (vec n) v with
            | [ a; b; c ] -> (a, b), c | _ -> raise (Rejected "a matrix has not three columns") in
          list int joints, Affine (list matrix columns, list (vec n) offsets)
      | _ -> assert false)
  | _ -> raise (Rejected "skinning is none that is known")

(* (m + d - 1 choose d) *)
let terms m d =
  let m = Integer.of_int m in
  let up k = Integer.add m (Integer.of_int k) in
  match d with
  | 1 -> m
  | 2 -> Integer.(div (mul m (up 1)) (of_int 2))
  | _ -> Integer.(div (mul (mul m (up 1)) (up 2)) (of_int 6))

(* The bound, and the terms that it has for m weight vertices. *)
let rec bound n skinning m halvings v =
  let by = match v with `Assoc l -> (match List.assoc_opt "by" l with Some b -> text b | None -> "") | _ -> "" in
  let alone b d = ignore (members [ "by" ] v); b, terms m d in
  match skinning, by with
  | "linear", "control" -> alone Control 1
  | "spherical", "control" -> alone Control 3
  | "dual_quaternion", "control" -> alone Control 2
  | "spherical", "all_rotations" -> alone All_rotations 1
  | "spherical", "cap" -> (match members [ "axis"; "by" ] v with
      | [ axis; _ ] -> Cap (quat n axis), terms m 1 | _ -> assert false)
  | "dual_quaternion", "reach" -> (match members [ "axis"; "by"; "center" ] v with
      | [ axis; _; center ] -> MotionBound (quat n axis, vec n center), terms m 1 | _ -> assert false)
  | "affine", "stretch" -> (match members [ "by"; "of_joints"; "of_weight_vertices" ] v with
      | [ _; of_joints; of_weight_vertices ] ->
          Stretch (list (number n) of_joints, list (number n) of_weight_vertices), terms m 1
      | _ -> assert false)
  | ("spherical" | "dual_quaternion"), "halves" ->
      require (halvings < most_halvings) "too many halves of halves";
      (match members [ "by"; "edge"; "halves" ] v with
       | [ _; edge; halves ] -> (match list index edge, list (bound n skinning m (halvings + 1)) halves with
           | [ k; l ], [ (a, i); (b, j) ] -> Halves (k, l, a, b), Integer.(add (terms m 1) (add i j))
           | _ -> raise (Rejected "no halves"))
       | _ -> assert false)
  | _ -> raise (Rejected "no bound of this skinning")

(* --- Certificates --- *)

type certificate_file = {
  about : string; of_model : string; of_pose : string; skinning : string; number_of_node : int; ids : int list;
  sets_of_joints : int list list; document : number certificate }

let piece n skinning v = match members [ "bound"; "joint_set"; "reference"; "weight_vertices" ] v with
  | [ b; s; r; c ] ->
      let weight_vertices = list (list (number n)) c in
      let m = List.length weight_vertices in
      let why, cost = bound n skinning m 0 b in
      { set_of_piece = index s; reference = sphere n r; weight_vertices; why },
      Integer.(add cost (mul (of_int m) (of_int (List.length (List.hd weight_vertices)))))
  | _ -> assert false

let vertex n v = match members [ "id"; "piece"; "position"; "shares"; "weight_vertices"; "weights" ] v with
  | [ id; piece; position; shares; weight_vertices; weights ] ->
      let shares = list (number n) shares and weights = list (number n) weights in
      int id, { piece_of_vertex = index piece; position = vec n position; weights; places = list index weight_vertices; shares }
  | _ -> assert false

(* Lists are walked from their beginning to each place: what these steps cost counts, too. *)
let costs_of_vertices pieces vertices =
  let counts = Array.of_list (List.map (fun p -> List.length p.weight_vertices) pieces) in
  let cost v =
    let i = v.piece_of_vertex in
    let m = if i < Array.length counts then counts.(i) else 0 and n = List.length v.weights in
    Integer.of_int (1 + (List.length v.shares * (n + (((n * n) + m) / steps_a_unit)))) in
  List.map cost vertices

let require_little_work n costs =
  let factor = Integer.of_int (1 + ((bits_of_scale n + longest n) / 512)) in
  let work = Integer.(mul (List.fold_left add zero costs) (mul factor factor)) in
  require (Integer.leq work (Integer.of_int most_work)) "the proofs take too much work"

let keys = [ "about"; "ball"; "digest"; "joint_sets"; "model"; "node"; "pieces"; "pose"; "skinning"; "vertices" ]

let certificate file =
  let value = parse file in
  match members keys value with
  | [ about; ball; (`String _ as said); joint_sets; model; node; pieces; pose; skinning; vertices ] ->
      require (Sha256.to_hex (Sha256.string (with_text "digest" "" file)) = text said) "the digest is another one's";
      let n = no_numbers () in
      let skinning = text skinning in
      let enclosing = sphere n ball in
      let joints, joint_sets = List.split (list (joint_set n skinning) joint_sets) in
      let pieces, piece_costs = List.split (list (piece n skinning) pieces) in
      let ids, vertices = List.split (list (vertex n) vertices) in
      require_little_work n (piece_costs @ costs_of_vertices pieces vertices);
      { about = text about; of_model = digest model; of_pose = digest pose; skinning; number_of_node = int node; ids;
        sets_of_joints = joints; document = { enclosing; joint_sets; pieces; vertices } }
  | _ -> raise (Rejected "the digest is no text")

(* --- Models and poses --- *)

type model_file = { name : string; model_digest : string; model : number model }
type pose_file = { pose_digest : string; pose_skinning : string; sets : (int list, number joint_set) Hashtbl.t }

let hash file = Sha256.to_hex (Sha256.string file)

(* Vertices are numbered from 0 in files and from 1 in the proofs. *)
let vertex_number id = require (id >= 0) "the number of a vertex is below 0"; Integer.of_int (id + 1)

let model file = match members [ "name"; "nodes"; "triangles"; "vertices" ] (parse file) with
  | [ name; nodes; triangles; vertices ] ->
      let n = of_any_length () in
      let triangle v = match list int v with
        | [ a; b; c ] -> (vertex_number a, vertex_number b), vertex_number c
        | _ -> raise (Rejected "a triangle has not three vertices") in
      let triangles = list triangle triangles in
      let last = List.length triangles in
      let node v = match list int v with
        | [ first; count ] when first >= 0 && count > 0 && first + count <= last -> first, count
        | _ -> raise (Rejected "a node has triangles that are not there") in
      let point v = match members [ "joints"; "position"; "weights" ] v with
        | [ joints; position; weights ] ->
            { place = vec n position; influences = list int joints; masses = list (number n) weights }
        | _ -> assert false in
      { name = text name; model_digest = hash file;
        model = { points = list point vertices; triangles; nodes = list node nodes } }
  | _ -> assert false

let pose file = match members [ "joint_sets"; "skinning" ] (parse file) with
  | [ joint_sets; skinning ] ->
      let n = of_any_length () in
      let sets = Hashtbl.create 100 in
      List.iter (fun (joints, set) -> Hashtbl.replace sets joints set) (list (joint_set n (text skinning)) joint_sets);
      { pose_digest = hash file; pose_skinning = text skinning; sets }
  | _ -> assert false
