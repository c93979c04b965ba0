// SPDX-License-Identifier: MIT
// Cases in CI are enough of all, and what no sampler takes is refused in so many words.
#include <set>

#include "law/sample/sample_cases.hpp"
#include "pliant/base/error.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "support/error_text.hpp"
#include "support/frameworks.hpp"

namespace pliant {
namespace sample_refusal_law_test {

TEST(SampleCases, AnyTwoRowsOfDifferentTablesMeet) {
  const auto pairs_of = [](const std::vector<test::SampleCase>& cases) {
    std::set<std::array<std::size_t, 3>> pairs;
    for (const auto& [sampler, network, model, molecule] : cases) {
      pairs.insert({{0, sampler, network}, {1, sampler, model}, {2, sampler, molecule}});
      pairs.insert({{3, network, model}, {4, network, molecule}, {5, model, molecule}});
    }
    return pairs;
  };
  EXPECT_EQ(test::sampled_molecules().size(), 12U);
  const auto chosen = test::covering_sample_cases(), all = test::all_sample_cases();
  EXPECT_EQ(pairs_of(chosen), pairs_of(all));
  EXPECT_LT(chosen.size(), all.size() / 10);
}

class SampleRefusalLaw : public test::SampleLaw {
 protected:
  static std::string refusal_of(const SampleSubject& subject) {
    SampleOptions options;
    options.frames = 1;
    options.sampler = std::string(sampler().name);
    const SampleTask task(subject, SampleAsked{options});
    return test::error_text<OptionError>([&] { task.run({}); });
  }
};
PLIANT_FOR_ALL_SAMPLERS(SampleRefusalLaw);

TEST_P(SampleRefusalLaw, PinnedAtomsAreRefused) {
  const char* expected = "sample: the framework has pinned joints, or lies in a plane";
  each_case([&](const test::SampleCase& at) {
    const MolecularModel& model = test::model_of(at);
    SampleSubject subject = subject_of(model);
    const Joint first = 0;
    const Framework pinned = model.framework.with_pinned({&first, 1});
    EXPECT_EQ(refusal_of({pinned, subject.start, subject.nodes}), expected);
  });
}

/// A single residue is one node, whatever its atoms do.
TEST_P(SampleRefusalLaw, OneNodeIsRefused) {
  Structure methane;
  methane.atoms.residues.push_back({"UNK", 1, ' ', ""});
  const Vec3 places[] = {{0, 0, 0}, {1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (std::size_t k = 0; k < std::size(places); ++k) {
    methane.atoms.names.emplace_back(k == 0 ? "C" : "H");
    methane.atoms.elements.push_back(k == 0 ? 6 : 1);
    methane.atoms.residue_of.push_back(0);
    methane.atoms.serials.push_back(static_cast<std::int64_t>(k) + 1);
    methane.positions.push_back(0.63 * places[k]);
  }
  perceive_bonds(methane);
  for (const ModelEntry& model : models()) {
    const MolecularModel made = build_model(methane, {.kind = model.kind});
    EXPECT_EQ(refusal_of(subject_of(made)), "network: 1 node; it needs 2 or more") << model.name;
  }
}

TEST_P(SampleRefusalLaw, AnAmplitudeIsRefusedWhereThereIsNone) {
  each_case([](const test::SampleCase& at) {
    SampleAsked asked{test::options_of(at)};
    asked.amplitude = AmplitudeChoice{1.0, "1", "as given"};
    const std::string found =
        test::error_text<OptionError>([&] { SampleTask(subject_of(test::model_of(at)), asked); });
    EXPECT_EQ(found, sampler().has_amplitude ? "(nothing was thrown)"
                                             : "amplitude: sampler " + std::string(sampler().name) +
                                                   " has none: how far torsions turn is drawn");
  });
}

}  // namespace sample_refusal_law_test
}  // namespace pliant
