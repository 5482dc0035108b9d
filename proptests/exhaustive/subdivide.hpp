// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a box of parameters in halves until a theorem is proved on each part.
//
// What is written is a tree in the order in which one draws it from the root: a digit is a cut across that parameter, in the
// middle, and the lower half and the upper half follow; '.' is a box on which the statement is proved, and 'o' one that it is not
// about. So no proof is needed that the leaves fill the box. Where a box is cut depends on nothing but the box. Down to
// cell_depth every box is cut, whatever is said of it: these boxes are the cells that shards prove apart, and the tree is the
// same however many shards there were.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>

#include "proptests/exhaustive/theorem.hpp"

namespace proptests::exhaustive {

inline constexpr int cell_depth = 6;
inline constexpr std::size_t cell_count = std::size_t(1) << cell_depth;

struct Counts {
  std::size_t proved = 0, outside = 0;
  // This is the share of the theorem's box that is done.
  double measure = 0;
};

// Holds the tree of one cell, and the path to it: a digit and '-' or '+' for each cut.
struct Cell {
  std::string path, tree;
};

// Says on which box the statement fails, or that no number of cuts decides.
class NotProved : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Proves the cells from first to before end. tell is called now and then with what is done so far. Throws NotProved.
std::vector<Cell> prove_cells(const Theorem& theorem, double constant, std::size_t first, std::size_t end,
                              const std::function<void(const Counts&)>& tell);

// Returns the tree of all cells, in order.
std::string joined(const std::vector<Cell>& cells);

}  // namespace proptests::exhaustive
