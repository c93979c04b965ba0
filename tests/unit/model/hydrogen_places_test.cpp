// SPDX-License-Identifier: MIT
// Hydrogens and side chains: lengths and angles, and where files of molecules have them.
#include "pliant/model/prepare/hydrogen_places.hpp"

#include "pliant/model/atoms/residue_chemistry.hpp"
#include "pliant/model/prepare/carbon_hydrogens.hpp"
#include "pliant/model/prepare/edit_structure.hpp"
#include "pliant/model/prepare/side_chain.hpp"
#include "pliant/model/prepare/side_chain_geometry.hpp"
#include "support/molecules.hpp"
#include "support/test.hpp"

namespace pliant::hydrogen_places_test {

constexpr double degree = std::numbers::pi / 180.0;

double angle(Vec3 a, Vec3 b, Vec3 c) {
  return std::acos(dot(a - b, c - b) / (distance(a, b) * distance(c, b))) / degree;
}

/// Degrees, from 0 to 360.
double torsion(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 axis = (1.0 / distance(b, c)) * (c - b);
  const Vec3 one = cross(a - b, axis), other = cross(d - c, axis);
  const double turn = std::atan2(dot(cross(one, other), axis), dot(one, other)) / degree;
  return std::fmod(turn + 360.0, 360.0);
}

TEST(HydrogenPlaces, ASpinHasLengthAngleAndTorsion) {
  const Vec3 reference{1.1, 0.3, -0.2}, neighbour{0, 0.2, 0.5}, parent{-0.7, 1.4, 0.9};
  const Spin spin(reference, neighbour, parent);
  for (const auto& [at, degrees] : {std::pair(tetrahedral_angle, 109.5),
                                    std::pair(planar_angle, 120.0), std::pair(thiol_angle, 96.0)})
    for (int tens = 1; tens < 36; ++tens) {
      const Vec3 h = spin.at(1.09, at, tens);
      EXPECT_NEAR(distance(h, parent), 1.09, 1e-12);
      EXPECT_NEAR(angle(h, parent, neighbour), degrees, 1e-9);
      EXPECT_NEAR(torsion(reference, neighbour, parent, h), 10.0 * tens, 1e-9);
    }
}

TEST(HydrogenPlaces, CosinesOfTensAreCosines) {
  for (int tens = -40; tens < 80; ++tens)
    EXPECT_NEAR(cosine_of_tens(tens), std::cos(10.0 * tens * degree), 1e-14) << tens;
}

TEST(HydrogenPlaces, BetweenTwoBonds) {
  const Vec3 parent{1, 1, 1}, one{2.5, 1, 1}, other{1, 2.2, 1};
  const Vec3 back = against_both(parent, one, other, 1.01);
  EXPECT_NEAR(distance(back, parent), 1.01, 1e-12);
  EXPECT_NEAR(angle(back, parent, one), 135.0, 1e-9);
  EXPECT_NEAR(angle(back, parent, other), 135.0, 1e-9);
  const Vec3 up = out_of_plane(parent, one, other, 1.09, 1.0),
             down = out_of_plane(parent, one, other, 1.09, -1.0);
  EXPECT_NEAR(distance(up, parent), 1.09, 1e-12);
  EXPECT_NEAR(angle(up, parent, down), 109.5, 1e-9);
  EXPECT_GT(up.z, 1.0);
  EXPECT_NEAR(up.z + down.z, 2.0, 1e-12);
}

/// Bonds on one line, or of no length, have no direction across: some place is taken.
TEST(HydrogenPlaces, WithoutADirectionSomeIsTaken) {
  EXPECT_EQ(unit_vector({}), (Vec3{0, 0, 1}));
  for (Vec3 u : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0.6, 0, 0.8}}) {
    EXPECT_NEAR(dot(perpendicular_to(u), u), 0.0, 1e-15);
    EXPECT_NEAR(norm(perpendicular_to(u)), 1.0, 1e-15);
  }
  const Vec3 beside = against_both({}, {1, 0, 0}, {-1, 0, 0}, 2.0);
  EXPECT_NEAR(norm(beside), 2.0, 1e-12);
  EXPECT_NEAR(beside.x, 0.0, 1e-12);
  const Vec3 on_line = Spin({2, 0, 0}, {1, 0, 0}, {}).at(1.0, tetrahedral_angle, 0);
  EXPECT_NEAR(norm(on_line), 1.0, 1e-12);
}

Structure whole(const char* file) { return test::bonded(molecule_file(file)); }

Structure without_hydrogens(const Structure& structure) {
  std::vector<bool> is_out;
  for (std::uint8_t element : structure.atoms.elements) is_out.push_back(element == 1);
  return without_atoms(structure, is_out).structure;
}

TEST(CarbonHydrogens, AMethylIsAStaggeredTripod) {
  const Structure bare = without_hydrogens(whole("alanine_dipeptide.pdb"));
  std::map<std::uint32_t, std::vector<Vec3>> of_parent;
  for (const PlacedHydrogen& h : place_carbon_hydrogens(bare))
    of_parent[h.parent].push_back(h.position);
  ASSERT_EQ(of_parent.size(), 4U);  // two caps, CA, CB
  for (const auto& [parent, places] : of_parent) {
    ASSERT_EQ(places.size(), bare.atoms.names[parent] == "CA" ? 1U : 3U);
    for (std::size_t k = 0; k < places.size(); ++k) {
      EXPECT_NEAR(distance(places[k], bare.positions[parent]), 1.09, 1e-12);
      for (std::size_t j = 0; j < k; ++j)
        EXPECT_NEAR(angle(places[k], bare.positions[parent], places[j]), 109.5, 0.2);
    }
  }
}

/// As many as the file has, and as near as ideal angles come; methyls turn alike.
TEST(CarbonHydrogens, AreThoseOfAllTwentyAminoAcids) {
  const Structure file = whole("peptide_20.pdb");
  std::map<std::string, std::vector<Vec3>> expected;
  for (const Bond& bond : file.bonds)
    for (const auto& [h, carbon] : {std::pair(bond.a, bond.b), std::pair(bond.b, bond.a)})
      if (file.atoms.elements[h] == 1 && file.atoms.elements[carbon] == 6)
        expected[file.atoms.label(carbon)].push_back(file.positions[h]);
  const Structure bare = without_hydrogens(file);
  std::map<std::string, std::vector<Vec3>> placed;
  for (const PlacedHydrogen& h : place_carbon_hydrogens(bare))
    placed[bare.atoms.label(h.parent)].push_back(h.position);
  ASSERT_EQ(placed.size(), expected.size());
  for (const auto& [carbon, places] : expected) {
    ASSERT_EQ(placed[carbon].size(), places.size()) << carbon;
    for (Vec3 h : placed[carbon]) {
      double nearest = HUGE_VAL;
      for (Vec3 there : places) nearest = std::min(nearest, distance(h, there));
      EXPECT_LT(nearest, places.size() == 3 ? 0.45 : 0.25) << carbon;
    }
  }
}

TEST(CarbonHydrogens, WhatHasSomeIsLeftAlone) {
  EXPECT_TRUE(place_carbon_hydrogens(whole("peptide_20.pdb")).empty());
  EXPECT_TRUE(place_carbon_hydrogens(without_hydrogens(whole("caffeine.sdf"))).empty());
}

constexpr const char* amino_acids[] = {"ALA", "ARG", "ASN", "ASP", "CYS", "GLN", "GLU",
                                       "GLY", "HIS", "ILE", "LEU", "LYS", "MET", "PHE",
                                       "PRO", "SER", "THR", "TRP", "TYR", "VAL"};

std::set<std::string> words(std::string_view text) {
  std::istringstream in{std::string(text)};
  return {std::istream_iterator<std::string>(in), {}};
}

TEST(SideChainGeometry, EveryAtomButCbHasARow) {
  for (const char* residue : amino_acids) {
    std::set<std::string> expected = words(side_chain_atoms(residue)), found;
    expected.erase("CB");
    for (const SideChainAtom& row : side_chain_geometry(residue)) found.emplace(row.name);
    EXPECT_EQ(found, expected) << residue;
  }
  EXPECT_TRUE(side_chain_geometry("LIG").empty());
}

TEST(SideChainGeometry, RowsAreAfterTheAtomsThatTheyArePlacedBy) {
  for (const char* residue : amino_acids) {
    std::set<std::string_view> known{"N", "CA", "C", "CB"};
    int turns = 0;
    for (const SideChainAtom& row : side_chain_geometry(residue)) {
      for (std::string_view needed : {row.reference, row.neighbour, row.parent})
        EXPECT_TRUE(known.contains(needed)) << residue << " " << row.name << " " << needed;
      known.insert(row.name);
      EXPECT_GT(row.length, 1.2);
      EXPECT_LT(row.length, 1.9);
      EXPECT_GT(row.angle, 100.0);
      EXPECT_LT(row.angle, 135.0);
      turns = std::max<int>(turns, row.chi);
    }
    EXPECT_EQ(usual_turns(residue).empty(), turns == 0) << residue;
  }
}

/// CB of a file, which is left out, comes back near where it was, and on the side of L amino acids.
TEST(SideChainGeometry, CbLiesWhereLAminoAcidsHaveIt) {
  const Structure file = whole("peptide_20.pdb");
  const ResidueAtoms residues(file.atoms);
  for (std::size_t r = 0; r < file.atoms.residues.size(); ++r) {
    const std::uint32_t cb = residues.find(r, "CB");
    if (cb == no_atom) continue;
    const auto at = [&](const char* name) { return file.positions[residues.find(r, name)]; };
    const Vec3 ideal = ideal_cb(at("N"), at("CA"), at("C"));
    EXPECT_LT(distance(ideal, file.positions[cb]), 0.3) << file.atoms.residues[r].name;
    EXPECT_NEAR(distance(ideal, at("CA")), 1.53, 0.02);
  }
}

/// Side chains are built to CB, and then to their ends, with the lengths of their rows.
TEST(SideChain, AtomsThatAreMissingGetTheLengthsOfTheirRows) {
  const Structure file = whole("peptide_20.pdb");
  std::vector<bool> is_out;
  for (std::size_t k = 0; k < file.size(); ++k) {
    const std::string& name = file.atoms.names[k];
    is_out.push_back(file.atoms.elements[k] == 1 || !words("N CA C O OXT CB").contains(name));
  }
  const Structure bare = without_atoms(file, is_out).structure;
  const ResidueAtoms residues(bare.atoms);
  for (std::uint32_t r = 0; r < bare.atoms.residues.size(); ++r) {
    SideChain chain(bare, residues, r);
    SCOPED_TRACE(bare.atoms.residues[r].name);
    EXPECT_TRUE(chain.can_be_built());
    const auto missing = chain.missing();
    if (missing.empty()) continue;
    const auto placed = chain.placed(chain.turns().empty() ? SideChainTurns{} : chain.turns()[0]);
    ASSERT_EQ(placed.size(), missing.size());
    for (const SideChainAtom& row : chain.rows()) {
      const auto place_of = [&](std::string_view name) {
        const auto at = std::find(missing.begin(), missing.end(), name);
        return at == missing.end()
                   ? bare.positions[residues.find(r, name)]
                   : placed[static_cast<std::size_t>(at - missing.begin())].position;
      };
      EXPECT_NEAR(distance(place_of(row.name), place_of(row.parent)), row.length,
                  chain.is_proline() ? 0.2 : 1e-9)
          << row.name;
    }
  }
}

}  // namespace pliant::hydrogen_places_test
