// SPDX-License-Identifier: GPL-3.0-or-later
// Tests how nodes of a skeleton move between two keys.
#include "algorithms/bake/over_time/node_motions.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <numeric>
#include <random>

#include "lemmas/exact/exact.hpp"
#include "proptests/gen/animated_model.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/animated_skin.hpp"

namespace proptests::suite_node_motions {
namespace {

using namespace refitlab;
using M = MultiprecisionInterval;
using Jet = oracle::Jet<M>;

// Says whether a length is certainly more than the bound, by more than its rounding. A length up to tiny counts as nothing.
bool is_beyond(double length, double bound, double tiny) { return length > bound * (1 + 1e-9) + tiny; }

// Returns the greatest length of the image of a unit vector.
double stretch(const Eigen::Matrix3d& m) { return m.jacobiSvd().singularValues()[0]; }

struct Derivatives {
  Eigen::Matrix3d linear[3];
  Eigen::Vector3d offset[3];
  Eigen::Vector4d turn[3];
};

Derivatives derivatives_of(const oracle::Placed<Jet>& placed) {
  Derivatives out;
  const auto part = [](const Jet& x, int order) {
    return static_cast<double>(median(order == 0 ? x.value : order == 1 ? x.first : x.second));
  };
  for (int order = 0; order < 3; ++order) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) out.linear[order](i, j) = part(placed.matrix[i][j], order);
      out.offset[order][i] = part(placed.matrix[i][3], order);
    }
    for (int i = 0; i < 4; ++i) out.turn[order][i] = part(placed.turn[i], order);
  }
  return out;
}

// Asserts that derivatives are within bounds. rate says how often lengths change per second, and so which of them count as
// nothing.
void moves_within(const Derivatives& d, const ChainMotion<double>& chain, double rate) {
  const auto bound = [](const Motion<double>& m, int order) {
    return order == 0 ? m.size : order == 1 ? m.speed : m.acceleration;
  };
  for (int order = 0; order < 3; ++order) {
    const double tiny = 1e-12 * std::pow(rate, order);
    RC_ASSERT(!is_beyond(stretch(d.linear[order]), bound(chain.linear, order), tiny * chain.linear.size));
    RC_ASSERT(!is_beyond(d.offset[order].norm(), bound(chain.offset, order), tiny * chain.offset.size));
    RC_ASSERT(!is_beyond(d.turn[order].norm(), bound(chain.rotation, order), tiny));
  }
}

Model one_node(const Animation& animation) {
  Model model;
  model.name = model.skeleton.file = "one";
  model.skeleton.nodes = {{"node", -1, Eigen::Matrix4d::Identity()}};
  model.clips.push_back({"clip", animation.duration, {}, animation});
  return model;
}

Channel<Eigen::Vector3d> still(double x) { return {{{0, Eigen::Vector3d::Constant(x)}}}; }

// Makes a spline of rotations that starts and ends at 1, swings out to one side and comes back from the other.
Channel<Eigen::Quaterniond> swinging(double duration, double tangent) {
  const Eigen::Quaterniond one = Eigen::Quaterniond::Identity();
  const Eigen::Quaterniond aside(0, tangent / duration, 0, 0);
  return {{{0, one}, {duration, one}}, Interpolation::cubic, {{aside, aside}, {aside, aside}}};
}

void times_and_splines(Suite& t) {
  t.holds("times are in order, from 0 to the duration, and hold every key's time and no jump between",
          {.number_type = "double", .cases = 300, .degenerate_at_most = 0.9}, [] {
            const auto plan = gen::draw_animated_plan(true);
            RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
            const Model model = gen::animated_model(plan);
            const Animation& animation = model.clips[0].animation;
            std::vector<double> times;
            try {
              times = smooth_times(model.name, model.skeleton.nodes, animation);
            } catch (const ModelError&) {
              return;
            }
            RC_ASSERT(times.front() == 0 && times.back() == animation.duration);
            for (std::size_t i = 0; i + 1 < times.size(); ++i) {
              RC_ASSERT(times[i] < times[i + 1]);
              const double between = times[i] + (times[i + 1] - times[i]) * 0.37;
              RC_ASSERT(between <= times[i] || between >= times[i + 1] || !jumps_at(animation, between));
            }
            for (const double time : key_times(animation, 1000)) RC_ASSERT(std::binary_search(times.begin(), times.end(), time));
            for (const double time : times) {
              const auto before = global_transforms(model.skeleton.nodes, animation, time, Side::before),
                         after = global_transforms(model.skeleton.nodes, animation, time, Side::after);
              if (jumps_at(animation, time)) continue;
              double size = 0;
              for (std::size_t n = 0; n < after.size(); ++n) size = std::max(size, after[n].norm());
              for (std::size_t n = 0; n < after.size(); ++n) RC_ASSERT((before[n] - after[n]).norm() <= 1e-7 * size);
            }
          });
  t.example("a spline of rotations through zero is refused by name, and one beyond the clip is not looked at", {}, [] {
    const auto refused = [](double from, double to, double duration) {
      const Eigen::Quaterniond one = Eigen::Quaterniond::Identity(), none(0, 0, 0, 0), other(-1, 0, 0, 0);
      const Animation animation{
          "clip",
          duration,
          {{0, still(0), {{{from, one}, {to, other}}, Interpolation::cubic, {{none, none}, {none, none}}}, still(1)}}};
      try {
        smooth_times("one", one_node(animation).skeleton.nodes, animation);
      } catch (const ModelError& e) {
        return std::string(e.what()) ==
               "one: clip 'clip', joint 'node': its cubic spline of rotations passes through zero, where it turns without a "
               "bound";
      }
      return false;
    };
    return refused(0, 1, 1) && refused(-1, 2, 1) && refused(-1, 1, 0) && !refused(2, 3, 1) && !refused(-3, -1, 1);
  });
  t.example("a part of a spline that other keys cut has a least length, too, and positive speeds", {}, [] {
    const double far = 900;
    Animation animation{"clip", 1, {{0, still(0), swinging(1, far), still(1)}}};
    const auto nodes = one_node(animation).skeleton.nodes;
    // The swing alone would be accepted as a whole. Cut at 1/5 and 3/5, its middle is no longer on one side of the sum of its own
    // ends.
    animation.tracks[0].positions.keys = {{0.2, Eigen::Vector3d::Zero()}, {0.6, Eigen::Vector3d::Ones()}};
    const auto times = smooth_times("one", nodes, animation);
    bool good = times.size() > 4;
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      const auto link = link_motions(nodes, animation, times[i], times[i + 1])[0];
      good = good && link.rotation.speed > 0 && link.rotation.acceleration > 0 && std::isfinite(link.rotation.acceleration);
    }
    return Checked(good, static_cast<long>(times.size()));
  });
}

void known_speeds_and_rounding(Suite& t) {
  t.example("nothing moves at a moment, where everything is as far as it is", {}, [] {
    const Animation animation{
        "clip", 0, {{0, {{{0, Eigen::Vector3d(3, 0, 4)}, {1, Eigen::Vector3d::Zero()}}}, swinging(1, 5), still(2)}}};
    const auto link = link_motions(one_node(animation).skeleton.nodes, animation, 0, 0)[0];
    return link.offset.size == 5 && link.offset.speed == 0 && link.linear.size == 2 && link.linear.speed == 0 &&
           link.linear.acceleration == 0 && link.rotation.size == 1 && link.rotation.speed == 0;
  });
  t.example("a linear channel's speed is its own, and so is a slerp's angle", {}, [] {
    const Eigen::Quaterniond one = Eigen::Quaterniond::Identity(), third(0.5, std::sqrt(0.75), 0, 0);
    const Animation animation{
        "clip", 2, {{0, {{{0, Eigen::Vector3d::Zero()}, {2, Eigen::Vector3d(6, 0, 8)}}}, {{{0, one}, {2, third}}}, still(1)}}};
    const auto link = link_motions(one_node(animation).skeleton.nodes, animation, 0, 2)[0];
    // The angle is in R^4, per second.
    const double angle = std::acos(0.5) / 2;
    return link.offset.size == 10 && link.offset.speed == 5 && link.offset.acceleration == 0 && link.rotation.speed >= angle &&
           link.rotation.speed < 1.004 * angle && link.linear.speed >= 2 * angle && link.linear.speed < 2.008 * angle;
  });
  t.example("rounding grows where a spline is shorter than what it is summed up from", {}, [] {
    const Animation animation{"clip", 1, {{0, still(0), swinging(1, 300), still(1)}}};
    const Animation slerp{"clip", 1, {{0, still(0), {{{0, Eigen::Quaterniond::Identity()}}}, still(1)}}};
    return growth_of_rounding(slerp, 0, 1) == 1 && growth_of_rounding(animation, 0, 1) >= 99;
  });
}

// Checks offsets and vertices whose images cancel to nearly nothing, in half of all cases.
void check_lengths_of_images() {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  std::uniform_real_distribution<double> number(-1, 1);
  const bool cancels = random() % 2 == 0, is_displacement = random() % 2 == 0;
  RC_CLASSIFY(cancels, "degenerate");
  Eigen::Matrix4d offset = Eigen::Matrix4d::Identity();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) offset(i, j) = std::ldexp(number(random), static_cast<int>(random() % 9) - 4);
  const Point3 v(number(random), number(random), number(random));
  auto linear = offset.topLeftCorner<3, 3>();
  if (cancels && is_displacement) linear -= (linear * v * v.transpose() / v.squaredNorm()).eval();
  else if (cancels) offset.topRightCorner<3, 1>() = -(linear * v);
  Model model;
  model.vertices = {v};
  const ImageLength made = is_displacement ? length_of_displacement(model, offset, 0, v) : length_of_vertex(model, offset, 0);
  Vec<Rational, 3> image, parts;
  for (int i = 0; i < 3; ++i) {
    const Rational moved = is_displacement ? Rational(0) : Rational(offset(i, 3));
    image[i] = Rational(offset(i, 0)) * Rational(v[0]) + Rational(offset(i, 1)) * Rational(v[1]) +
               Rational(offset(i, 2)) * Rational(v[2]) + moved;
    parts[i] = image[i] - moved;
  }
  const Rational computed(made.computed), summed = Rational(made.summed) * Rational(1 + 1e-12);
  RC_ASSERT(sq(computed) >= squared_norm(image));
  RC_ASSERT(sq(summed) >= squared_norm(image) && sq(summed) >= squared_norm(parts));
  // Twice the allowance is too much.
  const Rational less = computed - Rational(2 * rounding_of_image) * summed;
  RC_ASSERT(less <= 0 || sq(less) <= squared_norm(image));
}

PROPTEST(node_motions) {
  t.holds("links and chains move within their bounds at any time of a part, as jets say",
          {.number_type = "multiprecision interval",
           .cases = 250,
           .degenerate_at_least = 0.2,
           .degenerate_at_most = 0.9,
           .tags_at_least = {{"bounded", 0.8}}},
          [] {
            const auto plan = gen::draw_animated_plan(*rc::gen::arbitrary<bool>());
            RC_LOG() << plan;
            RC_CLASSIFY(gen::is_degenerate(plan), "degenerate");
            const Model model = gen::animated_model(plan);
            const Animation& animation = model.clips[0].animation;
            const auto& nodes = model.skeleton.nodes;
            std::vector<double> times;
            try {
              times = smooth_times(model.name, nodes, animation);
            } catch (const ModelError&) {
              RC_TAG("refused");
              return;
            }
            RC_TAG("bounded");
            std::mt19937 random(plan.seed + 2);
            for (int i = 0; i < 6 && times.size() > 1; ++i) {
              const std::size_t part = random() % (times.size() - 1);
              const double start = times[part], end = times[part + 1];
              const double at = i == 0   ? start
                                : i == 1 ? end
                                : i == 2 ? std::midpoint(start, end)
                                         : gen::time_within(start, end, random);
              const Side side = at == start ? Side::after : Side::before;
              const auto links = link_motions(nodes, animation, start, end);
              const auto chains = chain_motions(nodes, links);
              std::vector<oracle::Placed<Jet>> local;
              try {
                local = oracle::local_transforms<Jet>(model.skeleton, animation, at, Jet(M(at), M(1), M(0)), side, plan.rigid);
              } catch (const oracle::Ambiguous&) {
                RC_TAG("undecided");
                continue;
              }
              // A quaternion of a node that is not rigid can only be taken from its track.
              for (const NodeTrack& track : animation.tracks)
                local[track.node].turn = oracle::unit<Jet>(oracle::at<Jet>(track.rotations, at, Jet(M(at), M(1), M(0)), side));
              const auto scene = oracle::scene_transforms<Jet>(model.skeleton, local);
              const double rate = 1 / (end - start);
              for (std::size_t n = 0; n < nodes.size(); ++n) {
                moves_within(derivatives_of(local[n]), links[n], rate);
                moves_within(derivatives_of(scene[n]), chains[n], rate);
                const auto same = chain_below(nodes, links, -1, static_cast<int>(n));
                RC_ASSERT(std::abs(same.offset.speed - chains[n].offset.speed) <= 1e-9 * chains[n].offset.speed);
                RC_ASSERT(chain_below(nodes, links, static_cast<int>(n), static_cast<int>(n)).linear.size == 1);
                const auto range = stretches(nodes, animation, start, end)[n];
                const auto d = derivatives_of(local[n]).linear[0].jacobiSvd().singularValues().eval();
                RC_ASSERT(!is_beyond(d[0], range.most, 1e-300) && !is_beyond(range.least * (1 - 1e-9), d[2], 1e-12 * d[0]));
              }
            }
          });
  t.holds(
      "the length of an image is no less than in exact numbers, of images that cancel, too, and more by no more than is allowed "
      "for",
      {.number_type = "double against rational", .cases = 1000, .degenerate_at_least = 0.4, .degenerate_at_most = 0.6},
      check_lengths_of_images);
  times_and_splines(t);
  known_speeds_and_rounding(t);
}

}  // namespace
}  // namespace proptests::suite_node_motions
