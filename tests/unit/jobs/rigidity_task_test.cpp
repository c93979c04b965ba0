// SPDX-License-Identifier: MIT
#include "pliant/jobs/rigidity_task.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/read/read.hpp"
#include "support/error_text.hpp"
#include "support/source_folder.hpp"

namespace pliant {
namespace rigidity_task_test {

/// A helix with hydrogen bonds, and a tether between its ends.
ContactModel helix() {
  Structure structure = read_structure(molecule_file("peptide_20.pdb"));
  perceive_bonds(structure);
  ContactModel model = contact_model(structure);
  const auto last = static_cast<std::uint32_t>(model.structure.size() - 1);
  model.contacts.push_back({.kind = MolecularContactKind::hydrophobic, .a = 0, .b = last});
  return model;
}

/// Another value that is in range.
struct Change {
  void operator()(bool* value) const { *value = !*value; }
  void operator()(std::int64_t* value) const { *value = 1; }
  void operator()(std::string* value) const { *value = "name CA"; }
  void operator()(auto*) const { FAIL() << "has another type"; }
};

std::pair<std::size_t, std::size_t> bars_and_freedoms(const RigidityAsked& asked) {
  const RigidClusters found = find_rigidity(helix(), asked).rigidity.found;
  return {found.bars, found.freedoms};
}

TEST(RigidityTask, EachOptionChangesTheCount) {
  const auto usual = bars_and_freedoms({});
  for (const OptionField<RigidityAsked>& field : rigidity_fields()) {
    RigidityAsked asked;
    std::visit(Change{}, field.place(asked));
    EXPECT_NE(bars_and_freedoms(asked), usual) << field.name;
  }
}

TEST(RigidityTask, CountsAsTheAnalysisDoesThatItIsMadeOf) {
  const ContactModel model = helix();
  const Rigidity expected = analyse_rigidity(model.structure, model.contacts, {});
  const MoleculeRigidity found = find_rigidity(model, {});
  EXPECT_EQ(found.rigidity.found.freedoms, expected.found.freedoms);
  EXPECT_EQ(found.rigidity.flexibility, expected.flexibility);
}

TEST(RigidityTask, OptionsOutOfRangeAreRefused) {
  const auto refusal_of = [](const RigidityAsked& asked) {
    return test::error_text<OptionError>([&] { find_rigidity(helix(), asked); });
  };
  EXPECT_EQ(refusal_of({.hbond_bars = 0}), "hbond_bars = 0: must be from 1");
  EXPECT_EQ(refusal_of({.tether_bars = 7}), "tether_bars = 7: must be at most 6");
  EXPECT_EQ(refusal_of({.free_angles = "element Au"}),
            "free angles: selection \"element Au\" names no atom");
}

TEST(RigidityTask, APictureBearsTheNameOfTheFileOrAnother) {
  const MoleculeRigidity found = find_rigidity(helix(), {});
  EXPECT_NE(draw_dilution(found).svg.find(dilution_title("peptide_20.pdb")), std::string::npos);
  EXPECT_NE(draw_dilution(found, "helix").svg.find(dilution_title("helix")), std::string::npos);
}

}  // namespace rigidity_task_test
}  // namespace pliant
