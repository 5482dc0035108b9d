// SPDX-License-Identifier: GPL-3.0-or-later
#include "proptests/gen/bare_certified_node.hpp"

#include <numeric>

namespace proptests::gen {

BareCertifiedNode::BareCertifiedNode(const refitlab::RefitNode<double>& node, const std::string& about)
    : node_{about, 0, {}, {}, std::string(64, '0'), std::string(64, 'f')} {
  for (std::size_t s = 0; s < node.palette.size(); ++s) {
    joints_.emplace_back(node.palette.joint_count(s));
    std::iota(joints_.back().begin(), joints_.back().end(), 0);
    node_.joints.emplace_back(joints_.back());
  }
  weights_.reserve(2 * node.pieces.size());
  for (std::size_t i = 0; i < node.pieces.size(); ++i) {
    const auto& set = node.pieces[i];
    for (const int far : {0, 1}) {
      const auto first = node.weight_vertex(set, 0), other = node.weight_vertex(set, far ? set.weight_vertex_count - 1 : 0);
      auto& w = weights_.emplace_back();
      for (std::size_t k = 0; k < first.size(); ++k) w.push_back((first[k] + other[k]) / 2);
      node_.vertices.push_back({static_cast<int>(2 * i) + far, node.piece_reference(i).center, set.joint_set, w});
    }
  }
}

}  // namespace proptests::gen
