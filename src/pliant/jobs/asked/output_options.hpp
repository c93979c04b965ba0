// SPDX-License-Identifier: MIT
// What a job writes, and how often it keeps what is done.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "pliant/base/option_fields.hpp"
#include "pliant/record/h5md/h5md_header.hpp"

namespace pliant {

/// The value of `topology` that asks for none.
inline constexpr std::string_view no_topology = "none";

struct OutputOptions {
  std::string output;    ///< "": the input's name with .h5md, in the current folder
  std::string topology;  ///< sidecar PDB; "": the output's name with .pdb; "none": none
  std::string save;      ///< selection of the atoms to record; "": all
  H5mdOptions record;
  std::string commits;           ///< file that keeps what is done until the output is complete
  double commit_seconds = 10.0;  ///< between commits; 0: after each step or frame
};

/// The table of these options; recorded below "record".
std::span<const OptionField<OutputOptions>> output_fields();

/// Sets names that are open: see OutputOptions. `has_sidecar`: whether a topology is usual.
void name_outputs(OutputOptions& options, const std::string& input, bool has_sidecar);

/// With commits the output is written in one go, and replaces what is there of it where there are
/// commits already. Throws OptionError for options of H5MD with another format. `dashes`: as for
/// option_name().
void settle(OutputOptions& options, std::string_view dashes = "--");

/// Throws OptionError if one of `outputs` is one of `inputs`, or is given twice; "" is none.
void refuse_same_files(const std::vector<std::string>& inputs,
                       const std::vector<std::string>& outputs);

/// Throws FileError for an output that is there, unless it may be replaced. `dashes`: prefix of an
/// option's name in messages; scripts have none.
void refuse_to_replace(const std::vector<std::string>& outputs, const OutputOptions& options,
                       std::string_view dashes = "--");

/// "out.h5md: is not there", and what its writer has left beside it if it was ended before the
/// first frame was complete.
std::string not_there(const std::string& name);

/// ".pdb" for "OUT.PDB".
std::string extension_of(const std::string& name);
/// Whether the name is that of a PDB file (.pdb, .ent), of an SDF file (.sdf, .sd).
bool is_pdb_name(const std::string& output);
bool is_sdf_name(const std::string& output);

/// Throws OptionError if a trajectory's name is that of a format other than H5MD, PDB or SDF,
/// naming the command that makes such a file.
void check_trajectory_name(const std::string& output, bool takes_sdf);

}  // namespace pliant
