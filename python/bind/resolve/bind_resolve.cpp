// SPDX-License-Identifier: MIT
// Resolving: techniques, resolve() in place on numpy memory, Resolver for repeated calls.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <mutex>

#include "arrays.hpp"
#include "checks.hpp"
#include "collected.hpp"
#include "framework/limits.hpp"
#include "interrupt.hpp"
#include "messages.hpp"
#include "options.hpp"
#include "pliant/resolve/auto.hpp"
#include "pliant/resolve/techniques.hpp"
#include "tables.hpp"

namespace pliant::python {
namespace {

/// A Resolver that several Python threads may share: one after another.
class SharedResolver {
 public:
  SharedResolver(const Framework& framework, const ResolveArguments& arguments)
      : SharedResolver(framework, arguments.chosen(framework), arguments.options()) {}

  ResolveSummary resolve(const PositionsInPlace& positions, std::int64_t root, std::int64_t step,
                         const OptionalArray& reference, const OptionalArray& disturbed) {
    std::vector<Joint> joints;
    if (disturbed) joints = joints_from(*disturbed, "disturbed", framework_.joint_count());
    return resolve_disturbed(positions, {root_at(framework_, root), !disturbed, joints}, step,
                             reference);
  }

  int traverse(visitproc visit, void* argument) const {
    return callable_.traverse(visit, argument);
  }
  void clear() { callable_.clear(); }

  /// None where it may have been any joints.
  std::optional<std::vector<Joint>> moved() {
    const nb::gil_scoped_release no_gil;
    const std::lock_guard one_at_a_time(mutex_);
    const auto moved = resolver_.moved();
    if (!moved) return std::nullopt;
    return std::vector<Joint>(moved->begin(), moved->end());
  }

 private:
  /// Needs the GIL, which it gives up while it works.
  ResolveSummary resolve_disturbed(const PositionsInPlace& positions, const Disturbed& disturbed,
                                   std::int64_t step, const OptionalArray& reference) {
    const PositionsLease lease(positions);
    std::vector<Vec3> before;
    if (reference) before = positions_from(*reference, "reference");
    ResolveSummary summary;
    std::exception_ptr raised;
    {
      const nb::gil_scoped_release no_gil;
      const std::lock_guard one_at_a_time(mutex_);
      watch_ = InterruptWatch();
      summary = resolver_.resolve(lease.span(), disturbed, step, before);
      raised = watch_.raised();
    }
    if (raised) std::rethrow_exception(raised);
    return summary;
  }

  SharedResolver(const Framework& framework, const Technique& technique, ResolveOptions options)
      : framework_(framework),
        callable_(technique),
        resolver_(framework, technique, watched(std::move(options))) {
    warn_if_doubtful(technique, framework, python_log());
  }

  ResolveOptions watched(ResolveOptions options) {
    options.should_stop = [this] { return watch_(); };
    return options;
  }

  const Framework& framework_;
  CallableOf callable_;
  InterruptWatch watch_;
  std::mutex mutex_;
  Resolver resolver_;
};

ResolveSummary resolve_once(const Framework& framework, const PositionsInPlace& positions,
                            const TechniqueLike& technique, double weighting, bool mass_weighted,
                            double tolerance, std::optional<double> tolerance_length,
                            double tolerance_limit, double tolerance_overlap,
                            std::int64_t max_sweeps, std::uint64_t seed, std::uint64_t walker,
                            std::int64_t root, std::int64_t step,
                            const std::optional<OrderingColumns>& ordering,
                            const OptionalArray& reference) {
  SharedResolver resolver(
      framework, {technique, weighting, mass_weighted, tolerance, tolerance_length, tolerance_limit,
                  tolerance_overlap, max_sweeps, seed, walker, ordering});
  return resolver.resolve(positions, root, step, reference, {});
}

void make_resolver(SharedResolver* self, const Framework& framework, const TechniqueLike& technique,
                   double weighting, bool mass_weighted, double tolerance,
                   std::optional<double> tolerance_length, double tolerance_limit,
                   double tolerance_overlap, std::int64_t max_sweeps, std::uint64_t seed,
                   std::uint64_t walker, const std::optional<OrderingColumns>& ordering) {
  new (self) SharedResolver(
      framework, {technique, weighting, mass_weighted, tolerance, tolerance_length, tolerance_limit,
                  tolerance_overlap, max_sweeps, seed, walker, ordering});
}

constexpr const char* resolve_doc =
    R"(Moves ``positions`` in place until every bar has its rest length within the tolerance.

Nonlinear Gauss-Seidel (SHAKE-like): sweeps of one-bar projections in the sequence of an ordering
(Jakobsen, "Advanced character physics", GDC 2001; thesis "Motion Simulation of Geometric Constraint
Structures"), or a direct method. If it does not converge it raises nothing: look at ``stop`` or
``converged`` of what is returned. Other Python threads run meanwhile; Ctrl-C ends the call after a
sweep.

Parameters
----------
framework : Framework
positions : (N, 3) float64, Angstrom
    C-contiguous and writeable; changed in place. If a length stops being finite, the positions are
    put back.
technique : str or callable
    A name in ``techniques()``, or a technique of your own: called with (positions, sweep,
    framework) it makes one sweep, moving ``positions``, (N, 3) float64 in Angstrom, in place;
    ``sweep`` counts from 0. It is called again until every bar is whole by Pliant's own measure,
    or ``max_sweeps``. Pinned joints stay, whatever it does. What it raises ends the call, with
    positions put back.
weighting : float
    Share of a correction that the far joint of a tree bar takes, 0 to 1; the near joint takes the
    rest. Bars that close a cycle are shared half and half.
mass_weighted : bool
    Multiply shares by inverse masses.
tolerance : float
    Largest |length - rest| / rest of a whole bar.
tolerance_length : float, optional
    Largest |length - rest| in Angstrom, in place of ``tolerance``.
tolerance_limit, tolerance_overlap : float
    How far outside its interval a limit's distance may be, and how much nearer than sterics allow
    two joints may be, both in Angstrom.
max_sweeps : int
    Give up after so many sweeps.
seed, walker : int
    Random orderings and the parting of coincident joints depend on it.
root : int
    The joint where the ordering begins.
step : int
    Random draws depend on it, too.
ordering : (bar, near, is_tree), each (B,), optional
    With technique "input" alone: visit the bars in this sequence, each once, as ``order`` and
    ``read_ordering_file`` give it.
reference : (N, 3) array-like, optional
    Whole positions before the push, Angstrom: ``shake`` moves joints along the bars as they are
    there, as SHAKE, LINCS and CCMA do in dynamics. Without it, along the broken bars.

Raises
------
TypeError
    ``positions`` is no such array, or ``technique`` neither a name nor to be called.
OptionError
    An option is out of range, the technique leaves bars of this framework out, the ordering is
    none of this framework, or ``reference`` has another number of joints.
IndexError
    ``root`` is no joint.
)";

constexpr const char* resolve_again_doc =
    R"(Moves ``positions`` in place, as the function ``resolve`` does.

Parameters
----------
positions : (N, 3) float64, Angstrom
    C-contiguous and writeable; changed in place.
root, step, reference
    As for the function ``resolve``.
disturbed : (K,) array-like of int, optional
    The joints that have moved since all bars were whole; no other has, and the root is looked at
    as if it were among them. ``blocks``, and ``auto`` where it takes ``blocks``, then look only at
    what these joints reach, at a cost that does not depend on the size of the framework; other
    techniques do as ever. Without it any joint may have moved.

Returns
-------
ResolveSummary
    Where only some bars were measured, ``max_residual`` is that of the bars at the joints in
    ``disturbed`` and ``moved``, and ``rms_residual`` is -1.

Raises
------
TypeError
    ``positions`` is no such array.
InputError
    ``disturbed`` holds what is no joint.
OptionError
    ``positions`` or ``reference`` have another number of joints.
IndexError
    ``root`` is no joint.
)";

void bind_summary(nb::module_& module) {
  nb::class_<ResolveSummary> summary(module, "ResolveSummary", "What a resolve did.");
  bind_violations<ResolveSummary>(summary);
  summary.def_ro("stop", &ResolveSummary::stop, "Why it ended.")
      .def_prop_ro("converged", &ResolveSummary::converged, "Every bar is within the tolerance.")
      .def_ro("sweeps", &ResolveSummary::sweeps, "Passes over the ordering in one direction.")
      .def_ro("projections", &ResolveSummary::projections,
              "Bars looked at, summed over the sweeps.")
      .def_ro("max_residual", &ResolveSummary::max_residual,
              "Largest |length - rest| / rest at the end.")
      .def_ro("rms_residual", &ResolveSummary::rms_residual, "Its root mean square at the end.")
      .def_ro("worst_bar", &ResolveSummary::worst_bar, "The bar of max_residual.")
      .def_ro("seconds", &ResolveSummary::seconds, "Wall time.")
      .def_ro("dropped_bars", &ResolveSummary::dropped_bars,
              "Direct methods: bars left out of the last equations as they depend on others.")
      .def_ro("finishing_sweeps", &ResolveSummary::finishing_sweeps,
              "Direct methods: sweeps, among ``sweeps``, that finished what the method could not.")
      .def_ro("off_nearest", &ResolveSummary::off_nearest,
              "``newton``: the largest move towards the nearest whole positions that was still "
              "asked for at the last look, in Angstrom; -1 for other techniques.")
      .def("brief", &ResolveSummary::brief, "framework"_a, "The summary as one line of text.")
      .def("__repr__", [](const ResolveSummary& self) {
        return "<pliant.ResolveSummary: " + std::string(name(self.stop)) + ", " +
               std::to_string(self.sweeps) + " sweeps>";
      });
}

void bind_techniques(nb::module_& module) {
  bind_row<TechniqueEntry>(module, "TechniqueEntry",
                           "One row of the table of techniques: every ordering is one.")
      .def_ro("forests_only", &TechniqueEntry::forests_only,
              "Leaves bars out that close a cycle, so that only forests are resolved by it.")
      .def_ro("has_weighting", &TechniqueEntry::has_weighting, "``weighting`` has an effect.");
  module.def(
      "techniques", [] { return rows_of(techniques()); }, nb::rv_policy::reference,
      "The table of techniques: orderings and direct methods.");
  module.def(
      "techniques_for",
      [](const Framework& framework) {
        std::vector<std::tuple<std::string, std::string, std::string>> rows;
        for (const TechniqueEntry& row : techniques()) {
          const TechniqueFit found = fit_of({std::string(row.name)}, framework);
          rows.emplace_back(row.name, fit_names[static_cast<std::size_t>(found.fit)], found.why);
        }
        return rows;
      },
      "framework"_a,
      "Whether each technique suits this framework, found before anything is resolved:\n"
      "its name; \"fits\", \"doubtful\" (may be tried, but is known not to converge on such bars, "
      "or\nslowly) or \"refused\"; and why, with what to use instead (\"\" where it fits).");
  module.def(
      "choose_technique",
      [](const Framework& framework, bool mass_weighted) {
        Technique asked;
        asked.mass_weighted = mass_weighted;
        const Choice choice = choose_technique(framework, asked);
        return std::pair(choice.technique.name, choice.why);
      },
      "framework"_a, nb::kw_only(), "mass_weighted"_a = false,
      "The technique that \"auto\" chooses for this framework, and why. It depends on what the\n"
      "bars form (rings, triangles, hubs, pinned joints), never by positions or measured time.");
}

void bind_resolver(nb::module_& module) {
  const Technique technique;
  const ResolveOptions options;
  nb::class_<SharedResolver>(module, "Resolver",
                             "Resolves again and again with one technique on one framework.\n\n"
                             "Keeps its plan and memory between calls. Threads that share one wait "
                             "for each other. Parameters are those of ``resolve``.",
                             nb::type_slots(Collected<SharedResolver>::slots))
      .def("__init__", &make_resolver, nb::keep_alive<1, 2>(), "framework"_a,
           "technique"_a = technique.name, "weighting"_a = technique.weighting, nb::kw_only(),
           "mass_weighted"_a = technique.mass_weighted, "tolerance"_a = options.tolerance.relative,
           "tolerance_length"_a = nb::none(), "tolerance_limit"_a = options.tolerance.limit,
           "tolerance_overlap"_a = options.tolerance.overlap, "max_sweeps"_a = options.max_sweeps,
           "seed"_a = options.seed, "walker"_a = options.walker, "ordering"_a = nb::none())
      .def("resolve", &SharedResolver::resolve, "positions"_a, "root"_a = 0, nb::kw_only(),
           "step"_a = 0, "reference"_a = nb::none(), "disturbed"_a = nb::none(), resolve_again_doc)
      .def_prop_ro(
          "moved", &SharedResolver::moved,
          "The joints that the last resolve moved, in the order in which they moved first;\n"
          "those disturbed may or may not be among them. None where it may have been any.");
  module.def("resolve", &resolve_once, "framework"_a, "positions"_a, "technique"_a = technique.name,
             "weighting"_a = technique.weighting, nb::kw_only(),
             "mass_weighted"_a = technique.mass_weighted,
             "tolerance"_a = options.tolerance.relative, "tolerance_length"_a = nb::none(),
             "tolerance_limit"_a = options.tolerance.limit,
             "tolerance_overlap"_a = options.tolerance.overlap, "max_sweeps"_a = options.max_sweeps,
             "seed"_a = options.seed, "walker"_a = options.walker, "root"_a = 0, "step"_a = 0,
             "ordering"_a = nb::none(), "reference"_a = nb::none(), resolve_doc);
}

}  // namespace

void bind_resolve(nb::module_& module) {
  bind_summary(module);
  bind_techniques(module);
  bind_resolver(module);
}

}  // namespace pliant::python
