// SPDX-License-Identifier: MIT
// A run that is served over IMD, and clients that follow it over TCP.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "imd_client.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/run/run.hpp"
#include "pliant/stream/imd_server.hpp"

namespace pliant::test {

inline ImdOptions on_any_port() {
  ImdOptions options;
  options.port = 0;
  return options;
}

/// No client that waits in vain for long.
inline ImdOptions ended_by_clients(bool waits = false) {
  ImdOptions options = on_any_port();
  options.wait = waits;
  options.patience.reading = std::chrono::hours(1);
  options.patience.finish = std::chrono::milliseconds(20);
  return options;
}

/// Of a frame of version 3.
inline std::int64_t step_of(const Bytes& frame) {
  std::int64_t step = 0;
  if (frame.size() >= 32) std::memcpy(&step, &frame[24], sizeof step);
  return step;
}

/// One of its nine energies.
inline float energy_of(const Bytes& frame, std::size_t number) {
  float energy = 0.0F;
  std::memcpy(&energy, &frame[32 + 8 + 4 + 4 * number], sizeof energy);
  return energy;
}

class ImdServers : public testing::Test {
 protected:
  void serve(ImdOptions options) {
    options.log.function = [this](Severity, std::string_view text) {
      warnings_.emplace_back(text);
    };
    server_ = std::make_unique<ImdServer>(framework_.joint_count(), options, steering_);
  }

  /// Without random pushes where `is_still`.
  RunSummary run(std::int64_t steps, bool is_still = false) {
    RunOptions options;
    options.steps = steps;
    options.every = steps;
    if (is_still) options.perturb_options.force = 0.0;
    options.hands = {steering_};
    options.onlooker = {[this](std::int64_t step) { return server_->wants(step); },
                        [this](const Frame& frame) { server_->show(frame); }};
    options.resolve.should_stop = [this] { return server_->was_killed(); };
    options.on_push = on_push_;
    return pliant::run(framework_, state_, options, {});
  }

  /// Connected, without GO.
  Socket greeted() const {
    Socket client = connect_to(server_->port());
    const Bytes greeting = imd_greeting({3, false});
    EXPECT_EQ(receive(client, greeting.size()), greeting);
    return client;
  }

  Socket follow() const {
    Socket client = greeted();
    send_all(client, packet(ImdType::go));
    return client;
  }

  Bytes next_frame(const Socket& client) const { return receive(client, size_of_frame()); }

  /// Time, energies and coordinates with their heads.
  std::size_t size_of_frame() const { return 32 + 48 + 8 + 12 * framework_.joint_count(); }

  const Sketch sketch_ = ring(6);
  const Framework framework_ = framework_of(sketch_);
  State state_{sketch_.positions};
  std::function<void(const Push&)> on_push_;
  std::vector<std::string> warnings_;
  std::shared_ptr<Steering> steering_ = std::make_shared<Steering>(0.2);
  std::unique_ptr<ImdServer> server_;
};

}  // namespace pliant::test
