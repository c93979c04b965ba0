// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <set>

#include "document.hpp"
#include "pliant/molecule/secondary_structure.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant::play {
namespace {

enum BarSort : std::uint8_t { of_bond, of_angle, of_plane, of_graph };
constexpr const char* bar_sorts[] = {"bond", "angle", "plane", "bar"};

/// Whether two atoms are bonded to one atom.
class Neighbours {
 public:
  Neighbours(std::size_t atoms, const std::vector<Bond>& bonds) : of_(atoms) {
    for (const Bond& bond : bonds) {
      of_[bond.a].push_back(bond.b);
      of_[bond.b].push_back(bond.a);
    }
  }
  bool are_bonded(std::uint32_t a, std::uint32_t b) const { return std::ranges::count(of_[a], b); }
  bool share_one(std::uint32_t a, std::uint32_t b) const {
    return std::ranges::any_of(of_[a], [&](std::uint32_t c) { return are_bonded(c, b); });
  }

 private:
  std::vector<std::vector<std::uint32_t>> of_;
};

std::vector<std::uint8_t> sorts_of_bars(const Document& document) {
  std::vector<std::uint8_t> sorts(document.framework.bar_count(), of_graph);
  if (document.kind == "graph") return sorts;
  const Neighbours neighbours(document.atoms.size(), document.bonds);
  for (std::size_t k = 0; k < sorts.size(); ++k) {
    const Bar bar = document.framework.bars()[k];
    sorts[k] = neighbours.are_bonded(bar.a, bar.b)  ? of_bond
               : neighbours.share_one(bar.a, bar.b) ? of_angle
                                                    : of_plane;
  }
  return sorts;
}

/// Pairs of numbers, as many as there are rows.
template <class Rows>
std::vector<std::int32_t> pairs_of(const Rows& rows) {
  std::vector<std::int32_t> pairs;
  for (const auto& row : rows) {
    pairs.push_back(static_cast<std::int32_t>(row.a));
    pairs.push_back(static_cast<std::int32_t>(row.b));
  }
  return pairs;
}

std::vector<std::int32_t> signed_of(const std::vector<std::uint32_t>& numbers) {
  return {numbers.begin(), numbers.end()};
}

/// CA or P of each residue in order; -1 where a chain ends.
std::vector<std::int32_t> trace_of(const Document& document) {
  const AtomTable& atoms = document.atoms;
  std::vector<std::int32_t> trace;
  std::int64_t last = -1;
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    const bool is_carbon = atoms.names[k] == "CA" && atoms.elements[k] == 6;
    const bool is_phosphorus = atoms.names[k] == "P" && atoms.elements[k] == 15;
    if (!is_carbon && !is_phosphorus) continue;
    const auto residue = std::int64_t{atoms.residue_of[k]};
    const bool goes_on =
        last >= 0 && residue == last + 1 &&
        atoms.residues[std::size_t(last)].chain == atoms.residues[std::size_t(residue)].chain &&
        !(std::size_t(last) < document.chain_end.size() && document.chain_end[std::size_t(last)]);
    if (last >= 0 && !goes_on) trace.push_back(-1);
    trace.push_back(static_cast<std::int32_t>(k));
    last = residue;
  }
  return trace;
}

void describe_atoms(const Document& document, Reply& reply) {
  const AtomTable& atoms = document.atoms;
  Json names = Json::array(), chains = Json::array(), residues = Json::array();
  for (std::size_t k = 0; k < atoms.size(); ++k) names.push_back(atoms.label(k));
  for (const Residue& residue : atoms.residues) {
    chains.push_back(residue.chain);
    residues.push_back(
        {{"name", residue.name}, {"number", residue.number}, {"chain", residue.chain}});
  }
  reply.fields["names"] = std::move(names);
  reply.fields["atoms"] = atoms.names;
  reply.fields["chain"] = std::move(chains);
  reply.fields["residues"] = std::move(residues);
  reply.fields["secondary"] = secondary_structure(atoms, document.positions);
  reply.add("elements", std::span<const std::uint8_t>(atoms.elements));
  reply.add("residue", std::span<const std::int32_t>(signed_of(atoms.residue_of)));
  reply.add("trace", std::span<const std::int32_t>(trace_of(document)));
}

void describe_bars(const Document& document, Reply& reply) {
  const Framework& framework = document.framework;
  reply.fields["kindNames"] = bar_sorts;
  reply.add("bars", std::span<const std::int32_t>(pairs_of(framework.bars())));
  reply.add("kinds", std::span<const std::uint8_t>(sorts_of_bars(document)));
  reply.add("rest", framework.rest_lengths());
  reply.add("bonds", std::span<const std::int32_t>(pairs_of(document.bonds)));
  std::vector<double> masses;
  Json pinned = Json::array();
  for (std::size_t k = 0; k < framework.joint_count(); ++k) {
    const double inverse = framework.inverse_masses()[k];
    masses.push_back(inverse == 0.0 ? std::numeric_limits<double>::infinity() : 1.0 / inverse);
    if (inverse == 0.0) pinned.push_back(k);
  }
  reply.add("mass", std::span<const double>(masses));
  reply.fields["pinned"] = std::move(pinned);
}

void describe_contacts(const Document& document, Reply& reply) {
  std::vector<std::uint8_t> kinds;
  std::vector<double> limits;
  for (const MolecularContact& contact : document.contacts) {
    kinds.push_back(static_cast<std::uint8_t>(contact.kind));
    for (const double length : {contact.least, contact.distance, contact.most})
      limits.push_back(length);
  }
  Json names = Json::array(), colours = Json::array();
  for (const MolecularContactKindEntry& row : molecular_contact_kinds()) {
    names.push_back(row.name);
    colours.push_back(row.colour);
  }
  reply.fields["contactKindNames"] = std::move(names);
  reply.fields["contactKindColours"] = std::move(colours);
  reply.add("contacts", std::span<const std::int32_t>(pairs_of(document.contacts)));
  reply.add("contactKinds", std::span<const std::uint8_t>(kinds));
  reply.add("contactLimits", std::span<const double>(limits));
}

/// Techniques that do not fit the framework, with the reason.
Json unfit_told(const Framework& framework) {
  Json rows = Json::object();
  for (const TechniqueEntry& row : techniques()) {
    const TechniqueFit found = fit_of({std::string(row.name)}, framework);
    if (found.fit != Fit::fits)
      rows[std::string(row.name)] = {{"refused", found.fit == Fit::refused}, {"why", found.why}};
  }
  return rows;
}

/// Small pieces are in none.
void describe_clusters(const Document& document, Reply& reply) {
  const ClusterList& found = document.clusters;
  std::vector<std::int32_t> clusters(document.framework.joint_count(), -1);
  for (std::size_t k = 0; k < found.of_body.size(); ++k)
    if (found.of_body[k] < found.count()) clusters[k] = static_cast<std::int32_t>(found.of_body[k]);
  reply.fields["rigidClusters"] = found.count();
  reply.fields["colouredClusters"] = document.coloured_clusters;
  reply.add("cluster", std::span<const std::int32_t>(clusters));
}

}  // namespace

std::span<const double> numbers_of(std::span<const Vec3> positions) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return {reinterpret_cast<const double*>(positions.data()), 3 * positions.size()};
}

Reply describe(const Document& document, std::span<const Vec3> positions) {
  Reply reply;
  const std::size_t joints = document.framework.joint_count();
  reply.fields = {{"title", document.title},
                  {"kind", document.kind},
                  {"model", document.model},
                  {"joints", joints},
                  {"unfit", unfit_told(document.framework)},
                  {"warnings", document.warnings}};
  describe_atoms(document, reply);
  describe_bars(document, reply);
  describe_contacts(document, reply);
  describe_clusters(document, reply);
  reply.add("positions", numbers_of(positions));
  return reply;
}

}  // namespace pliant::play
