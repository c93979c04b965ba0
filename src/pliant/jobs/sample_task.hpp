// SPDX-License-Identifier: MIT
// The task `sample`, conformers included: from a model and options to frames. The command, Python,
// the page and a continued sample all use it.
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

/// What is sampled. The framework and the start must outlive the task.
struct SampleSubject {
  const Framework& framework;
  std::span<const Vec3> start;  ///< (N) Angstrom
  NetworkNodes nodes;
  bool has_residues = false;  ///< has residues of proteins or nucleic acids
};

/// A model with its residues as nodes. With fewer than two, the task refuses to run.
SampleSubject subject_of(const MolecularModel& model);

/// Options given before the molecule is known.
struct SampleAsked {
  SampleOptions options;  ///< unset_sample_options() at first
  /// Amplitude that replaces that of the options; none: that one, which every sampler accepts.
  std::optional<AmplitudeChoice> amplitude = std::nullopt;
  std::string_view dashes = "";  ///< prefix of an option's name in messages: "--" for the command
};

/// A sample that is ready to run.
class SampleTask {
 public:
  /// Makes the choices left open, and the framework of conformers if the sampler has no amplitude.
  /// Throws OptionError for bad options, and for an amplitude if the sampler has none.
  SampleTask(SampleSubject subject, const SampleAsked& asked);

  /// Continues a sample with the subject and the options of an earlier task. Throws OptionError.
  SampleTask(SampleSubject subject, const SampleOptions& recorded);

  SampleTask(const SampleTask&) = delete;
  SampleTask& operator=(const SampleTask&) = delete;

  /// The options, without open choices.
  const SampleOptions& options() const { return options_; }
  /// The framework of the frames.
  const Framework& framework() const;
  /// The framework of conformers, if the frames use it; otherwise null.
  const Framework* conformers() const { return conformers_ ? &*conformers_ : nullptr; }
  std::span<const Vec3> start() const { return subject_.start; }
  const NetworkNodes& nodes() const { return subject_.nodes; }

  /// Makes the frames by sample(). Throws as it does.
  SampleSummary run(const SampleObserver& observer, std::function<bool()> should_stop = {}) const;

 private:
  SampleSubject subject_;
  SampleOptions options_;
  std::optional<Framework> conformers_;
};

}  // namespace pliant
