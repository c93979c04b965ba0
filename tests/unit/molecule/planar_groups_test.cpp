// SPDX-License-Identifier: MIT
#include "pliant/molecule/planar_groups.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/molecule/build_framework.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::planar_groups_test {

using namespace test;
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::uint8_t aromatic = 4;

/// Atoms of these elements, one letter each, at places in general position; bonds with orders.
Structure made(const char* elements, std::vector<Bond> bonds) {
  std::vector<std::string> symbols;
  for (const char* at = elements; *at != '\0'; ++at) symbols.emplace_back(1, *at);
  std::vector<std::pair<const char*, Vec3>> atoms;
  for (std::size_t k = 0; k < symbols.size(); ++k) {
    const auto t = static_cast<double>(k);
    atoms.emplace_back(symbols[k].c_str(),
                       Vec3{1.3 * t, t * t * 0.1, static_cast<double>(k % 3) * 0.7});
  }
  Structure s = molecule(atoms);
  s.bonds = std::move(bonds);
  return s;
}

Bond bond(std::uint32_t a, std::uint32_t b, std::uint8_t order = 1) {
  return {a, b, BondOrigin::file, order};
}

std::vector<std::string> planar_bars(const Structure& s) {
  std::vector<std::string> texts;
  for (Bar bar : find_planar_bars(s))
    texts.push_back(std::to_string(bar.a) + "-" + std::to_string(bar.b));
  return texts;
}

TEST(PlanarGroups, HoldDoubleBonds) {
  EXPECT_THAT(planar_bars(made("CCCC", {bond(0, 1), bond(1, 2, 2), bond(2, 3)})),
              ElementsAre("0-3"));
  EXPECT_THAT(planar_bars(made("CCCC", {bond(0, 1), bond(1, 2, 1), bond(2, 3)})), IsEmpty());
  EXPECT_THAT(planar_bars(made("CCCC", {bond(0, 1), bond(1, 2, 0), bond(2, 3)})), IsEmpty());
}

/// C-C(=O)-N(H)-C: of the four pairs across the amide the one furthest apart.
TEST(PlanarGroups, HoldAmides) {
  const Structure amide =
      made("CCONHC", {bond(0, 1), bond(1, 2, 2), bond(1, 3), bond(3, 4), bond(3, 5)});
  EXPECT_THAT(planar_bars(amide), ElementsAre("0-5"));
}

TEST(PlanarGroups, HoldNothingAtAQuaternaryNitrogen) {
  const Structure salt =
      made("CCONCCC", {bond(0, 1), bond(1, 2, 2), bond(1, 3), bond(3, 4), bond(3, 5), bond(3, 6)});
  EXPECT_THAT(planar_bars(salt), IsEmpty());
}

TEST(PlanarGroups, HoldPeptideBondsWhateverIsKnownOfTheOxygen) {
  Structure peptide = made("CCONC", {bond(0, 1), bond(1, 2, 0), bond(1, 3), bond(3, 4)});
  EXPECT_THAT(planar_bars(peptide), IsEmpty());
  peptide.bonds[2].origin = BondOrigin::link;
  EXPECT_THAT(planar_bars(peptide), ElementsAre("0-4"));
}

/// Ends at which nothing hangs have no torsion.
TEST(PlanarGroups, HoldNothingWhereNothingHangs) {
  EXPECT_THAT(planar_bars(made("CCO", {bond(0, 1), bond(1, 2, 2)})), IsEmpty());
  EXPECT_THAT(planar_bars(made("CCON", {bond(0, 1), bond(1, 2, 2), bond(1, 3)})), IsEmpty());
}

/// Angles make rings of up to six atoms rigid; a bond of a larger ring is held.
TEST(PlanarGroups, LeaveSmallRingsToTheirAngles) {
  const auto ring = [](std::uint32_t size) {
    std::vector<Bond> bonds{bond(0, size - 1, aromatic)};
    for (std::uint32_t k = 0; k + 1 < size; ++k) bonds.push_back(bond(k, k + 1, aromatic));
    return made(std::string(size, 'C').c_str(), bonds);
  };
  EXPECT_THAT(planar_bars(ring(5)), IsEmpty());
  EXPECT_THAT(planar_bars(ring(6)), IsEmpty());
  EXPECT_EQ(planar_bars(ring(7)).size(), 7u);
}

TEST(PlanarGroups, AreBarsOfAnglesAfterAllOthersAndOfNothingElse) {
  const Structure s = made("CCCC", {bond(0, 1), bond(1, 2, 2), bond(2, 3)});
  const Framework angles = build_framework(s, {.bars = BarKind::angles});
  ASSERT_EQ(angles.bar_count(), 6u);
  EXPECT_EQ(angles.bars()[5], (Bar{0, 3}));
  EXPECT_DOUBLE_EQ(angles.rest_lengths()[5], distance(s.positions[0], s.positions[3]));
  EXPECT_EQ(build_framework(s).bar_count(), 3u);
}

}  // namespace
}  // namespace pliant::planar_groups_test
