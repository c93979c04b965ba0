// SPDX-License-Identifier: MIT
#include "pliant/molecule/planar_groups.hpp"

#include "pliant/molecule/aromaticity.hpp"
#include "pliant/molecule/build_framework.hpp"
#include "support/test.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::planar_groups_test {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

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

/// Phenyl-NH-(2-pyridyl): carbons 0 to 5, N 6 and its H 7, pyridyl 8 to 13 (N 13). The orders of
/// the bonds 8-9, 9-10 and so on round the pyridine.
Structure anilinopyridine(std::array<std::uint8_t, 6> orders) {
  std::vector<Bond> bonds{bond(0, 5, aromatic), bond(0, 6), bond(6, 7), bond(6, 8)};
  for (std::uint32_t k = 0; k < 5; ++k) bonds.push_back(bond(k, k + 1, aromatic));
  for (std::uint32_t k = 0; k < 5; ++k) bonds.push_back(bond(8 + k, 9 + k, orders[k]));
  bonds.push_back(bond(8, 13, orders[5]));
  return made("CCCCCCNHCCCCCN", bonds);
}

/// The drawing decides nothing: neither form of the pyridine makes an amidine of its C=N.
TEST(PlanarGroups, TurnAboutTheBondFromAnAromaticRingToNitrogenInEveryDrawing) {
  for (const auto& orders : {std::array<std::uint8_t, 6>{1, 2, 1, 2, 1, 2},
                             std::array<std::uint8_t, 6>{2, 1, 2, 1, 2, 1},
                             std::array<std::uint8_t, 6>{4, 4, 4, 4, 4, 4}}) {
    const Structure s = anilinopyridine(orders);
    EXPECT_THAT(planar_bars(s), IsEmpty());
    const std::vector<bool> is_locked = find_locked_bonds(s);
    for (std::size_t k = 0; k < s.bonds.size(); ++k) {
      const bool is_at_nitrogen = s.bonds[k].a == 6 || s.bonds[k].b == 6;
      EXPECT_EQ(is_locked[k], !is_at_nitrogen) << s.bonds[k].a << "-" << s.bonds[k].b;
    }
  }
}

/// NH2 on an aromatic carbon beside nitrogen, as in adenine and cytosine.
TEST(PlanarGroups, HoldAminoGroupsBesideNitrogenOfAromaticRingsInEveryDrawing) {
  for (const std::uint8_t first : std::array<std::uint8_t, 3>{1, 2, 4}) {
    std::vector<Bond> bonds{bond(0, 6), bond(6, 7), bond(6, 8)};
    const auto order = [&](std::uint32_t k) -> std::uint8_t {
      return first == aromatic ? aromatic : k % 2 == 0 ? first : 3 - first;
    };
    for (std::uint32_t k = 0; k < 5; ++k) bonds.push_back(bond(k, k + 1, order(k)));
    bonds.push_back(bond(0, 5, order(5)));
    EXPECT_EQ(planar_bars(made("CCCCCNNHH", bonds)).size(), 1u) << int(first);
  }
}

/// The amide of an acylated aminopyridine is held, the bond to its ring turns.
TEST(PlanarGroups, HoldOfAnAcylatedAminopyridineTheAmideAlone) {
  Structure s = anilinopyridine({1, 2, 1, 2, 1, 2});
  // Acetyl in place of phenyl: C 0 with O 1 and C 2.
  std::erase_if(s.bonds, [](const Bond& bond) { return bond.b < 6; });
  for (const Bond& added : {bond(0, 1, 2), bond(0, 2)}) s.bonds.push_back(added);
  s.atoms.elements[1] = 8;
  EXPECT_THAT(planar_bars(s), ElementsAre("1-8"));
}

/// C=N of a ring that is not aromatic makes an amidine.
TEST(PlanarGroups, HoldAmidinesOfRingsThatAreNotAromatic) {
  // 2-(methylamino)imidazoline: C 0, N 1, C 2, C 3, N 4 in the ring; N 5 with C 6.
  const Structure s = made("CNCCNNC", {bond(0, 1, 2), bond(1, 2), bond(2, 3), bond(3, 4),
                                       bond(0, 4), bond(0, 5), bond(5, 6)});
  EXPECT_EQ(planar_bars(s).size(), 1u);
}

TEST(PlanarGroups, AreBarsOfAnglesAfterAllOthersAndOfNothingElse) {
  const Structure s = made("CCCC", {bond(0, 1), bond(1, 2, 2), bond(2, 3)});
  const Framework angles = build_framework(s, {.bars = BarKind::angles});
  ASSERT_EQ(angles.bar_count(), 6u);
  EXPECT_EQ(angles.bars()[5], (Bar{0, 3}));
  EXPECT_DOUBLE_EQ(angles.rest_lengths()[5], distance(s.positions[0], s.positions[3]));
  EXPECT_EQ(build_framework(s).bar_count(), 3u);
}

/// Bonds as text: "01:2" is a double bond of atoms 0 and 1 (letters from a after 9).
struct Case {
  const char* name;
  const char* elements;  ///< one letter an atom; hydrogens only where they count
  const char* bonds;
  std::vector<std::pair<int, int>> charges;
  std::size_t aromatic;  ///< bonds
};

std::uint32_t number(char c) {
  return static_cast<std::uint32_t>(c <= '9' ? c - '0' : c - 'a' + 10);
}

Structure made(const Case& of) {
  std::vector<Bond> bonds;
  const std::string text = of.bonds;
  for (std::size_t k = 0; k + 3 < text.size(); k += 5)
    bonds.push_back(
        bond(number(text[k]), number(text[k + 1]), static_cast<std::uint8_t>(number(text[k + 3]))));
  Structure s = made(of.elements, bonds);
  s.charges.assign(s.size(), 0);
  for (const auto& [atom, charge] : of.charges)
    s.charges[static_cast<std::size_t>(atom)] = static_cast<std::int8_t>(charge);
  return s;
}

class AromaticityOf : public testing::TestWithParam<Case> {};

TEST_P(AromaticityOf, CountsPiElectrons) {
  const std::vector<bool> found = find_aromatic_bonds(made(GetParam()));
  EXPECT_EQ(std::size_t(std::count(found.begin(), found.end(), true)), GetParam().aromatic);
}

const Case cases[] = {
    {"benzene", "CCCCCC", "01:2 12:1 23:2 34:1 45:2 05:1", {}, 6},
    {"its_other_form", "CCCCCC", "01:1 12:2 23:1 34:2 45:1 05:2", {}, 6},
    {"stated", "CCCCCC", "01:4 12:4 23:4 34:4 45:4 05:4", {}, 6},
    {"not_known", "CCCCCC", "01:0 12:0 23:0 34:0 45:0 05:0", {}, 0},
    {"cyclohexadiene", "CCCCCC", "01:2 12:1 23:2 34:1 45:1 05:1", {}, 0},
    {"pyrrole", "NCCCC", "01:1 12:2 23:1 34:2 04:1", {}, 5},
    {"thiophene", "SCCCC", "01:1 12:2 23:1 34:2 04:1", {}, 5},
    {"thiophene_dioxide", "SCCCCOO", "01:1 12:2 23:1 34:2 04:1 05:2 06:2", {}, 0},
    {"imidazole", "NCNCC", "01:1 12:2 23:1 34:2 04:1", {}, 5},
    {"cyclopentadiene", "CCCCC", "01:1 12:2 23:1 34:2 04:1", {}, 0},
    {"cyclopentadienide", "CCCCC", "01:1 12:2 23:1 34:2 04:1", {{0, -1}}, 5},
    {"fulvene", "CCCCCC", "01:1 12:2 23:1 34:2 04:1 05:2", {}, 0},
    {"cyclopentadienone", "CCCCCO", "01:1 12:2 23:1 34:2 04:1 05:2", {}, 0},
    {"pyridone", "NCCCCCO", "01:1 12:1 23:2 34:1 45:2 05:1 16:2", {}, 6},
    {"quinone", "CCCCCCOO", "01:1 12:2 23:1 34:1 45:2 05:1 06:2 37:2", {}, 0},
    {"pyridine_oxide", "NCCCCCO", "01:2 12:1 23:2 34:1 45:2 05:1 06:1", {{0, 1}, {6, -1}}, 6},
    {"its_oxide_with_five_bonds", "NCCCCCO", "01:2 12:1 23:2 34:1 45:2 05:1 06:2", {}, 6},
    {"pyrylium", "OCCCCC", "01:2 12:1 23:2 34:1 45:2 05:1", {{0, 1}}, 6},
    {"pyran", "OCCCCC", "01:1 12:2 23:1 34:1 45:2 05:1", {}, 0},
    {"tropone", "CCCCCCCO", "01:1 12:2 23:1 34:2 45:1 56:2 06:1 07:2", {}, 7},
    {"tropylium", "CCCCCCC", "01:1 12:2 23:1 34:2 45:1 56:2 06:1", {{0, 1}}, 7},
    {"azepine", "NCCCCCC", "01:1 12:2 23:1 34:2 45:1 56:2 06:1", {}, 0},
    {"cyclobutadiene", "CCCC", "01:2 12:1 23:2 03:1", {}, 0},
    // Two rings that share the bond 04 are aromatic together alone.
    {"azulene", "CCCCCCCCCC", "01:2 12:1 23:2 34:1 04:1 45:2 56:1 67:2 78:1 89:2 09:1", {}, 10},
    {"indolizine", "NCCCCCCCC", "01:1 12:2 23:1 34:2 04:1 45:1 56:2 67:1 78:2 08:1", {}, 10},
    {"phthalimide",
     "CCCCCCCNCOO",
     "01:2 12:1 23:2 34:1 45:2 05:1 06:1 67:1 78:1 18:1 69:2 8a:2",
     {},
     6},
    // In some forms the bonds between the rings are double.
    {"biphenylene",
     "CCCCCCCCCCCC",
     "01:2 12:1 23:2 34:1 45:2 05:1 67:2 78:1 89:2 9a:1 ab:2 6b:1 06:1 17:1",
     {},
     12},
    {"biphenylene_with_quinoid_rings",
     "CCCCCCCCCCCC",
     "01:1 12:1 23:2 34:1 45:2 05:1 67:1 78:1 89:2 9a:1 ab:2 6b:1 06:2 17:2",
     {},
     12},
};

INSTANTIATE_TEST_SUITE_P(Molecules, AromaticityOf, testing::ValuesIn(cases),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace pliant::planar_groups_test
