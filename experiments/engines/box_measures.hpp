// SPDX-License-Identifier: GPL-3.0-or-later
// BoxMeasures measures how tight the boxes of some methods are in some poses, and in how many poses a vertex is outside.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/over_time/extremes.hpp"
#include "lemmas/vocabulary/verdict.hpp"

namespace refitlab {

// A BoxMeasure is that of one method in some poses. Ratios are to the true box of each pose, which is the smallest around its
// vertices.
struct BoxMeasure {
  std::string method;
  long poses = 0, misses = 0, undecided = 0;  // misses: poses in which a vertex is outside
  long unbounded = 0;                         // poses for which the method has no bound, which count for no ratio
  long flat = 0;                              // others in which the true box has no volume, which count for none either
  double volume = 0, area = 0, radius = 0;    // mean ratios; radius: of the ball around the box
  double to_reference = 0;                    // mean ratio to the reference method's volume
  double missed_by = 0;                       // how far a vertex is outside at most, as a share of the true box's longest side

  long with_ratios() const { return poses - unbounded - flat; }
};

double area_of_box(const Box<double>& box);

class BoxMeasures {
 public:
  // reference is the position of a method.
  BoxMeasures(const std::vector<std::string>& methods, std::size_t reference);

  // Adds a pose. boxes are by method, and infinite where there is no bound, which the reference must have. error bounds that of
  // the true box's places. Where such an error leaves it open, decide says whether the box at a position holds all vertices.
  void add(const Box<double>& truth, const std::vector<Box<double>>& boxes, double error,
           const std::function<Verdict(std::size_t)>& decide);

  // Returns the measures by method. Ratios are 0 where with_ratios() is.
  std::vector<BoxMeasure> measures() const;

 private:
  std::vector<BoxMeasure> sums_;
  std::size_t reference_;
};

}  // namespace refitlab
