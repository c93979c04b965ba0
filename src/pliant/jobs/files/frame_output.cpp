// SPDX-License-Identifier: MIT
#include "pliant/jobs/files/frame_output.hpp"

#include <filesystem>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"

namespace pliant {

namespace fs = std::filesystem;

namespace {

TopologyPdbOptions pdb_options(const H5mdOptions& options) {
  TopologyPdbOptions pdb;
  pdb.overwrite = options.overwrite;
  pdb.log = options.log;
  return pdb;
}

}  // namespace

void write_topology(const std::string& path, const Framework& framework, const H5mdHeader& header,
                    std::span<const Vec3> positions, const H5mdOptions& options) {
  if (path == no_topology) return;
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
  if (path == no_topology) return path;
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
    return std::string(no_topology);
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

}  // namespace pliant
