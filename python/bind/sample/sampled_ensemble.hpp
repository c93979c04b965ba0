// SPDX-License-Identifier: MIT
// An ensemble in memory: its frames, and all that a file of it would hold.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bind.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "pliant/model/amplitude.hpp"
#include "pliant/model/model.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/sample/sample.hpp"

namespace pliant::python {

/// Where frames are written.
struct SampleOutput {
  std::optional<std::filesystem::path> path;
  H5mdOptions options;
  std::string save = {};  ///< selection of the atoms; "": all
};

/// Throws OptionError for names that are not of H5MD.
SampleOutput sample_output(const std::optional<std::filesystem::path>& path, bool overwrite,
                           bool single, bool compress, double precision, const std::string& save);

/// Frames, and what they were made of.
struct SampledEnsemble {
  MolecularModel model;
  AmplitudeChoice amplitude;
  std::vector<Vec3> positions;  ///< (F * N)
  SampleSummary summary;
  H5mdHeader header;                                  ///< without how it is recorded
  std::vector<Frame> frames;                          ///< (F) without spans
  std::vector<std::vector<std::uint8_t>> limits_off;  ///< (F) of these frames

  /// How many atoms a frame has.
  std::size_t atoms() const { return model.positions.size(); }
  void add(const Frame& frame);
  Frame frame(std::size_t k) const;
};

/// What a file of it holds besides frames.
H5mdHeader header_of_sample(const MolecularModel& model, const AmplitudeChoice& amplitude,
                            const SampleTask& task);

/// The same with how it is recorded.
H5mdHeader header_for(H5mdHeader header, const SampleOutput& output);

void bind_sampled_ensemble(nb::module_& module);

}  // namespace pliant::python
