// SPDX-License-Identifier: MIT
#include "pliant/sample/network/b_factors.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "pliant/base/math/dense_cholesky.hpp"
#include "pliant/sample/network/coarse_nodes.hpp"

namespace pliant {
namespace {

constexpr std::size_t most_nodes = 3000;

/// Weaker springs than this join nothing: parts that nothing holds to the rest could move
/// without bounds.
constexpr double least_spring = 1e-6;

DenseMatrix springs_of(const NetworkNodes& nodes) {
  const Springs springs = find_network("shared").springs(nodes);
  DenseMatrix k = springs.contacts;
  for (std::size_t i = 0; i < k.rows(); ++i)
    for (std::size_t j = 0; j < k.rows(); ++j) {
      k(i, j) += springs.chain(i, j);
      if (k(i, j) < least_spring) k(i, j) = 0.0;
    }
  return k;
}

/// The nodes of each part; springs join a part.
std::vector<std::vector<std::size_t>> parts_of(const DenseMatrix& springs) {
  std::vector<bool> is_seen(springs.rows(), false);
  std::vector<std::vector<std::size_t>> parts;
  for (std::size_t root = 0; root < springs.rows(); ++root) {
    if (is_seen[root]) continue;
    std::vector<std::size_t> part{root};
    is_seen[root] = true;
    for (std::size_t next = 0; next < part.size(); ++next)
      for (std::size_t j = 0; j < springs.rows(); ++j)
        if (springs(part[next], j) > 0.0 && !is_seen[j]) {
          is_seen[j] = true;
          part.push_back(j);
        }
    std::sort(part.begin(), part.end());
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Kirchhoff's matrix of a part, with its one direction of no energy, all nodes alike, given the
/// stiffness 1: the inverse is then the pseudoinverse, with 1 / n added to each entry.
DenseMatrix grounded(const DenseMatrix& springs, const std::vector<std::size_t>& part) {
  const std::size_t n = part.size();
  DenseMatrix k(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      k(i, j) += 1.0 / double(n);
      if (i == j) continue;
      k(i, j) -= springs(part[i], part[j]);
      k(i, i) += springs(part[i], part[j]);
    }
  return k;
}

std::vector<double> variances(const NetworkNodes& nodes) {
  const DenseMatrix springs = springs_of(nodes);
  std::vector<double> values(nodes.positions.size());
  for (const auto& part : parts_of(springs)) {
    const auto found = DenseCholesky(grounded(springs, part)).inverse_diagonal();
    const double added = 1.0 / double(part.size());
    for (std::size_t k = 0; k < part.size(); ++k) values[part[k]] = std::max(found[k] - added, 0.0);
  }
  return values;
}

/// The same nodes, each its own joint, so that merging tells where it went.
NetworkNodes numbered(const NetworkNodes& nodes) {
  NetworkNodes out = nodes;
  out.of_joint.resize(nodes.positions.size());
  std::iota(out.of_joint.begin(), out.of_joint.end(), std::uint32_t{0});
  return out;
}

}  // namespace

std::vector<double> relative_b_factors(const NetworkNodes& nodes) {
  const NetworkNodes coarse = coarsened(numbered(nodes), most_nodes);
  const std::vector<double> of_coarse = variances(coarse);
  std::vector<double> values;
  values.reserve(nodes.positions.size());
  for (std::uint32_t node : coarse.of_joint) values.push_back(of_coarse[node]);
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
  if (!(mean > 0.0)) return std::vector<double>(values.size(), 1.0);
  for (double& value : values) value /= mean;
  return values;
}

}  // namespace pliant
