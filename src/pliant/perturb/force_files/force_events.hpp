// SPDX-License-Identifier: MIT
// Force files with events: what a person did with a framework, to be replayed bit by bit. A step
// may have any number of forces; joints may be held, and settings changed.
//
//   pliant-forces 3          # then the header, see force_header.hpp
//   set technique blocks     # an option of `pliant run`, from the next step on
//   start                    # the start is made whole under the settings above, not the usual ones
//   hold_back 0.2            # from here on no force moves its joint further in a step (Angstrom)
//   pin C1 C7                # these joints are held from the next step on, and no others
//   cut C1 C2                # what joins them goes: a bar, or a contact with all of its limits
//   bar C1 C7 2.5            # they are joined by a bar of this length (Angstrom)
//   restore C1 C2            # what joined them at the start is back, and nothing else
//   force C4 12.5 -3 0.25    # joint, force (x, y, z) in kJ/(mol Angstrom)
//   step 350                 # so many steps under the forces above; there may be none
//   wander 10                # so many steps of the pusher that `set perturb` names, and then of
//                            # the forces above
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pliant/framework/edits.hpp"
#include "pliant/perturb/force_files/force_header.hpp"
#include "pliant/perturb/push.hpp"

namespace pliant {

/// Name and value of an option of a run; checked when it is used.
struct SetOption {
  std::string name, value;
  friend bool operator==(const SetOption&, const SetOption&) = default;
};
/// All joints that are held.
struct PinJoints {
  std::vector<Joint> joints;
};
/// Steps under forces.
struct PullStep {
  std::vector<JointForce> forces;
  std::int64_t count = 1;  ///< from 1
};
/// Steps of a random pusher.
struct WanderSteps {
  std::int64_t count = 1;               ///< from 1
  std::vector<JointForce> forces = {};  ///< act after the pusher
};
/// How far a force may move its joint in a step, from this event on.
struct HoldBack {
  double longest_step;  ///< Angstrom, above 0
};
/// Makes the start whole. At most once, before the first step; without it this happens before all
/// events, under the usual settings.
struct StartWalk {};

struct ForceEvent {
  std::variant<SetOption, PinJoints, PullStep, WanderSteps, HoldBack, StartWalk, FrameworkEdit>
      what;
  std::size_t line = 0;  ///< line of the file, from 1; 0 if not from a file
};

/// Throws InputError naming file, line and what was expected.
std::vector<ForceEvent> parse_force_events(std::string_view text, std::string_view file_name,
                                           const Framework& framework);

/// The text that parse_force_events reads back to the same bits. Throws InputError as
/// write_force_file does.
std::string write_force_events(std::span<const ForceEvent> events, const Framework& framework,
                               const ForceHeader& header = {});

/// Adds a step under these forces, or of the random pusher and these forces. A step with the same
/// bits as the last one only increases its count.
void add_pull(std::vector<ForceEvent>& events, std::span<const JointForce> forces);
void add_wander(std::vector<ForceEvent>& events, std::span<const JointForce> forces = {});

/// Number of steps in the events.
std::int64_t steps_of(std::span<const ForceEvent> events);

/// The edits among the events, for files of frames: "after step 12: cut 3 - 7; after step 20: ...".
std::string edits_text(std::span<const ForceEvent> events, const Framework& framework);

}  // namespace pliant
