// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/deformations/reduced_basis.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <stdexcept>

#include "algorithms/runtime/packs/float_environment.hpp"

namespace refitlab {

ReducedBasis reduced_basis(const std::vector<std::vector<Point3>>& displacements, int size) {
  const DefaultFloatEnvironment environment;
  const auto frames = static_cast<Eigen::Index>(displacements.size());
  if (size < 1 || frames < size)
    throw std::invalid_argument("reduced basis: of " + std::to_string(frames) + " frames there is none of size " +
                                std::to_string(size));
  const auto vertices = static_cast<Eigen::Index>(displacements[0].size());
  Eigen::MatrixXd matrix(3 * vertices, frames);
  for (Eigen::Index f = 0; f < frames; ++f)
    for (Eigen::Index v = 0; v < vertices; ++v)
      matrix.block<3, 1>(3 * v, f) = displacements[static_cast<std::size_t>(f)][static_cast<std::size_t>(v)];
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const double root = std::sqrt(static_cast<double>(frames));

  ReducedBasis out{{size, std::vector<std::vector<Displacement<double>>>(static_cast<std::size_t>(vertices))}, {}, 1};
  for (Eigen::Index v = 0; v < vertices; ++v)
    for (int k = 0; k < size; ++k)
      out.targets.of_vertex[static_cast<std::size_t>(v)].push_back(
          {k, svd.matrixU().block<3, 1>(3 * v, k) * (svd.singularValues()[k] / root)});
  for (Eigen::Index f = 0; f < frames; ++f) {
    auto& coordinates = out.coordinates.emplace_back();
    for (int k = 0; k < size; ++k) coordinates.push_back(svd.matrixV()(f, k) * root);
  }
  if (const double all = svd.singularValues().squaredNorm(); all > 0)
    out.share = svd.singularValues().head(size).squaredNorm() / all;
  return out;
}

}  // namespace refitlab
