(* SPDX-License-Identifier: MIT *)
(* JSON in its canonical form: keys sorted, indented by one space, in ASCII, ended by a line feed. *)
exception Rejected of string

let require condition reason = if not condition then raise (Rejected reason)

(* The character at a place of a text in UTF-8, and its length; a byte that begins none is as what no text has. *)
let character text i =
  let continued k = i + k < String.length text && Char.code text.[i + k] land 0xc0 = 0x80 in
  let bits k = Char.code text.[i + k] land 0x3f in
  let c = Char.code text.[i] in
  if c < 0x80 then c, 1
  else if c land 0xe0 = 0xc0 && continued 1 then ((c land 0x1f) lsl 6) lor bits 1, 2
  else if c land 0xf0 = 0xe0 && continued 1 && continued 2 then
    ((c land 0xf) lsl 12) lor (bits 1 lsl 6) lor bits 2, 3
  else if c land 0xf8 = 0xf0 && continued 1 && continued 2 && continued 3 then
    ((c land 7) lsl 18) lor (bits 1 lsl 12) lor (bits 2 lsl 6) lor bits 3, 4
  else 0xdc00 + c, 1

let string_of text =
  let is_plain c = c >= ' ' && c <= '~' && c <> '"' && c <> '\\' in
  let out = Buffer.create (String.length text + 2) in
  let unit u = Printf.bprintf out "\\u%04x" u in
  let rec from i =
    if i < String.length text then begin
      let c, length = character text i in
      (match c with
       | 0x22 -> Buffer.add_string out "\\\""
       | 0x5c -> Buffer.add_string out "\\\\"
       | 0x08 -> Buffer.add_string out "\\b"
       | 0x09 -> Buffer.add_string out "\\t"
       | 0x0a -> Buffer.add_string out "\\n"
       | 0x0c -> Buffer.add_string out "\\f"
       | 0x0d -> Buffer.add_string out "\\r"
       | c when c >= 0x20 && c < 0x7f -> Buffer.add_char out (Char.chr c)
       | c when c < 0x10000 -> unit c
       | c -> unit (0xd800 + ((c - 0x10000) lsr 10)); unit (0xdc00 + ((c - 0x10000) land 0x3ff)));
      from (i + length)
    end
  in
  Buffer.add_char out '"';
  if String.for_all is_plain text then Buffer.add_string out text else from 0;
  Buffer.add_char out '"';
  Buffer.contents out

(* Half of a character beyond 0xffff, which no text has: it would be ED and then at least A0. *)
let has_half_character text =
  let rec from i = match String.index_from_opt text i '\xed' with
    | Some i when i + 1 < String.length text -> text.[i + 1] >= '\xa0' || from (i + 1)
    | _ -> false in
  from 0

(* Reads a text that is in canonical form, and rejects any other: so texts that are read as the same value are the same. The order of
   keys is kept: whoever reads an object says which keys it has, in order. *)
let parse text =
  let length = String.length text and at = ref 0 in
  let no_form () = raise (Rejected "no document in canonical form") in
  let next () = if !at < length then String.unsafe_get text !at else '\000' in
  let expect c = if next () = c then incr at else no_form () in
  let rec spaces n = if n > 0 then begin expect ' '; spaces (n - 1) end in
  let line indent = expect '\n'; spaces indent in
  let string () =
    expect '"';
    let first = !at in
    let rec plain i =
      if i >= length then no_form ()
      else match String.unsafe_get text i with
        | '"' -> at := i + 1; String.sub text first (i - first)
        | '\\' -> escaped i
        | c -> if c >= ' ' && c <= '~' then plain (i + 1) else no_form ()
    and escaped i =
      if i >= length then no_form ()
      else match String.unsafe_get text i with
        | '"' ->
            let raw = String.sub text (first - 1) (i + 2 - first) in
            let read = try Yojson.Safe.from_string raw with Yojson.Json_error _ -> no_form () in
            (match read with `String s when string_of s = raw && not (has_half_character s) -> at := i + 1; s | _ -> no_form ())
        | '\\' -> escaped (i + 2)
        | c -> if c >= ' ' && c <= '~' then escaped (i + 1) else no_form () in
    plain first in
  let integer () =
    let first = !at in
    if next () = '-' then incr at;
    let digits = !at in
    while next () >= '0' && next () <= '9' do incr at done;
    require (!at > digits && !at - digits <= 15) "no integer of at most 9 digits";
    if text.[digits] = '0' && (!at > digits + 1 || digits > first) then no_form ();
    int_of_string (String.sub text first (!at - first)) in
  let rec value indent : Yojson.Safe.t = match next () with
    | '"' -> `String (string ())
    | '[' -> incr at; if next () = ']' then (incr at; `List []) else `List (items indent (fun () -> value (indent + 1)) ']')
    | '{' -> incr at; if next () = '}' then (incr at; `Assoc []) else `Assoc (items indent (fun () -> member (indent + 1)) '}')
    | '-' | '0' .. '9' -> `Int (integer ())
    | _ -> no_form ()
  and member indent =
    let key = string () in
    expect ':'; expect ' ';
    key, value indent
  and items : 'a. int -> (unit -> 'a) -> char -> 'a list = fun indent one last ->
    let rec from read =
      line (indent + 1);
      let read = one () :: read in
      if next () = ',' then (incr at; from read) else (line indent; expect last; List.rev read) in
    from [] in
  let read = value 0 in
  expect '\n';
  if !at <> length then no_form ();
  match read with `Assoc _ -> read | _ -> no_form ()

(* The text with another value, a text too, of a key of the document itself. In the canonical form nothing but such a key is
   behind a line feed and one space. *)
let with_text key value text =
  let start = " \"" ^ key ^ "\": \"" in
  let n = String.length start in
  let rec find from = match String.index_from_opt text from '\n' with
    | Some i when i + 1 + n <= String.length text ->
        if text.[i + 2] = start.[1] && String.sub text (i + 1) n = start then i + 1 + n else find (i + 1)
    | _ -> raise (Rejected ("no " ^ key)) in
  let first = find 0 in
  let last = String.index_from text first '"' in
  String.concat "" [ String.sub text 0 first; value; String.sub text last (String.length text - last) ]
