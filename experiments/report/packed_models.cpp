#include "experiments/report/packed_models.hpp"

#include <algorithm>
#include <stdexcept>

#include "experiments/explorer/packed_model.hpp"
#include "experiments/report/html.hpp"

namespace refitlab {
namespace {

constexpr std::size_t most_bytes = 3 << 20;  // of all models together, as they stand in the page
const char* const procedural[] = {"man", "creature"};

// What the explorer will have is what the run has, but for rounding to float.
void check(const Model& model, const Model& unpacked) {
  double size = 0;
  for (const Point3& v : model.vertices) size = std::max(size, v.norm());
  const auto near = [&](const Point3& a, const Point3& b) { return (a - b).norm() <= 1e-6 * size; };
  bool same = model.triangles == unpacked.triangles && model.vertices.size() == unpacked.vertices.size() &&
              model.clips.size() == unpacked.clips.size();
  for (std::size_t v = 0; same && v < model.vertices.size(); ++v) {
    const auto &a = model.influences[v], &b = unpacked.influences[v];
    same = near(model.vertices[v], unpacked.vertices[v]) &&
           std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Influence& x, const Influence& y) {
             return x.joint == y.joint && x.weight == y.weight;
           });
  }
  for (std::size_t i = 0; same && i < model.clips.size(); ++i) {
    const Posture a = model.clips[i].sample(model.clips[i].duration),
                  b = unpacked.clips[i].sample(model.clips[i].duration);
    for (std::size_t j = 0; same && j < a.size(); ++j)
      same = near(apply(a[j], model.joints[j].origin), apply(b[j], unpacked.joints[j].origin));
  }
  if (!same) throw std::logic_error("packed models: " + model.name + " is another model when it is unpacked");
}

}  // namespace

void PackedModels::add(const Model& model) {
  if (std::find(std::begin(procedural), std::end(procedural), model.name) != std::end(procedural)) return;
  const auto bytes = pack(model);
  check(model, unpack(bytes));
  const std::string line = base64({bytes.begin(), bytes.end()});
  if (lines_.size() + line.size() > most_bytes) left_out_.push_back(model.name);
  else lines_ += line + "\n";
}

std::string PackedModels::html() const {
  std::string out;
  if (!lines_.empty()) out += "<script type=\"text/plain\" id=\"explorer-models\">\n" + lines_ + "</script>\n";
  for (const auto& name : left_out_)
    out += "<p class=\"soft\">" + escape_html(name) +
           " is not among the explorer’s models: the page would become too large.</p>\n";
  return out;
}

}  // namespace refitlab
