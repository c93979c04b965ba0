// SPDX-License-Identifier: MIT
// An ensemble in memory: its frames, and all that a file of it would hold.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bind.hpp"
#include "pliant/jobs/asked/output_options.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "pliant/model/amplitude.hpp"
#include "pliant/model/model.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/sample/sample.hpp"

namespace pliant::python {

/// The output that scripts ask for, by rows of output_fields(). Throws OptionError for names that
/// are not of H5MD; raises as take_values().
OutputOptions take_output(nb::dict given);

/// Frames, and what they were made of.
struct SampledEnsemble {
  MolecularModel model;
  AmplitudeChoice amplitude;
  std::vector<Vec3> positions;  ///< (F * N)
  SampleSummary summary;
  H5mdHeader header;                                  ///< of a file of these frames
  std::vector<Frame> frames;                          ///< (F) without spans
  std::vector<std::vector<std::uint8_t>> limits_off;  ///< (F) of these frames

  /// How many atoms a frame has.
  std::size_t atoms() const { return model.positions.size(); }
  void add(const Frame& frame);
  Frame frame(std::size_t k) const;
};

void bind_sampled_ensemble(nb::module_& module);

}  // namespace pliant::python
