// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/exhaustive/subdivide.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace proptests::exhaustive {
namespace {

constexpr int most_cuts = 200;  // from the root to a leaf

using Box = std::vector<Interval>;

class Prover {
 public:
  Prover(const Theorem& theorem, double constant, const std::function<void(const Counts&)>& tell)
      : theorem_(theorem),
        constant_(constant),
        tell_(tell) {}

  Box root() const {
    Box box;
    for (const Parameter& p : theorem_.parameters) box.emplace_back(p.low, p.high);
    return box;
  }

  std::size_t cut_of(const Box& box) const;

  // Appends the tree of a box at this depth.
  void prove(const Box& box, int depth, std::string& tree) {
    const Judgement found = judge(box);
    if (found.outcome != Outcome::open) {
      counts_.measure += std::ldexp(1.0, -depth);
      ++(found.outcome == Outcome::proved ? counts_.proved : counts_.outside);
      tree += found.outcome == Outcome::proved ? '.' : 'o';
      if ((counts_.proved + counts_.outside) % 1024 == 0) tell_(counts_);
      return;
    }
    look_for_counterexample(box, depth);
    if (depth == most_cuts) fail(box, "is not decided by intervals on");
    const std::size_t axis = cut_of(box);
    tree += static_cast<char>('0' + axis);
    prove(half_of(box, axis, false), depth + 1, tree);
    prove(half_of(box, axis, true), depth + 1, tree);
  }

  static Box half_of(Box box, std::size_t axis, bool upper) {
    const double middle = middle_of(box[axis]);
    box[axis] = upper ? Interval(middle, box[axis].sup()) : Interval(box[axis].inf(), middle);
    return box;
  }

 private:
  static double middle_of(const Interval& x) { return x.inf() + (x.sup() - x.inf()) / 2; }
  static Box middle_of(Box box) {
    for (Interval& x : box) x = Interval(middle_of(x));
    return box;
  }

  // Looks in the middle of the box, and now and then in its corners.
  void look_for_counterexample(const Box& box, int depth) const {
    if (judge(middle_of(box)).refuted) fail(middle_of(box), "fails at");
    if (depth % 8) return;
    for (std::size_t corner = 0; corner < std::size_t(1) << box.size(); ++corner) {
      Box point = box;
      for (std::size_t i = 0; i < box.size(); ++i) point[i] = Interval(corner >> i & 1 ? box[i].sup() : box[i].inf());
      if (judge(point).refuted) fail(point, "fails at");
    }
  }

  // Returns a length as a share of the root's, or of the parameter itself.
  double length_in(const Box& box, std::size_t axis) const {
    const Parameter& p = theorem_.parameters[axis];
    return (box[axis].sup() - box[axis].inf()) / (p.is_scale ? box[axis].sup() : p.high - p.low);
  }

  Judgement judge(const Box& box) const {
    Judgement found = theorem_.judge(box, Interval(constant_));
    if (!(found.excess <= std::numeric_limits<double>::max())) found.excess = std::numeric_limits<double>::infinity();
    return found;
  }

  [[noreturn]] void fail(const Box& box, const char* how) const {
    std::ostringstream text;
    text.precision(17);
    text << theorem_.name << ": with K = " << constant_ << ", the statement " << how << ' ';
    for (std::size_t i = 0; i < box.size(); ++i) {
      text << (i ? ", " : "") << theorem_.parameters[i].name << (box[i].is_point() ? " = " : " in ");
      if (box[i].is_point()) text << box[i].inf();
      else text << '[' << box[i].inf() << ", " << box[i].sup() << ']';
    }
    throw NotProved(text.str());
  }

  const Theorem& theorem_;
  const double constant_;
  const std::function<void(const Counts&)>& tell_;
  Counts counts_;
};

// Returns the parameter across which a cut leaves the least excess in both halves together, of those in which the box is not much
// shorter than in another. Otherwise the search might cut off proved halves for ever, and never what keeps the rest from being
// proved.
std::size_t Prover::cut_of(const Box& box) const {
  constexpr double much = 16;
  std::vector<double> lengths;
  for (std::size_t i = 0; i < box.size(); ++i) lengths.push_back(length_in(box, i));
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  std::size_t best = box.size();
  double least = 0;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (lengths[i] * much < longest) continue;
    double excess = 0;
    for (const bool upper : {false, true}) {
      const Judgement half = judge(half_of(box, i, upper));
      if (half.outcome == Outcome::open) excess += half.excess;
    }
    if (best == box.size() || excess < least || (excess == least && lengths[i] > lengths[best])) best = i, least = excess;
  }
  return best;
}

}  // namespace

std::vector<Cell> prove_cells(const Theorem& theorem, double constant, std::size_t first, std::size_t end,
                              const std::function<void(const Counts&)>& tell) {
  Prover prover(theorem, constant, tell);
  std::vector<Cell> cells;
  for (std::size_t cell = first; cell < end; ++cell) {
    Box box = prover.root();
    Cell out;
    for (int depth = 0; depth < cell_depth; ++depth) {
      const std::size_t axis = prover.cut_of(box);
      const bool upper = cell >> (cell_depth - 1 - depth) & 1;
      out.path += {static_cast<char>('0' + axis), upper ? '+' : '-'};
      box = Prover::half_of(std::move(box), axis, upper);
    }
    prover.prove(box, cell_depth, out.tree);
    cells.push_back(std::move(out));
  }
  return cells;
}

std::string joined(const std::vector<Cell>& cells) {
  std::string tree;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    // The cell before has not been through these cuts: they are below the last one of which it is on the lower side and this cell
    // on the upper.
    int shared = 0;
    if (i > 0)
      while (cells[i].path.compare(0, 2 * shared + 2, cells[i - 1].path, 0, 2 * shared + 2) == 0) ++shared;
    for (int depth = i == 0 ? 0 : shared + 1; depth < cell_depth; ++depth) tree += cells[i].path[2 * depth];
    tree += cells[i].tree;
  }
  return tree;
}

}  // namespace proptests::exhaustive
