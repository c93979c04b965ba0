// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "pliant/sample/network/domains.hpp"
#include "pliant/sample/network/lowest_modes.hpp"

namespace pliant {
namespace {

using Labels = std::vector<std::uint32_t>;

constexpr std::size_t embedding_modes = 8;
constexpr std::size_t distance_modes = 10;
constexpr std::size_t most_pieces = 8;
constexpr std::size_t smoothing_reach = 3;  // neighbours on each side

DenseMatrix joined_springs(const NetworkNodes& nodes) {
  const Springs springs = find_network("shared").springs(nodes);
  DenseMatrix k = springs.contacts;
  for (std::size_t i = 0; i < k.rows(); ++i)
    for (std::size_t j = 0; j < k.rows(); ++j) k(i, j) += springs.chain(i, j);
  return k;
}

/// Distances of nodes in the space of the lowest modes of the Kirchhoff matrix.
DenseMatrix spectral_distances(const NetworkNodes& nodes, const DenseMatrix& springs) {
  const EigenPairs modes = lowest_modes(stiffness(nodes.positions, springs, false),
                                        rigid_motions(nodes.positions, false), embedding_modes);
  const std::size_t n = nodes.positions.size();
  DenseMatrix apart(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      double sum = 0.0;
      for (std::size_t m = 0; m < modes.values.size(); ++m) {
        const double difference = modes.vectors(m, i) - modes.vectors(m, j);
        sum += difference * difference / modes.values[m];
      }
      apart(i, j) = apart(j, i) = std::sqrt(sum);
    }
  return apart;
}

DenseMatrix distances_in_modes(const NetworkNodes& nodes, const NetworkModes& modes) {
  const std::size_t count = std::min(distance_modes, modes.variances.size());
  return changes_of_distances(nodes.positions, modes.directions,
                              std::span(modes.variances).first(count));
}

bool is_one_chain(const NetworkNodes& nodes, std::size_t i, std::size_t j) {
  return nodes.chain[i] == nodes.chain[j];
}

std::uint32_t largest_label(const Labels& of_node) {
  return *std::max_element(of_node.begin(), of_node.end());
}

/// Each node goes with most of its neighbours along the chain; with its own where two are alike.
Labels smoothed(const NetworkNodes& nodes, const Labels& of_node) {
  Labels out = of_node;
  std::vector<std::size_t> votes(largest_label(of_node) + 1);
  for (std::size_t i = 0; i < out.size(); ++i) {
    std::fill(votes.begin(), votes.end(), 0);
    const std::size_t last = std::min(i + smoothing_reach, out.size() - 1);
    for (std::size_t j = i - std::min(i, smoothing_reach); j <= last; ++j)
      if (is_one_chain(nodes, i, j)) ++votes[of_node[j]];
    const auto most = std::max_element(votes.begin(), votes.end());
    if (*most > votes[of_node[i]]) out[i] = static_cast<std::uint32_t>(most - votes.begin());
  }
  return out;
}

/// How strongly the others hold a piece: by the springs between them, and far more by links of
/// chains.
std::vector<double> holds(const NetworkNodes& nodes, const DenseMatrix& springs,
                          const Labels& of_node, std::uint32_t piece) {
  constexpr double of_link = 1e3;  // a chain before any number of contacts
  std::vector<double> out(largest_label(of_node) + 1, 0.0);
  for (std::size_t i = 0; i < of_node.size(); ++i) {
    if (of_node[i] != piece) continue;
    for (std::size_t j = 0; j < of_node.size(); ++j)
      if (of_node[j] != piece) out[of_node[j]] += springs(i, j);
    if (i > 0 && is_one_chain(nodes, i - 1, i) && of_node[i - 1] != piece)
      out[of_node[i - 1]] += of_link;
    if (i + 1 < of_node.size() && is_one_chain(nodes, i, i + 1) && of_node[i + 1] != piece)
      out[of_node[i + 1]] += of_link;
  }
  return out;
}

std::vector<std::size_t> sizes_of(const Labels& of_node) {
  std::vector<std::size_t> sizes(largest_label(of_node) + 1, 0);
  for (const std::uint32_t piece : of_node) ++sizes[piece];
  return sizes;
}

/// Pieces that are too small go with those that hold them, the smallest first.
Labels without_small(const NetworkNodes& nodes, const DenseMatrix& springs, Labels of_node) {
  for (;;) {
    const std::vector<std::size_t> sizes = sizes_of(of_node);
    std::uint32_t least = 0;
    std::size_t pieces = 0;
    for (std::uint32_t p = 0; p < sizes.size(); ++p) {
      if (sizes[p] == 0) continue;
      if (pieces++ == 0 || sizes[p] < sizes[least]) least = p;
    }
    if (pieces < 2 || sizes[least] >= least_piece(of_node.size())) return of_node;
    const std::vector<double> hold = holds(nodes, springs, of_node, least);
    const auto by = std::max_element(hold.begin(), hold.end());
    if (!(*by > 0.0)) return of_node;
    for (std::uint32_t& piece : of_node)
      if (piece == least) piece = static_cast<std::uint32_t>(by - hold.begin());
  }
}

std::vector<ChainLink> links_of(const NetworkNodes& nodes, const Labels& of_node) {
  std::vector<ChainLink> links;
  for (std::uint32_t i = 0; i + 1 < of_node.size(); ++i)
    if (is_one_chain(nodes, i, i + 1) && of_node[i] != of_node[i + 1]) links.push_back({i, i + 1});
  return links;
}

/// Joins pieces to the largest, each time the one that is held best by those that are joined
/// already, and numbers them in that order.
PieceTree tree_of(const NetworkNodes& nodes, const DenseMatrix& springs, const Labels& of_node) {
  const std::vector<std::size_t> sizes = sizes_of(of_node);
  constexpr auto none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::vector<double>> hold;
  for (std::uint32_t p = 0; p < sizes.size(); ++p)
    hold.push_back(holds(nodes, springs, of_node, p));
  std::vector<std::uint32_t> number(sizes.size(), none), order;
  const auto root =
      static_cast<std::uint32_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  PieceTree tree;
  const auto join = [&](std::uint32_t piece, std::int32_t parent) {
    number[piece] = static_cast<std::uint32_t>(order.size());
    order.push_back(piece);
    tree.parent.push_back(parent);
  };
  join(root, -1);
  for (;;) {
    double best = -1.0;
    std::uint32_t next = none;
    std::int32_t parent = 0;
    for (std::uint32_t p = 0; p < sizes.size(); ++p) {
      if (sizes[p] == 0 || number[p] != none) continue;
      for (const std::uint32_t q : order)
        if (hold[p][q] > best) {
          best = hold[p][q];
          next = p;
          parent = static_cast<std::int32_t>(number[q]);
        }
    }
    if (next == none) break;
    join(next, parent);
  }
  for (const std::uint32_t piece : of_node) tree.of_node.push_back(number[piece]);
  tree.links = links_of(nodes, of_node);
  return tree;
}

DenseMatrix distances_between(std::span<const Vec3> one, std::span<const Vec3> other) {
  DenseMatrix apart(one.size(), one.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    for (std::size_t j = i + 1; j < one.size(); ++j)
      apart(i, j) = apart(j, i) = std::abs(distance(one[i], one[j]) - distance(other[i], other[j]));
  return apart;
}

bool are_enough(const NetworkNodes& nodes) {
  return nodes.positions.size() >= 2 * least_piece(nodes.positions.size());
}

std::vector<PieceTree> different_trees(const NetworkNodes& nodes, const DenseMatrix& springs,
                                       std::span<const AverageLinkage> cuts) {
  std::vector<PieceTree> out;
  for (std::size_t count = 2; count <= most_pieces; ++count)
    for (const AverageLinkage& cut : cuts) {
      const Labels of_node = without_small(
          nodes, springs, smoothed(nodes, cut.cut(std::min(count, nodes.positions.size()))));
      PieceTree tree = tree_of(nodes, springs, of_node);
      const auto is_same = [&](const PieceTree& other) { return other.of_node == tree.of_node; };
      if (tree.piece_count() > 1 && std::none_of(out.begin(), out.end(), is_same))
        out.push_back(std::move(tree));
    }
  return out;
}

}  // namespace

std::size_t least_piece(std::size_t nodes) { return std::clamp<std::size_t>(nodes / 5, 5, 20); }

std::vector<PieceTree> find_pieces(const NetworkNodes& nodes, const NetworkModes& modes) {
  if (!are_enough(nodes) || modes.variances.empty()) return {};
  const DenseMatrix springs = joined_springs(nodes);
  const std::array<AverageLinkage, 2> cuts{AverageLinkage(spectral_distances(nodes, springs)),
                                           AverageLinkage(distances_in_modes(nodes, modes))};
  return different_trees(nodes, springs, cuts);
}

std::vector<PieceTree> find_pieces(const NetworkNodes& nodes, std::span<const Vec3> other) {
  if (!are_enough(nodes)) return {};
  const AverageLinkage cut(distances_between(nodes.positions, other));
  return different_trees(nodes, joined_springs(nodes), {&cut, 1});
}

}  // namespace pliant
