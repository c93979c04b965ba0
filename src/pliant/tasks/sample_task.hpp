// SPDX-License-Identifier: MIT
// The task `sample`, conformers among them: from a model and what is asked for to frames. The
// command, Python, the page and what goes on with a recorded sample come in through this door.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/base/parameter.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/model/amplitude.hpp"
#include "pliant/model/model.hpp"
#include "pliant/sample/network/elastic_network.hpp"
#include "pliant/sample/sample.hpp"

namespace pliant {

/// What is sampled. The framework and the start outlive the task.
struct SampleSubject {
  const Framework& framework;
  std::span<const Vec3> start;  ///< (N) Angstrom
  NetworkNodes nodes;
  bool has_residues = false;  ///< of proteins or nucleic acids
};

/// A model, its residues as nodes. Where there are fewer than two, the task refuses to run.
SampleSubject subject_of(const MolecularModel& model);

/// What one asks for who has not yet seen the molecule.
struct SampleAsked {
  SampleOptions options;  ///< as unset_sample_options(), for a start
  /// Which goes into the options; none: that of the options, which goes with every sampler.
  std::optional<AmplitudeChoice> amplitude = std::nullopt;
  std::string_view dashes = "";  ///< of an option's name in messages: "--" of the command
};

/// A sample that is ready to be made.
class SampleTask {
 public:
  /// Chooses what was left open, and makes the framework of conformers where the sampler has no
  /// amplitude. Throws OptionError for bad options, and for an amplitude that goes with none.
  SampleTask(SampleSubject subject, const SampleAsked& asked);

  /// Goes on with a sample: both are as an earlier task had them. Throws OptionError.
  SampleTask(SampleSubject subject, const SampleOptions& recorded);

  SampleTask(const SampleTask&) = delete;
  SampleTask& operator=(const SampleTask&) = delete;

  /// Nothing is left open in them.
  const SampleOptions& options() const { return options_; }
  /// What frames are of.
  const Framework& framework() const;
  /// Where that is not the subject's own: the framework of conformers; else null.
  const Framework* conformers() const { return conformers_ ? &*conformers_ : nullptr; }
  std::span<const Vec3> start() const { return subject_.start; }
  const NetworkNodes& nodes() const { return subject_.nodes; }

  /// Makes the frames, as sample() does, which this is all about; and throws as it does.
  SampleSummary run(const SampleObserver& observer, std::function<bool()> should_stop = {}) const;

 private:
  SampleSubject subject_;
  SampleOptions options_;
  std::optional<Framework> conformers_;
};

}  // namespace pliant
