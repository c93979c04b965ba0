// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/carbon_hydrogens.hpp"

#include <string>
#include <string_view>

#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/atoms/residue_chemistry.hpp"
#include "pliant/model/prepare/hydrogen_places.hpp"

namespace pliant {
namespace {

constexpr double to_sp3 = 1.09, to_sp2 = 1.08;  // Angstrom

/// Carbons that bear hydrogens: name, a colon (= for sp2), how many.
struct CarbonsOf {
  std::string_view residue, carbons;
};

constexpr std::string_view of_backbone = "CA:1";
constexpr std::string_view of_sugar = "C1':1 C2':2 C3':1 C4':1 C5':2";

constexpr CarbonsOf table[] = {
    {"ALA", "CB:3"},
    {"ARG", "CB:2 CG:2 CD:2"},
    {"ASN", "CB:2"},
    {"ASP", "CB:2"},
    {"CYS", "CB:2"},
    {"GLN", "CB:2 CG:2"},
    {"GLU", "CB:2 CG:2"},
    {"GLY", "CA:2"},
    {"HIS", "CB:2 CD2=1 CE1=1"},
    {"ILE", "CB:1 CG1:2 CG2:3 CD1:3 CD:3"},
    {"LEU", "CB:2 CG:1 CD1:3 CD2:3"},
    {"LYS", "CB:2 CG:2 CD:2 CE:2"},
    {"MET", "CB:2 CG:2 CE:3"},
    {"PHE", "CB:2 CD1=1 CD2=1 CE1=1 CE2=1 CZ=1"},
    {"PRO", "CB:2 CG:2 CD:2"},
    {"SER", "CB:2"},
    {"THR", "CB:1 CG2:3"},
    {"TRP", "CB:2 CD1=1 CE3=1 CZ2=1 CZ3=1 CH2=1"},
    {"TYR", "CB:2 CD1=1 CD2=1 CE1=1 CE2=1"},
    {"VAL", "CB:1 CG1:3 CG2:3"},
    {"ACE", "CH3:3"},
    {"NME", "CH3:3 C:3"},
    {"A", "C2=1 C8=1"},
    {"G", "C8=1"},
    {"C", "C5=1 C6=1"},
    {"U", "C5=1 C6=1"},
    {"T", "C6=1 C7:3 C5M:3"},
};

/// The hydrogens of a carbon without further bonds.
struct Wanted {
  std::size_t count = 0;
  bool is_sp2 = false;
};

/// What a list gives a carbon; none if it is not in it.
Wanted wanted_in(std::string_view list, std::string_view carbon) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(' '), list.size());
    const std::string_view word = list.substr(0, end);
    if (word.substr(0, word.size() - 2) == carbon)
      return {std::size_t(word.back() - '0'), word[word.size() - 2] == '='};
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return {};
}

std::string_view carbons_of(std::string_view standard) {
  for (const CarbonsOf& row : table)
    if (row.residue == standard) return row.carbons;
  return {};
}

/// "HB2", "HG11", "H5''": of the carbon's name behind its C, and a number where there are several.
std::string hydrogen_name(std::string_view carbon, std::size_t k, std::size_t count) {
  std::string name = "H" + std::string(carbon.substr(1));
  if (count == 1) return name;
  if (!name.empty() && name.back() == '\'') return name + (k == 0 ? "" : "'");
  return name + std::to_string(count == 2 ? k + 2 : k + 1);
}

class CarbonPlacer {
 public:
  explicit CarbonPlacer(const Structure& structure) : structure_(structure), graph_(structure) {}

  std::vector<PlacedHydrogen> place() {
    for (std::uint32_t atom = 0; atom < structure_.size(); ++atom) {
      if (structure_.atoms.elements[atom] != 6 || graph_.hydrogens_at(atom) > 0) continue;
      place_at(atom, wanted_at(atom));
    }
    return std::move(placed_);
  }

 private:
  Vec3 at(std::uint32_t atom) const { return structure_.positions[atom]; }

  Wanted wanted_at(std::uint32_t atom) const {
    const Residue& residue = structure_.atoms.residues[structure_.atoms.residue_of[atom]];
    const std::string_view name = structure_.atoms.names[atom];
    const std::string_view carbons = carbons_of(standard_name(residue.name));
    if (carbons.empty()) return {};
    if (const Wanted own = wanted_in(carbons, name); own.count > 0) return own;
    if (is_nucleotide(residue)) return of_sugar_at(atom, name);
    return is_amino_acid(residue) ? wanted_in(of_backbone, name) : Wanted{};
  }

  /// C2' of RNA has O2' in place of a hydrogen.
  Wanted of_sugar_at(std::uint32_t atom, std::string_view name) const {
    const Wanted wanted = wanted_in(of_sugar, name);
    return name == "C2'" && graph_.heavy_at(atom).size() == 3 ? Wanted{1} : wanted;
  }

  /// Places hydrogens where heavy neighbours leave a tetrahedron or a plane open: a bond to another
  /// residue takes the place of one. None where an atom is missing.
  void place_at(std::uint32_t atom, Wanted wanted) {
    const std::vector<std::uint32_t> heavy = graph_.heavy_at(atom);
    const std::size_t valence = wanted.is_sp2 ? 3 : 4;
    if (heavy.empty() || heavy.size() >= valence || heavy.size() + wanted.count < valence) return;
    const std::vector<Vec3> places = wanted.is_sp2 ? in_plane(atom, heavy) : around(atom, heavy);
    for (std::size_t k = 0; k < places.size(); ++k)
      placed_.push_back(
          {atom, hydrogen_name(structure_.atoms.names[atom], k, wanted.count), places[k]});
  }

  std::vector<Vec3> in_plane(std::uint32_t atom, const std::vector<std::uint32_t>& heavy) const {
    if (heavy.size() != 2) return {};
    return {against_both(at(atom), at(heavy[0]), at(heavy[1]), to_sp2)};
  }

  std::vector<Vec3> around(std::uint32_t atom, const std::vector<std::uint32_t>& heavy) const {
    if (heavy.size() == 1) return methyl(atom, heavy[0]);
    if (heavy.size() == 3)
      return {against_three(at(atom), at(heavy[0]), at(heavy[1]), at(heavy[2]), to_sp3)};
    std::vector<Vec3> places;
    for (double side : {1.0, -1.0})
      places.push_back(out_of_plane(at(atom), at(heavy[0]), at(heavy[1]), to_sp3, side));
    return places;
  }

  /// Staggered against the first heavy atom beyond the neighbour.
  std::vector<Vec3> methyl(std::uint32_t atom, std::uint32_t neighbour) const {
    const std::uint32_t beyond = graph_.first_heavy(neighbour, atom);
    const Vec3 reference =
        beyond != no_atom ? at(beyond)
                          : at(neighbour) + perpendicular_to(unit_vector(at(neighbour) - at(atom)));
    const Spin spin(reference, at(neighbour), at(atom));
    return {spin.at(to_sp3, tetrahedral_angle, 6), spin.at(to_sp3, tetrahedral_angle, 18),
            spin.at(to_sp3, tetrahedral_angle, 30)};
  }

  const Structure& structure_;
  AtomGraph graph_;
  std::vector<PlacedHydrogen> placed_;
};

}  // namespace

std::vector<PlacedHydrogen> place_carbon_hydrogens(const Structure& structure) {
  return CarbonPlacer(structure).place();
}

}  // namespace pliant
