#include "algorithms/collide/reach.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/balls/smallest_ball.hpp"
#include "algorithms/skinning/rotation_center.hpp"

namespace refitlab {
namespace {

// Of one group: more are bounded about their rotation centers.
constexpr int most_straying_joints = 8;

// What is between the lemma and the numbers here. Squared lengths of 1 +- 1e-6 turn by matrices that are off by 2e-6: a
// joint's, the placement's, their product's; with what float loses, an image is off by less than this share of all
// sizes, for each of the joints that A has.
constexpr double lost = 0x1p-15;
// The lemma wants a least-squares solution for a rotation center. Where rotation_center takes a direction as
// undetermined, A lacks up to 2e-3 of f's distance from the prior for each joint. And the center itself may be 3e4 A
// away, where 2e-6 of it are the most of this share of A.
constexpr float off_unit = 0x1p-4f;
// A dot product that is greater is positive in exact numbers too.
constexpr float positive = 1e-5f;

Box6 everything() { return {-infinite, -infinite, -infinite, infinite, infinite, infinite}; }

}  // namespace

Reach::Reach(const Model& model, const JointSets& sets, Skinning skinning)
    : model_(model), sets_(sets), skinning_(skinning), groups_(make_groups()) {}

std::vector<Reach::Group> Reach::make_groups() const {
  std::vector<std::vector<Point3>> vertices(sets_.count());
  std::vector<Point3> priors;
  for (std::size_t v = 0; v < model_.vertices.size(); ++v)
    vertices[sets_.of_vertex(static_cast<int>(v))].push_back(model_.vertices[v]);
  for (int s = 0; s < sets_.count(); ++s) priors.push_back(center_prior(model_, sets_.joints(s), skinning_));

  const auto is_within = [&](int s, int t) {
    const auto a = sets_.joints(s), b = sets_.joints(t);
    return s != t && std::includes(b.begin(), b.end(), a.begin(), a.end()) &&
           (skinning_ != Skinning::hejl || priors[s] == priors[t]);
  };
  const auto ball_of = [&](const std::vector<int>& list) {
    std::vector<Point3> points;
    for (const int s : list) points.insert(points.end(), vertices[s].begin(), vertices[s].end());
    const Point3 center = skinning_ == Skinning::hejl ? priors[list[0]] : smallest_ball<double, 3>(points).center;
    double radius = 0;
    for (const Point3& p : points) radius = std::max(radius, (p - center).norm());
    return Ball3<double>{center, radius};
  };

  std::vector<Group> groups;
  std::vector<int> others;
  for (int s = 0; s < sets_.count(); ++s) {
    bool is_other = false;
    for (int t = 0; t < sets_.count(); ++t) is_other = is_other || is_within(s, t);
    if (is_other) others.push_back(s);
    else groups.push_back({{s}, ball_of({s}), {sets_.joints(s).begin(), sets_.joints(s).end()}, Four::Zero(), 0, 0});
  }
  // Each joins the group whose ball grows least.
  for (const int s : others) {
    Group* best = nullptr;
    Ball3<double> ball{Point3::Zero(), 0};
    for (Group& g : groups) {
      if (!is_within(s, g.sets[0])) continue;
      std::vector<int> list = g.sets;
      list.push_back(s);
      const Ball3<double> grown = ball_of(list);
      if (!best || grown.radius - g.reference.radius < ball.radius - best->reference.radius) best = &g, ball = grown;
    }
    best->sets.push_back(s);
    best->reference = ball;
  }

  for (Group& g : groups) {
    const double joints = static_cast<double>(g.joints.size());
    const Point3& f = g.reference.center;
    double to_prior = 0;
    for (const int s : g.sets) to_prior = std::max(to_prior, (f - priors[s]).norm());
    g.center << f.cast<float>().array(), 0.f;
    g.radius = static_cast<float>(g.reference.radius * (1 + lost) + lost * joints * f.norm());
    g.unsolved = skinning_ == Skinning::spherical ? static_cast<float>(to_prior * joints / 64) : 0.f;
  }
  return groups;
}

// False if nothing is known.
template <bool strays>
bool Reach::add(const Group& g, const Turned* turned, Bounds& bounds) {
  const int n = static_cast<int>(g.joints.size());
  if (strays && n > most_straying_joints) return false;
  Four images[most_straying_joints], rotations[most_straying_joints];
  Four low = Four::Constant(std::numeric_limits<float>::infinity()), high = -low, squared_a = Four::Zero();
  float c = 1;
  for (int k = 0; k < n; ++k) {
    const Turned& t = turned[g.joints[k]];
    const Four image = t.axes[0] * g.center[0] + t.axes[1] * g.center[1] + t.axes[2] * g.center[2] + t.origin;
    low = low.min(image), high = high.max(image);
    if constexpr (strays) {
      images[k] = image, rotations[k] = t.rotation;
      for (int l = 0; l < k; ++l) {
        const float cosine = (rotations[l] * rotations[k]).sum();
        if (l == 0 && cosine < 0) rotations[k] = -rotations[k];  // the skinning's sign
        c = std::min(c, l == 0 ? std::abs(cosine) : cosine);
        squared_a += (images[l] - image).square();
      }
    }
  }
  float reach = g.radius;
  if (strays && n > 1) {
    if (!(c > positive)) return false;
    const float a = std::sqrt(squared_a.sum()) + g.unsolved;
    reach += (0.75f * std::sqrt(std::max(1 - c, 0.f)) + off_unit) * a;
  }
  bounds.add(low - reach, high + reach);
  return true;
}

// A vertex is within its distance to the rotation center of the hull of the center's images, whatever the rotations.
void Reach::add_about_centers(const Group& g, const Posture& posture, const Quaternion<double>& rotation,
                              Box6& box) const {
  for (const int s : g.sets) {
    std::vector<RigidTransform<double>> transforms;
    for (const int j : sets_.joints(s)) transforms.push_back(posture[j]);
    const Point3 center = rotation_center<double>(transforms, center_prior(model_, sets_.joints(s), skinning_));
    for (const auto& t : transforms) {
      const Point3 image = apply(t, center), at = rotate(rotation, image);
      const double reach = (norm<double, 3>(center - g.reference.center) + g.radius) * (1 + lost) + lost * norm(image);
      for (int i = 0; i < 3; ++i)
        box[i] = std::min(box[i], at[i] - reach), box[3 + i] = std::max(box[3 + i], at[i] + reach);
    }
  }
}

Box6 Reach::box(const Posture& posture, const RigidTransform<double>& placement) const {
  Four matrix[3];  // of the placement's rotation, its columns
  for (int i = 0; i < 3; ++i)
    matrix[i] << rotate<double>(placement.rotation, Point3::Unit(i)).cast<float>().array(), 0.f;
  std::vector<Turned> turned(posture.size());
  Four squared_rotations = Four::Zero(), squared_origins = Four::Zero();
  for (std::size_t j = 0; j < posture.size(); ++j) {
    Turned& t = turned[j];
    const Quaternion<float> q = posture[j].rotation.cast<float>();
    const Vec<float, 3> at = posture[j].translation.cast<float>();
    const float w = q[0], x = q[1], y = q[2], z = q[3];
    t.axes[0] =
        matrix[0] * (1 - 2 * (y * y + z * z)) + matrix[1] * (2 * (x * y + w * z)) + matrix[2] * (2 * (x * z - w * y));
    t.axes[1] =
        matrix[0] * (2 * (x * y - w * z)) + matrix[1] * (1 - 2 * (x * x + z * z)) + matrix[2] * (2 * (y * z + w * x));
    t.axes[2] =
        matrix[0] * (2 * (x * z + w * y)) + matrix[1] * (2 * (y * z - w * x)) + matrix[2] * (1 - 2 * (x * x + y * y));
    t.origin = matrix[0] * at[0] + matrix[1] * at[1] + matrix[2] * at[2];
    t.rotation = q.array();
    squared_rotations += t.rotation.square(), squared_origins += t.origin.square();
  }
  const float farthest = std::sqrt(squared_origins.sum());
  // False for a NaN too, which minima would drop.
  if (!(farthest < 1e15f && squared_rotations.sum() < infinite)) return everything();

  Bounds bounds{Four::Constant(std::numeric_limits<float>::infinity()),
                Four::Constant(-std::numeric_limits<float>::infinity())};
  Box6 about_centers = no_box;
  std::size_t most_joints = 1;
  const bool strays = skinning_ == Skinning::spherical || skinning_ == Skinning::dual_quaternion;
  for (const Group& g : groups_) {
    most_joints = std::max(most_joints, g.joints.size());
    if (strays ? add<true>(g, turned.data(), bounds) : add<false>(g, turned.data(), bounds)) continue;
    if (skinning_ == Skinning::dual_quaternion) return everything();
    add_about_centers(g, posture, placement.rotation, about_centers);
  }
  Box6 box;
  for (int i = 0; i < 3; ++i) {
    const double at = placement.translation[i];
    const double low = std::min<double>(bounds.low[i], about_centers[i]),
                 high = std::max<double>(bounds.high[i], about_centers[3 + i]);
    const double off = lost * static_cast<double>(most_joints) * farthest +
                       1e-14 * (std::max(std::abs(low), std::abs(high)) + std::abs(at));
    box[i] = low + at - off, box[3 + i] = high + at + off;
  }
  return box;
}

}  // namespace refitlab
