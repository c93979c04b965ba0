// SPDX-License-Identifier: MIT
// Reading H5MD files: frames, and the framework and structure that were recorded.
#include <nanobind/stl/filesystem.h>

#include <algorithm>
#include <iterator>

#include "arrays.hpp"
#include "checks.hpp"
#include "locked.hpp"
#include "messages.hpp"
#include "molecule/structure_columns.hpp"
#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/record/hdf5/expansion.hpp"
#include "pliant/record/hdf5/structure_check.hpp"
#include "pliant/record/hdf5/while_written.hpp"

namespace pliant::python {

void bind_h5md_reader(nb::module_& module);

namespace {

void make_reader(LockedReader* self, const std::filesystem::path& path, const std::string& group) {
  const H5mdReadOptions options{group, python_log()};
  const nb::gil_scoped_release no_gil;
  new (self) LockedReader(path, options);
}

/// Python counts from the end with negative numbers.
std::int64_t frame_at(const H5mdReader& reader, std::int64_t frame) {
  const std::int64_t count = reader.frames();
  const std::int64_t from_start = frame < 0 ? frame + count : frame;
  if (from_start < 0 || from_start >= count)
    fail_index("frame", frame, static_cast<std::size_t>(count));
  return from_start;
}

PositionsView positions_of(LockedReader& self, std::int64_t frame) {
  return new_positions(self.call(
      [&](const H5mdReader& reader) { return reader.positions(frame_at(reader, frame)); }));
}

/// An origin that we do not know is what another program put into the file.
BondOrigin origin_of(const std::vector<std::string>& names, std::size_t origin) {
  if (origin >= names.size()) return BondOrigin::file;
  const auto known = std::find(bond_origin_names.begin(), bond_origin_names.end(), names[origin]);
  if (known == bond_origin_names.end()) return BondOrigin::file;
  return static_cast<BondOrigin>(std::distance(bond_origin_names.begin(), known));
}

std::vector<Bond> bonds_of(const H5mdReader& reader) {
  const std::vector<std::string> names = reader.bond_origin_names();
  std::vector<Bond> bonds;
  for (const RecordedBond& bond : reader.bonds()) {
    if (bond.a == bond.b) continue;  // a file of another program may hold anything
    bonds.push_back({bond.a, bond.b, origin_of(names, bond.origin), bond.order});
  }
  return canonical(std::move(bonds));
}

Structure structure_of(const H5mdReader& reader, std::int64_t frame) {
  const auto atoms = reader.atoms();
  if (!atoms) throw InputError("the file has no atom table, so there is no structure to read");
  Structure structure;
  structure.format = "h5md";
  structure.atoms = *atoms;
  for (std::uint8_t& element : structure.atoms.elements)
    if (element > element_count) element = 0;
  structure.positions = reader.positions(frame_at(reader, frame));
  structure.bonds = bonds_of(reader);
  return structure;
}

nb::dict parameters_of(LockedReader& self) {
  const std::vector<NamedParameter> parameters =
      self.call([](const H5mdReader& reader) { return reader.parameters(); });
  nb::dict values;
  for (const auto& [path, value] : parameters)
    std::visit([&](const auto& held) { values[path.c_str()] = held; }, value);
  return values;
}

void bind_frames(nb::class_<LockedReader>& reader) {
  reader.def("__len__", locked<H5mdReader, &H5mdReader::frames>())
      .def_prop_ro("joint_count", locked<H5mdReader, &H5mdReader::joint_count>(),
                   "Number N of joints.")
      .def("positions", &positions_of, "frame"_a,
           "(N, 3) float64, Angstrom: a new array. Negative frames count from the end.")
      .def(
          "step",
          [](LockedReader& self, std::int64_t frame) {
            return self.call(
                [&](const H5mdReader& reader) { return reader.step(frame_at(reader, frame)); });
          },
          "frame"_a, "The step of a frame.")
      .def(
          "time",
          [](LockedReader& self, std::int64_t frame) {
            return self.call(
                [&](const H5mdReader& reader) { return reader.time(frame_at(reader, frame)); });
          },
          "frame"_a, "The time of a frame in ps.");
}

void bind_recorded(nb::class_<LockedReader>& reader) {
  reader
      .def_prop_ro("observables", locked<H5mdReader, &H5mdReader::observables>(),
                   "Names of what is recorded once a frame as a number, sorted.")
      .def(
          "observable",
          [](LockedReader& self, const std::string& name) {
            return array_of(
                self.call([&](const H5mdReader& reader) { return reader.observable(name); }));
          },
          "name"_a, "(F,) float64: one number a frame; truth values are 0 and 1.")
      .def("parameters", &parameters_of,
           nb::sig("def parameters(self) -> dict[str, bool | int | float | str]"),
           "The values below /parameters by path: every option of the run.")
      .def("framework", locked<H5mdReader, &H5mdReader::framework>(),
           "The framework that was recorded.")
      .def(
          "structure",
          [](LockedReader& self, std::int64_t frame) {
            return self.call([&](const H5mdReader& reader) { return structure_of(reader, frame); });
          },
          "frame"_a = 0, "The atoms and bonds that were recorded, at the positions of a frame.");
}

bool check_structure(const std::filesystem::path& path) {
  const nb::gil_scoped_release no_gil;
  return while_written(path, [&] { return check_hdf5_structure(path); });
}

}  // namespace

void bind_h5md_reader(nb::module_& module) {
  module.def(
      "check_hdf5_structure", &check_structure, "path"_a,
      "Checks the structure of an HDF5 file within bounds, without HDF5. Returns whether all\n"
      "of it has a known format; raises InputError if it is damaged.");
  module.def(
      "expansion_refusal",
      [](std::uint64_t values, std::uint64_t at_once, std::uint64_t chunk, std::uint64_t stored,
         std::uint64_t chunks, std::uint64_t file_size) {
        return refusal_of({values, at_once, chunk, stored, chunks, file_size, harmless_chunk});
      },
      nb::kw_only(), "values"_a, "at_once"_a, "chunk"_a, "stored"_a, "chunks"_a, "file_size"_a,
      "Why values of a dataset are not read: the file cannot hold them, or they would take memory\n"
      "out of proportion to what it holds. \"\" if they may be read. In bytes, but for the number\n"
      "of chunks that are stored.");
  module.def("writer_of", &writer_of, "path"_a,
             "Who is writing a file now, such as \"process 123\"; \"\" for nobody.");
  nb::class_<LockedReader> reader(
      module, "H5mdReader",
      "An H5MD file, ours or another program's, which may still be written.\n\n"
      "``group`` is a name below /particles; default: \"trajectory\", else the first with\n"
      "positions. Raises FileError when HDF5 cannot read, InputError when what was read makes no\n"
      "sense; both name the file and the path within it.");
  reader.def("__init__", &make_reader, "path"_a, nb::kw_only(), "group"_a = "");
  bind_frames(reader);
  bind_recorded(reader);
}

}  // namespace pliant::python
