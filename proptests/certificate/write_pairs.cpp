// SPDX-License-Identifier: GPL-3.0-or-later
// write_pairs COUNT SEED FOLDER writes certificates of touching triangles of random bodies, for the checkers to agree on.
//
// FOLDER gets a folder of COUNT certificates of a few triangles each, and folders of one certificate each with its documents
// first and second: of skinned meshes, the procedural snake and man, and the real models that are there, in random poses. The
// output says which these are.
#include <filesystem>
#include <iostream>

#include "algorithms/bake/bake.hpp"
#include "algorithms/certificate/pairs_certificate.hpp"
#include "algorithms/results/write_whole.hpp"
#include "algorithms/runtime/collide/cluster_collide.hpp"
#include "experiments/procedural/procedural.hpp"
#include "proptests/gen/posed_bodies.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/real_models.hpp"
#include "proptests/gen/skinned_mesh.hpp"

namespace proptests {
namespace {

using namespace refitlab;

class Writer {
 public:
  Writer(long count, unsigned seed, std::filesystem::path folder) : count_(count), random_(seed), folder_(std::move(folder)) {}

  void run() {
    for (long i = 0; i < count_;) {
      const auto bodies = gen::two_bodies(random_);
      std::vector<TrianglePair> pairs;
      for (const auto& contact : separate(bodies.first, bodies.second).contacts) pairs.push_back(contact.pair);
      try {
        const std::string text = pairs_certificate("random triangles", bodies.first, bodies.second, pairs);
        write("0/" + std::to_string(i++) + ".json", text);
      } catch (const NoProof&) {  // It has too many digits.
      }
    }
    for (int i = 1; i <= 8; ++i) {
      const gen::MeshPlan plan{gen::MeshKind::tube, 2 + pick(11), 3 + pick(6), 1 + pick(4), static_cast<unsigned>(random_())};
      write_posed(i, bake(gen::make_mesh(plan)));
    }
    write_posed(9, bake(make_snake(5)));
    write_posed(10, bake(make_man()));
    int group = 11;
    gen::for_each_real_model(std::cout, [&](Model model) { write_posed(group++, bake(std::move(model))); });
  }

 private:
  int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

  void write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    write_whole((folder_ / name).string(), text);
  }

  // Writes a certificate of the character in two poses, not far from where it was bound.
  void write_posed(int group, const Character& character) {
    const Skinning skinning = std::array{Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}[pick(3)];
    const ClusterTree tree(character);
    ClusterBody a(tree, skinning), b(tree, skinning);
    a.begin(gen::random_pose(character.mesh, random_, 0.1), {{1, 0, 0, 0}, {0, 0, 0}});
    b.begin(gen::random_pose(character.mesh, random_, 0.1), {gen::random_rotation(random_, 0.2), {0.25, 0.125, 0.5}});
    QueryCounts counts;
    const PosedBody first = posed_body(a, "first"), second = posed_body(b, "second");
    const std::string at = std::to_string(group) + "/";
    write(at + "one.json", pairs_certificate(character.mesh.name, first, second, collide(a, b, Query::full, counts)));
    write(at + "first", body_document(first));
    write(at + "second", body_document(second));
  }

  long count_;
  std::mt19937 random_;
  std::filesystem::path folder_;
};

}  // namespace
}  // namespace proptests

int main(int count, char** arguments) try {
  if (count != 4) throw std::invalid_argument("usage: write_pairs COUNT SEED FOLDER");
  proptests::Writer(std::stol(arguments[1]), static_cast<unsigned>(std::stoul(arguments[2])), arguments[3]).run();
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
