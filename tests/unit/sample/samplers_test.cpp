// SPDX-License-Identifier: MIT
#include "pliant/sample/samplers.hpp"

#include <gtest/gtest.h>

#include <set>

#include "pliant/base/error.hpp"
#include "support/error_text.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant {
namespace samplers_test {

TEST(Samplers, EachHasANameOfItsOwnAndSaysWhatItDoes) {
  std::set<std::string_view> names;
  for (const SamplerEntry& row : samplers()) {
    EXPECT_TRUE(names.insert(row.name).second);
    EXPECT_FALSE(row.summary.empty());
    EXPECT_EQ(&find_sampler(row.name), &row);
  }
  EXPECT_EQ(test::error_text<OptionError>([] {
              find_sampler("mode");
            }).rfind("no sampler named \"mode\" (did you mean \"modes\"?)", 0),
            0U);
}

TEST(Samplers, TheUsualOneFollowsFromTheMolecule) {
  const auto usual = [](const char* file, std::size_t residues, bool has_place = false) {
    const MolecularModel model = test::model_of(file);
    return usual_sampler(model.framework, model.positions, residues, has_place);
  };
  EXPECT_EQ(usual("butane.sdf", 0), "torsions");
  EXPECT_EQ(usual("butane.sdf", 100), "modes");
  EXPECT_EQ(usual("butane.sdf", 101), "reach");
  EXPECT_EQ(usual("butane.sdf", 0, true), "pocket");
  EXPECT_EQ(usual("crown_18_6.cif", 0), "torsions");
}

TEST(Samplers, SeveralMoleculesMoveAgainstEachOtherByModes) {
  const MolecularModel one = test::model_of("butane.sdf");
  FrameworkParts parts = one.framework.parts();
  std::vector<Vec3> start = one.positions;
  const auto joints = static_cast<Joint>(parts.joint_count);
  const std::size_t bars = parts.bars.size();
  for (std::size_t k = 0; k < bars; ++k) {
    parts.bars.push_back({parts.bars[k].a + joints, parts.bars[k].b + joints});
    parts.rest_lengths.push_back(parts.rest_lengths[k]);
  }
  for (Joint k = 0; k < joints; ++k) start.push_back(start[k] + Vec3{0, 0, 9});
  parts.joint_count *= 2;
  parts.masses.clear();
  parts.sterics = nullptr;
  parts.torsion_preferences = nullptr;
  parts.atoms = nullptr;
  parts.drawn = start;
  EXPECT_EQ(usual_sampler(Framework(std::move(parts)), start, 0), "modes");
}

}  // namespace samplers_test
}  // namespace pliant
