// SPDX-License-Identifier: MIT
#include "pliant/sample/network/domains.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/base/graphs/disjoint_sets.hpp"

namespace pliant {
namespace {

/// Clusters that are left, each known by one of its members.
class Clusters {
 public:
  explicit Clusters(DenseMatrix& distances)
      : distances_(distances), size_(distances.rows(), 1), left_(distances.rows()) {}

  std::size_t left() const { return left_; }
  bool is_left(std::uint32_t k) const { return size_[k] > 0; }
  double apart(std::uint32_t i, std::uint32_t j) const { return distances_(i, j); }

  /// The nearest other cluster; `before`, the last of the chain, where another is no nearer.
  std::uint32_t nearest(std::uint32_t k, std::uint32_t before) const {
    std::uint32_t best = before;
    for (std::uint32_t j = 0; j < size_.size(); ++j) {
      if (j == k || !is_left(j)) continue;
      if (best == k || apart(k, j) < apart(k, best)) best = j;
    }
    return best;
  }

  /// Unites two clusters under the second's name.
  void unite(std::uint32_t gone, std::uint32_t kept) {
    const auto a = double(size_[gone]), b = double(size_[kept]);
    for (std::uint32_t j = 0; j < size_.size(); ++j) {
      if (j == kept || j == gone || !is_left(j)) continue;
      const double mean = (a * apart(gone, j) + b * apart(kept, j)) / (a + b);
      distances_(kept, j) = distances_(j, kept) = mean;
    }
    size_[kept] += size_[gone];
    size_[gone] = 0;
    --left_;
  }

 private:
  DenseMatrix& distances_;
  std::vector<std::size_t> size_;
  std::size_t left_;
};

}  // namespace

AverageLinkage::AverageLinkage(DenseMatrix distances) : things_(distances.rows()) {
  Clusters clusters(distances);
  std::vector<std::uint32_t> chain;
  std::uint32_t first = 0;
  while (clusters.left() > 1) {
    if (chain.empty()) {
      while (!clusters.is_left(first)) ++first;
      chain.push_back(first);
    }
    const std::uint32_t end = chain.back();
    const std::uint32_t before = chain.size() > 1 ? chain[chain.size() - 2] : end;
    const std::uint32_t next = clusters.nearest(end, before);
    if (next != before || chain.size() == 1) {
      chain.push_back(next);
      continue;
    }
    merges_.push_back({end, before, clusters.apart(end, before)});
    clusters.unite(std::max(end, before), std::min(end, before));
    chain.resize(chain.size() - 2);
  }
  std::stable_sort(merges_.begin(), merges_.end(),
                   [](const Merge& a, const Merge& b) { return a.height < b.height; });
}

std::vector<std::uint32_t> AverageLinkage::cut(std::size_t count) const {
  DisjointSets sets;
  sets.reset(things_);
  for (std::size_t k = 0; k + count < things_; ++k) sets.unite(merges_[k].one, merges_[k].other);
  std::vector<std::uint32_t> number(things_), of(things_);
  std::uint32_t next = 0;
  for (std::uint32_t k = 0; k < things_; ++k) {
    const std::uint32_t lowest = sets.find(k);
    if (lowest == k) number[k] = next++;
    of[k] = number[lowest];
  }
  return of;
}

DenseMatrix changes_of_distances(std::span<const Vec3> positions, const DenseMatrix& modes,
                                 std::span<const double> variances) {
  const std::size_t n = positions.size();
  DenseMatrix changes(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const Vec3 apart = positions[j] - positions[i];
      double sum = 0.0;
      for (std::size_t m = 0; m < variances.size(); ++m) {
        const double* u = modes.row(m).data();
        const double change = (u[3 * j] - u[3 * i]) * apart.x +
                              (u[3 * j + 1] - u[3 * i + 1]) * apart.y +
                              (u[3 * j + 2] - u[3 * i + 2]) * apart.z;
        sum += variances[m] * change * change;
      }
      changes(i, j) = changes(j, i) = std::sqrt(sum / norm_squared(apart));
    }
  return changes;
}

}  // namespace pliant
