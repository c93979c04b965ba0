// SPDX-License-Identifier: MIT
#include "fit/map_surface.hpp"

#include "arrays.hpp"
#include "pliant/fit/map/surface.hpp"

namespace pliant::python {
namespace {

using Triangles = nb::ndarray<nb::numpy, std::uint32_t, nb::shape<-1, 3>, nb::c_contig>;

nb::tuple surface_at(const DensityMap& map, double level) {
  Surface found = surface_of(map, level);
  auto* kept = new std::vector<std::array<std::uint32_t, 3>>(std::move(found.triangles));
  return nb::make_tuple(new_positions(std::move(found.vertices)),
                        Triangles(kept->data(), {kept->size(), 3}, owner_of(kept)));
}

constexpr const char* surface_doc =
    R"(The closed surface around what is at or above a level, as triangles.

By surface nets (S. Gibson, MICCAI 1998): a vertex for each cell of the grid that it crosses. Beyond
the border of the map there is nothing.

Parameters
----------
level : float
    In the unit of the values; see ``level_around``.

Returns
-------
vertices : (V, 3) float64
    Angstrom.
triangles : (T, 3) uint32
    Numbers of vertices, counterclockwise seen from outside.

Raises
------
OptionError
    The level is above the greatest value, or not finite.
)";

constexpr const char* level_around_doc =
    R"(The level that the densest points which fill a volume (Angstrom^3) are at or above.

A protein takes 1.21 Angstrom^3 a dalton. Raises OptionError for a volume that is not above 0, or
above that of the map.
)";

}  // namespace

void bind_map_surface(nb::class_<DensityMap>& bound) {
  bound
      .def("surface", &surface_at, "level"_a,
           nb::sig("def surface(self, level: float) -> tuple[numpy.typing.NDArray[numpy.float64], "
                   "numpy.typing.NDArray[numpy.uint32]]"),
           surface_doc)
      .def("level_around", &level_around, "volume"_a, level_around_doc);
}

}  // namespace pliant::python
