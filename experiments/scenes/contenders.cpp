#include "algorithms/methods/refit/compared_variants.hpp"
#include "experiments/scenes/contenders.hpp"

#include <stdexcept>

namespace refitlab {
namespace {

constexpr int joint_sets_from_below = 16;

std::vector<Contender> make_contenders() {
  std::vector<Contender> out;
  for (const RefitVariant& v : compared_variants()) {
    out.push_back({v.name, v.description, &v, {}});
    if (&v != &default_variant(v.skinning)) continue;
    out.push_back({v.name + "_from_below",
                   "the same, but nodes of more than " + std::to_string(joint_sets_from_below) +
                       " joint-sets by the balls of descendants that have no more, refitted once a frame",
                   &v, {.most_joint_sets = joint_sets_from_below}});
    out.push_back({v.name + "_children_first", "the same, or the smallest ball around the children's balls where that is smaller", &v,
                   {.children_first = true}});
  }
  return out;
}

}  // namespace

const std::vector<Contender>& contenders() {
  static const std::vector<Contender> all = make_contenders();
  return all;
}

const Contender& contender(const std::string& name) {
  for (const Contender& c : contenders())
    if (c.name == name) return c;
  throw std::invalid_argument("no contender named '" + name + "'");
}

std::vector<Ball3<double>> refit_all(const Character& character, const Contender& contender, const SkinningPose<double>& pose) {
  if (contender.stands_alone()) return refit_all(character, *contender.variant, pose);
  FrameRefits frame(character, *contender.variant, contender.options);
  frame.begin(pose);
  frame.refit_all();
  std::vector<Ball3<double>> balls;
  for (std::size_t n = 0; n < character.tree.nodes.size(); ++n) balls.push_back(frame[static_cast<int>(n)]);
  return balls;
}

}  // namespace refitlab
