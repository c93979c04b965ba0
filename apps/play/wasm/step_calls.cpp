// SPDX-License-Identifier: MIT
#include "calls.hpp"

#include "edits/joint_words.hpp"
#include "pliant/base/error.hpp"
#include "pliant/framework/fingerprint.hpp"
#include "session.hpp"
#include "settings.hpp"
#include "steps/step_reply.hpp"
#include "steps/visits.hpp"

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

Reply reply_of(const StepReport& report) {
  Reply reply;
  reply.fields = fields_of(report.frame);
  reply.fields["seconds"] = report.seconds;
  if (report.is_stopped())
    reply.fields["stopped"] = {{"worst", report.resolved.worst_bar},
                               {"residual", report.resolved.max_residual},
                               {"sweeps", report.resolved.sweeps},
                               {"milliseconds", session().clock()->milliseconds}};
  reply.add("positions", numbers_of(report.frame.positions));
  return reply;
}

Reply with_bars(const StepReport& report, KeptResiduals& residuals) {
  Reply reply = reply_of(report);
  residuals.look(report.pushed);  // first: it is the last step but for what was pushed
  reply.add("broken", residuals.all());
  residuals.look(report.frame.positions);
  reply.fields["worst"] = residuals.worst();
  reply.fields["residualsAre"] = "(length - rest) / rest";
  reply.add("residuals", residuals.all());
  return reply;
}

namespace {

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
  return with_bars(session().pull(forces_of(request.fields)), session().residuals());
}

/// Techniques that are no orderings refuse to be watched: `events` is then null.
Reply resolution(const Request& request) {
  take_pins(request.fields);
  const std::vector<JointForce> forces = forces_of(request.fields);
  Visits visits(session().framework().bar_count());
  std::string why;
  StepReport report;
  try {
    report = session().pull_watched(forces, [&](const RepairedBar& visit) { visits.note(visit); });
  } catch (const OptionError& error) {
    why = error.what();
    report = session().pull(forces);
  }
  Reply reply = with_bars(report, session().residuals());
  reply.add("pushed", numbers_of(report.pushed));
  reply.fields["whole"] = true;
  if (why.empty()) {
    visits.add_to(reply);
  } else {
    reply.fields["events"] = nullptr;
    reply.fields["why"] = why;
  }
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
    if (report.is_stopped()) {
      reply.fields["stopped"] = reply_of(report).fields["stopped"];
      break;
    }
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
  return reply_of(session().again(with_settings(session().options(), request.fields), after));
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

/// The clock of steps, for a page where a person waits: milliseconds, or 0 for none.
Reply step_limit(const Request& request) {
  const double milliseconds = request.fields.value("milliseconds", 0.0);
  if (!(milliseconds >= 0.0)) throw OptionError("step_limit: expected milliseconds, or 0 for none");
  session().set_step_limit(milliseconds);
  Reply reply;
  reply.fields["milliseconds"] = milliseconds;
  return reply;
}

Reply settings(const Request& request) {
  session().set(with_settings(session().options(), request.fields));
  Reply reply;
  reply.fields = settings_of(session().options());
  return reply;
}

}  // namespace pliant::play
