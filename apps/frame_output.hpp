// SPDX-License-Identifier: MIT
// Where run and sample put their frames: an H5MD file, or a PDB file by its name.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/record/pdb_recorder.hpp"

namespace pliant::app {

/// Whether the name is one of PDB (.pdb, .ent).
bool is_pdb_name(const std::string& output);

/// Throws OptionError if options of H5MD are given for a PDB file.
void check_record_options(const std::string& output, const H5mdOptions& options);

/// Records frames in the format that the name asks for.
class FrameOutput {
 public:
  /// A PDB file takes names and bonds only. Throws as the recorders do.
  FrameOutput(const std::string& output, const Framework& framework, const H5mdHeader& header,
              const H5mdOptions& options);

  void record(const Frame& frame);
  /// The run of the frames ends in this state. A PDB file cannot keep it.
  void end_run(const State& state);
  void close();

 private:
  std::optional<H5mdRecorder> h5md_;
  std::optional<PdbRecorder> pdb_;
};

}  // namespace pliant::app
