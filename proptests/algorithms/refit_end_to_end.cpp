// Every sound refit variant on nodes of whole models, against vertices that are skinned exactly.
//
// What is compared: the double data of a posture's joint-sets (quaternions, rotation centers, images of the centers,
// dual parts) are taken as exact rationals, and Equation (1) or the dual quaternions' is evaluated in rationals. They
// divide by the squared norm, so their rotations are exact although quaternions in double are not quite of unit length;
// for linear blending the slightly scaled rotations are part of what is compared. The ball is the one that double
// computes, its numbers taken as they are.
#include <algorithm>
#include <filesystem>
#include <map>
#include <random>

#include "algorithms/model/load.hpp"
#include "algorithms/model/procedural.hpp"
#include "algorithms/refit/character.hpp"
#include "algorithms/skinning/blend.hpp"
#include "lemmas/vocabulary/exact.hpp"
#include "proptests/harness.hpp"

namespace proptests {
namespace {

using namespace refitlab;
using RationalPoint = Vec<Rational, 3>;

constexpr double tolerance = 1e-12;  // of a miss relative to the ball's radius
constexpr int nodes_per_posture = 60, vertices_per_node = 12;

// Two times of each of at most three clips, none of them a key time, where postures tend to be too simple.
std::vector<Posture> postures_of(const Model& model) {
  std::vector<Posture> out;
  for (std::size_t c = 0; c < std::min<std::size_t>(3, model.clips.size()); ++c)
    for (const double share : {0.3718, 0.9141}) out.push_back(model.clips[c].sample(share * model.clips[c].duration));
  if (out.empty()) out.push_back(reference_posture(model));
  return out;
}

OwnedJointSetPose<Rational> as_exact(const JointSetPose<double>& pose) {
  OwnedJointSetPose<Rational> out;
  for (const auto& c : pose.transforms)
    out.transforms.push_back({convert<Rational>(c.rotation), convert<Rational>(c.translation)});
  out.rotation_center = convert<Rational>(pose.rotation_center);
  for (const auto& image : pose.center_images) out.center_images.push_back(convert<Rational>(image));
  for (const auto& dual : pose.duals) out.duals.push_back(convert<Rational>(dual));
  return out;
}

// The vertices of one posture, each skinned exactly when first asked for.
class ExactSkin {
 public:
  ExactSkin(const Character& c, const SkinningPose<double>& pose, Skinning skinning)
      : character_(c), pose_(pose), skinning_(skinning) {}

  const RationalPoint& operator[](int vertex) {
    if (const auto known = done_.find(vertex); known != done_.end()) return known->second;
    const auto pose = as_exact(pose_[character_.sets.of_vertex(vertex)]);
    std::vector<Rational> w;
    for (const double x : character_.sets.weights(vertex)) w.push_back(Rational(x));
    const RationalPoint v = convert<Rational>(character_.model.vertices[vertex]);
    return done_[vertex] = blend<Rational>(skinning_, pose, w, v);
  }

 private:
  const Character& character_;
  const SkinningPose<double>& pose_;
  Skinning skinning_;
  std::map<int, RationalPoint> done_;
};

struct Tally {
  long vertices = 0, misses = 0;
  double worst = 0;  // relative to the radius

  void add(const Ball3<double>& ball, const RationalPoint& v) {
    ++vertices;
    if (!(ball.center.allFinite() && std::isfinite(ball.radius))) {
      ++misses, worst = 1;
      return;
    }
    const Rational r(ball.radius), d2 = squared_distance<Rational, 3>(v, convert<Rational>(ball.center));
    if (r >= 0 && d2 <= r * r) return;
    ++misses;
    const double beyond = CGAL::to_double(Rational(d2 - r * r)) / (std::sqrt(CGAL::to_double(d2)) + ball.radius);
    worst = std::max(worst, beyond / ball.radius);
  }
};

// The first nodes, which carry many joint-sets, and random others.
std::vector<int> some_nodes(const Character& c, std::mt19937& random) {
  const int n = static_cast<int>(c.tree.nodes.size());
  std::vector<int> out;
  for (int i = 0; i < nodes_per_posture; ++i)
    out.push_back(i < nodes_per_posture / 4 ? std::min(i, n - 1)
                                            : std::uniform_int_distribution<int>(0, n - 1)(random));
  return out;
}

Checked check_model(Model model) {
  const Character c(std::move(model));
  std::mt19937 random(2006);
  std::map<std::string, Tally> tallies;
  for (const Posture& posture : postures_of(c.model))
    for (const Skinning skinning :
         {Skinning::linear, Skinning::spherical, Skinning::hejl, Skinning::dual_quaternion}) {
      // Hejl's rotation center changes the pose, not the bound: spherical variants must hold for it too.
      const Skinning bounded = skinning == Skinning::hejl ? Skinning::spherical : skinning;
      const auto pose = make_skinning_pose(c.model, c.sets, posture, skinning);
      ExactSkin skin(c, pose, skinning);
      for (const int n : some_nodes(c, random)) {
        const auto all = c.vertices[n];
        std::vector<int> vertices;
        std::sample(all.begin(), all.end(), std::back_inserter(vertices), vertices_per_node, random);
        for (const RefitVariant& variant : refit_variants()) {
          if (!variant.sound || variant.skinning != bounded) continue;
          const Ball3<double> ball = variant.refit(c.refit_node(n, pose, variant.pieces));
          for (const int v : vertices) tallies[variant.name].add(ball, skin[v]);
        }
      }
    }
  long vertices = 0;
  bool passed = !tallies.empty();
  std::string text = std::to_string(c.tree.nodes.size()) + " nodes; missed by rounding:";
  for (const auto& [name, tally] : tallies) {
    char part[120];
    std::snprintf(part, sizeof part, " %s %.2f %% by %.0e,", name.c_str(),
                  100.0 * double(tally.misses) / double(tally.vertices), tally.worst);
    text += part;
    vertices += tally.vertices;
    passed = passed && tally.worst <= tolerance;
  }
  text.back() = ' ';
  return Checked(passed, vertices, text + "of the radius at most");
}

const char* const sentence =
    "every sound variant's ball in double encloses exactly skinned vertices up to 1e-12 of its radius: ";

}  // namespace

PROPTEST(refit_end_to_end) {
  const Options options{.number_type = "double against rational"};
  t.example(sentence + std::string("the procedural man"), options, [] { return check_model(make_man()); });
  t.example(sentence + std::string("the procedural creature"), options, [] { return check_model(make_creature()); });
  // Relative to the root of the repository, from where the tests are run.
  const std::filesystem::path folder = "out/models";
  for (const char* file : {"BCN_Epileptic.X", "Testwuson.X", "Soldier.glb", "leftHandHigh.glb"})
    t.example(sentence + std::string(file), options, [=] {
      const auto path = folder / file;
      return std::filesystem::exists(path) ? check_model(load_model(path.string()))
                                           : Checked(true, 0, "skipped: " + path.string() + " is not there");
    });
}

}  // namespace proptests
