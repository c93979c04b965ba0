// SPDX-License-Identifier: MIT
// PDBx/mmCIF: the data block with an atom_site table, one of its models, and the bonds that
// struct_conn and chem_comp_bond state.
#include "pliant/molecule/read/cif/mmcif.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "pliant/base/number.hpp"
#include "pliant/molecule/read/cif/cif_document.hpp"
#include "pliant/molecule/read/cif/cif_grammar.hpp"
#include "pliant/molecule/read/cif/mmcif_assembly.hpp"
#include "pliant/molecule/read/cif/mmcif_atoms.hpp"
#include "pliant/molecule/read/cif/mmcif_bonds.hpp"
#include "pliant/molecule/read/shared/b_factor_source.hpp"
#include "pliant/molecule/read/shared/reading.hpp"
#include "pliant/text/text_lines.hpp"

namespace pliant {
namespace {

constexpr std::string_view atom_site = "_atom_site";
constexpr std::string_view struct_conn = "_struct_conn";
constexpr std::string_view component_bonds = "_chem_comp_bond";
constexpr std::string_view component_atoms = "_chem_comp_atom";
constexpr std::string_view structure_title = "_struct";
constexpr std::string_view cell_category = "_cell";
constexpr std::string_view experiment = "_exptl";
// ModelCIF, in which servers of predictions and the ModelArchive write:
constexpr std::string_view quality_metric = "_ma_qa_metric";
constexpr std::string_view model_list = "_ma_model_list";

/// The grammar knows LF and CRLF; a text with lone CRs gets LFs in `copy`, and is otherwise
/// returned as it is.
std::string_view with_line_feeds(std::string_view text, std::string& copy) {
  if (text.find('\r') == std::string_view::npos || text.find('\n') != std::string_view::npos)
    return text;
  copy = text;
  std::replace(copy.begin(), copy.end(), '\r', '\n');
  return copy;
}

[[noreturn]] void fail_without_atoms(const CifDocument& document, const Remarks& remarks) {
  const auto any = [&](auto is_so) {
    return std::any_of(document.blocks.begin(), document.blocks.end(), is_so);
  };
  const std::string without = "no atom_site category: ";
  if (any([](const CifBlock& block) { return block.table(component_atoms) != nullptr; }))
    fail(remarks.place(0), without +
                               "the definition of a chemical component (chem_comp_atom), which is "
                               "not read; expected a structure: its SDF, or a PDBx/mmCIF entry");
  if (any([](const CifBlock& block) { return block.has_fractions; }))
    fail(remarks.place(0), without +
                               "a CIF of a small molecule, with fractional coordinates, is not "
                               "read");
  fail(remarks.place(0), without + "no atoms");
}

/// The first data block that has atoms.
const CifBlock& choose_block(const CifDocument& document, Remarks& remarks) {
  const auto& blocks = document.blocks;
  const auto has_atoms = [](const CifBlock& block) { return block.table(atom_site) != nullptr; };
  const auto found = std::find_if(blocks.begin(), blocks.end(), has_atoms);
  if (found == blocks.end()) fail_without_atoms(document, remarks);
  if (blocks.size() > 1)
    remarks.note("data block " + pliant::quoted(found->name) + " of " +
                 std::to_string(blocks.size()) + " used");
  return *found;
}

std::string title_of(const CifDocument& document, const CifBlock& block) {
  const CifTable* table = block.table(structure_title);
  if (table == nullptr || table->rows() == 0) return {};
  const auto column = table->column("title");
  if (!column) return {};
  const std::string_view words = document.word(table->at(0, *column));
  std::string title(words.substr(std::min(words.find_first_not_of(" \t\r\n"), words.size())));
  std::replace_if(
      title.begin(), title.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return title;
}

void add_bonds(const CifDocument& document, const CifBlock& block, AtomSites& sites,
               Remarks& remarks) {
  if (const CifTable* table = block.table(component_bonds))
    add_component_bonds(document, *table, sites.structure);
  if (const CifTable* table = block.table(struct_conn))
    add_stated_links(sites, struct_conn_links(document, *table, sites.altlocs, remarks), remarks);
  sort_bonds(sites.structure.bonds);
}

void add_assembly(const CifDocument& document, const CifBlock& block, const ReadOptions& options,
                  AtomSites& sites, Remarks& remarks) {
  sites.structure.assemblies = cif_assembly_names(document, block);
  if (options.assembly.empty()) return;
  check_assembly(sites.structure.assemblies, options.assembly, remarks);
  make_assembly(sites, options.assembly, cif_assembly(document, block, options.assembly, remarks),
                remarks);
  sites.structure.cell.reset();  // the copies leave it
}

/// The cell, where all of its six numbers are there.
std::optional<Cell> cell_of_block(const CifDocument& document, const CifBlock& block) {
  const CifTable* table = block.table(cell_category);
  if (table == nullptr || table->rows() == 0) return std::nullopt;
  constexpr std::array<std::string_view, 6> tags{"length_a",    "length_b",   "length_c",
                                                 "angle_alpha", "angle_beta", "angle_gamma"};
  std::array<double, 6> values{};
  for (std::size_t k = 0; k < tags.size(); ++k) {
    const auto column = table->column(tags[k]);
    if (!column) return std::nullopt;
    const auto value = parse_real(without_uncertainty(document.word(table->at(0, *column))));
    if (!value) return std::nullopt;
    values[k] = *value;
  }
  return cell_of(std::array<double, 3>{values[0], values[1], values[2]},
                 std::array<double, 3>{values[3], values[4], values[5]});
}

void take_b_factor_source(const CifDocument& document, const CifBlock& block,
                          Structure& structure) {
  if (const CifTable* table = block.table(experiment))
    if (const auto method = table->column("method"); method && table->rows() > 0)
      take_method(structure, "_exptl.method", document.word(table->at(0, *method)));
  if (structure.b_factor_source == BFactorSource::experiment) return;
  const bool has_metric = block.table(quality_metric) != nullptr;
  if (has_metric || block.table(model_list) != nullptr) {
    structure.b_factor_source = has_metric ? BFactorSource::confidence : BFactorSource::model;
    structure.b_factor_record = has_metric ? quality_metric : model_list;
  }
  take_title_of_prediction(structure);
}

Structure read_block(const CifDocument& document, const CifBlock& block, const ReadOptions& options,
                     Remarks& remarks) {
  const CifTable& table = *block.table(atom_site);
  std::size_t model_count = 0;
  AtomSites sites = read_atom_sites(document, table, options.model, model_count, remarks);
  if (model_count == 0) fail(remarks.place(table.line), "atom_site has no rows: no atoms");
  take_model_count(sites.structure, model_count, options, "model", remarks);
  choose_atoms(sites, remarks);
  warn_of_placeholders(sites, remarks);
  sites.structure.title = title_of(document, block);
  take_b_factor_source(document, block, sites.structure);
  sites.structure.cell = cell_of_block(document, block);
  add_bonds(document, block, sites, remarks);
  add_assembly(document, block, options, sites, remarks);
  return std::move(sites.structure);
}

}  // namespace

bool looks_like_mmcif(std::string_view text) {
  Lines lines(text);
  while (lines.next()) {
    std::string_view line = lines.line();
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.empty() || line[0] == '#') continue;
    return line.starts_with("data_") || line.starts_with("DATA_") || line.starts_with("Data_");
  }
  return false;
}

Structure read_mmcif(const SourceText& source, const ReadOptions& options) {
  Remarks remarks(source.name, options.log);
  std::string copy;
  const SourceText text{source.name, with_line_feeds(source.text, copy)};
  const CifDocument document =
      parse_cif(text, {atom_site, struct_conn, component_bonds, component_atoms, structure_title,
                       cell_category, cif_assembly_gen, cif_oper_list, experiment, quality_metric,
                       model_list});
  const CifBlock& block = choose_block(document, remarks);
  return finish(read_block(document, block, options, remarks), source, "mmcif", remarks);
}

}  // namespace pliant
