// SPDX-License-Identifier: MIT
#include "output/frame_output.hpp"

#include <filesystem>
#include <utility>

#include "output/output_files.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"

namespace pliant::app {

namespace fs = std::filesystem;

namespace {

TopologyPdbOptions pdb_options(const H5mdOptions& options) {
  TopologyPdbOptions pdb;
  pdb.overwrite = options.overwrite;
  pdb.log = options.log;
  return pdb;
}

}  // namespace

bool is_pdb_name(const std::string& output) {
  const std::string extension = extension_of(output);
  return extension == ".pdb" || extension == ".ent";
}

bool is_sdf_name(const std::string& output) {
  const std::string extension = extension_of(output);
  return extension == ".sdf" || extension == ".sd";
}

void add_saving_options(CommandLine& line, std::string& save, H5mdOptions& options) {
  line.add_text(
      "--save", save, "SELECTION",
      "record only these atoms, such as \"name CA\" or \"not element H\" (default: all);\n"
      "all atoms still move, but --continue needs a file with all atoms");
  line.add_real("--precision", options.precision, Range::zero_to_one,
                "round to a grid of this spacing or less (Angstrom), and compress; residuals and\n"
                "convergence refer to the positions before rounding",
                "as they are");
}

void check_record_options(const std::string& output, const std::string& save,
                          const H5mdOptions& options) {
  if (is_sdf_name(output) && !save.empty())
    throw OptionError("--save: goes with H5MD and PDB, not with the SDF file " + output);
  if (!is_pdb_name(output) && !is_sdf_name(output)) return;
  for (const auto& [is_given, name] :
       {std::pair(options.single, "--single"), std::pair(options.compress, "--compress"),
        std::pair(options.precision > 0.0, "--precision")})
    if (is_given)
      throw OptionError(std::string(name) + ": goes with H5MD, not with the " +
                        (is_pdb_name(output) ? "PDB" : "SDF") + " file " + output);
}

void write_topology(const std::string& path, const Framework& framework, const H5mdHeader& header,
                    std::span<const Vec3> positions, const H5mdOptions& options) {
  if (path == "none") return;
  const TopologyPdbOptions pdb = pdb_options(options);
  if (options.saved.empty())
    return write_topology_pdb(path_of(path), *framework.atoms(), positions, header.bonds, pdb);
  SavedPart part(framework, options.saved);
  Frame frame;
  frame.positions = positions;
  write_topology_pdb(path_of(path), *part.framework().atoms(), part.shown(frame).positions,
                     part.bonds_of(header.bonds), pdb);
}

std::string fitting_topology(const std::string& path, bool is_asked, const Framework& framework,
                             std::span<const Vec3> positions, const H5mdOptions& options) {
  if (path == "none") return path;
  try {
    if (options.saved.empty()) {
      check_topology_pdb(*framework.atoms(), positions);
    } else {
      SavedPart part(framework, options.saved);
      Frame frame;
      frame.positions = positions;
      check_topology_pdb(*part.framework().atoms(), part.shown(frame).positions);
    }
    return path;
  } catch (const InputError& error) {
    if (is_asked) throw InputError(at({path}, error.what()));
    options.log.warn(printable_name(path) +
                     ", the file of names and bonds, is not written: " + error.what());
    return "none";
  }
}

FrameOutput::FrameOutput(const std::string& output, const Framework& framework,
                         const H5mdHeader& header, const H5mdOptions& options,
                         SdfMolecule molecule) {
  if (is_sdf_name(output)) {
    if (molecule.title.empty()) molecule.title = path_text(path_of(output).stem());
    sdf_.emplace(path_of(output), framework.atoms(), header.bonds, std::move(molecule),
                 SdfRecorder::Options{options.overwrite});
    return;
  }
  if (!is_pdb_name(output)) {
    h5md_.emplace(path_of(output), framework, header, options);
    return;
  }
  if (options.saved.empty()) {
    pdb_.emplace(path_of(output), framework.atoms(), header.bonds, pdb_options(options));
    return;
  }
  part_.emplace(framework, options.saved);
  pdb_.emplace(path_of(output), part_->framework().atoms(), part_->bonds_of(header.bonds),
               pdb_options(options));
}

void FrameOutput::record(const Frame& frame) {
  if (h5md_) h5md_->record(frame);
  if (pdb_) pdb_->record(part_ ? part_->shown(frame) : frame);
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
