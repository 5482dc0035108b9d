(* SPDX-License-Identifier: MIT *)
(* Certificates of touching triangles from JSON: exactly the members that the format has (algorithms/certificate). *)
module Integer = Z
module Rational = Q
open Canonical
open Document
open Checker

let most_work = 20_000_000

let list_or_none read = function `List l -> List.map read l | _ -> raise (Rejected "no list")
let triple read v = match list read v with [ a; b; c ] -> a, b, c | _ -> raise (Rejected "no list of three")

(* The bits of the common denominator and of the longest of the numbers over it. *)
let bits n = bits_of_scale n + longest n

let body n v = match members [ "name"; "triangles"; "vertices" ] v with
  | [ name; triangles; vertices ] ->
      let triangle v = let a, b, c = triple int v in (vertex_number a, vertex_number b), vertex_number c in
      text name, { corners = list (vec n) vertices; faces = list triangle triangles }
  | _ -> assert false

let step v = match v with
  | `String "first" -> Halve_first, 0
  | `String "second" -> Halve_second, 0
  | `String "contact" -> Touch, 0
  | `Assoc _ -> (match members [ "normal"; "offset" ] v with
      | [ normal; offset ] ->
          let n = no_numbers () in
          let plane = Plane (vec n normal, number n offset) in
          plane, bits n
      | _ -> assert false)
  | _ -> raise (Rejected "no step")

let contact v = match members [ "first"; "pair"; "second" ] v with
  | [ first; pair; second ] ->
      let n = no_numbers () in
      let weights v = let a, b, c = triple (number n) v in [ a; b; c ] in
      let first_weights = weights first in
      let second_weights = weights second in
      (match list int pair with
       | [ i; j ] -> { meeting = vertex_number i, vertex_number j; first_weights; second_weights }, bits n
       | _ -> raise (Rejected "no pair"))
  | _ -> assert false

let require_little_work steps sizes bits =
  let rec walk todo work = function
    | [] -> require (todo = []) "there are steps too few"; work
    | step :: rest -> (match todo with
        | [] -> raise (Rejected "there are steps too many")
        | (m, n) :: others ->
            let todo = match step with
              | Halve_first -> (m / 2, n) :: (m - (m / 2), n) :: others
              | Halve_second -> (m, n / 2) :: (m, n - (n / 2)) :: others
              | Plane _ | Touch -> others in
            walk todo (work + m + n) rest) in
  let factor = 1 + (bits / 512) in
  require (walk [ sizes ] 0 steps * factor * factor <= most_work) "the proof takes too much work"

type file = { about : string; names : string * string; bodies : Yojson.Safe.t * Yojson.Safe.t; document : number pairs }

let keys = [ "about"; "contacts"; "digest"; "first"; "first_order"; "second"; "second_order"; "steps" ]

let certificate file =
  let value = parse file in
  match members keys value with
  | [ about; contacts; (`String _ as said); first_body; first_order; second_body; second_order; steps ] ->
      require (Sha256.to_hex (Sha256.string (with_text "digest" "" file)) = text said) "the digest is another one's";
      let n = no_numbers () in
      let first_name, first = body n first_body in
      let second_name, second = body n second_body in
      let order v = List.map vertex_number (list int v) in
      let steps, bits_of_steps = List.split (list_or_none step steps) in
      let contacts, bits_of_contacts = List.split (list_or_none contact contacts) in
      let first_order = order first_order and second_order = order second_order in
      let most = List.fold_left max (bits n) (bits_of_steps @ bits_of_contacts) in
      require_little_work steps (List.length first_order, List.length second_order) most;
      { about = text about; names = first_name, second_name; bodies = first_body, second_body;
        document = { first; second; first_order; second_order; steps; contacts } }
  | _ -> raise (Rejected "the digest is no text")

(* A body, if that is what the document has. *)
let body_document text =
  let value = parse text in
  ignore (body (of_any_length ()) value);
  value

let prove against file =
  let c = certificate file in
  require (Checker.check_pairs_quickly c.document) "a pair of sets is not parted, or a contact is none";
  Option.iter (fun (first, second) ->
      require (first = fst c.bodies) "the first body is another one";
      require (second = snd c.bodies) "the second body is another one") against;
  Printf.sprintf "%d of %d x %d pairs of triangles touch, said to be %s of %s and %s" (List.length c.document.contacts)
    (List.length c.document.first_order) (List.length c.document.second_order) (string_of c.about)
    (string_of (fst c.names)) (string_of (snd c.names))
