// SPDX-License-Identifier: GPL-3.0-or-later
// write_certificates COUNT SEED FOLDER writes certificates of random nodes, each by some sound variant, for the checkers to agree
// on.
//
// FOLDER gets a folder for each model and pose and skinning, with a file model, a file pose and the certificates. The models are
// the procedural ones in clips and in random poses, random meshes of all kinds, and the real ones that are there, which the
// output names.
#include <filesystem>
#include <iostream>

#include "algorithms/bake/bake.hpp"
#include "algorithms/certificate/documents.hpp"
#include "algorithms/certificate/limits.hpp"
#include "algorithms/certificate/sha256.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/results/write_whole.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "proptests/gen/deformations.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/real_models.hpp"
#include "proptests/gen/skinned_mesh.hpp"

namespace proptests {
namespace {

using namespace refitlab;

class Writer {
 public:
  Writer(long count, unsigned seed, std::filesystem::path folder) : left_(count), random_(seed), folder_(std::move(folder)) {}

  void run() {
    std::vector<AnimatedCharacter> characters;
    for (const Model& model : {make_snake(5), make_man(), make_creature()}) characters.push_back(bake_animated(model));
    const std::size_t procedural = characters.size();
    gen::for_each_real_model(std::cout, [&](Model model) { characters.push_back(bake_animated(std::move(model))); });
    while (left_ > 0) {
      const std::size_t which = pick(characters.size() + 15);
      const long left = left_;
      if (which < characters.size()) write_some(characters[which]);
      else write_some(AnimatedCharacter{bake(gen::make_mesh(some_plan())), {}});
      if (which >= procedural && which < characters.size()) of_real_models_ += left - left_;
    }
    std::cout << of_real_models_ << " certificates of balls are of real models\n"
              << too_large_ << " more are not written, since checkers refuse them for their size\n";
  }

 private:
  std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  gen::MeshPlan some_plan() {
    const auto kind = pick(2) ? gen::MeshKind::tube : static_cast<gen::MeshKind>(pick(gen::mesh_kind_count));
    return {kind, static_cast<int>(2 + pick(11)), static_cast<int>(3 + pick(6)), static_cast<int>(1 + pick(4)),
            static_cast<unsigned>(random_())};
  }

  Pose some_pose(const AnimatedCharacter& c) {
    if (!c.clips.empty() && pick(2)) {
      const Clip& clip = c.clips[pick(c.clips.size())];
      return clip.sample(clip.duration * std::uniform_real_distribution<double>(0, 1)(random_));
    }
    return gen::random_pose(c.mesh, random_, std::array{0., 0.1, 0.3, 0.6, 1., 2.}[pick(6)]);
  }

  // Writes certificates of one pose by all skinnings, and of one with affine joints.
  void write_some(const AnimatedCharacter& c) {
    const Pose pose = some_pose(c);
    for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion})
      write_group(c, make_skinning_palette(c.mesh, c.sets, pose, skinning), skinning);
    const auto kind = static_cast<gen::JointKind>(pick(static_cast<std::size_t>(gen::JointKind::extreme)));
    write_group(c, make_skinning_palette(c.mesh, c.sets, gen::random_affine_pose(c.mesh, kind, random_)), Skinning::linear);
  }

  void write_group(const AnimatedCharacter& c, const SkinningPalette<double>& palette, Skinning skinning) {
    const std::string model = model_document(c), pose = pose_document(c, palette, skinning);
    const auto group = folder_ / std::to_string(groups_++);
    std::filesystem::create_directories(group);
    write_whole((group / "model").string(), model);
    write_whole((group / "pose").string(), pose);
    for (int i = 0; i < 20 && left_ > 0; ++i) write_one(c, palette, skinning, sha256(model), sha256(pose), group);
  }

  // Writes one certificate, or nothing for a ball that is all of space.
  void write_one(const Character& c, const SkinningPalette<double>& palette, Skinning skinning, const std::string& model_digest,
                 const std::string& pose_digest, const std::filesystem::path& group) {
    std::vector<const RefitVariant*> variants;
    for (const RefitVariant& v : compared_variants())
      if (v.sound && v.skinning == skinning) variants.push_back(&v);
    const RefitVariant& variant = *variants[pick(variants.size())];
    // Small nodes are most of a tree, and the first are the largest: some have more vertices than is worth checking often.
    const int n = static_cast<int>(pick(pick(2) ? std::min<std::size_t>(c.tree.nodes.size(), 9) : c.tree.nodes.size()));
    if (c.vertices[n].size() > 500) return;
    const auto node = c.refit_node(n, palette, variant.pieces);
    const Ball3<double> ball = variant.refit(node);
    if (std::isinf(ball.radius)) return;
    const std::string about = "node " + std::to_string(n) + " of " + c.mesh.name + ", by " + variant.name;
    const std::string text = certificate(node, skinning, ball, certified_node(c, n, about, model_digest, pose_digest));
    if (!refusal_of_certificate(text).empty()) ++too_large_;
    else write_whole((group / (std::to_string(left_--) + ".json")).string(), text);
  }

  long left_, of_real_models_ = 0, too_large_ = 0, groups_ = 0;
  std::mt19937 random_;
  std::filesystem::path folder_;
};

}  // namespace
}  // namespace proptests

int main(int count, char** arguments) try {
  if (count != 4) throw std::invalid_argument("usage: write_certificates COUNT SEED FOLDER");
  proptests::Writer(std::stol(arguments[1]), static_cast<unsigned>(std::stoul(arguments[2])), arguments[3]).run();
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
