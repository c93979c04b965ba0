// SPDX-License-Identifier: MIT
#include "support/rigidity.hpp"

#include <Eigen/Dense>

namespace pliant::test {
namespace {

std::size_t rank_of(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) return 0;
  const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd>(matrix).singularValues();
  return static_cast<std::size_t>((singular.array() > 1e-9).count());
}

Eigen::MatrixXd rigidity_matrix(const Framework& framework, std::span<const Vec3> positions) {
  const auto bars = framework.bars();
  Eigen::MatrixXd matrix =
      Eigen::MatrixXd::Zero(Eigen::Index(bars.size()), Eigen::Index(3 * positions.size()));
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const Vec3 along = positions[bars[k].b] - positions[bars[k].a];
    const Eigen::RowVector3d unit = Eigen::RowVector3d(along.x, along.y, along.z) / norm(along);
    matrix.block<1, 3>(Eigen::Index(k), 3 * Eigen::Index(bars[k].a)) = -unit;
    matrix.block<1, 3>(Eigen::Index(k), 3 * Eigen::Index(bars[k].b)) = unit;
  }
  return matrix;
}

}  // namespace

std::size_t rigidity_rank(const Framework& framework, std::span<const Vec3> positions) {
  return rank_of(rigidity_matrix(framework, positions));
}

double least_singular_value(const Framework& framework, std::span<const Vec3> positions) {
  const Eigen::MatrixXd matrix = rigidity_matrix(framework, positions);
  if (matrix.rows() == 0) return 1.0;
  if (matrix.rows() > matrix.cols()) return 0.0;
  return Eigen::JacobiSVD<Eigen::MatrixXd>(matrix).singularValues().minCoeff();
}

std::size_t rigid_motions(std::span<const Vec3> positions) {
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(6, Eigen::Index(3 * positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3 x = positions[i];
    const auto at = 3 * Eigen::Index(i);
    motions.block<3, 3>(0, at).setIdentity();
    motions.block<3, 3>(3, at) << 0, -x.z, x.y, x.z, 0, -x.x, -x.y, x.x, 0;
  }
  return rank_of(motions);
}

}  // namespace pliant::test
