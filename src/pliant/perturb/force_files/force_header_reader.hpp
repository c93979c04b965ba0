// SPDX-License-Identifier: MIT
// Reads the header of a force file line by line.
#pragma once

#include <string_view>

#include "pliant/base/error.hpp"
#include "pliant/base/words.hpp"
#include "pliant/perturb/force_files/force_header.hpp"

namespace pliant {

/// The first line of a force file.
inline constexpr std::string_view force_file_heading = "pliant-forces 3";

/// Takes the lines of a force file one after the other, until the header is over.
class ForceHeaderReader {
 public:
  /// Returns whether the line was empty or belonged to the header. Throws InputError at `place`.
  bool take(const Words& words, std::string_view line, const Place& place);
  /// Throws InputError if there was no first line.
  void end(std::string_view file) const;

  ForceHeader header;

 private:
  void take_heading(const Words& words, std::string_view line, const Place& place);
  void take_input(std::string_view line, const Place& place);

  bool is_headed_ = false, is_over_ = false;
};

}  // namespace pliant
