// SPDX-License-Identifier: MIT
#include "pliant/model/atoms/residue_chemistry.hpp"

#include <algorithm>
#include <iterator>

#include "pliant/base/elements.hpp"
#include "pliant/molecule/structure/residue_templates.hpp"

namespace pliant {
namespace {

struct SideChain {
  std::string_view name, atoms;
};

constexpr SideChain side_chains[] = {
    {"ALA", "CB"},
    {"ARG", "CB CG CD NE CZ NH1 NH2"},
    {"ASN", "CB CG OD1 ND2"},
    {"ASP", "CB CG OD1 OD2"},
    {"CYS", "CB SG"},
    {"GLN", "CB CG CD OE1 NE2"},
    {"GLU", "CB CG CD OE1 OE2"},
    {"GLY", ""},
    {"HIS", "CB CG ND1 CD2 CE1 NE2"},
    {"ILE", "CB CG1 CG2 CD1"},
    {"LEU", "CB CG CD1 CD2"},
    {"LYS", "CB CG CD CE NZ"},
    {"MET", "CB CG SD CE"},
    {"PHE", "CB CG CD1 CD2 CE1 CE2 CZ"},
    {"PRO", "CB CG CD"},
    {"SER", "CB OG"},
    {"THR", "CB OG1 CG2"},
    {"TRP", "CB CG CD1 CD2 NE1 CE2 CE3 CZ2 CZ3 CH2"},
    {"TYR", "CB CG CD1 CD2 CE1 CE2 CZ OH"},
    {"VAL", "CB CG1 CG2"},
};

struct Alias {
  std::string_view standard, names;
};

constexpr Alias aliases[] = {
    {"ARG", "ARN"},
    {"ASP", "ASH ASHP ASPH ASPP ASZ"},
    {"CYS", "CYX CYM CYSH CYS1 CYS2 CYSS CYN CYZ"},
    {"GLU", "GLH GLUH GLUP GLZ"},
    {"HIS", "HID HIE HIP HSD HSE HSP HISA HISB HISD HISE HISH HISP HIS1 HIS2 HISN"},
    {"LYS", "LYN LYP LYSH LSN"},
    {"TYR", "TYM"},
    {"A", "DA DA5 DA3 DAN A5 A3 AN RA RA5 RA3 RAN ADE"},
    {"G", "DG DG5 DG3 DGN G5 G3 GN RG RG5 RG3 RGN GUA"},
    {"C", "DC DC5 DC3 DCN C5 C3 CN RC RC5 RC3 RCN CYT"},
    {"U", "DU U5 U3 UN RU RU5 RU3 RUN URA URI"},
    {"T", "DT DT5 DT3 DTN THY"},
};

using enum HydrogenShape;

constexpr PolarSite sites[] = {
    {"ARG", "NE", "HE", bisector},
    {"ARG", "NH1", "HH11 HH12", in_plane},
    {"ARG", "NH2", "HH21 HH22", in_plane},
    {"ASN", "ND2", "HD22 HD21", in_plane},
    {"ASH", "OD2", "HD2", conjugated},
    {"CYS", "SG", "HG", spinning},
    {"GLN", "NE2", "HE22 HE21", in_plane},
    {"GLH", "OE2", "HE2", conjugated},
    {"HID", "ND1", "HD1", bisector},
    {"HIE", "NE2", "HE2", bisector},
    {"HIP", "ND1", "HD1", bisector},
    {"HIP", "NE2", "HE2", bisector},
    {"LYS", "NZ", "HZ1 HZ2 HZ3", spinning},
    {"LYN", "NZ", "HZ1 HZ2", spinning},
    {"SER", "OG", "HG", spinning},
    {"THR", "OG1", "HG1", spinning},
    {"TRP", "NE1", "HE1", bisector},
    {"TYR", "OH", "HH", conjugated},
    {"HYP", "OD1", "HD1", spinning},
    {"ORN", "NE", "HE1 HE2 HE3", spinning},
    {"A", "N6", "H62 H61", in_plane},
    {"C", "N4", "H42 H41", in_plane},
    {"G", "N1", "H1", bisector},
    {"G", "N2", "H21 H22", in_plane},
    {"U", "N3", "H3", bisector},
    {"T", "N3", "H3", bisector},
};

bool holds_word(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const auto end = std::min(words.find(' '), words.size());
    if (words.substr(0, end) == word) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

std::string_view known_name(std::string_view residue) {
  for (const Alias& row : aliases)
    if (row.standard == residue || holds_word(row.names, residue)) return row.standard;
  for (const SideChain& row : side_chains)
    if (row.name == residue) return row.name;
  return {};
}

bool is_of_kind(const Residue& residue, ResidueKind kind) {
  const ResidueTemplate* shape = find_residue_template(residue.name);
  return shape != nullptr && shape->kind == kind;
}

}  // namespace

std::string_view standard_name(std::string_view residue) {
  if (const auto known = known_name(residue); !known.empty()) return known;
  // Amber marks the ends of a chain by a first letter.
  if (residue.size() == 4 && (residue[0] == 'N' || residue[0] == 'C'))
    if (const auto known = known_name(residue.substr(1)); !known.empty()) return known;
  return residue;
}

std::string_view side_chain_atoms(std::string_view standard) {
  for (const SideChain& row : side_chains)
    if (row.name == standard) return row.atoms;
  return {};
}

std::span<const PolarSite> polar_sites() { return sites; }

bool is_water(const Residue& residue) { return is_of_kind(residue, ResidueKind::water); }
bool is_amino_acid(const Residue& residue) { return is_of_kind(residue, ResidueKind::amino_acid); }
bool is_nucleotide(const Residue& residue) { return is_of_kind(residue, ResidueKind::nucleotide); }
bool is_cap(const Residue& residue) { return is_of_kind(residue, ResidueKind::cap); }

std::vector<bool> polymer_residues(const Structure& structure) {
  const auto& residues = structure.atoms.residues;
  const auto& residue_of = structure.atoms.residue_of;
  const auto& elements = structure.atoms.elements;
  std::vector<bool> found(residues.size(), false);
  const auto is_known = [](const Residue& one) { return is_amino_acid(one) || is_nucleotide(one); };
  if (std::ranges::count_if(residues, is_known) > 1)
    std::transform(residues.begin(), residues.end(), found.begin(), is_known);
  for (const Bond& bond : structure.bonds) {
    const bool links = residue_of[bond.a] != residue_of[bond.b];
    if (links && !is_metal(elements[bond.a]) && !is_metal(elements[bond.b]))
      found[residue_of[bond.a]] = found[residue_of[bond.b]] = true;
  }
  return found;
}

}  // namespace pliant
