// SPDX-License-Identifier: MIT
// Where run and sample put their frames: an H5MD file, or by its name a PDB file, or an SDF file.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/record/h5md/saved_part.hpp"
#include "pliant/record/pdb_recorder.hpp"
#include "pliant/record/sdf_recorder.hpp"

namespace pliant::app {

/// Whether the name is one of PDB (.pdb, .ent).
bool is_pdb_name(const std::string& output);

/// Whether the name is one of SDF (.sdf, .sd).
bool is_sdf_name(const std::string& output);

/// --save and --precision, which several subcommands have.
void add_saving_options(CommandLine& line, std::string& save, H5mdOptions& options);

/// Writes the names and bonds of what is recorded, at these positions (N, of all joints).
void write_topology(const std::string& path, const Framework& framework, const H5mdHeader& header,
                    std::span<const Vec3> positions, const H5mdOptions& options);

/// Asked before anything is made: the topology PDB `path`, or "none" with a warning where a
/// position has no room in its columns. Throws InputError there if the user has asked for the file.
std::string fitting_topology(const std::string& path, bool is_asked, const Framework& framework,
                             std::span<const Vec3> positions, const H5mdOptions& options);

/// Throws OptionError if options of H5MD are given for another file.
void check_record_options(const std::string& output, const std::string& save,
                          const H5mdOptions& options);

/// Records frames in the format that the name asks for.
class FrameOutput {
 public:
  /// A PDB file takes names and bonds only; an SDF file elements, bonds and what
  /// `molecule` says; its title is the name of the file where it has none. Throws as the recorders
  /// do.
  FrameOutput(const std::string& output, const Framework& framework, const H5mdHeader& header,
              const H5mdOptions& options, SdfMolecule molecule = {});

  void record(const Frame& frame);
  /// The run of the frames ends in this state. Only H5MD can keep it.
  void end_run(const State& state);
  void close();

 private:
  std::optional<H5mdRecorder> h5md_;
  std::optional<SavedPart> part_;  // of a PDB file
  std::optional<PdbRecorder> pdb_;
  std::optional<SdfRecorder> sdf_;
};

}  // namespace pliant::app
