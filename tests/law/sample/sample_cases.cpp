// SPDX-License-Identifier: MIT
#include "law/sample/sample_cases.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>

#include "pliant/jobs/sample_checkpoint.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/read/read.hpp"
#include "support/frameworks.hpp"
#include "support/source_folder.hpp"

namespace pliant::test {
namespace {

Structure with_bonds(Structure structure) {
  perceive_bonds(structure);
  return structure;
}

Structure from_data(const char* file) { return with_bonds(read_structure(molecule_file(file))); }

Structure from_law(const char* file) {
  return with_bonds(
      read_structure((source_folder() / "tests/law/sample/molecules" / file).string()));
}

/// Adds the residues of another structure, which has no bonds yet, shifted.
void add_residues(Structure& s, const Structure& more, const std::string& chain, Vec3 shift) {
  const auto first = static_cast<std::uint32_t>(s.atoms.residues.size());
  for (Residue residue : more.atoms.residues) {
    residue.chain = chain;
    s.atoms.residues.push_back(residue);
    s.chain_end.push_back(false);
  }
  s.chain_end.back() = true;
  for (std::size_t k = 0; k < more.size(); ++k) {
    s.atoms.names.push_back(more.atoms.names[k]);
    s.atoms.elements.push_back(more.atoms.elements[k]);
    s.atoms.residue_of.push_back(first + more.atoms.residue_of[k]);
    s.atoms.serials.push_back(static_cast<std::int64_t>(s.atoms.serials.size()) + 1);
    s.positions.push_back(more.positions[k] + shift);
  }
}

/// One dipeptide above another.
Structure two_chains() {
  Structure both;
  const Structure one = read_structure(molecule_file("alanine_dipeptide.pdb"));
  add_residues(both, one, "A", {});
  add_residues(both, one, "B", {0, 0, 5.5});
  return with_bonds(std::move(both));
}

/// Zinc between the oxygens at the end of a chain.
Structure zinc() {
  Structure s;
  add_residues(s, from_law("zwitterion.pdb"), "A", {});
  const auto place_of = [&](std::string_view name) {
    const auto at = std::find(s.atoms.names.rbegin(), s.atoms.names.rend(), name);
    return s.positions[static_cast<std::size_t>(s.atoms.names.rend() - at) - 1];
  };
  const Vec3 carbon = place_of("C");
  const Vec3 out = 0.5 * (place_of("O") + place_of("OXT")) - carbon;
  Structure metal;
  metal.atoms.residues.push_back({"ZN", 900, ' ', ""});
  metal.atoms.names.emplace_back("ZN");
  metal.atoms.elements.push_back(30);
  metal.atoms.residue_of.push_back(0);
  metal.positions.push_back(carbon + (2.4 / norm(out)) * out);
  add_residues(s, metal, "Z", {});
  return with_bonds(std::move(s));
}

constexpr SampledMolecule molecules[] = {
    {"butane", "rotors alone", [] { return from_data("butane.sdf"); }},
    {"pentenol", "an alcohol: a centre and a double bond", [] { return from_law("pentenol.sdf"); }},
    {"cyclohexane", "a chair that turns over", [] { return from_data("cyclohexane_chair.xyz"); }},
    {"crown_18_6", "a macrocycle", [] { return from_data("crown_18_6.cif"); }},
    {"biphenyl", "two flat rings", [] { return from_law("biphenyl.sdf"); }},
    {"proline", "a tertiary amide", [] { return from_law("proline.pdb"); }},
    {"peptide_20", "a helix of all amino acids", [] { return from_data("peptide_20.pdb"); }},
    {"disulphide", "a loop of four residues", [] { return from_law("disulphide.pdb"); }},
    {"dinucleotide", "sugars, bases, phosphate", [] { return from_law("dinucleotide.pdb"); }},
    {"zwitterion", "charged at both ends", [] { return from_law("zwitterion.pdb"); }},
    {"zinc", "a metal between two oxygens", zinc},
    {"two_chains", "molecules that move apart", two_chains},
};

/// (table, row, table, row)
using RowPair = std::array<std::size_t, 4>;

std::vector<RowPair> pairs_of(const SampleCase& at) {
  const std::array<std::size_t, 3> rows{at.sampler, at.model, at.molecule};
  std::vector<RowPair> pairs;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) pairs.push_back({j, rows[j], i, rows[i]});
  return pairs;
}

std::size_t new_pairs(const SampleCase& at, const std::set<RowPair>& seen) {
  const auto pairs = pairs_of(at);
  return static_cast<std::size_t>(std::count_if(
      pairs.begin(), pairs.end(), [&](const RowPair& pair) { return seen.count(pair) == 0; }));
}

}  // namespace

std::span<const SampledMolecule> sampled_molecules() { return molecules; }

std::string SampleCase::name() const {
  return std::string(samplers()[sampler].name) + ", " + std::string(models()[model].name) + ", " +
         std::string(molecules[molecule].name);
}

std::vector<SampleCase> all_sample_cases() {
  std::vector<SampleCase> all;
  for (std::size_t sampler = 0; sampler < samplers().size(); ++sampler)
    for (std::size_t model = 0; model < models().size(); ++model)
      for (std::size_t molecule = 0; molecule < std::size(molecules); ++molecule)
        all.push_back({sampler, model, molecule});
  return all;
}

std::vector<SampleCase> covering_sample_cases() {
  const std::vector<SampleCase> all = all_sample_cases();
  std::vector<SampleCase> chosen;
  std::set<RowPair> seen;
  for (;;) {
    const SampleCase* best = nullptr;
    std::size_t most = 0;
    for (const SampleCase& at : all) {
      const std::size_t gain = new_pairs(at, seen);
      if (gain <= most) continue;
      best = &at;
      most = gain;
    }
    if (best == nullptr) return chosen;
    chosen.push_back(*best);
    for (const RowPair& pair : pairs_of(*best)) seen.insert(pair);
  }
}

const MolecularModel& model_of(const SampleCase& at) {
  static std::map<std::pair<std::size_t, std::size_t>, MolecularModel> made;
  const auto key = std::pair(at.model, at.molecule);
  const auto found = made.find(key);
  if (found != made.end()) return found->second;
  const Structure structure = molecules[at.molecule].make();
  return made.emplace(key, build_model(structure, {.kind = models()[at.model].kind})).first->second;
}

bool may_fail(const SampleCase& at) {
  return !samplers()[at.sampler].has_amplitude && !model_of(at).contacts.empty();
}

SampleOptions options_of(const SampleCase& at) {
  SampleOptions options;
  options.frames = 5;
  options.amplitude = 0.6;
  options.seed = 20240607;
  options.sampler = std::string(samplers()[at.sampler].name);
  if (options.sampler == "reach") options.near_frames = 1;
  return options;
}

std::unique_ptr<SampleTask> task_of(const SampleCase& at, const SampleOptions& options) {
  return std::make_unique<SampleTask>(subject_of(model_of(at)), SampleAsked{options});
}

namespace {

KeptFrame kept(const Frame& frame) {
  return {frame.step,
          {frame.positions.begin(), frame.positions.end()},
          {frame.limits_off.begin(), frame.limits_off.end()},
          frame.max_residual,
          frame.max_limit,
          frame.max_overlap};
}

}  // namespace

std::vector<KeptFrame> frames_of(const SampleTask& task) {
  std::vector<KeptFrame> frames;
  const SampleSummary summary = task.run([&](const Frame& frame) {
    frames.push_back(kept(frame));
    return false;
  });
  EXPECT_EQ(summary.frames, static_cast<std::int64_t>(frames.size()));
  EXPECT_EQ(summary.frames + summary.failed, task.options().frames);
  return frames;
}

std::vector<KeptFrame> record_sample(const std::filesystem::path& path, const SampleTask& task,
                                     std::size_t frames, const H5mdOptions& recording) {
  H5mdHeader header;
  header.parameters = parameters_of(task.options());
  header.inputs = sample_inputs(task.start(), task.nodes());
  H5mdRecorder recorder(path, task.framework(), header, recording);
  std::vector<KeptFrame> recorded;
  task.run([&](const Frame& frame) {
    recorder.record(frame);
    recorded.push_back(kept(frame));
    return recorded.size() == frames;
  });
  recorder.close();
  return recorded;
}

std::vector<KeptFrame> frames_of(const SampleCase& at, const SampleOptions& options) {
  return frames_of(*task_of(at, options));
}

void expect_same_frames(const std::vector<KeptFrame>& one, const std::vector<KeptFrame>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].frame, other[k].frame);
    EXPECT_TRUE(same_bits(one[k].positions, other[k].positions)) << "frame " << one[k].frame;
    EXPECT_EQ(one[k].limits_off, other[k].limits_off) << "frame " << one[k].frame;
  }
}

std::vector<SampleCase> SampleLaw::cases_of(std::size_t sampler) {
  const bool takes_all = std::getenv("PLIANT_ALL") != nullptr;
  std::vector<SampleCase> cases = takes_all ? all_sample_cases() : covering_sample_cases();
  std::erase_if(cases, [&](const SampleCase& at) { return at.sampler != sampler; });
  return cases;
}

}  // namespace pliant::test
