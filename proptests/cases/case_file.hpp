// SPDX-License-Identifier: GPL-3.0-or-later
// Reads case files: counterexamples and degenerate cases as exact rationals with the expected verdict (README.md here describes
// the format).
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "algorithms/verification/synthetic_case.hpp"
#include "lemmas/s41_weight_vertices_span.hpp"
#include "lemmas/s44_joint_sets.hpp"
#include "lemmas/vocabulary/cap.hpp"
#include "lemmas/vocabulary/squared_ball.hpp"

namespace proptests::cases {

using Json = nlohmann::ordered_json;
using refitlab::Rational;
template <int D>
using Point = refitlab::Vec<Rational, D>;
using Quaternion = refitlab::Quaternion<Rational>;
using Numbers = std::vector<Rational>;

// Names the file, the case and the reason.
struct CaseError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Reads a rational such as "3/5" or "-2": an optional sign, digits, and for a fraction a slash and digits. Throws CaseError with
// the reason alone.
Rational parse_rational(const Json& value);

// Reads the fields of an object, by name. Throws CaseError with the path of the field if it is missing or not as asked for. Lists
// of weights and points are not judged here: whether they are what a statement asks for is a part of its verdict.
class Fields {
 public:
  Fields(const Json& object, std::string where);

  bool has(const std::string& name) const { return object_->contains(name); }
  Fields object(const std::string& name) const;
  std::vector<Fields> objects(const std::string& name) const;  // The list is not empty.
  std::string text(const std::string& name) const;
  int integer(const std::string& name, int low, int high) const;

  Rational number(const std::string& name) const;
  Numbers numbers(const std::string& name) const;
  std::vector<Numbers> rows(const std::string& name, std::size_t width) const;
  Numbers convex_weights(const std::string& name, std::size_t count) const;  // on the simplex

  // Points are in R^D. The elements of a list of points have the same dimension.
  template <int D>
  Point<D> point(const std::string& name) const {
    return as_point<D>(numbers(name), name);
  }
  template <int D>
  std::vector<Point<D>> points(const std::string& name) const {
    std::vector<Point<D>> out;
    for (const Numbers& row : rows(name, D)) out.push_back(as_point<D>(row, name));
    return out;
  }
  Quaternion non_zero_quaternion(const std::string& name) const;  // w, x, y, z
  Quaternion unit_quaternion(const std::string& name) const;

  template <int D>
  refitlab::Ball<Rational, D> ball(const std::string& name) const {
    const Fields f = object(name);
    return {f.point<D>("center"), f.number("radius")};
  }
  template <int D>
  refitlab::SquaredBall<Rational, D> squared_ball(const std::string& name) const {
    const Fields f = object(name);
    return {f.point<D>("center"), f.number("squared_radius")};
  }
  template <int D>
  refitlab::HalfSpace<Rational, D> half_space(const std::string& name) const {
    const Fields f = object(name);
    return {f.point<D>("normal"), f.number("offset")};
  }
  template <int D>
  refitlab::Cap<Rational, D> cap(const std::string& name) const {
    const Fields f = object(name);
    return {f.point<D>("center"), f.point<D>("apex"), f.number("cos_angle")};
  }
  // There are as many low as high ones, at least one.
  refitlab::WeightBounds<Rational> bounds(const std::string& name) const;
  std::vector<refitlab::RigidTransform<Rational>> transforms(const std::string& name) const;

  [[noreturn]] void fail(const std::string& name, const std::string& reason) const;

 private:
  const Json& value(const std::string& name) const;
  template <int D>
  Point<D> as_point(const Numbers& row, const std::string& name) const {
    if (row.size() != D) fail(name, "needs " + std::to_string(D) + " coordinates, has " + std::to_string(row.size()));
    Point<D> out;
    for (int i = 0; i < D; ++i) out[i] = row[i];
    return out;
  }

  const Json* object_;
  std::string where_;
};

// Holds a refit and a vertex of one of its joint-sets.
struct RefitInput {
  refitlab::SyntheticCase query;
  int joint_set;
  Numbers weights;    // on the simplex, and admitted by the joint-set's bounds
  Point<3> position;  // in the reference ball
};
RefitInput read_refit(const Fields& inputs);

struct Case {
  std::string name, statement, form, claim;
  std::string expected;  // "holds" or "fails"; of a refit "encloses", "misses" or "undefined"
  // This names the hypothesis that is not met, if the case shows what goes wrong without it, and is empty otherwise.
  std::string without;
  std::string note;
  int dimension = 0;  // This is 0 for statements that are not of R^d.
  Json inputs;
  std::string file;

  Fields fields() const { return Fields(inputs, file + ": case '" + name + "': inputs"); }
};

// Checks that the statement is known, in this form, with this claim. Throws CaseError otherwise.
using StatementCheck = std::function<void(const Case&)>;

// Reads the cases of a file. Throws CaseError if it cannot be read, is malformed, or has two cases of one name.
std::vector<Case> read_cases(
    const std::string& file, const StatementCheck& check = [](const Case&) {});
std::vector<Case> parse_cases(const std::string& text, const std::string& file, const StatementCheck& check);

// Returns a case's statement, inputs and verdict to be read by people.
std::string as_markdown(const std::vector<Case>& cases);

}  // namespace proptests::cases
