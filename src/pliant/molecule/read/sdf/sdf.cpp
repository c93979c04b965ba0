// SPDX-License-Identifier: MIT
// MDL molfiles and SDF: records of a header of three lines, a counts line, and a connection table
// in version V2000 or V3000; "$$$$" ends a record.
#include "pliant/molecule/read/sdf/sdf.hpp"

#include <optional>
#include <string>

#include "pliant/base/number.hpp"
#include "pliant/molecule/read/sdf/mol_block.hpp"
#include "pliant/molecule/read/sdf/mol_v2000.hpp"
#include "pliant/molecule/read/sdf/mol_v3000.hpp"
#include "pliant/molecule/read/shared/fixed_columns.hpp"
#include "pliant/molecule/read/shared/reading.hpp"

namespace pliant {
namespace {

/// Walks over all records; returns the place before the first line of the wanted one. Blank lines
/// after the last "$$$$" are no record.
std::optional<Lines> find_record(Lines lines, std::size_t wanted, std::size_t& count) {
  std::optional<Lines> found;
  Lines start = lines;
  bool has_text = false;
  const auto end = [&] {
    if (has_text && ++count == wanted) found = start;
    has_text = false;
  };
  count = 0;
  while (lines.next()) {
    if (ends_record(lines.line())) {
      end();
      start = lines;
    } else if (!trimmed(lines.line()).empty()) {
      has_text = true;
    }
  }
  end();
  return found;
}

std::string_view version_of(std::string_view counts_line) {
  return trimmed(columns(counts_line, 34, 39));
}

bool is_counts_line(std::string_view line) {
  MolCounts counts;
  const std::string_view version = version_of(line);
  return parse_mol_counts(line, counts) && (version.empty() || version[0] == 'V');
}

struct Header {
  std::string title;
  std::uint8_t dimensions;  ///< 2 or 3; 0: not stated
};

/// The code in columns 21-22 of the second line: "2D" or "3D".
std::uint8_t dimensions_of(std::string_view line) {
  const std::string_view code = columns(line, 21, 22);
  return code == "2D" ? 2 : code == "3D" ? 3 : 0;
}

/// Title, program and comment, then the counts line, which is left as the current one.
Header read_header(Lines& lines, const Remarks& remarks) {
  Header header;
  header.title = trimmed(next_record_line(lines, "the title", remarks));
  header.dimensions =
      dimensions_of(next_record_line(lines, "the second line of the header", remarks));
  const bool early = is_counts_line(next_record_line(lines, "the comment line", remarks)) &&
                     !version_of(lines.line()).empty();
  const std::size_t third = lines.number();
  next_record_line(lines, "the counts line", remarks);
  if (is_counts_line(lines.line())) return header;
  if (early)
    fail(remarks.place(third),
         "the counts line, wanted on the fourth line of a record, is on its third: a line of the "
         "header is missing");
  fail(remarks.place(lines.number()), quoted(lines.line()) +
                                          " is not a counts line (atoms and "
                                          "bonds in columns 1-3 and 4-6)");
}

Structure read_record(Lines lines, Remarks& remarks) {
  MolBlock block(remarks);
  const Header header = read_header(lines, remarks);
  const std::size_t counts_line = lines.number();
  const std::string_view version = version_of(lines.line());
  if (version == "V3000") {
    read_mol_v3000(lines, block);
  } else if (version.empty() || version == "V2000") {
    read_mol_v2000(lines, block);
  } else {
    fail(remarks.place(counts_line),
         "version (columns 34-39) " + quoted(version) + " is neither V2000 nor V3000");
  }
  if (block.size() == 0) fail(remarks.place(counts_line), "the record has no atoms");
  Structure structure = block.take();
  structure.title = header.title;
  structure.dimensions = header.dimensions;
  return structure;
}

}  // namespace

bool looks_like_sdf(std::string_view text) {
  Lines lines(text);
  for (int k = 0; k < 4; ++k)
    if (!lines.next()) return false;
  const std::string_view version = version_of(lines.line());
  return is_counts_line(lines.line()) && (version == "V2000" || version == "V3000");
}

Structure read_sdf(const SourceText& source, const ReadOptions& options) {
  Remarks remarks(source.name, options.log);
  std::size_t count = 0;
  const auto record = find_record(Lines(source.text), options.model, count);
  if (count == 0) fail({source.name}, "has no record: only blank lines");
  Structure structure;
  take_model_count(structure, count, options, "record", remarks);
  Structure read = read_record(*record, remarks);
  read.model = structure.model;
  read.model_count = structure.model_count;
  return finish(std::move(read), source, "sdf", remarks);
}

}  // namespace pliant
