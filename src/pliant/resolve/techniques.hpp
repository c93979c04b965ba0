// SPDX-License-Identifier: MIT
// The table of techniques: every ordering is a row, and every direct method.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "pliant/base/log.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/resolve/method/technique.hpp"

namespace pliant {

class Method;
class LaneMethod;
struct LaneSetting;
struct ResolveOptions;

/// One row of the table of techniques: every ordering is a row, and every direct method.
struct TechniqueEntry {
  std::string_view name;
  std::string_view summary;
  bool forests_only = false;  ///< leaves bars out that close a cycle
  bool has_weighting = true;  ///< Technique::weighting has an effect
  bool knows_limits = false;  ///< can resolve limits and sterics
  /// Makes the method; all three must outlive it.
  std::unique_ptr<Method> (*make)(const Framework& framework, const Technique& technique,
                                  const ResolveOptions& options) = nullptr;
  /// Makes the method for eight walkers at once, or none for this framework. Null: there is none.
  std::unique_ptr<LaneMethod> (*make_lanes)(const LaneSetting& setting) = nullptr;
  /// Goes outward and carries along what hangs on a joint. When weighted by mass, each component is
  /// shifted afterwards so that its centre of mass does not move.
  bool carries = false;
  /// Sweeps from bar to bar, which converges slowly, or not in the sweeps of a run, where bars form
  /// rigid units (forms_rigid_units).
  bool bar_by_bar = false;
};

/// Whether a technique suits a framework, by the table and the bars.
enum class Fit : std::uint8_t {
  fits,
  doubtful,  ///< allowed, but known not to converge on such a framework
  refused,   ///< cannot resolve it: check() throws
};
inline constexpr std::array<std::string_view, 3> fit_names{"fits", "doubtful", "refused"};

struct TechniqueFit {
  Fit fit = Fit::fits;
  std::string why;  ///< with what to use instead, as one message; "" if it fits
};

std::span<const TechniqueEntry> techniques();

/// The row of that name. Throws OptionError listing the known names.
const TechniqueEntry& find_technique(std::string_view name);

/// The row of this technique. With a custom sweep (`custom`) it is a row that is not in
/// techniques(). Throws OptionError as find_technique does.
const TechniqueEntry& entry_of(const Technique& technique);

/// Whether this technique, which is not `auto`, shifts components after each resolve.
bool shifts_to_mass_centre(const Technique& technique);

/// Throws OptionError if the technique is unknown, the weighting is not in [0, 1], there is an
/// ordering and the technique is not `input`, or a sweep and it is not `custom`.
void check(const Technique& technique);

/// Whether a known technique suits a framework, found before anything is resolved. Linear.
TechniqueFit fit_of(const Technique& technique, const Framework& framework);

/// Warns of a technique that is doubtful for this framework.
void warn_if_doubtful(const Technique& technique, const Framework& framework, const Log& log);

/// Throws OptionError if the technique is refused: it leaves out bars of this framework or does not
/// support its limits; or if its ordering does not belong to this framework.
void check(const Technique& technique, const Framework& framework);

}  // namespace pliant
