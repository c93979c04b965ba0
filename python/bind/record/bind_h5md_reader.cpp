// SPDX-License-Identifier: MIT
// Reading H5MD files: frames, and the framework and structure that were recorded.
#include <nanobind/stl/filesystem.h>

#include <algorithm>
#include <iterator>
#include <numeric>

#include "arrays.hpp"
#include "checks.hpp"
#include "framework/limits.hpp"
#include "locked.hpp"
#include "messages.hpp"
#include "molecule/structure_columns.hpp"
#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/record/hdf5/expansion.hpp"
#include "pliant/record/hdf5/hdf5_dataset.hpp"
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

FramesView block_of(LockedReader& self, std::int64_t first, std::int64_t count) {
  std::size_t joints = 0;
  std::vector<Vec3> positions = self.call([&](const H5mdReader& reader) {
    joints = reader.joint_count();
    return reader.block(first, count);
  });
  return new_frames(std::move(positions), static_cast<std::size_t>(count), joints);
}

/// What the member function `Call` returns, as an array.
template <auto Call>
auto recorded_array() {
  return [](LockedReader& self) {
    return array_of(self.call([](const H5mdReader& reader) { return (reader.*Call)(); }));
  };
}

/// One number a frame, of the kind that is recorded.
nb::object observable_of(LockedReader& self, const std::string& name) {
  SeriesKind kind{};
  std::vector<double> values = self.call([&](const H5mdReader& reader) {
    kind = reader.kind_of(name);
    return reader.observable(name);
  });
  if (kind == SeriesKind::real) return nb::cast(array_of(std::move(values)));
  if (kind == SeriesKind::truth) return nb::cast(mask_of({values.begin(), values.end()}));
  return nb::cast(array_of(std::vector<std::int64_t>(values.begin(), values.end())));
}

/// Of a file that names no atoms.
AtomTable nameless(std::size_t count) {
  AtomTable atoms;
  atoms.elements.assign(count, 0);
  atoms.names.assign(count, std::string(element_symbol(0)));
  atoms.residue_of.assign(count, 0);
  if (count > 0) atoms.residues.push_back({.name = "UNK", .chain = ""});
  atoms.serials.resize(count);
  std::iota(atoms.serials.begin(), atoms.serials.end(), 1);
  return atoms;
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
  Structure structure;
  structure.format = "h5md";
  structure.atoms = atoms ? *atoms : nameless(reader.joint_count());
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
      .def("block", &block_of, "first"_a, "count"_a,
           nb::sig("def block(self, first: int, count: int) -> "
                   "numpy.typing.NDArray[numpy.float64]"),
           "(count, N, 3) float64, Angstrom: frames from `first` on, also such as are damaged and\n"
           "not finite.")
      .def_prop_ro("rounded_to", locked<H5mdReader, &H5mdReader::rounded_to>(),
                   "Coordinates are multiples of this, Angstrom; 0: they are as they were.")
      .def_prop_ro("frames_left_out", locked<H5mdReader, &H5mdReader::frames_left_out>(),
                   "Frames that lack positions, step or time, and are not counted.")
      .def_prop_ro("bytes_per_coordinate", locked<H5mdReader, &H5mdReader::bytes_per_coordinate>(),
                   "8 for double precision, 4 for single.")
      .def("steps", recorded_array<&H5mdReader::steps>(), "(F,) the steps of all frames.")
      .def("times", recorded_array<&H5mdReader::times>(),
           "(F,) the times of all frames, ps; empty where the file has none.")
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
      .def("observable", &observable_of, "name"_a,
           nb::sig("def observable(self, name: str) -> numpy.typing.NDArray[typing.Any]"),
           "(F,) float64, int64 or bool: one number a frame.")
      .def("contact_states", recorded_array<&H5mdReader::contact_states>(),
           "(F * C,) of each contact in each frame, frame after frame: 0 held, 1 broken, 2 "
           "switched\n"
           "off; in the order of each one's first limit.")
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

/// What is the same in all frames.
void bind_fixed(nb::class_<LockedReader>& reader) {
  reader
      .def(
          "bars",
          [](LockedReader& self) {
            std::vector<std::uint32_t> ends;
            for (const Bar& bar :
                 self.call([](const H5mdReader& reader) { return reader.bars(); })) {
              ends.push_back(bar.a);
              ends.push_back(bar.b);
            }
            return pairs_array_of(std::move(ends));
          },
          "(B, 2) joints; empty where the file has none.")
      .def("rest_lengths", recorded_array<&H5mdReader::rest_lengths>(),
           "(B,) Angstrom; empty where the file has none.")
      .def("masses", recorded_array<&H5mdReader::masses>(),
           "(N,) u; empty where the file has none.")
      .def(
          "limits",
          [](LockedReader& self) {
            return limits_to_python(
                self.call([](const H5mdReader& reader) { return reader.limits(); }));
          },
          nb::sig("def limits(self) -> numpy.typing.NDArray[numpy.void]"),
          "As those of a Framework.")
      .def_prop_ro(
          "has_atoms",
          [](LockedReader& self) {
            return self.call([](const H5mdReader& reader) { return reader.atoms() != nullptr; });
          },
          "Whether the file names the atoms.")
      .def_prop_ro("joints_of_whole", locked<H5mdReader, &H5mdReader::joints_of_whole>(),
                   "Joints of the molecule, of which the file has some; 0: it has all.");
}

void check_file(const std::filesystem::path& path) {
  const nb::gil_scoped_release no_gil;
  while_written(path, [&] { check_hdf5(path); });
}

}  // namespace

void bind_h5md_reader(nb::module_& module) {
  module.def(
      "check_hdf5", &check_file, "path"_a,
      "Looks at an HDF5 file before another library reads it. Raises InputError if it is damaged\n"
      "or would take memory out of proportion to its size, FileError if it cannot be read.");
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
  bind_fixed(reader);
}

}  // namespace pliant::python
