// SPDX-License-Identifier: MIT
// Density maps: files, values between points, and the map of a molecule.
#include <nanobind/stl/filesystem.h>

#include <array>

#include "arrays.hpp"
#include "fit/map_agreement.hpp"
#include "fit/map_surface.hpp"
#include "molecule/structure.hpp"
#include "pliant/base/error.hpp"
#include "pliant/fit/map/blurred.hpp"
#include "pliant/fit/map/read_map.hpp"
#include "pliant/fit/map/simulated.hpp"
#include "pliant/fit/map/write_map.hpp"

namespace pliant::python {
namespace {

using MapValues = nb::ndarray<nb::numpy, const float, nb::shape<-1, -1, -1>, nb::c_contig>;
using GivenMap = nb::ndarray<const float, nb::shape<-1, -1, -1>, nb::c_contig, nb::device::cpu>;

std::array<double, 3> three_from(const ArrayLike& argument, const char* name) {
  const std::vector<double> given = reals_from(argument, name);
  if (given.size() != 3)
    throw InputError(std::string(name) + ": expected 3 numbers, found " +
                     std::to_string(given.size()));
  return {given[0], given[1], given[2]};
}

/// float32 as it is kept; other numbers are converted.
DensityMap map_of(const ArrayLike& values, const ArrayLike& spacing, const ArrayLike& origin) {
  const nb::object array = nb::module_::import_("numpy").attr("ascontiguousarray")(
      values.object, nb::arg("dtype") = "float32");
  GivenMap given;
  if (!nb::try_cast(array, given, false))
    throw InputError("values: expected an array of real numbers with shape (X, Y, Z)");
  const std::array<double, 3> step = three_from(spacing, "spacing"),
                              first = three_from(origin, "origin");
  MapGrid grid;
  grid.count = {given.shape(0), given.shape(1), given.shape(2)};
  grid.steps = {Vec3{step[0], 0, 0}, Vec3{0, step[1], 0}, Vec3{0, 0, step[2]}};
  grid.origin = {first[0], first[1], first[2]};
  return {grid, std::vector<float>(given.data(), given.data() + given.size())};
}

DensityMap map_of_structure(const nb::handle& structure, double resolution,
                            std::optional<double> spacing, const DensityMap* like) {
  const WeighedAtoms atoms = weighed_atoms(structure);
  const nb::gil_scoped_release no_gil;
  const MapGrid grid = like != nullptr ? like->grid()
                                       : grid_around(atoms.positions, resolution,
                                                     spacing.value_or(usual_spacing(resolution)));
  return simulated(grid, atoms.positions, atoms.weights, resolution);
}

nb::tuple at_positions(const DensityMap& map, const ArrayLike& positions) {
  DensitiesAt found = map.at(positions_from(positions));
  return nb::make_tuple(array_of(std::move(found.values)),
                        new_positions(std::move(found.gradients)), found.outside);
}

MapValues values_of(const nb::handle& self) {
  const auto& map = nb::cast<const DensityMap&>(self);
  const std::array<std::size_t, 3>& count = map.grid().count;
  return {map.values().data(), {count[0], count[1], count[2]}, self};
}

constexpr const char* map_doc =
    R"(A density map: values at the points of a grid, as electron microscopy and crystals give them.

Parameters
----------
values : (X, Y, Z) array-like
    Kept as float32.
spacing : (3,) array-like
    Between points along x, y and z, Angstrom.
origin : (3,) array-like
    Where the first point is, Angstrom.

Raises
------
InputError
    Another shape, fewer than 2 points along an axis, or numbers that are not finite.
)";

constexpr const char* read_doc =
    R"(Reads an MRC or CCP4 map, also compressed.

Modes 0, 1, 2, 6 and 12, either order of bytes, axes in any order, any cell. The origin is that of
the header if it is not 0, as in ChimeraX; else the numbers of the first points x the spacing.
Nothing is repeated beyond the box that the file has.

Parameters
----------
path : path

Raises
------
FileError
    The file cannot be read.
InputError
    The file is no map, is cut short, or has numbers that are not finite: with the field, what was
    expected and what was found.
)";

constexpr const char* from_structure_doc =
    R"(The map that a molecule would have: a Gaussian for each atom, by its atomic number.

Sigma is 0.225 x the resolution, as EMAN and ChimeraX' molmap take it. Each Gaussian is as high as
the atomic number. Atoms of unknown element are left out.

Parameters
----------
structure : Structure
resolution : float
    Angstrom, from 0.5 to 200.
spacing : float, optional
    Angstrom. None: a quarter of the resolution.
like : DensityMap, optional
    A map whose grid is taken.

Raises
------
OptionError
    The resolution or the spacing is out of its range.
InputError
    No atom has a known element, or the map would have too many points.
)";

constexpr const char* at_doc =
    R"(The density at any place: linear between the eight points around it.

Parameters
----------
positions : (N, 3) array-like
    Angstrom.

Returns
-------
values : (N,) float64
    0 outside of the box of the map.
gradients : (N, 3) float64
    Of these values, exactly; per Angstrom.
outside : int
    How many positions are outside.

Raises
------
InputError
    Another shape.
)";

constexpr const char* blurred_doc =
    R"(The map convolved with a Gaussian whose sigma is 0.225 x the resolution.

This adds to the blur that the map has. A map whose axes are not at right angles is put onto such
first.

Parameters
----------
resolution : float
    Angstrom, from 0.5 to 200.

Raises
------
OptionError
    The resolution is out of its range.
)";

constexpr const char* save_doc =
    R"(Writes the map as an MRC file (MRC2014, float32).

Parameters
----------
path : path
overwrite : bool
    Whether a file of that name is replaced.

Raises
------
FileError
    The file is there already, or cannot be written.
)";

Array1<double> three_of(const std::array<double, 3>& numbers) {
  return array_of(std::vector<double>(numbers.begin(), numbers.end()));
}

/// What the grid is.
void bind_grid(nb::class_<DensityMap>& bound) {
  bound
      .def_prop_ro(
          "shape",
          [](const DensityMap& map) {
            return nb::make_tuple(map.grid().count[0], map.grid().count[1], map.grid().count[2]);
          },
          nb::sig("def shape(self) -> tuple[int, int, int]"), "Points along each axis.")
      .def_prop_ro(
          "origin",
          [](const DensityMap& map) {
            const Vec3 at = map.grid().origin;
            return three_of({at.x, at.y, at.z});
          },
          nb::rv_policy::automatic,
          nb::sig("def origin(self) -> numpy.typing.NDArray[numpy.float64]"),
          "(3,) where the first point is, Angstrom; a copy.")
      .def_prop_ro(
          "spacing", [](const DensityMap& map) { return three_of(map.grid().spacing()); },
          nb::rv_policy::automatic,
          nb::sig("def spacing(self) -> numpy.typing.NDArray[numpy.float64]"),
          "(3,) between points along each axis, Angstrom; a copy.")
      .def_prop_ro(
          "steps",
          [](const DensityMap& map) {
            const std::array<Vec3, 3>& steps = map.grid().steps;
            return new_positions({steps.begin(), steps.end()});
          },
          nb::rv_policy::automatic,
          nb::sig("def steps(self) -> numpy.typing.NDArray[numpy.float64]"),
          "(3, 3) from a point to the next along each axis, one a row, Angstrom; a copy. Point\n"
          "(i, j, k) is at origin + (i, j, k) @ steps.")
      .def_prop_ro("values", &values_of, nb::rv_policy::automatic,
                   nb::sig("def values(self) -> numpy.typing.NDArray[numpy.float32]"),
                   "(X, Y, Z) the values, read-only, without a copy.");
}

}  // namespace

void bind_density_map(nb::module_& module) {
  module.def("check_resolution", &check_resolution, "resolution"_a,
             "Raises OptionError unless maps may have that resolution (Angstrom).");
  nb::class_<DensityMap> bound(module, "DensityMap", map_doc);
  bound
      .def(
          "__init__",
          [](DensityMap* self, const ArrayLike& values, const ArrayLike& spacing,
             const ArrayLike& origin) { new (self) DensityMap(map_of(values, spacing, origin)); },
          "values"_a, "spacing"_a, "origin"_a = nb::make_tuple(0.0, 0.0, 0.0))
      .def_static("read", &read_map, "path"_a, nb::call_guard<nb::gil_scoped_release>(), read_doc)
      .def_static("from_structure", &map_of_structure, "structure"_a, "resolution"_a, nb::kw_only(),
                  "spacing"_a = nb::none(), "like"_a = nb::none(),
                  nb::sig("def from_structure(structure: Structure | Molecule, resolution: float, "
                          "*, spacing: float | None = None, like: DensityMap | None = None) -> "
                          "DensityMap"),
                  from_structure_doc)
      .def("at", &at_positions, "positions"_a,
           nb::sig("def at(self, positions: numpy.typing.ArrayLike) -> "
                   "tuple[numpy.typing.NDArray[numpy.float64], "
                   "numpy.typing.NDArray[numpy.float64], int]"),
           at_doc)
      .def("blurred", &blurred, "resolution"_a, nb::call_guard<nb::gil_scoped_release>(),
           blurred_doc)
      .def("normalized", &normalized,
           "The map with mean 0 and standard deviation 1. Raises InputError if all values are\n"
           "equal.")
      .def(
          "save",
          [](const DensityMap& map, const std::filesystem::path& path, bool overwrite) {
            write_map(path, map, overwrite);
          },
          "path"_a, nb::kw_only(), "overwrite"_a = false, nb::call_guard<nb::gil_scoped_release>(),
          save_doc);
  bind_grid(bound);
  bind_map_agreement(bound);
  bind_map_surface(bound);
}

}  // namespace pliant::python
