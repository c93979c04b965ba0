// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/protonation.hpp"

#include <algorithm>

#include "pliant/base/choices.hpp"
#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/atoms/near_atoms.hpp"
#include "pliant/model/atoms/residue_chemistry.hpp"
#include "pliant/model/prepare/hydrogen_places.hpp"

namespace pliant {
namespace {

constexpr double metal_reach = 2.8;     // Angstrom, of the atoms that a metal holds
constexpr double acceptor_reach = 3.3;  // Angstrom, of an N that may donate its hydrogen

// Angstrom: of N and C in amides and imines, 1.28 to 1.36; in amines it is 1.47.
constexpr double longest_partly_double = 1.4;

constexpr ProtonationForm table[] = {
    {"ASP", "ASP", "", "charged"},
    {"ASH", "ASP", "ASHP ASPH ASPP", "hydrogen on OD2"},
    {"CYS", "CYS", "CYSH", "hydrogen on SG"},
    {"CYX", "CYS", "CYM CYN CYS2 CYSS", "no hydrogen: disulphide, thiolate, at a metal"},
    {"GLU", "GLU", "", "charged"},
    {"GLH", "GLU", "GLUH GLUP", "hydrogen on OE2"},
    {"HID", "HIS", "HSD HISA HISD", "hydrogen on ND1"},
    {"HIE", "HIS", "HSE HISB HISE", "hydrogen on NE2"},
    {"HIP", "HIS", "HSP HISH HISP", "hydrogens on both, charged"},
    {"HIN", "HIS", "HISN", "no hydrogen: between two metals"},
    {"LYS", "LYS", "LYP LYSH", "three hydrogens, charged"},
    {"LYN", "LYS", "LSN", "two hydrogens"},
    {"TYR", "TYR", "", "hydrogen on OH"},
    {"TYM", "TYR", "", "no hydrogen, charged"},
};

bool says(std::string_view words, std::string_view word) {
  const auto at = (" " + std::string(words) + " ").find(" " + std::string(word) + " ");
  return at != std::string::npos;
}

/// The form that a residue's name says; "" if it leaves it open.
std::string_view form_in_name(std::string_view residue) {
  std::string_view name = residue;
  const std::string_view standard = standard_name(residue);
  if (name.size() == 4 && (name[0] == 'N' || name[0] == 'C') &&
      standard_name(name.substr(1)) == standard)
    name.remove_prefix(1);
  for (const ProtonationForm& row : table)
    if (row.residue == standard &&
        ((row.name == name && name != standard) || says(row.aliases, name)))
      return row.name;
  return {};
}

/// "HIS57:HID" taken apart.
struct Wish {
  std::string_view chain;  ///< "" : any
  std::string_view residue, form;
};

Wish wish_of(std::string_view text) {
  const auto last = text.rfind(':');
  if (last == text.npos || last == 0 || last + 1 == text.size())
    throw OptionError("protonate: expected RESIDUE:FORM such as HIS57:HID or A:HIS57:HID, found " +
                      quoted(text));
  const std::string_view before = text.substr(0, last);
  const auto chain = before.rfind(':');
  if (chain == before.npos) return {{}, before, text.substr(last + 1)};
  return {before.substr(0, chain), before.substr(chain + 1), text.substr(last + 1)};
}

bool is_meant(const Residue& residue, const Wish& wish) {
  if (!wish.chain.empty() && residue.chain != wish.chain) return false;
  const std::string number =
      std::to_string(residue.number) +
      (residue.insertion_code == ' ' ? "" : std::string(1, residue.insertion_code));
  return residue.name + number == wish.residue ||
         std::string(standard_name(residue.name)) + number == wish.residue;
}

/// The residue that a wish is about; throws unless it is one that has the form.
std::size_t residue_of(const AtomTable& atoms, const Wish& wish, std::string_view text) {
  const ProtonationForm& form = choose(table, "form of a residue", wish.form);
  std::vector<std::size_t> found;
  for (std::size_t r = 0; r < atoms.residues.size(); ++r)
    if (is_meant(atoms.residues[r], wish)) found.push_back(r);
  if (found.empty())
    throw OptionError("protonate: " + quoted(text) + ": there is no residue " +
                      quoted(wish.residue) +
                      (wish.chain.empty() ? "" : " in chain " + quoted(wish.chain)));
  if (found.size() > 1)
    throw OptionError("protonate: " + quoted(text) + ": " + std::to_string(found.size()) +
                      " residues are " + quoted(wish.residue) + "; say which chain, as in " +
                      quoted(atoms.residues[found[0]].chain + ":" + std::string(text)));
  if (standard_name(atoms.residues[found[0]].name) != form.residue)
    throw OptionError("protonate: " + quoted(text) + ": " + std::string(form.name) +
                      " is a form of " + std::string(form.residue));
  return found[0];
}

/// What the surroundings of His and Cys say of their protonation.
class Surroundings {
 public:
  explicit Surroundings(const Structure& structure)
      : structure_(structure), graph_(structure), residues_(structure.atoms) {
    std::vector<std::uint32_t> metals, oxygens;
    for (std::uint32_t i = 0; i < structure.size(); ++i) {
      if (is_metal(structure.atoms.elements[i])) metals.push_back(i);
      if (structure.atoms.elements[i] == 8) oxygens.push_back(i);
      if (is_asked(i)) centres_.push_back(i);
    }
    metals_ = near_atoms(structure, centres_, metals, metal_reach);
    oxygens_ = near_atoms(structure, centres_, oxygens, acceptor_reach);
  }

  std::string_view histidine(std::size_t residue) const {
    const std::uint32_t nd1 = residues_.find(residue, "ND1"), ne2 = residues_.find(residue, "NE2");
    if (is_at_metal(nd1) && is_at_metal(ne2)) return "HIN";
    if (is_at_metal(ne2)) return "HID";
    if (is_at_metal(nd1)) return "HIE";
    return has_acceptor(nd1) && !has_acceptor(ne2) ? "HID" : "HIE";
  }

  std::string_view cysteine(std::size_t residue) const {
    const std::uint32_t sg = residues_.find(residue, "SG");
    if (sg == no_atom) return "CYS";
    return graph_.heavy_at(sg).size() > 1 || is_at_metal(sg) ? "CYX" : "CYS";
  }

 private:
  bool is_asked(std::uint32_t atom) const {
    const std::string& name = structure_.atoms.names[atom];
    return name == "ND1" || name == "NE2" || name == "SG";
  }

  std::span<const std::uint32_t> near(const Grouped<std::uint32_t>& lists,
                                      std::uint32_t atom) const {
    const auto at = std::lower_bound(centres_.begin(), centres_.end(), atom);
    if (at == centres_.end() || *at != atom) return {};
    return lists.at(static_cast<std::size_t>(at - centres_.begin()));
  }

  bool is_at_metal(std::uint32_t atom) const { return !near(metals_, atom).empty(); }

  bool has_acceptor(std::uint32_t atom) const {
    const auto oxygens = near(oxygens_, atom);
    return std::any_of(oxygens.begin(), oxygens.end(), [&](std::uint32_t oxygen) {
      return structure_.atoms.residue_of[oxygen] != structure_.atoms.residue_of[atom];
    });
  }

  const Structure& structure_;
  AtomGraph graph_;
  ResidueAtoms residues_;
  std::vector<std::uint32_t> centres_;
  Grouped<std::uint32_t> metals_, oxygens_;
};

/// A form by the hydrogens that ND1 and NE2 have; "" where there are none.
std::string_view form_of_hydrogens(const AtomGraph& graph, const ResidueAtoms& residues,
                                   std::size_t residue) {
  const auto has_hydrogen = [&](std::string_view name) {
    const std::uint32_t atom = residues.find(residue, name);
    return atom != no_atom && graph.hydrogens_at(atom) > 0;
  };
  const bool on_nd1 = has_hydrogen("ND1"), on_ne2 = has_hydrogen("NE2");
  if (on_nd1) return on_ne2 ? "HIP" : "HID";
  return on_ne2 ? "HIE" : "";
}

bool has_carbonyl(const Structure& structure, const AtomGraph& graph, std::uint32_t atom) {
  return std::ranges::any_of(graph.at(atom), [&](const Link& link) {
    return structure.atoms.elements[link.node] == 8 && graph.at(link.node).size() == 1;
  });
}

}  // namespace

std::span<const ProtonationForm> protonation_forms() { return table; }

Protonation protonation_of(const Structure& structure, const std::vector<std::string>& wanted) {
  const AtomTable& atoms = structure.atoms;
  const Surroundings surroundings(structure);
  const AtomGraph graph(structure);
  const ResidueAtoms residues(atoms);
  Protonation found;
  for (std::size_t r = 0; r < atoms.residues.size(); ++r) {
    const std::string_view standard = standard_name(atoms.residues[r].name);
    std::string_view form = form_in_name(atoms.residues[r].name);
    if (form.empty() && standard == "HIS") form = form_of_hydrogens(graph, residues, r);
    if (form.empty() && standard == "HIS") form = surroundings.histidine(r);
    if (form.empty() && standard == "CYS") form = surroundings.cysteine(r);
    found.forms.emplace_back(form.empty() ? standard : form);
  }
  found.is_asked_for.assign(atoms.residues.size(), false);
  for (const std::string& text : wanted) {
    const Wish wish = wish_of(text);
    const std::size_t residue = residue_of(atoms, wish, text);
    found.forms[residue] = wish.form;
    found.is_asked_for[residue] = true;
  }
  return found;
}

bool is_acylated(const Structure& structure, const AtomGraph& graph, std::uint32_t n) {
  const AtomTable& atoms = structure.atoms;
  return std::ranges::any_of(graph.at(n), [&](const Link& link) {
    const std::uint32_t other = link.node;
    if (graph.is_hydrogen(other) || atoms.residue_of[other] == atoms.residue_of[n]) return false;
    if (atoms.elements[other] != 6) return true;
    const double length = distance(structure.positions[n], structure.positions[other]);
    return length < longest_partly_double || has_carbonyl(structure, graph, other) ||
           (graph.at(other).size() == 3 && is_planar(structure, graph, other));
  });
}

}  // namespace pliant
