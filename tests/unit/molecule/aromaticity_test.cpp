// SPDX-License-Identifier: MIT
#include "pliant/molecule/aromaticity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "unit/molecule/made_structure.hpp"

namespace pliant::aromaticity_test {

using namespace test;
namespace {

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
  std::vector<std::string> symbols;
  for (const char* at = of.elements; *at != '\0'; ++at) symbols.emplace_back(1, *at);
  std::vector<std::pair<const char*, Vec3>> atoms;
  for (const std::string& symbol : symbols) atoms.emplace_back(symbol.c_str(), Vec3{});
  Structure s = molecule(atoms);
  const std::string text = of.bonds;
  for (std::size_t k = 0; k + 3 < text.size(); k += 5)
    s.bonds.push_back({number(text[k]), number(text[k + 1]), BondOrigin::file,
                       static_cast<std::uint8_t>(number(text[k + 3]))});
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

}  // namespace
}  // namespace pliant::aromaticity_test
