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

/// Resolves again and again with one technique on one framework, without allocating after the
/// first call. Holds the plan of the last root joint. Not for two threads at once.
class Resolver {
 public:
  /// The framework must outlive the resolver.
  /// Throws OptionError if the technique or an option is out of range or leaves bars out.
  Resolver(const Framework& framework, const Technique& technique,
           const ResolveOptions& options = {});
  ~Resolver();
  Resolver(Resolver&&) noexcept;

  /// Moves `positions` (N, Angstrom) until all bars are within the tolerance or a limit is met.
  /// If a length stops being finite they are put back as they were.
  ///
  /// `disturbed` says what may be broken; its root is where orderings begin. Where it lists joints,
  /// nothing else has moved since all bars were whole: `blocks` then looks only at what these
  /// reach, at a cost that does not depend on the size of the framework, and other techniques do as
  /// ever. The summary's residuals are then those of the bars at the joints listed and at moved(),
  /// and rms_residual is -1.
  ///
  /// `step` is the step number that random draws depend on. `reference` (N, or none, Angstrom) are
  /// whole positions before the push, in which `shake` looks for the directions of the bars; other
  /// techniques do not look at it.
  /// Throws OptionError if the number of positions is wrong or a joint does not exist.
  ResolveSummary resolve(std::span<Vec3> positions, const Disturbed& disturbed,
                         std::int64_t step = 0, std::span<const Vec3> reference = {});

  /// The same where any joint may have moved; `root` is the pushed one.
  ResolveSummary resolve(std::span<Vec3> positions, Joint root = 0, std::int64_t step = 0,
                         std::span<const Vec3> reference = {}) {
    return resolve(positions, Disturbed{root}, step, reference);
  }

  /// The same where nothing but `root` has moved since all bars were whole.
  ResolveSummary resolve_near(std::span<Vec3> positions, Joint root, std::int64_t step = 0,
                              std::span<const Vec3> reference = {}) {
    return resolve(positions, Disturbed{root, false, {&root, 1}}, step, reference);
  }

  /// Random draws are this walker's from now on (ResolveOptions::walker).
  void set_walker(std::uint64_t walker);
  /// Limits that are off from now on: (L) 1 for off, or empty for none (State::limits_off).
  /// Throws OptionError if there are as many neither as limits nor none.
  void set_limits_off(std::span<const std::uint8_t> off);
  /// Throws what resolve() throws for such arguments.
  void check_arguments(std::span<const Vec3> positions, const Disturbed& disturbed,
                       std::span<const Vec3> reference) const;

  /// The joints, apart from those disturbed, that the last resolve moved; a disturbed joint may be
  /// among them. Nothing if any joint may have moved.
  std::optional<std::span<const Joint>> moved() const;

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

/// Resolves once: Resolver(framework, technique, options).resolve(positions, root).
ResolveSummary resolve(const Framework& framework, const Technique& technique,
                       std::span<Vec3> positions, const ResolveOptions& options = {},
                       Joint root = 0);

}  // namespace pliant
