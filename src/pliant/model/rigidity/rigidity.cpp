// SPDX-License-Identifier: MIT
#include "pliant/model/rigidity/rigidity.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "pliant/model/rigidity/rings_of_six.hpp"
#include "pliant/molecule/bonds/cut_bonds.hpp"

namespace pliant {
namespace {

constexpr std::uint8_t locked = 6;

/// Rates residues by the bonds within them that may turn.
class ResidueRating {
 public:
  ResidueRating(const Structure& structure, const Rigidity& rigidity)
      : structure_(structure),
        rigidity_(rigidity),
        has_backbone_(structure.atoms.residues.size(), 0),
        rated_(structure.atoms.residues.size()) {}

  std::vector<ResidueFlexibility> rate() {
    const AtomTable& atoms = structure_.atoms;
    for (std::size_t atom = 0; atom < atoms.size(); ++atom)
      if (backbone_bit(atom) != 0) has_backbone_[atoms.residue_of[atom]] |= backbone_bit(atom);
    for (std::size_t k = 0; k < rigidity_.network.bonds; ++k)
      if (counts(k)) add(k);
    for (ResidueFlexibility& residue : rated_)
      if (residue.bonds > 0) residue.index /= residue.bonds;
    take_clusters();
    return std::move(rated_);
  }

 private:
  static constexpr std::uint8_t n_bit = 1, ca_bit = 2, c_bit = 4, whole_backbone = 7;

  std::uint8_t backbone_bit(std::size_t atom) const {
    const std::string_view name = structure_.atoms.names[atom];
    return name == "N" ? n_bit : name == "CA" ? ca_bit : name == "C" ? c_bit : 0;
  }

  bool counts(std::size_t bond) const {
    const auto [a, b, bars] = rigidity_.network.edges[bond];
    const auto& residue_of = structure_.atoms.residue_of;
    if (bars == locked || residue_of[a] != residue_of[b]) return false;
    if (has_backbone_[residue_of[a]] != whole_backbone) return true;
    const std::uint8_t both = backbone_bit(a) | backbone_bit(b);
    return both == (n_bit | ca_bit) || both == (ca_bit | c_bit);
  }

  void add(std::size_t bond) {
    const BodyEdge& edge = rigidity_.network.edges[bond];
    ResidueFlexibility& residue = rated_[structure_.atoms.residue_of[edge.a]];
    residue.index += rigidity_.flexibility[bond];
    ++residue.bonds;
    if (rigidity_.is_flexible(bond)) ++residue.flexible;
  }

  /// The largest has the lowest number.
  void take_clusters() {
    const auto& of_atom = rigidity_.found.clusters.of_body;
    std::vector<bool> is_met(rated_.size(), false);
    for (std::size_t atom = 0; atom < of_atom.size(); ++atom) {
      const std::uint32_t residue = structure_.atoms.residue_of[atom];
      std::uint32_t& cluster = rated_[residue].cluster;
      cluster = is_met[residue] ? std::min(cluster, of_atom[atom]) : of_atom[atom];
      is_met[residue] = true;
    }
  }

  const Structure& structure_;
  const Rigidity& rigidity_;
  std::vector<std::uint8_t> has_backbone_;
  std::vector<ResidueFlexibility> rated_;
};

}  // namespace

Rigidity analyse_rigidity(const Structure& structure, std::span<const MolecularContact> contacts,
                          const RigidityOptions& options) {
  Rigidity rigidity;
  rigidity.network = rigidity_network(structure, contacts, options);
  const auto& edges = rigidity.network.edges;
  rigidity.found = find_rigid_clusters(rigidity.network.atoms, edges);
  rigidity.flexibility = flexibility_indices(edges, rigidity.found);
  for (std::size_t k = 0; k < rigidity.network.bonds; ++k) {
    if (edges[k].bars == locked) continue;
    ++rigidity.hinges;
    if (rigidity.is_flexible(k)) ++rigidity.flexible_bonds;
  }
  rigidity.rings_of_six = rings_of_six(rigidity.network).size();
  rigidity.residues = ResidueRating(structure, rigidity).rate();
  return rigidity;
}

ContactModel contact_model(const Structure& structure, const ModelOptions& options) {
  if (!options.may_be_cut) refuse_cut(structure);
  PrepareOptions preparing = options.prepare;
  if (!preparing.log.function) preparing.log = options.log;
  Preparation ready = prepare(structure, preparing);
  std::vector<MolecularContact> contacts = contacts_for(ready, options);
  return {std::move(ready.structure), std::move(contacts), std::move(ready.steps),
          std::move(ready.missing), std::move(ready.left_out)};
}

}  // namespace pliant
