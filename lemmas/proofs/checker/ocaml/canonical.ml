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

let add_string out text =
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
  let is_plain c = c >= ' ' && c <= '~' && c <> '"' && c <> '\\' in
  Buffer.add_char out '"';
  if String.for_all is_plain text then Buffer.add_string out text else from 0;
  Buffer.add_char out '"'

let string_of text =
  let out = Buffer.create 80 in
  add_string out text;
  Buffer.contents out

let rec add out indent (value : Yojson.Safe.t) =
  let items brackets each = function
    | [] -> Buffer.add_string out brackets
    | list ->
        let line depth = Buffer.add_char out '\n'; for _ = 1 to depth do Buffer.add_char out ' ' done in
        Buffer.add_char out brackets.[0];
        List.iteri (fun i item -> if i > 0 then Buffer.add_char out ','; line (indent + 1); each item) list;
        line indent;
        Buffer.add_char out brackets.[1]
  in
  match value with
  | `String text -> add_string out text
  | `Int i -> Buffer.add_string out (string_of_int i)
  | `List list -> items "[]" (add out (indent + 1)) list
  | `Assoc list -> items "{}" (fun (key, v) -> add_string out key; Buffer.add_string out ": "; add out (indent + 1) v) list
  | _ -> raise (Rejected "a value that no certificate has")

let encode length value =
  let out = Buffer.create length in
  add out 0 value;
  Buffer.add_char out '\n';
  Buffer.contents out

(* Its order of keys is kept: whoever reads an object says which keys it has, in order. *)
let parse text =
  String.iter (fun c -> require (Char.code c < 128) "no ASCII") text;
  let value = try Yojson.Safe.from_string text with Yojson.Json_error _ -> raise (Rejected "no JSON") in
  (match value with `Assoc _ -> () | _ -> raise (Rejected "no document in canonical form"));
  require (encode (String.length text) value = text) "no document in canonical form";
  value

(* The text with another value, a text too, of a key of the document itself. In the canonical form nothing but such a key is
   behind a line feed and one space. *)
let with_text key value text =
  let start = "\n \"" ^ key ^ "\": \"" in
  let n = String.length start in
  let rec find i =
    require (i + n <= String.length text) ("no " ^ key);
    if text.[i] = '\n' && String.sub text i n = start then i + n else find (i + 1) in
  let first = find 0 in
  let last = String.index_from text first '"' in
  String.concat "" [ String.sub text 0 first; value; String.sub text last (String.length text - last) ]
