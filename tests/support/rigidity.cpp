// SPDX-License-Identifier: MIT
#include "support/rigidity.hpp"

#include <Eigen/Dense>
#include <stdexcept>

#include "pliant/base/random.hpp"

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

using Line = Eigen::Matrix<double, 1, 6>;

/// Pluecker coordinates (direction, moment) of a line through a point.
Line line(Vec3 along, Vec3 point) {
  const Vec3 moment = cross(point, along);
  return (Line() << along.x, along.y, along.z, moment.x, moment.y, moment.z).finished();
}

/// A row for each bar, six columns (velocity at the origin, angular velocity) a body.
Eigen::MatrixXd body_bar_matrix(std::size_t bodies, std::span<const BodyEdge> edges,
                                std::uint64_t seed) {
  Eigen::Index rows = 0, row = 0;
  for (const BodyEdge& edge : edges) rows += edge.bars;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows, 6 * Eigen::Index(bodies));
  RandomSequence random({seed, Domain::generate, 0, 0, 0});
  for (const BodyEdge& edge : edges)
    for (int k = 0; k < edge.bars; ++k, ++row) {
      const Line bar = line(random.direction(), random.direction());
      matrix.block<1, 6>(row, 6 * Eigen::Index(edge.a)) = bar;
      matrix.block<1, 6>(row, 6 * Eigen::Index(edge.b)) = -bar;
    }
  return matrix;
}

/// Five rows at right angles to the turn about a line.
Eigen::Matrix<double, 6, 6> rows_but_turn(Vec3 a, Vec3 b) {
  const Vec3 axis = (1.0 / norm(b - a)) * (b - a);
  const Vec3 moment = cross(a, axis);
  Eigen::Matrix<double, 6, 1> turn;
  turn << moment.x, moment.y, moment.z, axis.x, axis.y, axis.z;
  turn.normalize();
  return Eigen::Matrix<double, 6, 6>::Identity() - turn * turn.transpose();
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

BodyBarFacts body_bar_facts(std::size_t bodies, std::span<const BodyEdge> edges,
                            std::uint64_t seed) {
  const Eigen::MatrixXd matrix = body_bar_matrix(bodies, edges, seed);
  BodyBarFacts facts;
  Eigen::MatrixXd still = Eigen::MatrixXd::Identity(matrix.cols(), matrix.cols());
  if (matrix.rows() > 0) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullV);
    facts.rank = static_cast<std::size_t>((svd.singularValues().array() > 1e-9).count());
    still = svd.matrixV().rightCols(matrix.cols() - Eigen::Index(facts.rank));
  }
  for (std::size_t b = 0; b < bodies; ++b) {
    const auto twist = [&](std::size_t body) {
      return still.block(6 * Eigen::Index(body), 0, 6, still.cols());
    };
    std::size_t lowest = 0;
    while ((twist(b) - twist(lowest)).cwiseAbs().maxCoeff() > 1e-8) ++lowest;
    facts.cluster_of.push_back(static_cast<std::uint32_t>(lowest));
  }
  return facts;
}

std::size_t hinge_rank(std::span<const Vec3> positions, std::span<const BodyEdge> edges) {
  Eigen::MatrixXd matrix =
      Eigen::MatrixXd::Zero(6 * Eigen::Index(edges.size()), 6 * Eigen::Index(positions.size()));
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto [a, b, bars] = edges[k];
    if (bars != 5 && bars != 6) throw std::invalid_argument("expected 5 or 6 bars");
    Eigen::Matrix<double, 6, 6> rows = Eigen::Matrix<double, 6, 6>::Identity();
    if (bars == 5) rows = rows_but_turn(positions[a], positions[b]);
    matrix.block<6, 6>(6 * Eigen::Index(k), 6 * Eigen::Index(a)) = rows;
    matrix.block<6, 6>(6 * Eigen::Index(k), 6 * Eigen::Index(b)) = -rows;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
  qr.setThreshold(1e-9);
  return static_cast<std::size_t>(qr.rank());
}

}  // namespace pliant::test
