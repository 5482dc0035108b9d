// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/certificates/certificates.hpp"

#include <filesystem>
#include <iostream>

#include "algorithms/bake/bake.hpp"
#include "algorithms/certificate/documents.hpp"
#include "algorithms/certificate/limits.hpp"
#include "algorithms/certificate/sha256.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/results/result_file.hpp"
#include "algorithms/runtime/refit/deformed_reference.hpp"
#include "experiments/deformations/deformed_pose.hpp"

namespace refitlab {
namespace {

const Clip* find_clip(const Model& model, const std::string& name) {
  if (name.empty()) return model.clips.empty() ? nullptr : &model.clips[0];
  std::string known;
  for (const Clip& clip : model.clips) {
    if (clip.name == name) return &clip;
    known += (known.empty() ? "; there are: " : ", ") + clip.name;
  }
  throw std::invalid_argument(model.name + ": no clip named '" + name + "'" + known);
}

// A CertifiedMoment is a pose of a model, and its name in a sentence.
struct CertifiedMoment {
  DeformedPose pose;
  std::string name;
};

CertifiedMoment moment_of(const Model& model, const CertificateRequest& request) {
  const Clip* clip = find_clip(model, request.clip);
  if (clip && !(request.seconds >= 0 && request.seconds <= clip->duration))
    throw std::invalid_argument(model.name + ", clip " + clip->name + ": it takes " + format_number(clip->duration) +
                                " s, without a pose at " + format_number(request.seconds) + " s");
  const Animation animation = clip ? clip->animation : Animation{};
  const double time = clip ? request.seconds : 0;
  std::vector<double> weights = model.morphs.empty() ? std::vector<double>{} : morph_weights(model, animation, time);
  const std::string name = clip ? clip->name + " at " + format_number(time) + " s" : "the reference pose";
  if (joints_of(model) == Joints::affine)
    return {deformed_pose(model, affine_pose(model.skeleton, animation, time), std::move(weights)), name};
  return {{clip ? clip->sample(time) : reference_pose(model), {}, {}, std::move(weights)}, name};
}

// Returns the certificate's name with another ending.
std::string beside(const std::string& file, const char* ending) {
  const std::string other = std::filesystem::path(file).replace_extension(ending).string();
  if (other == file) throw std::invalid_argument(file + ": this ending is for what is written beside a certificate");
  return other;
}

}  // namespace

void write_certificate(const CertificateRequest& request, Model model) {
  const RefitVariant& variant = compared_variant(request.variant);
  const auto [pose, moment] = moment_of(model, request);
  Character character = bake(std::move(model));
  const auto nodes = character.tree.nodes.size();
  if (request.node < 0 || static_cast<std::size_t>(request.node) >= nodes)
    throw std::invalid_argument(character.mesh.name + ": no node " + std::to_string(request.node) + "; there are 0 to " +
                                std::to_string(nodes - 1));
  const std::string about =
      "node " + std::to_string(request.node) + " of " + character.mesh.name + ", " + moment + ", by " + variant.name;
  const auto [deformation, palette] = frame_of(character, pose, variant.skinning);
  if (!deformation.is_none()) {
    character = deformed_character(character, deformation);
    character.mesh.name += ", its vertices as in " + moment;
  }
  const auto node = character.refit_node(request.node, palette, variant.pieces);
  const std::string model_file = beside(request.file, ".model"), pose_file = beside(request.file, ".pose");
  const std::string model_text = model_document(character), pose_text = pose_document(character, palette, variant.skinning);
  const CertifiedNode of = certified_node(character, request.node, about, sha256(model_text), sha256(pose_text));
  const std::string text = certificate(node, variant.skinning, variant.refit(node), of);
  write_whole(model_file, model_text);
  write_whole(pose_file, pose_text);
  write_whole(request.file, text);
  std::cerr << note_of_refusal(request.file, refusal_of_certificate(text));
  std::cout << "certificate of " << about << ": " << request.file << "\ncheck it: proptests/certificate/check --against "
            << model_file << " --pose " << pose_file << ' ' << request.file << '\n';
}

}  // namespace refitlab
