// SPDX-License-Identifier: MIT
// Limits that are on hold in every frame, to the 0.08 Angstrom that steps end at; a contact is off
// as a whole, and only where the sampler lets contacts go.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "law/sample/sample_cases.hpp"

namespace pliant {
namespace sample_limits_law_test {

constexpr double held = 0.08 + 1e-9;  // Angstrom

class SampleLimitsLaw : public test::SampleLaw {
 protected:
  /// Of every molecule with its contacts: those of CI alone have few.
  template <class Look>
  static void each_protein_frame(Look look) {
    for (const test::SampleCase& at : test::all_sample_cases()) {
      const bool has_contacts = models()[at.model].has_contacts;
      if (at.sampler != GetParam() || !has_contacts || at.network != 0) continue;
      SCOPED_TRACE(at.name());
      const auto task = test::task_of(at, test::options_of(at));
      for (const test::KeptFrame& frame : test::frames_of(*task)) look(*task, frame);
    }
  }
};
PLIANT_FOR_ALL_SAMPLERS(SampleLimitsLaw);

bool is_on(const test::KeptFrame& frame, std::size_t limit) {
  return frame.limits_off.empty() || frame.limits_off[limit] == 0;
}

TEST_P(SampleLimitsLaw, ThoseThatAreOnHoldAsReported) {
  each_frame([](const test::SampleCase&, const SampleTask& task, const test::KeptFrame& frame) {
    double worst = 0.0;
    const auto limits = task.framework().limits();
    for (std::size_t k = 0; k < limits.size(); ++k) {
      if (!is_on(frame, k)) continue;
      const double length = distance(frame.positions[limits[k].a], frame.positions[limits[k].b]);
      worst = std::max({worst, length - limits[k].most, limits[k].least - length});
    }
    EXPECT_LE(worst, held);
    // Frames of walks are turned back onto the ones before, which rounds.
    EXPECT_NEAR(frame.max_limit, worst, 1e-9);
  });
}

/// Whether the frame does not hold this contact, and says so.
bool is_let_go(const SampleTask& task, const test::KeptFrame& frame,
               const MolecularContact& contact) {
  const auto limits = task.framework().limits();
  for (std::size_t k = 0; k < limits.size(); ++k) {
    const bool is_it = std::minmax<std::size_t>({limits[k].a, limits[k].b}) ==
                       std::minmax<std::size_t>({contact.a, contact.b});
    if (is_it && !is_on(frame, k)) return true;
  }
  return false;
}

TEST_P(SampleLimitsLaw, ContactsOfTheModelHold) {
  if (sampler().name == "dilute") GTEST_SKIP() << "turns them off";
  each_frame([](const test::SampleCase& at, const SampleTask& task, const test::KeptFrame& frame) {
    for (const MolecularContact& contact : test::model_of(at).contacts) {
      if (is_let_go(task, frame, contact)) continue;
      const double length = distance(frame.positions[contact.a], frame.positions[contact.b]);
      EXPECT_LE(length, contact.most + held);
      EXPECT_GE(length, contact.least - held);
    }
  });
}

TEST_P(SampleLimitsLaw, OnlyDilutingTurnsContactsOffEachAsAWhole) {
  // Turns let go of contacts between domains that move apart, whatever their energy, and so do side
  // chains that are redrawn.
  const bool lets_go =
      sampler().name == "turns" || sampler().name == "reach" || sampler().name == "pocket";
  std::size_t off = 0;
  each_protein_frame([&](const SampleTask& task, const test::KeptFrame& frame) {
    std::map<std::uint32_t, std::set<bool>> states;
    const auto limits = task.framework().limits();
    for (std::size_t k = 0; k < limits.size(); ++k) {
      off += is_on(frame, k) ? 0U : 1U;
      EXPECT_TRUE(is_on(frame, k) || limits[k].energy != 0.0 || lets_go);
      if (limits[k].group != no_limit_group) states[limits[k].group].insert(is_on(frame, k));
    }
    for (const auto& [group, known] : states) EXPECT_EQ(known.size(), 1U) << "group " << group;
  });
  if (!lets_go) EXPECT_EQ(off > 0, sampler().name == "dilute");
}

}  // namespace sample_limits_law_test
}  // namespace pliant
