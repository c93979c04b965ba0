// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/protonation.hpp"

#include <gtest/gtest.h>

#include "pliant/base/error.hpp"
#include "support/error_text.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant {
namespace protonation_test {

/// The ring of a histidine: ND1 at (0, 0, 0), NE2 2.2 Angstrom from it.
std::vector<test::MadeAtom> histidine() {
  return {{"CA", "C", {-2.5, 1.2, 0}}, {"CG", "C", {-0.7, 1.1, 0}}, {"ND1", "N", {0, 0, 0}},
          {"CE1", "C", {1.3, 0.3, 0}}, {"NE2", "N", {1.4, 1.7, 0}}, {"CD2", "C", {0.2, 2.2, 0}}};
}

std::string form_of(const Structure& s, const std::vector<std::string>& wanted = {}) {
  return protonation_of(s, wanted).forms.at(0);
}

Structure with_histidine(const char* name = "HIS") {
  Structure s;
  test::add_residue(s, name, 57, histidine());
  return s;
}

TEST(Protonation, HistidineFollowsItsSurroundings) {
  EXPECT_EQ(form_of(with_histidine()), "HIE");
  Structure beside_oxygen = with_histidine();
  test::add_residue(beside_oxygen, "GLY", 58, {{"O", "O", {-1, -2.5, 0}}});
  EXPECT_EQ(form_of(beside_oxygen), "HID");
  Structure at_metal = with_histidine();
  test::add_residue(at_metal, "ZN", 99, {{"ZN", "ZN", {3.0, 2.6, 0}}});
  EXPECT_EQ(form_of(at_metal), "HID");
  test::add_residue(at_metal, "ZN", 100, {{"ZN", "ZN", {-0.8, -1.8, 0}}});
  EXPECT_EQ(form_of(at_metal), "HIN");
}

TEST(Protonation, NamesAndWishesComeFirst) {
  EXPECT_EQ(form_of(with_histidine("HSD")), "HID");
  EXPECT_EQ(form_of(with_histidine("HIP")), "HIP");
  EXPECT_EQ(form_of(with_histidine(), {"HIS57:HID"}), "HID");
  const Protonation asked = protonation_of(with_histidine("HIP"), {"A:HIS57:HIE"});
  EXPECT_EQ(asked.forms[0], "HIE");
  EXPECT_TRUE(asked.is_asked_for[0]);
}

TEST(Protonation, WishesThatMeanNothingAreRefused) {
  Structure s = with_histidine();
  test::add_residue(s, "ASP", 25, {}, "A");
  test::add_residue(s, "ASP", 25, {}, "B");
  const auto refusal = [&](const char* wish) {
    return test::error_text<OptionError>([&] { protonation_of(s, {wish}); });
  };
  EXPECT_EQ(refusal("HIS57"),
            "protonate: expected RESIDUE:FORM such as HIS57:HID or A:HIS57:HID, found \"HIS57\"");
  EXPECT_EQ(refusal("HIS58:HID"), "protonate: \"HIS58:HID\": there is no residue \"HIS58\"");
  EXPECT_EQ(refusal("C:HIS57:HID"),
            "protonate: \"C:HIS57:HID\": there is no residue \"HIS57\" in chain \"C\"");
  EXPECT_EQ(refusal("ASP25:ASH"),
            "protonate: \"ASP25:ASH\": 2 residues are \"ASP25\"; say which chain, as in "
            "\"A:ASP25:ASH\"");
  EXPECT_EQ(refusal("HIS57:ASH"), "protonate: \"HIS57:ASH\": ASH is a form of ASP");
}

}  // namespace protonation_test
}  // namespace pliant
