// SPDX-License-Identifier: MIT
#include "pliant/path/matching.hpp"

#include "pliant/base/random.hpp"
#include "pliant/path/sequence.hpp"
#include "pliant/path/shared_contacts.hpp"
#include "support/test.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::matching_test {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StrEq;

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
  EXPECT_ERROR(InputError,
               "b.pdb: only 0 of 5 residues of ours are in it, matched by sequence: is it the same "
               "molecule? pliant compare --select chooses parts of both",
               match_residues(chain("ACDEF"), chain("WWWWW"), "b.pdb"));
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

/// The score of an alignment by its definition.
int score(const std::string& ours, const std::string& theirs,
          const std::vector<ResiduePair>& pairs) {
  int sum = -2 * int(ours.size() + theirs.size() - 2 * pairs.size());
  for (const auto& [i, j] : pairs) sum += ours[i] == theirs[j] ? 2 : -1;
  return sum;
}

/// The best score of any alignment, by trying all.
int best(const std::string& ours, const std::string& theirs, std::size_t i = 0, std::size_t j = 0) {
  if (i == ours.size() || j == theirs.size()) return -2 * int(ours.size() - i + theirs.size() - j);
  const int paired = (ours[i] == theirs[j] ? 2 : -1) + best(ours, theirs, i + 1, j + 1);
  return std::max({paired, best(ours, theirs, i + 1, j) - 2, best(ours, theirs, i, j + 1) - 2});
}

std::string random_letters(RandomSequence& draws) {
  std::string letters;
  for (std::uint64_t length = draws.below(7); letters.size() < length;)
    letters += "ACG"[draws.below(3)];
  return letters;
}

TEST(Align, FindsABestAlignmentWhateverTheSequences) {
  RandomSequence draws({.seed = 5});
  for (int round = 0; round < 300; ++round) {
    const std::string ours = random_letters(draws), theirs = random_letters(draws);
    const auto pairs = align(ours, theirs);
    EXPECT_EQ(score(ours, theirs, pairs), best(ours, theirs)) << ours << " " << theirs;
    for (std::size_t k = 1; k < pairs.size(); ++k) {
      EXPECT_LT(pairs[k - 1][0], pairs[k][0]);
      EXPECT_LT(pairs[k - 1][1], pairs[k][1]);
    }
  }
}

TEST(Align, OfEqualWaysAPairComesBeforeAGapInTheirs) {
  EXPECT_THAT(align("AA", "A"), ElementsAre(ResiduePair{1, 0}));
  EXPECT_THAT(align("A", "AA"), ElementsAre(ResiduePair{0, 1}));
  EXPECT_THAT(align("ACG", "AG"), ElementsAre(ResiduePair{0, 0}, ResiduePair{2, 1}));
  EXPECT_THAT(align("", "ACG"), IsEmpty());
}

TEST(Letters, AreKnownByTheNamesOfForceFieldsToo) {
  EXPECT_EQ(letter_of("LYS", amino_acid_letters()), 'K');
  EXPECT_EQ(letter_of("HSD", amino_acid_letters()), 'H');
  EXPECT_EQ(letter_of("DT", nucleotide_letters()), 'T');
  EXPECT_EQ(letter_of("ATP", nucleotide_letters()), unknown_letter);
}

constexpr auto bond = MolecularContactKind::hydrogen_bond;
constexpr auto tether = MolecularContactKind::hydrophobic;

/// ASP, LYS and an ion; `swapped` has the names of both O of ASP the other way round.
Structure salt(bool swapped, std::int64_t ion = 900) {
  Structure s;
  add_residue(s, "ASP", 1,
              {{swapped ? "OD2" : "OD1", "O", {}}, {swapped ? "OD1" : "OD2", "O", {2, 0, 0}}});
  add_residue(s, "LYS", 2, {{"NZ", "N", {3, 0, 0}}});
  add_residue(s, "ZN", ion, {{"ZN", "Zn", {5, 0, 0}}});
  return s;
}

SharedContacts shared(const Structure& ours, const std::vector<MolecularContact>& our_contacts,
                      const Structure& theirs,
                      const std::vector<MolecularContact>& their_contacts) {
  const ResiduePairing all = with_ligands(ours, theirs, {{0, 1}, {0, 1}});
  const MatchedAtoms here(ours, all.ours), there(theirs, all.theirs);
  return share_contacts(our_contacts, here, their_contacts, there);
}

TEST(SharedContacts, AtomsThatAreAlikeAreOne) {
  const Structure ours = salt(false), theirs = salt(true);
  const auto found =
      shared(ours, {MolecularContact{bond, 2, 0}}, theirs, {MolecularContact{bond, 2, 0}});
  EXPECT_THAT(found.ours, SizeIs(1));
  EXPECT_THAT(found.theirs, SizeIs(1));
  EXPECT_THAT(found.only_ours, IsEmpty());
}

TEST(SharedContacts, JoinInEitherOrderButOfOneKind) {
  const Structure s = salt(false);
  EXPECT_THAT(shared(s, {MolecularContact{tether, 2, 0}}, s, {MolecularContact{tether, 0, 2}}).ours,
              SizeIs(1));
  const auto other = shared(s, {MolecularContact{tether, 2, 0}}, s, {MolecularContact{bond, 2, 0}});
  EXPECT_THAT(other.ours, IsEmpty());
  EXPECT_THAT(other.only_ours, SizeIs(1));
  EXPECT_THAT(other.only_theirs, SizeIs(1));
}

TEST(SharedContacts, ThoseOfWhatIsNotMatchedAreInNone) {
  const Structure ours = salt(false), theirs = salt(false, 901);
  const auto found =
      shared(ours, {MolecularContact{bond, 3, 0}}, theirs, {MolecularContact{bond, 3, 0}});
  EXPECT_THAT(found.ours, IsEmpty());
  EXPECT_THAT(found.only_ours, IsEmpty());
  EXPECT_THAT(found.only_theirs, IsEmpty());
}

TEST(SharedContacts, LigandsAreMatchedByChainNumberAndName) {
  const Structure s = salt(false);
  EXPECT_THAT(with_ligands(s, s, {{0, 1}, {0, 1}}).ours, ElementsAre(0, 1, 2));
  EXPECT_THAT(with_ligands(s, salt(false, 901), {{0, 1}, {0, 1}}).ours, ElementsAre(0, 1));
  EXPECT_THAT(shared(s, {MolecularContact{bond, 3, 0}}, s, {MolecularContact{bond, 3, 0}}).ours,
              SizeIs(1));
}

TEST(SharedContacts, OutsideIsHowFarADistanceIsFromItsInterval) {
  MolecularContact one = MolecularContact{tether, 0, 1};
  one.least = 1.0;
  one.most = 2.0;
  EXPECT_EQ(outside(one, std::vector<Vec3>{{}, {0.25, 0, 0}}), 0.75);
  EXPECT_EQ(outside(one, std::vector<Vec3>{{}, {1.5, 0, 0}}), 0.0);
  EXPECT_EQ(outside(one, std::vector<Vec3>{{}, {4.0, 0, 0}}), 2.0);
}

}  // namespace pliant::matching_test
