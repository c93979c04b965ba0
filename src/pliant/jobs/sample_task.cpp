// SPDX-License-Identifier: MIT
#include "pliant/jobs/sample_task.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/conformers/torsions/conformer_framework.hpp"
#include "pliant/model/atoms/residue_nodes.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/sample/pocket/pocket.hpp"
#include "pliant/sample/sample_fields.hpp"
#include "pliant/sample/samplers.hpp"

namespace pliant {
namespace {

std::string_view usual_sampler(const SampleSubject& subject, const SampleOptions& options) {
  const std::size_t residues = subject.has_residues ? subject.nodes.positions.size() : 0;
  return pliant::usual_sampler(subject.framework, subject.start, residues, !options.around.empty());
}

/// Whether all frames are near ones.
bool is_near_alone(const SampleOptions& options) {
  return options.near_frames >= options.first_frame + options.frames;
}

/// What `around` selects, and whether `hold` has a ligand there. Throws OptionError if that is no
/// place in a protein.
void find_place(const SampleSubject& subject, std::string_view dashes, SampleOptions& options) {
  const std::string name = std::string(dashes) + "around";
  options.around_joints = select_joints(subject.framework, options.around, name);
  bool has_ligand = false;
  if (!options.around.empty()) {
    if (!find_sampler(options.sampler).has_place)
      throw OptionError(
          name + ": goes with sampler " +
          std::string(std::ranges::find(samplers(), true, &SamplerEntry::has_place)->name) +
          ", not with " + options.sampler);
    const auto& joints = options.around_joints;
    has_ligand = !pocket_around(subject.framework, subject.start, joints).ligand.empty();
  }
  if (!has_ligand && options.hold != SampleOptions{}.hold)
    throw OptionError(std::string(dashes) + "hold: goes with a ligand that " + name + " selects");
}

void choose_sampler(const SampleSubject& subject, SampleOptions& options) {
  const bool is_open = options.sampler == automatic_sampler;
  if (is_open) options.sampler = usual_sampler(subject, options);
  const SamplerEntry& sampler = find_sampler(options.sampler);
  if (options.frames == open_frames) options.frames = sampler.frames;
  check(options);
  options.near_frames = sampler.near_sampler.empty() ? 0 : near_frames_of(options);
  if (options.near_frames == 0 || !is_near_alone(options)) return;
  const std::string near(sampler.near_sampler);
  if (!is_open)
    options.log.warn("sampler " + options.sampler + ": all frames are those of sampler " + near +
                     "; it turns domains in those from number " +
                     std::to_string(options.near_frames) + " on");
  options.sampler = near;
  options.near_frames = 0;
}

SampleOptions completed(const SampleSubject& subject, const SampleAsked& asked) {
  SampleOptions options = asked.options;
  if (asked.amplitude) options.amplitude = asked.amplitude->value;
  choose_sampler(subject, options);
  find_place(subject, asked.dashes, options);
  if (asked.amplitude && !find_sampler(options.sampler).has_amplitude)
    throw OptionError(std::string(asked.dashes) + "amplitude: sampler " + options.sampler +
                      " has none: how far torsions turn is drawn");
  return options;
}

}  // namespace

SampleSubject subject_of(const MolecularModel& model) {
  ResidueNodes found = residue_nodes(model.structure);
  return {model.framework,
          model.positions,
          {std::move(found.positions), std::move(found.chain), std::move(found.of_atom)},
          usual_model(model.structure) == ModelKind::protein};
}

SampleTask::SampleTask(SampleSubject subject, const SampleAsked& asked)
    : subject_(std::move(subject)), options_(completed(subject_, asked)) {
  if (!find_sampler(options_.sampler).has_amplitude)
    conformers_ =
        conformer_framework(subject_.framework, subject_.start, conformer_moves(options_));
}

SampleTask::SampleTask(SampleSubject subject, const SampleOptions& recorded)
    : subject_(std::move(subject)), options_(recorded) {
  check(options_);
  find_place(subject_, "", options_);
}

const Framework& SampleTask::framework() const {
  return conformers_ ? *conformers_ : subject_.framework;
}

SampleSummary SampleTask::run(const SampleObserver& observer,
                              std::function<bool()> should_stop) const {
  SampleOptions options = options_;
  if (should_stop) options.should_stop = std::move(should_stop);
  return sample(framework(), start(), nodes(), options, observer);
}

}  // namespace pliant
