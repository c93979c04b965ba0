// SPDX-License-Identifier: MIT
#include "pliant/path/path.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "pliant/path/detour.hpp"
#include "pliant/path/meeting.hpp"
#include "pliant/path/turn_ways.hpp"

namespace pliant {
namespace {

// Angstrom; what is left where turns have come so near is no matter of the way round
constexpr double turned_near = 1.0;
constexpr double timestep = 0.01;  // ps a step, as files of Motion have it; a path has no time

}  // namespace

/// First both ends, if so asked; then the march of the start; then turns; then detours. Each of
/// these makes a march, and only where all before did not arrive.
struct PathWalk::Search {
  std::shared_ptr<const PathEnds> ends;
  PathOptions options;
  PathWalker walker;
  Way best;   ///< the first, or a better one that began with turns or a detour
  Way other;  ///< that began with the last turns or detour
  std::vector<std::vector<Vec3>> goals;
  std::vector<std::string> notes;
  std::optional<Meeting> meeting;
  std::optional<Detour> detour;
  std::optional<March> march;
  std::optional<std::vector<TurnWay>> turns;  ///< not tried yet, the next one last
  std::int64_t attempts = 0, replaced = 0;
  bool is_first = true;  ///< no other way has been begun
  bool is_over = false;

  Search(std::shared_ptr<const PathEnds> given, const PathOptions& asked)
      : ends(std::move(given)),
        options(asked),
        walker(ends->start, options.should_stop),
        goals{ends->goal} {
    best.add(walker.now(), walker.apart(ends->goal));
    if (options.both) {
      meeting.emplace(*ends, walker, best, options);
    } else {
      march.emplace(walker, best, goals, options.step);
    }
  }
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  void advance() {
    if (meeting) {
      if (!meeting->advance()) end_meeting();
    } else if (detour) {
      if (!detour->advance()) end_detour();
    } else if (!march->advance()) {
      end_march();
    }
  }

 private:
  void end_meeting() {
    notes.push_back(meeting->summary());
    goals = meeting->goals();
    meeting.reset();
    march.emplace(walker, best, goals, options.step);
  }

  void end_detour() {
    other = std::move(detour->way());
    detour.reset();
    const auto apart = [&](const std::vector<Vec3>& goal) { return walker.apart(goal); };
    const auto nearest =
        std::min_element(goals.begin(), goals.end(),
                         [&](const auto& a, const auto& b) { return apart(a) < apart(b); });
    march.emplace(walker, other, std::vector(nearest, goals.end()), options.step);
  }

  void end_march() {
    march.reset();
    if (!is_first && other.left.back() < best.left.back() - least_gain) {
      best = std::move(other);
      ++replaced;
    }
    is_first = false;
    if (best.left.back() <= find_path_atoms(options.atoms).arrived_within) return end();
    if (!turns) seek_turns();
    if (!turns->empty() && (best.turned == 0.0 || best.left.back() > turned_near))
      return begin_turns();
    if (attempts >= options.backtrack) return end();
    ++attempts;
    detour.emplace(walker, best, goals.back(), std::uint64_t(attempts), options.seed);
  }

  void seek_turns() {
    turns = find_turn_ways(ends->start, ends->goal);
    std::reverse(turns->begin(), turns->end());
  }

  void begin_turns() {
    other = best.first(1);
    other.turned = turns->back().angle;
    walker.put(other.places.back());
    march.emplace(walker, other, std::move(turns->back().goals), options.step);
    turns->pop_back();
  }

  void end() {
    walker.put(best.places.back());
    is_over = true;
  }
};

PathWalk::PathWalk(std::shared_ptr<const PathEnds> ends, const PathOptions& options) {
  check(options);
  search_ = std::make_unique<Search>(std::move(ends), options);
}

PathWalk::~PathWalk() = default;
PathWalk::PathWalk(PathWalk&&) noexcept = default;

bool PathWalk::advance() {
  if (!search_->is_over) search_->advance();
  return !search_->is_over;
}

bool PathWalk::is_over() const { return search_->is_over; }
std::size_t PathWalk::frame_count() const { return search_->best.places.size(); }

Frame PathWalk::frame(std::size_t number) const {
  const PathPlace& place = *search_->best.places[number];
  Frame frame;
  frame.step = std::int64_t(number);
  frame.time = double(number) * timestep;
  frame.positions = place.positions;
  frame.sweeps = place.sweeps;
  frame.projections = place.projections;
  frame.max_residual = place.max_residual;
  frame.rms_residual = place.rms_residual;
  frame.max_limit = place.max_limit;
  frame.max_overlap = place.max_overlap;
  return frame;
}

double PathWalk::left() const { return search_->best.left.back(); }
std::int64_t PathWalk::attempts() const { return search_->attempts; }
std::int64_t PathWalk::replaced() const { return search_->replaced; }
double PathWalk::turned() const { return search_->best.turned; }

std::vector<std::string> PathWalk::notes() const {
  std::vector<std::string> all = search_->ends->notes;
  all.insert(all.end(), search_->notes.begin(), search_->notes.end());
  const std::vector<std::string>& of_way = search_->best.notes;
  all.insert(all.end(), of_way.begin(), of_way.end());
  return all;
}

const std::shared_ptr<const PathEnds>& PathWalk::ends() const { return search_->ends; }
const PathOptions& PathWalk::options() const { return search_->options; }

std::vector<PathFrame> table_of(const PathWalk& walk) {
  PathTable table(*walk.ends());
  std::vector<PathFrame> rows;
  for (std::size_t k = 0; k < walk.frame_count(); ++k) {
    const Frame frame = walk.frame(k);
    rows.push_back(table.row(frame.step, frame.positions, frame.max_residual));
  }
  return rows;
}

MolecularPath found_by(const PathWalk& walk) {
  MolecularPath found{walk.ends(),   {},   table_of(walk), walk.notes(), walk.attempts(),
                      walk.turned(), false};
  for (std::size_t k = 0; k < walk.frame_count(); ++k) {
    const auto positions = walk.frame(k).positions;
    found.positions.emplace_back(positions.begin(), positions.end());
  }
  found.has_arrived =
      found.frames.back().to_end <= find_path_atoms(walk.options().atoms).arrived_within;
  return found;
}

MolecularPath find_path(const Structure& start, const Structure& end, const PathOptions& options) {
  PathWalk walk(std::make_shared<const PathEnds>(match_ends(start, end, options)), options);
  while (!(options.should_stop && options.should_stop()) && walk.advance()) {
  }
  return found_by(walk);
}

}  // namespace pliant
