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
  std::string_view label;                        ///< "PDB", of text
  std::string_view summary;                      ///< one line for help
  std::span<const std::string_view> extensions;  ///< ".pdb", ".ent"
  bool (*looks_like)(std::string_view text);     ///< whether the content could have this format
  Structure (*read)(const SourceText& source, const ReadOptions& options);
  bool has_assemblies = false;       ///< biological ones
  bool has_small_molecules = false;  ///< one a record, all of whose bonds are stated
  bool has_bare_atoms = false;       ///< elements and positions: nothing says what belongs together
};

std::span<const Format> formats();

/// Whether `structure` was read from a file of a format of which `what` is true.
bool is_from(const Structure& structure, bool Format::*what);

/// Reads one model of a molecule file; gzip, bzip2 and xz are recognized by content and undone.
/// Returns only the bonds that the file states: perceive_bonds() adds the others. Throws InputError
/// (file, line, field, expected, found), TooLargeError, FileError (with the system's reason),
/// OptionError (unknown format, no such model or assembly, model 0, max_input of 0 or beyond
/// largest_text).
Structure read_structure(const std::filesystem::path& path, const ReadOptions& options = {});

/// Reads text in memory. `source.name` gives the extension.
Structure read_structure(const SourceText& source, const ReadOptions& options = {});

}  // namespace pliant
