// SPDX-License-Identifier: MIT
#include "pliant/molecule/selection.hpp"

#include "pliant/base/printable.hpp"
#include "pliant/molecule/bond_lengths.hpp"
#include "pliant/molecule/structure/residue_templates.hpp"
#include "support/test.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::selection_test {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

/// 0-3 ACE, 4-8 ALA -1, 9-11 water 5, 12 chloride 5A, 13-14 adenosine 7.
AtomTable atoms() {
  Structure s;
  add_residue(s, "ACE", -2, {{"CH3", "C", {}}, {"HH31", "H", {}}, {"C", "C", {}}, {"O", "O", {}}});
  add_residue(s, "ALA", -1,
              {{"N", "N", {}}, {"CA", "C", {}}, {"CB", "C", {}}, {"C", "C", {}}, {"O", "O", {}}});
  add_residue(s, "HOH", 5, {{"O", "O", {}}, {"H1", "H", {}}, {"H2", "H", {}}}, "W");
  add_residue(s, "CL", 5, {{"CL", "Cl", {}}}, "W");
  s.atoms.residues.back().insertion_code = 'A';
  add_residue(s, "DA", 7, {{"P", "P", {}}, {"O5'", "O", {}}}, "B1");
  return s.atoms;
}

std::vector<std::uint32_t> selected(std::string_view text) { return select_atoms(atoms(), text); }

TEST(Selection, KnowsKindsOfResidues) {
  EXPECT_EQ(selected("all").size(), 15U);
  EXPECT_THAT(selected("none"), IsEmpty());
  EXPECT_THAT(selected("protein"), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
  EXPECT_THAT(selected("backbone"), ElementsAre(2, 3, 4, 5, 7, 8));
  EXPECT_THAT(selected("water"), ElementsAre(9, 10, 11));
  EXPECT_THAT(selected("nucleic"), ElementsAre(13, 14));
}

TEST(Selection, KnowsNamesWithWildcards) {
  EXPECT_THAT(selected("name CA CB"), ElementsAre(5, 6));
  EXPECT_THAT(selected("name C*"), ElementsAre(0, 2, 5, 6, 7, 12));
  EXPECT_THAT(selected("name C?"), ElementsAre(5, 6, 12));
  EXPECT_THAT(selected("name *3*1"), ElementsAre(1));
  EXPECT_THAT(selected("name O5'"), ElementsAre(14));
  EXPECT_THAT(selected("name ca"), IsEmpty());
  EXPECT_THAT(selected("element CL h"), ElementsAre(1, 10, 11, 12));
  EXPECT_THAT(selected("resname D?"), ElementsAre(13, 14));
  EXPECT_THAT(selected("chainID W"), ElementsAre(9, 10, 11, 12));
  EXPECT_THAT(selected("segid B*"), ElementsAre(13, 14));
  EXPECT_THAT(selected("name \\all"), IsEmpty());
}

TEST(Selection, KnowsNumbersAndRanges) {
  EXPECT_THAT(selected("resid 5"), ElementsAre(9, 10, 11));
  EXPECT_THAT(selected("resid 5A"), ElementsAre(12));
  EXPECT_THAT(selected("resid -1"), ElementsAre(4, 5, 6, 7, 8));
  EXPECT_THAT(selected("resid -2--1"), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
  EXPECT_THAT(selected("resid -1:5"), ElementsAre(4, 5, 6, 7, 8, 9, 10, 11));
  EXPECT_THAT(selected("resid 5-5A 7"), ElementsAre(9, 10, 11, 12, 13, 14));
  EXPECT_THAT(selected("index 0-2 14"), ElementsAre(0, 1, 2, 14));
  EXPECT_THAT(selected("bynum 1:3"), ElementsAre(0, 1, 2));
  EXPECT_THAT(selected("index 400"), IsEmpty());
}

TEST(Selection, CombinesFromLeftToRightWithNotFirst) {
  EXPECT_THAT(selected("protein and not name C*"), ElementsAre(1, 3, 4, 8));
  EXPECT_THAT(selected("water or protein and name O"), ElementsAre(3, 8, 9));
  EXPECT_THAT(selected("water or (protein and name O)"), ElementsAre(3, 8, 9, 10, 11));
  EXPECT_THAT(selected("not (water or protein) and not element Cl"), ElementsAre(13, 14));
  EXPECT_THAT(selected("not not water"), ElementsAre(9, 10, 11));
  EXPECT_THAT(selected(" (name P) "), ElementsAre(13));
}

TEST(Selection, IsNotDepthLimited) {
  const std::string deep(200000, '(');
  EXPECT_THAT(selected(deep + "water" + std::string(200000, ')')), ElementsAre(9, 10, 11));
}

std::string refusal(std::string_view text) {
  return test::error_text<OptionError>([&] { selected(text); });
}

TEST(Selection, SaysWhatItCannotUnderstand) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "expected a word that selects atoms, found the end at character 1"},
      {"nam CA",
       "expected a word that selects atoms (did you mean \"name\"?), found \"nam\" at character 1"},
      {"protein water", "expected \"and\", \"or\" or the end, found \"water\" at character 9"},
      {"name and water", "\"name\" needs names, found \"and\" at character 6"},
      {"resid", "\"resid\" needs numbers and ranges, found the end at character 6"},
      {"resid 3x-",
       "\"resid\" takes numbers and ranges such as 3-8 or 3:8, found \"3x-\" at character 7"},
      {"index 1.5",
       "\"index\" takes numbers and ranges such as 3-8 or 3:8, found \"1.5\" at character 7"},
      {"index 8-3",
       "a range goes from the lower number to the higher, found \"8-3\" at character 7"},
      {"name C[AB]", "a name may hold * and ? but no brackets, found \"C[AB]\" at character 6"},
      {"(water", "the parenthesis at character 1 is not closed"},
      {"water)", "no parenthesis is open, found \")\" at character 6"},
      {"not", "expected a word that selects atoms, found the end at character 4"},
      {"name \x1b[2J",
       "a name may hold * and ? but no brackets, found \"\\x1b[2J\" at character 6"}};
  for (const auto& [text, fault] : cases)
    EXPECT_EQ(refusal(text), "selection " + quoted(text) + ": " + fault);
}

TEST(Selection, ListsItsWords) {
  for (const SelectionWord& word : selection_words()) {
    EXPECT_FALSE(word.summary.empty()) << word.name;
    if (word.name == "id") continue;  // of a graph
    const std::string values = word.values.empty() ? "" : " 1";
    EXPECT_NO_THROW(selected(std::string(word.name) + values)) << word.name;
  }
}

TEST(Selection, AGraphHasIdsAndAMoleculeHasNone) {
  AtomTable joints{{"A", "B", "5"}, {0, 0, 0}, {0, 0, 0}, {{"", 1, ' ', ""}}, {1, 2, 3}};
  EXPECT_EQ(select_atoms(joints, "id A 5"), (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(select_atoms(joints, "not id A"), (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(refusal("not id 5"),
            "selection \"not id 5\": atoms have a name, an index (from 0) and a bynum (from 1), "
            "joints of a graph an id, found \"id\" at character 5");
}

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

}  // namespace pliant::selection_test
