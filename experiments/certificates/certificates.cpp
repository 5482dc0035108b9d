// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/certificates/certificates.hpp"

#include <filesystem>
#include <iostream>

#include "algorithms/bake/bake.hpp"
#include "algorithms/certificate/documents.hpp"
#include "algorithms/certificate/sha256.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/results/result_file.hpp"

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

// A pose and its name in a sentence.
std::pair<Pose, std::string> pose_of(const Model& model, const CertificateRequest& request) {
  const Clip* clip = find_clip(model, request.clip);
  if (!clip) return {reference_pose(model), "the reference pose"};
  if (!(request.seconds >= 0 && request.seconds <= clip->duration))
    throw std::invalid_argument(model.name + ", clip " + clip->name + ": it takes " + format_number(clip->duration) +
                                " s, without a pose at " + format_number(request.seconds) + " s");
  return {clip->sample(request.seconds), clip->name + " at " + format_number(request.seconds) + " s"};
}

// The certificate's name with another ending.
std::string beside(const std::string& file, const char* ending) {
  const std::string other = std::filesystem::path(file).replace_extension(ending).string();
  if (other == file) throw std::invalid_argument(file + ": this ending is for what is written beside a certificate");
  return other;
}

}  // namespace

void write_certificate(const CertificateRequest& request, Model model) {
  const RefitVariant& variant = compared_variant(request.variant);
  const auto [pose, name] = pose_of(model, request);
  const auto character = bake(std::move(model));
  const auto nodes = character.tree.nodes.size();
  if (request.node < 0 || static_cast<std::size_t>(request.node) >= nodes)
    throw std::invalid_argument(character.mesh.name + ": no node " + std::to_string(request.node) + "; there are 0 to " +
                                std::to_string(nodes - 1));
  const std::string about =
      "node " + std::to_string(request.node) + " of " + character.mesh.name + ", " + name + ", by " + variant.name;
  const auto palette = make_skinning_palette(character.mesh, character.sets, pose, variant.skinning);
  const auto node = character.refit_node(request.node, palette, variant.pieces);
  const std::string model_file = beside(request.file, ".model"), pose_file = beside(request.file, ".pose");
  const std::string model_text = model_document(character), pose_text = pose_document(character, palette, variant.skinning);
  const CertifiedNode of = certified_node(character, request.node, about, sha256(model_text), sha256(pose_text));
  const std::string text = certificate(node, variant.skinning, variant.refit(node), of);
  write_whole(model_file, model_text);
  write_whole(pose_file, pose_text);
  write_whole(request.file, text);
  std::cout << "certificate of " << about << ": " << request.file << "\ncheck it: proptests/certificate/check --against "
            << model_file << " --pose " << pose_file << ' ' << request.file << '\n';
}

}  // namespace refitlab
