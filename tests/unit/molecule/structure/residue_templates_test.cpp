// SPDX-License-Identifier: MIT
#include "pliant/molecule/structure/residue_templates.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "pliant/molecule/bond_lengths.hpp"

namespace pliant {
namespace residue_templates_test {

bool is_bonded(const char* residue, const char* a, const char* b) {
  const ResidueTemplate* shape = find_residue_template(residue);
  if (shape == nullptr) return false;
  const int i = shape->find(atom_key(a, false)), j = shape->find(atom_key(b, false));
  if (i == ResidueTemplate::none || j == ResidueTemplate::none) return false;
  for (const ResidueTemplate::Edge& edge : shape->edges)
    if ((edge.a == i && edge.b == j) || (edge.a == j && edge.b == i)) return true;
  return false;
}

TEST(AtomKey, IsOneForEachSpelling) {
  EXPECT_EQ(atom_key("1HB", true), atom_key("HB1", true));
  EXPECT_EQ(atom_key("2HD1", true), atom_key("HD12", true));
  EXPECT_EQ(atom_key("C1*", false), atom_key("C1'", false));
  EXPECT_EQ(atom_key("DB1", true), atom_key("HB1", true));
  EXPECT_NE(atom_key("DB1", false), atom_key("HB1", false));
  EXPECT_NE(atom_key("CA", false), atom_key("AC", false));
  EXPECT_EQ(atom_key("", false), 0U);
  EXPECT_EQ(atom_key("TOOLONGNAME", false), 0U);
  EXPECT_NE(atom_key("12345678", false), 0U);
}

TEST(ResidueTemplates, AreFoundByEveryProgramsNames) {
  for (const char* name :
       {"ALA", "HID", "HIE", "HIP",  "HSD",  "HSE",  "HSP",  "CYX",  "CYM", "ASH",
        "GLH", "LYN", "MSE", "NALA", "CALA", "CHIE", "NCYX", "ACE",  "NME", "NH2",
        "DA",  "DA5", "DT3", "A",    "RU",   "HOH",  "WAT",  "TIP3", "SOL"})
    EXPECT_NE(find_residue_template(name), nullptr) << name;
  for (const char* name : {"", "ala", "XALA", "NACE", "LIG", "NWAT", "UNK", "ALAA"})
    EXPECT_EQ(find_residue_template(name), nullptr) << name;
}

TEST(ResidueTemplates, KnowAliases) {
  EXPECT_TRUE(is_bonded("ILE", "CG1", "CD1"));
  EXPECT_TRUE(is_bonded("ILE", "CG1", "CD"));
  EXPECT_TRUE(is_bonded("ILE", "CD", "3HD"));
  EXPECT_TRUE(is_bonded("VAL", "CG2", "2HG2"));
  EXPECT_TRUE(is_bonded("GLY", "N", "HN"));
  EXPECT_TRUE(is_bonded("GLY", "N", "HT3"));
  EXPECT_TRUE(is_bonded("GLY", "C", "OT2"));
  EXPECT_TRUE(is_bonded("GLY", "C", "O1"));
  EXPECT_TRUE(is_bonded("A", "C2*", "O2*"));
  EXPECT_TRUE(is_bonded("T", "C5", "C5M"));
  EXPECT_TRUE(is_bonded("NHIS", "NE2", "HE2"));
  EXPECT_FALSE(is_bonded("PHE", "CD1", "CE2"));
  EXPECT_FALSE(is_bonded("HOH", "H1", "H2"));
}

TEST(ResidueTemplates, NameEachBondOnce) {
  for (const std::string_view name : residue_template_names()) {
    const ResidueTemplate& shape = *find_residue_template(name);
    std::set<std::pair<int, int>> pairs;
    for (const ResidueTemplate::Edge& edge : shape.edges) {
      EXPECT_NE(edge.a, edge.b) << name;
      EXPECT_TRUE(pairs.insert(std::minmax<int>(edge.a, edge.b)).second)
          << name << " " << int{edge.a} << " " << int{edge.b};
      EXPECT_GE(edge.order, 1);
      EXPECT_LE(edge.order, 4);
    }
  }
}

TEST(StandardBondLength, KnowsPairsInEitherOrder) {
  EXPECT_EQ(standard_bond_length(6, 8, 2), 1.21);
  EXPECT_EQ(standard_bond_length(8, 6, 2), 1.21);
  EXPECT_EQ(standard_bond_length(1, 6, 0), 1.09);
  EXPECT_EQ(standard_bond_length(6, 6, 0), std::nullopt);
  EXPECT_EQ(standard_bond_length(6, 26, 1), std::nullopt);
}

}  // namespace residue_templates_test
}  // namespace pliant
