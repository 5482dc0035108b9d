// SPDX-License-Identifier: MIT
#include "algorithms/runtime/tree/binary.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "algorithms/runtime/tree/fingerprint.hpp"

namespace refitlab {
namespace {

std::uint64_t checksum_of(std::string_view bytes) {
  Fingerprint of_bytes;
  of_bytes.add_bytes(bytes);
  return of_bytes.value();
}

}  // namespace

std::string sealed(std::string_view magic, std::uint32_t version, std::string_view body) {
  BinaryWriter out{std::string(magic)};
  out.number(version), out.number(std::uint64_t(body.size())), out.number(checksum_of(body));
  return out.bytes.append(body);
}

BinaryReader opened(std::string_view bytes, std::string_view magic, std::uint32_t version, const std::string& what,
                    const std::string& file) {
  BinaryReader in(bytes, what, file);
  if (bytes.substr(0, magic.size()) != magic) throw ModelError(file, "file", "is no " + what);
  in.take(magic.size());
  std::uint32_t of_file = 0;
  in.number(of_file);
  if (of_file != version)
    throw ModelError(
        file, what,
        "is of version " + std::to_string(of_file) + ", not " + std::to_string(version) + ", which is read: bake it again");
  std::uint64_t size = 0, checksum = 0;
  in.number(size), in.number(checksum);
  if (size > in.rest().size()) throw ModelError(file, what, "ends early");
  if (size < in.rest().size()) throw ModelError(file, what, "goes on after its end");
  if (checksum_of(in.rest()) != checksum) throw ModelError(file, what, "its checksum is not that of its bytes");
  return in;
}

std::string read_bytes(const std::string& path) try {
  std::error_code error;
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_character_file(path, error))
    throw ModelError(path, "file", "cannot be read");  // a device need not end
  return {std::istreambuf_iterator<char>(in), {}};
} catch (const std::ios_base::failure&) {  // of a folder, or a broken disk
  throw ModelError(path, "file", "cannot be read");
}

}  // namespace refitlab
