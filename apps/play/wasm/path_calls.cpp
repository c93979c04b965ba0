// SPDX-License-Identifier: MIT
#include "calls.hpp"

#include <chrono>
#include <string>
#include <utility>

#include "pliant/base/error.hpp"
#include "session.hpp"
#include "settings.hpp"

namespace pliant::play {
namespace {

/// What a page has of a walk.
struct Sent {
  std::size_t frames = 0;
  std::int64_t replaced = 0;  ///< ways by better ones
};

Sent sent;

/// Makes at least one step, and as many as there is time for.
void go_on(PathWalk& walk, double milliseconds) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto passed = [&] {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  };
  while (walk.advance() && passed() < milliseconds) {
  }
}

/// The frames from one on.
void add_frames(const PathWalk& walk, std::size_t first, Reply& reply) {
  Json frames = Json::array();
  for (std::size_t k = first; k < walk.frame_count(); ++k) {
    const Frame frame = walk.frame(k);
    const std::string place = "frames." + std::to_string(frames.size()) + ".positions";
    frames.push_back({{"step", frame.step},
                      {"sweeps", frame.sweeps},
                      {"projections", frame.projections},
                      {"residual", frame.max_residual},
                      {"converged", true}});
    reply.add(place.c_str(), numbers_of(frame.positions));
  }
  reply.fields["frames"] = std::move(frames);
}

}  // namespace

Reply begin_path(const Request& request) {
  const Document& open = session().document();
  if (!open.file) throw OptionError("path: expected a molecule to start from");
  const std::string name = request.fields.value("name", "file");
  const PathOptions options = with_options(path_fields(), PathOptions(), request.fields);
  std::vector<std::string> warnings;
  const Structure end = read_molecule(name, request.bytes, {}, warnings);
  const auto ends = std::make_shared<const PathEnds>(match_ends(*open.file, end, options));
  Document document = document_of(ends->start.model, open.title);
  document.file = open.file;
  document.path = std::make_shared<PathWalk>(ends, options);
  document.warnings = std::move(warnings);
  sent = {1, 0};
  return begin_session(std::move(document));
}

Reply path_steps(const Request& request) {
  const auto& walk = session().document().path;
  if (!walk) throw OptionError("path: none has been begun");
  go_on(*walk, request.fields.value("milliseconds", 50.0));
  // A way that came nearer has taken the place of what was there: all of it is sent anew.
  const std::size_t kept = walk->replaced() > sent.replaced ? 0 : sent.frames;
  Reply reply;
  reply.fields = {
      {"kept", kept},
      {"left", walk->left()},
      {"over", walk->is_over()},
      {"arrived", walk->left() <= find_path_atoms(walk->options().atoms).arrived_within},
      {"attempts", walk->attempts()},
      {"notes", walk->notes()}};
  add_frames(*walk, kept, reply);
  sent = {walk->frame_count(), walk->replaced()};
  return reply;
}

}  // namespace pliant::play
