// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/methods.hpp"

#include <stdexcept>

#include "algorithms/methods/refit/compared_variants.hpp"

namespace refitlab {
namespace {

constexpr int joint_sets_through_descendants = 16;

std::vector<Method> make_methods() {
  std::vector<Method> out;
  for (const RefitVariant& v : compared_variants()) {
    out.push_back({v.name, v.description, &v, {}});
    if (v.name != default_variant(v.skinning).name) continue;
    out.push_back({v.name + "_through_descendants",
                   "the same, but nodes of more than " + std::to_string(joint_sets_through_descendants) +
                       " joint-sets by the balls of descendants that have no more, refitted once a frame",
                   &v,
                   {.most_joint_sets = joint_sets_through_descendants}});
    out.push_back({v.name + "_children_first",
                   "the same, or the smallest ball around the children's balls where that is smaller",
                   &v,
                   {.children_first = true}});
  }
  return out;
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> all = make_methods();
  return all;
}

const Method& method(const std::string& name) {
  for (const Method& c : methods())
    if (c.name == name) return c;
  throw std::invalid_argument("no method named '" + name + "'");
}

std::vector<Ball3<double>> refit_all(const Character& character, const Method& method, const SkinningPalette<double>& palette) {
  if (method.stands_alone()) return refit_all(character, *method.variant, palette);
  FrameRefits frame(character, *method.variant, method.options);
  frame.begin(palette);
  frame.refit_all();
  std::vector<Ball3<double>> balls;
  for (std::size_t n = 0; n < character.tree.nodes.size(); ++n) balls.push_back(frame[static_cast<int>(n)]);
  return balls;
}

}  // namespace refitlab
