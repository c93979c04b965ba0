// SPDX-License-Identifier: MIT
#include "pliant/path/meeting.hpp"

#include <array>
#include <charconv>

namespace pliant {
namespace {

/// "0.49"
std::string two_decimals(double value) {
  std::array<char, 64> text;
  const auto written =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 2);
  return {text.data(), written.ptr};
}

}  // namespace

Meeting::Meeting(const PathEnds& ends, PathWalker& walker, Way& way, const PathOptions& options)
    : ends_(ends),
      step_(options.step),
      other_walker_(*ends.end, options.should_stop),
      other_way_{{other_walker_.now()}, {way.left[0]}, {}, 0.0},
      ours_{walker, way, way.left[0], {step_, way.left[0]}},
      theirs_{other_walker_, other_way_, way.left[0], {step_, way.left[0]}} {}

bool Meeting::advance() {
  if (turns_ >= most_path_steps || (ours_.waits && theirs_.waits)) return false;
  const bool is_ours = turns_ % 2 == 0;
  Traveller& here = is_ours ? ours_ : theirs_;
  const PathWalker& there = (is_ours ? theirs_ : ours_).walker;
  if (here.walker.apart(there.asked()) <= path_near) return false;
  if (here.waits || go(here, there)) ++turns_;
  return true;
}

/// A step; false if it was stopped.
bool Meeting::go(Traveller& here, const PathWalker& there) {
  const std::vector<Vec3> goal = there.asked();
  const double before = here.walker.apart(goal);
  const StepEnd end = here.walker.whole_step(goal, step_);
  if (end == StepEnd::stopped) return false;
  if (end == StepEnd::not_whole) {
    here.waits = true;
    return true;
  }
  here.left -= before - here.walker.apart(goal);
  here.way.add(here.walker.now(), here.walker.apart(ends_.goal));
  here.waits = here.patience.is_over(here.left);
  return true;
}

std::vector<std::vector<Vec3>> Meeting::goals() const {
  std::vector<std::vector<Vec3>> goals;
  for (auto place = other_way_.places.rbegin(); place != other_way_.places.rend(); ++place)
    goals.push_back(asked_of(*ends_.end, (*place)->positions));
  return goals;
}

std::string Meeting::summary() const {
  const double apart = ours_.walker.apart(theirs_.walker.asked());
  return std::string("the two ends ") + (apart <= path_near ? "met, " : "did not meet, ") +
         two_decimals(apart) + " A apart, after " + std::to_string(ours_.way.places.size() - 1) +
         " steps of the start and " + std::to_string(theirs_.way.places.size() - 1) + " of the end";
}

}  // namespace pliant
