// SPDX-License-Identifier: MIT
#include "options/molecule_fields.hpp"

#include <sstream>

#include "pliant/base/value_text.hpp"

namespace pliant::app {
namespace {

template <auto Member>
MoleculePlace at(MoleculeOptions& options) {
  return &(options.*Member);
}

template <auto Member>
MoleculePlace of_kind(MoleculeOptions& options) {
  return &(options.kind.*Member);
}

constexpr MoleculeField table[] = {
    {"frame", "--frame", at<&MoleculeOptions::model>},
    {"select", "--select", at<&MoleculeOptions::select>},
    {"assembly", "--assembly", at<&MoleculeOptions::assembly>},
    {"lengths", "--lengths", at<&MoleculeOptions::lengths>},
    {"pin", "--pin", at<&MoleculeOptions::pin>},
    {"distance_bonds", "--no-distance-bonds", at<&MoleculeOptions::guess_distances>},
    {"hbond_cutoff", "--hbond-cutoff", of_kind<&ModelSettings::hbond_cutoff>},
    {.name = "contacts",
     .option = "--contacts",
     .place = of_kind<&ModelSettings::contacts>,
     .is_file = true},
    {"more_contacts", "--more-contacts", of_kind<&ModelSettings::more_contacts>},
    {"keep_waters", "--keep-waters", of_kind<&ModelSettings::keep_waters>},
    {"keep", "--keep", of_kind<&ModelSettings::keep>},
    {"fill_side_chains", "--fill-side-chains", of_kind<&ModelSettings::fill_side_chains>},
    {"all_hydrogens", "--all-hydrogens", of_kind<&ModelSettings::all_hydrogens>},
    {"protonate", "--protonate", of_kind<&ModelSettings::protonate>},
    {"floppy", "--floppy", of_kind<&ModelSettings::floppy>},
};

struct Spelled {
  std::string operator()(const auto* value) const { return value_text(*value); }
  std::string operator()(const std::vector<std::string>* values) const {
    std::string text;
    for (const std::string& value : *values) text += (text.empty() ? "" : ",") + value;
    return text;
  }
};

struct Setting {
  std::string_view name, text;

  void operator()(auto* place) const { set_value(name, text, *place); }
  void operator()(std::int64_t* place) const { set_value(name, text, *place, 1); }
  void operator()(std::vector<std::string>* place) const {
    place->clear();
    std::istringstream parts{std::string(text)};
    for (std::string part; std::getline(parts, part, ',');) place->push_back(part);
  }
};

}  // namespace

std::span<const MoleculeField> molecule_fields() { return table; }

std::string molecule_field_text(const MoleculeOptions& options, const MoleculeField& field) {
  return std::visit(Spelled{}, field.place(const_cast<MoleculeOptions&>(options)));
}

void set_molecule_field(MoleculeOptions& options, const MoleculeField& field,
                        std::string_view text) {
  std::visit(Setting{field.name, text}, field.place(options));
}

ForceHeader force_header_of(const MoleculeOptions& options, const Molecule& molecule) {
  ForceHeader header = pliant::force_header_of(molecule.framework);
  header.structure = molecule.fingerprint;
  const bool has_model = !options.kind.name.empty();
  const bool is_graph = molecule.structure.format == "graph";
  if (has_model || !is_graph || !options.bars.empty())
    header.input.push_back({has_model ? "model" : "bars", bars_of(options)});
  for (const MoleculeField& field : molecule_fields()) {
    const std::string text = molecule_field_text(options, field);
    if (text != molecule_field_text({}, field))
      header.input.push_back({std::string(field.name), text});
  }
  return header;
}

}  // namespace pliant::app
