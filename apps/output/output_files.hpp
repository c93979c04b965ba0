// SPDX-License-Identifier: MIT
// Checks of the files of a command before any of them is opened.
#pragma once

#include <string>
#include <vector>

namespace pliant::app {

/// Throws OptionError if an output is one of the inputs or another output, under whatever names and
/// links. Names "" are ignored, and so are existing files that are not regular, such as /dev/null.
void refuse_same_files(const std::vector<std::string>& inputs,
                       const std::vector<std::string>& outputs);

/// "out.h5md: is not there", and what its writer has left beside it if it was ended before the
/// first frame was whole.
std::string not_there(const std::string& name);

/// The input's name in the current folder: mol.h5md for data/mol.pdb.gz.
std::string default_trajectory(const std::string& input);

/// A name like that of the output, in its folder; "mol-topology.pdb" if the input is mol.pdb.
std::string default_topology(const std::string& output, const std::string& input);

/// ".pdb" for "OUT.PDB".
std::string extension_of(const std::string& name);

/// Throws OptionError if a trajectory's name is that of a format other than H5MD or PDB, naming the
/// command that makes such a file.
void check_trajectory_name(const std::string& output);

}  // namespace pliant::app
