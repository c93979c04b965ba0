// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/largest_molecule.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "pliant/molecule/read/read.hpp"

namespace pliant {
namespace {

Structure salt() {
  const std::string text =
      "sodium formate\n\n\n  6  3  0  0  0  0  0  0  0  0999 V2000\n"
      "    9.0000    0.0000    0.0000 Na  0  3\n"
      "    0.0000    0.0000    0.0000 C   0  0\n"
      "    1.2000    0.5000    0.1000 O   0  5\n"
      "   -1.2000    0.5000    0.0000 O   0  0\n"
      "    0.0000   -1.1000    0.0000 H   0  0\n"
      "    0.0000    9.0000    0.0000 O   0  0\n"
      "  2  3  1  0\n  2  4  2  0\n  2  5  1  0\nM  END\n";
  return read_structure(SourceText{"salt.sdf", text});
}

TEST(LargestMolecule, IsKeptWithItsBondsAndCharges) {
  std::vector<std::string> notes;
  const Log log{[&](Severity, std::string_view text) { notes.emplace_back(text); }};
  const Structure kept = largest_molecule(salt(), log);
  EXPECT_EQ(kept.size(), 4u);
  EXPECT_EQ(kept.bonds.size(), 3u);
  EXPECT_EQ(kept.charges, (std::vector<std::int8_t>{0, -1, 0, 0}));
  EXPECT_EQ(notes, std::vector<std::string>{"the largest of 3 molecules is kept: 4 of 6 atoms"});
}

TEST(LargestMolecule, LeavesOtherFormatsAlone) {
  Structure crystal = salt();
  crystal.format = "xyz";
  EXPECT_EQ(largest_molecule(crystal).size(), 6u);
}

}  // namespace
}  // namespace pliant
