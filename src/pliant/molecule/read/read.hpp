// SPDX-License-Identifier: MIT
// Reading molecules: the table of formats, and the function that callers use.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "pliant/molecule/read/shared/read_options.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant {

/// A format: one row of the table of formats.
struct Format {
  std::string_view name;                         ///< "pdb"
  std::string_view summary;                      ///< one line for help
  std::span<const std::string_view> extensions;  ///< ".pdb", ".ent"
  bool (*looks_like)(std::string_view text);     ///< whether the content could have this format
  Structure (*read)(const SourceText& source, const ReadOptions& options);
};

std::span<const Format> formats();

/// Reads one model of a molecule file; gzip, bzip2 and xz are recognized by content and undone.
/// Returns only the bonds that the file states: perceive_bonds() adds the others. Throws InputError
/// (file, line, field, expected, found), TooLargeError, FileError (with the system's reason),
/// OptionError (unknown format, no such model or assembly, model 0, max_input of 0 or beyond
/// largest_text).
Structure read_structure(const std::filesystem::path& path, const ReadOptions& options = {});

/// Reads text in memory. `source.name` gives the extension.
Structure read_structure(const SourceText& source, const ReadOptions& options = {});

}  // namespace pliant
