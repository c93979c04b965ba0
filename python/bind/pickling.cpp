// SPDX-License-Identifier: MIT
#include "pickling.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

#include "framework/limits.hpp"
#include "pliant/base/error.hpp"

namespace pliant::python {
namespace {

constexpr int layout = 3;  ///< of what __getstate__ gives

/// Throws InputError unless the state begins with the layout and has so many parts.
void check_state(const nb::tuple& state, std::size_t parts) {
  if (state.size() != parts || !nb::isinstance<nb::int_>(state[0]) ||
      nb::cast<int>(state[0]) != layout)
    throw InputError("a pickle of another version of pliant");
}

template <class Thing>
nb::bytes packed(std::span<const Thing> things) {
  static_assert(std::has_unique_object_representations_v<Thing> ||
                std::is_floating_point_v<Thing> || std::is_same_v<Thing, Vec3>);
  return nb::bytes(reinterpret_cast<const char*>(things.data()), things.size_bytes());
}

template <class Thing>
nb::bytes packed(const std::vector<Thing>& things) {
  return packed(std::span<const Thing>(things));
}

template <class Thing>
std::vector<Thing> unpacked(nb::handle bytes) {
  const auto from = nb::cast<nb::bytes>(bytes);
  if (from.size() % sizeof(Thing) != 0) throw InputError("a pickle that is damaged");
  std::vector<Thing> things(from.size() / sizeof(Thing));
  if (from.size() > 0) std::memcpy(things.data(), from.c_str(), from.size());
  return things;
}

/// Text as bytes: names of a file may be no Unicode.
nb::bytes text_bytes(const std::string& text) { return nb::bytes(text.data(), text.size()); }

std::string text_from(nb::handle bytes) {
  const auto from = nb::cast<nb::bytes>(bytes);
  return {from.c_str(), from.size()};
}

nb::tuple state_of(const AtomTable& atoms) {
  nb::list names, residues;
  for (const std::string& name : atoms.names) names.append(text_bytes(name));
  for (const Residue& residue : atoms.residues)
    residues.append(nb::make_tuple(text_bytes(residue.name), residue.number,
                                   int(residue.insertion_code), text_bytes(residue.chain)));
  return nb::make_tuple(names, packed(atoms.elements), packed(atoms.residue_of), residues,
                        packed(atoms.serials));
}

AtomTable atoms_from(nb::handle state) {
  const auto parts = nb::cast<nb::tuple>(state);
  AtomTable atoms;
  for (nb::handle name : nb::cast<nb::list>(parts[0])) atoms.names.push_back(text_from(name));
  atoms.elements = unpacked<std::uint8_t>(parts[1]);
  atoms.residue_of = unpacked<std::uint32_t>(parts[2]);
  for (nb::handle row : nb::cast<nb::list>(parts[3])) {
    const auto residue = nb::cast<nb::tuple>(row);
    atoms.residues.push_back({text_from(residue[0]), nb::cast<std::int64_t>(residue[1]),
                              static_cast<char>(nb::cast<int>(residue[2])), text_from(residue[3])});
  }
  atoms.serials = unpacked<std::int64_t>(parts[4]);
  check(atoms);
  return atoms;
}

nb::tuple state_of(const Sterics& sterics) {
  nb::list own;
  std::vector<std::uint32_t> bonds;
  for (const OwnDistance& pair : sterics.own)
    own.append(nb::make_tuple(pair.a, pair.b, pair.least));
  for (const auto& [a, b] : sterics.bonds) bonds.insert(bonds.end(), {a, b});
  return nb::make_tuple(sterics.kind_count, packed(sterics.kinds), packed(sterics.least), own,
                        packed(sterics.units), sterics.excluded_bonds, packed(bonds));
}

std::shared_ptr<const Sterics> sterics_from(nb::handle state) {
  if (state.is_none()) return nullptr;
  const auto parts = nb::cast<nb::tuple>(state);
  auto sterics = std::make_shared<Sterics>();
  sterics->kind_count = nb::cast<std::size_t>(parts[0]);
  sterics->kinds = unpacked<std::uint16_t>(parts[1]);
  sterics->least = unpacked<double>(parts[2]);
  for (nb::handle row : nb::cast<nb::list>(parts[3])) {
    const auto pair = nb::cast<nb::tuple>(row);
    sterics->own.push_back({nb::cast<std::uint32_t>(pair[0]), nb::cast<std::uint32_t>(pair[1]),
                            nb::cast<double>(pair[2])});
  }
  sterics->units = unpacked<std::uint32_t>(parts[4]);
  sterics->excluded_bonds = nb::cast<int>(parts[5]);
  const auto bonds = unpacked<std::uint32_t>(parts[6]);
  for (std::size_t k = 0; k + 1 < bonds.size(); k += 2)
    sterics->bonds.emplace_back(bonds[k], bonds[k + 1]);
  return sterics;
}

nb::tuple state_of(const TorsionPreferences& preferences) {
  const TorsionColumns columns = columns_of(preferences);
  return nb::make_tuple(packed(columns.staggered), packed(columns.free), packed(columns.backbone),
                        packed(columns.reach));
}

std::shared_ptr<const TorsionPreferences> torsion_preferences_from(nb::handle state) {
  if (state.is_none()) return nullptr;
  const auto parts = nb::cast<nb::tuple>(state);
  return std::make_shared<const TorsionPreferences>(
      torsion_preferences_of({unpacked<std::uint32_t>(parts[0]), unpacked<double>(parts[1]),
                              unpacked<std::uint32_t>(parts[2]), unpacked<double>(parts[3])}));
}

/// A mass whose inverse is this very number: one of those next to 1 / inverse.
double mass_of(double inverse) {
  const double near = 1.0 / inverse;
  double mass = near;
  for (int k = 0; k < 4 && 1.0 / mass != inverse; ++k)
    mass = std::nextafter(mass, std::numeric_limits<double>::infinity());
  if (1.0 / mass == inverse) return mass;
  mass = near;
  for (int k = 0; k < 4 && 1.0 / mass != inverse; ++k) mass = std::nextafter(mass, 0.0);
  return mass;
}

/// The joints of bars, and of bar 0 once more for each that was merged.
std::vector<Joint> joints_of_bars(const Framework& framework) {
  std::vector<Joint> joints;
  for (Bar bar : framework.bars()) joints.insert(joints.end(), {bar.a, bar.b});
  for (std::size_t k = 0; k < framework.merged_bar_count(); ++k)
    joints.insert(joints.end(), {joints[0], joints[1]});
  return joints;
}

nb::tuple framework_state(const Framework& framework) {
  nb::object atoms = nb::none(), sterics = nb::none(), torsions = nb::none();
  if (framework.atoms()) atoms = state_of(*framework.atoms());
  if (framework.sterics()) sterics = state_of(*framework.sterics());
  if (framework.torsion_preferences()) torsions = state_of(*framework.torsion_preferences());
  return nb::make_tuple(layout, framework.joint_count(), packed(joints_of_bars(framework)),
                        packed(framework.rest_lengths()), packed(framework.inverse_masses()), atoms,
                        packed(framework.drawn()), framework.is_planar(),
                        limits_to_python(framework.limits()), sterics, torsions);
}

FrameworkParts parts_from(const nb::tuple& state) {
  check_state(state, 11);
  FrameworkParts parts;
  parts.joint_count = nb::cast<std::size_t>(state[1]);
  const auto joints = unpacked<Joint>(state[2]);
  for (std::size_t k = 0; k + 1 < joints.size(); k += 2)
    parts.bars.push_back({joints[k], joints[k + 1]});
  parts.rest_lengths = unpacked<double>(state[3]);
  if (!parts.rest_lengths.empty())
    parts.rest_lengths.resize(parts.bars.size(), parts.rest_lengths[0]);
  for (const double inverse : unpacked<double>(state[4])) {
    if (inverse == 0.0) parts.pinned.push_back(static_cast<Joint>(parts.masses.size()));
    parts.masses.push_back(inverse == 0.0 ? 1.0 : mass_of(inverse));
  }
  if (!state[5].is_none()) parts.atoms = std::make_shared<const AtomTable>(atoms_from(state[5]));
  parts.drawn = unpacked<Vec3>(state[6]);
  parts.planar = nb::cast<bool>(state[7]);
  parts.limits = limits_from(state[8]);
  parts.sterics = sterics_from(state[9]);
  parts.torsion_preferences = torsion_preferences_from(state[10]);
  return parts;
}

std::vector<std::uint32_t> numbers_of(const std::vector<Bond>& bonds) {
  std::vector<std::uint32_t> numbers;
  for (const Bond& bond : bonds)
    numbers.insert(numbers.end(), {bond.a, bond.b, std::uint32_t(bond.origin), bond.order});
  return numbers;
}

std::vector<Bond> bonds_from(const std::vector<std::uint32_t>& numbers, std::size_t atoms) {
  std::vector<Bond> bonds;
  for (std::size_t k = 0; k + 3 < numbers.size(); k += 4) {
    if (numbers[k] >= atoms || numbers[k + 1] >= atoms ||
        numbers[k + 2] >= bond_origin_names.size())
      throw InputError("a pickle that is damaged");
    bonds.push_back({numbers[k], numbers[k + 1], BondOrigin(numbers[k + 2]),
                     static_cast<std::uint8_t>(numbers[k + 3])});
  }
  return bonds;
}

/// The edges of the cell; empty: none.
std::vector<Vec3> edges_of(const std::optional<Cell>& cell) {
  if (!cell) return {};
  return {cell->edges.begin(), cell->edges.end()};
}

nb::tuple structure_state(const Structure& structure) {
  std::vector<std::uint8_t> ends(structure.chain_end.begin(), structure.chain_end.end());
  return nb::make_tuple(
      layout, text_bytes(structure.title), text_bytes(structure.source), structure.format,
      state_of(structure.atoms), packed(structure.positions), packed(numbers_of(structure.bonds)),
      packed(structure.charges), packed(ends), structure.model, structure.model_count,
      packed(structure.b_factors), structure.assemblies, packed(structure.isotopes),
      packed(structure.radicals), packed(edges_of(structure.cell)), int(structure.dimensions),
      int(structure.b_factor_source), text_bytes(structure.b_factor_record));
}

Structure structure_of_state(const nb::tuple& state) {
  check_state(state, 19);
  Structure structure;
  structure.title = text_from(state[1]);
  structure.source = text_from(state[2]);
  structure.format = nb::cast<std::string>(state[3]);
  structure.atoms = atoms_from(state[4]);
  structure.positions = unpacked<Vec3>(state[5]);
  if (structure.positions.size() != structure.atoms.size())
    throw InputError("a pickle that is damaged");
  structure.bonds = bonds_from(unpacked<std::uint32_t>(state[6]), structure.size());
  structure.charges = unpacked<std::int8_t>(state[7]);
  for (const std::uint8_t end : unpacked<std::uint8_t>(state[8]))
    structure.chain_end.push_back(end != 0);
  structure.model = nb::cast<std::size_t>(state[9]);
  structure.model_count = nb::cast<std::size_t>(state[10]);
  structure.b_factors = unpacked<float>(state[11]);
  if (!structure.b_factors.empty() && structure.b_factors.size() != structure.size())
    throw InputError("a pickle that is damaged");
  structure.assemblies = nb::cast<std::vector<std::string>>(state[12]);
  structure.isotopes = unpacked<std::uint16_t>(state[13]);
  structure.radicals = unpacked<std::uint8_t>(state[14]);
  const auto edges = unpacked<Vec3>(state[15]);
  if (edges.size() == 3) structure.cell = Cell{{edges[0], edges[1], edges[2]}};
  structure.dimensions = static_cast<std::uint8_t>(nb::cast<int>(state[16]));
  structure.b_factor_source = BFactorSource(nb::cast<int>(state[17]));
  structure.b_factor_record = text_from(state[18]);
  return structure;
}

nb::tuple state_state(const State& state) {
  return nb::make_tuple(layout, packed(state.positions), packed(state.previous), state.step,
                        state.time, packed(state.limits_off));
}

State state_from(const nb::tuple& from) {
  check_state(from, 6);
  State state(unpacked<Vec3>(from[1]));
  state.previous = unpacked<Vec3>(from[2]);
  if (state.previous.size() != state.positions.size()) throw InputError("a pickle that is damaged");
  state.step = nb::cast<std::int64_t>(from[3]);
  state.time = nb::cast<double>(from[4]);
  state.limits_off = unpacked<std::uint8_t>(from[5]);
  return state;
}

/// Makes `self` of a state; what cannot be cast is damaged.
template <class Thing, class Make>
void make_from(Thing& self, Make&& make) {
  try {
    new (&self) Thing(make());
  } catch (const std::bad_cast&) {
    throw InputError("a pickle that is damaged");
  }
}

/// `get` makes a tuple of a thing, `set` a thing of a tuple.
template <class Thing, class Get, class Set>
void bind_state(nb::class_<Thing>& bound, Get get, Set set) {
  bound.def("__getstate__", get, nb::sig("def __getstate__(self) -> tuple[object, ...]"))
      .def(
          "__setstate__",
          [set](Thing& self, const nb::tuple& state) {
            make_from(self, [&] { return Thing(set(state)); });
          },
          nb::sig("def __setstate__(self, state: tuple[object, ...]) -> None"));
}

}  // namespace

void bind_pickling(nb::class_<Framework>& framework) {
  bind_state(framework, &framework_state, &parts_from);
}

void bind_pickling(nb::class_<Structure>& structure) {
  bind_state(structure, &structure_state, &structure_of_state);
}

void bind_pickling(nb::class_<State>& state) { bind_state(state, &state_state, &state_from); }

}  // namespace pliant::python
