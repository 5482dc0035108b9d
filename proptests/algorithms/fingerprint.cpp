// SPDX-License-Identifier: GPL-3.0-or-later
// Tests fingerprints: those that are published for FNV-1a, and those of parts in order.
#include "algorithms/runtime/tree/fingerprint.hpp"

#include "proptests/harness/harness.hpp"

namespace proptests::suite_fingerprint {
namespace {

using refitlab::Fingerprint;

std::string of_bytes(std::string_view bytes) {
  Fingerprint print;
  print.add_bytes(bytes);
  return print.text();
}

std::string of_texts(const std::vector<std::string>& texts) {
  Fingerprint print;
  for (const auto& text : texts) print.add(std::string_view(text));
  return print.text();
}

}  // namespace

PROPTEST(fingerprint) {
  t.example("the published values", {}, [] {
    return of_bytes("") == "cbf29ce484222325" && of_bytes("a") == "af63dc4c8601ec8c" && of_bytes("foobar") == "85944171f73967e8";
  });
  t.holds("one changed byte changes it", {.cases = 1000}, [] {
    auto text = *rc::gen::nonEmpty(rc::gen::arbitrary<std::string>());
    const std::string before = of_bytes(text);
    text[*rc::gen::inRange<std::size_t>(0, text.size())] ^= static_cast<char>(*rc::gen::inRange(1, 256));
    RC_ASSERT(of_bytes(text) != before);
  });
  t.example("texts do not run into each other, and numbers count", {}, [] {
    Fingerprint one, two;
    one.add(1.0), two.add(1);
    return of_texts({"ab", "c"}) != of_texts({"a", "bc"}) && of_texts({"", "a"}) != of_texts({"a", ""}) &&
           one.text() != two.text();
  });
}

}  // namespace proptests::suite_fingerprint
