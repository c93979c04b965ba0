// SPDX-License-Identifier: MIT
#include "pliant/resolve/equations/bar_elimination.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace pliant {
namespace {

/// How many bars are left at a joint, and the exclusive or of their numbers: with one left, its
/// own.
struct BarsLeft {
  std::uint32_t count = 0, mixed = 0;
};

/// Takes the bars of trees off, outermost first; returns which bars are left.
std::vector<bool> peel_trees(std::span<const EquationEnds> ends, std::size_t joint_count,
                             std::vector<std::uint32_t>& order) {
  std::vector<BarsLeft> at(joint_count);
  for (std::uint32_t k = 0; k < ends.size(); ++k)
    for (const std::uint32_t joint : {ends[k].a, ends[k].b})
      ++at[joint].count, at[joint].mixed ^= k;
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t joint = 0; joint < joint_count; ++joint)
    if (at[joint].count == 1) leaves.push_back(joint);
  std::vector<bool> left(ends.size(), true);
  for (std::size_t next = 0; next < leaves.size(); ++next) {
    if (at[leaves[next]].count != 1) continue;
    const std::uint32_t k = at[leaves[next]].mixed;
    order.push_back(k);
    left[k] = false;
    for (const std::uint32_t joint : {ends[k].a, ends[k].b}) {
      at[joint].mixed ^= k;
      if (--at[joint].count == 1) leaves.push_back(joint);
    }
  }
  return left;
}

/// Bars of `core` that share a joint, as the entries of a symmetric matrix.
Eigen::SparseMatrix<double> line_graph(std::span<const EquationEnds> ends, std::size_t joint_count,
                                       const std::vector<std::uint32_t>& core) {
  std::vector<std::vector<int>> at(joint_count);
  for (std::size_t place = 0; place < core.size(); ++place) {
    at[ends[core[place]].a].push_back(int(place));
    at[ends[core[place]].b].push_back(int(place));
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (const std::vector<int>& bars : at)
    for (const int row : bars)
      for (const int column : bars) entries.emplace_back(row, column, 1.0);
  const auto size = Eigen::Index(core.size());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

std::vector<std::uint32_t> elimination_order(std::span<const EquationEnds> ends,
                                             std::size_t joint_count) {
  std::vector<std::uint32_t> order, core;
  order.reserve(ends.size());
  const std::vector<bool> left = peel_trees(ends, joint_count, order);
  for (std::uint32_t k = 0; k < ends.size(); ++k)
    if (left[k]) core.push_back(k);
  if (core.empty()) return order;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> sequence;
  Eigen::AMDOrdering<int>()(line_graph(ends, joint_count, core), sequence);
  for (Eigen::Index k = 0; k < sequence.size(); ++k)
    order.push_back(core[std::size_t(sequence.indices()[k])]);
  return order;
}

}  // namespace pliant
