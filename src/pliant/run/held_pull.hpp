// SPDX-License-Identifier: MIT
// Why a pull does not get further: what carries it, found by its loads and tried by removal.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pliant/framework/measures/loads.hpp"
#include "pliant/run/steered_walk.hpp"

namespace pliant {

/// A hand that draws a joint towards a place, as the page's does: in each step by a share of the
/// way, at most so far.
struct HandPull {
  Joint joint = 0;
  Vec3 target;            ///< Angstrom
  double share = 0.8;     ///< of the way that is left, in a step
  double furthest = 0.6;  ///< Angstrom, in a step
};

/// The force by which move_by_verlet moves the joint so in the next step, against its velocity.
JointForce force_of(const HandPull& pull, const Framework& framework, const State& state,
                    const PerturbOptions& options);

/// A contact, a pair that presses, or a pin, and its share of the pull: 1 for all of it.
struct Holder {
  enum class Kind : std::uint8_t { limit, pressed, pin } kind = Kind::limit;
  Joint a = 0, b = 0;    ///< equal for a pin
  LimitIndex limit = 0;  ///< of SteeredWalk::framework(): the one with most load of its contact
  double load = 0.0;
  bool is_next = false;  ///< it holds as soon as the others are cut
};

/// A chain of bars that is as long as it can be.
struct TautChain {
  std::vector<Joint> joints;  ///< from the end that is pulled, two or more
  double reach = 0.0;         ///< its length as a share of the longest it can have
};

struct HeldPull {
  bool is_pinned = false;       ///< the joint itself
  std::vector<Holder> holders;  ///< by their load, the largest first
  double yields = 0.0;          ///< Loads::yields() of the joint
  std::optional<TautChain> taut;
  std::vector<BarIndex> loaded;  ///< bars that carry a tenth of the pull or more
  // What trial steps found; the walk itself does not move.
  bool is_tried = false;  ///< they all converged
  double as_it_is = 0.0;  ///< Angstrom that the joint still gets towards the target
  double without = 0.0;   ///< the same without all holders but the pressed pairs
  bool frees() const { return is_tried && without > as_it_is + least_gain; }
  static constexpr double least_gain = 0.02;  ///< Angstrom
};

struct HeldOptions {
  int steps = 24;            ///< of each trial
  double least_load = 0.05;  ///< share of the pull from which something counts as a holder
  int rounds = 4;            ///< of trials in which holders may be added
  double free_way = 0.5;     ///< Angstrom further than it gets as it is: free
};

/// Finds what holds a pull where `walk` is. What carries a share of it is cut in a trial; what
/// holds the joint there is added, too, where it is not yet free and cutting more brings it
/// further. Throws as SteeredWalk::pull().
HeldPull why_held(const SteeredWalk& walk, const HandPull& pull, const HeldOptions& options = {});

/// The cuts that take away the contacts among these.
std::vector<FrameworkEdit> cuts_of(std::span<const Holder> holders);

}  // namespace pliant
