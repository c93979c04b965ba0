// SPDX-License-Identifier: MIT
#include "output/output_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string_view>

#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/text/compression.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant::app {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

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

std::string default_trajectory(const std::string& input) {
  return path_text(without_compression_suffix(path_of(input).filename()).stem()) + ".h5md";
}

std::string default_topology(const std::string& output, const std::string& input) {
  const fs::path beside = path_of(output).replace_extension(".pdb");
  std::error_code error;
  const bool is_input = beside.lexically_normal() == path_of(input).lexically_normal() ||
                        fs::equivalent(beside, path_of(input), error);
  if (!is_input) return path_text(beside);
  return path_text(beside.parent_path() / path_of(path_text(beside.stem()) + "-topology.pdb"));
}

std::string extension_of(const std::string& name) {
  std::string extension = path_text(path_of(name).extension());
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

void check_trajectory_name(const std::string& output) {
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

}  // namespace pliant::app
