// SPDX-License-Identifier: GPL-3.0-or-later
// The measured characters are deformed by joints that scale and by morph targets, which are made up or those of a file.
#pragma once

#include <span>

#include "experiments/deformations/deformed_pose.hpp"
#include "experiments/scenes/animated_character.hpp"

namespace refitlab {

// Scales says how a joint is scaled: not at all, by a factor of its own, or by factors of its own along two axes.
enum class Scales { none, uniform, axes };

// A DeformationKind is a made-up deformation, by its name in tables of results.
struct DeformationKind {
  const char* name;
  Scales scales;
  bool has_morphs;
};
inline constexpr DeformationKind rigid_kind{"rigid", Scales::none, false}, scaled_kind{"scaled", Scales::uniform, false},
    scaled_along_axes_kind{"scaled_along_axes", Scales::axes, false}, morphed_kind{"morphed", Scales::none, true},
    both_kind{"both", Scales::axes, true};
inline constexpr DeformationKind made_up_kinds[] = {rigid_kind, scaled_kind, scaled_along_axes_kind, morphed_kind, both_kind};

// Returns the joints of this pose, which scale about their own origins by 0.55 to 1.25 before they turn.
AffinePose scaled(const SkinnedMesh& mesh, const Pose& pose, Scales scales);

// Gives a mesh three morph targets in place of its own: a belly that swells, a lean, and bumps all over.
void add_targets(SkinnedMesh& mesh);

// DeformingCharacters are a rigid character's model as it is baked for each kind of deformation: for joints that scale or not,
// with the targets of add_targets or none.
class DeformingCharacters {
 public:
  explicit DeformingCharacters(const Model& model);
  const AnimatedCharacter& of(const DeformationKind& kind) const {
    return baked_[kind.scales == Scales::none ? 0 : 1][kind.has_morphs ? 1 : 0];
  }

 private:
  std::vector<AnimatedCharacter> baked_[2];
};

// Returns the poses of all clips of a rigid character, at these shares of their durations. One with morphs has the targets of
// add_targets. Throws ModelError for a clip that is not rigid.
std::vector<DeformedPose> deformed_poses(const AnimatedCharacter& character, const DeformationKind& kind,
                                         std::span<const double> shares);

// Says whether a model has morph targets or joints that scale. Such a model is deformed as its own clips say.
bool deforms_itself(const Model& model);

// Returns the poses of all clips of such a model: its joints and its weights. One without clips is in the pose that it rests
// in, with all weights a half.
std::vector<DeformedPose> own_poses(const Model& model, std::span<const double> shares);

// Returns that many shares of a duration, in the middles of as many equal parts.
std::vector<double> even_shares(int count);

}  // namespace refitlab
