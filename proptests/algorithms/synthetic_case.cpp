// SPDX-License-Identifier: GPL-3.0-or-later
// Tests synthetic cases and their scoring, on which the experiment of that name rests.
#include "algorithms/verification/synthetic_case.hpp"

#include <fstream>
#include <iterator>

#include "algorithms/methods/refit/compared_variants.hpp"
#include "algorithms/runtime/balls/smallest_ball_of_balls.hpp"
#include "algorithms/verification/portable_random.hpp"
#include "algorithms/verification/score.hpp"
#include "proptests/cases/statements.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/skinning.hpp"

namespace proptests::suite_synthetic_case {
namespace {

using namespace refitlab;

constexpr std::uint64_t seed = 2006;
constexpr int sample_count = 100;
const char* const sample_file = "proptests/cases/synthetic_sample.json";

std::string text_of(const char* file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(std::string(file) + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

// Returns which promise a synthetic case breaks, or nothing.
std::string complaint(const SyntheticCase& synthetic) {
  if (synthetic.sets.empty() || synthetic.sets.size() > 3) return "the number of joint-sets; ";
  for (const SyntheticSet& set : synthetic.sets) {
    const std::size_t n = set.palette.transforms.size();
    if (n < 1 || n > 5) return "the number of joints; ";
    if (encloses(synthetic.reference, set.reference) != Verdict::holds) return "a joint-set outside the reference ball; ";
    for (std::size_t i = 0; i < n; ++i) {
      const auto& c = set.palette.transforms[i];
      if (squared_norm(c.rotation) != 1) return "a quaternion that is not of unit length; ";
      if (set.palette.center_images[i] != apply(c, set.palette.rotation_center)) return "an image of the rotation center; ";
      for (const Rational& x : {set.bounds.low[i], set.bounds.high[i]})
        if ((x * Rational(1 << 24)).denominator() != 1) return "a bound that is no multiple of 2^-24; ";
    }
    if (weight_vertices_are_admissible(set.bounds, set.weight_vertices) != Verdict::holds ||
        weight_vertices_are_complete(set.bounds, set.weight_vertices) != Verdict::holds || set.weight_vertices.empty())
      return "the weight vertices; ";
    const auto weights = sampled_weights(set);
    if (weights.empty()) return "no weights; ";
    for (const auto& w : weights)
      if (admits<Rational>(set.bounds, w) != Verdict::holds) return "weights outside the bounds; ";
  }
  return "";
}

// Holds scores without any of score.cpp: by matrices in rationals, and without intervals. They say by how much the farthest image
// reaches beyond the ball. This is not above 0 if it holds all of them, which is decided exactly.
struct ByMatrices {
  bool misses = false;
  double worst = 0;
};
ByMatrices by_matrices(const SyntheticCase& synthetic, Skinning skinning, const Ball3<double>& ball) {
  const Ball3<Rational> exact{convert<Rational>(ball.center), Rational(ball.radius)};
  ByMatrices out;
  const auto see = [&](const Vec<Rational, 3>& center, const Rational& radius) {
    out.misses = out.misses || encloses(exact, Ball3<Rational>{center, radius}) != Verdict::holds;
    const double distance = std::sqrt(CGAL::to_double(squared_distance<Rational, 3>(center, exact.center)));
    out.worst = std::max(out.worst, distance + CGAL::to_double(radius) - ball.radius);
  };
  for (const SyntheticSet& set : synthetic.sets)
    for (const auto& w : sampled_weights(set)) {
      const auto& c = set.palette.transforms;
      const auto& [p, r] = set.reference;
      // The middle stands for S where S is a point, and otherwise the ends of its axes do.
      if (skinning == Skinning::linear)
        for (int i = 0; i < 3; ++i)
          for (const int side : {-1, 1})
            see(oracle::linear(c, w, Vec<Rational, 3>(p + Vec<Rational, 3>::Unit(i) * Rational(r * side))), 0);
      else if (skinning == Skinning::dual_quaternion) see(oracle::dual_quaternion(c, w, p), r);
      else see(oracle::spherical(c, w, set.palette.rotation_center, p), r);
    }
  return out;
}

double size_of(const SyntheticCase& synthetic, const Ball3<double>& ball) {
  double size = 0;
  for (const SyntheticSet& set : synthetic.sets) {
    size = std::max(size, norm(lift<double>(set.palette.rotation_center)));
    for (const auto& image : set.palette.center_images) size = std::max(size, norm(lift<double>(image)));
  }
  return size + norm(ball.center) + ball.radius;
}

Ball3<double> scaled(Ball3<double> ball, double factor) {
  ball.radius *= factor;
  return ball;
}

void the_stored_sample_and_what_cases_keep(Suite& t) {
  t.example("the stored sample is what the generator makes of its seed, to the letter", {.number_type = "rational"},
            [] { return Checked(text_of(sample_file) == synthetic_cases_as_case_file(seed, sample_count), sample_count); });
  t.example("each case of the sample is read, and its vertex enclosed by the repaired Algorithm 1",
            {.number_type = "interval to exact"}, [] {
              std::string wrong;
              const auto list = cases::read_cases(sample_file, [](const cases::Case& c) { cases::statement_of(c); });
              for (const auto& c : list)
                if (const auto j = cases::judge_refit(c); j.decided != c.expected)
                  wrong += c.name + " is decided as " + j.decided + "; ";
              return Checked(wrong.empty() && list.size() == sample_count, static_cast<long>(list.size()), wrong);
            });
  t.example("synthetic cases keep what they promise, and a quarter of them is degenerate in one of 8 ways",
            {.number_type = "rational"}, [] {
              std::string wrong;
              std::map<std::string, long> kinds;
              constexpr int count = 1000;
              for (int number = 0; number < count; ++number) {
                const SyntheticCase synthetic = make_synthetic_case(seed, number);
                wrong += complaint(synthetic);
                ++kinds[synthetic.degeneracy];
              }
              if (kinds[""] < count * 2 / 3 || kinds[""] > count * 5 / 6) wrong += "the share of degenerate cases; ";
              if (kinds.size() != 9) wrong += std::to_string(kinds.size() - 1) + " ways; ";
              return Checked(wrong.empty(), count, wrong);
            });
}

// Returns the number of parts that have weights, if a joint-set's weight box is halved so often at the widest weight, the first
// of several.
int parts_with_weights(WeightBounds<Rational> bounds, int halvings) {
  Rational widest(0), least(0), greatest(0);
  std::size_t at = 0;
  for (std::size_t i = 0; i < bounds.low.size(); ++i) {
    const Rational width = bounds.high[i] - bounds.low[i];
    if (width > widest) widest = width, at = i;
    least += bounds.low[i], greatest += bounds.high[i];
  }
  if (halvings == 0 || widest == 0) return least <= 1 && 1 <= greatest ? 1 : 0;
  WeightBounds<Rational> above = bounds;
  bounds.high[at] = above.low[at] = Rational(bounds.low[at] + widest / Rational(2));
  return parts_with_weights(bounds, halvings - 1) + parts_with_weights(above, halvings - 1);
}

void pieces_of_a_synthetic_node(Suite& t) {
  t.holds("a synthetic case's node has the joint-sets' own balls as its pieces', and its own ball about them", {.cases = 100},
          [] {
            const SyntheticCase synthetic = make_synthetic_case(seed, *rc::gen::inRange(0, 1000000));
            const CaseNodes nodes(synthetic);
            for (const Pieces pieces : {Pieces::node, Pieces::joint_sets, Pieces::mixed, Pieces::many}) {
              const auto node = nodes.node(pieces);
              RC_ASSERT(node.reference.radius == lift<double>(synthetic.reference).radius);
              RC_ASSERT(node.pieces.size() >= synthetic.sets.size());
              for (std::size_t i = 0; i < node.pieces.size(); ++i) {
                const auto& set = synthetic.sets[node.pieces[i].joint_set];
                const Ball3<double> expected = lift<double>(pieces == Pieces::node ? synthetic.reference : set.reference);
                RC_ASSERT(node.piece_reference(i).center == expected.center && node.piece_reference(i).radius == expected.radius);
              }
            }
          });
  t.holds("the pieces of a divided joint-set have weight vertices within its bounds, and all of its weights between them",
          {.cases = 300, .tags_at_least = {{"divided", 0.5}}}, [] {
            const SyntheticCase synthetic = make_synthetic_case(seed, *rc::gen::inRange(0, 1000000));
            const CaseNodes nodes(synthetic);
            const auto node = nodes.node(Pieces::many);
            for (std::size_t z = 0; z < synthetic.sets.size(); ++z) {
              const SyntheticSet& set = synthetic.sets[z];
              const std::size_t n = set.palette.transforms.size();
              // There is a box of the weight vertices of each piece.
              std::vector<std::pair<std::vector<double>, std::vector<double>>> boxes;
              for (const auto& piece : node.pieces) {
                if (piece.joint_set != static_cast<int>(z)) continue;
                std::vector<double> low(n, 1), high(n, 0);
                for (int k = 0; k < piece.weight_vertex_count; ++k) {
                  double sum = 0;
                  for (std::size_t i = 0; i < n; ++i) {
                    const double w = node.weight_vertex(piece, k)[i];
                    RC_ASSERT(lift<double>(set.bounds.low[i]) <= w && w <= lift<double>(set.bounds.high[i]));
                    low[i] = std::min(low[i], w), high[i] = std::max(high[i], w), sum += w;
                  }
                  RC_ASSERT(sum == 1);
                }
                boxes.emplace_back(low, high);
              }
              if (boxes.size() > 1) RC_TAG("divided");
              RC_ASSERT(static_cast<int>(boxes.size()) == parts_with_weights(set.bounds, 2));
              for (const auto& weights : sampled_weights(set)) {
                const auto has = [&](const auto& box) {
                  for (std::size_t i = 0; i < n; ++i)
                    if (weights[i] < Rational(box.first[i]) || Rational(box.second[i]) < weights[i]) return false;
                  return true;
                };
                RC_ASSERT(std::any_of(boxes.begin(), boxes.end(), has));
              }
            }
          });
}

void weights_at_which_a_case_is_looked_at(Suite& t) {
  t.example("of up to ten weight vertices each is looked at, and of more every n-th from the first on, ten at most", {}, [] {
    constexpr int most = 60;
    for (int m = 1; m <= most; ++m) {
      SyntheticSet set;
      set.palette.transforms.resize(2);
      for (int k = 0; k < m; ++k) set.weight_vertices.push_back({Rational(k, most), Rational(most - k, most)});
      const auto weights = sampled_weights(set);
      // As few weight vertices are left out as possible.
      std::size_t step = 1;
      while (10 * step < set.weight_vertices.size()) ++step;
      std::size_t count = 0;
      for (std::size_t k = 0; k < set.weight_vertices.size(); k += step, ++count)
        if (count >= weights.size() || weights[count] != set.weight_vertices[k])
          return Checked(false, m, std::to_string(m) + " weight vertices");
      if (weights.size() != (m == 1 ? 1 : count + 16)) return Checked(false, m, "as many others as for any case");
    }
    return Checked(true, most);
  });
}

void scores_of_small_and_undefined_balls(Suite& t) {
  t.holds("a ball that is too small by a share is scored as missing by that share, and the smallest ball as 1",
          {.number_type = "double", .cases = 300}, [] {
            const SyntheticCase synthetic = make_synthetic_case(seed, *rc::gen::inRange(0, 1000000));
            SkinnedCase skinned(synthetic, Skinning::spherical);
            std::vector<Ball3<double>> images;
            double size = 0;
            for (const SyntheticSet& set : synthetic.sets) {
              size = std::max(size, norm(lift<double>(set.palette.rotation_center)));
              for (const auto& image : set.palette.center_images) size = std::max(size, norm(lift<double>(image)));
              for (const auto& w : sampled_weights(set))
                images.push_back({lift<double>(oracle::spherical(set.palette.transforms, w, set.palette.rotation_center,
                                                                 set.reference.center)),
                                  lift<double>(set.reference.radius)});
            }
            const Ball3<double> smallest = smallest_ball_of_balls(images);
            RC_ASSERT(std::abs(skinned.smallest_radius() - smallest.radius) <= 1e-9 * (smallest.radius + size));
            RC_ASSERT(!skinned.score(scaled(smallest, 1 + 1e-6)).misses_beyond_tolerance());
            const double share = *rc::gen::element(1e-3, 0.1, 0.5);
            const CaseScore score = skinned.score(scaled(smallest, 1 - share));
            const double expected = share * smallest.radius / (size + norm(smallest.center) + (1 - share) * smallest.radius);
            if (smallest.radius > 1e-6) RC_ASSERT(score.misses && std::abs(score.worst_miss - expected) <= 1e-6 * expected);
          });
  t.example("a ball that is not a number, or of negative radius, is undefined and misses", {.number_type = "double"}, [] {
    const SyntheticCase synthetic = make_synthetic_case(seed, 0);
    SkinnedCase skinned(synthetic, Skinning::spherical);
    const auto is_undefined = [&](const Ball3<double>& ball) {
      const CaseScore s = skinned.score(ball);
      return s.undefined && s.misses && s.misses_beyond_tolerance();
    };
    const Ball3<double> all_of_space{{0, 0, 0}, INFINITY};
    const CaseScore dual = SkinnedCase(synthetic, Skinning::dual_quaternion).score(all_of_space);
    return dual.unbounded && !dual.undefined && !dual.misses && is_undefined({{0, 0, 0}, -1}) && is_undefined({{0, 0, 0}, NAN}) &&
           is_undefined({{NAN, 0, 0}, 1}) && is_undefined({{0, 0, 0}, INFINITY}) && !is_undefined({{0, 0, 0}, 1e6}) &&
           !skinned.score({{0, 0, 0}, 1e6}).misses;
  });
}

}  // namespace

PROPTEST(synthetic_case) {
  the_stored_sample_and_what_cases_keep(t);
  t.holds("a ball is scored as missing exactly if matrices in rationals say so",
          {.number_type = "double against rational", .cases = 300}, [] {
            const SyntheticCase synthetic = make_synthetic_case(seed, *rc::gen::inRange(0, 1000000));
            const CaseNodes nodes(synthetic);
            const RefitVariant& variant = compared_variant(*rc::gen::element<std::string>(
                "spherical_printed_signed", "spherical_repaired", "control_mean", "dual_quaternion_control_mean", "linear"));
            SkinnedCase skinned(synthetic, variant.skinning);
            const Ball3<double> ball =
                scaled(variant.refit(nodes.node(variant.pieces)), *rc::gen::element(1.0, 0.97, 0.9, 1.0000001));
            const CaseScore score = skinned.score(ball);
            RC_CLASSIFY(score.misses, "missed");
            RC_CLASSIFY(score.undefined, "undefined");
            RC_CLASSIFY(score.unbounded, "unbounded");
            RC_PRE(!score.unbounded);
            if (score.undefined) {
              RC_ASSERT(score.misses && score.worst_miss == 1);
              return;
            }
            const ByMatrices expected = by_matrices(synthetic, variant.skinning, ball);
            RC_ASSERT(score.misses == expected.misses);
            RC_ASSERT(std::abs(score.worst_miss - expected.worst / size_of(synthetic, ball)) <= 1e-13);
          });
  weights_at_which_a_case_is_looked_at(t);
  pieces_of_a_synthetic_node(t);
  scores_of_small_and_undefined_balls(t);
  t.example("every sound variant holds every synthetic case up to rounding; each printed form misses some",
            {.number_type = "double against rational"}, [] {
              constexpr int count = 300;
              std::map<std::string, long> missed, unbounded;
              for (int number = 0; number < count; ++number) {
                const SyntheticCase synthetic = make_synthetic_case(seed, number);
                const CaseNodes nodes(synthetic);
                std::map<Skinning, SkinnedCase> skinned;
                for (const Skinning s : {Skinning::linear, Skinning::spherical, Skinning::dual_quaternion})
                  skinned.emplace(s, SkinnedCase(synthetic, s));
                for (const RefitVariant& v : compared_variants()) {
                  const auto ball = v.refit(nodes.node(v.pieces));
                  const CaseScore score = skinned.at(v.skinning).score(ball);
                  missed[v.name] += score.misses_beyond_tolerance();
                  unbounded[v.name] += score.unbounded;
                }
              }
              std::string wrong;
              for (const RefitVariant& v : compared_variants())
                if ((missed[v.name] == 0) != v.sound) wrong += v.name + " misses " + std::to_string(missed[v.name]) + "; ";
                else if (unbounded[v.name] * 10 > count)
                  wrong += v.name + " gives up on " + std::to_string(unbounded[v.name]) + "; ";
              return Checked(wrong.empty(), count, wrong);
            });
}

}  // namespace proptests::suite_synthetic_case
