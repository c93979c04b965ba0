// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/cif/mmcif_bonds.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>

#include "pliant/base/letters.hpp"
#include "pliant/base/number.hpp"
#include "pliant/molecule/read/cif/mmcif_atoms.hpp"

namespace pliant {
namespace {

std::uint8_t order_of(std::string_view word) {
  const std::string order = lower_case(word);
  if (order == "sing") return 1;
  if (order == "doub") return 2;
  if (order == "trip") return 3;
  return order == "arom" ? 4 : 0;
}

/// Reads the rows of struct_conn.
class StructConnReader {
 public:
  StructConnReader(const CifDocument& document, const CifTable& table,
                   std::span<const std::string_view> altlocs, Remarks& remarks)
      : document_(document),
        table_(table),
        altlocs_(altlocs),
        remarks_(remarks),
        lines_(document.text) {}

  std::vector<StatedLink> read();

 private:
  /// The first of `tags` that has a value; "" for none.
  std::string_view word(std::size_t row, const std::vector<std::string>& tags) const;
  std::optional<LinkEnd> end_of(std::size_t row, const std::string& partner) const;
  bool is_bond(std::size_t row);

  const CifDocument& document_;
  const CifTable& table_;
  std::span<const std::string_view> altlocs_;
  Remarks& remarks_;
  CifLines lines_;
  std::size_t line_ = 0;  // where the current row begins
};

std::string_view StructConnReader::word(std::size_t row,
                                        const std::vector<std::string>& tags) const {
  for (const std::string& tag : tags) {
    const auto column = table_.column(tag);
    if (!column) continue;
    const std::string_view word = document_.word(table_.at(row, *column));
    if (!word.empty()) return word;
  }
  return {};
}

std::optional<LinkEnd> StructConnReader::end_of(std::size_t row, const std::string& partner) const {
  const auto number =
      parse_integer(word(row, {partner + "_auth_seq_id", partner + "_label_seq_id"}));
  const std::string_view insertion = word(row, {"pdbx_" + partner + "_pdb_ins_code"});
  const std::string_view conformer = word(row, {"pdbx_" + partner + "_label_alt_id"});
  const std::string_view symmetry = word(row, {partner + "_symmetry"});
  if (!number) return std::nullopt;
  LinkEnd end;
  end.address.chain = word(row, {partner + "_auth_asym_id", partner + "_label_asym_id"});
  end.address.number = *number;
  end.address.insertion_code = insertion.empty() ? ' ' : insertion[0];
  end.address.name = word(row, {partner + "_auth_atom_id", partner + "_label_atom_id"});
  end.conformer = altloc_character(conformer, altlocs_);
  if (symmetry != "1_555") end.symmetry = symmetry;
  return end;
}

bool StructConnReader::is_bond(std::size_t row) {
  const std::string type = lower_case(word(row, {"conn_type_id"}));
  if (type.starts_with("covale") || type == "disulf" || type == "modres" || type == "metalc")
    return true;
  const auto text = [&] {
    return "struct_conn of type " + pliant::quoted(type) + " is no bond: left out";
  };
  remarks_.note(type == "hydrog" ? "hydrog" : "other struct_conn", line_, text);
  return false;
}

std::vector<StatedLink> StructConnReader::read() {
  std::vector<StatedLink> links;
  for (std::size_t row = 0; row < table_.rows(); ++row) {
    line_ = lines_(table_.at(row, 0));
    if (!is_bond(row)) continue;
    const auto first = end_of(row, "ptnr1"), second = end_of(row, "ptnr2");
    if (!first || !second) {
      remarks_.warn("link number", line_, [] {
        return "struct_conn without two whole residue numbers (auth_seq_id): left out";
      });
      continue;
    }
    links.push_back(
        {{*first, *second}, "struct_conn", line_, order_of(word(row, {"pdbx_value_order"}))});
  }
  return links;
}

struct ComponentBond {
  std::string_view first, second;
  std::uint8_t order;
};
using Components = std::map<std::string_view, std::vector<ComponentBond>>;

Components components_of(const CifDocument& document, const CifTable& table) {
  const auto component = table.column("comp_id");
  const auto first = table.column("atom_id_1"), second = table.column("atom_id_2");
  const auto order = table.column("value_order"), aromatic = table.column("pdbx_aromatic_flag");
  Components components;
  if (!component || !first || !second) return components;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto word = [&](const std::optional<std::size_t>& column) {
      return column ? document.word(table.at(row, *column)) : std::string_view();
    };
    const bool is_aromatic = word(aromatic) == "Y";
    components[word(component)].push_back(
        {word(first), word(second), is_aromatic ? std::uint8_t{4} : order_of(word(order))});
  }
  return components;
}

/// Atoms of one residue by name.
class ResidueNames {
 public:
  ResidueNames(const AtomTable& atoms, std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t i = first; i < last; ++i) entries_.push_back({atoms.names[i], i});
    std::sort(entries_.begin(), entries_.end());
  }

  std::optional<std::uint32_t> find(std::string_view name) const {
    const auto at =
        std::lower_bound(entries_.begin(), entries_.end(), std::make_pair(name, std::uint32_t{0}));
    if (at == entries_.end() || at->first != name) return std::nullopt;
    return at->second;
  }

 private:
  std::vector<std::pair<std::string_view, std::uint32_t>> entries_;
};

}  // namespace

std::vector<StatedLink> struct_conn_links(const CifDocument& document, const CifTable& table,
                                          std::span<const std::string_view> altlocs,
                                          Remarks& remarks) {
  return StructConnReader(document, table, altlocs, remarks).read();
}

void add_component_bonds(const CifDocument& document, const CifTable& table, Structure& structure) {
  const Components components = components_of(document, table);
  const AtomTable& atoms = structure.atoms;
  const auto count = static_cast<std::uint32_t>(atoms.size());
  for (std::uint32_t first = 0, last = 0; first < count; first = last) {
    while (last < count && atoms.residue_of[last] == atoms.residue_of[first]) ++last;
    const auto component = components.find(atoms.residues[atoms.residue_of[first]].name);
    if (component == components.end()) continue;
    const ResidueNames names(atoms, first, last);
    for (const ComponentBond& bond : component->second) {
      const auto a = names.find(bond.first), b = names.find(bond.second);
      if (!a || !b || *a == *b) continue;
      structure.bonds.push_back({std::min(*a, *b), std::max(*a, *b), BondOrigin::file, bond.order});
    }
  }
}

}  // namespace pliant
