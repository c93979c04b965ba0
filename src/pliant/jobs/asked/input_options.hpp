// SPDX-License-Identifier: MIT
// What a job reads: a file, which part of it is taken, and how its bonds are found.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pliant/base/log.hpp"
#include "pliant/base/option_fields.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant {

struct InputOptions {
  std::string file;        ///< no row: it stands in front of all options
  std::int64_t frame = 1;  ///< which model, frame or record of the file
  std::string assembly;    ///< a biological assembly; "": the atoms as listed
  std::string select;      ///< selection of atoms; "": all
  /// MB; limit of the file, and of what it expands to
  std::int64_t max_input = usual_text / 1'000'000;
  bool distance_bonds = true;  ///< bonds that the file lacks are guessed from distances
};

/// The table of these options; recorded below "input".
std::span<const OptionField<InputOptions>> input_fields();

/// All bytes of the file, expanded. Throws FileError; OptionError for a file beyond max_input.
std::string input_bytes(const InputOptions& options);

/// Reads the file, perceives its bonds and selects atoms. Throws as read_structure(),
/// perceive_bonds() and select_part() do.
Structure read_input(const InputOptions& options, const Log& log);

}  // namespace pliant
