// SPDX-License-Identifier: GPL-3.0-or-later
// Tests binary glTF files as chunks.
#include "algorithms/runtime/tree/glb_file.hpp"

#include "algorithms/runtime/mesh/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"

namespace proptests::suite_glb_file {
namespace {

using namespace refitlab;

std::vector<GlbChunk> drawn_chunks() {
  std::vector<GlbChunk> chunks = {{json_chunk, *rc::gen::element<std::string>("{}  ", "{\"asset\":{\"version\":\"2.0\"}} ")}};
  for (int n = *rc::gen::inRange(0, 4); n > 0; --n) {
    std::string data(static_cast<std::size_t>(4 * *rc::gen::inRange(0, 5)), '\0');
    for (char& c : data) c = *rc::gen::arbitrary<char>();
    chunks.push_back({*rc::gen::element(bin_chunk, refitlab_chunk, std::uint32_t{7}), data});
  }
  while (chunks[0].data.size() % 4 != 0) chunks[0].data += ' ';
  return chunks;
}

bool is_refused(const std::string& bytes) {
  try {
    read_glb(bytes, "test.glb");
  } catch (const ModelError&) {
    return true;
  }
  return false;
}

}  // namespace

PROPTEST(glb_file) {
  t.holds("chunks are read as they were written", {.number_type = "bytes", .cases = 300}, [] {
    const auto chunks = drawn_chunks();
    const auto again = read_glb(glb_of(chunks, "test.glb"), "test.glb");
    RC_ASSERT(again.size() == chunks.size());
    for (std::size_t i = 0; i < chunks.size(); ++i) RC_ASSERT(again[i].type == chunks[i].type && again[i].data == chunks[i].data);
  });
  t.holds("a file that ends anywhere, or goes on, is refused", {.number_type = "bytes", .cases = 100}, [] {
    const std::string bytes = glb_of(drawn_chunks(), "test.glb");
    for (std::size_t size = 0; size < bytes.size(); ++size) RC_ASSERT(is_refused(bytes.substr(0, size)));
    RC_ASSERT(is_refused(bytes + std::string(4, '\0')));
  });
  t.example("data is padded, with spaces or zeros; another magic, version, size or first chunk is refused", {}, [] {
    const std::string bytes = glb_of({{json_chunk, "{}"}, {bin_chunk, "abcde"}}, "test.glb");
    const auto chunks = read_glb(bytes, "test.glb");
    bool good = chunks[0].data == "{}  " && chunks[1].data == std::string("abcde\0\0\0", 8);
    for (const std::size_t at : {0u, 4u, 8u, 12u, 16u}) {
      std::string other = bytes;
      other[at] = static_cast<char>(other[at] + 1);
      good = good && is_refused(other);
    }
    // The chunk's size is no multiple of four, and all other sizes are as they should be.
    std::string uneven = bytes.substr(0, bytes.size() - 1);
    uneven[8] = static_cast<char>(uneven.size()), uneven[24] = 7;
    // The file is cut in the header and in the data of a chunk, with a total size that fits.
    for (const std::size_t size : {bytes.size() - 12, bytes.size() - 4}) {
      std::string cut = bytes.substr(0, size);
      cut[8] = static_cast<char>(size);
      good = good && is_refused(cut);
    }
    return Checked(good && is_refused(uneven) && is_refused(bytes.substr(0, 12)), 10);
  });
  t.example("JSON that begins with a byte order mark is refused, as the checker of certificates refuses it", {}, [] {
    std::string refusal;
    try {
      read_glb(glb_of({{json_chunk, "\xef\xbb\xbf{}"}}, "test.glb"), "test.glb");
    } catch (const ModelError& error) {
      refusal = error.what();
    }
    return Checked(refusal == "test.glb: chunk 0: its JSON begins with a byte order mark, which is to be left out", 1, refusal);
  });
  t.example("NULs behind the JSON are left out, and one within it is refused", {}, [] {
    using namespace std::string_literals;
    const auto read = [](const std::string& text) {
      try {
        return read_glb(glb_of({{json_chunk, text}}, "test.glb"), "test.glb")[0].data;
      } catch (const ModelError& error) {
        return std::string(error.what());
      }
    };
    const std::string refusal = read("{}\0{}  "s);
    return Checked(read("{}\0\0"s) == "{}" && read("{}\0\0\0\0\0\0"s) == "{}" &&
                       refusal == "test.glb: chunk 0: its JSON has a NUL character",
                   3, refusal);
  });
}

}  // namespace proptests::suite_glb_file
