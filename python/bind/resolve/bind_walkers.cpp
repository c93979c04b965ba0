// SPDX-License-Identifier: MIT
// Resolving many walkers at once, in place on numpy memory.
#include "pliant/resolve/walkers.hpp"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <mutex>

#include "arrays.hpp"
#include "checks.hpp"
#include "collected.hpp"
#include "interrupt.hpp"
#include "options.hpp"
#include "pliant/base/error.hpp"

namespace pliant::python {
namespace {

Measured measured_from(const std::string& name) {
  if (name == "nothing") return Measured::nothing;
  if (name == "max_residual") return Measured::max_residual;
  if (name == "rms_residual") return Measured::rms_residual;
  throw OptionError("measured = " + name + ": must be nothing, max_residual or rms_residual");
}

/// A WalkerResolver that several Python threads may share: one after another.
class SharedWalkerResolver {
 public:
  SharedWalkerResolver(const Framework& framework, const ResolveArguments& arguments, bool lanes,
                       const std::string& level)
      : SharedWalkerResolver(framework, arguments.chosen(framework), arguments.options(),
                             {lanes, level}) {}

  int traverse(visitproc visit, void* argument) const {
    return callable_.traverse(visit, argument);
  }
  void clear() { callable_.clear(); }

  /// Makes the lanes' plans if need be, so that another thread's resolve is waited for.
  std::string level() {
    const nb::gil_scoped_release no_gil;
    const std::lock_guard one_at_a_time(mutex_);
    return std::string(resolver_.level());
  }

  /// Needs the GIL, which it gives up while it works.
  std::vector<ResolveSummary> resolve(const PositionsInPlace& positions, std::int64_t root,
                                      std::int64_t step, std::uint64_t first_walker,
                                      const OptionalArray& reference, const std::string& measured) {
    const Measured wanted = measured_from(measured);
    const ConformersLease lease(positions);
    std::vector<Vec3> before;
    if (reference) before = positions_from(*reference, "reference");
    const Joint root_joint = root_at(framework_, root);
    std::vector<WalkerPositions> walkers;
    for (std::size_t k = 0; k < lease.count(); ++k)
      walkers.push_back({first_walker + k, lease.at(k), before});
    std::vector<ResolveSummary> summaries(walkers.size());
    std::exception_ptr raised;
    {
      const nb::gil_scoped_release no_gil;
      const std::lock_guard one_at_a_time(mutex_);
      watch_ = InterruptWatch();
      resolver_.resolve(walkers, summaries, root_joint, step, wanted);
      raised = watch_.raised();
    }
    if (raised) std::rethrow_exception(raised);
    return summaries;
  }

 private:
  SharedWalkerResolver(const Framework& framework, const Technique& technique,
                       ResolveOptions options, const LaneOptions& lanes)
      : framework_(framework),
        callable_(technique),
        resolver_(framework, technique, watched(std::move(options)), lanes) {}

  ResolveOptions watched(ResolveOptions options) {
    options.should_stop = [this] { return watch_(); };
    return options;
  }

  const Framework& framework_;
  CallableOf callable_;
  InterruptWatch watch_;
  std::mutex mutex_;
  WalkerResolver resolver_;
};

void make_walker_resolver(SharedWalkerResolver* self, const Framework& framework,
                          const TechniqueLike& technique, double weighting, bool mass_weighted,
                          double tolerance, std::optional<double> tolerance_length,
                          double tolerance_limit, double tolerance_overlap, std::int64_t max_sweeps,
                          std::uint64_t seed, const std::optional<OrderingColumns>& ordering,
                          bool lanes, const std::string& level) {
  new (self)
      SharedWalkerResolver(framework,
                           {technique, weighting, mass_weighted, tolerance, tolerance_length,
                            tolerance_limit, tolerance_overlap, max_sweeps, seed, 0, ordering},
                           lanes, level);
}

constexpr const char* class_doc =
    R"(Resolves many walkers (independent copies of one framework) at once.

Groups of eight go through SIMD registers side by side (lanes) where the technique supports it:
sweeps of one ordering for all, ``blocks``, ``newton``, ``shake``. Each walker ends with the same
bits as alone in a ``Resolver``, whoever stands beside it and whatever the processor.

Parameters are those of ``resolve``, and:

lanes : bool
    If false, one walker after the other is resolved.
level : str
    Level of instructions to use, a name in ``lane_levels()``; by default the best.
)";

constexpr const char* resolve_walkers_doc =
    R"(Moves all ``positions`` in place, as the function ``resolve`` does those of one walker.

Parameters
----------
positions : (K, N, 3) float64, Angstrom
    C-contiguous and writeable; changed in place.
root, step : int
    As for ``resolve``, for all walkers.
first_walker : int
    Number of the first walker; the others follow. Random draws depend on it.
reference : (N, 3) array-like, optional
    As for ``resolve``, for all walkers.
measured : {"nothing", "max_residual", "rms_residual"}
    Which residuals the summaries hold: neither (both are -1), ``max_residual`` alone, or both.
    Whether all bars are whole is checked in any case.

Returns
-------
list of ResolveSummary
    One for each walker; ``seconds`` is its share.
)";

}  // namespace

void bind_walkers(nb::module_& module) {
  const Technique technique;
  const ResolveOptions options;
  module.def(
      "lane_levels",
      [] {
        const auto names = lane_level_names();
        return std::vector<std::string>(names.begin(), names.end());
      },
      "Instructions that this build and this processor have for walkers in lanes, the best first:\n"
      "\"v4\" (x86-64-v4, AVX-512), \"v3\" (AVX2), \"v2\" (SSE4.2), \"portable\".");
  nb::class_<SharedWalkerResolver>(module, "WalkerResolver", class_doc,
                                   nb::type_slots(Collected<SharedWalkerResolver>::slots))
      .def("__init__", &make_walker_resolver, nb::keep_alive<1, 2>(), "framework"_a,
           "technique"_a = technique.name, "weighting"_a = technique.weighting, nb::kw_only(),
           "mass_weighted"_a = technique.mass_weighted, "tolerance"_a = options.tolerance.relative,
           "tolerance_length"_a = nb::none(), "tolerance_limit"_a = options.tolerance.limit,
           "tolerance_overlap"_a = options.tolerance.overlap, "max_sweeps"_a = options.max_sweeps,
           "seed"_a = options.seed, "ordering"_a = nb::none(), "lanes"_a = true, "level"_a = "")
      .def_prop_ro("level", &SharedWalkerResolver::level,
                   "The instructions in use; empty if walkers go one after the other.")
      .def("resolve", &SharedWalkerResolver::resolve, "positions"_a, "root"_a = 0, nb::kw_only(),
           "step"_a = 0, "first_walker"_a = 0, "reference"_a = nb::none(),
           "measured"_a = "max_residual", resolve_walkers_doc);
}

}  // namespace pliant::python
