// SPDX-License-Identifier: MIT
#include "calls.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/framework/fingerprint.hpp"
#include "settings.hpp"
#include "steps/replay.hpp"
#include "steps/step_reply.hpp"

namespace pliant::play {
namespace {

/// More rows than a person looks through.
constexpr std::size_t most_rows = 2000;

/// The event of a force file in its own words.
struct Told {
  std::string joint(Joint number) const { return session().framework().label(number); }
  std::string forces(const std::vector<JointForce>& all) const {
    std::string text;
    for (const JointForce& one : all)
      text += (text.empty() ? "" : "; ") + joint(one.joint) + " (" + number_text(one.force.x, 3) +
              ", " + number_text(one.force.y, 3) + ", " + number_text(one.force.z, 3) + ")";
    return text.empty() ? "no force" : text;
  }

  Json operator()(const SetOption& set) const { return {"set", set.name + " " + set.value}; }
  Json operator()(const PinJoints& pins) const {
    std::string text;
    for (const Joint one : pins.joints) text += (text.empty() ? "" : ", ") + joint(one);
    return {"pin", text.empty() ? "none" : text};
  }
  Json operator()(const PullStep& pull) const { return {"pull", forces(pull.forces), pull.count}; }
  Json operator()(const WanderSteps& wander) const {
    return {"wander", wander.forces.empty() ? "" : forces(wander.forces), wander.count};
  }
  Json operator()(const HoldBack& hold) const {
    return {"hold back", number_text(hold.longest_step, 3) + " \u00c5 a step"};
  }
  Json operator()(const FrameworkEdit& edit) const {
    const std::string text = text_of(edit, session().framework());
    const std::string word(name(edit.kind));
    return {word, text.substr(text.starts_with(word) ? word.size() + 1 : 0)};
  }
  Json operator()(const StartWalk&) const { return {"start", "made whole"}; }
};

Json rows_of(const std::vector<ForceEvent>& events) {
  Json rows = Json::array();
  for (std::size_t k = 0; k < events.size() && k < most_rows; ++k)
    rows.push_back(std::visit(Told(), events[k].what));
  return rows;
}

/// A replay ends where its file does: no clock shortens its steps, or it would be another session.
class WithoutClock {
 public:
  WithoutClock() : clock_(session().clock()), kept_(clock_->milliseconds) {
    clock_->milliseconds = 0.0;
  }
  WithoutClock(const WithoutClock&) = delete;
  WithoutClock& operator=(const WithoutClock&) = delete;
  ~WithoutClock() { clock_->milliseconds = kept_; }

 private:
  std::shared_ptr<StepClock> clock_;
  double kept_;
};

Replay& replay() {
  if (!session().replay) throw OptionError("replay: none has been begun");
  return *session().replay;
}

/// Adds a step as frame number `number`.
void add_frame(Reply& reply, const StepReport& report, std::size_t number) {
  Json fields = fields_of(report.frame);
  fields["seconds"] = report.seconds;
  reply.fields["frames"].push_back(std::move(fields));
  const std::string place = "frames." + std::to_string(number) + ".positions";
  reply.add(place.c_str(), numbers_of(report.frame.positions));
}

void add_residuals(Reply& reply, const std::vector<Vec3>& pushed) {
  KeptResiduals& residuals = session().residuals();
  residuals.look(pushed);
  reply.add("broken", residuals.all());
  residuals.look(session().state().positions);
  reply.fields["worst"] = residuals.worst();
  reply.add("residuals", residuals.all());
}

std::size_t edits_made() {
  const auto& edited = session().walk().edited();
  return edited ? edited->edits.size() : 0;
}

}  // namespace

Reply force_file(const Request& request) {
  const ForceHeader header =
      read_force_header(request.bytes, request.fields.value("name", "force file"));
  Reply reply;
  reply.fields = {{"input", Json::array()}};
  if (header.structure) reply.fields["structure"] = fingerprint_text(*header.structure);
  if (header.joints) reply.fields["joints"] = *header.joints;
  if (header.bars) reply.fields["bars"] = *header.bars;
  for (const ForceSetting& one : header.input)
    reply.fields["input"].push_back({{"name", one.name}, {"value", one.value}});
  return reply;
}

Reply begin_replay(const Request& request) {
  Session& open = session();
  auto fresh = std::make_shared<Replay>(request.bytes, request.fields.value("name", "force file"),
                                        open.document());
  fresh->begin(open);
  open.replay = fresh;
  Reply reply;
  reply.fields = {{"rows", rows_of(fresh->events())},
                  {"events", fresh->events().size()},
                  {"steps", fresh->steps()}};
  return reply;
}

Reply replay_steps(const Request& request) {
  const double milliseconds = request.fields.value("milliseconds", 30.0);
  const auto most = request.fields.value("most", std::size_t{100});
  const auto start = std::chrono::steady_clock::now();
  const auto passed = [&] {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
  };
  const WithoutClock whole_steps;
  Reply reply;
  reply.fields["frames"] = Json::array();
  std::vector<Vec3> pushed;
  const std::size_t edits = edits_made();
  for (std::size_t k = 0; k < most && (k == 0 || passed() < milliseconds); ++k) {
    const auto made = replay().step(session());
    if (!made) break;
    pushed = made->pushed;
    add_frame(reply, *made, k);
  }
  if (!pushed.empty()) add_residuals(reply, pushed);
  reply.fields["edits"] = edits_made() - edits;
  reply.fields["done"] = replay().done();
  reply.fields["next"] = replay().next();
  reply.fields["over"] = replay().is_over();
  reply.fields["settings"] = settings_of(session().options());
  reply.fields["pins"] = session().pinned();
  return reply;
}

}  // namespace pliant::play
