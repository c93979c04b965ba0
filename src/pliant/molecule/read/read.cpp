// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/read.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/letters.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/molecule/read/cif/mmcif.hpp"
#include "pliant/molecule/read/foreign.hpp"
#include "pliant/molecule/read/pdb/pdb.hpp"
#include "pliant/molecule/read/sdf/sdf.hpp"
#include "pliant/molecule/read/shared/assembly.hpp"
#include "pliant/molecule/read/xyz/xyz.hpp"
#include "pliant/text/compression.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant {
namespace {

constexpr std::array<std::string_view, 3> pdb_extensions{".pdb", ".ent", ".pdbqt"};
constexpr std::array<std::string_view, 4> sdf_extensions{".sdf", ".sd", ".mol", ".mdl"};
constexpr std::array<std::string_view, 3> mmcif_extensions{".cif", ".mmcif", ".mcif"};
constexpr std::array<std::string_view, 2> xyz_extensions{".xyz", ".extxyz"};

// Looked through by content in this order: XYZ last, as a number on the first line says least.
constexpr Format table[] = {
    {.name = "pdb",
     .label = "PDB",
     .summary = "Protein Data Bank, fixed columns, and PDBQT",
     .extensions = pdb_extensions,
     .looks_like = looks_like_pdb,
     .read = read_pdb,
     .has_assemblies = true},
    {.name = "mmcif",
     .label = "mmCIF",
     .summary = "PDBx/mmCIF",
     .extensions = mmcif_extensions,
     .looks_like = looks_like_mmcif,
     .read = read_mmcif,
     .has_assemblies = true},
    {.name = "sdf",
     .label = "SDF",
     .summary = "MDL molfile and SDF, V2000 and V3000",
     .extensions = sdf_extensions,
     .looks_like = looks_like_sdf,
     .read = read_sdf,
     .has_small_molecules = true},
    {.name = "xyz",
     .label = "XYZ",
     .summary = "XYZ and extended XYZ",
     .extensions = xyz_extensions,
     .looks_like = looks_like_xyz,
     .read = read_xyz,
     .has_bare_atoms = true},
};

/// The extension in lower case, below that of a compression: ".pdb" of "1ABC.PDB.gz".
std::string extension_of(std::string_view name) {
  return path_text(without_compression_suffix(path_of(lower_case(name))).extension());
}

const Format* format_by_extension(std::string_view name) {
  const std::string extension = extension_of(name);
  for (const Format& format : table)
    for (std::string_view known : format.extensions)
      if (known == extension) return &format;
  return nullptr;
}

const Format* format_by_content(std::string_view text) {
  for (const Format& format : table)
    if (format.looks_like(text)) return &format;
  return nullptr;
}

[[noreturn]] void fail_unknown(std::string_view name) {
  const std::string extension = extension_of(name);
  if (extension == ".xml")
    fail({name},
         "is a graph by its extension .xml, and no molecule: pliant run, play, order, info "
         "and rigidity take it; in Python pliant.read_graph_xml reads it");
  std::string message = "neither extension nor content matches a known format; known:";
  if (const std::string_view format = foreign_format(extension); !format.empty())
    message = "is a file of " + std::string(format) + " by its extension " + extension +
              ", which is not read (pliant.from_mdanalysis in Python may); known:";
  for (const Format& format : table) {
    message.append(&format == table ? " " : "; ").append(format.name);
    for (std::string_view known : format.extensions) message.append(" ").append(known);
  }
  fail({name}, message);
}

const Format& format_of(const SourceText& source, std::string_view wanted) {
  if (!wanted.empty()) return choose(table, "format", wanted);
  if (const Format* format = format_by_extension(source.name)) return *format;
  if (extension_of(source.name) == ".pqr") fail_unknown(source.name);  // it looks like PDB
  if (const Format* format = format_by_content(source.text)) return *format;
  fail_unknown(source.name);
}

void check(const ReadOptions& options) {
  if (options.model == 0) throw OptionError("model is 0: models are counted from 1");
  if (options.max_input == 0 || options.max_input > largest_text)
    throw OptionError("max_input: expected 1 to " + std::to_string(largest_text) +
                      " bytes, found " + std::to_string(options.max_input));
  if (!options.format.empty()) choose(table, "format", options.format);
}

void check_assembly(const Format& format, const SourceText& source, const ReadOptions& options) {
  if (options.assembly.empty() || format.has_assemblies) return;
  check_assembly({}, options.assembly, Remarks(source.name, options.log));
}

/// A file whose extension speaks of another format than its content fails in a way that says
/// little: the content may say more.
[[noreturn]] void fail_with_hint(const InputError& error, const SourceText& source,
                                 const Format& format) {
  const Format* other = format_by_content(source.text);
  if (other == nullptr || other == &format || format.looks_like(source.text)) throw error;
  throw InputError(std::string(error.what()) + " (read as " + std::string(format.name) +
                   "; the content looks like " + std::string(other->name) + ")");
}

}  // namespace

std::span<const Format> formats() { return table; }

bool is_from(const Structure& structure, bool Format::*what) {
  const auto found = std::ranges::find(table, structure.format, &Format::name);
  return found != std::end(table) && (*found).*what;
}

Structure read_structure(const std::filesystem::path& path, const ReadOptions& options) {
  check(options);
  const std::string bytes = read_bytes(path, options.max_input);
  const std::string name = path_text(path);
  return read_structure(SourceText{name, bytes}, options);
}

Structure read_structure(const SourceText& source, const ReadOptions& options) {
  check(options);
  const SourceText plain{source.name, without_byte_order_mark(source.text)};
  if (const std::string_view what = foreign_content(plain.text); !what.empty())
    fail({plain.name}, "is " + std::string(what));
  check_text(plain);
  const Format& format = format_of(plain, options.format);
  check_assembly(format, plain, options);
  try {
    return format.read(plain, options);
  } catch (const InputError& error) {
    fail_with_hint(error, plain, format);
  }
}

}  // namespace pliant
