// SPDX-License-Identifier: MIT
// Resolving broken bars (constraint satisfaction; SHAKE-like nonlinear Gauss-Seidel): sweeps of a
// technique until every bar has its rest length within the tolerance.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "pliant/framework/disturbed.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/resolve/method/resolve_options.hpp"
#include "pliant/resolve/method/resolve_summary.hpp"
#include "pliant/resolve/method/technique.hpp"

namespace pliant {

/// Resolves repeatedly with one technique on one framework, without allocating after the first
/// call. Holds the plan of the last root joint. Not thread-safe.
class Resolver {
 public:
  /// The framework must outlive the resolver.
  /// Throws OptionError if the technique or an option is out of range or leaves bars out.
  Resolver(const Framework& framework, const Technique& technique,
           const ResolveOptions& options = {});
  ~Resolver();
  Resolver(Resolver&&) noexcept;

  /// Moves `positions` (N, Angstrom) until all bars are within the tolerance or a limit is reached.
  /// If a length stops being finite, the positions are restored.
  ///
  /// `disturbed` says what may be broken; its root is where orderings begin. Where it lists joints,
  /// nothing else has moved since all was whole: `blocks`, and with a reference `units` and
  /// `froda`, then look only at what these reach, at a cost that does not depend on the size of the
  /// framework; other techniques do as ever. The summary's residuals are then those of the bars at
  /// the joints listed and at moved(), and rms_residual is -1.
  ///
  /// Random draws depend on the step number `step`. `reference` (N, or none, Angstrom) are whole
  /// positions before the push, where `froda` and regions of units begin, and from which `shake`
  /// takes the directions of the bars. Throws OptionError if the number of positions is wrong or a
  /// joint does not exist.
  ResolveSummary resolve(std::span<Vec3> positions, const Disturbed& disturbed,
                         std::int64_t step = 0, std::span<const Vec3> reference = {});

  /// The same if any joint may have moved; `root` is the pushed one.
  ResolveSummary resolve(std::span<Vec3> positions, Joint root = 0, std::int64_t step = 0,
                         std::span<const Vec3> reference = {}) {
    return resolve(positions, Disturbed{root}, step, reference);
  }

  /// The same if only `root` has moved since all bars were whole.
  ResolveSummary resolve_near(std::span<Vec3> positions, Joint root, std::int64_t step = 0,
                              std::span<const Vec3> reference = {}) {
    return resolve(positions, Disturbed{root, false, {&root, 1}}, step, reference);
  }

  /// Sets the walker of later random draws (ResolveOptions::walker).
  void set_walker(std::uint64_t walker);
  /// Sets the limits that are off from now on: (L) 1 for off, or empty for none
  /// (State::limits_off). Throws OptionError if the number is neither that of the limits nor 0.
  void set_limits_off(std::span<const std::uint8_t> off);
  /// Throws what resolve() throws for such arguments.
  void check_arguments(std::span<const Vec3> positions, const Disturbed& disturbed,
                       std::span<const Vec3> reference) const;

  /// The joints that the last resolve moved, without those disturbed unless it moved them, too.
  /// Nothing if any joint may have moved.
  std::optional<std::span<const Joint>> moved() const;

 private:
  struct MethodPlan;
  std::unique_ptr<MethodPlan> plan_;
};

/// Resolves once: Resolver(framework, technique, options).resolve(positions, root).
ResolveSummary resolve(const Framework& framework, const Technique& technique,
                       std::span<Vec3> positions, const ResolveOptions& options = {},
                       Joint root = 0);

}  // namespace pliant
