// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/select_part.hpp"

#include <gtest/gtest.h>

#include "pliant/base/error.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/read/read.hpp"
#include "support/error_text.hpp"

namespace pliant {
namespace select_part_test {

/// Two glycines, a silicon that the file bonds to the first O, a water.
constexpr std::string_view text =
    "ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00 10.00           N\n"
    "ATOM      2  CA  GLY A   1       1.450   0.000   0.000  1.00 11.00           C\n"
    "ATOM      3  C   GLY A   1       2.000   1.420   0.000  1.00 12.00           C\n"
    "ATOM      4  O   GLY A   1       1.250   2.390   0.000  1.00 13.00           O\n"
    "ATOM      5  N   GLY A   2       3.330   1.540   0.000  1.00 14.00           N\n"
    "TER\n"
    "HETATM    6 SI   LIG B   1       1.250   4.020   0.000  1.00 15.00          SI\n"
    "HETATM    7  O   HOH B   2       9.000   9.000   9.000  1.00 16.00           O\n"
    "CONECT    4    6\n";

Structure whole() {
  Structure structure = read_structure(SourceText{"x.pdb", text});
  perceive_bonds(structure, {});
  return structure;
}

const std::string cut = "warning: select: 1 bond to an atom that is left out vanishes";

struct Messages {
  std::vector<std::string> lines;
  Log log() {
    return {[this](Severity severity, std::string_view line) {
      lines.push_back((severity == Severity::warning ? "warning: " : "note: ") + std::string(line));
    }};
  }
};

TEST(SelectPart, TakesAtomsWithAllTheirColumns) {
  Messages messages;
  const Structure part = select_part(whole(), "protein", messages.log());
  EXPECT_EQ(part.atoms.names, (std::vector<std::string>{"N", "CA", "C", "O", "N"}));
  EXPECT_EQ(part.atoms.serials, (std::vector<std::int64_t>{1, 2, 3, 4, 5}));
  EXPECT_EQ(part.b_factors, (std::vector<float>{10, 11, 12, 13, 14}));
  EXPECT_EQ(part.positions[4], (Vec3{3.33, 1.54, 0.0}));
  EXPECT_EQ(part.bonds.size(), 4U);
  EXPECT_EQ(part.source, "x.pdb");
  EXPECT_EQ(messages.lines, (std::vector<std::string>{"note: select: 5 of 7 atoms", cut}));
}

TEST(SelectPart, NumbersBondsAnew) {
  Messages messages;
  const Structure part = select_part(whole(), "element O Si", messages.log());
  ASSERT_EQ(part.bonds.size(), 1U);
  EXPECT_EQ(part.bonds[0], (Bond{0, 1, BondOrigin::file, 0}));
  EXPECT_EQ(messages.lines, (std::vector<std::string>{"note: select: 3 of 7 atoms", cut}));
}

TEST(SelectPart, OfAllIsTheSame) {
  Messages messages;
  const Structure all = whole(), part = select_part(all, "all", messages.log());
  EXPECT_EQ(part.atoms.residues, all.atoms.residues);
  EXPECT_EQ(part.bonds, all.bonds);
  EXPECT_EQ(part.chain_end, all.chain_end);
  EXPECT_EQ(messages.lines, std::vector<std::string>{"note: select: 7 of 7 atoms"});
}

TEST(SelectPart, OfNothingIsRefused) {
  EXPECT_EQ(test::error_text<OptionError>([] { select_part(whole(), "nucleic"); }),
            "select: selection \"nucleic\" names no atom");
  EXPECT_THROW(select_part(whole(), "name"), OptionError);
}

}  // namespace select_part_test
}  // namespace pliant
