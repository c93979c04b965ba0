// SPDX-License-Identifier: MIT
// How a molecule is read: what every reader is given besides the text.
#pragma once

#include <cstddef>
#include <string>

#include "pliant/base/log.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant {

/// How to read; checked by read_structure.
struct ReadOptions {
  std::size_t model = 1;               ///< which model, frame or record, from 1
  std::string assembly = "";           ///< a biological one that the file states; "": as it is
  std::string format = "";             ///< a name in formats(); "": by extension, then by content
  std::size_t max_input = usual_text;  ///< bytes of the file and of what it expands to
  Log log = {};                        ///< where notes and warnings go
};

}  // namespace pliant
