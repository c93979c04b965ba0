// SPDX-License-Identifier: MIT
#include "frame_output.hpp"

#include <filesystem>
#include <utility>

#include "output_files.hpp"
#include "pliant/base/error.hpp"

namespace pliant::app {

namespace fs = std::filesystem;

bool is_pdb_name(const std::string& output) {
  const std::string extension = extension_of(output);
  return extension == ".pdb" || extension == ".ent";
}

bool is_sdf_name(const std::string& output) {
  const std::string extension = extension_of(output);
  return extension == ".sdf" || extension == ".sd";
}

void add_precision_option(CommandLine& line, H5mdOptions& options) {
  line.add_real(
      "--precision", options.precision, Range::zero_to_one,
      "round positions, by half of this at most (Angstrom), and compress them; residuals\n"
      "and what is converged are of before the rounding",
      "as they are");
}

void check_record_options(const std::string& output, const H5mdOptions& options) {
  if (!is_pdb_name(output) && !is_sdf_name(output)) return;
  for (const auto& [is_given, name] :
       {std::pair(options.single, "--single"), std::pair(options.compress, "--compress"),
        std::pair(options.precision > 0.0, "--precision")})
    if (is_given)
      throw OptionError(std::string(name) + ": goes with H5MD, not with the " +
                        (is_pdb_name(output) ? "PDB" : "SDF") + " file " + output);
}

FrameOutput::FrameOutput(const std::string& output, const Framework& framework,
                         const H5mdHeader& header, const H5mdOptions& options,
                         SdfMolecule molecule) {
  if (is_sdf_name(output)) {
    if (molecule.title.empty()) molecule.title = fs::path(output).stem().string();
    sdf_.emplace(output, framework.atoms(), header.bonds, std::move(molecule),
                 SdfRecorder::Options{options.overwrite});
    return;
  }
  if (!is_pdb_name(output)) {
    h5md_.emplace(output, framework, header, options);
    return;
  }
  TopologyPdbOptions pdb;
  pdb.overwrite = options.overwrite;
  pdb.log = options.log;
  pdb_.emplace(output, framework.atoms(), header.bonds, pdb);
}

void FrameOutput::record(const Frame& frame) {
  if (h5md_) h5md_->record(frame);
  if (pdb_) pdb_->record(frame);
  if (sdf_) sdf_->record(frame);
}

void FrameOutput::end_run(const State& state) {
  if (h5md_) h5md_->end_run(state);
}

void FrameOutput::close() {
  if (h5md_) h5md_->close();
  if (pdb_) pdb_->close();
  if (sdf_) sdf_->close();
}

}  // namespace pliant::app
