// SPDX-License-Identifier: MIT
// Degrees of freedom and redundant bars of joints and bars.
#include "framework/framework_rigidity.hpp"

#include "arrays.hpp"
#include "messages.hpp"
#include "pliant/base/error.hpp"
#include "pliant/record/xml/graph_xml.hpp"
#include "pliant/rigidity/framework_rigidity.hpp"

namespace pliant::python {
namespace {

struct Found : FrameworkRigidity {
  std::size_t joints = 0;
  std::size_t bars() const { return rank.redundant.size(); }
};

std::filesystem::path path_from(nb::handle argument) {
  if (!nb::isinstance<nb::str>(argument) && !nb::hasattr(argument, "__fspath__")) return {};
  return nb::cast<std::string>(nb::module_::import_("os").attr("fsdecode")(nb::borrow(argument)));
}

GraphFile graph_from(nb::handle argument) {
  if (nb::isinstance<GraphFile>(argument)) return nb::cast<const GraphFile&>(argument);
  if (!nb::isinstance<Framework>(argument))
    return read_graph_xml(path_from(argument), python_log());
  const auto& framework = nb::cast<const Framework&>(argument);
  if (framework.drawn().empty())
    throw InputError(
        "rigidity: this Framework has no positions of its own: give it "
        "pliant.Graph(framework, positions)");
  return {framework, {framework.drawn().begin(), framework.drawn().end()}, {}};
}

Found rigidity_of_graph(nb::handle argument, const nb::kwargs& options) {
  if (!is_graph(argument)) throw nb::next_overload();
  for (const auto& [name, value] : options) {
    const std::string text = nb::cast<std::string>(name) + ": is for molecules, not for a graph";
    throw nb::type_error(text.c_str());
  }
  const GraphFile graph = graph_from(argument);
  const nb::gil_scoped_release no_gil;
  return {framework_rigidity(graph.framework, graph.positions), graph.framework.joint_count()};
}

std::size_t redundant_bars(const BarRank& rank) {
  return static_cast<std::size_t>(std::count(rank.redundant.begin(), rank.redundant.end(), true));
}

using Self = const Found&;

void bind_freedoms(nb::class_<Found>& bound) {
  bound
      .def_prop_ro(
          "dimension", [](Self self) { return self.dimension; },
          "3; 2 of a planar framework, whose joints keep their z.")
      .def_prop_ro(
          "joints", [](Self self) { return self.joints; }, "Number N of joints.")
      .def_prop_ro(
          "parts", [](Self self) { return self.parts; },
          "Parts that nothing links. Their motions against each other count as internal.")
      .def_prop_ro(
          "degrees_of_freedom", [](Self self) { return self.motions.internal(); },
          "Internal ones at the positions: motions that change no bar to first order, without\n"
          "those of the whole.")
      .def_prop_ro(
          "motions_of_the_whole", [](Self self) { return self.motions.of_whole; },
          "Motions of all joints as one body that leave pinned joints where they are: up to 6, in\n"
          "the plane 3.")
      .def_prop_ro(
          "generic_degrees_of_freedom", [](Self self) { return self.generic_motions.internal(); },
          "Internal ones at almost all positions. Where there are more at these, some may be no\n"
          "more than a first step.")
      .def_prop_ro(
          "counted_degrees_of_freedom", [](Self self) { return self.counted_motions.internal(); },
          "By counting bars (pebble game): in the plane as at almost all positions, in space as\n"
          "many or fewer.");
}

void bind_bars(nb::class_<Found>& bound) {
  bound.def_prop_ro("bars", &Found::bars, "Number B of bars.")
      .def_prop_ro(
          "rank", [](Self self) { return self.rank.rank; },
          "Independent bars: the rank of the rigidity matrix at the positions.")
      .def_prop_ro(
          "generic_rank", [](Self self) { return self.generic_rank.rank; },
          "The rank at almost all positions.")
      .def_prop_ro(
          "self_stresses", [](Self self) { return self.bars() - self.rank.rank; },
          "Independent states of self-stress: bars - rank.")
      .def_prop_ro(
          "redundant", [](Self self) { return redundant_bars(self.rank); },
          "Bars without any one of which the rank stays what it is.")
      .def_prop_ro(
          "bar_redundant", [](Self self) { return mask_of(self.rank.redundant); },
          nb::rv_policy::reference, "(B,) bool: whether each bar is redundant at the positions.")
      .def_prop_ro(
          "bar_generic_redundant", [](Self self) { return mask_of(self.generic_rank.redundant); },
          nb::rv_policy::reference, "(B,) bool: the same at almost all positions.")
      .def_prop_ro(
          "overconstrained",
          [](Self self) {
            nb::list parts;
            for (const OverconstrainedPart& part : self.overconstrained)
              parts.append(array_of(std::vector<std::int64_t>(part.bars.begin(), part.bars.end())));
            return parts;
          },
          nb::sig("def overconstrained(self) -> list[numpy.typing.NDArray[numpy.int64]]"),
          "Redundant bars that hang together over joints that are not pinned: the bars of each "
          "part, int64.")
      .def_prop_ro(
          "nearly_dependent", [](Self self) { return array_of(self.rank.nearly_dependent); },
          nb::rv_policy::reference,
          "float64: singular values of the rigidity matrix between 1e-9, below which they count "
          "as\n"
          "0, and 1e-4. If they are rounding of coordinates, there are so many more freedoms.");
}

constexpr const char* doc =
    R"(Degrees of freedom of a linkage: joints that bars hold at distances.

By the rank of the rigidity matrix: at the positions (singular values above 1e-9; of large frameworks
sparse QR), and at almost all positions (exact, modulo a prime); and by counting bars (pebble game).
Pinned joints stay where they are. Limits and sterics hold nothing.

Parameters
----------
structure : Graph, Framework or path of a graph XML file
    A Framework has positions if it was made with them.

Raises
------
InputError
    A Framework without positions; what ``read_graph_xml`` raises.
TypeError
    An option of molecules.
)";

}  // namespace

bool is_graph(nb::handle argument) {
  return nb::isinstance<GraphFile>(argument) || nb::isinstance<Framework>(argument) ||
         path_from(argument).extension() == ".xml";
}

void bind_framework_rigidity(nb::module_& module) {
  nb::class_<Found> bound(module, "FrameworkRigidity",
                          "Degrees of freedom, redundant bars and overconstrained parts of a "
                          "framework.");
  bind_freedoms(bound);
  bind_bars(bound);
  bound.def("__repr__", [](Self self) {
    return "<pliant.FrameworkRigidity: " + std::to_string(self.motions.internal()) +
           " degrees of freedom of " + std::to_string(self.joints) + " joints>";
  });
  module.def("rigidity", &rigidity_of_graph, "structure"_a, "options"_a,
             nb::sig("def rigidity(structure: Framework | Graph) -> FrameworkRigidity"), doc);
}

}  // namespace pliant::python
