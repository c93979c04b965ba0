// SPDX-License-Identifier: MIT
#include "pliant/jobs/run_job.hpp"

#include "pliant/jobs/continued_run.hpp"
#include "pliant/jobs/rigidity_task.hpp"
#include "pliant/jobs/run_outputs.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/read/read.hpp"
#include "pliant/run/run.hpp"
#include "support/frameworks.hpp"
#include "support/source_folder.hpp"
#include "support/test.hpp"
#include "unit/record/recorded_runs.hpp"

namespace pliant::run_job_test {

Job job_of(std::int64_t steps, const std::string& technique = "auto") {
  Job job = usual_job("run");
  job.run.technique.name = technique;
  job.run.steps = steps;
  job.run.every = 4;
  job.run.perturb = "displacement";
  job.output.topology = no_topology;
  job.walkers.threads = 2;
  return job;
}

RunSubject subject_of(const Framework& framework, const Sketch& sketch) {
  RunSubject subject{framework, sketch.positions};
  subject.is_given = true;
  return subject;
}

TEST(RunJob, AWalkerMakesTheFramesOfTheLibrary) {
  for (const Sketch& sketch : {chain(12), ring(8)})
    for (const char* technique : {"auto", "bfs_cycle", "random", "shake"}) {
      SCOPED_TRACE(technique);
      const Framework framework = framework_of(sketch);
      RunJob job(job_of(13, technique), "");
      job.take(subject_of(framework, sketch), {});
      State ours(sketch.positions), theirs(sketch.positions);
      std::vector<std::int64_t> steps;
      RunWatch watch;
      watch.observers_of = [&](std::int64_t) {
        return std::vector<Observer>{[&](const Frame& frame) {
          steps.push_back(frame.step);
          return false;
        }};
      };
      const RunSummary summary = job.run_alone(ours, watch);
      run(framework, theirs, job.job().run, {});
      EXPECT_EQ(steps, (std::vector<std::int64_t>{0, 4, 8, 12, 13}));
      EXPECT_EQ(summary.steps, 13);
      EXPECT_EQ(ours.positions, theirs.positions);
    }
}

TEST(RunJob, WalkersGoOnFromTheirFilesAsIfTheyHadNeverStopped) {
  const test::TempDirectory folder;
  const Sketch sketch = chain(12);
  const Framework framework = framework_of(sketch);
  const auto record = [&](const char* name, std::int64_t steps) {
    Job job = job_of(steps);
    job.walkers.walkers = 3;
    job.output.output = (folder / name).string();
    RunJob run(job, "--");
    run.take(subject_of(framework, sketch), {});
    run.run(State(sketch.positions), {});
    return run.job();
  };
  const Job whole = record("whole.h5md", 21);
  Job part = record("part.h5md", 10);
  std::filesystem::remove(output_of(part, 1));  // as if it had never begun
  part.go_on = part.output.output;
  ContinuedRun continued(part, 21, "--", {});
  const std::vector<RunSummary> summaries = continued.run({});
  EXPECT_EQ(summaries[0].frames, 4);  // 12, 16, 20 and 21; that of step 10 makes way
  for (std::int64_t walker = 0; walker < 3; ++walker)
    test::expect_same_file(output_of(whole, walker), output_of(part, walker));
}

TEST(RunJob, OptionsThatExcludeEachOtherAreRefused) {
  const std::pair<const char*, std::function<void(Job&)>> cases[] = {
      {"one_file: is for several walkers: give walkers or shard",
       [](Job& job) { job.walkers.one_file = true; }},
      {"commits: goes with one_file; other trajectories have --continue",
       [](Job& job) { job.output.commits = "c"; }},
      {"--amplitude: goes with --rock", [](Job& job) { job.given = {"amplitude"}; }},
      {"--imd: follows one walker, not several",
       [](Job& job) { job.is_live = true, job.walkers.walkers = 2; }}};
  for (const auto& [text, change] : cases) {
    Job job = job_of(5);
    change(job);
    EXPECT_ERROR(OptionError, text, settle_walkers(job));
  }
}

TEST(RunJob, AForceFileHoldsOneForceAStep) {
  const Sketch sketch = chain(5);
  const Framework framework = framework_of(sketch);
  Job job = job_of(5);
  job.walkers.record_forces = "f.txt";
  for (const auto& [dashes, text] :
       {std::pair{"--",
                  "--record-forces: a force file holds one force on one joint a step, which "
                  "displacement is not; use --perturb force"},
        std::pair{"",
                  "record_forces: a force file holds one force on one joint a step, which "
                  "displacement is not; use perturb=\"force\""}}) {
    RunJob run(job, dashes);
    EXPECT_ERROR(OptionError, text, run.take(subject_of(framework, sketch), {}));
  }
}

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
  const std::pair<const char*, RigidityAsked> cases[] = {
      {"hbond_bars = 0: must be from 1", {.hbond_bars = 0}},
      {"tether_bars = 7: must be at most 6", {.tether_bars = 7}},
      {"free angles: selection \"element Au\" names no atom", {.free_angles = "element Au"}}};
  for (const auto& [text, asked] : cases)
    EXPECT_ERROR(OptionError, text, find_rigidity(helix(), asked));
}

TEST(RigidityTask, APictureBearsTheNameOfTheFileOrAnother) {
  const MoleculeRigidity found = find_rigidity(helix(), {});
  EXPECT_NE(draw_dilution(found).svg.find(dilution_title("peptide_20.pdb")), std::string::npos);
  EXPECT_NE(draw_dilution(found, "helix").svg.find(dilution_title("helix")), std::string::npos);
}

}  // namespace pliant::run_job_test
