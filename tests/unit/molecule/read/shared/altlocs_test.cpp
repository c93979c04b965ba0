// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/shared/altlocs.hpp"

#include <gtest/gtest.h>

#include <ctime>
#include <string>

namespace pliant {
namespace conformers_test {

/// One letter an atom: 'x' where it stays, '-' where it goes.
std::string kept(const std::vector<AltlocAtom>& atoms) {
  std::string text;
  for (bool stays : choose_altlocs(atoms)) text += stays ? 'x' : '-';
  return text;
}

TEST(Conformers, HighestMeanOccupancyOfTheResidueWins) {
  EXPECT_EQ(kept({{"CA", 'A', 0.4F}, {"CA", 'B', 0.6F}}), "-x");
  // B wins one name, A the mean: all atoms come from A.
  EXPECT_EQ(kept({{"CA", 'A', 0.4F}, {"CA", 'B', 0.6F}, {"CB", 'A', 0.9F}, {"CB", 'B', 0.1F}}),
            "x-x-");
}

TEST(Conformers, FirstOnATie) {
  EXPECT_EQ(kept({{"CA", 'B', 0.5F}, {"CA", 'A', 0.5F}}), "x-");
  EXPECT_EQ(kept({{"CA", 'A', 0.0F}, {"CA", 'B', 0.0F}}), "x-");
}

TEST(Conformers, AtomsOfOtherConformersGoWithThem) {
  EXPECT_EQ(kept({{"CA", 'A', 0.6F}, {"CA", 'B', 0.4F}, {"OG", 'B', 0.4F}}), "x--");
}

TEST(Conformers, ThoseThatShareNoNameBothStay) {
  EXPECT_EQ(kept({{"CA", 'A', 0.5F}, {"OG", 'C', 0.1F}}), "xx");
  EXPECT_EQ(kept({{"CA", 'A', 0.5F}, {"CA", 'B', 0.4F}, {"OG", 'C', 0.1F}, {"OG", 'D', 0.2F}}),
            "x--x");
}

TEST(Conformers, AtomsWithoutOneStayUnlessTheirNameIsChosen) {
  EXPECT_EQ(kept({{"N", ' ', 1.0F}, {"CA", 'A', 0.3F}}), "xx");
  EXPECT_EQ(kept({{"CA", ' ', 0.7F}, {"CA", 'B', 0.3F}, {"N", ' ', 1.0F}}), "x-x");
  EXPECT_EQ(kept({{"CA", ' ', 0.3F}, {"CA", 'B', 0.7F}, {"N", ' ', 0.1F}}), "-xx");
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

}  // namespace conformers_test
}  // namespace pliant
