#include "proptests/gen/random_posture.hpp"

namespace proptests::gen {

using namespace refitlab;

Quaternion<double> random_rotation(std::mt19937& random, double spread) {
  std::normal_distribution<double> normal;
  Quaternion<double> q{1, spread * normal(random), spread * normal(random), spread * normal(random)};
  q.normalize();
  return q;
}

Posture random_posture(const SkinnedMesh& model, std::mt19937& random, double spread) {
  std::normal_distribution<double> normal;
  Posture posture = reference_posture(model);
  for (auto& t : posture) {
    t.rotation = random_rotation(random, spread);
    t.translation = Point3(normal(random), normal(random), normal(random)) * 0.2;
  }
  return posture;
}

}  // namespace proptests::gen
