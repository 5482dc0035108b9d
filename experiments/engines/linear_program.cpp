// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/engines/linear_program.hpp"

#include <algorithm>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

int LinearProgram::add_variable(double least, double most) {
  const int variable = glp_add_cols(program_.get(), 1) - 1;
  set_bounds(variable, least, most);
  return variable;
}

void LinearProgram::set_bounds(int variable, double least, double most) {
  glp_set_col_bnds(program_.get(), variable + 1, least < most ? GLP_DB : GLP_FX, least, most);
}

void LinearProgram::set_most(int variable, double most) {
  set_bounds(variable, glp_get_col_lb(program_.get(), variable + 1), most);
}

double LinearProgram::value(int variable) const {
  const int column = variable + 1;
  return std::clamp(glp_get_col_prim(program_.get(), column), glp_get_col_lb(program_.get(), column),
                    glp_get_col_ub(program_.get(), column));
}

void LinearProgram::add_row(const std::vector<ProgramTerm>& terms, double least) {
  std::vector<int> columns = {0};  // GLPK counts from 1
  std::vector<double> factors = {0};
  for (const ProgramTerm& t : terms) columns.push_back(t.variable + 1), factors.push_back(t.factor);
  const int row = glp_add_rows(program_.get(), 1);
  glp_set_row_bnds(program_.get(), row, GLP_LO, least, 0);
  glp_set_mat_row(program_.get(), row, static_cast<int>(terms.size()), columns.data(), factors.data());
}

bool LinearProgram::solve() {
  const DefaultFloatEnvironment environment;
  glp_smcp parameters;
  glp_init_smcp(&parameters);
  parameters.msg_lev = GLP_MSG_OFF;
  parameters.meth = GLP_DUALP;
  if (glp_simplex(program_.get(), &parameters) != 0) return false;
  return glp_get_status(program_.get()) == GLP_OPT;
}

}  // namespace refitlab
