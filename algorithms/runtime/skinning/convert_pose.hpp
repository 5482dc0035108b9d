// A joint-set's pose of one number type as that of another: doubles as the exact numbers they are, for example.
#pragma once

#include "algorithms/runtime/skinning/skinning_pose.hpp"

namespace refitlab {

template <class T, class S>
OwnedJointSetPose<T> convert(const JointSetPose<S>& pose) {
  OwnedJointSetPose<T> out;
  for (const auto& c : pose.transforms) out.transforms.push_back({convert<T>(c.rotation), convert<T>(c.translation)});
  out.rotation_center = convert<T>(pose.rotation_center);
  for (const auto& image : pose.center_images) out.center_images.push_back(convert<T>(image));
  for (const auto& dual : pose.duals) out.duals.push_back(convert<T>(dual));
  return out;
}

}  // namespace refitlab
