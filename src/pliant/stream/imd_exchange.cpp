// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_exchange.hpp"

#include <algorithm>
#include <chrono>

namespace pliant {
namespace {

/// Frames between a run that waits and the socket of a client.
constexpr std::size_t most_frames = 16;
/// Warnings about clients; after that they are only counted.
constexpr std::int64_t most_messages = 100;
/// How often a waiting run looks whether it shall stop.
constexpr std::chrono::milliseconds glance{50};

}  // namespace

ImdExchange::ImdExchange(const Options& options, std::shared_ptr<Steering> steering)
    : options_(options), steering_(std::move(steering)), waits_for_client_(options.waits) {}

/// Where the run waits, frames queue, and none is lost. Where it does not, one is made only when
/// the client can be sent it: one made earlier would be old by then.
bool ImdExchange::has_room(const ImdFollower& client) const {
  return options_.waits ? client.frames.size() < most_frames : client.is_ready;
}

bool ImdExchange::must_wait() const {
  if (followers_.empty()) return waits_for_client_;
  return std::any_of(followers_.begin(), followers_.end(), [this](const ImdFollower& client) {
    return client.is_paused || (options_.waits && !has_room(client));
  });
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
  bool is_wanted = false;
  for (ImdFollower& client : followers_) is_wanted |= takes(client, step);
  return is_wanted;
}

/// Notes whether the client gets this step, and counts it where it is too slow.
bool ImdExchange::takes(ImdFollower& client, std::int64_t step) {
  const bool is_due = step % client.every == 0;
  client.gets_next = is_due && has_room(client);
  if (is_due && !client.gets_next) {
    ++client.counts.dropped;
    ++summary_.frames_dropped;
  }
  return client.gets_next;
}

void ImdExchange::put(std::shared_ptr<Bytes> coordinates, const MakeHead& head_for) {
  {
    const std::lock_guard hold(mutex_);
    for (ImdFollower& client : followers_) {
      if (!client.gets_next) continue;
      client.frames.push_back({head_for(client.counts), coordinates});
      client.gets_next = client.is_ready = false;
    }
    coordinates.reset();  // take_back() finds out whether a buffer is free
  }
  wake_.wake();
}

std::shared_ptr<Bytes> ImdExchange::buffer() {
  const std::lock_guard hold(mutex_);
  if (spare_.empty()) return std::make_shared<Bytes>();
  std::shared_ptr<Bytes> buffer = std::move(spare_.back());
  spare_.pop_back();
  return buffer;
}

void ImdExchange::finish() {
  {
    const std::lock_guard hold(mutex_);
    is_finishing_ = true;
  }
  wake_.wake();
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

ImdFollower& ImdExchange::begin_client() {
  const std::lock_guard hold(mutex_);
  ++summary_.clients;
  changed_.notify_all();
  ImdFollower client;
  return followers_.emplace_back(std::move(client));
}

void ImdExchange::end_client(ImdFollower& client) {
  const std::lock_guard hold(mutex_);
  const bool has_pulled = !client.forces.empty();
  std::erase_if(followers_, [&](const ImdFollower& one) { return &one == &client; });
  if (has_pulled) steering_->pull(forces_of(followers_));
  changed_.notify_all();
}

void ImdExchange::refuse(const std::string& message) {
  const std::lock_guard hold(mutex_);
  ++summary_.refused;
  keep_message(message);
}

void ImdExchange::keep_message(const std::string& message) {
  if (++messages_kept_ > most_messages) return;
  messages_.push_back(messages_kept_ < most_messages ? message
                                                     : message + "; further ones are only counted");
  has_messages_ = true;
}

void ImdExchange::set_ready(ImdFollower& client) {
  const std::lock_guard hold(mutex_);
  client.is_ready = true;
}

bool ImdExchange::next_frame(ImdFollower& client, ImdOutgoing& frame) {
  const std::lock_guard hold(mutex_);
  if (client.frames.empty()) return false;
  frame = std::move(client.frames.front());
  client.frames.pop_front();
  changed_.notify_all();
  return true;
}

void ImdExchange::take_back(ImdOutgoing sent) {
  const std::lock_guard hold(mutex_);
  ++summary_.frames_sent;
  if (sent.body.use_count() == 1) spare_.push_back(std::move(sent.body));
  sent.body.reset();
}

void ImdExchange::pause(ImdFollower& client, bool is_paused) {
  const std::lock_guard hold(mutex_);
  client.is_paused = is_paused;
  changed_.notify_all();
}

void ImdExchange::set_rate(ImdFollower& client, std::int64_t every) {
  const std::lock_guard hold(mutex_);
  client.every = std::max<std::int64_t>(every, 1);
}

void ImdExchange::set_waits(bool waits) {
  const std::lock_guard hold(mutex_);
  waits_for_client_ = waits;
  changed_.notify_all();
}

void ImdExchange::pull(ImdFollower& client, const std::vector<JointForce>& forces) {
  const std::lock_guard hold(mutex_);
  client.forces = forces;
  client.counts.forces = static_cast<std::int64_t>(forces.size());
  ++summary_.forces_taken;
  steering_->pull(forces_of(followers_));
}

void ImdExchange::kill(const std::string& name) {
  const std::lock_guard hold(mutex_);
  if (!options_.can_kill) {
    keep_message("IMD client " + name + " asked the run to end (KILL): it goes on, as clients " +
                 "of other machines can reach it");
    return;
  }
  is_killed_ = true;
  changed_.notify_all();
}

}  // namespace pliant
