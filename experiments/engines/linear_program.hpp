// SPDX-License-Identifier: GPL-3.0-or-later
// LinearProgram: a linear program that grows by rows, solved by GLPK's simplex method, which goes on from its last basis.
#pragma once

#include <glpk.h>

#include <memory>
#include <vector>

namespace refitlab {

// A ProgramTerm is a variable of a row and its coefficient.
struct ProgramTerm {
  int variable;
  double factor;
};

class LinearProgram {
 public:
  LinearProgram() : program_(glp_create_prob(), glp_delete_prob) { glp_set_obj_dir(program_.get(), GLP_MIN); }

  // Returns the position of a new variable, which is at least `least` and at most `most`, both finite.
  int add_variable(double least, double most);
  // Lets a variable be at most this from now on, which is no less than the least that it may be.
  void set_most(int variable, double most);
  // Sets what a variable counts in the sum that is to be least, which is 0 at first.
  void set_cost(int variable, double cost) { glp_set_obj_coef(program_.get(), variable + 1, cost); }
  // Requires that the sum of the terms is at least this. A variable is in a row at most once.
  void add_row(const std::vector<ProgramTerm>& terms, double least);

  // Returns false if no least sum is found.
  bool solve();
  // Returns the variable's value in the last solution, within its bounds.
  double value(int variable) const;

 private:
  void set_bounds(int variable, double least, double most);

  std::unique_ptr<glp_prob, decltype(&glp_delete_prob)> program_;
};

}  // namespace refitlab
