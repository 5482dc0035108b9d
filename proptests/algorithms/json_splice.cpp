// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that members of JSON text are added, replaced and removed, and no other byte changes.
#include "algorithms/program/json_splice.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "proptests/harness/harness.hpp"

namespace proptests::suite_json_splice {
namespace {

using namespace refitlab;
using Json = nlohmann::ordered_json;

// Draws strings with everything that a scanner could stumble over.
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

// Draws an edit of a value, and does the same to the value.
JsonEdit drawn_edit(Json& value, int depth, int& changes) {
  JsonEdit edit;
  if (value.is_array() && !value.empty()) {
    for (std::size_t i = 0; i < value.size(); ++i)
      if (*rc::gen::arbitrary<bool>() && value[i].is_structured() && !value[i].empty())
        edit.elements[i] = drawn_edit(value[i], depth, changes);
    return edit;
  }
  if (!value.is_object()) return edit;
  std::vector<std::string> gone;
  for (auto& [name, member] : value.items()) {
    const int what = *rc::gen::inRange(0, 4);
    if (what == 0) edit.members[name].is_removed = true, gone.push_back(name), ++changes;
    if (what == 1) member = drawn_value(1), edit.members[name].value = member.dump(), ++changes;
    if (what == 2 && member.is_structured() && !member.empty()) edit.members[name] = drawn_edit(member, depth, changes);
    if (what == 2 && member.is_null() && depth > 0) {
      member = Json::object();
      edit.members[name] = drawn_edit(member, depth - 1, changes);
      // Nothing is put into it, so it stays null.
      if (member.empty()) member = nullptr;
    }
  }
  for (const std::string& name : gone) value.erase(name);
  std::map<std::string, Json> added;  // The order is that of their names.
  for (int n = *rc::gen::inRange(0, 3); n > 0; --n)
    if (const std::string name = drawn_text(); !value.contains(name) && !edit.members.contains(name)) {
      JsonEdit& inner = edit.members[name];
      Json made = Json::object();
      if (depth > 0 && *rc::gen::arbitrary<bool>()) inner = drawn_edit(made, depth - 1, changes);
      else made = drawn_value(1), inner.value = made.dump(), ++changes;
      if (inner.value.empty() && made.empty()) {
        // The edit removes a member that is not there.
        if (*rc::gen::arbitrary<bool>()) inner.is_removed = true;
        continue;
      }
      added[name] = made;
    }
  for (const auto& [name, made] : added) value[name] = made;
  return edit;
}

}  // namespace

PROPTEST(json_splice) {
  t.holds("what was edited reads as it should, and all else as before, in the same order",
          {.number_type = "double", .cases = 3000, .degenerate_at_most = 0.7, .tags_at_least = {{"several", 0.2}}}, [] {
            Json root = drawn_value(3);
            if (!root.is_object()) root = Json{{"meshes", root}};
            Json expected = root;
            int changes = 0;
            const JsonEdit edit = drawn_edit(expected, 2, changes);
            std::string text = root.dump(*rc::gen::inRange(-1, 3));
            if (*rc::gen::arbitrary<bool>()) text = " \n" + text + "\t ";
            if (*rc::gen::inRange(0, 4) == 0) text = "\xEF\xBB\xBF" + text;  // a byte order mark
            const std::string after = edited(text, edit);
            RC_CLASSIFY(changes == 0, "degenerate");
            RC_CLASSIFY(changes > 1, "several");
            RC_ASSERT(Json::parse(after) == expected);
            if (changes == 0) RC_ASSERT(after == text);
          });
  t.holds("a member that is added leaves every byte as it was", {.number_type = "double", .cases = 1000}, [] {
    Json root = drawn_value(3);
    if (!root.is_object()) root = Json{{"meshes", root}};
    const std::string text = root.dump(*rc::gen::inRange(-1, 3)), name = "added";
    JsonEdit edit;
    JsonEdit* at = &edit;
    Json* there = &root;
    while (!there->empty() && *rc::gen::arbitrary<bool>()) {
      auto inner = there->begin();
      std::advance(inner, *rc::gen::inRange<std::size_t>(0, there->size()));
      if (!inner->is_object()) break;
      at = &at->members[inner.key()], there = &*inner;
    }
    at->members[name].value = "[true]";
    const std::string after = edited(text, edit);
    const auto start =
        static_cast<std::size_t>(std::mismatch(text.begin(), text.end(), after.begin(), after.end()).first - text.begin());
    const auto end =
        static_cast<std::size_t>(std::mismatch(text.rbegin(), text.rend(), after.rbegin(), after.rend()).first - text.rbegin());
    RC_ASSERT(start + end >= text.size());
    (*there)[name] = Json::parse("[true]");
    RC_ASSERT(Json::parse(after) == root);
  });
  t.example("of several members of one name, the last is edited, and all are removed", {}, [] {
    JsonEdit inner, removed;
    inner.members["a"].members["x"].value = "3", removed.members["a"].is_removed = true;
    const std::string text = R"({"a": {"x": 1}, "b": 0, "a": {"x": 2} })";
    return Checked(edited(text, inner) == R"({"a": {"x": 1}, "b": 0, "a": {"x": 3} })" && edited(text, removed) == R"({"b": 0 })",
                   2);
  });
  t.holds("a path through what is no object is refused", {.number_type = "double", .cases = 200}, [] {
    Json leaf = drawn_value(0);
    // It may then become an object.
    if (leaf.is_null()) leaf = true;
    const std::string text = Json{{"a", {{"b", leaf}}}, {"c", 1}}.dump();
    bool is_refused = false;
    try {
      JsonEdit edit;
      edit.members["a"].members["b"].members["x"].value = "1";
      edited(text, edit);
    } catch (const std::invalid_argument& e) {
      is_refused = std::string(e.what()) == "/a/b is no object";
    }
    RC_ASSERT(is_refused);
  });
}

}  // namespace proptests::suite_json_splice
