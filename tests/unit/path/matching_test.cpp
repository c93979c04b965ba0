// SPDX-License-Identifier: MIT
#include "pliant/path/matching.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "pliant/base/error.hpp"
#include "pliant/path/sequence.hpp"
#include "support/error_text.hpp"

namespace pliant::matching_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StrEq;

std::string name_of(char letter) {
  for (const ResidueLetter& row : amino_acid_letters())
    if (row.letter == letter) return std::string(row.name);
  return "UNK";
}

/// Adds a chain of amino acids, numbered from `first`.
void add_chain(Trace& trace, const std::string& chain, const std::string& letters,
               std::int64_t first = 1) {
  for (char letter : letters)
    trace.add(std::uint32_t(10 * trace.size()), {name_of(letter), first++, ' ', chain},
              PolymerKind::amino);
}

Trace chain(const std::string& letters, std::int64_t first = 1, const std::string& name = "A") {
  Trace trace;
  add_chain(trace, name, letters, first);
  return trace;
}

TEST(MatchResidues, ByNumberWhereTheNumbersFit) {
  const ResidueMatch match = match_residues(chain("AKKW"), chain("KKW", 2), "b.pdb");
  EXPECT_THAT(match.ours, ElementsAre(1, 2, 3));
  EXPECT_THAT(match.theirs, ElementsAre(0, 1, 2));
  EXPECT_THAT(match.notes, ElementsAre("b.pdb: 3 of our 4 residues are in it",
                                       "b.pdb: left out, of ours alone: A:1"));
}

TEST(MatchResidues, BySequenceWhereTheyDoNot) {
  const ResidueMatch match = match_residues(chain("ACDEFGH"), chain("CDEFGH", 300), "b.pdb");
  EXPECT_THAT(match.ours, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(match.theirs, ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(MatchResidues, ResiduesThatDifferAreNamed) {
  const ResidueMatch one = match_residues(chain("ACDEFGHIKLM"), chain("ACDEFGHIKLW"), "b.pdb");
  EXPECT_THAT(one.notes.back(),
              StrEq("b.pdb: 1 residue differs, compared all the same: A:MET11 is TRP11"));
  const ResidueMatch many = match_residues(chain("ACDEFGHIKLMNPQR"), chain("WWWWWWWIKLMNPQR"), "b");
  EXPECT_THAT(many.ours, SizeIs(15));
  EXPECT_THAT(many.notes.back(), HasSubstr("7 residues differ, "));
  EXPECT_THAT(many.notes.back(), HasSubstr("A:GLY6 is TRP6 and 1 more"));
}

TEST(MatchResidues, ChainsThatShareMostGoTogether) {
  Trace ours, theirs;
  add_chain(ours, "A", "ACDEFGHIKL");
  add_chain(ours, "B", "MNPQRSTVWY");
  add_chain(theirs, "X", "MNPQRSTVWY");
  add_chain(theirs, "Y", "ACDEFGHIKL");
  const ResidueMatch match = match_residues(ours, theirs, "b.pdb");
  EXPECT_THAT(match.theirs, ElementsAre(10, 11, 12, 13, 14, 15, 16, 17, 18, 19,  //
                                        0, 1, 2, 3, 4, 5, 6, 7, 8, 9));
  EXPECT_THAT(match.notes[0], HasSubstr("20 of our 20"));
  EXPECT_THAT(match.notes[0], HasSubstr("(chains A with Y, B with X)"));
}

TEST(MatchResidues, OfEqualChainsThoseOfOneNameGoTogether) {
  Trace ours, theirs;
  for (const char* name : {"A", "B"}) add_chain(ours, name, "ACDEF");
  for (const char* name : {"B", "A"}) add_chain(theirs, name, "ACDEF");
  EXPECT_THAT(match_residues(ours, theirs, "b.pdb").theirs,
              ElementsAre(5, 6, 7, 8, 9, 0, 1, 2, 3, 4));
}

TEST(MatchResidues, AnotherMoleculeIsRefused) {
  EXPECT_EQ(
      test::error_text<InputError>([] { match_residues(chain("ACDEF"), chain("WWWWW"), "b.pdb"); }),
      "b.pdb: only 0 of 5 residues of ours are in it, matched by sequence: is it the same "
      "molecule? pliant compare --select chooses parts of both");
  EXPECT_THROW(match_residues(chain("AC"), chain("AC"), "b.pdb"), InputError);
}

TEST(Trace, NamesResiduesAndRanges) {
  Trace trace = chain("ACD");
  trace.add(30, {"GLY", 3, 'A', "A"}, PolymerKind::amino);
  add_chain(trace, "", "ACD", 7);
  EXPECT_EQ(trace.label(3), "A:GLY3A");
  EXPECT_EQ(trace.label(4), "ALA7");
  EXPECT_EQ(trace.ranges(std::vector<std::uint32_t>{0, 2, 3, 4, 5}), "A:1, A:3-3A, 7-8");
  EXPECT_EQ(trace.ranges({}), "");
}

TEST(Trace, PhosphatesThatAreNoNucleotidesAreLeftOut) {
  Trace trace;
  trace.add(0, {"DA", 1, ' ', "A"}, PolymerKind::nucleic);
  trace.add(1, {"SEP", 2, ' ', "A"}, PolymerKind::nucleic);
  trace.add(2, {"SEP", 2, ' ', "A"}, PolymerKind::amino);
  ASSERT_EQ(trace.size(), 2U);
  EXPECT_EQ(trace[0].letter, 'A');
  EXPECT_EQ(trace[1].letter, unknown_letter);
}

}  // namespace pliant::matching_test
