// SPDX-License-Identifier: MIT
#include "pliant/model/rigidity/rigidity_dilution.hpp"

#include <algorithm>
#include <utility>

namespace pliant {
namespace {

class Dilution {
 public:
  explicit Dilution(const RigidityNetwork& network)
      : network_(network),
        game_(network.atoms),
        bonds_at_(network.atoms, 0),
        is_held_(network.atoms, false) {
    parts_.reset(network.atoms);
    row_.components = network.atoms;
    for (std::size_t k = 0; k < network.bonds; ++k) {
      ++bonds_at_[network.edges[k].a];
      ++bonds_at_[network.edges[k].b];
    }
  }

  std::vector<DilutionRow> run(const DilutionObserver& observer) {
    std::vector<DilutionRow> rows;
    for (std::size_t k = 0; k < network_.first_hydrogen_bond; ++k) {
      add(network_.edges[k]);
      if (!network_.is_bond(k)) hold(network_.edges[k]);
    }
    find_all_clusters(game_, with_first(network_.first_hydrogen_bond));
    take_row(rows, observer);
    for (std::size_t k = network_.first_hydrogen_bond; k < network_.edges.size(); ++k) {
      const BodyEdge& edge = network_.edges[k];
      add(edge);
      hold(edge);
      ++row_.hydrogen_bonds;
      // Only what holds both ends can have become rigid.
      if (game_.are_locked(edge.a, edge.b)) find_all_clusters(game_, with_first(k + 1));
      take_row(rows, observer);
    }
    std::reverse(rows.begin(), rows.end());
    return rows;
  }

 private:
  std::span<const BodyEdge> with_first(std::size_t count) const {
    return std::span(network_.edges).first(count);
  }

  void add(const BodyEdge& edge) {
    row_.redundant += edge.bars - game_.add(edge.a, edge.b, edge.bars);
    if (edge.bars > 0 && parts_.unite(edge.a, edge.b)) --row_.components;
  }

  void hold(const BodyEdge& contact) { is_held_[contact.a] = is_held_[contact.b] = true; }

  /// Whether an atom has one bond and no contact.
  bool hangs(std::uint32_t atom) const { return bonds_at_[atom] == 1 && !is_held_[atom]; }

  void take_row(std::vector<DilutionRow>& rows, const DilutionObserver& observer) {
    std::vector<std::uint32_t> representative(network_.atoms);
    for (std::size_t k = 0; k < network_.atoms; ++k)
      representative[k] = game_.cluster_of(static_cast<std::uint32_t>(k));
    std::size_t idle = 0;
    for (const std::uint32_t k : network_.turning_ends) {
      const BodyEdge& edge = network_.edges[k];
      if (!hangs(edge.a) && !hangs(edge.b)) continue;
      ++idle;
      const auto [end, other] =
          hangs(edge.a) ? std::pair(edge.a, edge.b) : std::pair(edge.b, edge.a);
      representative[end] = representative[other];
    }
    const ClusterList clusters = list_clusters(representative);
    row_.freedoms = freedoms_of_body * (network_.atoms - row_.components) - game_.rank() - idle;
    row_.clusters = clusters.count();
    for (std::size_t k = 0; k < row_.largest.size(); ++k)
      row_.largest[k] = k < clusters.sizes.size() ? clusters.sizes[k] : 0;
    rows.push_back(row_);
    if (observer) observer(row_, clusters);
  }

  const RigidityNetwork& network_;
  PebbleGame game_;
  DisjointSets parts_;
  std::vector<std::uint32_t> bonds_at_;
  std::vector<bool> is_held_;  ///< by contacts so far
  DilutionRow row_;
};

}  // namespace

std::vector<DilutionRow> dilute_hydrogen_bonds(const RigidityNetwork& network,
                                               const DilutionObserver& observer) {
  return Dilution(network).run(observer);
}

}  // namespace pliant
