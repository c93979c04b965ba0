// SPDX-License-Identifier: MIT
#include "step_calls.hpp"

#include "joint_words.hpp"
#include "pliant/base/error.hpp"
#include "pliant/framework/fingerprint.hpp"
#include "session.hpp"
#include "settings.hpp"

namespace pliant::play {

Joint joint_of(const Json& number) {
  if (!number.is_number_unsigned() || number.get<std::uint64_t>() >= ~Joint{0})
    throw OptionError("joint " + number.dump() + ": expected a whole number from 0");
  return number.get<Joint>();
}

namespace {

std::vector<JointForce> forces_of(const Json& fields) {
  std::vector<JointForce> forces;
  for (const Json& row : fields.value("forces", Json::array())) {
    if (!row.is_array() || row.size() != 4)
      throw OptionError("forces: expected rows of joint, x, y, z, found " + row.dump());
    forces.push_back({joint_of(row[0]), {row[1], row[2], row[3]}});
  }
  return forces;
}

/// Pins of the request are in force from now on; without the word those before stay.
void take_pins(const Json& fields) {
  const auto pins = fields.find("pins");
  if (pins == fields.end()) return;
  std::vector<Joint> joints;
  for (const Json& pin : *pins) joints.push_back(joint_of(pin));
  session().pin(std::move(joints));
}

}  // namespace

Json fields_of(const Frame& frame) {
  return {{"step", frame.step},
          {"time", frame.time},
          {"sweeps", frame.sweeps},
          {"projections", frame.projections},
          {"residual", frame.max_residual},
          {"rms", frame.rms_residual},
          {"converged", frame.stop == Stop::converged},
          {"stop", name(frame.stop)},
          {"stopCode", static_cast<int>(frame.stop)},
          {"root", frame.root_joint},
          {"force", {frame.force.x, frame.force.y, frame.force.z}},
          {"limit", frame.max_limit},
          {"overlap", frame.max_overlap}};
}

namespace {

Reply reply_of(const StepReport& report) {
  Reply reply;
  reply.fields = fields_of(report.frame);
  reply.fields["seconds"] = report.seconds;
  reply.add("positions", numbers_of(report.frame.positions));
  return reply;
}

/// Adds what each bar has left, and had before it was resolved: (length - rest) / rest.
Reply with_bars(const StepReport& report) {
  Reply reply = reply_of(report);
  KeptResiduals& residuals = session().residuals();
  residuals.look(report.pushed);  // first: it is the last step but for what was pushed
  reply.add("broken", residuals.all());
  residuals.look(report.frame.positions);
  reply.fields["worst"] = residuals.worst();
  reply.fields["residualsAre"] = "(length - rest) / rest";
  reply.add("residuals", residuals.all());
  return reply;
}

/// What a person sees of a step bar by bar: enough for an hour of slow motion.
constexpr std::size_t most_events = 100000;

struct Visits {
  std::vector<std::int32_t> events;  ///< (4 E) bar, near joint, far joint, sweep
  std::vector<float> moved;          ///< (6 E) where both joints are after it (Angstrom)
  std::int32_t sweep = 0;
  std::vector<bool> seen;
  bool is_whole = true;

  /// A sweep visits each bar once: the next one has begun when a bar comes again.
  void note(const RepairedBar& visit) {
    if (seen[visit.bar]) {
      ++sweep;
      seen.assign(seen.size(), false);
    }
    seen[visit.bar] = true;
    if (events.size() / 4 >= most_events) {
      is_whole = false;
      return;
    }
    for (std::uint32_t number : {visit.bar, visit.near, visit.far})
      events.push_back(static_cast<std::int32_t>(number));
    events.push_back(sweep);
    for (Joint joint : {visit.near, visit.far}) {
      const Vec3 x = visit.positions[joint];
      for (double part : {x.x, x.y, x.z}) moved.push_back(static_cast<float>(part));
    }
  }
};

/// Steps of several walkers, which leave the session where it is.
void wander_together(Reply& reply, std::size_t walkers, std::int64_t steps, bool goes_on) {
  std::size_t number = 0;
  for (const auto& walk : session().crowd(walkers, goes_on)) {
    Frame frame = walk->frame();
    for (std::int64_t step = 0; step < steps; ++step) frame = walk->wander();
    reply.fields["walkers"].push_back(fields_of(frame));
    const std::string place = "walkers." + std::to_string(number++) + ".positions";
    reply.add(place.c_str(), numbers_of(frame.positions));
  }
}

}  // namespace

Reply pull(const Request& request) {
  take_pins(request.fields);
  return with_bars(session().pull(forces_of(request.fields)));
}

Reply resolution(const Request& request) {
  take_pins(request.fields);
  const std::vector<JointForce> forces = forces_of(request.fields);
  Visits visits;
  visits.seen.resize(session().framework().bar_count());
  const auto note = [&](const RepairedBar& visit) { visits.note(visit); };
  std::string why;
  StepReport report;
  try {
    report = session().pull_watched(forces, note);
  } catch (const OptionError& error) {
    why = error.what();
    report = session().pull(forces);
  }
  Reply reply = with_bars(report);
  reply.add("pushed", numbers_of(report.pushed));
  reply.fields["whole"] = visits.is_whole;
  if (!why.empty()) {
    reply.fields["events"] = nullptr;
    reply.fields["why"] = why;
    return reply;
  }
  reply.add("events", std::span<const std::int32_t>(visits.events));
  reply.add("moved", std::span<const float>(visits.moved));
  return reply;
}

Reply wander(const Request& request) {
  take_pins(request.fields);
  const auto steps = request.fields.value("steps", std::int64_t{1});
  const auto walkers = request.fields.value("walkers", std::size_t{1});
  if (steps < 1 || steps > 100000 || walkers < 1 || walkers > 1000)
    throw OptionError("wander: expected 1 to 100000 steps of 1 to 1000 walkers");
  const bool is_last_alone = request.fields.value("last", false);
  Reply reply;
  reply.fields[walkers > 1 ? "walkers" : "frames"] = Json::array();
  if (walkers > 1) wander_together(reply, walkers, steps, request.fields.value("go_on", false));
  for (std::int64_t k = 0; walkers == 1 && k < steps; ++k) {
    const StepReport report = session().wander();
    if (is_last_alone && k + 1 < steps) continue;
    Json fields = fields_of(report.frame);
    fields["seconds"] = report.seconds;
    reply.fields["frames"].push_back(std::move(fields));
    const std::size_t number = reply.fields["frames"].size() - 1;
    const std::string place = "frames." + std::to_string(number) + ".positions";
    reply.add(place.c_str(), numbers_of(report.frame.positions));
  }
  return reply;
}

Reply forces(const Request&) {
  Reply reply;
  reply.fields["text"] = write_force_events(session().events(), session().document().framework,
                                            session().force_header());
  return reply;
}

Reply again(const Request& request) {
  State after;
  const RunOptions options = with_settings(session().options(), request.fields);
  return reply_of(session().again(options, after));
}

Reply undo(const Request& request) {
  const auto steps = request.fields.value("steps", std::size_t{1});
  const auto held_by = session().walk().edited();
  Reply reply;
  reply.fields["steps"] = session().undo(steps);
  reply.fields["edited"] = session().walk().edited() != held_by;
  reply.fields["step"] = session().state().step;
  reply.add("positions", numbers_of(session().state().positions));
  return reply;
}

/// What two machines compare.
Reply state(const Request&) {
  Reply reply;
  reply.fields["hash"] = fingerprint_text(fingerprint(session().state().positions));
  reply.fields["step"] = session().state().step;
  return reply;
}

Reply settings(const Request& request) {
  session().set(with_settings(session().options(), request.fields));
  Reply reply;
  reply.fields = settings_of(session().options());
  return reply;
}

}  // namespace pliant::play
