// SPDX-License-Identifier: GPL-3.0-or-later
// Returns what a certificate says of a node without a model: each piece has two vertices at the center of its reference ball, one
// with the weights of its first weight vertex, and one half-way to its last one.
#pragma once

#include "algorithms/certificate/certificate.hpp"

namespace proptests::gen {

class BareCertifiedNode {
 public:
  BareCertifiedNode(const refitlab::RefitNode<double>& node, const std::string& about);
  operator const refitlab::CertifiedNode&() const { return node_; }

 private:
  refitlab::CertifiedNode node_;
  std::vector<std::vector<double>> weights_;
  std::vector<std::vector<int>> joints_;
};

}  // namespace proptests::gen
