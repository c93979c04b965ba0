// SPDX-License-Identifier: MIT
// Limits that are on hold in every frame, to the 0.08 Angstrom that steps end at; a contact is off
// as a whole, and only where the sampler lets contacts go. No two atoms are nearer than the table
// of sterics says, where the model has one: pairs four bonds apart or more, all of them looked at,
// with least distances by the words of the pages.
#include "law/sample/sample_cases.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/steric_table.hpp"
#include "support/test.hpp"

namespace pliant::sample_limits_law_test {

constexpr double held = 0.08 + 1e-9;  // Angstrom

class SampleLimitsLaw : public test::SampleLaw {
 protected:
  /// Of every molecule with its contacts: those of CI alone have few.
  template <class Look>
  static void each_protein_frame(Look look) {
    for (const test::SampleCase& at : test::all_sample_cases()) {
      const bool has_contacts = models()[at.model].has_contacts;
      if (at.sampler != GetParam() || !has_contacts) continue;
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

constexpr double kept = 0.08 + 1e-9;  // Angstrom, at which steps end

class SampleOverlapLaw : public test::SampleLaw {};
PLIANT_FOR_ALL_SAMPLERS(SampleOverlapLaw);

constexpr int far = 1000;  // no bonds lead there

/// Bonds from an atom to each other.
std::vector<int> bonds_from(std::uint32_t atom, const AtomGraph& graph, std::size_t atoms) {
  std::vector<int> apart(atoms, far);
  apart[atom] = 0;
  for (int step = 0; std::ranges::count(apart, step) > 0; ++step)
    for (std::uint32_t k = 0; k < atoms; ++k)
      if (apart[k] == step)
        for (const Link& bond : graph.at(k))
          apart[bond.node] = std::min(apart[bond.node], step + 1);
  return apart;
}

struct Pair {
  std::uint32_t a, b;
  double least;
};

/// Pairs that are nearer at the start keep the distance that they have there; heavy atoms of
/// conformers come nearer where they are four bonds apart, but none more than that to 2.68
/// Angstrom.
std::vector<Pair> pairs_of(const MolecularModel& model, bool is_soft) {
  const Sterics table = molecular_sterics(model.structure, false);
  const AtomGraph graph(model.structure);
  const std::size_t atoms = model.structure.size();
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < atoms; ++a) {
    const std::vector<int> apart = bonds_from(a, graph, atoms);
    for (std::uint32_t b = a + 1; b < atoms; ++b) {
      if (apart[b] <= 3) continue;
      const double usual = table.of_kinds(a, b);
      const double start = distance(model.positions[a], model.positions[b]);
      const bool are_heavy = !graph.is_hydrogen(a) && !graph.is_hydrogen(b);
      const bool is_known = apart[b] == 4 || (apart[b] > 4 && apart[b] < far && atoms <= 300);
      const double soft = std::max((apart[b] == 4 ? 0.9 : 1.0) * usual, 2.68);
      const bool is_own = is_soft && are_heavy && is_known && start >= std::max(usual, soft);
      pairs.push_back({a, b, is_own ? soft : std::min(usual, start)});
    }
  }
  return pairs;
}

TEST_P(SampleOverlapLaw, NoneIsDeeperThanReported) {
  const SampleTask* last = nullptr;
  std::vector<Pair> pairs;
  each_frame([&](const test::SampleCase& at, const SampleTask& task, const test::KeptFrame& frame) {
    if (!models()[at.model].has_sterics) return;
    if (&task != last || frame.frame == 0)
      pairs = pairs_of(test::model_of(at), !sampler().has_amplitude);
    last = &task;
    double worst = 0.0;
    for (const Pair& pair : pairs) {
      const double depth = pair.least - distance(frame.positions[pair.a], frame.positions[pair.b]);
      if (depth > kept)
        ADD_FAILURE() << task.framework().label(Bar{pair.a, pair.b}) << ": " << depth;
      worst = std::max(worst, depth);
    }
    EXPECT_NEAR(frame.max_overlap, worst, 1e-9);
  });
}

}  // namespace pliant::sample_limits_law_test
