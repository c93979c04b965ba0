// SPDX-License-Identifier: MIT
#include "pliant/record/topology_pdb.hpp"

#include "pliant/molecule/read/read.hpp"
#include "pliant/record/pdb_recorder.hpp"
#include "support/test.hpp"
#include "unit/record/samples.hpp"

namespace pliant::topology_pdb_test {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;

AtomTable one_residue(std::size_t count) {
  AtomTable atoms;
  for (std::size_t i = 0; i < count; ++i) {
    atoms.names.push_back("C" + std::to_string(i + 1));
    atoms.elements.push_back(6);
    atoms.residue_of.push_back(0);
    atoms.serials.push_back(1);
  }
  atoms.residues = {{"UNL", 1, ' ', ""}};
  return atoms;
}

class TopologyPdbTest : public FileTest {
 protected:
  std::string write(const AtomTable& atoms, const std::vector<Vec3>& positions,
                    const std::vector<RecordedBond>& bonds, TopologyPdbOptions options = {}) {
    options.overwrite = true;
    options.log.function = [this](Severity, std::string_view text) {
      messages_.emplace_back(text);
    };
    write_topology_pdb(path_, atoms, positions, bonds, options);
    return content_of(path_);
  }

  std::vector<std::string> messages_;
};

TEST_F(TopologyPdbTest, WritesTheColumnsOfTheFormat) {
  const AtomTable atoms{
      {"CA", "CA", "HB11", "N", "FE"},
      {6, 20, 1, 7, 26},
      {0, 1, 2, 3, 3},
      {{"ALA", -12, ' ', "A"}, {"CA", 10000, 'B', "A"}, {"TIP3", 3, ' ', "B"}, {"HEM", 1, ' ', ""}},
      {7, 8, 9, 10, 11}};
  const std::string text =
      write(atoms, {{0, 1.5, -2.25}, {9999.999, -999.999, 0}, {1, 2, 3}, {0, 0, -1e-9}, {4, 5, 6}},
            {{0, 1, 0, 1}, {3, 4, 0, 2}}, {.title = "two\nlines"});
  // clang-format off
  EXPECT_EQ(text,
      "TITLE     two_lines\n"
      "ATOM      1  CA  ALA A -12       0.000   1.500  -2.250  1.00  0.00           C\n"
      "HETATM    2 CA    CA AA000B   9999.999-999.999   0.000  1.00  0.00          CA\n"
      "TER\n"
      "HETATM    3 HB11 TIP3B   3       1.000   2.000   3.000  1.00  0.00           H\n"
      "TER\n"
      "HETATM    4  N   HEM     1       0.000   0.000  -0.000  1.00  0.00           N\n"
      "HETATM    5 FE   HEM     1       4.000   5.000   6.000  1.00  0.00          FE\n"
      "CONECT    1    2\n"
      "CONECT    2    1\n"
      "CONECT    4    5    5\n"
      "CONECT    5    4    4\n"
      "END\n");
  // clang-format on
  EXPECT_TRUE(messages_.empty());
}

TEST_F(TopologyPdbTest, ListsFourBondsARecord) {
  std::vector<RecordedBond> bonds;
  for (Joint other = 5; other > 0; --other) bonds.push_back({0, other, 0, 1});
  EXPECT_THAT(write(one_residue(6), std::vector<Vec3>(6), bonds),
              HasSubstr("CONECT    1    2    3    4    5\nCONECT    1    6\nCONECT    2    1\n"));
}

// Known values: cci.lbl.gov/hybrid_36.
TEST(Hybrid36, ContinuesDecimals) {
  EXPECT_EQ(hybrid36(0, 5), "    0");
  EXPECT_EQ(hybrid36(-9999, 5), "-9999");
  EXPECT_EQ(hybrid36(99999, 5), "99999");
  EXPECT_EQ(hybrid36(100000, 5), "A0000");
  EXPECT_EQ(hybrid36(100035, 5), "A000Z");
  EXPECT_EQ(hybrid36(43770015, 5), "ZZZZZ");
  EXPECT_EQ(hybrid36(43770016, 5), "a0000");
  EXPECT_EQ(hybrid36(87440031, 5), "zzzzz");
  EXPECT_EQ(hybrid36(9999, 4), "9999");
  EXPECT_EQ(hybrid36(10000, 4), "A000");
  EXPECT_EQ(hybrid36(1223055, 4), "ZZZZ");
  EXPECT_EQ(hybrid36(2436111, 4), "zzzz");
  EXPECT_ERROR(InputError, "87440032 does not fit 5 columns", hybrid36(87440032, 5));
  EXPECT_ERROR(InputError, "-1000 does not fit 4 columns", hybrid36(-1000, 4));
}

TEST_F(TopologyPdbTest, OurReaderReadsItBack) {
  const std::size_t count = 100'010;
  AtomTable atoms = one_residue(count);
  std::vector<Vec3> positions;
  std::vector<RecordedBond> bonds;
  for (std::size_t i = 0; i < count; ++i) {
    atoms.names[i] = "C" + std::to_string(i % 9);
    atoms.residue_of[i] = static_cast<std::uint32_t>(i / 9);
    positions.push_back({double(i % 1000), double(i / 1000), 0.125});
    if (i > 0) bonds.push_back({Joint(i - 1), Joint(i), 0, 1});
  }
  atoms.residues.clear();
  for (std::int64_t r = 0; r <= std::int64_t(count / 9); ++r)
    atoms.residues.push_back({"UNL", r + 1, ' ', "X"});
  write(atoms, positions, bonds, {.hybrid36_bonds = true});
  const Structure read = read_structure(path_);
  ASSERT_EQ(read.size(), count);
  EXPECT_EQ(read.atoms.names, atoms.names);
  EXPECT_EQ(read.atoms.elements, atoms.elements);
  EXPECT_EQ(read.atoms.residues, atoms.residues);
  EXPECT_EQ(read.atoms.serials.back(), std::int64_t(count));
  EXPECT_EQ(read.positions.back(), positions.back());
  ASSERT_EQ(read.bonds.size(), bonds.size());
  EXPECT_EQ(read.bonds.back().b, count - 1);
}

TEST_F(TopologyPdbTest, LeavesOutBondsThatMDAnalysisStopsAt) {
  const std::size_t count = 100'001;
  const std::string text = write(one_residue(count), std::vector<Vec3>(count),
                                 {{0, 1, 0, 1}, {99'998, 99'999, 0, 1}, {5, 100'000, 0, 1}});
  EXPECT_THAT(text, HasSubstr("HETATMA0001 "));
  EXPECT_THAT(text, HasSubstr("CONECT    1    2\nCONECT    2    1\nEND\n"));
  EXPECT_THAT(
      messages_,
      ElementsAre(path_.string() + ": atom names cut to four characters: 99002",
                  path_.string() +
                      ": bonds of atoms past 99,999 left out, as MDAnalysis stops at them: 2"));
}

TEST_F(TopologyPdbTest, CutsNamesAndSaysSoOnce) {
  AtomTable atoms = one_residue(2);
  atoms.names = {"C12345", "O 1\n"};
  atoms.residues = {{"LIGAND", 1, ' ', "AXP"}};
  const std::string text = write(atoms, std::vector<Vec3>(2), {});
  EXPECT_THAT(text, HasSubstr("HETATM    1 C123 LIGAA   1       0.000   0.000   0.000  1.00  0.00"
                              "      AXP  C\n"));
  EXPECT_THAT(text, HasSubstr("HETATM    2 O_1_ LIGA"));
  const std::string name = path_.string();
  EXPECT_THAT(messages_,
              ElementsAre(name + ": atom names cut to four characters: 1",
                          name + ": residue names cut to four characters: 2",
                          name + ": chain names cut to one character, and to four as segments: 2"));
}

TEST_F(TopologyPdbTest, RefusesWhatDoesNotFit) {
  std::ofstream(path_) << "precious";
  AtomTable atoms = one_residue(1);
  const auto message = [&](Vec3 position) {
    return error_text<InputError>([&] { write(atoms, {position}, {}); });
  };
  const std::string end = " does not fit the columns of a PDB file (-999.999 to 9999.999 Angstrom)";
  EXPECT_EQ(message({9999.9996, 0, 0}), "position of C1(1) (10000, 0, 0)" + end);
  EXPECT_EQ(message({0, -1000, 0}), "position of C1(1) (0, -1000, 0)" + end);
  EXPECT_EQ(message({0, 0, std::numeric_limits<double>::infinity()}),
            "position of C1(1) (0, 0, inf)" + end);
  EXPECT_ERROR(InputError, "bond of atoms 0 and 1, of 1 atoms", write(atoms, {{}}, {{0, 1, 0, 1}}));
  EXPECT_ERROR(InputError, "0 positions for 1 atoms", write(atoms, {}, {}));
  atoms.residues[0].number = 2436112;
  EXPECT_EQ(message({}),
            "residue number of C1(1) does not fit the columns of a PDB file "
            "(-999 to 2436111)");
  EXPECT_EQ(content_of(path_), "precious");
  EXPECT_ERROR(FileError, path_.string() + ": exists already; overwrite replaces it",
               write_topology_pdb(path_, one_residue(1), std::vector<Vec3>(1), {}));
}

class PdbRecorderTest : public FileTest {};

TEST_F(PdbRecorderTest, WritesAModelAFrameAndBondsOnce) {
  const Framework framework = named_chain(2);
  PdbRecorder recorder(path_, framework.atoms(), {{0, 1, 0, 1}});
  recorder.record(std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}});
  EXPECT_FALSE(std::filesystem::exists(path_));
  recorder.record(std::vector<Vec3>{{-1, 2, 3}, {4, 5, 9999.999}});
  recorder.close();
  EXPECT_EQ(recorder.models(), 2);
  EXPECT_EQ(content_of(path_),
            "MODEL        1\n"
            "ATOM      1  CA  ALA A  -3       1.000   2.000   3.000  1.00  0.00           C\n"
            "ATOM      2 HB11 LYS A  -3B      4.000   5.000   6.000  1.00  0.00           H\n"
            "ENDMDL\n"
            "MODEL        2\n"
            "ATOM      1  CA  ALA A  -3      -1.000   2.000   3.000  1.00  0.00           C\n"
            "ATOM      2 HB11 LYS A  -3B      4.000   5.0009999.999  1.00  0.00           H\n"
            "ENDMDL\n"
            "CONECT    1    2\n"
            "CONECT    2    1\n"
            "END\n");
}

TEST_F(PdbRecorderTest, LeavesNothingThatIsNotClosed) {
  { PdbRecorder(path_, named_chain(1).atoms()).record(std::vector<Vec3>{{}}); }
  PdbRecorder(directory_ / "empty.pdb", named_chain(1).atoms()).close();
  EXPECT_TRUE(std::filesystem::is_empty(directory_.path()));
}

TEST_F(PdbRecorderTest, RefusesWhatDoesNotFit) {
  PdbRecorder recorder(path_, named_chain(1).atoms());
  const std::string name = std::filesystem::canonical(directory_.path()).string() + "/run.h5md: ";
  EXPECT_ERROR(InputError, name + "2 positions for 1 atoms", recorder.record(std::vector<Vec3>(2)));
  EXPECT_ERROR(InputError,
               name +
                   "model 1: position of A:LYS-3B:CA (-1000, 0, 0) does not fit the columns of a "
                   "PDB file (-999.999 to 9999.999 Angstrom)",
               recorder.record(std::vector<Vec3>{{-1000, 0, 0}}));
  recorder.close();
  EXPECT_ERROR(FileError, name + "is closed: no frame can be recorded",
               recorder.record(std::vector<Vec3>(1)));
  EXPECT_ERROR(InputError, "a framework without names of atoms cannot be written as PDB",
               PdbRecorder(path_, bare(2).atoms()));
}

}  // namespace pliant::topology_pdb_test
