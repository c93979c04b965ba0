// SPDX-License-Identifier: MIT
#include "run/asked_run.hpp"

#include <nanobind/stl/filesystem.h>

#include <algorithm>
#include <filesystem>

#include "checks.hpp"
#include "option_fields.hpp"
#include "pliant/base/error.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/run/run.hpp"
#include "pliant/run/run_fields.hpp"
#include "refusals.hpp"
#include "resolve/orderings.hpp"
#include "resolve/techniques.hpp"
#include "run/pushes.hpp"

namespace pliant::python {
namespace {

constexpr const char* push_type =
    "collections.abc.Sequence[tuple[int, tuple[float, float, float]]]";
constexpr const char* ordering_type =
    "tuple[numpy.typing.ArrayLike, numpy.typing.ArrayLike, numpy.typing.ArrayLike]";
constexpr const char* technique_type =
    "str | collections.abc.Callable[[numpy.typing.NDArray[numpy.float64], int, Framework], None]";

constexpr const char* doc_of_objects =
    R"(replay : sequence of (joint, (x, y, z)), optional
    Forces in kJ/(mol Angstrom), one per step, in place of ``perturb``. The last ends the run.
ordering : (bar, near, is_tree), each (B,), optional
    Bars in the sequence of a sweep, as ``order`` gives them, for technique ``input``.
)";

void refuse_given_for_graph(const Job& job) {
  const BarsAsked &bars = job.molecule.bars, usual;
  for (const auto& field : bars_fields())
    if (option_text(field.place(places_of(bars))) != option_text(field.place(places_of(usual))))
      throw nb::type_error(
          ("run: " + std::string(field.name) + " is for a structure, or a file of one").c_str());
}

bool is_graph_file(nb::handle source) {
  const bool is_path = nb::isinstance<nb::str>(source) || nb::hasattr(source, "__fspath__");
  return is_path && nb::cast<std::filesystem::path>(source).extension() == ".xml";
}

/// A framework, and where it starts if it is that of a graph file.
AskedRun open_framework(nb::handle source, nb::object structure, const Job& job) {
  if (!job.molecule.input.select.empty())
    throw nb::type_error("run: select is for a structure, or a file of one");
  refuse_given_for_graph(job);
  if (nb::isinstance<Framework>(source))
    return {nb::borrow(source), std::move(structure), nb::none(), true};
  const nb::object read = nb::module_::import_("pliant._core").attr("read_graph_xml")(source);
  return {read.attr("framework"), std::move(structure), read.attr("positions"), true};
}

AskedRun open_structure(nb::handle source, nb::handle structure, Job& job) {
  if (!structure.is_none()) throw nb::type_error("run: structure is given twice");
  const BarsAsked& bars = job.molecule.bars;
  nb::object part = nb::module_::import_("pliant.trajectory.sources")
                        .attr("part_of")(source, job.molecule.input.select);
  nb::object framework = part.attr("framework")(bars_of(job.molecule), bars.pin);
  return {std::move(framework), std::move(part), nb::none(), false};
}

}  // namespace

std::string argument_texts_of_moves() {
  RunOptions usual;
  std::string text;
  for (const RunField& field : run_fields()) {
    const bool is_technique = field.name == "technique";
    text += is_technique ? std::string("technique: ") + technique_type + " = 'auto'"
                         : argument_text(field, field.place(usual));
    text += ", ";
  }
  return text + "replay: " + push_type + " | None = None, ordering: " + ordering_type +
         " | None = None";
}

std::string argument_docs_of_moves() {
  return argument_docs(run_fields(), RunOptions()) + doc_of_objects;
}

nb::object taken(nb::dict given, const char* name) {
  if (!given.contains(name)) return nb::none();
  nb::object value = given[name];
  nb::del(given[name]);
  return value;
}

void take_moves(nb::dict given, Job& job) {
  RunOptions& run = job.run;
  if (given.contains("technique")) choose(run.technique, TechniqueLike{taken(given, "technique")});
  take_values(run_fields(), given, run);
  if (const nb::object value = taken(given, "ordering"); !value.is_none())
    run.technique.ordering =
        technique_ordering(argument_as<OrderingColumns>("ordering", value, ordering_type));
  if (const nb::object value = taken(given, "replay"); !value.is_none()) {
    run.replay = pushes_from(argument_as<PythonPushes>("replay", value, push_type));
    if (run.replay.empty()) throw InputError("replay: holds no push");
  }
  check(run);
}

std::vector<nb::object> members_of(const char* name, nb::handle value) {
  if (!nb::hasattr(value, "__iter__"))
    refuse_argument(name, value, "collections.abc.Iterable", nb::none(), nb::none());
  std::vector<nb::object> members;
  for (nb::handle member : nb::borrow<nb::object>(value)) members.push_back(nb::borrow(member));
  return members;
}

const Structure* AskedRun::molecule() const {
  return structure.is_none() ? nullptr : &nb::cast<const Structure&>(structure);
}

AskedRun open_run(nb::handle source, nb::object state, nb::object structure, Job& job) {
  const bool is_framework = nb::isinstance<Framework>(source) || is_graph_file(source);
  AskedRun asked = is_framework ? open_framework(source, std::move(structure), job)
                                : open_structure(source, structure, job);
  if (!state.is_none()) asked.state = std::move(state);
  if (asked.state.is_none() && asked.molecule() != nullptr)
    asked.state = asked.structure.attr("positions");
  if (asked.state.is_none()) throw nb::type_error("run: a framework has no positions: give state");
  if (!nb::isinstance<State>(asked.state)) asked.state = nb::type<State>()(asked.state);
  if (const Structure* molecule = asked.molecule()) {
    job.molecule.input.file = molecule->source;
    job.molecule.input.frame = static_cast<std::int64_t>(molecule->model);
  }
  return asked;
}

}  // namespace pliant::python
