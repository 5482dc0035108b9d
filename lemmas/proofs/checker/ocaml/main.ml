(* SPDX-License-Identifier: MIT *)
(* check [--against MODEL [--pose POSE]] FILE_OR_FOLDER...: what proptests/certificate/check does, by the program that is
   extracted from the proofs. check --pairs [--against FIRST SECOND] FILE_OR_FOLDER...: what check_pairs there does. The verdicts
   are the same; the sentences after them need not be. *)
open Canonical
open Document

let most_bytes = 1 lsl 24

let read path = let file = open_in_bin path in
  Fun.protect ~finally:(fun () -> close_in file) (fun () -> really_input_string file (in_channel_length file))

(* What the proofs say of the model, by the checker that has it; that it is the one meant is said by its digest. *)
let require_of_model (c : certificate_file) (m, check) =
  require (c.of_model = m.model_digest) "the model is another one";
  require (c.number_of_node >= 0) "node is none of the model's";
  let numbers = List.map vertex_number c.ids in
  require
    (check { Checker.stated = c.document; node = c.number_of_node; numbers; joints = c.sets_of_joints })
    "a vertex of the node is left out, or is not as the model has it"

let require_of_pose (c : certificate_file) (p : pose_file) =
  require (c.of_pose = p.pose_digest && c.skinning = p.pose_skinning) "the pose is another one";
  List.iter2 (fun joints set ->
      require (Hashtbl.find_opt p.sets joints = Some set) "a joint-set is not as the pose has it")
    c.sets_of_joints c.document.joint_sets

(* What a text is about, if it is proved. *)
let prove_ball model pose text =
  let c = certificate text in
  (match model with
   | None -> require (Checker.check_exactly c.document) "a piece or a vertex is not proved"
   | Some m -> require_of_model c m);
  Option.iter (require_of_pose c) pose;
  Printf.sprintf "%d %s pieces, said to be %s" (List.length c.document.pieces) c.skinning (string_of c.about)

let too_long = "it is too long, or nested too deeply, for this program's stack"

(* The exit status, the verdict and the reason. *)
let judge prove path =
  try
    require (Unix.((stat path).st_kind = S_REG)) "Not a regular file";
    require (Unix.((stat path).st_size <= most_bytes)) "the file has more than 16777216 bytes";
    let text = read path in
    try 0, "accepted", prove text
    with Rejected reason -> 1, "rejected", reason | Stack_overflow -> 1, "rejected", too_long
  with
  | Rejected "Not a regular file" -> 2, "unreadable", "Not a regular file"
  | Rejected reason -> 1, "rejected", reason
  | Sys_error reason -> 2, "unreadable", string_of reason
  | Unix.Unix_error (error, _, _) -> 2, "unreadable", Unix.error_message error

let files path =
  if Sys.file_exists path && Sys.is_directory path then
    match List.filter (fun f -> Filename.check_suffix f ".json") (List.sort compare (Array.to_list (Sys.readdir path))) with
    | [] -> [ path ]
    | found -> List.map (Filename.concat path) found
  else [ path ]

let say verdict path reason = Printf.printf "%s: %s: %s\n" verdict (string_of path) reason

(* The functions that are extracted walk long lists by calling themselves. So where a file may have a list of more than some ten thousand
   members, the program begins again with the largest stack that it may have. Its memory is then in large pages where the system has them
   for programs that ask: making small ones took half of the time. *)
let bytes_for_any_stack = 1 lsl 19
let begun = "REFITLAB_CHECKER_HAS_ITS_STACK"
let has_its_stack = Sys.getenv_opt begun <> None
let () =
  let is_large path = try Unix.((stat path).st_size > bytes_for_any_stack) with Unix.Unix_error _ -> false in
  if not has_its_stack && List.exists is_large (List.concat_map files (List.tl (Array.to_list Sys.argv))) then begin
    Unix.putenv begun "yes";
    if Sys.getenv_opt "GLIBC_TUNABLES" = None then Unix.putenv "GLIBC_TUNABLES" "glibc.malloc.hugetlb=1";
    let largest = "ulimit -s unlimited 2>/dev/null || ulimit -s $(ulimit -H -s) 2>/dev/null; exec \"$0\" \"$@\"" in
    try Unix.execv "/bin/sh" (Array.append [| "sh"; "-c"; largest; Sys.executable_name |] (Array.sub Sys.argv 1 (Array.length Sys.argv - 1)))
    with Unix.Unix_error _ -> ()
  end

(* Documents are read into lists of many short-lived numbers. *)
let () = Gc.set { (Gc.get ()) with minor_heap_size = 1 lsl (if has_its_stack then 19 else 15); space_overhead = 1000 }

let () =
  let model text =
    let m = Document.model text in
    m, Checker.check_exactly_against m.model in
  let bound_to reader path =
    try reader (read path) with
    | Rejected reason | Sys_error reason -> say "unreadable" path (string_of reason); exit 2
    | Stack_overflow -> say "unreadable" path too_long; exit 2 in
  let prove, arguments = match List.tl (Array.to_list Sys.argv) with
    | "--pairs" :: "--against" :: first :: second :: rest ->
        let first = bound_to Pairs.body_document first in
        let second = bound_to Pairs.body_document second in
        Pairs.prove (Some (first, second)), rest
    | "--pairs" :: rest -> Pairs.prove None, rest
    | "--against" :: m :: "--pose" :: p :: rest ->
        let model = bound_to model m in
        prove_ball (Some model) (Some (bound_to Document.pose p)), rest
    | "--against" :: m :: rest -> prove_ball (Some (bound_to model m)) None, rest
    | rest -> prove_ball None None, rest in
  if arguments = [] then
    prerr_endline "usage: check [--against MODEL [--pose POSE] | --pairs [--against FIRST SECOND]] FILE_OR_FOLDER...";
  let status = List.fold_left (fun worst path ->
      let failed, verdict, reason = judge prove path in
      say verdict path reason;
      max worst failed) (if arguments = [] then 2 else 0) (List.concat_map files arguments) in
  exit status
