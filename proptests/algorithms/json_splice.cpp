// SPDX-License-Identifier: GPL-3.0-or-later
// Members added to JSON text: the value is there, and no other byte changed.
#include "algorithms/program/json_splice.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "proptests/harness.hpp"

namespace proptests::suite_json_splice {
namespace {

using namespace refitlab;
using Json = nlohmann::ordered_json;

// Strings with everything that a scanner could stumble over.
std::string drawn_text() {
  return *rc::gen::element<std::string>("", "a", "extras", "refitlab", "\"", "\\", "{", "}]", ",:", "\xC3\xA4", "\n", "a\\\"b");
}

Json drawn_value(int depth) {
  switch (*rc::gen::inRange(0, depth > 0 ? 7 : 5)) {
    case 0: return nullptr;
    case 1: return *rc::gen::arbitrary<bool>();
    case 2: return *rc::gen::arbitrary<int>();
    case 3: return *rc::gen::inRange(-1000, 1000) / 7.0;
    case 4: return drawn_text();
    case 5: {
      Json list = Json::array();
      for (int n = *rc::gen::inRange(0, 4); n > 0; --n) list.push_back(drawn_value(depth - 1));
      return list;
    }
    default: {
      Json object = Json::object();
      for (int n = *rc::gen::inRange(0, 4); n > 0; --n) object[drawn_text()] = drawn_value(depth - 1);
      return object;
    }
  }
}

// A path from the root to an object, by what is there; and some steps beyond.
JsonPath drawn_path(const Json& root) {
  JsonPath path;
  const Json* at = &root;
  while (*rc::gen::inRange(0, 4) != 0) {
    if (at->is_object() && !at->empty()) {
      auto member = at->begin();
      std::advance(member, *rc::gen::inRange<std::size_t>(0, at->size()));
      if (!member->is_structured()) break;
      path.push_back(member.key()), at = &*member;
    } else if (at->is_array() && !at->empty()) {
      const auto index = *rc::gen::inRange<std::size_t>(0, at->size());
      if (!(*at)[index].is_structured()) break;
      path.push_back(index), at = &(*at)[index];
    } else {
      break;
    }
  }
  if (at->is_array()) return {};
  for (int n = *rc::gen::inRange(0, 3); n > 0; --n) {
    const std::string name = drawn_text();
    if (at && at->contains(name)) break;
    path.push_back(name), at = nullptr;
  }
  return path;
}

}  // namespace

PROPTEST(json_splice) {
  t.holds("the member is there with its value, all else reads as before, and bytes change in one place only",
          {.number_type = "double", .cases = 2000, .degenerate_at_most = 0.7}, [] {
            Json root = drawn_value(3);
            if (!root.is_object()) root = Json{{"meshes", root}};
            const JsonPath path = drawn_path(root);
            const std::string name = drawn_text(), value = drawn_value(2).dump();
            std::string text = root.dump(*rc::gen::inRange(-1, 3));
            if (*rc::gen::arbitrary<bool>()) text = " \n" + text + "\t ";
            if (*rc::gen::inRange(0, 4) == 0) text = "\xEF\xBB\xBF" + text;  // a byte order mark
            const std::string after = with_member(text, path, name, value);
            RC_CLASSIFY(path.empty(), "degenerate");

            Json expected = root;
            Json* at = &expected;
            for (const auto& step : path)
              at = std::holds_alternative<std::string>(step) ? &(*at)[std::get<std::string>(step)]
                                                             : &(*at)[std::get<std::size_t>(step)];
            if (at->is_null()) *at = Json::object();
            const bool is_replaced = at->contains(name);
            (*at)[name] = Json::parse(value);
            RC_ASSERT(Json::parse(after) == expected);
            // What is common at the start and at the end leaves nothing of the text but, at most, an old value.
            const auto start = static_cast<std::size_t>(
                std::mismatch(text.begin(), text.end(), after.begin(), after.end()).first - text.begin());
            const auto end = static_cast<std::size_t>(
                std::mismatch(text.rbegin(), text.rend(), after.rbegin(), after.rend()).first - text.rbegin());
            if (!is_replaced) RC_ASSERT(start + end >= text.size());
          });
  t.holds("a path through what is no object is refused", {.number_type = "double", .cases = 200}, [] {
    const Json leaf = drawn_value(0);
    const std::string text = Json{{"a", {{"b", leaf}}}, {"c", 1}}.dump();
    bool is_refused = false;
    try {
      with_member(text, {"a", "b"}, "x", "1");
    } catch (const std::invalid_argument& e) {
      is_refused = std::string(e.what()) == "/a/b is no object";
    }
    RC_ASSERT(is_refused);
  });
}

}  // namespace proptests::suite_json_splice
