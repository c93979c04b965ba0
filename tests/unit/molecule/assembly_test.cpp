// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/shared/assembly.hpp"

#include <ctime>

#include "pliant/molecule/read/read.hpp"
#include "pliant/molecule/read/shared/altlocs.hpp"
#include "support/test.hpp"

namespace pliant::assembly_test {

/// Two chains and a water of A; one assembly of both chains turned by half about z, one of B alone.
const std::string pdb_head =
    "REMARK 350 BIOMOLECULE: 1\n"
    "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A,\n"
    "REMARK 350                    AND CHAINS: B\n"
    "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n"
    "REMARK 350   BIOMT1   2 -1.000000  0.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT2   2  0.000000 -1.000000  0.000000        5.00000\n"
    "REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000\n"
    "REMARK 350 BIOMOLECULE: 2\n"
    "REMARK 350 APPLY THE FOLLOWING TO CHAINS: B\n"
    "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        1.50000\n"
    "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n";
const std::string pdb_atoms =
    "ATOM      1  N   GLY A   1       1.000   2.000   3.000  1.00  0.00           N\n"
    "ATOM      2  CA  GLY A   1       2.400   2.000   3.000  1.00  0.00           C\n"
    "TER       3      GLY A   1\n"
    "ATOM      4  N   GLY B   1       9.000   2.000   3.000  1.00  0.00           N\n"
    "ATOM      5  CA  GLY B   1       9.000   3.400   3.000  1.00  0.00           C\n"
    "TER       6      GLY B   1\n"
    "HETATM    7 ZN    ZN A   2       0.000   2.500   8.000  1.00  0.00          ZN\n"
    "CONECT    1    2\n";

Structure read(const std::string& text, const std::string& assembly,
               const std::string& name = "m.pdb", const Log& log = {}) {
  return read_structure(SourceText{name, text}, {.assembly = assembly, .log = log});
}

std::vector<std::string> chains_of(const Structure& structure) {
  std::vector<std::string> chains;
  for (const Residue& residue : structure.atoms.residues) chains.push_back(residue.chain);
  return chains;
}

TEST(Assembly, FilesSayWhichTheyState) {
  const Structure structure = read(pdb_head + pdb_atoms, "");
  EXPECT_EQ(structure.assemblies, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(structure.size(), 5U);
  EXPECT_TRUE(read(pdb_atoms, "").assemblies.empty());
}

TEST(Assembly, CopiesAreTurnedAndShifted) {
  std::string said;
  const Structure made = read(pdb_head + pdb_atoms, "1", "m.pdb",
                              {[&](Severity, std::string_view text) { (said += text) += "\n"; }});
  // The zinc is on the axis: it is there once.
  ASSERT_EQ(made.size(), 9U);
  EXPECT_EQ(chains_of(made), (std::vector<std::string>{"A", "B", "A", "C", "D"}));
  EXPECT_EQ(made.positions[5], (Vec3{-1.0, 3.0, 3.0}));
  EXPECT_EQ(made.positions[8], (Vec3{-9.0, 5.0 - 3.4, 3.0}));
  EXPECT_EQ(made.bonds, (std::vector<Bond>{{0, 1}, {5, 6}}));
  EXPECT_EQ(made.chain_end, (std::vector<bool>{true, true, true, true, true}));
  EXPECT_EQ(made.atoms.serials, (std::vector<std::int64_t>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(made.source, "m.pdb");
  EXPECT_EQ(
      said,
      "m.pdb: assembly 1: 9 atoms by 2 motions; chain \"A\" is A and C; \"B\" is B and D\n"
      "m.pdb: assembly 1: 1 copy of an atom left out that would lie on the atom itself, as on "
      "an axis of symmetry\n");
}

TEST(Assembly, ChainsThatItLeavesOutAreOut) {
  const Structure made = read(pdb_head + pdb_atoms, "2");
  ASSERT_EQ(made.size(), 2U);
  EXPECT_EQ(chains_of(made), std::vector<std::string>{"B"});
  EXPECT_EQ(made.positions[0], (Vec3{10.5, 2.0, 3.0}));
  EXPECT_EQ(made.atoms.serials, (std::vector<std::int64_t>{4, 5}));
}

TEST(Assembly, WhatIsNotStatedIsRefused) {
  const auto fault = [](const std::string& text, const std::string& name) {
    return test::error_text<OptionError>([&] { read(text, "3", name); });
  };
  EXPECT_EQ(fault(pdb_head + pdb_atoms, "m.pdb"), "no assembly \"3\" in m.pdb: it states 1, 2");
  EXPECT_EQ(fault(pdb_atoms, "m.pdb"), "no assembly \"3\" in m.pdb: it states none");
  EXPECT_EQ(fault("1\nx\nH 0 0 0\n", "m.xyz"), "no assembly \"3\" in m.xyz: it states none");
}

TEST(Assembly, ABrokenRemarkIsNamedWhereItIsNeeded) {
  const auto fault = [](const std::string& from, const std::string& to) {
    std::string text = pdb_head + pdb_atoms;
    text.replace(text.find(from), from.size(), to);
    EXPECT_EQ(read(text, "").size(), 5U);
    return test::error_text<InputError>([&] { read(text, "1"); });
  };
  EXPECT_EQ(fault("0.000000  1.000000  0.000000        0.00000\nREMARK 350   BIOMT3   1",
                  "0.0 1.0\nREMARK 350   BIOMT3   1"),
            "m.pdb:5: REMARK 350: BIOMT2: expected a number and four values, found 3 words");
  EXPECT_EQ(fault("  BIOMT2   1", "  BIOMT3   1"),
            "m.pdb:5: REMARK 350: expected BIOMT2, found \"BIOMT3\"");
  EXPECT_EQ(fault("5.00000", "5,00000"),
            "m.pdb:8: REMARK 350: BIOMT: expected a number, found \"5,00000\"");
  EXPECT_EQ(fault("APPLY THE FOLLOWING TO CHAINS: A,", "THE"),
            "");  // AND CHAINS: B alone
  EXPECT_EQ(fault("REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000\n", ""),
            "m.pdb:8: REMARK 350: expected three rows BIOMT1, BIOMT2 and BIOMT3, found fewer");
}

TEST(Assembly, ACopyOfNoChainIsTold) {
  std::string text = pdb_head + pdb_atoms;
  const std::string from =
      "CHAINS: B\nREMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        1";
  text.replace(text.find(from), 9, "CHAINS: X");
  EXPECT_ERROR(InputError, "m.pdb: assembly 2: none of its chains has atoms", read(text, "2"));
}

/// The same two chains as mmCIF, with operations of which 2 turns by half about z.
std::string cif(const std::string& expression, const std::string& asyms = "A,C") {
  std::string text =
      "data_M\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n"
      "_atom_site.label_atom_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n"
      "_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
      "_atom_site.Cartn_z\n"
      "ATOM 1 N N GLY A H 1 1 2 3\nATOM 2 C CA GLY A H 1 2.4 2 3\n"
      "ATOM 3 N N GLY B L 1 9 2 3\nHETATM 4 O O HOH C H 99 5 5 5\n"
      "_pdbx_struct_assembly_gen.assembly_id PAU\n_pdbx_struct_assembly_gen.oper_expression ";
  text += "'" + expression + "'\n_pdbx_struct_assembly_gen.asym_id_list '" + asyms + "'\n";
  text += "loop_\n_pdbx_struct_oper_list.id\n";
  for (const char row : {'1', '2', '3'}) {
    for (const char column : {'1', '2', '3'})
      text += std::string("_pdbx_struct_oper_list.matrix[") + row + "][" + column + "]\n";
    text += std::string("_pdbx_struct_oper_list.vector[") + row + "]\n";
  }
  return text +
         "1 1 0 0 0 0 1 0 0 0 0 1 0\n2 -1 0 0 0 0 -1 0 0 0 0 1 0\n"
         "3 1 0 0 10 0 1 0 0 0 0 1 0\nX0 0 -1 0 100 1 0 0 0 0 0 1 0\n";
}

TEST(Assembly, InstancesOfMmcifAreNotTheAuthorsChains) {
  const Structure made = read(cif("1,2"), "PAU", "m.cif");
  EXPECT_EQ(made.assemblies, std::vector<std::string>{"PAU"});
  ASSERT_EQ(made.size(), 6U);  // without B, whose author calls it L
  EXPECT_EQ(chains_of(made), (std::vector<std::string>{"H", "H", "A", "A"}));
  EXPECT_EQ(made.positions[3], (Vec3{-1.0, -2.0, 3.0}));
}

TEST(Assembly, ExpressionsAreListsRangesAndProducts) {
  const auto first_atoms = [](const std::string& expression) {
    std::vector<Vec3> at;
    const Structure made = read(cif(expression, "B"), "PAU", "m.cif");
    for (const Vec3 x : made.positions) at.push_back(x);
    return at;
  };
  const Vec3 x{9, 2, 3}, turned{-9, -2, 3}, shifted{19, 2, 3};
  EXPECT_EQ(first_atoms("(1-3)"), (std::vector<Vec3>{x, turned, shifted}));
  EXPECT_EQ(first_atoms("1-3"), (std::vector<Vec3>{x, turned, shifted}));
  EXPECT_EQ(first_atoms("(1,3)"), (std::vector<Vec3>{x, shifted}));
  EXPECT_EQ(first_atoms("2, 1"), (std::vector<Vec3>{turned, x}));
  // The last acts first: 3 shifts, then X0 turns by a quarter and shifts.
  EXPECT_EQ(first_atoms("(X0)(1,3)"), (std::vector<Vec3>{{98, 9, 3}, {98, 19, 3}}));
  EXPECT_EQ(first_atoms("(3)(X0)"), (std::vector<Vec3>{{108, 9, 3}}));
  EXPECT_EQ(first_atoms("1,(2)(3)"), (std::vector<Vec3>{x, {-19, -2, 3}}));
}

TEST(Assembly, AWrongExpressionIsTold) {
  const auto fault = [](const std::string& expression) {
    return test::error_text<InputError>([&] { read(cif(expression), "PAU", "m.cif"); });
  };
  EXPECT_EQ(fault("1,9"),
            "m.cif:18: oper_expression: there is no operation \"9\" in pdbx_struct_oper_list");
  EXPECT_EQ(fault("(1)(2"),
            "m.cif:18: oper_expression: expected lists in parentheses, found \"(1)(2\"");
  EXPECT_EQ(fault("1-999999999"), "m.cif:18: oper_expression: expected at most 10000 operations");
  EXPECT_EQ(fault("(1-3)(1-3)(1-3)(1-3)(1-3)(1-3)(1-3)(1-3)(1-3)"),
            "m.cif:18: oper_expression: expected at most 10000 operations");
}

/// One letter an atom: 'x' where it stays, '-' where it goes.
std::string kept(const std::vector<AltlocAtom>& atoms) {
  std::string text;
  for (bool stays : choose_altlocs(atoms)) text += stays ? 'x' : '-';
  return text;
}

TEST(Conformers, OneOfAResidueIsKept) {
  const std::pair<const char*, std::vector<AltlocAtom>> cases[] = {
      {"-x", {{"CA", 'A', 0.4F}, {"CA", 'B', 0.6F}}},
      // B wins one name, A the mean: all atoms come from A.
      {"x-x-", {{"CA", 'A', 0.4F}, {"CA", 'B', 0.6F}, {"CB", 'A', 0.9F}, {"CB", 'B', 0.1F}}},
      // The first on a tie.
      {"x-", {{"CA", 'B', 0.5F}, {"CA", 'A', 0.5F}}},
      {"x-", {{"CA", 'A', 0.0F}, {"CA", 'B', 0.0F}}},
      // Atoms of other conformers go with them.
      {"x--", {{"CA", 'A', 0.6F}, {"CA", 'B', 0.4F}, {"OG", 'B', 0.4F}}},
      // Those that share no name both stay.
      {"xx", {{"CA", 'A', 0.5F}, {"OG", 'C', 0.1F}}},
      {"x--x", {{"CA", 'A', 0.5F}, {"CA", 'B', 0.4F}, {"OG", 'C', 0.1F}, {"OG", 'D', 0.2F}}},
      // Atoms without one stay unless their name is chosen.
      {"xx", {{"N", ' ', 1.0F}, {"CA", 'A', 0.3F}}},
      {"x-x", {{"CA", ' ', 0.7F}, {"CA", 'B', 0.3F}, {"N", ' ', 1.0F}}},
      {"-xx", {{"CA", ' ', 0.3F}, {"CA", 'B', 0.7F}, {"N", ' ', 0.1F}}}};
  for (const auto& [letters, atoms] : cases) EXPECT_EQ(kept(atoms), letters);
}

TEST(Conformers, ManyAtomsInLittleTime) {
  std::vector<std::string> names;
  for (int k = 0; k < 200'000; ++k) names.push_back(std::to_string(k / 2));
  std::vector<AltlocAtom> atoms;
  for (std::size_t k = 0; k < names.size(); ++k)
    atoms.push_back({names[k], k % 2 == 0 ? 'A' : 'B', k % 2 == 0 ? 0.4F : 0.6F});
  const std::clock_t begin = std::clock();  // of this process: others may be busy
  const std::vector<bool> stays = choose_altlocs(atoms);
  EXPECT_LT(std::clock() - begin, 10 * CLOCKS_PER_SEC);
  for (std::size_t k = 0; k < stays.size(); ++k) ASSERT_EQ(stays[k], k % 2 == 1);
}

}  // namespace pliant::assembly_test
