// SPDX-License-Identifier: MIT
// What analyses measure of many frames, on all processors.
#include "arrays.hpp"
#include "pliant/base/threads/threads.hpp"
#include "pliant/measure/pockets.hpp"
#include "pliant/measure/rigid_motion.hpp"
#include "pliant/measure/room.hpp"

namespace pliant::python {
namespace {

using Lining = std::vector<std::uint32_t>;

nb::list pockets_of(const GivenFrames& frames, const std::vector<double>& radii) {
  std::vector<PocketPoints> found(frames.shape(0));
  {
    const nb::gil_scoped_release no_gil;
    for_each_in_threads(all_processors(), found.size(), [&](std::size_t k) {
      found[k] = find_pockets(frame_of(frames, k), radii);
    });
  }
  nb::list out;
  for (PocketPoints& one : found)
    out.append(nb::make_tuple(array_of(std::move(one.pocket)), array_of(std::move(one.atom))));
  return out;
}

nb::object rooms_of(const GivenFrames& frames, const std::vector<double>& radii,
                    const std::vector<Lining>& linings, double step, double offset) {
  std::vector<double> found(2 * frames.shape(0) * linings.size());
  {
    const nb::gil_scoped_release no_gil;
    for_each_in_threads(all_processors(), found.size() / 2, [&](std::size_t k) {
      const std::size_t frame = k / linings.size(), lining = k % linings.size();
      const Room room = room_among(frame_of(frames, frame), radii, linings[lining], step, offset);
      found[2 * k] = room.all;
      found[2 * k + 1] = room.enclosed;
    });
  }
  return nb::cast(pairs_array_of(std::move(found)));
}

using GivenPlaces = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using GivenMoves = nb::ndarray<const double, nb::shape<-1, 3, -1>, nb::c_contig, nb::device::cpu>;
using GivenSides = nb::ndarray<const bool, nb::shape<-1>, nb::c_contig, nb::device::cpu>;
using GivenStretches =
    nb::ndarray<const std::int64_t, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;

nb::object followed_by(const GivenPlaces& mean, const GivenMoves& moves, const GivenSides& is_one,
                       const GivenStretches& stretches) {
  const SiteMoves sites{{reinterpret_cast<const Vec3*>(mean.data()), mean.shape(0)},
                        {moves.data(), moves.size()}};
  std::vector<double> found;
  for (const auto& both : followed_rigidly(
           sites, {reinterpret_cast<const std::uint8_t*>(is_one.data()), is_one.size()},
           {reinterpret_cast<const Stretch*>(stretches.data()), stretches.shape(0)}))
    found.insert(found.end(), both.begin(), both.end());
  return nb::cast(pairs_array_of(std::move(found)));
}

}  // namespace

void bind_measures(nb::module_& module) {
  module.attr("POCKET_STEP") = pocket_step;
  module.def("find_pockets", &pockets_of, "frames"_a, "radii"_a,
             nb::sig("def find_pockets(frames: numpy.typing.NDArray[numpy.float64], "
                     "radii: numpy.typing.NDArray[numpy.float64]) -> "
                     "list[tuple[numpy.typing.NDArray[numpy.int64], "
                     "numpy.typing.NDArray[numpy.int64]]]"),
             "Of each frame (F, n, 3): the points of pockets, as the pocket of each, from 0 by "
             "size, and the atom nearest to it.");
  module.def("followed_rigidly", &followed_by, "mean"_a, "moves"_a, "is_one"_a, "stretches"_a,
             nb::sig("def followed_rigidly(mean: numpy.typing.NDArray[numpy.float64], "
                     "moves: numpy.typing.NDArray[numpy.float64], "
                     "is_one: numpy.typing.NDArray[numpy.bool_], "
                     "stretches: numpy.typing.NDArray[numpy.int64]) -> "
                     "numpy.typing.NDArray[numpy.float64]"),
             "Of sites of mean (n, 3) and moves (n, 3, m), and of each stretch (first, end): the "
             "sums of squares (s, 2) that the sites of is_one follow as one rigid body, and the "
             "others, once the sites of the stretch have changed sides.");
  module.def("rooms_among", &rooms_of, "frames"_a, "radii"_a, "linings"_a, "step"_a = pocket_step,
             "offset"_a = 0.0,
             nb::sig("def rooms_among(frames: numpy.typing.NDArray[numpy.float64], "
                     "radii: numpy.typing.NDArray[numpy.float64], "
                     "linings: collections.abc.Sequence[numpy.typing.NDArray[numpy.int64]], "
                     "step: float = 1.0, offset: float = 0.0) -> "
                     "numpy.typing.NDArray[numpy.float64]"),
             "Of each frame (F, n, 3) and of each lining (numbers of atoms) in turn: the room "
             "within its hull, and how much of it is enclosed, Angstrom^3 (F L, 2).");
}

}  // namespace pliant::python
