// SPDX-License-Identifier: MIT
// How plausible other shapes of a molecule are, and how soft it is.
#include "arrays.hpp"
#include "pliant/sample/network/softness.hpp"
#include "pliant/sample/turns/plausible_shapes.hpp"

namespace pliant::python {
namespace {

nb::object scores_of(const PlausibleShapes& self, const GivenFrames& frames) {
  std::vector<double> found;
  for (std::size_t k = 0; k < frames.shape(0); ++k)
    found.push_back(self.score(frame_of(frames, k)));
  return nb::cast(array_of(std::move(found)));
}

}  // namespace

void bind_plausible_shapes(nb::module_& module) {
  module.def(
      "softness", [](const ArrayLike& nodes) { return softness(positions_from(nodes)); },
      "positions"_a, nb::sig("def softness(positions: numpy.typing.ArrayLike) -> float"),
      "1 / the lowest eigenvalue above zero of Kirchhoff's matrix of alpha carbons (N, 3), "
      "Angstrom.\nThe spring of two within 10 Angstrom is the number of neighbours that they "
      "share.");
  nb::class_<PlausibleShapes>(
      module, "PlausibleShapes",
      "How plausible other shapes of a protein are, by what known pairs of structures have in "
      "common.")
      .def(
          "__init__",
          [](PlausibleShapes* self, const ArrayLike& start, double scale) {
            new (self) PlausibleShapes(positions_from(start, "start"), scale);
          },
          "start"_a, "scale"_a = 1.0,
          nb::sig("def __init__(self, start: numpy.typing.ArrayLike, scale: float = 1.0) -> None"))
      .def_prop_ro("softness", &PlausibleShapes::softness, "As ``softness`` of the start.")
      .def_prop_ro("expected", &PlausibleShapes::expected,
                   "RMSD of the other structure that is expected of so soft a protein (Angstrom).")
      .def_prop_ro("openness", &PlausibleShapes::openness, "From -1, compact, to 1, open.")
      .def("scores", &scores_of, "frames"_a,
           nb::sig("def scores(self, frames: numpy.typing.NDArray[numpy.float64]) -> "
                   "numpy.typing.NDArray[numpy.float64]"),
           "(F,) natural logarithms of how plausible frames (F, n, 3) are, but for a constant.");
}

}  // namespace pliant::python
