// SPDX-License-Identifier: MIT
// What bond perception promises for any structure, however senseless: random atoms of random
// elements and names, dense and sparse, with and without known residues.
#include "pliant/base/random.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/build_framework.hpp"
#include "support/test.hpp"

namespace pliant::bond_law_test {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs pairs_of(const Structure& s) {
  Pairs pairs;
  for (const Bond& bond : s.bonds) pairs.emplace_back(bond.a, bond.b);
  return pairs;
}

/// Draws structures; one seed, one row of draws.
class Source {
 public:
  explicit Source(std::uint64_t seed) : random(RandomKey{.seed = seed}) {}

  RandomSequence random;

  template <class Table>
  auto one_of(const Table& table) {
    return table[random.below(std::size(table))];
  }

  Vec3 point(double extent) {
    return extent * Vec3{random.uniform(), random.uniform(), random.uniform()};
  }

  /// One residue without a template; 2 to 61 atoms.
  Structure molecule() {
    constexpr std::uint8_t elements[] = {1, 1, 1, 6, 6, 6, 7, 8, 9, 15, 16, 17, 30, 0, 53};
    Structure s;
    s.atoms.residues.push_back({"UNK", 1, ' ', ""});
    const double extent = 1.0 + 12.0 * random.uniform();
    for (std::uint64_t k = 2 + random.below(60); k > 0; --k) add(s, "C1", one_of(elements), extent);
    return s;
  }

  /// Residues with templates and without, with atoms that belong and that do not.
  Structure residues() {
    constexpr const char* names[] = {"ALA", "CYS", "HOH", "LIG", "DA", "ACE", "NME", "ZN"};
    constexpr const char* atoms[] = {"N",  "CA", "C",   "O",  "CB", "SG", "HA", "H",
                                     "1H", "P",  "O3'", "HG", "OW", "X9", "ZN", "CH3"};
    constexpr std::uint8_t elements[] = {1, 6, 7, 8, 15, 16, 30, 0};
    Structure s;
    const double extent = 2.0 + 10.0 * random.uniform();
    for (std::uint64_t r = 1 + random.below(8); r > 0; --r) {
      s.atoms.residues.push_back({one_of(names), 1, ' ', random.below(2) == 0 ? "A" : "B"});
      s.chain_end.push_back(random.below(4) == 0);
      for (std::uint64_t k = 1 + random.below(12); k > 0; --k)
        add(s, one_of(atoms), one_of(elements), extent);
    }
    return s;
  }

  void add(Structure& s, const char* name, std::uint8_t element, double extent) {
    s.atoms.names.emplace_back(name);
    s.atoms.elements.push_back(element);
    s.atoms.residue_of.push_back(static_cast<std::uint32_t>(s.atoms.residues.size() - 1));
    s.atoms.serials.push_back(static_cast<std::int64_t>(s.positions.size()) + 1);
    s.positions.push_back(point(extent));
  }
};

template <class Check>
void for_each_source(const Check& check) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Source source(seed);
    check(source);
  }
}

TEST(BondLaw, BondsAreSortedDifferentAndWithinReason) {
  for_each_source([](Source& source) {
    for (Structure s : {source.molecule(), source.residues()}) {
      perceive_bonds(s);
      const Pairs pairs = pairs_of(s);
      EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
      EXPECT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end());
      for (const Bond& bond : s.bonds) {
        EXPECT_LT(bond.a, bond.b);
        EXPECT_LT(bond.b, s.size());
        EXPECT_LE(distance(s.positions[bond.a], s.positions[bond.b]), 3.3);
      }
    }
  });
}

/// Of H, C, N, O, F, P, S, Cl, Zn (within its residue) and I; others make none.
int most_bonds(std::uint8_t element) {
  const std::map<std::uint8_t, int> most{{1, 1},  {6, 4},  {7, 4},  {8, 3},   {9, 1},
                                         {15, 6}, {16, 6}, {17, 4}, {30, 12}, {53, 7}};
  const auto at = most.find(element);
  return at == most.end() ? 0 : at->second;
}

TEST(BondLaw, AtomsGetNoMoreBondsThanTheirElementMakes) {
  for_each_source([](Source& source) {
    Structure s = source.molecule();
    perceive_bonds(s);
    std::vector<int> counts(s.size());
    for (const Bond& bond : s.bonds) {
      ++counts[bond.a];
      ++counts[bond.b];
    }
    for (std::size_t i = 0; i < s.size(); ++i) {
      const std::uint8_t element = s.atoms.elements[i];
      EXPECT_LE(counts[i], most_bonds(element)) << int{element};
    }
  });
}

TEST(BondLaw, PerceivingAgainAddsNothing) {
  for_each_source([](Source& source) {
    for (Structure s : {source.molecule(), source.residues()}) {
      perceive_bonds(s);
      const std::vector<Bond> once = s.bonds;
      perceive_bonds(s);
      EXPECT_EQ(s.bonds, once);
    }
  });
}

TEST(BondLaw, RigidMotionChangesNothing) {
  for_each_source([](Source& source) {
    for (Structure s : {source.molecule(), source.residues()}) {
      Structure moved = s;
      for (Vec3& p : moved.positions) p = {p.z + 64.0, -p.x + 1024.0, p.y - 128.0};
      perceive_bonds(s);
      perceive_bonds(moved);
      EXPECT_EQ(pairs_of(moved), pairs_of(s));
    }
  });
}

TEST(BondLaw, TheOrderOfAtomsChangesNothing) {
  for_each_source([](Source& source) {
    Structure s = source.molecule();
    std::vector<std::uint32_t> order(s.size());
    std::iota(order.begin(), order.end(), 0U);
    for (std::size_t k = order.size(); k > 1; --k)
      std::swap(order[k - 1], order[source.random.below(k)]);
    Structure shuffled = s;
    for (std::size_t k = 0; k < s.size(); ++k) {
      shuffled.positions[k] = s.positions[order[k]];
      shuffled.atoms.elements[k] = s.atoms.elements[order[k]];
    }
    perceive_bonds(s);
    perceive_bonds(shuffled);
    Pairs back;
    for (const auto& [a, b] : pairs_of(shuffled)) back.push_back(std::minmax({order[a], order[b]}));
    std::sort(back.begin(), back.end());
    EXPECT_EQ(back, pairs_of(s));
  });
}

TEST(BondLaw, FrameworksHaveABarOfEachBondAndAngle) {
  for_each_source([](Source& source) {
    Structure s = source.molecule();
    perceive_bonds(s);
    const Framework bonds = build_framework(s);
    const Framework angles = build_framework(s, {.bars = BarKind::angles});
    ASSERT_EQ(bonds.bar_count(), s.bonds.size());
    EXPECT_EQ(angles.merged_bar_count(), 0U);
    Pairs expected = pairs_of(s);
    for (Joint centre = 0; centre < s.size(); ++centre)
      for (const Incidence& one : bonds.neighbours(centre))
        for (const Incidence& other : bonds.neighbours(centre))
          if (one.joint < other.joint) expected.emplace_back(one.joint, other.joint);
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    Pairs found;
    for (Bar bar : angles.bars()) found.emplace_back(bar.a, bar.b);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
    for (std::size_t k = 0; k < angles.bar_count(); ++k)
      EXPECT_EQ(angles.rest_lengths()[k],
                distance(s.positions[angles.bars()[k].a], s.positions[angles.bars()[k].b]));
  });
}

}  // namespace pliant::bond_law_test
