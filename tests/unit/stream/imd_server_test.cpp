// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_server.hpp"

#include <mutex>
#include <thread>

#include "imd_servers.hpp"
#include "support/test.hpp"

namespace pliant::imd_server_test {

using namespace test;
using Milliseconds = std::chrono::milliseconds;

constexpr std::int64_t for_ever = 1'000'000'000;
constexpr std::size_t forces_acting = 7;  ///< place among the energies

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
    const Bytes frame = next_frame(client);
    ASSERT_EQ(frame.size(), size_of_frame());
    ASSERT_EQ(step_of(frame), step);
  }
  EXPECT_TRUE(test::receive(client, 1).empty()) << "and no more";
}

TEST_F(ImdServers, ServeOneClientAfterAnother) {
  serve(ended_by_clients(true));
  std::jthread walker([this] { run(for_ever); });
  std::int64_t last = -1;
  // Closing a socket with frames in it that nobody read resets the connection, and the packet is
  // lost that was sent last: the client that ends the run stays until it has ended.
  Socket ender;
  for (int k = 0; k < 3; ++k) {
    Socket client = follow();
    const std::int64_t step = step_of(next_frame(client));
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
  ImdOptions options = ended_by_clients(true);
  options.patience.go = std::chrono::hours(1);
  serve(options);
  std::jthread walker([this] { run(for_ever); });
  const Socket silent = greeted();
  const Socket client = follow();
  EXPECT_EQ(step_of(next_frame(client)), 0);
  test::send_all(client, packet(ImdType::kill));
  walker.join();
  EXPECT_EQ(server_->close().clients, 1);
  EXPECT_TRUE(test::receive(silent, 1).empty()) << "it has been left";
}

TEST_F(ImdServers, NeverWaitForAClientThatDoesNotRead) {
  serve(ended_by_clients());
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
  serve(on_any_port());
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
  ASSERT_EQ(warnings_.size(), 6u);
  EXPECT_THAT(warnings_[2], testing::HasSubstr(" dropped: force on atom 77 of 6"));
}

TEST_F(ImdServers, PullAtJoints) {
  serve(ended_by_clients(true));
  std::vector<JointForce> acted;
  on_push_ = [&](const Push& push) {
    if (push.forces.size() > 1) acted = push.forces;
  };
  std::jthread walker([this] { run(for_ever, true); });
  const Socket client = follow();
  test::send_all(client, test::forces(1, {2}, {0, 0, 1e6F}));
  float pulled = 0.0F;
  while (pulled == 0.0F) {
    pulled = energy_of(next_frame(client), forces_acting);
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

TEST_F(ImdServers, ServeEightAtOnce) {
  serve(ended_by_clients());
  std::jthread walker([this] { run(for_ever); });
  std::vector<Socket> clients;
  for (int k = 0; k < 8; ++k) clients.push_back(follow());
  // The first reads nothing, the second one frame; the third pulls.
  const std::int64_t seen = step_of(next_frame(clients[1]));
  test::send_all(clients[2], test::forces(1, {2}, {0, 0, 5}));
  while (energy_of(next_frame(clients[2]), forces_acting) == 0.0F) continue;
  for (std::size_t k = 3; k < 8; ++k) {
    std::int64_t last = -1;
    for (int count = 0; count < 50; ++count) {
      const Bytes frame = next_frame(clients[k]);
      EXPECT_GT(step_of(frame), last);
      EXPECT_EQ(energy_of(frame, forces_acting), 0.0F) << "it does not pull";
      last = step_of(frame);
    }
    EXPECT_GT(last, seen);
  }
  test::send_all(clients[7], packet(ImdType::kill));
  walker.join();
  const ImdSummary served = server_->close();
  EXPECT_EQ(served.clients, 8);
  EXPECT_EQ(served.refused, 0);
  EXPECT_EQ(served.forces_taken, 1);
}

TEST_F(ImdServers, GiveTheSameBitsWhoeverLooks) {
  serve(on_any_port());
  run(2000);
  const State alone = state_;
  state_ = State{sketch_.positions};
  std::vector<Socket> clients;
  for (int k = 0; k < 8; ++k) clients.push_back(follow());
  while (server_->summary().clients < 8) std::this_thread::yield();
  run(2000);
  for (std::size_t joint = 0; joint < alone.positions.size(); ++joint)
    for (const auto member : {&Vec3::x, &Vec3::y, &Vec3::z})
      EXPECT_EQ(std::bit_cast<std::uint64_t>(state_.positions[joint].*member),
                std::bit_cast<std::uint64_t>(alone.positions[joint].*member));
  for (const Socket& client : clients) EXPECT_LE(step_of(next_frame(client)), 2000);
  clients.clear();
  EXPECT_EQ(server_->close().clients, 8);
}

TEST_F(ImdServers, DropWhoReadsNothingAndNobodyElse) {
  ImdOptions options = ended_by_clients();
  options.patience.reading = Milliseconds(50);
  serve(options);
  // For whom nothing waits, nothing can be late.
  const Socket seldom = follow();
  test::send_all(seldom, packet(ImdType::rate, for_ever));
  const Socket dead = follow();
  while (server_->summary().clients < 2) std::this_thread::yield();
  std::jthread walker([this] { run(for_ever); });
  while (server_->summary().refused == 0) std::this_thread::yield();
  test::send_all(seldom, packet(ImdType::kill));
  walker.join();
  EXPECT_EQ(server_->close().refused, 1);
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_THAT(warnings_[0], testing::HasSubstr(" dropped: read nothing for 0.05 s"));
}

TEST_F(ImdServers, TurnAwayWhoIsOneTooMany) {
  ImdOptions options = ended_by_clients();
  options.most_clients = 2;
  serve(options);
  std::vector<Socket> clients;
  for (int k = 0; k < 2; ++k) clients.push_back(follow());
  EXPECT_TRUE(test::receive(test::connect_to(server_->port()), 1).empty()) << "closed at once";
  clients.pop_back();
  Bytes greeting;
  while (greeting.empty()) {  // until it is noticed that one has gone
    clients.back() = test::connect_to(server_->port());
    greeting = test::receive(clients.back(), 8);
  }
  clients.clear();
  server_->close();
  ASSERT_FALSE(warnings_.empty());
  EXPECT_THAT(warnings_[0],
              testing::HasSubstr(" turned away: 2 are connected, and no more are served"));
}

/// Two hands on one joint, and one of them on another: what acts is the sum.
TEST_F(ImdServers, AddUpThePullsOfAllAndForgetThoseOfWhoHasGone) {
  serve(ended_by_clients(true));
  std::mutex mutex;
  std::vector<JointForce> acting;
  on_push_ = [&](const Push& push) {
    const std::lock_guard hold(mutex);
    acting = push.forces;
  };
  std::jthread walker([this] { run(for_ever, true); });
  const Socket watcher = follow();
  const auto wait_for = [&](const std::vector<JointForce>& expected) {
    const auto is_there = [&] {
      const std::lock_guard hold(mutex);
      std::vector<JointForce> pulls = acting;
      // The random push of the run, whose size is zero.
      std::erase_if(pulls, [](const JointForce& pull) { return norm(pull.force) == 0.0; });
      return pulls.size() == expected.size() &&
             std::equal(pulls.begin(), pulls.end(), expected.begin(), [](auto& a, auto& b) {
               return a.joint == b.joint && norm(a.force - b.force) == 0.0;
             });
    };
    for (int k = 0; k < 100'000 && !is_there(); ++k) next_frame(watcher);
    return is_there();
  };
  Socket one = follow();
  test::send_all(one, test::forces(1, {2}, {1, 0, 0}) + packet(ImdType::rate, for_ever));
  EXPECT_TRUE(wait_for({{2, {1, 0, 0}}}));
  const Socket other = follow();
  test::send_all(other,
                 test::forces(2, {4, 2}, {0, 2, 0, 0, 0, 3}) + packet(ImdType::rate, for_ever));
  EXPECT_TRUE(wait_for({{2, {1, 0, 3}}, {4, {0, 2, 0}}}));
  one = Socket();
  EXPECT_TRUE(wait_for({{4, {0, 2, 0}}, {2, {0, 0, 3}}}));
  test::send_all(watcher, packet(ImdType::kill));
  walker.join();
}

TEST(ImdServer, RefusesOptionsThatMakeNoSense) {
  const std::pair<const char*, ImdOptions> cases[] = {
      {"imd port = 65536: must be from 0 to 65535", {.port = 65536}},
      {"imd version = 4: must be 2 or 3", {.version = 4}},
      {"imd most_clients = 0: must be from 1", {.most_clients = 0}}};
  for (const auto& [text, options] : cases)
    EXPECT_ERROR(OptionError, text, ImdServer(3, options, std::make_shared<Steering>()));
}

TEST(ImdServer, SaysWhereItCannotListen) {
  const ImdServer first(3, on_any_port(), std::make_shared<Steering>());
  EXPECT_ERROR(FileError,
               "IMD on 127.0.0.1:" + std::to_string(first.port()) +
                   ": cannot listen: Address already in use",
               ImdServer(3, {.port = first.port()}, std::make_shared<Steering>()));
}

TEST(ImdServer, KnowsWhoReachesIt) {
  ImdOptions options = on_any_port();
  EXPECT_TRUE(ImdServer(3, options, std::make_shared<Steering>()).is_loopback());
  options.host = "0.0.0.0";
  EXPECT_FALSE(ImdServer(3, options, std::make_shared<Steering>()).is_loopback());
}

}  // namespace pliant::imd_server_test
