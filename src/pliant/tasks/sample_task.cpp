// SPDX-License-Identifier: MIT
#include "pliant/tasks/sample_task.hpp"

#include <string>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/model/atoms/residue_nodes.hpp"
#include "pliant/sample/conformers/conformer_framework.hpp"
#include "pliant/sample/sample_fields.hpp"
#include "pliant/sample/samplers.hpp"

namespace pliant {
namespace {

SampleOptions completed(const SampleSubject& subject, const SampleAsked& asked) {
  SampleOptions options = asked.options;
  if (asked.amplitude) options.amplitude = asked.amplitude->value;
  if (options.sampler == automatic_sampler)
    options.sampler = usual_sampler(subject.framework, subject.start, subject.has_residues);
  check(options);
  if (options.sampler == "reach") options.near_frames = near_frames_of(options);
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
    conformers_ = conformer_framework(subject_.framework, subject_.start);
}

SampleTask::SampleTask(SampleSubject subject, const SampleOptions& recorded)
    : subject_(std::move(subject)), options_(recorded) {
  check(options_);
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
