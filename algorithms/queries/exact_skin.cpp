#include "algorithms/queries/exact_skin.hpp"

#include <cmath>

#include "algorithms/skinning/blend.hpp"

namespace refitlab {
namespace {

template <class S>
OwnedJointSetPose<S> as(const JointSetPose<double>& pose) {
  OwnedJointSetPose<S> out;
  for (const auto& c : pose.transforms) out.transforms.push_back({convert<S>(c.rotation), convert<S>(c.translation)});
  out.rotation_center = convert<S>(pose.rotation_center);
  for (const auto& image : pose.center_images) out.center_images.push_back(convert<S>(image));
  for (const auto& dual : pose.duals) out.duals.push_back(convert<S>(dual));
  return out;
}

}  // namespace

ExactSkin::ExactSkin(const Model& model, const JointSets& sets, const SkinningPose<double>& pose, Skinning skinning)
    : model_(model), sets_(sets), pose_(pose), skinning_(skinning), quick_(model.vertices.size()),
      exact_(model.vertices.size()) {}

template <class S>
Vec<S, 3> ExactSkin::skinned(int vertex) const {
  const OwnedJointSetPose<S> pose = as<S>(pose_[sets_.of_vertex(vertex)]);
  std::vector<S> weights;
  for (const double w : sets_.weights(vertex)) weights.push_back(S(w));
  return blend<S>(skinning_, pose, weights, convert<S>(model_.vertices[vertex]));
}

const Vec<Rational, 3>& ExactSkin::exact(int vertex) {
  auto& known = exact_[vertex];
  if (!known) known = skinned<Rational>(vertex);
  return *known;
}

bool ExactSkin::is_in(const Ball3<double>& ball, int vertex) {
  if (!ball.center.allFinite() || !std::isfinite(ball.radius)) return ball.radius == HUGE_VAL;
  auto& quick = quick_[vertex];
  if (!quick) quick = skinned<Interval>(vertex);
  const Verdict v = encloses(Ball3<Interval>{convert<Interval>(ball.center), Interval(ball.radius)}, *quick);
  if (v != Verdict::undecided) return v == Verdict::holds;
  return encloses(Ball3<Rational>{convert<Rational>(ball.center), Rational(ball.radius)}, exact(vertex)) == Verdict::holds;
}

double ExactSkin::excess(const Ball3<double>& ball, int vertex) {
  const Rational squared = squared_distance<Rational, 3>(exact(vertex), convert<Rational>(ball.center));
  const double beyond = CGAL::to_double(Rational(squared - sq(Rational(ball.radius))));
  return beyond / (std::sqrt(CGAL::to_double(squared)) + ball.radius);  // a difference of roots would have no digits left
}

}  // namespace refitlab
