// SPDX-License-Identifier: MIT
// Protein Data Bank format: fixed columns, one record a line. What programs write beside the
// standard (overflowed numbers, frames without MODEL, missing elements) is read where its meaning
// is sure, warned of where it is a guess, and refused where it is neither.
#include "pliant/molecule/read/pdb/pdb.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <tuple>

#include "pliant/base/elements.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/words.hpp"
#include "pliant/molecule/read/pdb/hybrid36.hpp"
#include "pliant/molecule/read/pdb/pdb_assembly.hpp"
#include "pliant/molecule/read/pdb/pdb_cell.hpp"
#include "pliant/molecule/read/pdb/pdb_columns.hpp"
#include "pliant/molecule/read/pdb/pdb_conect.hpp"
#include "pliant/molecule/read/pdb/pdb_element.hpp"
#include "pliant/molecule/read/pdb/pdb_links.hpp"
#include "pliant/molecule/read/pdb/pdb_models.hpp"
#include "pliant/molecule/read/pdb/pdb_serials.hpp"
#include "pliant/molecule/read/shared/atom_sites.hpp"
#include "pliant/molecule/read/shared/b_factor_source.hpp"
#include "pliant/molecule/read/shared/reading.hpp"
#include "pliant/text/text_lines.hpp"

namespace pliant {
namespace {

bool is_atom_record(std::string_view line) {
  if (line.starts_with("HETATM")) return true;
  const auto fits = [&](std::size_t at) {
    const char c = column(line, at);
    return c == ' ' || c == '\t' || (c >= '0' && c <= '9');
  };
  return line.starts_with("ATOM") && fits(5) && fits(6);
}

/// The first ATOM or HETATM record, with its number; number 0 for none.
PdbLine first_atom(std::string_view text) {
  Lines lines(text);
  while (lines.next())
    if (is_atom_record(lines.line())) return {lines.line(), lines.number()};
  return {{}, 0};
}

/// Reads one model of a PDB file, line by line.
class PdbReader {
 public:
  PdbReader(const SourceText& source, const ReadOptions& options, Remarks& remarks)
      : source_(source),
        options_(options),
        remarks_(remarks),
        is_pdbqt_(is_pdbqt_atom(first_atom(source.text).text)),
        models_(options.model),
        elements_(is_pdbqt_) {
    constexpr std::size_t bytes_per_atom = 81;
    reserve(source.text.size() / bytes_per_atom + 1);
  }

  Structure read();

 private:
  void reserve(std::size_t count);
  void refuse_pqr() const;
  void take(const PdbLine& line);
  void take_atom(const PdbLine& line);
  void take_residue(const PdbLine& line);
  void take_charge(const PdbLine& line);
  void take_ter(const PdbLine& line);
  void take_title(std::string_view line);
  void take_other(const PdbLine& line, std::string_view record);
  void finish_bonds();
  void add_assembly();
  [[noreturn]] void fail_without_atoms(std::size_t line_count) const;

  const SourceText& source_;
  const ReadOptions& options_;
  Remarks& remarks_;
  bool is_pdbqt_;
  PdbModels models_;
  PdbSerials serials_;
  PdbElements elements_;
  AtomSites sites_;
  std::string_view residue_columns_;  // of the atom before: the same bytes are the same residue
  std::string first_name_;            // of the residue
  std::vector<bool> serial_given_;
  std::vector<std::int64_t> ter_serials_;
  std::vector<PdbLine> link_records_, remark_350_;
};

void PdbReader::reserve(std::size_t count) {
  AtomTable& atoms = sites_.structure.atoms;
  atoms.names.reserve(count);
  atoms.elements.reserve(count);
  atoms.residue_of.reserve(count);
  atoms.serials.reserve(count);
  sites_.structure.positions.reserve(count);
  sites_.conformers.reserve(count);
  sites_.structure.b_factors.reserve(count);
  sites_.occupancies.reserve(count);
  sites_.lines.reserve(count);
}

/// A new run begins where columns 18-27 (name, chain, number, insertion code) or the segment
/// change, or where an overflowed number hides it: with the name of the residue's first atom.
void PdbReader::take_residue(const PdbLine& line) {
  AtomTable& atoms = sites_.structure.atoms;
  const std::string_view name = trimmed(columns(line.text, 13, 16));
  const std::string_view before = residue_columns_;
  const bool same = !before.empty() && columns(line.text, 18, 30) == columns(before, 18, 30) &&
                    pdb_segment(line.text) == pdb_segment(before) &&
                    !(has_starred_residue(line.text) && name == first_name_);
  if (!same) {
    static const Residue none{"", 0, ' ', ""};
    const Residue& previous = atoms.residues.empty() ? none : atoms.residues.back();
    atoms.residues.push_back(pdb_residue(line, previous, remarks_));
    sites_.segments.push_back(pdb_segment(line.text));
    sites_.sections.push_back(sites_.ended_sections);
    sites_.unnumbered.push_back(has_starred_residue(line.text));
    first_name_ = name;
    residue_columns_ = line.text;
  }
  atoms.names.emplace_back(name);
  atoms.residue_of.push_back(static_cast<std::uint32_t>(atoms.residues.size() - 1));
}

void PdbReader::take_charge(const PdbLine& line) {
  if (is_pdbqt_) return;
  const bool has_element = element_number(trimmed(columns(line.text, 77, 78))) != 0;
  const std::int8_t charge = has_element ? pdb_charge(line, remarks_) : std::int8_t{0};
  auto& charges = sites_.structure.charges;
  if (charge != 0) charges.resize(sites_.size(), 0);
  if (charge != 0) charges.back() = charge;
}

void PdbReader::take_atom(const PdbLine& line) {
  if (!models_.on_atom(line.number)) return;
  AtomTable& atoms = sites_.structure.atoms;
  sites_.structure.positions.push_back(pdb_position(line, remarks_));
  take_residue(line);
  atoms.serials.push_back(serials_.next(line, remarks_));
  serial_given_.push_back(serials_.last_was_given());
  atoms.elements.push_back(elements_.next(line, atoms.residues.back().name, remarks_));
  sites_.conformers.push_back(column(line.text, 17));
  sites_.occupancies.push_back(pdb_occupancy(line, remarks_));
  sites_.structure.b_factors.push_back(pdb_b_factor(line));
  sites_.lines.push_back(static_cast<std::uint32_t>(line.number));
  take_charge(line);
}

void PdbReader::take_ter(const PdbLine& line) {
  if (!models_.in_wanted()) return;
  if (const auto serial = parse_hybrid36(columns(line.text, 7, 11)))
    ter_serials_.push_back(*serial);
  ++sites_.ended_sections;
  residue_columns_ = {};
}

void PdbReader::take_title(std::string_view line) {
  std::string& title = sites_.structure.title;
  const std::string_view part = trimmed(columns(line, 11, 80));
  if (!title.empty() && !part.empty()) title += ' ';
  title += part;
}

void PdbReader::take_other(const PdbLine& line, std::string_view record) {
  if (record == "CONECT") models_.on_conect(line);
  if (record == "TER") take_ter(line);
  if (record == "MODEL") models_.on_model(line, remarks_);
  if (record == "ENDMDL") models_.on_endmdl();
  if (record == "END") models_.on_end();
  if (record == "SSBOND" || record == "LINK") link_records_.push_back(line);
  if (record == "REMARK" && trimmed(columns(line.text, 8, 10)) == "350")
    remark_350_.push_back(line);
  if (record == "TITLE" && models_.count() == 0) take_title(line.text);
  if (record == "EXPDTA")
    take_method(sites_.structure, record, trimmed(columns(line.text, 11, 79)));
  // The cell of a model stands before its atoms; programs write one for each model.
  if (record == "CRYST1" && models_.count() < options_.model)
    sites_.structure.cell = pdb_cell(line, remarks_);
}

void PdbReader::take(const PdbLine& line) {
  if (is_atom_record(line.text)) {
    take_atom(line);
  } else {
    take_other(line, trimmed(columns(line.text, 1, 6)));
  }
}

void PdbReader::fail_without_atoms(std::size_t line_count) const {
  std::string hint;
  Lines lines(source_.text);
  while (hint.empty() && lines.next()) {
    const std::string_view word = trimmed(lines.line()).substr(0, 6);
    const bool shifted = word.starts_with("ATOM ") || word.starts_with("HETATM");
    if (shifted && !lines.line().starts_with(word))
      hint = ": record names start in column 1, here they do not";
    if (word.starts_with("atom ") || word.starts_with("hetatm"))
      hint = ": record names are in upper case, here they are not";
  }
  fail({source_.name}, "no ATOM or HETATM record in " + std::to_string(line_count) +
                           (line_count == 1 ? " line" : " lines") + hint);
}

void PdbReader::finish_bonds() {
  std::sort(ter_serials_.begin(), ter_serials_.end());
  std::vector<Bond> bonds;
  const std::vector<PdbLine> records = models_.conect_of_wanted();
  if (!records.empty()) {
    const SerialIndex index(sites_.structure.atoms.serials, serial_given_);
    bonds = conect_bonds(records, {index, ter_serials_, serials_.hexadecimal()}, remarks_);
  }
  const std::vector<std::uint32_t> atom = choose_atoms(sites_, remarks_);
  for (Bond bond : bonds) {
    std::tie(bond.a, bond.b) = std::minmax({atom[bond.a], atom[bond.b]});
    if (bond.b != left_out) sites_.structure.bonds.push_back(bond);
  }
  add_stated_links(sites_, pdb_links(link_records_, remarks_), remarks_);
  sort_bonds(sites_.structure.bonds);
}

void PdbReader::add_assembly() {
  sites_.structure.assemblies = pdb_assembly_names(remark_350_);
  if (options_.assembly.empty()) return;
  check_assembly(sites_.structure.assemblies, options_.assembly, remarks_);
  make_assembly(sites_, options_.assembly, pdb_assembly(remark_350_, options_.assembly, remarks_),
                remarks_);
  sites_.structure.cell.reset();  // the copies leave it
}

/// PQR has words, not columns: after x, y and z a charge and a radius, with more digits than the
/// occupancy and the B factor of PDB files.
void PdbReader::refuse_pqr() const {
  const PdbLine line = first_atom(source_.text);
  const Words words = words_of(line.text);
  constexpr std::size_t of_pdb = 2;  // decimals
  std::size_t reals = 0, decimals = 0;
  for (auto word = words.rbegin(); word != words.rend(); ++word, ++reals) {
    const std::size_t point = word->find('.');
    if (point == std::string_view::npos || !parse_real(*word)) break;
    if (reals < 2) decimals = std::max(decimals, word->size() - point - 1);
  }
  if (reals != 5 || decimals <= of_pdb) return;
  fail(remarks_.place(line.number),
       "PQR is not read: a charge and a radius where a PDB file has occupancy and B factor; "
       "expected the PDB file that it was made from");
}

Structure PdbReader::read() {
  refuse_pqr();
  if (is_pdbqt_)
    remarks_.note(
        "the content is PDBQT: elements are those of AutoDock types, partial charges are "
        "left out");
  Lines lines(source_.text);
  while (lines.next()) take({lines.line(), lines.number()});
  if (models_.count() == 0) fail_without_atoms(lines.number());
  Structure& structure = sites_.structure;
  take_model_count(structure, models_.count(), options_, "model", remarks_);
  models_.tell_of_unequal(remarks_);
  take_title_of_prediction(structure);
  if (!structure.charges.empty()) structure.charges.resize(structure.size(), 0);
  finish_bonds();
  warn_of_placeholders(sites_, remarks_);
  add_assembly();
  return finish(std::move(structure), source_, "pdb", remarks_);
}

}  // namespace

bool looks_like_pdb(std::string_view text) {
  constexpr auto first_records = std::to_array<std::string_view>(
      {"ATOM",   "AUTHOR", "CAVEAT", "COMPND", "CONECT", "CRYST1", "DBREF",  "EXPDTA",
       "HEADER", "HELIX",  "HETATM", "JRNL",   "KEYWDS", "LINK",   "MODEL",  "NUMMDL",
       "OBSLTE", "ORIGX1", "REMARK", "REVDAT", "ROOT",   "SCALE1", "SEQRES", "SHEET",
       "SOURCE", "SPLIT",  "SSBOND", "TITLE",  "USER"});
  Lines lines(text);
  while (lines.next() && trimmed(lines.line()).empty()) {
  }
  const std::string_view record = trimmed(columns(lines.line(), 1, 6));
  return std::binary_search(first_records.begin(), first_records.end(), record) ||
         is_atom_record(lines.line());
}

Structure read_pdb(const SourceText& source, const ReadOptions& options) {
  Remarks remarks(source.name, options.log);
  return PdbReader(source, options, remarks).read();
}

}  // namespace pliant
