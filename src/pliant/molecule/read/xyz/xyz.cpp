// SPDX-License-Identifier: MIT
// XYZ and extended XYZ: an atom count, a comment line, then one line an atom; any number of frames.
#include "pliant/molecule/read/xyz/xyz.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "pliant/base/elements.hpp"
#include "pliant/base/number.hpp"
#include "pliant/molecule/read/shared/reading.hpp"
#include "pliant/molecule/read/xyz/xyz_columns.hpp"
#include "pliant/molecule/structure/atom_label.hpp"
#include "pliant/text/text_lines.hpp"

namespace pliant {
namespace {

/// Where a frame lies: `comment` stands on the comment line.
struct Frame {
  std::size_t atom_count;
  std::size_t first_line;
  Lines comment;
};

/// Cuts the next word off the front of `rest`; "" at the end.
std::string_view next_field(std::string_view& rest) {
  constexpr std::string_view blanks = " \t";
  rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
  const std::string_view field = rest.substr(0, rest.find_first_of(blanks));
  rest.remove_prefix(field.size());
  return field;
}

/// The count on the current line, behind `frames` frames. Text after it is allowed with a warning.
std::size_t atom_count_of(const Lines& lines, std::size_t frames, Remarks& remarks) {
  std::string_view rest = lines.line();
  const auto count = parse_integer(next_field(rest));
  if (!count || *count < 0)
    fail(remarks.place(lines.number()),
         quoted(lines.line()) + " is not an atom count" +
             (frames == 0 ? "" : ": frame " + std::to_string(frames) + " has all of its atoms"));
  if (!trimmed(rest).empty())
    remarks.warn("text after count", lines.number(), [&] {
      return "text after the atom count " + std::to_string(*count) +
             " is left out: " + quoted(trimmed(rest));
    });
  return static_cast<std::size_t>(*count);
}

[[noreturn]] void fail_short(std::size_t wanted, std::size_t found, std::size_t line,
                             const Remarks& remarks) {
  fail(remarks.place(line),
       std::to_string(wanted) + " atoms wanted, " + std::to_string(found) + " found");
}

void skip_atoms(Lines& lines, std::size_t count, const Remarks& remarks) {
  for (std::size_t i = 0; i < count; ++i) {
    const bool there = lines.next();
    if (!there || trimmed(lines.line()).empty())
      fail_short(count, i, lines.number() + (there ? 0 : 1), remarks);
  }
}

/// Moves to the next line that is not blank.
bool next_text(Lines& lines) {
  while (lines.next())
    if (!trimmed(lines.line()).empty()) return true;
  return false;
}

/// Walks over all frames, checks that each is complete, and remembers the wanted one.
std::optional<Frame> find_frame(Lines lines, std::size_t wanted, std::size_t& frame_count,
                                Remarks& remarks) {
  std::optional<Frame> found;
  frame_count = 0;
  std::size_t first_count = 0;
  while (next_text(lines)) {
    if (frame_count == 0 && lines.number() > 1)
      remarks.warn("blank before count", 1, [] { return "blank line before the atom count"; });
    const std::size_t count = atom_count_of(lines, frame_count, remarks);
    const std::size_t line = lines.number();
    if (!lines.next() && count > 0) fail_short(count, 0, line + 1, remarks);
    if (++frame_count == wanted) found = Frame{count, line, lines};
    if (frame_count == 1) first_count = count;
    if (count != first_count)
      remarks.note("unequal frames", line, [&] {
        return "frame " + std::to_string(frame_count) + " has " + std::to_string(count) +
               " atoms, frame 1 has " + std::to_string(first_count);
      });
    skip_atoms(lines, count, remarks);
  }
  return found;
}

/// The fields of one atom line that matter.
struct AtomLine {
  std::string_view symbol;
  std::array<std::string_view, 3> position;
};

[[noreturn]] void fail_columns(const Lines& lines, const XyzColumns& columns, std::size_t found,
                               const Remarks& remarks) {
  const std::string wanted = columns.fields == 4
                                 ? "a symbol and three numbers wanted"
                                 : std::to_string(columns.fields) + " columns wanted by Properties";
  fail(remarks.place(lines.number()), wanted + ", found " + std::to_string(found) +
                                          (found == 1 ? " field in " : " fields in ") +
                                          quoted(lines.line()));
}

AtomLine split_atom_line(const Lines& lines, const XyzColumns& columns, const Remarks& remarks) {
  AtomLine atom;
  std::string_view rest = lines.line();
  for (std::size_t column = 0; column < columns.fields; ++column) {
    const std::string_view field = next_field(rest);
    if (field.empty()) fail_columns(lines, columns, column, remarks);
    if (column == columns.symbol) atom.symbol = field;
    if (column >= columns.x && column < columns.x + 3) atom.position[column - columns.x] = field;
  }
  return atom;
}

void warn_of_label(std::string_view label, LabelElement found, std::size_t line, Remarks& remarks) {
  if (found.source == ElementSource::guessed)
    remarks.warn("guessed label", line, [&] {
      return "label " + quoted(label) + " is not an element symbol: taken as " +
             std::string(element_symbol(found.element));
    });
  if (found.source == ElementSource::dummy)
    remarks.warn("dummy label", line,
                 [&] { return "label " + quoted(label) + " is a dummy atom: it has no element"; });
  if (found.source == ElementSource::unknown)
    remarks.warn("unknown label", line,
                 [&] { return "label " + quoted(label) + " names no element: taken as unknown"; });
}

void add_atom(Structure& structure, const AtomLine& atom, std::size_t line, Remarks& remarks) {
  const LabelElement found = element_of_label(atom.symbol);
  warn_of_label(atom.symbol, found, line, remarks);
  const bool number = found.source == ElementSource::number;
  const Place place = remarks.place(line);
  structure.positions.push_back({parse_coordinate(atom.position[0], place, "x"),
                                 parse_coordinate(atom.position[1], place, "y"),
                                 parse_coordinate(atom.position[2], place, "z")});
  structure.atoms.names.emplace_back(number ? element_symbol(found.element) : atom.symbol);
  structure.atoms.elements.push_back(found.element);
  structure.atoms.residue_of.push_back(0);
  structure.atoms.serials.push_back(static_cast<std::int64_t>(structure.atoms.names.size()));
}

void read_frame(Frame frame, Structure& structure, Remarks& remarks) {
  Lines& lines = frame.comment;
  structure.title = trimmed(lines.line());
  structure.atoms.residues.push_back({"UNK", 1, ' ', ""});
  std::string problem;
  const XyzColumns columns = columns_of_comment(lines.line(), problem);
  if (!problem.empty())
    remarks.warn("extended", lines.number(), [&] { return problem + ": read as plain XYZ"; });
  std::string no_cell;
  structure.cell = cell_of_comment(lines.line(), no_cell);
  if (!no_cell.empty())
    remarks.warn("lattice", lines.number(), [&] { return no_cell + ": no periodic cell"; });
  for (std::size_t i = 0; i < frame.atom_count; ++i) {
    lines.next();
    add_atom(structure, split_atom_line(lines, columns, remarks), lines.number(), remarks);
  }
}

/// Whether it is an atom line of Tinker: number 1, symbol, x, y, z, type of the force field.
bool is_first_of_tinker(std::string_view line) {
  if (next_field(line) != "1" || parse_integer(next_field(line))) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (!parse_real(next_field(line))) return false;
  return parse_integer(next_field(line)).has_value();
}

/// Tinker's files also begin with a count and are also named .xyz. Their atoms begin on the second
/// line, or after a line of six numbers, the box.
bool looks_like_tinker(std::string_view text) {
  Lines lines(text);
  for (int line = 1; lines.next() && line <= 3; ++line)
    if (line > 1 && is_first_of_tinker(lines.line())) return true;
  return false;
}

Structure read_plain_xyz(const SourceText& source, const ReadOptions& options) {
  Remarks remarks(source.name, options.log);
  std::size_t frame_count = 0;
  const auto frame = find_frame(Lines(source.text), options.model, frame_count, remarks);
  if (frame_count == 0) fail({source.name}, "has no atom count: only blank lines");
  Structure structure;
  take_model_count(structure, frame_count, options, "frame", remarks);
  if (frame->atom_count == 0) fail(remarks.place(frame->first_line), "the frame has no atoms");
  read_frame(*frame, structure, remarks);
  return finish(std::move(structure), source, "xyz", remarks);
}

}  // namespace

bool looks_like_xyz(std::string_view text) {
  Lines lines(text);
  if (!lines.next()) return false;
  const auto count = parse_integer(lines.line());
  return count && *count >= 0;
}

Structure read_xyz(const SourceText& source, const ReadOptions& options) {
  try {
    return read_plain_xyz(source, options);
  } catch (const InputError&) {
    // Not asked before: the comment of a good XYZ file may read like an atom of Tinker.
    if (!looks_like_tinker(source.text)) throw;
    fail({source.name, 1},
         "is a Tinker XYZ file (numbered atoms with types and bonds), which is not read; expected "
         "XYZ (a count, a comment, then a symbol and x y z a line), SDF or PDB");
  }
}

}  // namespace pliant
