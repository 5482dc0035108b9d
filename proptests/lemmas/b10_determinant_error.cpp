// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/b10_determinant_error.hpp"

#include "proptests/counterexamples/b10_determinant_error.hpp"
#include "proptests/gen/vector.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"

namespace proptests::suite_b10_determinant_error {
namespace {

using namespace refitlab;
using gen::RationalVec;
using Points = FourPoints<Rational>;
using Errors = CoordinateErrors<Rational>;

// Returns the determinant as the sum of its six products.
Rational six_products(const Points& at) {
  static constexpr int orders[6][4] = {{0, 1, 2, 1}, {1, 2, 0, 1}, {2, 0, 1, 1}, {0, 2, 1, -1}, {2, 1, 0, -1}, {1, 0, 2, -1}};
  Rational sum(0);
  for (const auto& i : orders) {
    Rational product(i[3]);
    for (int k = 0; k < 3; ++k) product *= at[k + 1][i[k]] - at[0][i[k]];
    sum += product;
  }
  return sum;
}
// Returns the sum of the absolute slopes. D is linear in each coordinate, so a step of 1 finds its slope.
Rational sum_of_steps(const Points& at) {
  Rational sum(0);
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < 3; ++i) {
      Points next = at;
      next[k][i] += Rational(1);
      sum += absolute<Rational>(six_products(next) - six_products(at));
    }
  return sum;
}
// Returns the greatest coordinates of the differences.
RationalVec<3> least_extent(const Points& at) {
  RationalVec<3> out(0, 0, 0);
  for (int k = 1; k < 4; ++k)
    for (int i = 0; i < 3; ++i) out[i] = std::max(out[i], absolute<Rational>(at[k][i] - at[0][i]));
  return out;
}
// Returns the points mirrored at the origin.
Points opposite(Points at) {
  for (auto& point : at) point = -point;
  return at;
}

// Draws a power of ten, which is 1 in half of the cases.
Rational unit() {
  static const Rational thousand(1000), far("1000000000000000000000000000000");
  return *rc::gen::element(Rational(1), Rational(1), Rational(1), thousand, Rational(1) / thousand, far, Rational(1) / far);
}

enum class Kind { generic, one_plane, one_line, two_are_one, all_are_one };

// Points that are off by no more than h. Some are in one plane, on one line, or one, some have coordinates in units of their own, and h
// may be 0, or more than the points are apart.
struct PointsCase {
  Points at, moved;
  Errors errors;
  Kind kind;
  PointsCase() {
    kind = *rc::gen::element(Kind::generic, Kind::generic, Kind::generic, Kind::one_plane, Kind::one_line, Kind::two_are_one,
                             Kind::all_are_one);
    for (auto& point : at) point = *gen::rational_vector<3>();
    const Rational s = *gen::rational(), t = *gen::rational();
    if (kind == Kind::one_plane) at[3] = at[0] + (at[1] - at[0]) * s + (at[2] - at[0]) * t;
    if (kind == Kind::one_line)
      for (const int k : {2, 3}) at[k] = at[0] + (at[1] - at[0]) * (k == 2 ? s : t);
    if (kind == Kind::two_are_one) at[1 + gen::any_place(3)] = at[0];
    if (kind == Kind::all_are_one) at[1] = at[2] = at[3] = at[0];
    for (int i = 0; i < 3; ++i) {
      const Rational size = unit();
      for (auto& point : at) point[i] *= size;
    }
    errors.off = *gen::positive_rational() * unit() *
                 *rc::gen::element(Rational(0), Rational(1), Rational(1, 100), Rational(1, 10'000), Rational(100));
    errors.extent = least_extent(at);
    if (gen::any_place(4) == 0) errors.extent[static_cast<int>(gen::any_place(3))] += *gen::positive_rational();
    moved = steepest_points(at, errors.off);
    const std::size_t way = gen::any_place(3);
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 3; ++i) {
        const Rational error = moved[k][i] - at[k][i];
        if (way == 1) moved[k][i] = at[k][i] - error;
        if (way == 2) moved[k][i] = at[k][i] + error * *rc::gen::element(Rational(1), Rational(-1), Rational(0), Rational(2, 3));
      }
  }
  Verdict hypotheses() const { return are_coordinate_errors(at, moved, errors); }
  bool is_degenerate() const { return six_products(at) == 0 || errors.off == 0; }
  // Returns the terms of the statement, as it writes them.
  Rational e() const { return Rational(2) * errors.off; }
  Rational products() const {
    const auto& x = errors.extent;
    return x[0] * x[1] + x[1] * x[2] + x[2] * x[0];
  }
  Rational higher() const {
    return Rational(3) * sq(e()) * (errors.extent[0] + errors.extent[1] + errors.extent[2]) + Rational(2) * sq(e()) * e();
  }
};

void formulas_are_those_of_the_statement(Suite& t) {
  const auto are_right = []<class S>(const S& one) {
    using V = Vec<S, 3>;
    const S two = S(2) * one;
    const V by_b(one, -two, S(0)), by_c(S(0), S(0), S(3)), by_d(-one, S(0), -one);
    const CoordinateErrors<S> errors{one, V(one, two, S(3))};
    const FourPoints<S> at{V(one, one, one), V(two, one, one), V(one, S(3), one), V(one, one, S(4))};
    return one_norm<S>(by_b) == S(3) && sum_of_slopes<S>(by_b, by_c, by_d) == S(12) &&
           first_order_by_slopes<S>(two, S(3)) == S(6) && first_order_by_extents<S>(two, S(3)) == S(24) &&
           second_order_by_extents<S>(two, S(5)) == S(60) && third_order<S>(two) == S(16) &&
           errors.by_extents() == S(88 + 72 + 16) && determinant_of<S>(at) == S(6) && errors.first_order(at) == S(22) &&
           errors.by_slopes(at) == S(22 + 72 + 16);
  };
  t.example("h = 1 and extents of 1, 2, 3 lose 4 2 11 + 3 4 6 + 2 8 at most, in each number type", {},
            [&] { return are_right(Rational(1)) && are_right(1.0) && are_right(1.0F); });
}

void determinants_change_within_the_bounds(Suite& t) {
  t.holds("the determinant changes by no more than extents and slopes say, and each order by no more than its part",
          {.form = "beyond", .number_type = "rational", .cases = 1500, .degenerate_at_least = 0.3, .degenerate_at_most = 0.9},
          [] {
            const PointsCase c;
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_ASSERT(c.hypotheses() == Verdict::holds);
            const auto found = determinant_change(c.at, c.moved, c.errors);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(is_determinant_change(c.at, c.moved, c.errors, found) == Verdict::holds);
            const Rational before = six_products(c.at), now = six_products(c.moved), change = absolute<Rational>(now - before);
            RC_ASSERT(found.first + found.second + found.third == now - before);
            RC_ASSERT(determinant_of(c.at) == before);
            RC_ASSERT(changes_by_extents(before, now, c.errors) == Verdict::holds);
            RC_ASSERT(changes_by_slopes(c.at, now, c.errors) == Verdict::holds);
            // The same as the statement writes it.
            RC_ASSERT(change <= Rational(4) * c.e() * c.products() + c.higher());
            RC_ASSERT(change <= c.errors.off * sum_of_steps(c.at) + c.higher());
          });
  t.holds("the slopes say no more than the extents",
          {.form = "beyond", .number_type = "rational", .cases = 1000, .degenerate_at_least = 0.3, .degenerate_at_most = 0.9},
          [] {
            const PointsCase c;
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_ASSERT(slopes_are_within_extents(c.at, c.errors) == Verdict::holds);
            RC_ASSERT(c.errors.first_order(c.at) == c.errors.off * sum_of_steps(c.at));
            RC_ASSERT(c.errors.by_slopes(c.at) <= c.errors.by_extents());
          });
}

void bounds_are_reached(Suite& t) {
  t.holds("points that are off as the signs of the slopes say reach them to first order",
          {.form = "beyond", .number_type = "rational", .cases = 1000, .degenerate_at_least = 0.3, .degenerate_at_most = 0.9},
          [] {
            const PointsCase c;
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            const Points moved = steepest_points(c.at, c.errors.off);
            RC_ASSERT(reaches_slopes(c.at, moved, c.errors) == Verdict::holds);
            RC_ASSERT(are_off_at_most(c.at, moved, c.errors.off) == Verdict::holds);
            const Rational change = six_products(moved) - six_products(c.at);
            RC_ASSERT(change >= c.errors.off * sum_of_steps(c.at) - c.higher());
            // In the other direction they do not, nor where a coordinate is not off.
            Points back = c.at, fewer = moved;
            for (int k = 0; k < 4; ++k) back[k] = c.at[k] * Rational(2) - moved[k];
            if (c.errors.off * sum_of_steps(c.at) > c.higher()) RC_ASSERT(reaches_slopes(c.at, back, c.errors) == Verdict::fails);
            const int k = static_cast<int>(gen::any_place(4)), i = static_cast<int>(gen::any_place(3));
            fewer[k][i] = c.at[k][i];
            if (c.errors.off > 0) RC_ASSERT(reaches_slopes(c.at, fewer, c.errors) == Verdict::fails);
          });
  t.holds("where errors are small, the determinant loses nine tenths of the bound by slopes",
          {.form = "beyond", .number_type = "rational", .cases = 500}, [] {
            Points at;
            for (auto& point : at) point = *gen::rational_vector<3>();
            const Rational slopes = sum_of_steps(at);
            RC_PRE(slopes > 0);
            const RationalVec<3> extent = least_extent(at);
            const Rational sum = extent[0] + extent[1] + extent[2];
            const Rational off = slopes / (Rational(1000) * (sum + slopes)) / (Rational(1) + slopes);
            const Errors errors{off, extent};
            const Points moved = steepest_points(at, off);
            RC_ASSERT(six_products(moved) - six_products(at) >= errors.by_slopes(at) * Rational(9, 10));
          });
  t.holds("corners of a box reach the bound by extents, whatever x, y, z and h are",
          {.form = "beyond", .number_type = "rational", .cases = 500, .degenerate_at_least = 0.2}, [] {
            const auto length = [] {
              return *rc::gen::element(Rational(0), Rational(1), Rational(1), Rational(1)) * *gen::positive_rational() * unit();
            };
            const Errors errors{length(), {length(), length(), length()}};
            const bool is_mirrored = *rc::gen::arbitrary<bool>();
            Points at = box_corners(errors.extent, Rational(0)), moved = box_corners(errors.extent, errors.off);
            if (is_mirrored) at = opposite(at), moved = opposite(moved);
            RC_CLASSIFY(six_products(at) == 0 || errors.off == 0, "degenerate");
            RC_ASSERT(are_coordinate_errors(at, moved, errors) == Verdict::holds);
            const Rational before = six_products(at), now = six_products(moved);
            RC_ASSERT(absolute<Rational>(now - before) == errors.by_extents());
            RC_ASSERT(errors.by_slopes(at) == errors.by_extents());
            RC_ASSERT(changes_by_extents(before, now, errors) == Verdict::holds);
            if (errors.by_extents() == 0) return;
            const Rational less = Rational(1) / (Rational(1) + *gen::excess());
            const Errors too_small{errors.off * less, errors.extent * less};
            RC_ASSERT(changes_by_extents(before, now, too_small) == Verdict::fails);
            RC_ASSERT(changes_by_slopes(at, now, Errors{errors.off * less, errors.extent}) == Verdict::fails);
          });
}

void signs_are_kept(Suite& t) {
  t.holds("a number near the determinant that is beyond the bound has the sign of that of the points that are off",
          {.form = "beyond",
           .number_type = "rational",
           .cases = 1500,
           .degenerate_at_least = 0.3,
           .degenerate_at_most = 0.9,
           .tags_at_least = {{"beyond the bound", 0.1}}},
          [] {
            const PointsCase c;
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            const Rational before = six_products(c.at), now = six_products(c.moved), bound = c.errors.by_slopes(c.at);
            const Rational lost = (bound + absolute<Rational>(before)) *
                                  *rc::gen::element(Rational(0), Rational(1, 10), Rational(2)),
                           computed = before + lost * *rc::gen::element(Rational(1), Rational(-1), Rational(1, 2));
            RC_CLASSIFY(absolute<Rational>(computed) > bound + lost, "beyond the bound");
            RC_ASSERT(keeps_sign(computed, bound, lost, now) == Verdict::holds);
            if (absolute<Rational>(computed) > bound + lost) RC_ASSERT((computed > 0) == (now > 0) && now != 0);
          });
  t.holds("a number within the bound may have any sign, and one beyond it has just one",
          {.number_type = "rational", .cases = 200}, [] {
            const Rational bound = *gen::positive_rational(), lost = *gen::positive_rational(), excess = *gen::excess(),
                           sign = *rc::gen::element(Rational(1), Rational(-1)), most = bound + lost, beyond = most + excess;
            for (const Rational& now : {Rational(1), Rational(0), Rational(-1)}) {
              RC_ASSERT(keeps_sign<Rational>(sign * most, bound, lost, now) == Verdict::holds);
              RC_ASSERT(keeps_sign<Rational>(sign * beyond, bound, lost, now) == verdict_of(now == sign));
            }
          });
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 300}, [] {
    const PointsCase c;
    const Rational off = c.errors.off * *rc::gen::element(Rational(1), Rational(1, 2), Rational(9, 10));
    decide_by_all(
        []<class S>(const Vec<S, 3>& a, const Vec<S, 3>& b, const Vec<S, 3>& c, const Vec<S, 3>& d, const Vec<S, 3>& a_now,
                    const Vec<S, 3>& b_now, const Vec<S, 3>& c_now, const Vec<S, 3>& d_now, const S& off,
                    const Vec<S, 3>& extent) {
          const FourPoints<S> at{a, b, c, d}, now{a_now, b_now, c_now, d_now};
          const CoordinateErrors<S> errors{off, extent};
          return are_coordinate_errors<S>(at, now, errors) & changes_by_slopes<S>(at, determinant_of<S>(now), errors);
        },
        c.at[0], c.at[1], c.at[2], c.at[3], c.moved[0], c.moved[1], c.moved[2], c.moved[3], off, c.errors.extent);
  });
  t.holds("mutated witnesses are rejected, each part by itself and two at once", {.number_type = "rational", .cases = 400}, [] {
    const PointsCase c;
    const auto good = determinant_change(c.at, c.moved, c.errors);
    const auto rejected = [&](Rational first, Rational second, Rational third) {
      const DeterminantChange<Rational> w{Verdict::holds, good.first + first, good.second + second, good.third + third};
      return is_determinant_change(c.at, c.moved, c.errors, w) == Verdict::fails;
    };
    const Rational wrong = *gen::excess() * *rc::gen::element(Rational(1), Rational(-1));
    RC_ASSERT(!rejected(0, 0, 0) && rejected(wrong, 0, 0) && rejected(0, wrong, 0) && rejected(0, 0, wrong));
    RC_ASSERT(rejected(wrong, -wrong, 0) && rejected(0, wrong, -wrong) && rejected(wrong, 0, -wrong));
  });
  t.holds("each part of a witness is compared with its own bound", {.number_type = "rational", .cases = 300}, [] {
    // At the corners of a box all parts are as large as they can be, in one direction or the other.
    const auto length = [] { return *gen::positive_rational(); };
    const Errors errors{length(), {length(), length(), length()}};
    const bool is_mirrored = *rc::gen::arbitrary<bool>();
    Points at = box_corners(errors.extent, Rational(0)), moved = box_corners(errors.extent, errors.off);
    if (is_mirrored) at = opposite(at), moved = opposite(moved);
    const auto found = determinant_change(at, moved, errors);
    const Rational sign(is_mirrored ? -1 : 1);
    RC_ASSERT(found.verdict == Verdict::holds);
    RC_ASSERT(found.first == sign * errors.first_order_by_extents());
    RC_ASSERT(found.second == sign * errors.second_order() && found.third == sign * errors.third_order());
    Errors smaller = errors;
    smaller.extent[static_cast<int>(gen::any_place(3))] *= Rational(1) / (Rational(1) + *gen::excess());
    RC_ASSERT(is_determinant_change(at, moved, smaller, found) == Verdict::fails);
    // If one coordinate is off, only the first part is left.
    Points one_off = at;
    one_off[0][static_cast<int>(gen::any_place(3))] += length();
    const auto first = determinant_change(at, one_off, errors);
    const Rational least = absolute<Rational>(first.first) / sum_of_steps(at);
    RC_ASSERT(first.first != 0 && first.second == 0 && first.third == 0);
    RC_ASSERT(is_determinant_change(at, one_off, Errors{least, errors.extent}, first) == Verdict::holds);
    const Errors too_small{least / (Rational(1) + *gen::excess()), errors.extent};
    RC_ASSERT(is_determinant_change(at, one_off, too_small, first) == Verdict::fails);
    // If all points are one, only the third part is left.
    const RationalVec<3> none(0, 0, 0);
    const Points one = box_corners(none, Rational(0)), apart = box_corners(none, errors.off);
    const auto third = determinant_change(one, apart, Errors{errors.off, none});
    RC_ASSERT(third.verdict == Verdict::holds && third.first == 0 && third.second == 0 && third.third == errors.third_order());
    const Errors less{errors.off / (Rational(1) + *gen::excess()), none};
    RC_ASSERT(is_determinant_change(one, apart, less, third) == Verdict::fails);
  });
}

// Draws corners of a box, where the bounds are reached, and takes one coordinate farther than is allowed.
Weakening one_coordinate_is_wrong() {
  const auto length = [] { return *gen::positive_rational(); };
  const Errors errors{length(), {length(), length(), length()}};
  Points at = box_corners(errors.extent, Rational(0)), moved = box_corners(errors.extent, errors.off);
  const std::size_t part = gen::any_place(22);
  const int i = static_cast<int>(part % 3), k = static_cast<int>(part / 3 % 4);
  const Rational excess = *gen::excess();
  const auto farther = [&](Rational& x) { x += x < 0 ? -excess : excess; };
  const auto judged = [&](const std::string& which, const Errors& allowed) {
    if (*rc::gen::arbitrary<bool>()) at = opposite(at), moved = opposite(moved);
    return Weakening(
        which, are_coordinate_errors(at, moved, allowed),
        changes_by_extents(six_products(at), six_products(moved), allowed) & changes_by_slopes(at, six_products(moved), allowed));
  };
  const std::string which = std::string("coordinate ") + "xyz"[i] + " of " + "abcd"[k];
  RC_ASSERT(are_coordinate_errors(at, moved, errors) == Verdict::holds);
  if (part == 21) return judged("the error is negative", {-errors.off, errors.extent});
  if (part < 12) {
    farther(moved[k][i]);
    return judged(which + " is off by more", errors);
  }
  // Parts 12 to 20 are the coordinates of p, q and r.
  const int of = 1 + static_cast<int>(part - 12) / 3;
  farther(at[of][i]), farther(moved[of][i]);
  return judged(std::string("coordinate ") + "xyz"[i] + " of " + "pqr"[of - 1] + " is larger", errors);
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(t, "each coordinate is looked at by itself", {.parts = 22, .share = 0.9}, one_coordinate_is_wrong, 1500);
}

void pinned_cases(Suite& t) {
  using namespace b10;
  t.example("the slopes alone are not enough where all points are one, and the bound is reached",
            {.form = "beyond", .hypothesis = "products of errors are allowed for"}, [] {
              return are_coordinate_errors(one_point, cube_corners, of_one_point) == Verdict::holds &&
                     of_one_point.first_order(one_point) == 0 && six_products(cube_corners) == of_cube &&
                     changes_by_slopes_alone(one_point, of_cube, of_one_point) == Verdict::fails &&
                     changes_by_slopes(one_point, of_cube, of_one_point) == Verdict::holds &&
                     of_one_point.by_slopes(one_point) == of_cube &&
                     reaches_slopes(one_point, Points(opposite(cube_corners)), of_one_point) == Verdict::holds;
            });
  t.example("nor are they of a tetrahedron of some volume",
            {.form = "beyond", .hypothesis = "products of errors are allowed for"}, [] {
              return are_coordinate_errors(corners, grown, of_corners) == Verdict::holds && six_products(corners) == before &&
                     six_products(grown) == after && sum_of_steps(corners) == slopes &&
                     changes_by_slopes_alone(corners, after, of_corners) == Verdict::fails &&
                     changes_by_slopes_alone(corners, before + half * slopes, of_corners) == Verdict::holds &&
                     changes_by_slopes(corners, after, of_corners) == Verdict::holds &&
                     changes_by_slopes(corners, after + off, of_corners) == Verdict::fails;
            });
  t.example("points that are off by more than said may come to either side",
            {.form = "beyond", .hypothesis = "no coordinate is off by more than h"}, [] {
              bool ok = true;
              for (const auto* moved : {&above, &below})
                ok = ok && are_coordinate_errors(flat, *moved, of_flat) == Verdict::holds &&
                     changes_by_slopes(flat, six_products(*moved), of_flat) == Verdict::holds &&
                     are_coordinate_errors(flat, *moved, not_off) == Verdict::fails &&
                     changes_by_slopes(flat, six_products(*moved), not_off) == Verdict::fails;
              return ok && six_products(above) > 0 && six_products(below) < 0;
            });
  t.example("points that are farther apart than said lose more",
            {.form = "beyond", .hypothesis = "x, y and z are no less than the extents"}, [] {
              return are_coordinate_errors(corners, grown, too_short) == Verdict::fails &&
                     changes_by_extents(before, after, too_short) == Verdict::fails &&
                     changes_by_slopes(corners, after, too_short) == Verdict::fails;
            });
}

PROPTEST(b10_determinant_error) {
  formulas_are_those_of_the_statement(t);
  determinants_change_within_the_bounds(t);
  bounds_are_reached(t);
  signs_are_kept(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  reaches_share(t, "cases of points that are in no plane, and are off", 0.2, [] { return !PointsCase().is_degenerate(); });
  pinned_cases(t);
}

}  // namespace
}  // namespace proptests::suite_b10_determinant_error
