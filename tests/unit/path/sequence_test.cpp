// SPDX-License-Identifier: MIT
#include "pliant/path/sequence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "pliant/base/random.hpp"

namespace pliant::sequence_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

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

}  // namespace pliant::sequence_test
