// SPDX-License-Identifier: GPL-3.0-or-later
// Tests certificates of refitted balls and their checker, proptests/certificate/check: what is true is accepted, whatever is
// changed is noticed, and no bound proves what is false.
#include "algorithms/certificate/certificate.hpp"

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

#include "algorithms/bake/bake.hpp"
#include "algorithms/certificate/documents.hpp"
#include "algorithms/certificate/limits.hpp"
#include "algorithms/methods/refit/algorithm1_printed.hpp"
#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/model/load.hpp"
#include "algorithms/runtime/skinning/blend.hpp"
#include "algorithms/verification/exact_skin.hpp"
#include "algorithms/verification/synthetic_case.hpp"
#include "experiments/procedural/procedural.hpp"
#include "experiments/scenes/animated_character.hpp"
#include "experiments/scenes/real_models.hpp"
#include "proptests/counterexamples/algorithm1.hpp"
#include "proptests/gen/bare_certified_node.hpp"
#include "proptests/gen/deformations.hpp"
#include "proptests/gen/random_pose.hpp"
#include "proptests/gen/skinned_mesh.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/checked_folder.hpp"

namespace proptests::suite_certificate {
namespace {

using namespace refitlab;
using nlohmann::json;
using oracle::CheckedFolder;
using oracle::sealed;
using Numbers = std::vector<Rational>;

// --- Documents ---

Rational number(const json& x) { return Rational(x.get<std::string>()); }
template <int D>
Vec<Rational, D> vector(const json& x) {
  Vec<Rational, D> out;
  for (int i = 0; i < D; ++i) out[i] = number(x.at(i));
  return out;
}
template <int D>
json as_json(const Vec<Rational, D>& v) {
  json out;
  for (int i = 0; i < D; ++i) out.push_back(as_text(v[i]));
  return out;
}

Skinning skinning_of(const json& document) {
  return document["skinning"] == "linear" || document["skinning"] == "affine" ? Skinning::linear
         : document["skinning"] == "dual_quaternion"                          ? Skinning::dual_quaternion
                                                                              : Skinning::spherical;
}

// Reads what a document says of a joint-set.
OwnedPaletteEntry<Rational> palette_of(const json& set) {
  OwnedPaletteEntry<Rational> out;
  for (std::size_t i = 0; set.contains("columns") && i < set["columns"].size(); ++i) {
    const json& columns = set["columns"][i];
    out.maps.push_back(
        {{vector<3>(columns.at(0)), vector<3>(columns.at(1)), vector<3>(columns.at(2))}, vector<3>(set["offsets"][i])});
  }
  for (std::size_t i = 0; set.contains("rotations") && i < set["rotations"].size(); ++i) {
    out.transforms.push_back({vector<4>(set["rotations"][i]), {0, 0, 0}});
    if (set.contains("translations")) out.transforms[i].translation = vector<3>(set["translations"][i]);
    if (set.contains("center_images")) out.center_images.push_back(vector<3>(set["center_images"][i]));
    if (set.contains("duals")) out.duals.push_back(vector<4>(set["duals"][i]));
  }
  if (set.contains("rotation_center")) out.rotation_center = vector<3>(set["rotation_center"]);
  return out;
}

Ball3<Rational> ball_of(const json& ball) { return {vector<3>(ball["center"]), number(ball["radius"])}; }

Ball3<Rational> exactly(const Ball3<double>& b) { return {convert<Rational>(b.center), Rational(b.radius)}; }

bool same(const Ball3<Rational>& a, const Ball3<Rational>& b) { return a.center == b.center && a.radius == b.radius; }

// Says whether the joints of a document, as it stands in its joint-set, are those of the palette.
bool has_joints(const json& document, const PaletteEntry<Rational>& stated, const PaletteEntry<double>& palette,
                Skinning skinning) {
  if (stated.transforms.size() != (palette.maps.empty() ? palette.transforms.size() : 0) ||
      stated.maps.size() != palette.maps.size() || (document["skinning"] == "affine") == palette.maps.empty())
    return false;
  bool all = true;
  for (std::size_t j = 0; j < palette.maps.size(); ++j) {
    const AffineMap<Rational> map = convert<Rational>(palette.maps[j]);
    all = all && stated.maps[j].columns == map.columns && stated.maps[j].offset == map.offset;
  }
  for (std::size_t j = 0; j < stated.transforms.size(); ++j) {
    all = all && stated.transforms[j].rotation == convert<Rational>(palette.transforms[j].rotation);
    if (skinning == Skinning::linear)
      all = all && stated.transforms[j].translation == convert<Rational>(palette.transforms[j].translation);
    if (skinning == Skinning::dual_quaternion) all = all && stated.duals[j] == convert<Rational>(palette.duals[j]);
    if (skinning == Skinning::spherical) all = all && stated.center_images[j] == convert<Rational>(palette.center_images[j]);
  }
  if (skinning == Skinning::spherical) all = all && stated.rotation_center == convert<Rational>(palette.rotation_center);
  return all;
}

// Says whether the document is about this ball and these inputs, to the last bit.
bool is_about(const json& document, const RefitNode<double>& node, Skinning skinning, const Ball3<double>& ball,
              const CertifiedNode& of) {
  bool all = skinning_of(document) == skinning && same(ball_of(document["ball"]), exactly(ball)) &&
             document["pieces"].size() == node.pieces.size() && document["vertices"].size() == of.vertices.size() &&
             document["node"] == of.number && document["model"] == of.model_digest && document["pose"] == of.pose_digest;
  for (std::size_t i = 0; all && i < of.vertices.size(); ++i) {
    const json& vertex = document["vertices"][i];
    const json& piece = document["pieces"].at(vertex["piece"].get<std::size_t>());
    all = vertex["id"] == of.vertices[i].id && vector<3>(vertex["position"]) == convert<Rational>(of.vertices[i].position) &&
          vertex["weights"].size() == of.vertices[i].weights.size() &&
          document["joint_sets"][piece["joint_set"].get<std::size_t>()]["joints"] == json(of.joints[of.vertices[i].joint_set]);
    for (std::size_t j = 0; all && j < of.vertices[i].weights.size(); ++j)
      all = number(vertex["weights"][j]) == Rational(of.vertices[i].weights[j]);
  }
  for (std::size_t i = 0; all && i < node.pieces.size(); ++i) {
    const json& piece = document["pieces"][i];
    const NodePiece& set = node.pieces[i];
    const auto stated = palette_of(document["joint_sets"].at(piece["joint_set"].get<std::size_t>()));
    const PaletteEntry<double> palette = node.palette[set.joint_set];
    all = same(ball_of(piece["reference"]), exactly(node.piece_reference(i))) &&
          piece["weight_vertices"].size() == std::size_t(set.weight_vertex_count) &&
          has_joints(document, stated, palette, skinning);
    for (int k = 0; all && k < set.weight_vertex_count; ++k)
      for (std::size_t j = 0; j < palette.transforms.size(); ++j)
        all = all && number(piece["weight_vertices"][k].at(j)) == Rational(node.weight_vertex(set, k)[j]);
  }
  return all;
}

// --- What is true ---

// Puts the certificate of a variant's ball into the folder and returns it; a null document if the ball is all of space.
json certify(CheckedFolder& folder, const RefitVariant& variant, const RefitNode<double>& node, const CertifiedNode& of) {
  const Ball3<double> ball = variant.refit(node);
  if (std::isinf(ball.radius)) return {};
  const std::string text = certificate(node, variant.skinning, ball, of);
  folder.add(text);
  const json document = json::parse(text);
  if (!is_about(document, node, variant.skinning, ball, of)) throw std::logic_error("the certificate is about something else");
  return document;
}

json certify(CheckedFolder& folder, const RefitVariant& variant, const RefitNode<double>& node) {
  return certify(folder, variant, node, gen::BareCertifiedNode(node, variant.name));
}

// Returns the node of a character, without its documents.
CertifiedNode certified(const Character& c, int node, const std::string& about) {
  return certified_node(c, node, about, std::string(64, '1'), std::string(64, '2'));
}

// Checks that the checker accepts each of these true certificates, or refuses it for its size, as the writer predicts. Counts
// those accepted.
Checked check_true_ones(const CheckedFolder& folder) {
  const auto lines = folder.check();
  long accepted = 0, refused = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string refusal = refusal_of_certificate(folder.text(i));
    if (!(refusal.empty() ? lines[i].is_accepted() : lines[i].is_rejected_for(refusal)))
      return Checked(false, accepted, lines[i].text + (", where the writer knows of: " + refusal));
    ++(refusal.empty() ? accepted : refused);
  }
  return Checked(true, accepted, refused == 0 ? "" : std::to_string(refused) + " refused for their size");
}

void require_true_ones(const CheckedFolder& folder) {
  const Checked checked = check_true_ones(folder);
  if (!checked.passed) RC_FAIL(checked.detail);
  RC_CLASSIFY(!checked.detail.empty(), "some refused for their size");
}

void check_random_nodes() {
  CheckedFolder folder;
  for (int i = 0; i < 6; ++i) {
    const auto c = gen::rounded_to_double(*gen::refit_case(gen::Turns::any));
    RC_CLASSIFY(!gen::degeneracies(c).empty(), "degenerate");
    const gen::NodeOf<double> node(c);
    for (const RefitVariant& variant : compared_variants())
      if (variant.sound) certify(folder, variant, node.node());
  }
  require_true_ones(folder);
}

// Returns the sound variants of one skinning.
std::vector<const RefitVariant*> sound_variants(Skinning skinning) {
  std::vector<const RefitVariant*> out;
  for (const RefitVariant& variant : compared_variants())
    if (variant.sound && variant.skinning == skinning) out.push_back(&variant);
  return out;
}

// Checks the root and other nodes of a character in a pose by every sound variant, or the root by one of each skinning.
Checked check_nodes(const Character& c, const Pose& pose, std::mt19937& random, int others, bool root_by_all) {
  const auto pick = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  CheckedFolder folder;
  for (int i = 0; i <= others; ++i) {
    const int n = i == 0 ? 0 : static_cast<int>(pick(c.tree.nodes.size()));
    for (const Skinning skinning : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion}) {
      const auto palette = make_skinning_palette(c.mesh, c.sets, pose, skinning);
      auto variants = sound_variants(skinning);
      if (i == 0 && !root_by_all) variants = {variants[pick(variants.size())]};
      for (const RefitVariant* variant : variants)
        certify(folder, *variant, c.refit_node(n, palette, variant->pieces), certified(c, n, variant->name));
    }
  }
  return check_true_ones(folder);
}

// Checks some nodes of a random mesh whose joints are affine, by every sound variant of linear skinning.
void check_affine_nodes() {
  const auto plan = *gen::mesh_plan();
  const gen::JointKind kind = *rc::gen::map(rc::gen::inRange(0, gen::joint_kind_count), [](int k) { return gen::JointKind{k}; });
  RC_CLASSIFY(gen::is_degenerate(plan) || kind == gen::JointKind::flat || kind == gen::JointKind::extreme, "degenerate");
  const auto c = bake(gen::make_mesh(plan));
  std::mt19937 random(plan.seed);
  const auto palette = make_skinning_palette(c.mesh, c.sets, gen::random_affine_pose(c.mesh, kind, random));
  CheckedFolder folder;
  for (const int n : {0, static_cast<int>(random() % c.tree.nodes.size())})
    for (const RefitVariant& variant : compared_variants())
      if (variant.sound && variant.skinning == Skinning::linear)
        certify(folder, variant, c.refit_node(n, palette, variant.pieces), certified(c, n, variant.name));
  require_true_ones(folder);
}

Checked check_model(const AnimatedCharacter& c) {
  std::mt19937 random(2006);
  const Clip& clip = c.clips.at(0);
  Checked checked = check_nodes(c, clip.sample(0.3718 * clip.duration), random, 2, false);
  checked.passed = checked.passed && checked.detail.empty();  // No certificate is refused for its size either.
  return checked;
}

// --- Balls that are no refit of this node in this palette, or a little smaller than one ---

std::vector<Ball3<double>> nearby_balls(const Ball3<double>& ball, std::mt19937& random) {
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const auto power = [&](std::array<double, 3> most) {
    const double largest = most[std::uniform_int_distribution<std::size_t>(0, 2)(random)];
    return std::pow(10, uniform(largest - 4, largest));
  };
  Point3 step;
  for (double& x : step) x = uniform(-1, 1);
  return {{ball.center, std::nextafter(ball.radius, 0)},
          {ball.center, ball.radius / 2},
          {ball.center, ball.radius * (1 - power({-12, -5, -1}))},
          {ball.center + step * (ball.radius * power({-12, -5, 0})), ball.radius}};
}

// Checks that whatever has a certificate is accepted and holds all vertices of the node exactly.
void check_other_balls() {
  // The last two count balls that have no certificate: those that miss a vertex, and those that do not.
  int certified_balls = 0, missing = 0, holding = 0;
  const auto plan = *gen::mesh_plan();
  const auto c = bake(gen::make_mesh(plan));
  std::mt19937 random(plan.seed);
  const double spread = *rc::gen::element(0.0, 0.3, 1.0);
  const Pose pose = gen::random_pose(c.mesh, random, spread), other = gen::random_pose(c.mesh, random, spread);
  const auto pick = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  CheckedFolder folder;
  const auto kind = static_cast<gen::JointKind>(pick(gen::joint_kind_count));
  for (const char* blending : {"linear", "affine", "spherical", "dual quaternion"}) {
    const Skinning skinning = blending[0] == 's'   ? Skinning::spherical
                              : blending[0] == 'd' ? Skinning::dual_quaternion
                                                   : Skinning::linear;
    const auto palette_of_pose = [&](const Pose& p) {
      return blending[0] == 'a' ? make_skinning_palette(c.mesh, c.sets, gen::random_affine_pose(c.mesh, kind, random))
                                : make_skinning_palette(c.mesh, c.sets, p, skinning);
    };
    const auto palette = palette_of_pose(pose), later = palette_of_pose(other);
    ExactSkin skin(c.mesh, c.sets, palette, skinning);
    const auto variants = sound_variants(skinning);
    const RefitVariant& variant = *variants[pick(variants.size())];
    const int n = static_cast<int>(pick(c.tree.nodes.size()));
    const RefitNode<double> node = c.refit_node(n, palette, variant.pieces);
    auto balls = nearby_balls(variant.refit(node), random);
    balls.push_back(variant.refit(c.refit_node(n, later, variant.pieces)));
    balls.push_back(variant.refit(c.refit_node(static_cast<int>(pick(c.tree.nodes.size())), palette, variant.pieces)));
    for (const Ball3<double>& ball : balls) {
      if (!ball.center.allFinite() || !std::isfinite(ball.radius)) continue;
      bool is_outside = false;
      for (const int v : c.vertices[n]) is_outside = is_outside || !skin.is_in(ball, v);
      try {
        folder.add(certificate(node, skinning, ball, certified(c, n, variant.name)));
        ++certified_balls;
        RC_ASSERT(!is_outside);
      } catch (const NoProof&) {
        ++(is_outside ? missing : holding);
      }
    }
  }
  require_true_ones(folder);
  RC_CLASSIFY(certified_balls >= 5, "certified");
  RC_CLASSIFY(missing >= 5, "missing a vertex");
  RC_CLASSIFY(holding > 0, "holding all without a certificate");
}

// --- What is changed ---

// Returns the text with one change of some bytes, which is never without effect.
std::string with_other_bytes(const std::string& text, std::mt19937& random) {
  const auto pick = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  for (;;) {
    std::string out = text;
    const std::size_t at = pick(text.size());
    switch (pick(6)) {
      case 0: out[at] = static_cast<char>(pick(256)); break;
      case 1: out[at] = static_cast<char>(out[at] ^ 1 << pick(8)); break;
      case 2: out.erase(at, 1 + pick(40)); break;
      case 3: out.insert(at, 1, "0123456789\"-/,[]{} \n"[pick(20)]); break;
      case 4: out.resize(at); break;
      default: out.insert(at, out.substr(pick(text.size()), 1 + pick(40)));
    }
    if (out != text) return out;
  }
}

// Lists every value of a document, from the document itself down.
void all_values(json& value, std::vector<json*>& out) {
  out.push_back(&value);
  if (value.is_structured())
    for (json& v : value) all_values(v, out);
}

// Returns the document with one value changed to something of any shape. The document itself stays an object.
json with_other_value(json document, std::mt19937& random) {
  const auto pick = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const json before = document;
  while (document == before) {
    std::vector<json*> values;
    all_values(document, values);
    json& value = *values[pick(values.size())];
    const json others[] = {nullptr,
                           true,
                           0,
                           -1,
                           1.5,
                           "",
                           "1/0",
                           "0/1",
                           "-1",
                           "1e3",
                           "nan",
                           json::array(),
                           json::object(),
                           std::string(5000, '7'),
                           {"1", "2", "3"},
                           *values[pick(values.size())]};
    if (&value != &document && (pick(2) == 0 || !value.is_structured() || value.empty())) {
      value = json(others[pick(std::size(others))]);
    } else if (value.is_object()) {
      const std::string key = std::next(value.begin(), static_cast<std::ptrdiff_t>(pick(value.size()))).key();
      if (pick(2) == 0) value[key + "s"] = json(value[key]);
      if (pick(2) == 0) value.erase(key);
    } else {
      const auto item = value.begin() + static_cast<std::ptrdiff_t>(pick(value.size()));
      if (pick(2) == 0) value.push_back(json(*item));
      else value.erase(item);
    }
  }
  return document;
}

// --- What is false ---

// Returns weights at which a piece is looked at: weight vertices, points between two of them, and the mean of all.
std::vector<Numbers> sampled(const json& weight_vertices) {
  std::vector<Numbers> out;
  for (const json& weight_vertex : weight_vertices) {
    out.emplace_back();
    for (const json& w : weight_vertex) out.back().push_back(number(w));
  }
  const std::size_t m = out.size(), n = out[0].size();
  Numbers middle(n, Rational(0));
  for (std::size_t k = 0; k < m; ++k) {
    for (std::size_t i = 0; i < n; ++i) middle[i] += out[k][i] / Rational(int(m));
    for (std::size_t l = 0; l < k; ++l)
      for (const int eighths : {1, 4, 6}) {
        Numbers between;
        for (std::size_t i = 0; i < n; ++i) between.push_back((out[k][i] * eighths + out[l][i] * (8 - eighths)) / 8);
        out.push_back(between);
      }
  }
  out.push_back(middle);
  return out;
}

// Holds a point whose image shows whether all of the reference ball is inside. The image by a rigid blend is a ball, so that the
// center's distance and r are enough; of a linear blend the center and the six ends of the ball's axes are looked at.
struct Image {
  Vec<Rational, 3> position;
  Rational margin;
};

std::vector<Image> images_of(const json& document, const json& piece) {
  const Skinning skinning = skinning_of(document);
  const auto palette = palette_of(document["joint_sets"][piece["joint_set"].get<std::size_t>()]);
  const auto reference = ball_of(piece["reference"]);
  std::vector<Image> out;
  for (const Numbers& w : sampled(piece["weight_vertices"])) {
    if (skinning != Skinning::linear) {
      if (squared_norm(blend_quaternion<Rational>(palette, w)) == 0) continue;
      out.push_back({blend<Rational>(skinning, palette, w, reference.center), reference.radius});
    } else {
      for (int end = 0; end < 7; ++end) {
        Vec<Rational, 3> v = reference.center;
        if (end < 6) v[end / 2] += end % 2 ? reference.radius : -reference.radius;
        out.push_back({blend_linear<Rational>(palette, w, v), Rational(0)});
      }
    }
  }
  return out;
}

// Returns a listed vertex as it is skinned, unless its blend is 0.
std::optional<Vec<Rational, 3>> image_of(const json& document, const json& vertex) {
  const json& piece = document["pieces"].at(vertex["piece"].get<std::size_t>());
  const auto palette = palette_of(document["joint_sets"][piece["joint_set"].get<std::size_t>()]);
  Numbers w;
  for (const json& x : vertex["weights"]) w.push_back(number(x));
  const Skinning skinning = skinning_of(document);
  if (skinning != Skinning::linear && squared_norm(blend_quaternion<Rational>(palette, w)) == 0) return {};
  return blend<Rational>(skinning, palette, w, vector<3>(vertex["position"]));
}

// Says whether some vertex is outside, exactly.
bool is_false(const json& document) {
  const auto ball = ball_of(document["ball"]);
  for (const json& piece : document["pieces"])
    for (const Image& image : images_of(document, piece))
      if (encloses(ball, Ball3<Rational>{image.position, image.margin}) != Verdict::holds) return true;
  for (const json& vertex : document["vertices"])
    if (const auto position = image_of(document, vertex); position && encloses<Rational, 3>(ball, *position) != Verdict::holds)
      return true;
  return false;
}

// Returns the least radius that the images seen allow, up to rounding.
double needed_radius(const json& document) {
  const auto center = vector<3>(document["ball"]["center"]);
  double needed = 0;
  for (const json& piece : document["pieces"])
    for (const Image& image : images_of(document, piece)) {
      const double apart = CGAL::to_double(squared_distance<Rational, 3>(center, image.position));
      needed = std::max(needed, std::sqrt(apart) + CGAL::to_double(image.margin));
    }
  return needed;
}

class Forger {
 public:
  explicit Forger(std::mt19937& random) : random_(random) {}

  // Changes inputs and bounds or not, and then makes the radius a little less than is needed. The center is moved by little or
  // far: seen from afar, any image may be the farthest, not only those of weight vertices.
  json forge(json document) {
    json& piece = document["pieces"][pick(document["pieces"].size())];
    json& set = document["joint_sets"][piece["joint_set"].get<std::size_t>()];
    const std::size_t joint = pick(set["joints"].size());
    const bool is_affine = set.contains("columns");
    json& part = is_affine ? set["columns"][joint][pick(3)] : set["rotations"][joint];
    switch (pick(7)) {
      case 0: part = is_affine ? as_json<3>(some_vector<3>()) : as_json<4>(some_vector<4>()); break;  // a joint is turned
      case 1: part = is_affine ? as_json<3>(-vector<3>(part)) : as_json<4>(-vector<4>(part)); break;
      case 2: move(set, joint); break;
      case 3: widen(piece["weight_vertices"]); break;
      case 4: piece["reference"]["radius"] = as_text(number(piece["reference"]["radius"]) + Rational(int(pick(3)), 8)); break;
      case 5: piece["reference"]["center"] = as_json<3>(some_vector<3>()); break;
      default: break;
    }
    const Rational far[] = {0, Rational(1, 64), 1, 64};
    document["ball"]["center"] = as_json<3>(vector<3>(document["ball"]["center"]) + some_vector<3>() * far[pick(4)]);
    for (json& p : document["pieces"])
      if (pick(2) == 0) p["bound"] = some_bound(document, p, 3);
    const double gap = std::pow(10., -3. - double(pick(6)));
    document["ball"]["radius"] = as_text(Rational(needed_radius(document) * (1 - gap)));
    return oracle::with_weight_vertex_vertices(document);
  }

 private:
  std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  template <int D>
  Vec<Rational, D> some_vector() {
    Vec<Rational, D> v;
    for (int i = 0; i < D; ++i) v[i] = Rational(int(pick(17)) - 8, 8);
    return v;
  }

  void move(json& set, std::size_t joint) {
    if (set.contains("duals")) {
      set["duals"][joint] = as_json<4>(some_vector<4>());
    } else {
      const char* data = set.contains("offsets") ? "offsets" : set.contains("translations") ? "translations" : "center_images";
      set[data][joint] = as_json<3>(vector<3>(set[data][joint]) + some_vector<3>());
    }
  }
  // Replaces one weight vertex by a vertex of the whole simplex.
  void widen(json& weight_vertices) {
    json& weight_vertex = weight_vertices[pick(weight_vertices.size())];
    const std::size_t n = weight_vertex.size(), one = pick(n);
    for (std::size_t i = 0; i < n; ++i) weight_vertex[i] = i == one ? "1" : "0";
  }

  // Returns any bound that has the shape of one, or a given one whose halves are cut.
  json some_bound(const json& document, const json& piece, int depth) {
    const std::size_t m = piece["weight_vertices"].size();
    if (document["skinning"] == "affine") {
      // The factors are those that were found, all times one number, or some of them are anything.
      const Rational factors[] = {0, 1, Rational(1, 2), Rational(999, 1000), 1000, -1};
      json bound = piece["bound"];
      const Rational factor = factors[pick(6)];
      for (const char* of : {"of_joints", "of_weight_vertices"})
        for (json& stretch : bound[of])
          if (pick(3)) stretch = as_text(number(stretch) * factor);
          else if (pick(3) == 0) stretch = as_text(Rational(int(pick(17)) - 4, 8));
      return bound;
    }
    if (pick(4) == 0 && piece["bound"].contains("halves")) return piece["bound"]["halves"][pick(2)];
    if (depth > 0 && pick(3) == 0 && document["skinning"] != "linear")
      return {{"by", "halves"},
              {"edge", {pick(m), pick(m)}},
              {"halves", {some_bound(document, piece, depth - 1), some_bound(document, piece, depth - 1)}}};
    const auto& rotations = document["joint_sets"][piece["joint_set"].get<std::size_t>()]["rotations"];
    const json axis = pick(2) ? as_json<4>(some_vector<4>()) : rotations[pick(rotations.size())];
    switch (document["skinning"] == "linear" ? 0 : pick(document["skinning"] == "spherical" ? 4 : 2)) {
      case 0: return {{"by", "control"}};
      case 1:
        if (document["skinning"] == "dual_quaternion")
          return {{"by", "reach"}, {"axis", axis}, {"center", document["ball"]["center"]}};
        return {{"by", "all_rotations"}};
      default: return {{"by", "cap"}, {"axis", axis}};
    }
  }

  std::mt19937& random_;
};

// Returns certificates of small random nodes.
std::vector<json> some_certificates() {
  CheckedFolder folder;
  std::vector<json> out;
  const auto c = gen::rounded_to_double(*gen::refit_case(*rc::gen::element(gen::Turns::any, gen::Turns::moderate)));
  const gen::NodeOf<double> node(c);
  for (const char* name : {"linear", "spherical_repaired", "control_miniball", "dual_quaternion_control_near"})
    if (json document = certify(folder, compared_variant(name), node.node()); !document.is_null()) out.push_back(document);
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const auto mesh = bake(gen::make_mesh({gen::MeshKind::tube, 3, 3, 2, static_cast<unsigned>(random())}));
  const auto kind = *rc::gen::element(gen::JointKind::rigid, gen::JointKind::uniform, gen::JointKind::axes, gen::JointKind::shear,
                                      gen::JointKind::flat);
  const auto palette = make_skinning_palette(mesh.mesh, mesh.sets, gen::random_affine_pose(mesh.mesh, kind, random));
  const RefitVariant& linear = compared_variant("linear");
  const int last = static_cast<int>(mesh.tree.nodes.size()) - 1;
  out.push_back(certify(folder, linear, mesh.refit_node(last, palette, linear.pieces), certified(mesh, last, "affine")));
  return out;
}

// Holds the root of a tube whose joints are turned a little.
struct BentTube {
  const Character c = bake(gen::make_mesh({gen::MeshKind::tube, 12, 4, 3, 2006}));
  std::mt19937 random{2006};
  const SkinningPalette<double> palette =
      make_skinning_palette(c.mesh, c.sets, gen::random_pose(c.mesh, random, 0.2), Skinning::spherical);
  const RefitVariant& variant = compared_variant("control_miniball");
  const RefitNode<double> node = c.refit_node(0, palette, variant.pieces);
};

struct Malformed {
  const char* what;
  std::function<std::string(const json&)> made;
  const char* reason;
};

// Returns a change that puts another value at a place, and seals the document with a new digest.
std::function<std::string(const json&)> with(const char* pointer, const json& value) {
  return [=](const json& document) {
    json changed = document;
    changed[json::json_pointer(pointer)] = value;
    return sealed(changed);
  };
}
std::function<std::string(const json&)> without(const char* owner, const char* key) {
  return [=](const json& document) {
    json changed = document;
    changed[json::json_pointer(owner)].erase(key);
    return sealed(changed);
  };
}
std::function<std::string(const json&)> text(const std::string& text) {
  return [=](const json&) { return text; };
}

std::vector<Malformed> malformed_texts() {
  return {
      {"an empty file", text(""), "Expecting value"},
      {"no JSON", text("{\"about\": "), "Expecting value"},
      {"no object", text("[]\n"), "canonical"},
      {"no ASCII", text("\xc3\xa4"), "ascii"},
      {"NaN", text("{\n \"ball\": NaN\n}\n"), "no integer"},
      {"lists in lists without end", text(std::string(100000, '[')), "recursion"},
      {"other white space", [](const json& d) { return sealed(d) + "\n"; }, "canonical"},
      {"a key twice", [](const json& d) { return "{\n \"about\": \"\"," + sealed(d).substr(1); }, "canonical"},
      {"a digest left out",
       [](const json& d) {
         json e = d;
         e.erase("digest");
         return e.dump(1) + "\n";
       },
       "digest"},
      {"a change without its digest",
       [](const json& d) {
         json e = d;
         e["about"] = "";
         return e.dump(1) + "\n";
       },
       "digest"},
  };
}

std::vector<Malformed> malformed_members() {
  return {
      {"a skinning of another kind", with("/skinning", "hejl"), "skinning is none"},
      {"a skinning that is no text", with("/skinning", {"linear"}), "skinning is none"},
      {"a model's digest that is none", with("/model", "0"), "certificate.model is no SHA-256"},
      {"a pose's digest with a line feed", with("/pose", std::string(63, '0') + "\n"), "certificate.pose is no SHA-256"},
      {"no vertices", with("/vertices", json::array()), "certificate.vertices is no list"},
      {"a vertex of no piece", with("/vertices/0/piece", 9), "vertices[0]: piece is none of them"},
      {"a vertex of a piece counted from the end", with("/vertices/0/piece", -1), "vertices[0]: piece is none of them"},
      {"no ball", without("", "ball"), "certificate has not the members"},
      {"something more", with("/more", 1), "certificate has not the members"},
      {"pieces that are none", with("/pieces", json::array()), "certificate.pieces is no list"},
      {"a ball that is a list", with("/ball", {"0", "0", "0", "1"}), "certificate.ball has not the members"},
      {"a number without quotes", with("/ball/radius", 2), "certificate.ball.radius is no"},
      {"a decimal", with("/ball/radius", "1.5"), "certificate.ball.radius is no"},
      {"a zero denominator", with("/ball/radius", "1/0"), "certificate.ball.radius is no"},
      {"a number too long to read", with("/ball/radius", std::string(4001, '1')), "certificate.ball.radius is no"},
      {"digits that are not ASCII", with("/ball/radius", "\xd9\xa3"), "certificate.ball.radius is no"},
      {"a center in the plane", with("/ball/center", {"0", "0"}), "certificate.ball.center has 2 items, not 3"},
      {"a joint-set without rotations", without("/joint_sets/0", "rotations"), "joint_sets[0] has not the members"},
      {"a joint-set number that is true", with("/pieces/0/joint_set", true), "joint_set is no int"},
      {"a joint-set that is not there", with("/pieces/0/joint_set", 1), "pieces[0]: joint_set is none of them"},
      {"a joint-set counted from the end", with("/pieces/0/joint_set", -1), "pieces[0]: joint_set is none of them"},
      {"more images than joints", with("/joint_sets/0/center_images/4", {"0", "0", "0"}), "lists differ in length"},
      {"a weight vertex of one weight", with("/pieces/0/weight_vertices/0", {"1"}), "weights are not convex"},
      {"a weight below 0", with("/pieces/0/weight_vertices/0", {"2", "-1", "0", "0"}), "weights are not convex"},
      {"weights of sum 2", with("/pieces/0/weight_vertices/0", {"1", "1", "0", "0"}), "weights are not convex"},
      {"a reference ball of radius -1", with("/pieces/0/reference/radius", "-1"), "reference.radius is negative"},
      {"a ball of radius -1", with("/ball/radius", "-1"), "smaller than the reference"},
  };
}

// Returns malformed bounds. bound is one that proves something.
std::vector<Malformed> malformed_bounds(const json& bound) {
  return {
      {"a bound that is a text", with("/pieces/0/bound", "control"), "bound is no dict"},
      {"a bound by nothing", with("/pieces/0/bound", json::object()), "bound.by is no bound"},
      {"a bound by a list", with("/pieces/0/bound", {{"by", {"control"}}}), "bound.by is no bound"},
      {"a bound of another skinning", with("/pieces/0/bound", {{"by", "reach"}}), "bound.by is no bound"},
      {"a cap without axis", with("/pieces/0/bound", {{"by", "cap"}}), "bound has not the members"},
      {"a cap about 0", with("/pieces/0/bound", {{"by", "cap"}, {"axis", {"0", "0", "0", "0"}}}), "not ahead"},
      {"halves of no edge", with("/pieces/0/bound", {{"by", "halves"}, {"edge", {0, 99}}, {"halves", {bound, bound}}}),
       "edge ends at no weight vertex"},
      {"halves of an edge counted from the end",
       with("/pieces/0/bound", {{"by", "halves"}, {"edge", {-1, 0}}, {"halves", {bound, bound}}}),
       "edge ends at no weight vertex"},
      {"one half", with("/pieces/0/bound", {{"by", "halves"}, {"edge", {0, 1}}, {"halves", {bound}}}), "has 1 items, not 2"},
  };
}

Checked check_malformed() {
  const auto c = gen::rounded_to_double(counterexamples::algorithm1()[0].input);
  const gen::NodeOf<double> node(c);
  CheckedFolder whole, folder;
  const json good = certify(whole, compared_variant("control_miniball"), node.node());
  std::vector<Malformed> list = malformed_texts();
  for (const auto& part : {malformed_members(), malformed_bounds(good["pieces"][0]["bound"])})
    list.insert(list.end(), part.begin(), part.end());
  folder.add(sealed(good));
  for (const Malformed& m : list) folder.add(m.made(good));
  const auto lines = folder.check();
  if (!lines[0].is_accepted()) return Checked(false, 0, lines[0].text);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!lines[i + 1].is_rejected_for(list[i].reason)) return Checked(false, long(i), list[i].what + (": " + lines[i + 1].text));
  return Checked(true, static_cast<long>(list.size()));
}

void nodes_have_accepted_certificates(Suite& t) {
  const Options exact{.form = "", .number_type = "double against rational"};
  t.holds(
      "random nodes have certificates by every sound variant, and all are accepted that are not refused for a size the writer "
      "tells",
      {.number_type = "double against rational", .cases = 15, .degenerate_at_least = 0.3, .degenerate_at_most = 1},
      check_random_nodes);
  t.holds(
      "nodes of random meshes have certificates by every sound variant, and all are accepted that are not refused for a size the "
      "writer tells",
      {.number_type = "double against rational", .cases = 9, .degenerate_at_least = 0.3}, [] {
        const auto plan = gen::classified_plan();
        const auto c = bake(gen::make_mesh(plan));
        std::mt19937 random(plan.seed);
        const auto pose = gen::random_pose(c.mesh, random, *rc::gen::element(0.0, 0.3, 1.0));
        const auto checked = check_nodes(c, pose, random, 1, true);
        if (!checked.passed) RC_FAIL(checked.detail);
      });
  t.holds(
      "nodes of random meshes with affine joints of every kind have certificates by every sound variant of linear skinning, and "
      "all are accepted that are not refused for a size the writer tells",
      {.number_type = "double against rational", .cases = 60, .degenerate_at_least = 0.3, .degenerate_at_most = 0.85},
      check_affine_nodes);
  t.example(
      "two nodes of the procedural man have certificates by every sound variant, the root by one of each skinning, and all are "
      "accepted",
      exact, [] { return check_model(bake_animated(make_man())); });
  t.example(
      "two nodes of the procedural creature have certificates by every sound variant, the root by one of each skinning, and all "
      "are accepted",
      exact, [] { return check_model(bake_animated(make_creature())); });
  for (const char* file : real_models)
    t.example("two nodes have certificates by every sound variant, the root by one of each skinning, and all are accepted: " +
                  std::string(file),
              exact, [=] {
                const std::string path = std::string("out/models/") + file;
                return std::filesystem::exists(path) ? check_model(bake_animated(load_model(path)))
                                                     : Checked::skip(path + " is not there");
              });
}

void what_has_no_certificate(Suite& t) {
  t.example("Algorithm 1's balls as printed have no proof on its pinned counterexamples, and forged ones are rejected", {}, [] {
    CheckedFolder folder;
    long refused = 0;
    for (const auto& pinned : counterexamples::algorithm1()) {
      const auto c = gen::rounded_to_double(pinned.input);
      const gen::NodeOf<double> storage(c);
      const auto node = storage.node();
      RefitLists<double> lists;
      const auto ball = refit_algorithm1_printed<MeanBalls>(node, Signs::of_matrices, lists);
      try {
        certificate(node, Skinning::spherical, ball, gen::BareCertifiedNode(node, pinned.finding));
        return Checked(false, refused, pinned.finding);
      } catch (const NoProof&) {
        CheckedFolder sound;
        json forged = certify(sound, compared_variant("control_miniball"), node);
        forged["ball"] = {{"center", as_json<3>(convert<Rational>(ball.center))}, {"radius", as_text(Rational(ball.radius))}};
        folder.add(sealed(forged));
      } catch (const std::invalid_argument&) {  // not a number
      }
      ++refused;
    }
    for (const auto& line : folder.check())
      if (!line.is_rejected()) return Checked(false, refused, line.text);
    return Checked(refused == 5 && folder.size() > 0, refused, std::to_string(folder.size()) + " forged");
  });
  t.example("numbers that are not finite, and weights that are not convex, have no certificate", {}, [] {
    const auto pinned = counterexamples::algorithm1().front();
    const gen::NodeOf<double> storage(gen::rounded_to_double(pinned.input));
    const RefitNode<double> node = storage.node();
    const Ball3<double> ball = compared_variant("control_miniball").refit(node);
    const auto is_refused = [&](const RefitNode<double>& of, const Ball3<double>& by) {
      try {
        certificate(of, Skinning::spherical, by, gen::BareCertifiedNode(node, ""));
        return false;
      } catch (const std::invalid_argument&) {
        return true;
      }
    };
    const auto with_first_weight = [&](double weight) {
      const auto n = node.palette.joint_count(node.pieces[0].joint_set);
      std::vector<double> pool(node.weight_vertices,
                               node.weight_vertices + node.pieces[0].first_weight + n * node.pieces[0].weight_vertex_count);
      pool[node.pieces[0].first_weight] = weight;
      const RefitNode<double> changed{node.reference, node.pieces.first(1), pool.data(), node.palette};
      return is_refused(changed, ball);
    };
    const double first = node.weight_vertices[node.pieces[0].first_weight], infinity = HUGE_VAL;
    return is_refused(node, {ball.center, std::nan("")}) && is_refused(node, {ball.center, infinity}) &&
           is_refused(node, {{0, -infinity, 0}, ball.radius}) && with_first_weight(-0.5) && with_first_weight(0.375) &&
           with_first_weight(std::nextafter(first, 2)) && with_first_weight(first - 0x1p-53);
  });
  t.example("a vertex outside its pieces' reference balls, or with weights outside their hulls, has no certificate", {}, [] {
    const BentTube tube;
    const Ball3<double> ball = tube.variant.refit(tube.node);
    const CertifiedNode good = certified(tube.c, 0, "");
    const auto is_refused = [&](const auto& change) {
      CertifiedNode of = good;
      change(of.vertices[0]);
      try {
        certificate(tube.node, Skinning::spherical, ball, of);
        return false;
      } catch (const NoProof& error) {
        return std::string(error.what()) == ": no piece holds vertex " + std::to_string(good.vertices[0].id);
      }
    };
    std::vector<double> beyond(good.vertices[0].weights.begin(), good.vertices[0].weights.end());
    beyond[0] += 2, beyond.back() -= 2;
    return !is_refused([](CertifiedVertex&) {}) && is_refused([](CertifiedVertex& v) { v.position[2] += 1e3; }) &&
           (beyond.size() == 1 || is_refused([&](CertifiedVertex& v) { v.weights = beyond; })) &&
           is_refused([&](CertifiedVertex& v) { v.joint_set = tube.c.sets.count() + 1; });
  });
}

void joint_sets_and_shares_as_they_are_written(Suite& t) {
  t.example("joint-sets are written once each, and pieces name them by their places, whatever their numbers", {}, [] {
    // The node has two pieces of set 2 around one of set 0.
    const BentTube tube;
    const RefitNode<double>& node = tube.node;
    std::vector<NodePiece> twice(node.pieces.rbegin(), node.pieces.rend());
    twice.insert(twice.end(), node.pieces.begin(), node.pieces.end());
    const RefitNode<double> both{node.reference, twice, node.weight_vertices, node.palette, node.piece_references};
    const Ball3<double> ball = tube.variant.refit(both);
    CheckedFolder folder;
    const CertifiedNode of = certified(tube.c, 0, "\xff");
    const std::string text = certificate(both, Skinning::spherical, ball, of);
    folder.add(text);
    const json document = json::parse(text);
    return Checked(is_about(document, both, Skinning::spherical, ball, of) &&
                       document["joint_sets"].size() == node.pieces.size() && node.pieces.size() > 1 &&
                       folder.check()[0].is_accepted(),
                   long(twice.size()));
  });
  t.example("shares that are 0 are as good as none, but not all of them", {}, [] {
    const BentTube tube;
    CheckedFolder made, folder;
    const json document = certify(made, tube.variant, tube.node, certified(tube.c, 0, ""));
    json more = document, none = document;
    for (json& vertex : more["vertices"]) vertex["weight_vertices"].push_back(0), vertex["shares"].push_back("0");
    for (json& share : none["vertices"][0]["shares"]) share = "0";
    folder.add(sealed(more)), folder.add(sealed(none));
    const auto lines = folder.check();
    return Checked(lines[0].is_accepted() && lines[1].text.find("the shares are not convex") != std::string::npos,
                   static_cast<long>(more["vertices"].size()), lines[0].text + lines[1].text);
  });
}

void whatever_is_changed_or_forged(Suite& t) {
  t.holds("whatever bytes or values are changed, the certificate is rejected, with a reason",
          {.cases = 25, .tags_at_least = {{"40 changes", 0.8}}}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            CheckedFolder folder;
            for (const json& document : some_certificates())
              for (int i = 0; i < 8; ++i) {
                folder.add(with_other_bytes(sealed(document), random));
                folder.add(with_other_value(document, random).dump(1, ' ', true) + "\n");
              }
            for (const auto& line : folder.check()) RC_ASSERT(line.is_rejected());
            RC_CLASSIFY(folder.size() >= 40, "40 changes");
          });
  t.holds("with a new digest, changed values are accepted or rejected, with a reason", {.cases = 25}, [] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    CheckedFolder folder;
    std::vector<json> documents;
    for (const json& document : some_certificates())
      for (int i = 0; i < 10; ++i) folder.add(sealed(documents.emplace_back(with_other_value(document, random))));
    const auto lines = folder.check();
    for (std::size_t i = 0; i < lines.size(); ++i)
      RC_ASSERT(lines[i].is_rejected() || (lines[i].is_accepted() && !is_false(documents[i])));
  });
  t.holds("no bound proves a ball a little too small, whatever else is forged",
          {.cases = 25, .tags_at_least = {{"25 forgeries", 0.8}}}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            CheckedFolder folder;
            Forger forger(random);
            for (const json& document : some_certificates())
              for (int i = 0; i < 10; ++i)
                if (const json false_one = forger.forge(document); is_false(false_one)) folder.add(sealed(false_one));
            for (const auto& line : folder.check()) RC_ASSERT(line.is_rejected());
            RC_CLASSIFY(folder.size() >= 25, "25 forgeries");
          });
}

}  // namespace

PROPTEST(certificate) {
  nodes_have_accepted_certificates(t);
  what_has_no_certificate(t);
  t.holds(
      "shrunk by an ulp up to a half, moved, of another node or palette: a ball has a certificate that is accepted, or none, and "
      "none if a vertex is outside",
      {.number_type = "double against rational",
       .cases = 12,
       .tags_at_least = {{"certified", 0.5}, {"missing a vertex", 0.5}, {"holding all without a certificate", 0.05}}},
      check_other_balls);
  joint_sets_and_shares_as_they_are_written(t);
  t.example("what is no certificate is rejected, each for its reason", {}, check_malformed);
  t.example("the checker has at most 390 lines", {}, [] {
    std::ifstream file(oracle::checker());
    long lines = 0;
    for (std::string line; std::getline(file, line);) ++lines;
    return Checked(lines > 0 && lines <= 390, lines, "");
  });
  t.example("an unreadable file and none at all are told from rejected ones by the exit status", {}, [] {
    CheckedFolder folder;
    return oracle::run_checker("").status == 2 && oracle::run_checker(folder.path() + "/absent.json").status == 2 &&
           oracle::run_checker(folder.path()).status == 2;
  });
  whatever_is_changed_or_forged(t);
}

}  // namespace proptests::suite_certificate
