// SPDX-License-Identifier: MIT
// Framework, State and graph facts.
#include "arrays.hpp"
#include "checks.hpp"
#include "framework/frame.hpp"
#include "framework/limits.hpp"
#include "pickling.hpp"
#include "pliant/base/error.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/framework/graph.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant::python {

void bind_examples(nb::module_& module);
void bind_sterics(nb::module_& module);
void bind_torsion_preferences(nb::module_& module);
void bind_residual(nb::module_& module);

namespace {

std::shared_ptr<const AtomTable> table_of_names(std::vector<std::string> names) {
  auto atoms = std::make_shared<AtomTable>();
  atoms->names = std::move(names);
  atoms->elements.assign(atoms->size(), 0);
  atoms->residue_of.assign(atoms->size(), 0);
  atoms->residues.push_back({"", 1, ' ', ""});
  for (std::size_t i = 0; i < atoms->size(); ++i)
    atoms->serials.push_back(static_cast<std::int64_t>(i));
  return atoms;
}

std::vector<double> lengths_at(const std::vector<Vec3>& positions, const std::vector<Bar>& bars) {
  std::vector<double> lengths;
  for (const Bar& bar : bars) lengths.push_back(distance(positions[bar.a], positions[bar.b]));
  return lengths;
}

std::size_t count_joints(const ArrayLike& bars, std::optional<std::int64_t> joint_count,
                         const std::optional<std::vector<Vec3>>& positions) {
  if (joint_count && *joint_count < 0)
    throw InputError("joint_count = " + std::to_string(*joint_count) + ": must be from 0");
  if (joint_count && positions && static_cast<std::uint64_t>(*joint_count) != positions->size())
    throw InputError("positions: " + std::to_string(positions->size()) + " for " +
                     std::to_string(*joint_count) + " joints");
  if (joint_count) return static_cast<std::size_t>(*joint_count);
  return positions ? positions->size() : joints_named_in(bars, "bars");
}

void make_framework(Framework* self, const ArrayLike& bars, const OptionalArray& rest_lengths,
                    std::optional<std::int64_t> joint_count, const OptionalArray& positions,
                    const OptionalArray& masses, const OptionalArray& pinned,
                    std::optional<std::vector<std::string>> names, const Structure* structure,
                    bool planar, const nb::object& limits, const Sterics* sterics,
                    const TorsionPreferences* torsion_preferences) {
  std::optional<std::vector<Vec3>> start;
  if (positions) start = positions_from(*positions);
  FrameworkParts parts;
  parts.joint_count = count_joints(bars, joint_count, start);
  parts.bars = pairs_from(bars, "bars", parts.joint_count);
  if (rest_lengths) {
    parts.rest_lengths = reals_from(*rest_lengths, "rest_lengths");
  } else if (start) {
    parts.rest_lengths = lengths_at(*start, parts.bars);
    parts.drawn = std::move(*start);
  } else {
    throw nb::type_error("Framework: either rest_lengths or positions must be given");
  }
  if (masses) parts.masses = reals_from(*masses, "masses");
  if (pinned) parts.pinned = joints_from(*pinned, "pinned", parts.joint_count);
  if (names && structure) throw nb::type_error("Framework: give names or a structure, not both");
  if (names) parts.atoms = table_of_names(std::move(*names));
  if (structure) parts.atoms = std::make_shared<const AtomTable>(structure->atoms);
  parts.planar = planar;
  if (!limits.is_none()) parts.limits = limits_from(limits);
  if (sterics != nullptr) parts.sterics = std::make_shared<const Sterics>(*sterics);
  if (torsion_preferences != nullptr)
    parts.torsion_preferences = std::make_shared<const TorsionPreferences>(*torsion_preferences);
  const nb::gil_scoped_release no_gil;
  new (self) Framework(std::move(parts));
}

Array2<const std::uint32_t> bars_view(nb::handle_t<Framework> self) {
  static_assert(sizeof(Bar) == 2 * sizeof(std::uint32_t));
  const auto bars = nb::cast<const Framework&>(self).bars();
  return Array2<const std::uint32_t>(reinterpret_cast<const std::uint32_t*>(bars.data()),
                                     {bars.size(), 2}, self);
}

std::vector<Joint> pinned_joints(const Framework& framework) {
  std::vector<Joint> pinned;
  for (std::size_t i = 0; i < framework.joint_count(); ++i)
    if (framework.is_pinned(static_cast<Joint>(i))) pinned.push_back(static_cast<Joint>(i));
  return pinned;
}

std::string count_of(std::size_t count, const char* noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string framework_repr(const Framework& framework) {
  std::string text = "<pliant.Framework: " + count_of(framework.joint_count(), "joint") + ", " +
                     count_of(framework.bar_count(), "bar");
  if (framework.has_pinned_joints())
    text += ", " + std::to_string(framework.pinned_count()) + " pinned";
  return text + ">";
}

void bind_graph_facts(nb::module_& module) {
  nb::class_<GraphFacts>(module, "GraphFacts", "Properties of the graph of a framework.")
      .def_ro("joints", &GraphFacts::joints, "Number of joints.")
      .def_ro("bars", &GraphFacts::bars, "Number of bars.")
      .def_ro("components", &GraphFacts::components, "Number of connected components.")
      .def_ro("cycles", &GraphFacts::cycles,
              "Number of independent cycles: bars - joints + components.")
      .def_ro("bridges", &GraphFacts::bridges, "Number of bars that are on no cycle.")
      .def_ro("blocks", &GraphFacts::blocks,
              "Number of blocks of two or more bars: rings and ring systems.")
      .def_ro("largest_block", &GraphFacts::largest_block, "Number of bars in the largest block.")
      .def_ro("bars_in_blocks", &GraphFacts::bars_in_blocks, "Number of bars on some cycle.")
      .def_prop_ro("is_forest", &GraphFacts::is_forest, "True if there is no cycle.")
      .def("__repr__", [](const GraphFacts& facts) {
        return "<pliant.GraphFacts: " + count_of(facts.joints, "joint") + ", " +
               count_of(facts.bars, "bar") + ", " + count_of(facts.components, "component") + ", " +
               count_of(facts.cycles, "cycle") + ", " + count_of(facts.bridges, "bridge") + ", " +
               count_of(facts.blocks, "block") + ">";
      });
}

constexpr const char* framework_doc = R"(Joints connected by bars of fixed rest length; immutable.

Parameters
----------
bars : (B, 2) integers
    The two joints of each bar, from 0.
rest_lengths : (B,) Angstrom, optional
    Default: the distances at ``positions``.
joint_count : int, optional
    Default: the number of ``positions``, else one more than the largest joint in ``bars``.
positions : (N, 3) Angstrom, optional
    For ``joint_count`` and ``rest_lengths``. Where lengths come from them they are kept as the
    shape of rigid parts, handedness included.
masses : (N,) u, optional
    Default: 1 each.
pinned : joints or (N,) truth values, optional
    Joints that never move.
names : N strings, optional
    Names of the joints in messages.
structure : Structure, optional
    The structure whose atoms the joints are; it names them in messages and files.
planar : bool
    A planar framework: no push changes the z of a joint.
limits : sequence of (a, b, least, most[, kind[, energy[, group]]]), optional
    Pairs of joints whose distance is held to [least, most] Angstrom; ``most`` may be infinite. Kind:
    "given", "torsion" or that of a contact, such as "hydrogen_bond"; energy in kJ/mol, 0 if not
    known; limits of one group, from 0, stand for one contact.
sterics : Sterics, optional
    Least distances of joints that no bar joins.
torsion_preferences : TorsionPreferences, optional
    Usual torsions.

Raises
------
InputError
    A bar joins a joint to itself, names an unknown joint, has a length out of range (1e-150 to
    1e150), or is given twice with different lengths; shapes do not fit. Equal duplicates are merged.
    A limit joins a pair that has a bar, unknown joints, or has an empty interval.
TypeError
    An argument is no array of numbers (of integers, for ``bars``); a limit is no such row.
)";

void bind_framework_graph(nb::class_<Framework>& framework) {
  framework
      .def("graph_facts", &graph_facts, nb::call_guard<nb::gil_scoped_release>(),
           "Counts of components, independent cycles, bridges and blocks; linear in time.")
      .def(
          "components",
          [](const Framework& self) { return array_of(find_components(self).of_node); },
          "(N,) uint32: the connected component of each joint, numbered by their lowest joint.")
      .def(
          "blocks", [](const Framework& self) { return array_of(find_blocks(self).of_edge); },
          "(B,) uint32: the block (biconnected component) of each bar; a bridge is one alone.\n\n"
          "Hopcroft and Tarjan, Commun. ACM 16 (1973) 372.")
      .def(
          "bridges", [](const Framework& self) { return mask_of(find_blocks(self).is_bridge); },
          "(B,) bool: whether each bar is a bridge, that is on no cycle.");
}

void bind_limits_of_framework(nb::class_<Framework>& framework) {
  framework
      .def_prop_ro(
          "limits", [](const Framework& self) { return limits_to_python(self.limits()); },
          nb::sig("def limits(self) -> numpy.typing.NDArray[numpy.void]"),
          "(L,) structured array: a, b, least, most (Angstrom), kind, energy (kJ/mol),\n"
          "group (-1: none). ``Framework(limits=...)`` takes it.")
      .def_prop_ro(
          "has_sterics", [](const Framework& self) { return self.sterics() != nullptr; },
          "Whether there are least distances of joints.")
      .def_prop_ro(
          "sterics",
          [](const Framework& self) {
            return self.sterics() == nullptr ? std::nullopt : std::optional(*self.sterics());
          },
          "Least distances of joints: a copy; None if there are none.")
      .def_prop_ro(
          "torsion_preferences",
          [](const Framework& self) {
            const TorsionPreferences* const at = self.torsion_preferences();
            return at == nullptr ? std::nullopt : std::optional(*at);
          },
          "Usual torsions: a copy; None if there are none.");
}

void bind_framework_class(nb::module_& module) {
  nb::class_<Framework> framework(module, "Framework", framework_doc);
  framework
      .def("__init__", &make_framework, "bars"_a, "rest_lengths"_a = nb::none(),
           "joint_count"_a = nb::none(), nb::kw_only(), "positions"_a = nb::none(),
           "masses"_a = nb::none(), "pinned"_a = nb::none(), "names"_a = nb::none(),
           "structure"_a = nb::none(), "planar"_a = false, "limits"_a = nb::none(),
           "sterics"_a = nb::none(), "torsion_preferences"_a = nb::none())
      .def_prop_ro("joint_count", &Framework::joint_count, "Number N of joints.")
      .def_prop_ro("bar_count", &Framework::bar_count, "Number B of bars.")
      .def_prop_ro("bars", &bars_view, "(B, 2) uint32, read-only view: the joints of each bar.")
      .def_prop_ro(
          "rest_lengths",
          [](nb::handle_t<Framework> self) {
            return const_view_of(nb::cast<const Framework&>(self).rest_lengths(), self);
          },
          "(B,) float64, read-only view: rest lengths in Angstrom.")
      .def_prop_ro(
          "inverse_masses",
          [](nb::handle_t<Framework> self) {
            return const_view_of(nb::cast<const Framework&>(self).inverse_masses(), self);
          },
          "(N,) float64, read-only view: 1/u, 0 for a pinned joint.")
      .def_prop_ro(
          "pinned", [](const Framework& self) { return array_of(pinned_joints(self)); },
          nb::rv_policy::reference, "uint32 indices of the joints that never move, ascending.")
      .def_prop_ro("is_planar", &Framework::is_planar, "Whether no push changes the z of a joint.")
      .def_prop_ro("merged_bar_count", &Framework::merged_bar_count,
                   "How many bars were given twice and merged.")
      .def(
          "label",
          [](const Framework& self, std::int64_t joint) {
            return self.label(joint_at(self, joint));
          },
          "joint"_a, "Name of a joint in messages: \"A:LYS12:CA\", or \"joint 7\".")
      .def(
          "bar_label",
          [](const Framework& self, std::int64_t bar) { return self.label(bar_at(self, bar)); },
          "bar"_a, "Name of a bar in messages: \"CA - CB\".")
      .def("__repr__", &framework_repr);
  bind_limits_of_framework(framework);
  bind_framework_graph(framework);
  bind_pickling(framework);
}

void set_positions(std::vector<Vec3>& to, const ArrayLike& values) {
  const std::vector<Vec3> from = positions_from(values, to.size());
  std::copy(from.begin(), from.end(), to.begin());  // in place: views stay views
}

std::vector<std::uint8_t> switches_from(const ArrayLike& values) {
  const std::vector<std::int64_t> truths = truths_from(values, "limits_off");
  return {truths.begin(), truths.end()};
}

void bind_state(nb::module_& module) {
  nb::class_<State> state(
      module, "State",
      "What changes during a run: positions, and those of one step earlier.\n\n"
      "Both (N, 3) arrays are writeable views of the memory that runs work on. While a run\n"
      "goes on in another thread their contents change; their number never does.");
  state
      .def(
          "__init__",
          [](State* self, const ArrayLike& positions) {
            new (self) State(positions_from(positions));
          },
          "positions"_a, "Starts at rest from a copy of ``positions``, (N, 3) Angstrom.")
      .def_prop_rw(
          "positions",
          [](nb::handle_t<State> self) { return view_of(nb::cast<State&>(self).positions, self); },
          [](State& self, const ArrayLike& values) { set_positions(self.positions, values); },
          "(N, 3) float64 view, Angstrom. Assigning copies into the same memory.")
      .def_prop_rw(
          "previous",
          [](nb::handle_t<State> self) { return view_of(nb::cast<State&>(self).previous, self); },
          [](State& self, const ArrayLike& values) { set_positions(self.previous, values); },
          "(N, 3) float64 view, Angstrom: positions one step earlier, for Verlet.")
      .def_prop_rw(
          "limits_off",
          [](const State& self) -> nb::object {
            return nb::cast(mask_of({self.limits_off.begin(), self.limits_off.end()}));
          },
          [](State& self, const ArrayLike& values) { self.limits_off = switches_from(values); },
          "(L,) bool, a copy: limits that are off from the next step on; empty: all are on.")
      .def_rw("step", &State::step, "Steps done.")
      .def_rw("time", &State::time, "Time in ps.")
      .def("__repr__", [](const State& self) {
        return "<pliant.State: " + count_of(self.positions.size(), "joint") + ", step " +
               std::to_string(self.step) + ">";
      });
  bind_pickling(state);
}

}  // namespace

void bind_framework(nb::module_& module) {
  bind_graph_facts(module);
  bind_sterics(module);
  bind_torsion_preferences(module);
  bind_framework_class(module);
  bind_state(module);
  bind_residual(module);
  bind_frame(module);
  bind_examples(module);
}

}  // namespace pliant::python
