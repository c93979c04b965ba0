// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/polar_atoms.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/jobs/sampled_molecules.hpp"

namespace pliant {
namespace polar_atoms_test {

struct Polar {
  explicit Polar(const char* file)
      : model(test::model_of(file)), graph(model.structure), atoms(model.structure, graph) {}
  std::uint32_t find(const char* residue, const char* name) const {
    const AtomTable& table = model.structure.atoms;
    for (std::uint32_t k = 0; k < table.size(); ++k)
      if (table.residues[table.residue_of[k]].name == residue && table.names[k] == name) return k;
    return no_atom;
  }
  MolecularModel model;
  AtomGraph graph;
  PolarAtoms atoms;
};

TEST(PolarAtoms, OfAspirin) {
  const Polar at("aspirin.sdf");
  EXPECT_EQ(at.atoms.hydrogens().size(), 1U);  // of the acid
  EXPECT_EQ(at.atoms.acceptors().size(), 4U);
}

TEST(PolarAtoms, HybridisationOfAPeptide) {
  const Polar at("peptide_20.pdb");
  const auto is_sp3 = [&](const char* residue, const char* atom) {
    return at.atoms.hybridisation(at.find(residue, atom)) == Hybridisation::sp3;
  };
  EXPECT_TRUE(is_sp3("SER", "OG"));
  EXPECT_TRUE(is_sp3("LYS", "NZ"));
  EXPECT_FALSE(is_sp3("TYR", "OH"));
  EXPECT_FALSE(is_sp3("ALA", "O"));
  EXPECT_FALSE(is_sp3("ALA", "N"));
}

TEST(PolarAtoms, ChargesOfAPeptide) {
  const Polar at("peptide_20.pdb");
  EXPECT_TRUE(at.atoms.is_positive(at.find("LYS", "NZ")));
  EXPECT_TRUE(at.atoms.is_positive(at.find("ARG", "NH1")));
  EXPECT_FALSE(at.atoms.is_positive(at.find("ALA", "N")));
  EXPECT_FALSE(at.atoms.is_positive(at.find("GLN", "NE2")));
  EXPECT_TRUE(at.atoms.is_negative(at.find("ASP", "OD1")));
  EXPECT_TRUE(at.atoms.is_negative(at.find("GLU", "OE2")));
  EXPECT_FALSE(at.atoms.is_negative(at.find("ASN", "OD1")));
  EXPECT_FALSE(at.atoms.is_negative(at.find("SER", "OG")));
}

TEST(PolarAtoms, APlaneIsAcrossItsBonds) {
  const Polar at("peptide_20.pdb");
  const std::uint32_t n = at.find("ALA", "N");
  const Vec3 normal = at.atoms.plane(n);
  const auto bonds = at.graph.at(n);
  const auto& x = at.model.structure.positions;
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec3 along = x[bonds[k].node] - x[n];
    EXPECT_NEAR(dot(normal, along) / (norm(normal) * norm(along)), 0.0, 1e-12);
  }
}

}  // namespace polar_atoms_test
}  // namespace pliant
