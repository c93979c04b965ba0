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
  bool has_weighting = true;  ///< Technique::weighting means something
  bool knows_limits = false;  ///< resolves frameworks that have limits or sterics
  /// Makes what resolves; all three outlive it.
  std::unique_ptr<Method> (*make)(const Framework& framework, const Technique& technique,
                                  const ResolveOptions& options) = nullptr;
  /// Makes what resolves eight walkers at once, or none for such a framework. Null: no such way.
  std::unique_ptr<LaneMethod> (*make_lanes)(const LaneSetting& setting) = nullptr;
  /// Goes outward and carries along what hangs on a joint: if asked to weight by mass, each
  /// component is shifted afterwards so that its centre of mass stays.
  bool carries = false;
  /// Sweeps from bar to bar, which does not converge in the sweeps of a run, or slowly, where bars
  /// form rigid units (forms_rigid_units).
  bool bar_by_bar = false;
};

/// Whether a technique is the right one for a framework, as far as the table and the bars tell.
enum class Fit : std::uint8_t {
  fits,
  doubtful,  ///< may be tried, but is known not to converge on such a framework
  refused,   ///< cannot resolve it: check() throws
};
inline constexpr std::array<std::string_view, 3> fit_names{"fits", "doubtful", "refused"};

struct TechniqueFit {
  Fit fit = Fit::fits;
  std::string why;  ///< and what to use instead, as one message; "" where it fits
};

std::span<const TechniqueEntry> techniques();

/// The row of that name. Throws OptionError listing the known names.
const TechniqueEntry& find_technique(std::string_view name);

/// The row of this technique. Of one that has a sweep of its own (`custom`): a row that is not in
/// techniques(). Throws OptionError as find_technique does.
const TechniqueEntry& entry_of(const Technique& technique);

/// Whether components are shifted after each resolve by this technique, which is not `auto`.
bool shifts_to_mass_centre(const Technique& technique);

/// Throws OptionError if the technique is unknown, the weighting is not in [0, 1], an ordering goes
/// with another technique than `input`, or a sweep with another than `custom`.
void check(const Technique& technique);

/// What is to be expected of a known technique before anything is resolved. Linear.
TechniqueFit fit_of(const Technique& technique, const Framework& framework);

/// Warns of a technique that is doubtful for this framework.
void warn_if_doubtful(const Technique& technique, const Framework& framework, const Log& log);

/// Throws OptionError if the technique is refused: it leaves bars of this framework out, or does
/// not support limits where it has some; or if its ordering is none of this framework.
void check(const Technique& technique, const Framework& framework);

}  // namespace pliant
