// SPDX-License-Identifier: MIT
// Residuals: how far bars, limits and sterics are from what they ask for.
#include "pliant/framework/measures/residual.hpp"

#include "arrays.hpp"
#include "framework/limits.hpp"
#include "options.hpp"

namespace pliant::python {
namespace {

constexpr const char* measure_doc =
    R"(Measures all bars, limits and overlaps at ``positions``.

Parameters
----------
framework : Framework
positions : (N, 3) Angstrom
    They need not be finite.
tolerance, tolerance_length, tolerance_limit, tolerance_overlap
    As for ``resolve``: what ``within`` means.

Returns
-------
ResidualSummary
)";

void bind_summary(nb::module_& module) {
  nb::class_<ResidualSummary> summary(module, "ResidualSummary",
                                      "How far a framework is from its rest lengths, its limits "
                                      "and its sterics.");
  summary.def_ro("max_relative", &ResidualSummary::max_relative, "Largest |length - rest| / rest.")
      .def_ro("rms_relative", &ResidualSummary::rms_relative,
              "Root mean square of |length - rest| / rest.")
      .def_ro("max_length", &ResidualSummary::max_length, "Largest |length - rest| in Angstrom.")
      .def_ro("worst_bar", &ResidualSummary::worst_bar, "The bar of max_relative.")
      .def_ro("within", &ResidualSummary::within, "Everything is within the tolerance.")
      .def_ro("finite", &ResidualSummary::finite, "Every length is a finite number.");
  bind_violations<ResidualSummary>(summary);
}

void bind_measure(nb::module_& module) {
  const Tolerance usual;
  module.def(
      "measure_bars",
      [](const Framework& framework, const ArrayLike& positions, double tolerance,
         std::optional<double> tolerance_length, double tolerance_limit, double tolerance_overlap) {
        const std::vector<Vec3> points = positions_from(positions, framework.joint_count());
        const Tolerance within{tolerance, tolerance_length.value_or(0.0), tolerance_limit,
                               tolerance_overlap};
        const nb::gil_scoped_release no_gil;
        return measure(framework, points, within);
      },
      "framework"_a, "positions"_a, nb::kw_only(), "tolerance"_a = usual.relative,
      "tolerance_length"_a = nb::none(), "tolerance_limit"_a = usual.limit,
      "tolerance_overlap"_a = usual.overlap, measure_doc);
}

}  // namespace

void bind_residual(nb::module_& module) {
  bind_summary(module);
  bind_measure(module);
  module.def(
      "residuals",
      [](const Framework& framework, const ArrayLike& positions) {
        const std::vector<Vec3> points = positions_from(positions, framework.joint_count());
        std::vector<double> residuals;
        for (std::size_t k = 0; k < framework.bar_count(); ++k) {
          const Bar bar = framework.bars()[k];
          residuals.push_back(residual(points[bar.a], points[bar.b], framework.rest_lengths()[k]));
        }
        return array_of(std::move(residuals));
      },
      "framework"_a, "positions"_a,
      "(B,) float64: length - rest of each bar at ``positions``, (N, 3); both in Angstrom.");
}

}  // namespace pliant::python
