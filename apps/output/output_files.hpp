// SPDX-License-Identifier: MIT
// What is asked of the files of a command before any of them is opened.
#pragma once

#include <string>
#include <vector>

namespace pliant::app {

/// Throws OptionError if an output is one of the inputs or another output, whatever names and
/// links lead to it. Names "" are none. What exists and is no regular file, such as /dev/null, is
/// not compared.
void refuse_same_files(const std::vector<std::string>& inputs,
                       const std::vector<std::string>& outputs);

/// The input's name in this folder: mol.h5md of data/mol.pdb.gz.
std::string default_trajectory(const std::string& input);

/// Beside the output and of its name; "mol-topology.pdb" where mol.pdb is the input.
std::string default_topology(const std::string& output, const std::string& input);

/// ".pdb" of "OUT.PDB".
std::string extension_of(const std::string& name);

/// Throws OptionError if a trajectory's name promises another format than H5MD or PDB. Names the
/// command that makes such a file.
void check_trajectory_name(const std::string& output);

}  // namespace pliant::app
