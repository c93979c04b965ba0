// SPDX-License-Identifier: MIT
// Guides: where joints are asked to go.
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/variant.h>

#include <limits>
#include <variant>

#include "arrays.hpp"
#include "checks.hpp"
#include "pliant/base/error.hpp"
#include "pliant/perturb/guide.hpp"

namespace pliant::python {
namespace {

using Place = std::tuple<double, double, double>;
using Distances = std::variant<double, std::tuple<double, double>>;
using PythonPull = std::tuple<nb::object, Place>;
using PythonPair = std::tuple<nb::object, nb::object, Distances>;

std::vector<Joint> group_from(const nb::object& given) {
  std::vector<Joint> joints;
  for (const std::int64_t joint : integers_from(ArrayLike{given}, "joints")) {
    if (joint < 0 || joint > std::numeric_limits<Joint>::max())
      fail_index("joint", joint, std::numeric_limits<Joint>::max());
    joints.push_back(static_cast<Joint>(joint));
  }
  return joints;
}

Pull pull_from(const PythonPull& given) {
  const auto& [joints, to] = given;
  const auto [x, y, z] = to;
  return {group_from(joints), {x, y, z}};
}

PairDistance pair_from(const PythonPair& given) {
  const auto& [first, second, distances] = given;
  PairDistance pair{group_from(first), group_from(second), 0.0, 0.0};
  if (const auto* one = std::get_if<double>(&distances))
    pair.least = pair.most = *one;
  else
    std::tie(pair.least, pair.most) = std::get<std::tuple<double, double>>(distances);
  return pair;
}

void make_guide(Guide* self, const OptionalArray& rock, const std::vector<PythonPull>& pulls,
                const std::vector<PythonPair>& pairs, std::int64_t period) {
  Guide guide;
  if (rock) guide.rock = positions_from(*rock, "rock");
  for (const PythonPull& pull : pulls) guide.pulls.push_back(pull_from(pull));
  for (const PythonPair& pair : pairs) guide.pairs.push_back(pair_from(pair));
  guide.period = period;
  new (self) Guide(std::move(guide));
}

void check_joints(const Guide& guide, std::size_t joints) {
  const auto check_group = [&](const std::vector<Joint>& group) {
    for (Joint joint : group)
      if (joint >= joints) fail_index("joint", joint, static_cast<std::int64_t>(joints) - 1);
  };
  for (const Pull& pull : guide.pulls) check_group(pull.joints);
  for (const PairDistance& pair : guide.pairs) {
    check_group(pair.first);
    check_group(pair.second);
  }
}

/// Positions that have every joint of the guide. Throws IndexError.
std::vector<Vec3> positions_for(const Guide& guide, const ArrayLike& positions) {
  std::vector<Vec3> x = positions_from(positions);
  check_joints(guide, x.size());
  return x;
}

constexpr const char* guide_doc =
    R"(Targets that joints move towards step by step (steered motion). For ``run`` and ``Motion``.

Each step moves what is not there yet by ``displacement`` at most (an option of ``run``), and then
resolves. What holds it back (bars, contacts, overlaps) may keep it from arriving.

Parameters
----------
rock : (N, 3) array-like, optional
    How far out joints swing to either side, Angstrom: ``mode_field`` gives it for a mode of an
    elastic network. There, to the other side and back as a triangular wave.
pulls : sequence of (joints, (x, y, z))
    Groups of joints, each moved as a whole until its centre is at that place, Angstrom.
pairs : sequence of (joints, joints, distance or (least, most))
    Pairs of groups, moved together or apart until their centres are at that distance, or between
    these, Angstrom, as FRET, DEER or a cross-link has it.
period : int
    Steps of rocking, from 2.
)";

}  // namespace

void bind_guide(nb::module_& module) {
  nb::class_<Guide>(module, "Guide", guide_doc)
      .def("__init__", &make_guide, nb::kw_only(), "rock"_a = nb::none(),
           "pulls"_a = std::vector<PythonPull>(), "pairs"_a = std::vector<PythonPair>(),
           "period"_a = Guide().period,
           nb::sig("def __init__(self, *, rock: numpy.typing.ArrayLike | None = None, "
                   "pulls: collections.abc.Sequence[tuple[numpy.typing.ArrayLike, "
                   "tuple[float, float, float]]] = (), "
                   "pairs: collections.abc.Sequence[tuple[numpy.typing.ArrayLike, "
                   "numpy.typing.ArrayLike, float | tuple[float, float]]] = (), "
                   "period: int = 100) -> None"))
      .def(
          "has_arrived",
          [](const Guide& self, const ArrayLike& positions) {
            return has_arrived(self, positions_for(self, positions));
          },
          "positions"_a,
          "Whether nothing is left to follow at positions (N, 3), Angstrom: each pull is within\n"
          "0.05 Angstrom of its place, each pair of its distance. Never while it rocks.")
      .def(
          "pulls_away",
          [](const Guide& self, const ArrayLike& positions) {
            const std::vector<Vec3> x = positions_for(self, positions);
            std::vector<double> away;
            for (const Pull& pull : self.pulls) away.push_back(norm(way_of(pull, x)));
            return array_of(std::move(away));
          },
          "positions"_a,
          "(K,) float64: how far each pulled centre is from its place at positions (N, 3),\n"
          "Angstrom.")
      .def(
          "pair_distances",
          [](const Guide& self, const ArrayLike& positions) {
            const std::vector<Vec3> x = positions_for(self, positions);
            std::vector<double> found;
            for (const PairDistance& pair : self.pairs) found.push_back(norm(line_of(pair, x)));
            return array_of(std::move(found));
          },
          "positions"_a, "(K,) float64: distances of the pairs at positions (N, 3), Angstrom.");
}

}  // namespace pliant::python
