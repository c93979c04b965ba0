// SPDX-License-Identifier: MIT
#include "frame_output.hpp"

#include <utility>

#include "output_files.hpp"
#include "pliant/base/error.hpp"

namespace pliant::app {

bool is_pdb_name(const std::string& output) {
  const std::string extension = extension_of(output);
  return extension == ".pdb" || extension == ".ent";
}

void check_record_options(const std::string& output, const H5mdOptions& options) {
  if (!is_pdb_name(output)) return;
  for (const auto& [is_given, name] :
       {std::pair(options.single, "--single"), std::pair(options.compress, "--compress")})
    if (is_given)
      throw OptionError(std::string(name) + ": goes with H5MD, not with the PDB file " + output);
}

FrameOutput::FrameOutput(const std::string& output, const Framework& framework,
                         const H5mdHeader& header, const H5mdOptions& options) {
  if (!is_pdb_name(output)) {
    h5md_.emplace(output, framework, header, options);
    return;
  }
  TopologyPdbOptions pdb;
  pdb.overwrite = options.overwrite;
  pdb.log = options.log;
  pdb_.emplace(output, framework.atoms(), header.bonds, pdb);
}

void FrameOutput::record(const Frame& frame) { h5md_ ? h5md_->record(frame) : pdb_->record(frame); }

void FrameOutput::end_run(const State& state) {
  if (h5md_) h5md_->end_run(state);
}

void FrameOutput::close() { h5md_ ? h5md_->close() : pdb_->close(); }

}  // namespace pliant::app
