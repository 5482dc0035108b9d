// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/animated_model.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "algorithms/runtime/mesh/quantize.hpp"
#include "proptests/gen/any_place.hpp"

namespace proptests::gen {

using namespace refitlab;

namespace {

class ModelMaker {
 public:
  explicit ModelMaker(const AnimatedPlan& plan) : plan_(plan), random_(plan.seed) {}

  Model make() {
    model_.name = model_.skeleton.file = "generated";
    Animation animation{"clip", plan_.duration, {}};
    for (int n = 0; n < plan_.nodes; ++n) add_node(n, animation);
    for (int j = 0; j < plan_.joints; ++j) add_joint(j);
    for (int v = 0; v < plan_.vertices; ++v) add_vertex();
    model_.triangles.push_back({0, plan_.vertices / 2, plan_.vertices - 1});
    if (plan_.targets > 0) add_morphs(animation);
    validate(model_);
    model_.clips.push_back({"clip", plan_.duration, {}, animation});
    return model_;
  }

  Animation second(const Model& model) {
    Animation animation{"second", plan_.duration, {}};
    for (int n = 0; n < plan_.nodes; ++n) {
      const auto first = std::find_if(model.clips[0].animation.tracks.begin(), model.clips[0].animation.tracks.end(),
                                      [&](const NodeTrack& track) { return track.node == n; });
      const bool is_moved = first != model.clips[0].animation.tracks.end();
      if (!is_moved && (chance(0.6) || !model.skeleton.nodes[n].rest)) continue;
      if (is_moved && model.skeleton.nodes[n].rest && chance(0.2)) continue;
      add_track(n, animation);
      if (is_moved && !plan_.near_zero) meet(animation.tracks.back().rotations, first->rotations);
    }
    std::shuffle(animation.tracks.begin(), animation.tracks.end(), random_);
    for (const MorphedMesh& mesh : model.morphs)
      if (chance(0.7)) animation.weight_tracks.push_back(weight_track(mesh.node));
    return animation;
  }

 private:
  int pick(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  bool chance(double p) { return std::uniform_real_distribution<double>(0, 1)(random_) < p; }
  double real() { return chance(0.2) ? pick(-4, 4) / 4.0 : std::uniform_real_distribution<double>(-1, 1)(random_); }
  Eigen::Vector3d vector() { return {real(), real(), real()}; }
  double magnitude(double least, double most) {
    return std::exp(std::uniform_real_distribution<double>(std::log(least), std::log(most))(random_));
  }
  Eigen::Quaterniond turn() {
    Eigen::Vector4d v(real(), real(), real(), real());
    while (v.norm() < 0.1) v = Eigen::Vector4d(real(), real(), real(), real() + 1);
    return Eigen::Quaterniond(Eigen::Vector4d(v.normalized()));
  }
  Eigen::Vector3d position() {
    return chance(0.15) ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : Eigen::Vector3d(plan_.unit * vector());
  }
  Eigen::Vector3d scale() {
    if (plan_.rigid) return Eigen::Vector3d::Ones() + plan_.noise * vector();
    if (plan_.smooth || chance(0.3)) return Eigen::Vector3d::Ones() + 0.3 * vector();
    if (chance(0.1)) return Eigen::Vector3d::Zero();
    if (chance(0.2)) return magnitude(1e-3, 1e3) * vector();
    return 2 * vector();
  }
  Eigen::Matrix4d rigid() {
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.topLeftCorner<3, 3>() = chance(0.2) ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : turn().toRotationMatrix();
    m.topRightCorner<3, 1>() = position();
    return m;
  }
  Eigen::Matrix4d affine() {
    Eigen::Matrix4d m = rigid();
    if (plan_.rigid || chance(0.4)) return m;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) m(i, j) = 2 * real();
    if (chance(0.1)) m.col(pick(0, 2)).setZero();
    return m;
  }

  // Returns times in order. Some of them are together, at the ends, before 0 or beyond the duration.
  std::vector<double> times() {
    const double scale = plan_.duration > 0 ? plan_.duration : 1;
    std::vector<double> out;
    const int count = plan_.smooth ? pick(2, 4) : pick(1, 5);
    for (int k = 0; k < count; ++k) {
      double share = std::uniform_real_distribution<double>(-0.5, 1.5)(random_);
      if (plan_.smooth) share = (k + 0.5 * real()) / std::max(1, count - 1);
      else if (chance(0.5)) share = pick(-2, 10) / 8.0;
      out.push_back(scale * share);
    }
    if (!plan_.smooth)
      for (int k = 1; k < count; ++k)
        if (chance(0.15)) out[k] = out[k - 1];
    std::sort(out.begin(), out.end());
    return out;
  }

  Interpolation interpolation(bool of_rotations) {
    if (plan_.smooth) return chance(0.5) && (!of_rotations || plan_.cubic) ? Interpolation::cubic : Interpolation::linear;
    const int kind = pick(0, 3);
    if (kind == 0) return Interpolation::step;
    return kind == 1 && (!of_rotations || plan_.cubic) ? Interpolation::cubic : Interpolation::linear;
  }

  template <class Make>
  Channel<Eigen::Vector3d> vectors(const Make& make, double size) {
    Channel<Eigen::Vector3d> out;
    out.interpolation = interpolation(false);
    for (const double t : times()) {
      const bool again = !out.keys.empty() && chance(0.2);
      out.keys.push_back({t, again ? out.keys.back().value : make()});
      if (plan_.smooth && out.keys.size() > 1 && !again) {
        const Eigen::Vector3d before = out.keys[out.keys.size() - 2].value;
        out.keys.back().value = before + 0.3 * (out.keys.back().value - before);
      }
    }
    for (std::size_t k = 0; out.interpolation == Interpolation::cubic && k < out.keys.size(); ++k)
      out.tangents.push_back({tangent(size), tangent(size)});
    return out;
  }
  Eigen::Vector3d tangent(double size) { return rate() * size * vector(); }
  double rate() {
    const double most = plan_.smooth ? 1 : chance(0.2) ? 0 : chance(0.2) ? 100 : 4;
    return most / (plan_.duration > 0 ? plan_.duration : 1);
  }

  // Returns a key after q: anywhere, the same, the opposite one or nearly so, half a turn away or nearly so, or a little further.
  Eigen::Quaterniond next_turn(const Eigen::Quaterniond& q) {
    const Eigen::Vector4d c = q.coeffs(), across = Eigen::Vector4d(c[3], -c[2], c[1], -c[0]);
    if (plan_.smooth) return Eigen::Quaterniond(Eigen::Vector4d((c + 0.4 * turn().coeffs()).normalized()));
    switch (pick(0, 8)) {
      case 0: return q;
      case 1: return Eigen::Quaterniond(Eigen::Vector4d(-c));
      case 2: return Eigen::Quaterniond(Eigen::Vector4d((-c + magnitude(1e-15, 1e-3) * turn().coeffs()).normalized()));
      case 3: return Eigen::Quaterniond(Eigen::Vector4d((c + magnitude(1e-15, 1e-3) * turn().coeffs()).normalized()));
      case 4: return Eigen::Quaterniond(across);
      case 5: return Eigen::Quaterniond(Eigen::Vector4d((across + magnitude(1e-12, 1e-2) * real() * c).normalized()));
      default: return turn();
    }
  }
  Channel<Eigen::Quaterniond> turns() {
    Channel<Eigen::Quaterniond> out;
    out.interpolation = interpolation(true);
    for (const double t : times()) out.keys.push_back({t, out.keys.empty() ? turn() : next_turn(out.keys.back().value)});
    if (out.interpolation != Interpolation::cubic) return out;
    for (std::size_t k = 1; k < out.keys.size(); ++k) {
      Eigen::Quaterniond& q = out.keys[k].value;
      const Eigen::Vector4d before = out.keys[k - 1].value.coeffs();
      // The spline goes through quaternions themselves: mostly the shorter way, since the longer one may lead through zero.
      if (plan_.near_zero && chance(0.5)) q.coeffs() = (-before + magnitude(1e-7, 0.3) * turn().coeffs()).normalized();
      else if (before.dot(q.coeffs()) < (chance(0.9) ? 0.1 : -0.9)) q.coeffs() = (before + 0.5 * turn().coeffs()).normalized();
    }
    for (std::size_t k = 0; k < out.keys.size(); ++k) {
      const double size = (plan_.near_zero ? 0 : plan_.smooth ? 0.5 : chance(0.1) ? 30 : 1) * rate();
      const auto any = [&] {
        return Eigen::Quaterniond(Eigen::Vector4d(size * Eigen::Vector4d(real(), real(), real(), real())));
      };
      out.tangents.push_back({any(), any()});
    }
    return out;
  }

  void add_node(int n, Animation& animation) {
    const int parent = n == 0 || (!plan_.smooth && chance(0.1)) ? -1 : chance(0.5) ? n - 1 : pick(0, n - 1);
    model_.skeleton.nodes.push_back({"node " + std::to_string(n), parent, affine()});
    if (n == 0 && plan_.root_scale != 1) {
      model_.skeleton.nodes.back().local.topLeftCorner<3, 3>() *= plan_.root_scale;
      if (plan_.far == 0) return;
    }
    if (plan_.far > 0 && n < 2) {  // there, and back
      auto& local = model_.skeleton.nodes.back().local;
      if (n == 0) local = Eigen::Vector4d(plan_.root_scale, plan_.root_scale, plan_.root_scale, 1).asDiagonal();
      local(0, 3) += n == 0 ? plan_.far * plan_.unit : -plan_.far * plan_.unit / plan_.root_scale;
      if (n == 0) return;
    }
    add_rest(model_.skeleton.nodes.back());
    if (chance(0.25)) return;
    add_track(n, animation);
    std::shuffle(animation.tracks.begin(), animation.tracks.end(), random_);
  }

  void add_track(int n, Animation& animation) {
    const Eigen::Vector3d back =
        plan_.far > 0 && n == 1 ? Eigen::Vector3d(-plan_.far * plan_.unit / plan_.root_scale, 0, 0) : Eigen::Vector3d(0, 0, 0);
    animation.tracks.push_back({n, vectors([&] { return Eigen::Vector3d(back + position()); }, plan_.unit), turns(),
                                vectors([&] { return scale(); }, plan_.rigid ? plan_.noise : 1)});
    if (plan_.rigid && plan_.noise == 0) animation.tracks.back().scales = {{{0, Eigen::Vector3d::Ones()}}};
  }

  // Adds a rest transform where the matrix has parts.
  void add_rest(SceneNode& node) {
    const Eigen::Matrix3d m = node.local.topLeftCorner<3, 3>();
    if ((m.transpose() * m - Eigen::Matrix3d::Identity()).norm() > 1e-9) return;
    node.rest = NodeTransform{node.local.topRightCorner<3, 1>(), scale(), Eigen::Quaterniond(m).normalized()};
    node.local = matrix_of(*node.rest);
  }

  // Moves keys near those of a track of the first clip.
  void meet(Channel<Eigen::Quaterniond>& turns, const Channel<Eigen::Quaterniond>& other) {
    const Eigen::Vector4d c = other.keys[0].value.coeffs();
    Eigen::Quaterniond& q = turns.keys[0].value;
    switch (pick(0, 7)) {
      case 0: turns = other; break;
      case 1: q = Eigen::Quaterniond(Eigen::Vector4d(-c)); break;
      case 2: q = Eigen::Quaterniond(Eigen::Vector4d(c[3], -c[2], c[1], -c[0])); break;
      case 3: q = next_turn(other.keys[0].value); break;
      default: break;
    }
  }

  void add_joint(int j) {
    Eigen::Matrix4d offset = affine();
    const int node = pick(0, plan_.nodes - 1);
    int root = node;
    while (model_.skeleton.nodes[root].parent >= 0) root = model_.skeleton.nodes[root].parent;
    if (root == 0) offset.topRows<3>() /= plan_.root_scale;
    if (plan_.away > 0) offset.topRightCorner<3, 1>() -= offset.topLeftCorner<3, 3>() * away();
    model_.skeleton.joints.push_back({"joint " + std::to_string(j), node, pick(-1, j - 1), offset});
    const Eigen::Matrix3d m = offset.topLeftCorner<3, 3>();
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    if (std::abs(m.determinant()) > 1e-3) origin = -m.inverse() * offset.topRightCorner<3, 1>();
    model_.joints.push_back({"joint " + std::to_string(j), model_.skeleton.joints.back().parent, origin});
  }

  // Returns where the reference pose is.
  Eigen::Vector3d away() const { return plan_.away * plan_.unit * Eigen::Vector3d(0.6, 0, 0.8); }

  void add_vertex() {
    const int near = pick(0, plan_.joints - 1);
    model_.vertices.push_back(chance(0.15) ? model_.joints[near].origin : Point3(away() + position()));
    std::vector<int> all;
    for (int j = 0; j < plan_.joints; ++j) all.push_back(j);
    std::shuffle(all.begin(), all.end(), random_);
    all.resize(std::min<std::size_t>(all.size(), pick(1, 4)));
    std::vector<std::pair<int, double>> weights;
    const bool equal = chance(0.3);
    for (const int j : all) weights.emplace_back(j, equal ? 1 : chance(0.15) ? magnitude(1e-7, 1e-2) : 0.05 + std::abs(real()));
    model_.influences.emplace_back();
    for (const auto& [joint, weight] : quantize_weights(weights)) model_.influences.back().push_back({joint, weight});
  }

  // Adds morph targets. The first vertices belong to one mesh, and the others perhaps to another, whose weights move or stay.
  void add_morphs(Animation& animation) {
    const int first = plan_.nodes == 1 || chance(0.5) ? plan_.vertices : pick(0, plan_.vertices);
    for (int mesh = 0; mesh < (first < plan_.vertices ? 2 : 1); ++mesh) {
      MorphedMesh morph{mesh, {}, {}};
      for (int t = 0; t < plan_.targets; ++t) {
        morph.weights.push_back(real());
        morph.targets.emplace_back();
        for (int v = mesh == 0 ? 0 : first; v < (mesh == 0 ? first : plan_.vertices); ++v)
          if (chance(0.8)) morph.targets.back().displacements.push_back({v, position()});
      }
      model_.morphs.push_back(morph);
      if (chance(0.2)) continue;
      animation.weight_tracks.push_back(weight_track(mesh));
    }
  }

  WeightTrack weight_track(int node) {
    WeightTrack track{node, {{}, interpolation(false), {}}};
    const auto any = [&](double size) {
      Eigen::VectorXd out(plan_.targets);
      for (double& w : out) w = size * real();
      return out;
    };
    for (const double time : times()) {
      track.weights.keys.push_back({time, any(plan_.smooth ? 0.3 : 1.5)});
      if (track.weights.interpolation == Interpolation::cubic) track.weights.tangents.push_back({any(rate()), any(rate())});
    }
    return track;
  }

  const AnimatedPlan& plan_;
  std::mt19937 random_;
  Model model_;
};

}  // namespace

Model animated_model(const AnimatedPlan& plan) { return ModelMaker(plan).make(); }

Animation second_animation(const AnimatedPlan& plan, const Model& model) {
  AnimatedPlan other = plan;
  other.seed = plan.seed + 7919;
  const double share = std::array{1.0, 0.4, 3.0, 1.0, 0.0}[plan.seed % 5];
  other.duration = (plan.duration > 0 ? plan.duration : 1) * (plan.smooth && share == 0 ? 2.5 : share);
  return ModelMaker(other).second(model);
}

AnimatedPlan draw_animated_plan(bool rigid) {
  AnimatedPlan plan;
  plan.rigid = rigid;
  plan.nodes = *between(1, 8), plan.joints = *between(1, 7), plan.vertices = *between(1, 6);
  plan.targets = std::max(0, *between(-3, 4));
  plan.unit = *rc::gen::element(1.0, 1.0, 1e-6, 1e6);
  plan.duration = *rc::gen::element(1.0, 1.0, 2.5, 1e-6, 1e6, 0.0);
  plan.cubic = *between(0, 2) == 1;
  plan.near_zero = plan.cubic && *between(0, 4) == 0;
  plan.noise = rigid ? *rc::gen::element(0.0, 0.0, 1e-9, 1e-4, 2e-4) : 0;
  plan.root_scale = *rc::gen::element(1.0, 1.0, 1.0, 0.01, 100.0, -1.0, -3.0);
  plan.far = *rc::gen::element(0.0, 0.0, 0.0, 1e6), plan.away = *rc::gen::element(0.0, 0.0, 0.0, 1e6);
  plan.seed = *rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<unsigned>());
  return plan;
}

AnimatedPlan draw_smooth_plan(bool rigid) {
  AnimatedPlan plan = draw_animated_plan(rigid);
  plan.smooth = true, plan.near_zero = false, plan.far = plan.away = 0, plan.noise = 0;
  plan.nodes = std::min(plan.nodes, 4);
  if (plan.duration == 0) plan.duration = 1;
  return plan;
}

bool is_degenerate(const AnimatedPlan& plan) {
  return plan.duration == 0 || plan.far > 0 || plan.away > 0 || plan.near_zero || plan.nodes == 1 || plan.joints == 1;
}

std::ostream& operator<<(std::ostream& out, const AnimatedPlan& plan) {
  return out << (plan.rigid ? "rigid" : "affine") << ", " << plan.nodes << " nodes, " << plan.joints << " joints, "
             << plan.vertices << " vertices, " << plan.targets << " targets, unit " << plan.unit << ", duration " << plan.duration
             << (plan.smooth ? ", smooth" : "") << (plan.cubic ? ", cubic" : "") << (plan.near_zero ? ", near zero" : "")
             << ", noise " << plan.noise << ", root scale " << plan.root_scale << ", far " << plan.far << ", away " << plan.away
             << ", seed " << plan.seed;
}

double time_within(double start, double end, std::mt19937& random) {
  return std::min(end, start + (end - start) * std::uniform_real_distribution<double>(0, 1)(random));
}

}  // namespace proptests::gen
