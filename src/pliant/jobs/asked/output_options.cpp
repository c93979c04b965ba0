// SPDX-License-Identifier: MIT
#include "pliant/jobs/asked/output_options.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <string_view>

#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/text/compression.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view group = "Output";

template <auto... Members>
constexpr auto at = place_at<OutputOptions, Members...>;

constexpr auto record = &OutputOptions::record;

constexpr OptionField<OutputOptions> table[] = {
    {{.name = "output",
      .letter = 'o',
      .group = group,
      .summary = "H5MD trajectory, or a PDB file (.pdb) of all frames, or for conformers an SDF\n"
                 "file (.sdf) (default: INPUT's name.h5md)",
      .kind = "FILE",
      .in_python = "H5MD file to write, or a PDB file of a model a frame where the name ends in "
                   ".pdb.",
      .users = {.file = false},
      .type_in_python = "str | os.PathLike[str] | None"},
     at<&OutputOptions::output>},
    {{.name = "topology",
      .group = group,
      .summary = "PDB file of names and bonds to write, or none (default: OUTPUT's name.pdb)",
      .kind = "FILE",
      .in_python = "PDB file to write as well, with names and bonds.",
      .users = {.file = false, .again = false},
      .type_in_python = "str | os.PathLike[str] | None"},
     at<&OutputOptions::topology>},
    {{.name = "overwrite",
      .group = group,
      .summary = "replace existing outputs",
      .in_python = "Replace existing outputs, but never the file that the structure was read from.",
      .users = {.file = false, .again = false}},
     at<record, &H5mdOptions::overwrite>},
    {{.name = "save",
      .group = group,
      .summary = "record only these atoms, such as \"name CA\" or \"not element H\" (default: "
                 "all);\nall atoms still move, but --continue needs a file with all atoms",
      .kind = "SELECTION",
      .in_python = "Selection of the atoms to record; as for ``H5mdRecorder``."},
     at<&OutputOptions::save>},
    {{.name = "precision",
      .group = group,
      .summary = "round to a grid of this spacing or less (Angstrom), and compress; residuals and\n"
                 "convergence refer to the positions before rounding",
      .range = Range::zero_to_one,
      .is_optional = true,
      .in_python = "Angstrom; as for ``H5mdRecorder``."},
     at<record, &H5mdOptions::precision>},
    {{.name = "flush_seconds",
      .group = group,
      .summary = "interval between commits of the trajectory (s)",
      .range = Range::zero_or_more,
      .in_python = "As for ``H5mdRecorder``.",
      .users = {.command = false, .job = false, .file = false}},
     at<record, &H5mdOptions::flush_seconds>},
    {{.name = "commits",
      .group = group,
      .summary = "save finished work here until the output is complete; after a kill the same\n"
                 "job continues from it, and the output has the same bytes",
      .kind = "FILE",
      .users = {.command = false, .python = false, .file = false, .again = false}},
     at<&OutputOptions::commits>},
    {{.name = "commit_seconds",
      .group = group,
      .summary = "interval between these commits (s)",
      .range = Range::zero_or_more,
      .users = {.command = false, .python = false, .file = false}},
     at<&OutputOptions::commit_seconds>},
};

struct ForeignName {
  std::string_view extension, format;
};

constexpr auto foreign_names = std::to_array<ForeignName>({
    {".cif", "mmCIF"},    {".csv", "CSV"},       {".dcd", "DCD"},       {".extxyz", "XYZ"},
    {".gro", "Gromos87"}, {".gz", "gzip"},       {".json", "JSON"},     {".mdcrd", "AMBER"},
    {".mmcif", "mmCIF"},  {".mol", "MDL"},       {".mol2", "MOL2"},     {".nc", "NetCDF"},
    {".ncdf", "NetCDF"},  {".netcdf", "NetCDF"}, {".npy", "NumPy"},     {".npz", "NumPy"},
    {".pdbqt", "PDBQT"},  {".sd", "SDF"},        {".sdf", "SDF"},       {".tng", "TNG"},
    {".trj", "AMBER"},    {".trr", "TRR"},       {".xml", "graph XML"}, {".xtc", "XTC"},
    {".xyz", "XYZ"},
});

constexpr auto convertible =
    std::to_array<std::string_view>({".cif", ".dcd", ".mmcif", ".trr", ".xtc", ".xyz"});

/// Where a name leads, also through a link to a file that does not exist yet.
fs::path end_of_links(fs::path name) {
  constexpr int most_links = 40;  // as systems have it: links may go in circles
  std::error_code error;
  for (int k = 0; k < most_links && fs::is_symlink(fs::symlink_status(name, error)); ++k)
    name = name.parent_path() / fs::read_symlink(name, error);
  const fs::path whole = fs::absolute(name, error);
  const fs::path found = fs::weakly_canonical(whole, error);
  return error ? whole.lexically_normal() : found;
}

/// Files seen so far, by where they lead; those with several names (hard links) also in a list, as
/// no path tells that they are one.
class SeenFiles {
 public:
  /// The earlier name of the same file, or "" and it is remembered.
  std::string add(const std::string& name) {
    std::error_code error;
    const fs::file_status status = fs::status(path_of(name), error);
    if (name.empty() || (fs::exists(status) && !fs::is_regular_file(status))) return {};
    const auto [seen, is_new] = by_path_.emplace(end_of_links(path_of(name)), name);
    if (!is_new) return seen->second;
    if (!fs::exists(status) || fs::hard_link_count(path_of(name), error) < 2) return {};
    for (const std::string& other : linked_)
      if (fs::equivalent(path_of(name), path_of(other), error)) return other;
    linked_.push_back(name);
    return {};
  }

 private:
  std::map<fs::path, std::string> by_path_;
  std::vector<std::string> linked_;
};

/// The input's name in the current folder: mol.h5md for data/mol.pdb.gz.
std::string default_trajectory(const std::string& input) {
  return path_text(without_compression_suffix(path_of(input).filename()).stem()) + ".h5md";
}

/// A name like that of the output, in its folder; "mol-topology.pdb" if the input is mol.pdb.
std::string default_topology(const std::string& output, const std::string& input) {
  const fs::path beside = path_of(output).replace_extension(".pdb");
  std::error_code error;
  const bool is_input = beside.lexically_normal() == path_of(input).lexically_normal() ||
                        fs::equivalent(beside, path_of(input), error);
  if (!is_input) return path_text(beside);
  return path_text(beside.parent_path() / path_of(path_text(beside.stem()) + "-topology.pdb"));
}

/// Throws OptionError if options of H5MD are given for another format.
void check_format(const OutputOptions& options, std::string_view dashes) {
  const std::string& output = options.output;
  if (is_sdf_name(output) && !options.save.empty())
    throw OptionError(option_name("save", dashes) +
                      ": goes with H5MD and PDB, not with the SDF file " + output);
  if (!is_pdb_name(output) && !is_sdf_name(output)) return;
  if (options.record.precision > 0.0)
    throw OptionError(option_name("precision", dashes) + ": goes with H5MD, not with the " +
                      (is_pdb_name(output) ? "PDB" : "SDF") + " file " + output);
}

}  // namespace

std::span<const OptionField<OutputOptions>> output_fields() { return table; }

void name_outputs(OutputOptions& options, const std::string& input, bool has_sidecar) {
  if (options.output.empty()) options.output = default_trajectory(input);
  if (!options.topology.empty()) return;
  options.topology = has_sidecar && !is_pdb_name(options.output) && !is_sdf_name(options.output)
                         ? default_topology(options.output, input)
                         : std::string(no_topology);
}

void settle(OutputOptions& options, std::string_view dashes) {
  check_format(options, dashes);
  if (options.commits.empty()) return;
  options.record.flush_seconds = std::numeric_limits<double>::infinity();
  if (is_there(path_of(options.commits))) options.record.overwrite = true;
}

void refuse_to_replace(const std::vector<std::string>& outputs, const OutputOptions& options,
                       std::string_view dashes) {
  if (options.record.overwrite) return;
  std::error_code error;
  for (const std::string& output : outputs)
    if (!output.empty() && fs::is_regular_file(path_of(output), error))
      throw FileError(printable_name(output) + ": exists; " +
                      (dashes.empty() ? "overwrite=True" : "--overwrite") + " replaces it");
}

bool is_pdb_name(const std::string& output) {
  const std::string extension = extension_of(output);
  return extension == ".pdb" || extension == ".ent";
}

bool is_sdf_name(const std::string& output) {
  const std::string extension = extension_of(output);
  return extension == ".sdf" || extension == ".sd";
}

void refuse_same_files(const std::vector<std::string>& inputs,
                       const std::vector<std::string>& outputs) {
  SeenFiles read, written;
  for (const std::string& input : inputs) read.add(input);
  for (const std::string& output : outputs) {
    SeenFiles with_inputs = read;
    if (!with_inputs.add(output).empty())
      throw OptionError(printable_name(output) + ": is both input and output");
    if (const std::string other = written.add(output); !other.empty())
      throw OptionError(printable_name(output) + ": two outputs are this one file" +
                        (other == output ? "" : ", also named " + printable_name(other)));
  }
}

std::string not_there(const std::string& name) {
  const std::string partial = path_text(partial_name(path_of(name)));
  const bool was_begun = is_there(path_of(partial));
  return printable_name(name) + ": is not there" +
         (was_begun ? ", but " + printable_name(partial) +
                          " is: its writer was ended before the first frame; begin anew"
                    : "");
}

std::string extension_of(const std::string& name) {
  std::string extension = path_text(path_of(name).extension());
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

void check_trajectory_name(const std::string& output, bool takes_sdf) {
  if (takes_sdf && is_sdf_name(output)) return;
  if (output == "-")
    throw OptionError(
        "--output -: a trajectory is not written to standard output: expected a name such as "
        "out.h5md");
  const std::string extension = extension_of(output);
  for (const ForeignName& foreign : foreign_names) {
    if (foreign.extension != extension) continue;
    const std::string h5md = path_text(path_of(output).replace_extension(".h5md"));
    const bool converts =
        std::find(convertible.begin(), convertible.end(), extension) != convertible.end();
    throw OptionError("--output " + printable_name(output) + ": is a name of " +
                      std::string(foreign.format) +
                      "; trajectories are written as H5MD or PDB: expected a name such as " +
                      printable_name(h5md) +
                      (converts ? ", of which \"pliant convert " + printable_name(h5md) + " -o " +
                                      printable_name(output) + "\" makes this one"
                                : ""));
  }
}

}  // namespace pliant
