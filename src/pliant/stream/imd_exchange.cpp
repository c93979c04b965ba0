// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_exchange.hpp"

#include <chrono>

namespace pliant {
namespace {

/// Frames between run and socket: more would be old when they are seen.
constexpr std::size_t most_frames = 16;
/// Warnings about clients; after that they are only counted.
constexpr std::int64_t most_messages = 10;
/// How often a waiting run looks whether it shall stop.
constexpr std::chrono::milliseconds glance{50};

}  // namespace

ImdExchange::ImdExchange(const Options& options, std::shared_ptr<Steering> steering)
    : options_(options),
      steering_(std::move(steering)),
      wake_(make_wake()),
      waits_for_client_(options.waits),
      every_(options.every) {}

bool ImdExchange::must_wait() const {
  if (!is_followed_) return waits_for_client_;
  return is_paused_ || (options_.waits && frames_.size() >= most_frames);
}

void ImdExchange::wait(std::unique_lock<std::mutex>& hold) {
  const auto start = std::chrono::steady_clock::now();
  while (must_wait() && !was_killed() && !(options_.should_stop && options_.should_stop()))
    changed_.wait_for(hold, glance);
  summary_.seconds_waited +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool ImdExchange::wants(std::int64_t step) {
  std::unique_lock hold(mutex_);
  if (must_wait()) wait(hold);
  if (!is_followed_ || step % every_ != 0) return false;
  if (frames_.size() < most_frames) return true;
  ++counts_.dropped;
  ++summary_.frames_dropped;
  return false;
}

void ImdExchange::put(Bytes frame) {
  {
    const std::lock_guard hold(mutex_);
    if (!is_followed_) return;
    frames_.push_back(std::move(frame));
    if (frames_.size() > 1) return;  // it has been woken
  }
  wake(wake_);
}

Bytes ImdExchange::buffer() {
  const std::lock_guard hold(mutex_);
  if (spare_.empty()) return {};
  Bytes buffer = std::move(spare_.back());
  spare_.pop_back();
  return buffer;
}

ImdCounts ImdExchange::counts() {
  const std::lock_guard hold(mutex_);
  return counts_;
}

void ImdExchange::finish() {
  {
    const std::lock_guard hold(mutex_);
    is_finishing_ = true;
  }
  wake(wake_);
}

void ImdExchange::tell(const Log& log) {
  if (!has_messages_.exchange(false)) return;
  std::vector<std::string> messages;
  {
    const std::lock_guard hold(mutex_);
    messages.swap(messages_);
  }
  for (const std::string& message : messages) log.warn(message);
}

ImdSummary ImdExchange::summary() {
  const std::lock_guard hold(mutex_);
  return summary_;
}

bool ImdExchange::is_finishing() {
  const std::lock_guard hold(mutex_);
  return is_finishing_;
}

void ImdExchange::begin_client() {
  const std::lock_guard hold(mutex_);
  is_followed_ = true;
  ++summary_.clients;
  changed_.notify_all();
}

/// The next one finds everything as if nobody had been there.
void ImdExchange::end_client() {
  steering_->release();
  const std::lock_guard hold(mutex_);
  is_followed_ = is_paused_ = false;
  every_ = options_.every;
  counts_ = {};
  frames_.clear();
  changed_.notify_all();
}

void ImdExchange::refuse(const std::string& message) {
  const std::lock_guard hold(mutex_);
  if (++summary_.refused <= most_messages) messages_.push_back(message);
  has_messages_ = true;
}

bool ImdExchange::next_frame(Bytes& frame) {
  const std::lock_guard hold(mutex_);
  if (frames_.empty()) return false;
  frame = std::move(frames_.front());
  frames_.pop_front();
  changed_.notify_all();
  return true;
}

void ImdExchange::take_back(Bytes sent) {
  sent.clear();
  const std::lock_guard hold(mutex_);
  ++summary_.frames_sent;
  spare_.push_back(std::move(sent));
}

void ImdExchange::pause(bool is_paused) {
  const std::lock_guard hold(mutex_);
  is_paused_ = is_paused;
  changed_.notify_all();
}

void ImdExchange::toggle_pause() {
  const std::lock_guard hold(mutex_);
  is_paused_ = !is_paused_;
  changed_.notify_all();
}

void ImdExchange::set_rate(std::int64_t every) {
  const std::lock_guard hold(mutex_);
  every_ = every < 1 ? options_.every : every;
}

void ImdExchange::set_waits(bool waits) {
  const std::lock_guard hold(mutex_);
  waits_for_client_ = waits;
  changed_.notify_all();
}

void ImdExchange::pull(const std::vector<JointForce>& forces) {
  steering_->pull(forces);
  const std::lock_guard hold(mutex_);
  counts_.forces = static_cast<std::int64_t>(forces.size());
  ++summary_.forces_taken;
}

void ImdExchange::kill() {
  is_killed_ = true;
  const std::lock_guard hold(mutex_);
  changed_.notify_all();
}

}  // namespace pliant
