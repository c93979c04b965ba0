// SPDX-License-Identifier: MIT
// Force files with events (version 2): what a person did with a framework, to be repeated bit by
// bit. Any number of forces in a step, joints that are held, settings that change.
//
//   pliant-forces 2
//   set technique blocks     # an option of `pliant run`, from the next step on
//   pin C1 C7                # these joints are held from the next step on, and no others
//   force C4 12.5 -3 0.25    # joint, force (x, y, z) in kJ/(mol Angstrom), in the next step
//   step                     # a step under the forces above; there may be none
//   wander 10                # so many steps of the pusher that `set perturb` names
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pliant/perturb/push.hpp"

namespace pliant {

/// Name and value of an option of a run; checked where it is used.
struct SetOption {
  std::string name, value;
  friend bool operator==(const SetOption&, const SetOption&) = default;
};
/// All joints that are held.
struct PinJoints {
  std::vector<Joint> joints;
};
/// One step under forces.
struct PullStep {
  std::vector<JointForce> forces;
};
/// Steps of a random pusher.
struct WanderSteps {
  std::int64_t count = 1;  ///< from 1
};

struct ForceEvent {
  std::variant<SetOption, PinJoints, PullStep, WanderSteps> what;
  std::size_t line = 0;  ///< of the file, from 1; 0: of none
};

/// Whether a text says to be of version 2 in its first line that is not empty.
bool has_force_events(std::string_view text);

/// Throws InputError naming file, line and what was expected.
std::vector<ForceEvent> parse_force_events(std::string_view text, std::string_view file_name,
                                           const Framework& framework);

/// The text that parse_force_events reads back to the same bits. Throws InputError as
/// write_force_file does.
std::string write_force_events(std::span<const ForceEvent> events, const Framework& framework);

/// How many steps the events are.
std::int64_t steps_of(std::span<const ForceEvent> events);

}  // namespace pliant
