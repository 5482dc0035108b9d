// SPDX-License-Identifier: GPL-3.0-or-later
#include "lemmas/b8_blend_error.hpp"

#include "proptests/counterexamples/b8_blend_error.hpp"
#include "proptests/gen/quaternion.hpp"
#include "proptests/gen/rigid.hpp"
#include "proptests/gen/vector.hpp"
#include "proptests/gen/weakening.hpp"
#include "proptests/gen/weights.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/oracles/number_types.hpp"
#include "proptests/oracles/skinning.hpp"
#include "proptests/oracles/upper_root.hpp"

namespace proptests::suite_b8_blend_error {
namespace {

using namespace refitlab;
using gen::RationalQuaternion;
using gen::RationalVec;
using Blend = BlendedDuals<Rational>;
using Error = BlendError<Rational>;

const RationalQuaternion zero = RationalQuaternion::Zero();

// Draws two blends, which may be near each other or equal, and the least errors that are rational. The errors are exact for
// rotations that are multiples of unit quaternions, and for those whose difference is such a multiple.
struct ErrorCase {
  Blend blend, other;
  RationalVec<3> x = *gen::rational_vector<3>();
  Error error;

  ErrorCase() {
    const Rational size = *rc::gen::element(Rational(0), Rational(1, 1000000), Rational(1, 8), Rational(1), Rational(100));
    blend = {*gen::nonzero_quaternion(), *gen::rational_vector<4>()};
    other = {RationalQuaternion(blend.rotation + *gen::nonzero_quaternion() * size),
             RationalQuaternion(blend.dual + *gen::rational_vector<4>() * size)};
    RC_PRE(squared_norm(other.rotation) > 0);
    error = least_error();
  }
  Error least_error() const {
    const Rational shortest = std::min(squared_norm(blend.rotation), squared_norm(other.rotation));
    return {upper_root(squared_distance(other.rotation, blend.rotation)), upper_root(squared_distance(other.dual, blend.dual)),
            upper_root(squared_norm(blend.dual)), upper_root(Rational(1) / shortest)};
  }
  bool is_degenerate() const { return other.rotation == blend.rotation || squared_norm(x) == 0 || blend.dual == zero; }
};

// Draws the rotation nearest to the given one of those that turn by another angle about an axis across x, so that the bound is
// sharp. All of cosine, sine, e and kappa are rational.
struct SharpCase {
  RationalQuaternion q, other;
  RationalVec<3> x;
  Error error;

  SharpCase() {
    const RationalQuaternion frame = *gen::unit_quaternion();
    const Rational length = *gen::positive_rational(), half_tangent = *gen::positive_rational();
    if (half_tangent == 1) RC_DISCARD("a right angle");
    const Rational square = sq(half_tangent), cosine = (Rational(1) - square) / (Rational(1) + square),
                   sine = Rational(2) * half_tangent / (Rational(1) + square);
    q = frame * length;
    // It multiplies from the right, so that the axis is given in the frame before.
    other = multiply(q, RationalQuaternion(cosine, sine, 0, 0)) * cosine;
    x = RationalVec<3>(0, *gen::rational(), *gen::rational());
    error = {length * sine, 0, 0, Rational(1) / length};
  }
};

// Draws a spherical blend of up to four joints with two lists of convex weights, which may be near each other or equal, and the least
// errors that are rational.
struct SphericalCase {
  PointOfJoints<Rational> of;
  std::vector<Rational> w, other;
  ChangeOfWeights<Rational> error{};

  SphericalCase() {
    const int count = 1 + gen::any_place(4);
    for (int k = 0; k < count; ++k) of.transforms.push_back(*gen::rigid_transform());
    of.center = *gen::rational_vector<3>(), of.point = *gen::rational_vector<3>(), of.from = *gen::rational_vector<3>();
    w = *gen::convex_weights(count);
    other = *gen::convex_weights(count);
    const Rational share = *rc::gen::element(Rational(0), Rational(1, 1000000), Rational(1, 8), Rational(1));
    for (std::size_t k = 0; k < w.size(); ++k) other[k] = w[k] + share * (other[k] - w[k]);
    of.middle = RationalVec<3>::Zero();
    for (const auto& c : of.transforms) of.middle += rotate<Rational>(c.rotation, of.point - of.center) / count;
    const Rational shortest = std::min(squared_length(w), squared_length(other));
    RC_PRE(shortest > 0);
    Rational image(0), turned(0);
    for (std::size_t k = 0; k < w.size(); ++k) {
      const auto& c = of.transforms[k];
      error.weights += abs(Rational(other[k] - w[k]));
      image = std::max(image, squared_distance<Rational, 3>(apply(c, of.point), of.from));
      turned = std::max(turned, squared_distance<Rational, 3>(rotate<Rational>(c.rotation, of.point - of.center), of.middle));
    }
    error.image = upper_root(image), error.turned = upper_root(turned), error.inverse_length = upper_root(Rational(1) / shortest);
  }
  Rational squared_length(const std::vector<Rational>& weights) const {
    return squared_norm(blended_rotation<Rational>(of.transforms, weights));
  }
  Verdict hypotheses() const { return spherical_move_hypotheses<Rational>(of, w, other, error); }
  ImagesOfBlends<Rational> images() const { return spherical_move_is_little<Rational>(of, w, other, error); }
  bool is_degenerate() const { return w.size() == 1 || error.weights == 0 || error.turned == 0; }
};

RationalVec<3> translation_of(const Blend& blend) {
  const auto product =
      oracle::hamilton<Rational>(blend.dual, {blend.rotation[0], -blend.rotation[1], -blend.rotation[2], -blend.rotation[3]});
  return RationalVec<3>(product[1], product[2], product[3]) * (Rational(2) / squared_norm(blend.rotation));
}

void images_are_near_each_other(Suite& t) {
  t.holds("a rotation whose quaternion is off turns every point by no more than 2 kappa e of its length",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.1, .degenerate_at_most = 0.7}, [] {
            ErrorCase c;
            // This is the inverse length of one of the two blends.
            c.error.inverse_length = upper_root(Rational(1) / squared_norm(c.blend.rotation));
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_ASSERT(turn_hypotheses(c.blend.rotation, c.other.rotation, c.error) == Verdict::holds);
            const auto found = turn_is_little(c.blend.rotation, c.other.rotation, c.x, c.error);
            RC_ASSERT(found.verdict == Verdict::holds);
            const RationalVec<3> none(0, 0, 0);
            RC_ASSERT(found.image == oracle::times(oracle::affine_of(c.blend.rotation, none), c.x));
            RC_ASSERT(found.other == oracle::times(oracle::affine_of(c.other.rotation, none), c.x));
          });
  t.holds("the translations of dual quaternions that are off differ by no more than 2 kappa (f + kappa e l)",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.1, .degenerate_at_most = 0.7}, [] {
            const ErrorCase c;
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_ASSERT(move_hypotheses(c.blend, c.other, c.error) == Verdict::holds);
            const auto found = move_is_little(c.blend, c.other, c.error);
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(found.image == translation_of(c.blend) && found.other == translation_of(c.other));
          });
  t.holds("about an axis across the point the nearest rotation of another angle is just as far off",
          {.form = "beyond", .number_type = "rational", .cases = 300}, [] {
            const SharpCase c;
            RC_ASSERT(turn_hypotheses(c.q, c.other, c.error) == Verdict::holds);
            const auto found = turn_is_little(c.q, c.other, c.x, c.error);
            RC_ASSERT(found.verdict == Verdict::holds);
            const Rational allowed = sq(turn_of_error(c.error.rotation, c.error.inverse_length)) * squared_norm(c.x);
            RC_ASSERT((squared_distance<Rational, 3>(found.image, found.other) == allowed));
          });
  t.example(
      "so is a pinned one, by 6/5; and duals that are off by 1/4 of a blend of length 1/2 move by 1", {.form = "beyond"}, [] {
        const auto turned = turn_is_little(b8::still, b8::nearest, b8::across, b8::of_nearest);
        const auto moved = move_is_little(b8::at_rest, b8::moved, b8::of_moved);
        return turned.verdict == Verdict::holds && moved.verdict == Verdict::holds && move_of_error(b8::of_moved) == b8::Q(1) &&
               squared_distance<b8::Q, 3>(turned.image, turned.other) == b8::Q(36, 25) &&
               squared_distance<b8::Q, 3>(moved.image, moved.other) == b8::Q(1);
      });
}

// Returns the spherical image by Equation (1), with the rotation's matrix.
RationalVec<3> spherical_image(const SphericalCase& c, const std::vector<Rational>& weights) {
  RationalQuaternion q = zero;
  RationalVec<3> image = RationalVec<3>::Zero();
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const auto& joint = c.of.transforms[k];
    q += joint.rotation * weights[k];
    image += oracle::times(oracle::affine_of(joint.rotation, joint.translation), c.of.center) * weights[k];
  }
  return oracle::times(oracle::affine_of(q, image), RationalVec<3>(c.of.point - c.of.center));
}

void spherical_images_are_near_each_other(Suite& t) {
  t.holds("a spherical blend whose weights are off by e moves by no more than e (a + s (1 + kappa + kappa^2))",
          {.form = "beyond", .number_type = "rational", .cases = 600, .degenerate_at_least = 0.1, .degenerate_at_most = 0.8}, [] {
            const SphericalCase c;
            RC_CLASSIFY(c.is_degenerate(), "degenerate");
            RC_ASSERT(c.hypotheses() == Verdict::holds);
            const auto found = c.images();
            RC_ASSERT(found.verdict == Verdict::holds);
            RC_ASSERT(found.image == spherical_image(c, c.w) && found.other == spherical_image(c, c.other));
            const Rational kappa = c.error.inverse_length;
            const Rational bound = c.error.weights * (c.error.image + c.error.turned * (1 + kappa + kappa * kappa));
            RC_ASSERT(spherical_move_of_error(c.error) == bound);
          });
  t.holds("each part of a spherical witness is checked by itself", {.number_type = "rational", .cases = 300}, [] {
    SphericalCase c;
    c.error.weights += 1000000;
    RC_PRE(c.error.image > 0);
    const auto found = c.images();
    RC_ASSERT(found.verdict == Verdict::holds);
    const Rational amount = *gen::excess();
    for (int i = 0; i < 3; ++i)
      for (const bool is_other : {false, true}) {
        auto wrong = found;
        (is_other ? wrong.other : wrong.image)[i] += amount;
        RC_ASSERT(are_spherical_images<Rational>(c.of, c.w, c.other, c.error, wrong) == Verdict::fails);
      }
  });
  needs_each_part(
      t, "the bound of spherical blends needs each part of its hypotheses", {.parts = 8, .share = 0},
      [] {
        SphericalCase c;
        while (c.is_degenerate() || c.error.image == 0) c = SphericalCase();
        const Rational rest = Rational(1) / (Rational(2) + *gen::excess());
        std::string part;
        switch (gen::any_place(8)) {
          case 0: part = "weights are not convex", c.w[0] += 1, c.error.weights += 1; break;
          case 1: part = "the other weights are not convex", c.other[0] += 1, c.error.weights += 1; break;
          case 2: part = "weights change by more than e", c.error.weights *= rest; break;
          case 3: part = "an image is farther than a", c.error.image *= rest; break;
          case 4: part = "a turned vector is farther than s", c.error.turned *= rest; break;
          case 5: part = "a is negative", c.error.image = -c.error.image; break;
          case 6: part = "kappa is less than that of a blend", c.error.inverse_length *= rest; break;
          default: part = "a rotation is not of unit length", c.of.transforms[0].rotation *= Rational(1) + rest; break;
        }
        return Weakening{part, c.hypotheses(), std::nullopt};
      },
      600);
}

void verdicts_and_witnesses_are_checked(Suite& t) {
  t.holds("no number type contradicts the exact verdict", {.number_type = "interval", .cases = 200}, [] {
    const ErrorCase c;
    const Rational share = *rc::gen::element(Rational(1), Rational(99, 100), Rational(1, 2));
    decide_by_all(
        []<class S>(const Quaternion<S>& q, const Quaternion<S>& d, const Quaternion<S>& other, const Quaternion<S>& other_dual,
                    const Vec<S, 3>& x, const S& e, const S& f, const S& l, const S& kappa) {
          const BlendError<S> error{e, f, l, kappa};
          return turn_is_little<S>(q, other, x, error).verdict & move_is_little<S>({q, d}, {other, other_dual}, error).verdict;
        },
        c.blend.rotation, c.blend.dual, c.other.rotation, c.other.dual, c.x, Rational(c.error.rotation * share),
        Rational(c.error.dual * share), c.error.dual_length, c.error.inverse_length);
  });
  t.holds("each part of a witness is checked by itself", {.number_type = "rational", .cases = 300}, [] {
    const ErrorCase c;
    RC_PRE(squared_norm(c.x) > 0);
    const Error plenty{Rational(1000000), Rational(1000000), Rational(1000000), Rational(1000000)};  // Only the images show it.
    const auto turned = turn_is_little(c.blend.rotation, c.other.rotation, c.x, plenty);
    const auto moved = move_is_little(c.blend, c.other, plenty);
    RC_ASSERT(turned.verdict == Verdict::holds && moved.verdict == Verdict::holds);
    const Rational amount = *gen::excess();
    for (int i = 0; i < 3; ++i)
      for (const bool is_other : {false, true}) {
        auto image = turned, translation = moved;
        (is_other ? image.other : image.image)[i] += amount, (is_other ? translation.other : translation.image)[i] += amount;
        RC_ASSERT(are_turned_images(c.blend.rotation, c.other.rotation, c.x, plenty, image) == Verdict::fails);
        RC_ASSERT(are_translations(c.blend, c.other, plenty, translation) == Verdict::fails);
      }
  });
  t.holds("only the distance tells that an error is greater than said", {.number_type = "rational", .cases = 300}, [] {
    const ErrorCase c;
    const Rational share = *gen::unit_interval_rational();
    const Error less{c.error.rotation * share, c.error.dual * share, c.error.dual_length, c.error.inverse_length};
    const auto turned = turn_is_little(c.blend.rotation, c.other.rotation, c.x, less);
    const Rational far = squared_distance<Rational, 3>(turned.image, turned.other);
    const bool is_turned = far <= sq(2 * less.inverse_length * less.rotation) * squared_norm(c.x);
    RC_ASSERT(turned.verdict == verdict_of(is_turned));
    const auto moved = move_is_little(c.blend, c.other, less);
    const Rational step = 2 * less.inverse_length * less.dual + 2 * sq(less.inverse_length) * less.rotation * less.dual_length;
    const bool is_moved = squared_distance<Rational, 3>(moved.image, moved.other) <= sq(step);
    RC_ASSERT(moved.verdict == verdict_of(is_moved));
    RC_CLASSIFY(!is_turned, "turned by more");
    RC_CLASSIFY(!is_moved, "moved by more");
  });
}

void hypotheses_need_each_part(Suite& t) {
  needs_each_part(t, "the bound of rotations needs each part of its hypotheses", {.parts = 5, .share = 0.5}, [] {
    SharpCase c;
    while (squared_norm(c.x) == 0) c.x[1] = *gen::rational();
    const Rational amount = *gen::excess(), rest = Rational(1) / (Rational(1) + amount);
    std::string part;
    bool is_asked = true;
    switch (gen::any_place(5)) {
      case 0: part = "e is less than the distance", c.error.rotation *= rest; break;
      case 1: part = "e is negative", c.error.rotation = -c.error.rotation, is_asked = false; break;
      case 2: part = "kappa is less than 1 / ||q||", c.error.inverse_length *= rest; break;
      case 3: part = "kappa is negative", c.error.inverse_length = -c.error.inverse_length, is_asked = false; break;
      default: part = "q' is 0", c.other = zero, c.error.rotation = Rational(1) / c.error.inverse_length, is_asked = false; break;
    }
    const Verdict hypothesis = turn_hypotheses(c.q, c.other, c.error);
    return Weakening{part, hypothesis,
                     is_asked ? std::optional(turn_is_little(c.q, c.other, c.x, c.error).verdict) : std::nullopt};
  });
  needs_each_part(
      t, "the bound of translations needs each part of its hypotheses", {.parts = 8, .share = 0.2},
      [] {
        // All turns are about one axis, where lengths are those of numbers. The dual is a translation along it.
        const Rational kappa = *gen::positive_rational(), length = Rational(1) / kappa, amount = *gen::excess(),
                       dual = *gen::positive_rational(), off = *gen::positive_rational();
        Blend blend{RationalQuaternion(length, 0, 0, 0), RationalQuaternion(0, dual, 0, 0)}, other = blend;
        Error error{0, 0, dual, kappa};
        std::string part;
        bool is_asked = true;
        switch (gen::any_place(8)) {
          case 0: part = "rotations are farther apart than e", other.rotation[0] += amount; break;
          case 1: part = "duals are farther apart than f", other.dual[1] += amount; break;
          case 2: part = "e is negative", error.rotation = -off, is_asked = false; break;
          case 3: part = "f is negative", error.dual = -off, is_asked = false; break;
          case 4:
            part = "q is shorter than 1 / kappa";
            blend.rotation[0] = length / (Rational(2) + amount), error.rotation = length - blend.rotation[0];
            break;
          case 5:
            part = "q' is shorter than 1 / kappa";
            other.rotation[0] = length / (Rational(2) + amount), error.rotation = length - other.rotation[0];
            break;
          case 6:
            part = "the dual is longer than l";
            other.rotation[0] = length + off, error.rotation = off,
            error.dual_length = dual / (Rational(2) + off / length + amount);
            break;
          default: part = "l is negative", error.dual_length = -dual, is_asked = false; break;
        }
        const Verdict hypothesis = move_hypotheses(blend, other, error);
        return Weakening{part, hypothesis, is_asked ? std::optional(move_is_little(blend, other, error).verdict) : std::nullopt};
      },
      600);
}

PROPTEST(b8_blend_error) {
  images_are_near_each_other(t);
  spherical_images_are_near_each_other(t);
  verdicts_and_witnesses_are_checked(t);
  hypotheses_need_each_part(t);
  t.example("a quaternion of 0 has no translation", {}, [] {
    return is_translation<b8::Q>({b8::zero, b8::zero}, b8::Point(0, 0, 0)) == Verdict::fails;
  });
  t.example("a shorter blend turns by more", {.form = "beyond", .hypothesis = "kappa ||q|| >= 1"}, [] {
    const b8::Error of_half{b8::Q(3, 10), 0, 0, 1};
    return turn_hypotheses(b8::half, b8::half_off, of_half) == Verdict::fails &&
           turn_is_little(b8::half, b8::half_off, b8::across, of_half).verdict == Verdict::fails;
  });
  t.example("no less than the distance will do", {.form = "beyond", .hypothesis = "||q' - q|| <= e"}, [] {
    auto less = b8::of_nearest;
    less.rotation = b8::Q(59, 100);
    return turn_hypotheses(b8::still, b8::nearest, less) == Verdict::fails &&
           turn_is_little(b8::still, b8::nearest, b8::across, less).verdict == Verdict::fails;
  });
}

}  // namespace
}  // namespace proptests::suite_b8_blend_error
