// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/h5md_static.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"
#include "pliant/record/hdf5/hdf5_write.hpp"

namespace pliant {
namespace {

// H5MD 1.1.0 (https://www.nongnu.org/h5md/h5md.html): group /h5md, module units 1.0.
void write_provenance(std::int64_t file, const H5mdHeader& header) {
  constexpr std::array version{1, 1}, units_version{1, 0};
  const Hid root = make_group(file, "/h5md");
  write_integer_attribute(root, "version", version);
  const Hid author = make_group(file, "/h5md/author");
  write_text_attribute(author, "name", header.author);
  const Hid creator = make_group(file, "/h5md/creator");
  write_text_attribute(creator, "name", header.creator);
  write_text_attribute(creator, "version", header.creator_version);
  write_integer_attribute(creator, "schema", h5md::schema);
  const Hid units = make_group(file, "/h5md/modules/units");
  write_integer_attribute(units, "version", units_version);
  write_text_attribute(units, "system", "SI");
}

void write_box(std::int64_t file) {
  const std::array<std::string, 3> boundary{"none", "none", "none"};
  const Hid box = make_group(file, std::string(h5md::trajectory) + "/box");
  write_integer_attribute(box, "dimension", 3);
  write_text_attribute(box, "boundary", boundary);
}

std::vector<double> masses_of(const Framework& framework, const H5mdHeader& header) {
  if (!header.masses.empty()) return header.masses;
  std::vector<double> masses;
  for (const double inverse : framework.inverse_masses())
    masses.push_back(inverse > 0.0 ? 1.0 / inverse : 1.0);
  return masses;
}

void write_particles(std::int64_t file, const Framework& framework, const H5mdHeader& header) {
  const std::vector<double> masses = masses_of(framework, header);
  if (masses.size() != framework.joint_count())
    throw OptionError("H5mdHeader::masses has " + std::to_string(masses.size()) + " values for " +
                      std::to_string(framework.joint_count()) + " joints");
  const std::string group = h5md::trajectory;
  write_text_attribute(write_numbers(file, group + "/mass", masses), "unit", "u");
  if (framework.atoms()) write_numbers(file, group + "/species", framework.atoms()->elements);
}

void write_connectivity(std::int64_t file, const char* path, std::span<const Bar> pairs) {
  const Hid dataset = write_pairs(file, path, pairs);
  write_reference_attribute(dataset, "particles_group", h5md::trajectory);
}

void write_framework(std::int64_t file, const Framework& framework) {
  write_connectivity(file, h5md::bars, framework.bars());
  const std::string group = h5md::framework;
  write_text_attribute(write_numbers(file, group + "/rest_length", framework.rest_lengths()),
                       "unit", "Angstrom");
  std::vector<std::uint8_t> pinned;
  for (const double inverse : framework.inverse_masses()) pinned.push_back(inverse == 0.0);
  write_booleans(file, group + "/pinned", pinned);
  if (framework.is_planar()) write_parameter(file, group + "/planar", true);
}

std::vector<std::string> names_of_kinds() {
  std::vector<std::string> names;
  for (const LimitKindEntry& row : limit_kinds()) names.emplace_back(row.name);
  return names;
}

void write_limits(std::int64_t file, const Framework& framework) {
  std::vector<Bar> pairs;
  std::vector<double> least, most, energies;
  std::vector<std::uint8_t> kinds;
  std::vector<std::int64_t> groups;
  for (const Limit& limit : framework.limits()) {
    pairs.push_back({limit.a, limit.b});
    least.push_back(limit.least);
    most.push_back(limit.most);
    kinds.push_back(static_cast<std::uint8_t>(limit.kind));
    energies.push_back(limit.energy);
    groups.push_back(limit.group == no_limit_group ? -1 : std::int64_t{limit.group});
  }
  write_connectivity(file, h5md::limits, pairs);
  const std::string group = h5md::limit;
  for (const auto& [name, values] : {std::pair("/least", &least), std::pair("/most", &most)})
    write_text_attribute(write_numbers(file, group + name, *values), "unit", "Angstrom");
  write_named_numbers(file, group + "/kind", kinds, names_of_kinds());
  write_text_attribute(write_numbers(file, group + "/energy", energies), "unit", "kJ mol-1");
  write_numbers(file, group + "/group", groups);
}

void write_sterics(std::int64_t file, const Sterics& sterics) {
  const std::string group = h5md::sterics;
  std::vector<Bar> own, bonds;
  std::vector<double> own_least;
  for (const OwnDistance& pair : sterics.own) {
    own.push_back({pair.a, pair.b});
    own_least.push_back(pair.least);
  }
  for (const auto& [a, b] : sterics.bonds) bonds.push_back({a, b});
  write_numbers(file, group + "/kind",
                std::vector<std::uint32_t>(sterics.kinds.begin(), sterics.kinds.end()));
  write_text_attribute(write_numbers(file, group + "/least", sterics.least), "unit", "Angstrom");
  write_pairs(file, group + "/own", own);
  write_text_attribute(write_numbers(file, group + "/own_least", own_least), "unit", "Angstrom");
  if (!sterics.units.empty()) write_numbers(file, group + "/unit", sterics.units);
  if (!bonds.empty()) write_pairs(file, group + "/bonds", bonds);
  write_parameter(file, group + "/bonds_apart", std::int64_t{sterics.excluded_bonds});
}

void write_torsion_preferences(std::int64_t file, const TorsionPreferences& preferences) {
  const TorsionColumns columns = columns_of(preferences);
  const std::string group = h5md::torsion_preferences;
  write_table(file, group + "/staggered", columns.free.size(), 4, columns.staggered);
  write_text_attribute(write_numbers(file, group + "/free", columns.free), "unit", "radian");
  write_table(file, group + "/backbone", columns.reach.size(), 5, columns.backbone);
  write_numbers(file, group + "/reach", columns.reach);
}

void write_bonds(std::int64_t file, const H5mdHeader& header) {
  std::vector<Bar> pairs;
  std::vector<std::uint8_t> origins, orders;
  for (const RecordedBond& bond : header.bonds) {
    pairs.push_back({bond.a, bond.b});
    origins.push_back(bond.origin);
    orders.push_back(bond.order);
  }
  write_connectivity(file, h5md::bonds, pairs);
  const std::string group = h5md::topology;
  write_named_numbers(file, group + "/bond_origin", origins, header.bond_origin_names);
  write_numbers(file, group + "/bond_order", orders);
}

void write_residues(std::int64_t file, const std::vector<Residue>& residues) {
  std::vector<std::string> names, insertion_codes, chains;
  std::vector<std::int64_t> numbers;
  for (const Residue& residue : residues) {
    names.push_back(residue.name);
    numbers.push_back(residue.number);
    insertion_codes.emplace_back(residue.insertion_code == ' ' ? 0 : 1, residue.insertion_code);
    chains.push_back(residue.chain);
  }
  const std::string group = h5md::topology;
  write_texts(file, group + "/residue_name", names);
  write_numbers(file, group + "/residue_number", numbers);
  write_texts(file, group + "/insertion_code", insertion_codes);
  write_texts(file, group + "/chain", chains);
}

/// "" where there is none.
std::vector<std::string> symbols_of(const std::vector<std::uint8_t>& elements) {
  std::vector<std::string> symbols;
  symbols.reserve(elements.size());
  for (const std::uint8_t element : elements)
    symbols.emplace_back(element == 0 ? "" : element_symbol(element));
  return symbols;
}

void write_atoms(std::int64_t file, const AtomTable& atoms) {
  const std::string group = h5md::topology;
  write_texts(file, group + "/atom_name", atoms.names);
  write_texts(file, group + "/element", symbols_of(atoms.elements));
  write_numbers(file, group + "/atomic_number", atoms.elements);
  write_numbers(file, group + "/atom_serial", atoms.serials);
  write_numbers(file, group + "/residue_of", atoms.residue_of);
  write_residues(file, atoms.residues);
}

[[noreturn]] void refuse_parameter(const std::string& path, const std::string& why) {
  throw OptionError("parameter " + pliant::quoted(path) + ": " + why);
}

void check_parameters(const std::vector<NamedParameter>& parameters) {
  std::set<std::string> paths;
  for (const auto& [path, value] : parameters) {
    if (path.empty() || path.front() == '/' || path.back() == '/')
      refuse_parameter(path, "must be a path below /parameters, such as run/seed");
    if (is_own_parameter(path))
      refuse_parameter(
          path,
          "the groups framework, limit, sterics, torsion_preferences, topology and checkpoint are "
          "the file's own");
    if (!paths.insert(path).second) refuse_parameter(path, "is given twice");
    const double* number = std::get_if<double>(&value);
    if (number != nullptr && std::isnan(*number)) refuse_parameter(path, "is not a number");
  }
}

void write_parameters(std::int64_t file, const std::vector<NamedParameter>& parameters) {
  for (const auto& [path, value] : parameters) write_parameter(file, "/parameters/" + path, value);
}

}  // namespace

bool is_own_parameter(const std::string& path) {
  return path.starts_with("framework/") || path.starts_with("limit/") ||
         path.starts_with("sterics/") || path.starts_with("torsion_preferences/") ||
         path.starts_with("topology/") || path.starts_with("checkpoint/");
}

void write_static_part(std::int64_t file, const Framework& framework, const H5mdHeader& header) {
  check_parameters(header.parameters);
  write_provenance(file, header);
  write_box(file);
  write_particles(file, framework, header);
  write_framework(file, framework);
  if (!framework.limits().empty()) write_limits(file, framework);
  if (framework.sterics() != nullptr) write_sterics(file, *framework.sterics());
  if (framework.torsion_preferences() != nullptr)
    write_torsion_preferences(file, *framework.torsion_preferences());
  write_bonds(file, header);
  if (framework.atoms()) write_atoms(file, *framework.atoms());
  write_parameters(file, header.parameters);
}

void write_saved_joints(std::int64_t file, const std::vector<std::uint32_t>& joints,
                        std::size_t joint_count) {
  const Hid id = write_numbers(file, h5md::id, joints);
  write_integer_attribute(id, h5md::joints_of_whole, static_cast<int>(joint_count));
}

}  // namespace pliant
