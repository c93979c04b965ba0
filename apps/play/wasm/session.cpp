// SPDX-License-Identifier: MIT
#include "session.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "pliant/base/error.hpp"
#include "settings.hpp"

namespace pliant::play {
namespace {

std::unique_ptr<Session> open_session;

/// Bytes of the states that undo goes back to.
constexpr std::size_t kept_bytes = std::size_t{64} << 20;

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Session::Session(Document document)
    : document_(std::move(document)),
      residuals_(std::in_place, document_.framework),
      walk_(std::make_unique<SteeredWalk>(document_.framework, State(document_.positions))),
      options_(std::make_shared<const RunOptions>(walk_->options())),
      pinned_(std::make_shared<const std::vector<Joint>>()) {
  const std::size_t one = 2 * sizeof(Vec3) * std::max<std::size_t>(document_.positions.size(), 1);
  most_befores_ = std::clamp<std::size_t>(kept_bytes / one, 4, 1000);
  walk_->start();
}

void Session::set(const RunOptions& options) {
  crowd_.clear();
  walk_->set(options);
  options_ = std::make_shared<const RunOptions>(options);
}

void Session::pin(std::vector<Joint> joints) {
  std::ranges::sort(joints);
  joints.erase(std::ranges::unique(joints).begin(), joints.end());
  if (joints == *pinned_) return;
  crowd_.clear();
  walk_->pin(joints);
  pinned_ = std::make_shared<const std::vector<Joint>>(std::move(joints));
}

/// Bars have changed: their residuals are others.
void Session::measure_anew() {
  const auto& edited = walk_->edited();
  residuals_.emplace(edited ? edited->framework : document_.framework);
  measured_ = edited;
}

void Session::keep(Before before, std::vector<JointForce> forces, Act act) {
  befores_.push_back(std::move(before));
  if (befores_.size() > most_befores_) befores_.pop_front();
  done_.push_back({options_, pinned_, walk_->edited(), std::move(forces), act});
}

void Session::edit(const std::vector<FrameworkEdit>& edits) {
  crowd_.clear();
  Before before{state(), walk_->edited()};
  walk_->edit(edits);
  keep(std::move(before), {}, Act::edit);
  measure_anew();
}

Document Session::shown() const {
  return walk_->edited() ? after_edits(document_, *walk_->edited()) : document_;
}

StepReport Session::report(std::vector<JointForce> forces, Act act,
                           const std::function<Frame()>& step) {
  crowd_.clear();
  StepReport report;
  Before before{state(), walk_->edited()};
  walk_->look_at_push([&](std::span<const Vec3> positions) {
    report.pushed.assign(positions.begin(), positions.end());
  });
  report.seconds = seconds_of([&] { report.frame = step(); });
  walk_->look_at_push({});
  keep(std::move(before), std::move(forces), act);
  return report;
}

StepReport Session::pull(const std::vector<JointForce>& forces) {
  return report(forces, Act::pull, [&] { return walk_->pull(forces); });
}

StepReport Session::pull_watched(const std::vector<JointForce>& forces,
                                 const std::function<void(const RepairedBar&)>& on_bar) {
  walk_->watch(on_bar);
  const auto leave = [&] { walk_->watch({}); };
  try {
    StepReport done = pull(forces);
    leave();
    return done;
  } catch (...) {
    leave();
    throw;
  }
}

StepReport Session::wander() {
  return report({}, Act::wander, [&] { return walk_->wander(); });
}

std::vector<std::unique_ptr<SteeredWalk>>& Session::crowd(std::size_t walkers, bool goes_on) {
  if (goes_on && crowd_.size() == walkers) return crowd_;
  crowd_.clear();
  for (std::size_t number = 0; number < walkers; ++number) {
    RunOptions options = this->options();
    options.resolve.walker = number;
    crowd_.push_back(std::make_unique<SteeredWalk>(framework(), state(), options));
  }
  return crowd_;
}

StepReport Session::again(const RunOptions& options, State& after) const {
  if (done_.empty() || befores_.empty() || done_.back().act != Act::pull)
    throw OptionError("again: the last step was no pull");
  const Done& last = done_.back();
  SteeredWalk other(last.edited ? last.edited->framework : document_.framework,
                    befores_.back().state, options);
  other.pin(*last.pinned);
  StepReport report;
  report.seconds = seconds_of([&] { report.frame = other.pull(last.forces); });
  after = other.state();
  report.frame.positions = after.positions;
  return report;
}

std::size_t Session::undo(std::size_t steps) {
  const std::size_t count = std::min(steps, befores_.size());
  if (count == 0) return 0;
  crowd_.clear();
  Before before = std::move(befores_[befores_.size() - count]);
  befores_.resize(befores_.size() - count);
  done_.resize(done_.size() - count);
  walk_->put(std::move(before.state), std::move(before.edited));
  if (walk_->edited() != measured_) measure_anew();
  return count;
}

void Session::apply(const ForceEvent& event, const std::function<void(const StepReport&)>& show) {
  if (const auto* chosen = std::get_if<SetOption>(&event.what)) {
    RunOptions wanted = options();
    set_run_field(wanted, chosen->name, chosen->value);
    set(wanted);
  } else if (const auto* pins = std::get_if<PinJoints>(&event.what)) {
    pin(pins->joints);
  } else if (const auto* one = std::get_if<FrameworkEdit>(&event.what)) {
    edit({*one});
  } else if (const auto* steps = std::get_if<PullStep>(&event.what)) {
    for (std::int64_t k = 0; k < steps->count; ++k) show(pull(steps->forces));
  } else if (const auto* steps = std::get_if<WanderSteps>(&event.what);
             steps && steps->forces.empty()) {
    for (std::int64_t k = 0; k < steps->count; ++k) show(wander());
  } else {
    throw OptionError("the page has no start, no hold_back, and no forces with wander");
  }
}

std::vector<ForceEvent> Session::events() const {
  std::vector<ForceEvent> events;
  RunOptions set;
  std::vector<Joint> pinned;
  std::size_t edits = 0;
  for (const Done& done : done_) {
    for (const RunField& field : run_fields()) {
      const std::string value = run_field_text(*done.options, field);
      if (is_no_setting(field) || value == run_field_text(set, field)) continue;
      events.push_back({SetOption{std::string(field.name), value}});
    }
    set = *done.options;
    if (*done.pinned != pinned) events.push_back({PinJoints{pinned = *done.pinned}});
    for (const std::size_t all = done.edited ? done.edited->edits.size() : 0; edits < all; ++edits)
      events.push_back({done.edited->edits[edits]});
    if (done.act == Act::pull) add_pull(events, done.forces);
    if (done.act == Act::wander) add_wander(events);
  }
  return events;
}

ForceHeader Session::force_header() const {
  ForceHeader header = force_header_of(document_.framework);
  header.structure = document_.fingerprint;
  if (!document_.model.empty()) header.input.push_back({"model", document_.model});
  return header;
}

Session& session() {
  if (!open_session) throw OptionError("nothing is open");
  return *open_session;
}

Reply begin_session(Document document) {
  auto fresh = std::make_unique<Session>(std::move(document));
  open_session = std::move(fresh);
  Reply reply = describe(open_session->document(), open_session->state().positions);
  reply.fields["start"] = fields_of(open_session->frame());
  return reply;
}

}  // namespace pliant::play
