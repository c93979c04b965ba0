// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_server.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "imd_servers.hpp"
#include "support/error_text.hpp"

namespace pliant::imd_server_test {

using test::operator+;
using test::packet;

using test::ImdServers;
using test::on_any_port;
using test::step_of;

TEST_F(ImdServers, ShowEachStepToWhomTheyWaitFor) {
  ImdOptions options = on_any_port();
  options.wait = true;
  serve(options);
  std::jthread walker([this] {
    run(300);
    server_->close();
  });
  const Socket client = follow();
  for (std::int64_t step = 0; step <= 300; ++step) {
    const Bytes frame = test::receive(client, size_of_frame());
    ASSERT_EQ(frame.size(), size_of_frame());
    ASSERT_EQ(step_of(frame), step);
  }
  EXPECT_TRUE(test::receive(client, 1).empty()) << "and no more";
}

TEST_F(ImdServers, ServeOneClientAfterAnother) {
  ImdOptions options = on_any_port();
  options.wait = true;
  options.patience.finish = std::chrono::milliseconds(20);
  serve(options);
  std::jthread walker([this] { run(1'000'000'000); });
  std::int64_t last = -1;
  // Closing a socket with frames in it that nobody read resets the connection, and the packet is
  // lost that was sent last: the client that ends the run stays until it has ended.
  Socket ender;
  for (int k = 0; k < 3; ++k) {
    Socket client = follow();
    const std::int64_t step = step_of(test::receive(client, size_of_frame()));
    EXPECT_GT(step, last);
    last = step;
    if (k < 2) continue;
    test::send_all(client, packet(ImdType::kill));
    ender = std::move(client);
  }
  walker.join();
  EXPECT_GE(state_.step, last);
  EXPECT_EQ(server_->close().clients, 3);
}

TEST_F(ImdServers, WaitForNobodyWhoNeverSaysGo) {
  ImdOptions options = on_any_port();
  options.wait = true;
  options.patience.go = std::chrono::hours(1);
  options.patience.finish = std::chrono::milliseconds(20);
  serve(options);
  std::jthread walker([this] { run(1'000'000'000); });
  const Socket silent = greeted();
  const Socket client = follow();
  EXPECT_EQ(step_of(test::receive(client, size_of_frame())), 0);
  test::send_all(client, packet(ImdType::kill));
  walker.join();
  EXPECT_EQ(server_->close().clients, 1);
  EXPECT_TRUE(test::receive(silent, 1).empty()) << "it has been left";
}

TEST_F(ImdServers, NeverWaitForAClientThatDoesNotRead) {
  ImdOptions options = on_any_port();
  options.patience.finish = std::chrono::milliseconds(20);
  serve(options);
  const Socket client = follow();
  while (server_->summary().clients == 0) std::this_thread::yield();
  // Far more than what the system keeps for a client: 160 bytes a frame.
  std::int64_t steps = 0;
  while (server_->summary().frames_dropped < 1000) steps += run(100'000).steps;
  const ImdSummary served = server_->close();
  EXPECT_GE(served.frames_dropped, 1000);
  EXPECT_EQ(served.seconds_waited, 0.0);
  EXPECT_EQ(state_.step, steps);
}

TEST_F(ImdServers, GoOnWhateverAClientSends) {
  std::vector<std::string> warnings;
  ImdOptions options = on_any_port();
  options.log.function = [&](Severity, std::string_view text) { warnings.emplace_back(text); };
  serve(options);
  const std::vector<Bytes> hostile{
      packet(ImdType::forces, -1),      packet(ImdType::forces, 1 << 30),
      test::forces(1, {77}, {0, 0, 0}), test::bytes_of("474554202f20485454502f312e310d0a"),
      packet(ImdType::handshake, 3),    packet(ImdType::go)};
  for (const Bytes& bytes : hostile) {
    const Socket client = follow();
    test::send_all(client, bytes);
    run(10);
    test::receive_all(client);  // until it is dropped
  }
  run(10);
  EXPECT_EQ(state_.step, 70);
  const ImdSummary served = server_->close();
  EXPECT_EQ(served.refused, 6);
  ASSERT_EQ(warnings.size(), 6u);
  EXPECT_NE(warnings[2].find(" dropped: force on atom 77 of 6"), std::string::npos) << warnings[2];
}

TEST_F(ImdServers, PullAtJoints) {
  ImdOptions options = on_any_port();
  options.wait = true;
  options.patience.finish = std::chrono::milliseconds(20);
  serve(options);
  std::vector<JointForce> acted;
  std::jthread walker([&] {
    RunOptions how;
    how.perturb_options.force = 0.0;
    how.steps = 1'000'000'000;
    how.every = how.steps;
    how.hands = {steering_};
    how.onlooker = {[this](std::int64_t step) { return server_->wants(step); },
                    [this](const Frame& frame) { server_->show(frame); }};
    how.resolve.should_stop = [this] { return server_->was_killed(); };
    how.on_push = [&](const Push& push) {
      if (push.forces.size() > 1) acted = push.forces;
    };
    pliant::run(framework_, state_, how, {});
  });
  const Socket client = follow();
  test::send_all(client, test::forces(1, {2}, {0, 0, 1e6F}));
  float pulled = 0.0F;
  while (pulled == 0.0F) {
    const Bytes frame = test::receive(client, size_of_frame());
    std::memcpy(&pulled, &frame[32 + 8 + 4 + 4 * 7], sizeof pulled);
  }
  test::receive(client, 20 * size_of_frame());  // so long it acts
  test::send_all(client, packet(ImdType::kill));
  walker.join();
  EXPECT_EQ(pulled, 1.0F);
  ASSERT_EQ(acted.size(), 2u);
  EXPECT_EQ(acted[1].joint, 2u);
  EXPECT_LT(norm(acted[1].force), 1e5) << "capped";
  EXPECT_EQ(server_->close().forces_taken, 1);
}

TEST(ImdServer, RefusesOptionsThatMakeNoSense) {
  const auto refusal = [](auto change) {
    ImdOptions options;
    change(options);
    return test::error_text<OptionError>(
        [&] { ImdServer(3, options, std::make_shared<Steering>()); });
  };
  EXPECT_EQ(refusal([](ImdOptions& options) { options.port = 65536; }),
            "imd port = 65536: must be from 0 to 65535");
  EXPECT_EQ(refusal([](ImdOptions& options) { options.version = 4; }),
            "imd version = 4: must be 2 or 3");
  EXPECT_EQ(refusal([](ImdOptions& options) { options.most_clients = 0; }),
            "imd most_clients = 0: must be from 1");
}

TEST(ImdServer, SaysWhereItCannotListen) {
  const ImdServer first(3, on_any_port(), std::make_shared<Steering>());
  ImdOptions taken;
  taken.port = first.port();
  EXPECT_EQ(test::error_text<FileError>([&] { ImdServer(3, taken, std::make_shared<Steering>()); }),
            "IMD on 127.0.0.1:" + std::to_string(first.port()) +
                ": cannot listen: Address already in use");
}

TEST(ImdServer, KnowsWhoReachesIt) {
  ImdOptions options = on_any_port();
  EXPECT_TRUE(ImdServer(3, options, std::make_shared<Steering>()).is_loopback());
  options.host = "0.0.0.0";
  EXPECT_FALSE(ImdServer(3, options, std::make_shared<Steering>()).is_loopback());
}

}  // namespace pliant::imd_server_test
