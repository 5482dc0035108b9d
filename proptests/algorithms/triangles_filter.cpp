// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/runtime/collide/triangles_filter.hpp"

#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "algorithms/runtime/collide/box_kernel.hpp"
#include "algorithms/runtime/collide/cluster_pair_kernel.hpp"
#include "algorithms/runtime/packs/pack.hpp"
#include "lemmas/exact/exact.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/triangles_meet.hpp"

namespace proptests::suite_triangles_filter {
namespace {

using namespace refitlab;

bool never_wrong(const TrianglePoints& a, const TrianglePoints& b, bool meets) {
  const Filtered quick = filter_triangles(a, b);
  return quick == Filtered::unknown || (quick == Filtered::meet) == meets;
}

// Says whether the filter is never wrong in the six orders of the vertices of each triangle and both orders of the two.
bool never_wrong_in_any_order(const TrianglePoints& a, const TrianglePoints& b) {
  const bool meets = oracle::triangles_meet(a, b);
  static constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (const auto& i : orders)
    for (const auto& j : orders) {
      const TrianglePoints p{a[i[0]], a[i[1]], a[i[2]]}, q{b[j[0]], b[j[1]], b[j[2]]};
      if (!never_wrong(p, q, meets) || !never_wrong(q, p, meets)) return false;
    }
  return true;
}

TrianglePoints random_triangle(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> u(-size, size);
  TrianglePoints t;
  for (auto& p : t) p = {u(random), u(random), u(random)};
  return t;
}

void decisions_are_those_of_exact_arithmetic(Suite& t) {
  t.holds("what it says of random triangles is what exact arithmetic says, whatever the order of their vertices",
          {.number_type = "rational", .cases = 400}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const TrianglePoints a = random_triangle(random, 1), b = random_triangle(random, *rc::gen::element(1.0, 0.1));
            RC_ASSERT(never_wrong_in_any_order(a, b));
            RC_TAG(filter_triangles(a, b) == Filtered::meet ? "meet" : "apart");
            RC_ASSERT(filter_triangles(a, b) != Filtered::unknown);
          });
  t.holds("nor is it wrong where rounding decides: a vertex of one nearly in the other's plane, edge or vertex",
          {.number_type = "rational", .cases = 400, .degenerate_at_least = 0.3, .degenerate_at_most = 1}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const TrianglePoints a = random_triangle(random, 1);
            TrianglePoints b = random_triangle(random, 1);
            std::uniform_real_distribution<double> u(0, 1), v(-1, 1);
            const double s = *rc::gen::element(0.0, 1.0, u(random)), w = *rc::gen::element(0.0, 1.0, u(random));
            b[0] = a[0] * (1 - s) + (a[1] * (1 - w) + a[2] * w) * s;
            if (*rc::gen::arbitrary<bool>()) b[1] = a[1] * 0.5 + a[2] * 0.5;
            const double off = *rc::gen::element(0.0, 1e-16, 1e-15, 1e-14, 1e-13);
            b[0] += Vec<double, 3>(v(random), v(random), v(random)) * off;
            // The unit may be so small that determinants lose digits.
            const double unit = *rc::gen::element(1.0, 1.0, 0x1p-348, 0x1p-352);
            TrianglePoints a_unit = a;
            for (int i = 0; i < 3; ++i) a_unit[i] *= unit, b[i] *= unit;
            RC_CLASSIFY(filter_triangles(a_unit, b) == Filtered::unknown, "degenerate");
            RC_TAG(filter_triangles(a_unit, b) == Filtered::unknown ? "unknown" : "decided");
            RC_ASSERT(never_wrong_in_any_order(a_unit, b));
          });
  t.holds("nor where coordinates have units of their own, from the smallest to the largest, whose products underflow or overflow",
          {.number_type = "rational", .cases = 2000, .degenerate_at_least = 0.5}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const auto whole = [&] {
              return Vec<double, 3>(int(random() % 17) - 8, int(random() % 17) - 8, int(random() % 17) - 8);
            };
            TrianglePoints a{whole(), whole(), whole()}, b{whole(), whole(), whole()};
            const bool is_near = random() % 4 != 0;
            if (is_near) b[0] = a[0] + (a[1] - a[0]) * 0.25 + (a[2] - a[0]) * (random() % 2 ? 0.5 : 0.0);
            RC_CLASSIFY(is_near, "degenerate");
            const int most = *rc::gen::element(30, 345, 1000);
            const auto exponent = [&] { return int(random() % (2 * most + 1)) - most; };
            const int all = exponent();
            const bool is_even = random() % 2;
            for (int i = 0; i < 3; ++i) {
              const double unit = std::ldexp(1.0, is_even ? all : exponent());
              for (auto* t : {&a, &b})
                for (auto& p : *t) p[i] *= unit;
            }
            RC_TAG(filter_triangles(a, b) == Filtered::unknown ? "unknown" : "decided");
            RC_ASSERT(never_wrong_in_any_order(a, b));
          });
}

void what_is_decided_and_what_is_left_open(Suite& t) {
  t.example("triangles of common sizes are decided, those of sizes beyond 1e100 and below 1e-66 are not", {}, [] {
    const TrianglePoints a{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, through{{{0.2, 0.2, -1}, {0.2, 0.3, 1}, {0.3, 0.2, 1}}},
        above{{{0.2, 0.2, 1}, {0.2, 0.3, 2}, {0.3, 0.2, 3}}};
    bool ok = true;
    for (const double unit : {1e-60, 1e-30, 1.0, 1e30, 1e98, 1e-67, 1e101}) {
      TrianglePoints p = a, q = through, r = above;
      for (auto* t : {&p, &q, &r})
        for (auto& x : *t) x *= unit;
      const bool is_common = unit > 1e-61 && unit < 1e99;
      ok = ok && filter_triangles(p, q) == (is_common ? Filtered::meet : Filtered::unknown) &&
           filter_triangles(p, r) == (is_common ? Filtered::apart : Filtered::unknown);
    }
    return Checked(ok, 14);
  });
  t.example("packs of random pairs are decided as one pair is, and floats near the vertices decide nearly all of them", {}, [] {
    std::mt19937 random(2006);
    constexpr float slack = 1e-6f;
    std::uniform_real_distribution<float> off(-slack, slack);
    using Doubles = Pack<double>;
    using Floats = Pack<float, static_cast<int>(Doubles::size())>;
    const auto lanes_of = []<class P>(P, const std::vector<TrianglePoints>& from) {
      TriangleOf<P> out;
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
          out[k][i] = P([&](std::size_t lane) { return static_cast<typename P::value_type>(from[lane][k][i]); });
      return out;
    };
    long pairs = 0, open = 0;
    for (int c = 0; c < 1000; ++c) {
      std::vector<TrianglePoints> a, b;
      for (std::size_t lane = 0; lane < Doubles::size(); ++lane)
        a.push_back(random_triangle(random, 1)), b.push_back(random_triangle(random, 1));
      const auto lanes = filter_lanes(lanes_of(Doubles(), a), lanes_of(Doubles(), b));
      std::vector<TrianglePoints> near_a = a, near_b = b;
      for (auto* all : {&near_a, &near_b})
        for (TrianglePoints& points : *all)
          for (auto& p : points)
            // The other half is for the rounding to float.
            for (double& x : p) x += off(random) / 2;
      const NearVertices<Floats> vertices{Floats(2 * slack)};
      const auto near = filter_lanes(lanes_of(Floats(), near_a), lanes_of(Floats(), near_b), vertices);
      for (std::size_t lane = 0; lane < Doubles::size(); ++lane, ++pairs) {
        const Filtered one = filter_triangles(a[lane], b[lane]);
        if (one == Filtered::unknown || lanes.meet[lane] != (one == Filtered::meet) ||
            lanes.are_apart[lane] != (one == Filtered::apart))
          return Checked(false, pairs, "a lane differs from its pair");
        if ((near.meet[lane] && one != Filtered::meet) || (near.are_apart[lane] && one != Filtered::apart))
          return Checked(false, pairs, "floats are wrong");
        open += !near.meet[lane] && !near.are_apart[lane];
      }
    }
    return Checked(100 * open < pairs, pairs, std::to_string(open) + " left open by floats");
  });
  t.example("flat triangles, those in one plane, those that touch, and tiny or non-finite ones are left open", {}, [] {
    const TrianglePoints a{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, flat{{{0, 0, 0}, {0.25, 0.25, 0}, {0.5, 0.5, 0}}},
        beside{{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}}}, standing{{{0.2, 0.2, 0}, {0.2, 0.2, 1}, {0.3, 0.2, 1}}};
    TrianglePoints tiny_a = a, tiny_b = standing, undefined = standing;
    for (int i = 0; i < 3; ++i) tiny_a[i] *= 1e-150, tiny_b[i] *= 1e-150;
    undefined[1][2] = std::numeric_limits<double>::quiet_NaN();
    for (const auto& [p, q] : {std::pair(a, flat), std::pair(a, beside), std::pair(a, standing), std::pair(tiny_a, tiny_b),
                               std::pair(a, undefined), std::pair(a, a)})
      if (filter_triangles(p, q) != Filtered::unknown || filter_triangles(q, p) != Filtered::unknown) return Checked(false, 12);
    return Checked(true, 12);
  });
}

// --- Slopes ---

using ExactPoint = Vec<Rational, 3>;
// Signs say for each coordinate of four vertices whether it is off upward, downward, or, by 0, not at all.
using Signs = std::array<std::array<int, 3>, 4>;

Signs opposite(Signs signs) {
  for (auto& of_vertex : signs)
    for (int& sign : of_vertex) sign = -sign;
  return signs;
}

Rational determinant(const std::array<ExactPoint, 4>& at) {
  const ExactPoint p = at[1] - at[0], q = at[2] - at[0], r = at[3] - at[0];
  return dot<Rational, 3>(cross<Rational>(p, q), r);
}

// A DeterminantCase has four vertices in float, and a slack. Some are nearly in a plane or on a line, some have coordinates in units of
// their own, and the slack may be as large as they are.
struct DeterminantCase {
  explicit DeterminantCase(std::mt19937& random) {
    std::uniform_real_distribution<float> u(-1, 1);
    const auto one_of = [&](std::initializer_list<float> list) { return list.begin()[random() % list.size()]; };
    for (auto& v : at) v = {u(random), u(random), u(random)};
    const float off = one_of({0, 1e-7f, 1e-4f});
    const auto shifted = [&](const Vec<float, 3>& v) {
      return Vec<float, 3>(v[0] + off * u(random), v[1] + off * u(random), v[2] + off * u(random));
    };
    kind = random() % 4;
    if (kind == 1) at[3] = shifted(at[0] + (at[1] - at[0]) * u(random) + (at[2] - at[0]) * u(random));
    if (kind == 2) at[2] = shifted(at[0] + (at[1] - at[0]) * u(random));
    if (kind == 3) at[random() % 3] = shifted(at[3]);
    const Vec<float, 3> from(10 * u(random), 10 * u(random), 10 * u(random));  // far from the origin, differences are rounded
    const bool is_far = random() % 2;
    for (int i = 0; i < 3; ++i) {
      const float unit = one_of({1, 1, 1e-3f, 1e3f});
      for (auto& v : at) v[i] = unit * (is_far ? v[i] + from[i] : v[i]);
    }
    slack = one_of({0, 1e-7f, 1e-5f, 1e-3f, 0.1f, 10});
  }

  // Returns the computed determinant, and its error, by slopes or by extents.
  template <class Vertices = NearVerticesBySlopes<float>>
  std::pair<float, float> computed() const {
    const Vec<float, 3> p = at[1] - at[0], q = at[2] - at[0], r = at[3] - at[0], normal = cross<float>(p, q);
    const Vertices vertices{{2 * slack}};
    DifferenceExtent<float, Vertices> extent(vertices);
    extent.add(p), extent.add(q), extent.add(r);
    return {dot<float, 3>(normal, r), extent.error_of(extent.error(), p, q, normal, r)};
  }
  // Returns the exact vertices, moved by the slack as the signs say.
  std::array<ExactPoint, 4> moved(const Signs& signs) const {
    std::array<ExactPoint, 4> out;
    for (int v = 0; v < 4; ++v)
      for (int i = 0; i < 3; ++i) out[v][i] = Rational(at[v][i]) + signs[v][i] * Rational(slack);
    return out;
  }
  // Returns how far the computed determinant is off that of the moved vertices.
  Rational off(const Signs& signs) const { return absolute<Rational>(determinant(moved(signs)) - Rational(computed().first)); }
  // Returns the signs of the derivatives.
  Signs steepest() const {
    const std::array<ExactPoint, 4> exact = moved({});
    Signs signs;
    for (int v = 0; v < 4; ++v)
      for (int i = 0; i < 3; ++i) {
        auto next = exact;  // the determinant is linear in each coordinate
        next[v][i] += 1;
        signs[v][i] = determinant(next) < determinant(exact) ? -1 : 1;
      }
    return signs;
  }

  std::array<Vec<float, 3>, 4> at;
  float slack;
  unsigned kind;
};

void slopes_allow_for_all(Suite& t) {
  t.holds("neither error is less than what the determinant loses, with vertices off as far as they can be, up or down",
          {.number_type = "rational", .cases = 3000, .degenerate_at_least = 0.5}, [] {
            std::mt19937 random(*rc::gen::arbitrary<unsigned>());
            const DeterminantCase c(random);
            RC_CLASSIFY(c.kind > 0, "degenerate");
            RC_TAG(c.slack > 0 ? "with slack" : "rounding alone");
            const Rational error(std::min(c.computed().second, c.computed<NearVertices<float>>().second));
            const Signs steepest = c.steepest();
            RC_ASSERT(c.off(steepest) <= error);
            RC_ASSERT(c.off(opposite(steepest)) <= error);
            Signs any;
            for (auto& of_vertex : any)
              for (int& sign : of_vertex) sign = static_cast<int>(random() % 3) - 1;
            RC_ASSERT(c.off(any) <= error);
          });
  t.example("where the slack is small and rounding is nothing beside it, that error is at most a twentieth more", {}, [] {
    std::mt19937 random(2006);
    std::uniform_real_distribution<float> u(-1, 1);
    double greatest = 0;
    long cases = 0;
    while (cases < 500) {
      DeterminantCase c(random);
      for (auto& v : c.at) v = {u(random), u(random), u(random)};
      c.slack = 1e-4f;
      const Signs steepest = c.steepest();
      const Rational most = std::max(c.off(steepest), c.off(opposite(steepest)));
      if (c.off({}) * 1000 > most) continue;
      ++cases, greatest = std::max(greatest, c.computed().second / CGAL::to_double(most));
    }
    return Checked(greatest >= 1 && greatest < 1.05, cases, "at most " + std::to_string(greatest) + " times what vertices lose");
  });
  t.example("of corners of a box that become longer, the error by extents is at most a fiftieth more, however large the slack is",
            {}, [] {
              std::mt19937 random(2006);
              std::uniform_real_distribution<float> u(0.5, 2);
              double least = HUGE_VAL, greatest = 0;
              for (int n = 0; n < 500; ++n) {
                DeterminantCase c(random);
                c.slack = std::ldexp(1.f, static_cast<int>(random() % 16) - 8);
                const ExactPoint extent(Rational(u(random)), Rational(u(random)), Rational(u(random)));
                const auto at = box_corners<Rational>(extent, 0), moved = box_corners<Rational>(extent, Rational(c.slack));
                for (int v = 0; v < 4; ++v)
                  for (int i = 0; i < 3; ++i) c.at[v][i] = static_cast<float>(CGAL::to_double(at[v][i]));
                const auto [computed, error] = c.computed<NearVertices<float>>();
                const double share = error / CGAL::to_double(determinant(moved) - Rational(computed));
                least = std::min(least, share), greatest = std::max(greatest, share);
              }
              return Checked(least >= 1 && greatest < 1.02, 500,
                             std::to_string(least) + " to " + std::to_string(greatest) + " times");
            });
}

// Draws a pair of triangles. Some have a vertex near the other's plane.
std::pair<TrianglePoints, TrianglePoints> drawn_pair(std::mt19937& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  std::pair<TrianglePoints, TrianglePoints> out{random_triangle(random, 1), random_triangle(random, 1)};
  auto& [a, b] = out;
  if (random() % 2)
    b[random() % 3] = a[0] + (a[1] - a[0]) * u(random) + (a[2] - a[0]) * u(random) + Point3(0, 0, 1e-4 * u(random));
  return out;
}

void slopes_decide_more(Suite& t) {
  t.example(
      "on every target, the filter by slopes is never wrong of vertices that are off, decides more than two fifths of what "
      "extents "
      "leave open, and leaves open what has a large slack",
      {}, [] {
        std::mt19937 random(2006);
        constexpr float slack = 1e-6f;
        std::uniform_real_distribution<float> off(-slack, slack);
        using Floats = Pack<float>;
        long pairs = 0, open_before = 0, open = 0;
        for (const Target target : available_targets())
          for (int count = 0; count <= 100; ++count) {
            std::vector<TrianglePairBlock> blocks(static_cast<std::size_t>(blocks_for<float>(count)));
            for (auto& block : blocks)
              std::fill_n(block.first[0].lane.data(), sizeof block / sizeof(float), std::numeric_limits<float>::quiet_NaN());
            std::vector<std::pair<TrianglePoints, TrianglePoints>> drawn;
            std::vector<bool> has_large_slack, is_left_open;
            for (int k = 0; k < count; ++k) {
              auto& block = blocks[static_cast<std::size_t>(k / 16)];
              const auto& [a, b] = drawn.emplace_back(drawn_pair(random));
              TriangleOf<Floats> first, second;
              for (int c = 0; c < 3; ++c)
                for (int i = 0; i < 3; ++i) {  // the other half is for the rounding to float
                  const float x = static_cast<float>(a[c][i] + off(random) / 2),
                              y = static_cast<float>(b[c][i] + off(random) / 2);
                  block.first[3 * c + i].lane[k % 16] = x, block.second[3 * c + i].lane[k % 16] = y;
                  first[c][i] = Floats(x), second[c][i] = Floats(y);
                }
              has_large_slack.push_back(random() % 4 == 0);
              block.slack.lane[k % 16] = has_large_slack.back() ? 10 : slack;
              const auto before = filter_lanes(first, second, NearVertices<Floats>{Floats(2 * slack)});
              is_left_open.push_back(!before.are_apart[0] && !before.meet[0]);
            }
            std::vector<Filtered> answers(static_cast<std::size_t>(count));
            cluster_pair_kernels(target).filter_by_slopes(blocks.data(), count, answers.data());
            for (std::size_t k = 0; k < answers.size(); ++k, ++pairs) {
              if (has_large_slack[k]) {
                if (answers[k] != Filtered::unknown) return Checked(false, pairs, "a large slack is passed over");
                continue;
              }
              open_before += is_left_open[k], open += answers[k] == Filtered::unknown;
              const Filtered one = filter_triangles(drawn[k].first, drawn[k].second);
              if (answers[k] != Filtered::unknown && answers[k] != one) return Checked(false, pairs, "it is wrong");
            }
          }
        return Checked(open_before > 100 && 5 * open < 3 * open_before, pairs,
                       std::to_string(open_before) + " left open before, " + std::to_string(open) + " by slopes");
      });
}

// Puts the triangle behind the others and returns its places.
std::array<std::uint16_t, 3> put(const TrianglePoints& triangle, std::vector<PaddedVertex>& vertices) {
  std::array<std::uint16_t, 3> places;
  for (int c = 0; c < 3; ++c) {
    places[c] = static_cast<std::uint16_t>(vertices.size());
    vertices.push_back({triangle[c][0], triangle[c][1], triangle[c][2], 0});
  }
  return places;
}

void kernels_answer_as_for_one_pair(Suite& t) {
  t.example("on every target the kernel decides each pair of a list as one pair is, however many there are", {}, [] {
    std::mt19937 random(2006);
    long pairs = 0;
    for (const Target target : available_targets())
      for (int count = 0; count <= 40; ++count) {
        std::vector<TrianglePoints> a, b;
        std::vector<PaddedVertex> vertices_a, vertices_b;
        std::vector<TrianglePairCandidate> candidates;
        for (int p = 0; p < count; ++p) {
          a.push_back(random_triangle(random, 1)), b.push_back(random_triangle(random, 1));
          candidates.push_back({put(a[p], vertices_a), put(b[p], vertices_b), p, p});
        }
        std::shuffle(candidates.begin(), candidates.end(), random);
        std::vector<Filtered> answers(static_cast<std::size_t>(count));
        box_kernels(target).filter_pairs(vertices_a.data(), vertices_b.data(), candidates.data(), count, answers.data());
        for (int k = 0; k < count; ++k, ++pairs) {
          const Filtered one = filter_triangles(a[candidates[k].first], b[candidates[k].second]);
          if (one == Filtered::unknown || answers[k] != one) return Checked(false, pairs, "a pair is decided in another way");
        }
      }
    return Checked(pairs > 0, pairs);
  });
}

}  // namespace

PROPTEST(triangles_filter) {
  kernels_answer_as_for_one_pair(t);
  decisions_are_those_of_exact_arithmetic(t);
  what_is_decided_and_what_is_left_open(t);
  slopes_allow_for_all(t);
  slopes_decide_more(t);
}

}  // namespace proptests::suite_triangles_filter
