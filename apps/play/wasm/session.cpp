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
  RunOptions wanted = options;
  wanted.resolve.should_stop = [clock = clock_] { return clock->is_over(); };
  walk_->set(wanted);
  options_ = std::make_shared<const RunOptions>(std::move(wanted));
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

void Session::keep(Before before, MadeStep step) {
  befores_.push_back(std::move(before));
  if (befores_.size() > most_befores_) befores_.pop_front();
  done_.push_back(std::move(step));
}

void Session::edit(const std::vector<FrameworkEdit>& edits) {
  crowd_.clear();
  stopped_.reset();
  Before before{state(), walk_->edited()};
  walk_->edit(edits);
  keep(std::move(before), step_of({}, Act::edit));
  measure_anew();
}

Document Session::shown() const {
  return walk_->edited() ? after_edits(document_, *walk_->edited()) : document_;
}

MadeStep Session::step_of(std::vector<JointForce> forces, Act act) const {
  return {options_, pinned_, walk_->edited(), std::move(forces), act, longest_step_};
}

/// A step that was stopped has been taken back: the session is as if nobody had asked for it.
StepReport Session::report(MadeStep step, const std::function<Frame()>& make) {
  crowd_.clear();
  stopped_.reset();
  Before before{state(), walk_->edited()};
  StepReport report = make_step(*walk_, *clock_, make);
  if (report.is_stopped())
    stopped_ = std::move(step);
  else
    keep(std::move(before), std::move(step));
  return report;
}

StepReport Session::pull(const std::vector<JointForce>& forces) {
  return report(step_of(forces, Act::pull), [&] { return walk_->pull(forces); });
}

StepReport Session::pull_watched(const std::vector<JointForce>& forces,
                                 const std::function<void(const RepairedBar&)>& on_bar) {
  return make_watched(*walk_, on_bar, [&] { return pull(forces); });
}

StepReport Session::wander() {
  return report(step_of({}, Act::wander), [&] { return walk_->wander(); });
}

std::vector<std::unique_ptr<SteeredWalk>>& Session::crowd(std::size_t walkers, bool goes_on) {
  if (goes_on && crowd_.size() == walkers) return crowd_;
  crowd_.clear();
  for (std::size_t number = 0; number < walkers; ++number) {
    RunOptions options = this->options();
    options.resolve.walker = number;
    options.resolve.should_stop = {};
    crowd_.push_back(std::make_unique<SteeredWalk>(framework(), state(), options));
  }
  return crowd_;
}

StepReport Session::again(const RunOptions& options, State& after) const {
  if (!stopped_ && (done_.empty() || befores_.empty()))
    throw OptionError("again: no step has been made");
  const MadeStep& last = stopped_ ? *stopped_ : done_.back();
  if (last.act != Act::pull) throw OptionError("again: the last step was no pull");
  SteeredWalk other(last.edited ? last.edited->framework : document_.framework,
                    stopped_ ? state() : befores_.back().state, options);
  other.pin(*last.pinned);
  if (last.longest_step > 0.0) other.hold_back(last.longest_step);
  StepReport report = make_step(other, *clock_, [&] { return other.pull(last.forces); });
  after = other.state();
  report.frame.positions = after.positions;
  return report;
}

std::size_t Session::undo(std::size_t steps) {
  const std::size_t count = std::min(steps, befores_.size());
  if (count == 0) return 0;
  crowd_.clear();
  stopped_.reset();
  Before before = std::move(befores_[befores_.size() - count]);
  befores_.resize(befores_.size() - count);
  done_.resize(done_.size() - count);
  walk_->put(std::move(before.state), std::move(before.edited));
  if (walk_->edited() != measured_) measure_anew();
  return count;
}

namespace {

void add_settings(std::vector<ForceEvent>& events, const RunOptions& options, RunOptions& set) {
  for (const RunField& field : run_fields()) {
    const std::string value = run_field_text(options, field);
    if (is_no_setting(field) || value == run_field_text(set, field)) continue;
    events.push_back({SetOption{std::string(field.name), value}});
  }
  set = options;
}

}  // namespace

std::vector<ForceEvent> Session::events() const {
  std::vector<ForceEvent> events;
  RunOptions set;
  std::vector<Joint> pinned;
  std::size_t edits = 0;
  double longest_step = 0.0;
  if (start_by_) {
    add_settings(events, *start_by_, set);
    events.push_back({StartWalk{}});
  }
  for (const MadeStep& done : done_) {
    add_settings(events, *done.options, set);
    if (done.longest_step != longest_step)
      events.push_back({HoldBack{longest_step = done.longest_step}});
    if (*done.pinned != pinned) events.push_back({PinJoints{pinned = *done.pinned}});
    for (const std::size_t all = done.edited ? done.edited->edits.size() : 0; edits < all; ++edits)
      events.push_back({done.edited->edits[edits]});
    if (done.act == Act::pull) add_pull(events, done.forces);
    if (done.act == Act::wander) add_wander(events, done.forces);
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
