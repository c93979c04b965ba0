// SPDX-License-Identifier: MIT
#include "pliant/sample/network/elastic_network.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/math/elementary.hpp"

namespace pliant {
namespace {

// Angstrom, between alpha carbons.
constexpr double anm_cutoff = 15.0;
constexpr double gnm_cutoff = 10.0;
constexpr double near_length = 6.0;   // of the springs that fall with the sixth power
constexpr double least_length = 2.8;  // nearer nodes, atoms of a ligand, count as so far apart
constexpr double far_cutoff = 15.0;   // of a weak spring besides
constexpr double far_strength = 0.1;
constexpr double shared_cutoff = 18.0;  // of neighbours that two nodes share
constexpr double contact_cutoff = 8.0;  // of pairs over which shares are averaged
constexpr double chain_strength = 3.0;
constexpr std::size_t chain_reach = 3;
constexpr double longest_link = 4.3;  // between neighbours in an unbroken chain

/// Fills both halves of a matrix by spring(i, j, squared distance).
template <class Spring>
DenseMatrix all_pairs(const NetworkNodes& nodes, const Spring& spring) {
  const std::size_t count = nodes.positions.size();
  DenseMatrix k(count, count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      k(i, j) = k(j, i) = spring(i, j, norm_squared(nodes.positions[j] - nodes.positions[i]));
  return k;
}

DenseMatrix no_chain(const NetworkNodes& nodes) {
  return {nodes.positions.size(), nodes.positions.size()};
}

Springs within_cutoff(const NetworkNodes& nodes, double cutoff) {
  return {all_pairs(nodes, [&](std::size_t, std::size_t,
                               double square) { return square < cutoff * cutoff ? 1.0 : 0.0; }),
          no_chain(nodes)};
}

Springs anm_springs(const NetworkNodes& nodes) {
  return within_cutoff(nodes, anm_cutoff * nodes.scale);
}

Springs gnm_springs(const NetworkNodes& nodes) {
  return within_cutoff(nodes, gnm_cutoff * nodes.scale);
}

Springs pfanm_springs(const NetworkNodes& nodes) {
  return {all_pairs(nodes, [](std::size_t, std::size_t, double square) { return 1.0 / square; }),
          no_chain(nodes)};
}

/// For each node the set of those within a distance, as bits.
class NearSets {
 public:
  NearSets(std::span<const Vec3> positions, double cutoff)
      : words_((positions.size() + 63) / 64), bits_(positions.size() * words_, 0) {
    for (std::size_t i = 0; i < positions.size(); ++i)
      for (std::size_t j = 0; j < positions.size(); ++j)
        if (i != j && norm_squared(positions[j] - positions[i]) < cutoff * cutoff)
          bits_[i * words_ + j / 64] |= std::uint64_t{1} << (j % 64);
  }

  int shared(std::size_t i, std::size_t j) const {
    int count = 0;
    for (std::size_t w = 0; w < words_; ++w)
      count += std::popcount(bits_[i * words_ + w] & bits_[j * words_ + w]);
    return count;
  }

 private:
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

/// Neighbours that two nodes share, over the geometric mean of how many each has; then over the
/// mean of that in contacts.
DenseMatrix shares_of_neighbours(const NetworkNodes& nodes) {
  const NearSets near(nodes.positions, shared_cutoff * nodes.scale);
  std::vector<double> own(nodes.positions.size());
  for (std::size_t i = 0; i < own.size(); ++i) own[i] = near.shared(i, i);
  double sum = 0.0;
  std::size_t pairs = 0;
  const double contact = contact_cutoff * nodes.scale;
  DenseMatrix shares = all_pairs(nodes, [&](std::size_t i, std::size_t j, double square) {
    const double share = near.shared(i, j) / std::max(std::sqrt(own[i] * own[j]), 1.0);
    if (square < contact * contact) {
      sum += share;
      ++pairs;
    }
    return share;
  });
  if (!(sum > 0.0)) return all_pairs(nodes, [](auto, auto, double) { return 1.0; });
  for (std::size_t i = 0; i < own.size(); ++i)
    for (double& share : shares.row(i)) share *= double(pairs) / sum;
  return shares;
}

/// Whether two nodes of a chain are as near as neighbours so far apart along it can be.
bool is_unbroken(const NetworkNodes& nodes, std::size_t i, std::size_t j) {
  if (nodes.chain[i] != nodes.chain[j]) return false;
  const double most = longest_link * double(j - i);
  // Nodes that stand for several residues may lie further apart than the scale says.
  return nodes.scale > 1.0 || distance(nodes.positions[i], nodes.positions[j]) < most;
}

DenseMatrix chain_springs(const NetworkNodes& nodes) {
  DenseMatrix k = no_chain(nodes);
  for (std::size_t i = 0; i < nodes.positions.size(); ++i)
    for (std::size_t j = i + 1; j <= i + chain_reach && j < nodes.positions.size(); ++j)
      if (is_unbroken(nodes, i, j)) k(i, j) = k(j, i) = chain_strength;
  return k;
}

Springs shared_springs(const NetworkNodes& nodes) {
  const DenseMatrix shares = shares_of_neighbours(nodes);
  const double near = near_length * near_length * nodes.scale * nodes.scale;
  const double least = least_length * least_length * nodes.scale * nodes.scale;
  const double far = far_cutoff * far_cutoff * nodes.scale * nodes.scale;
  return {all_pairs(nodes,
                    [&](std::size_t i, std::size_t j, double square) {
                      const double ratio = near / std::max(square, least);
                      const double spring =
                          ratio * ratio * ratio + (square < far ? far_strength : 0.0);
                      return spring * (shares(i, j) * shares(i, j));
                    }),
          chain_springs(nodes)};
}

constexpr NetworkEntry table[] = {
    {.name = "shared",
     .summary = "springs by shared neighbours, averaged over cuts into 1 to 4 domains",
     .has_directions = true,
     .has_domains = true,
     .springs = shared_springs},
    {.name = "anm",
     .summary = "equal springs within 15 Angstrom (anisotropic network model)",
     .has_directions = true,
     .has_domains = false,
     .springs = anm_springs},
    {.name = "pfanm",
     .summary = "springs that fall with the squared distance (parameter-free ANM)",
     .has_directions = true,
     .has_domains = false,
     .springs = pfanm_springs},
    {.name = "gnm",
     .summary =
         "equal springs within 10 Angstrom, alike in all directions (Gaussian network model)",
     .has_directions = false,
     .has_domains = false,
     .springs = gnm_springs}};

void add_block(DenseMatrix& h, std::size_t i, std::size_t j, Vec3 along, double k) {
  const std::array<double, 3> n{along.x, along.y, along.z};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) {
      const double value = k * n[a] * n[b];
      h(3 * i + a, 3 * i + b) += value;
      h(3 * j + a, 3 * j + b) += value;
      h(3 * i + a, 3 * j + b) -= value;
      h(3 * j + a, 3 * i + b) -= value;
    }
}

DenseMatrix kirchhoff(const DenseMatrix& springs) {
  DenseMatrix k(springs.rows(), springs.rows());
  for (std::size_t i = 0; i < springs.rows(); ++i)
    for (std::size_t j = 0; j < springs.rows(); ++j)
      if (i != j) {
        k(i, j) -= springs(i, j);
        k(i, i) += springs(i, j);
      }
  return k;
}

/// Adds a row, at right angles to those before, unless nothing is left of it.
void add_row(std::vector<std::vector<double>>& rows, std::vector<double> row) {
  const double before = std::sqrt(dot_product(row, row));
  for (int again = 0; again < 2; ++again)
    for (const auto& other : rows) add_scaled(-dot_product(other, row), other, row);
  const double after = std::sqrt(dot_product(row, row));
  if (!(after > 1e-9 * before)) return;
  for (double& value : row) value *= 1.0 / after;
  rows.push_back(std::move(row));
}

}  // namespace

void check(const NetworkNodes& nodes, std::size_t joint_count) {
  const std::size_t count = nodes.positions.size();
  if (count < 2)
    throw OptionError("network: " + std::to_string(count) + (count == 1 ? " node" : " nodes") +
                      "; it needs 2 or more");
  if (nodes.chain.size() != count)
    throw OptionError("network: " + std::to_string(nodes.chain.size()) + " chains for " +
                      std::to_string(count) + " nodes");
  if (nodes.of_joint.size() != joint_count)
    throw OptionError("network: nodes of " + std::to_string(nodes.of_joint.size()) +
                      " joints for " + std::to_string(joint_count));
  for (std::uint32_t node : nodes.of_joint)
    if (node != no_node && node >= count)
      throw OptionError("network: node " + std::to_string(node) + " of " + std::to_string(count) +
                        " does not exist");
  for (std::size_t k = 0; k < count; ++k)
    if (!is_finite(nodes.positions[k]))
      throw InputError("network: the position of node " + std::to_string(k) + " is not finite");
}

std::span<const NetworkEntry> networks() { return table; }

const NetworkEntry& find_network(std::string_view name) {
  return choose(networks(), "network", name);
}

DenseMatrix stiffness(std::span<const Vec3> positions, const DenseMatrix& springs,
                      bool has_directions) {
  if (!has_directions) return kirchhoff(springs);
  DenseMatrix h(3 * positions.size(), 3 * positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    for (std::size_t j = i + 1; j < positions.size(); ++j) {
      if (springs(i, j) == 0.0) continue;
      const Vec3 along = positions[j] - positions[i];
      add_block(h, i, j, along, springs(i, j) / norm_squared(along));
    }
  return h;
}

DenseMatrix rigid_motions(std::span<const Vec3> positions, bool has_directions) {
  const std::size_t n = positions.size();
  std::vector<std::vector<double>> rows;
  if (!has_directions) {
    rows.emplace_back(n, 1.0 / std::sqrt(double(n)));
  } else {
    Vec3 centre;
    for (Vec3 x : positions) centre += (1.0 / double(n)) * x;
    constexpr std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    for (int turns = 0; turns < 2; ++turns)
      for (Vec3 axis : axes) {
        std::vector<double> row;
        for (Vec3 x : positions) {
          const Vec3 move = turns ? cross(axis, x - centre) : axis;
          row.insert(row.end(), {move.x, move.y, move.z});
        }
        add_row(rows, std::move(row));
      }
  }
  DenseMatrix out(rows.size(), has_directions ? 3 * n : n);
  for (std::size_t k = 0; k < rows.size(); ++k)
    std::copy(rows[k].begin(), rows[k].end(), out.row(k).begin());
  return out;
}

}  // namespace pliant
