// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/program/clip_certificate.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "algorithms/certificate/sha256.hpp"
#include "algorithms/program/bound_json.hpp"

namespace refitlab {
namespace {

using nlohmann::json;

// Returns the file's names for the parts. A cluster's triangles are those of the file's primitive.
std::vector<json> names_of(const Model& model, const ModelBounds& bounds) {
  const ClusterBounds clusters = clusters_of(model, bounds);
  auto cluster = clusters.clusters.begin();
  std::vector<json> out;
  for (const ModelPart& part : bounds.parts) {
    json& name = out.emplace_back(json{{"kind", name_of(part.kind)}});
    if (part.kind == PartKind::skin || part.kind == PartKind::mesh) name[name_of(part.kind)] = part.index;
    if (part.kind == PartKind::primitive || part.kind == PartKind::cluster) {
      const SourcePrimitive& source = model.sources[part.index];
      name["node"] = source.node, name["mesh"] = source.mesh, name["primitive"] = source.primitive;
    }
    if (part.kind == PartKind::cluster) name["triangles"] = (cluster++)->triangles;
  }
  return out;
}

json list_of(const std::vector<ProvenInterval>& intervals) {
  json out = json::array();
  for (const ProvenInterval& interval : intervals) out.push_back({interval.start, interval.end, interval.slack});
  return out;
}

json json_of_proven(const BoundedPart& part, const PartIntervals& intervals) {
  json out = json_of_bound<json>(part);
  out["slabs"] = json_of_slabs<json>(part);
  out["box_intervals"] = list_of(intervals.box), out["ball_intervals"] = list_of(intervals.ball);
  return out;
}

}  // namespace

std::string clip_certificate(const Model& model, const ModelBounds& bounds, const std::string& baked) {
  // Parts with the same vertices, whose bounds are the same, are proved once.
  const std::vector<json> names = names_of(model, bounds);
  std::map<std::vector<int>, std::size_t> known;
  std::vector<std::size_t> distinct;
  json parts = json::array(), clips = json::array();
  for (std::size_t p = 0; p < bounds.parts.size(); ++p) {
    const auto [found, is_new] = known.try_emplace(bounds.parts[p].vertices, distinct.size());
    if (is_new) distinct.push_back(p), parts.push_back(json::array());
    parts[found->second].push_back(names[p]);
  }
  const auto add = [&](int animation, double duration, const std::vector<BoundedPart>& of_parts,
                       const std::vector<PartIntervals>& intervals) {
    json of_clip = json::array();
    for (const std::size_t p : distinct) of_clip.push_back(json_of_proven(of_parts[p], intervals[p]));
    clips.push_back({{"animation", animation}, {"duration", duration}, {"bounds", of_clip}});
  };
  for (std::size_t c = 0; c < bounds.clips.size(); ++c)
    add(static_cast<int>(c), bounds.clips[c].duration, bounds.clips[c].parts, bounds.clips[c].intervals);
  const PartIntervals moment{{{0, 0, 0}}, {{0, 0, 0}}};
  add(-1, 0, bounds.rest, std::vector<PartIntervals>(bounds.parts.size(), moment));
  return json{{"version", 2},          {"skinning", "linear"},
              {"file", sha256(baked)}, {"directions", json_of_directions<json>(bounds.dop)},
              {"parts", parts},        {"clips", clips}}
             .dump() +
         "\n";
}

}  // namespace refitlab
