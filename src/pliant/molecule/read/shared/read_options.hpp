// SPDX-License-Identifier: MIT
// Options of reading a molecule, which every reader gets.
#pragma once

#include <cstddef>
#include <string>

#include "pliant/base/log.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant {

/// How to read; checked by read_structure.
struct ReadOptions {
  std::size_t model = 1;      ///< which model, frame or record, from 1
  std::string assembly = "";  ///< name of a biological assembly; "": the atoms as listed
  std::string format = "";    ///< a name in formats(); "": by extension, then by content
  /// largest size of the file, and of what it expands to (bytes)
  std::size_t max_input = usual_text;
  Log log = {};  ///< where notes and warnings go
};

}  // namespace pliant
