// SPDX-License-Identifier: MIT
#include "pliant/sample/network/network_modes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/base/threads/threads.hpp"
#include "pliant/sample/network/domains.hpp"
#include "pliant/sample/network/lowest_modes.hpp"

namespace pliant {
namespace {

constexpr std::size_t domain_modes = 10;
constexpr std::size_t most_domains = 4;
constexpr double between_domains = 0.1;

NetworkModes from_stiffness(EigenPairs pairs) {
  NetworkModes modes;
  for (double value : pairs.values) modes.variances.push_back(1.0 / value);
  modes.directions = std::move(pairs.vectors);
  return modes;
}

/// Makes three modes, along x, y and z, of each mode without a direction.
NetworkModes in_three_directions(const NetworkModes& plain, std::size_t nodes, std::size_t count) {
  NetworkModes modes;
  const std::size_t kept = std::min(count, 3 * plain.variances.size());
  modes.directions = DenseMatrix(kept, 3 * nodes);
  for (std::size_t k = 0; k < kept; ++k) {
    modes.variances.push_back(plain.variances[k / 3]);
    for (std::size_t i = 0; i < nodes; ++i)
      modes.directions(k, 3 * i + k % 3) = plain.directions(k / 3, i);
  }
  return modes;
}

/// The springs of both kinds; contacts between domains count a tenth.
DenseMatrix joined(const Springs& springs, const std::vector<std::uint32_t>& domain) {
  DenseMatrix k = springs.contacts;
  for (std::size_t i = 0; i < k.rows(); ++i)
    for (std::size_t j = 0; j < k.rows(); ++j) {
      if (domain[i] != domain[j]) k(i, j) *= between_domains;
      k(i, j) += springs.chain(i, j);
    }
  return k;
}

NetworkModes modes_of(const NetworkNodes& nodes, const DenseMatrix& springs, bool has_directions,
                      std::size_t count) {
  const std::size_t wanted = has_directions ? count : (count + 2) / 3;
  NetworkModes modes =
      from_stiffness(lowest_modes(stiffness(nodes.positions, springs, has_directions),
                                  rigid_motions(nodes.positions, has_directions), wanted));
  if (has_directions) return modes;
  return in_three_directions(modes, nodes.positions.size(), count);
}

/// Rows sqrt(variance / all variances) times direction: their products make up the covariance,
/// divided by its trace.
void add_weighted(const NetworkModes& modes, std::vector<std::vector<double>>& rows) {
  double trace = 0.0;
  for (double variance : modes.variances) trace += variance;
  for (std::size_t k = 0; k < modes.variances.size(); ++k) {
    const auto direction = modes.directions.row(k);
    rows.emplace_back(direction.begin(), direction.end());
    for (double& value : rows.back()) value *= std::sqrt(modes.variances[k] / trace);
  }
}

/// The modes of largest variance of the covariance sum_r row_r row_r^T / cuts, from the matrix of
/// products of rows, which has the same eigenvalues.
NetworkModes principal(const std::vector<std::vector<double>>& rows, double cuts,
                       std::size_t count) {
  const std::size_t size = rows.size();
  DenseMatrix products(size, size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = i; j < size; ++j)
      products(i, j) = products(j, i) = dot_product(rows[i], rows[j]) / cuts;
  const EigenPairs pairs = symmetric_eigen(std::move(products));
  const double least = 1e-9 * pairs.values.back();
  NetworkModes modes;
  std::size_t kept = 0;
  while (kept < std::min(count, size) && pairs.values[size - 1 - kept] > least) ++kept;
  modes.directions = DenseMatrix(kept, rows[0].size());
  for (std::size_t k = 0; k < kept; ++k) {
    const std::size_t from = size - 1 - k;
    const auto direction = modes.directions.row(k);
    for (std::size_t r = 0; r < size; ++r) add_scaled(pairs.vectors(from, r), rows[r], direction);
    const double length = std::sqrt(dot_product(direction, direction));
    for (double& value : direction) value *= 1.0 / length;
    make_sign_canonical(direction);
    modes.variances.push_back(pairs.values[from]);
  }
  return modes;
}

/// Of the network cut into 2, 3, ... domains.
std::vector<NetworkModes> modes_of_cuts(const NetworkNodes& nodes, const Springs& springs,
                                        const AverageLinkage& tree, std::size_t count,
                                        std::size_t threads) {
  const std::size_t cuts = std::min(most_domains, nodes.positions.size()) - 1;
  std::vector<NetworkModes> modes(cuts);
  for_each_in_threads(std::min(threads, cuts), cuts, [&](std::size_t k) {
    modes[k] = modes_of(nodes, joined(springs, tree.cut(k + 2)), true, count);
  });
  return modes;
}

NetworkModes averaged_over_domains(const NetworkNodes& nodes, const Springs& springs,
                                   std::size_t count, std::size_t threads) {
  const std::size_t n = nodes.positions.size();
  NetworkModes whole =
      modes_of(nodes, joined(springs, std::vector<std::uint32_t>(n, 0)), true, count);
  if (whole.variances.empty()) return whole;
  std::vector<std::vector<double>> rows;
  add_weighted(whole, rows);
  const std::size_t looked_at = std::min(domain_modes, whole.variances.size());
  const AverageLinkage tree(changes_of_distances(nodes.positions, whole.directions,
                                                 std::span(whole.variances).first(looked_at)));
  const std::vector<NetworkModes> cuts = modes_of_cuts(nodes, springs, tree, count, threads);
  for (const NetworkModes& modes : cuts) add_weighted(modes, rows);
  return principal(rows, double(1 + cuts.size()), count);
}

}  // namespace

NetworkModes network_modes(const NetworkNodes& nodes, std::string_view network, std::size_t count,
                           std::size_t threads) {
  const NetworkEntry& entry = find_network(network);
  const Springs springs = entry.springs(nodes);
  if (entry.has_domains) return averaged_over_domains(nodes, springs, count, threads);
  const std::vector<std::uint32_t> one_domain(nodes.positions.size(), 0);
  return modes_of(nodes, joined(springs, one_domain), entry.has_directions, count);
}

std::vector<double> fluctuations(const NetworkModes& modes) {
  std::vector<double> squares(modes.directions.columns() / 3, 0.0);
  for (std::size_t k = 0; k < modes.variances.size(); ++k) {
    const auto u = modes.directions.row(k);
    for (std::size_t i = 0; i < squares.size(); ++i)
      squares[i] += modes.variances[k] * (u[3 * i] * u[3 * i] + u[3 * i + 1] * u[3 * i + 1] +
                                          u[3 * i + 2] * u[3 * i + 2]);
  }
  for (double& value : squares) value = std::sqrt(value);
  return squares;
}

void scale_to(double amplitude, NetworkModes& modes) {
  const std::vector<double> now = fluctuations(modes);
  double mean = 0.0;
  for (double value : now) mean += value / double(now.size());
  if (!(mean > 0.0)) return;
  for (double& variance : modes.variances) variance *= (amplitude / mean) * (amplitude / mean);
}

std::vector<Vec3> moves_along(const NetworkModes& modes, std::span<const double> amplitudes) {
  std::vector<Vec3> moves(modes.directions.columns() / 3);
  for (std::size_t k = 0; k < amplitudes.size(); ++k) {
    const double scale = amplitudes[k] * std::sqrt(modes.variances[k]);
    const auto u = modes.directions.row(k);
    for (std::size_t i = 0; i < moves.size(); ++i)
      moves[i] += scale * Vec3{u[3 * i], u[3 * i + 1], u[3 * i + 2]};
  }
  return moves;
}

}  // namespace pliant
