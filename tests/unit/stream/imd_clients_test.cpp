// SPDX-License-Identifier: MIT
// Several clients of one run at once.
#include <gtest/gtest.h>

#include <bit>
#include <mutex>
#include <thread>

#include "imd_servers.hpp"

namespace pliant::imd_clients_test {

using test::operator+;
using test::energy_of;
using test::ImdServers;
using test::on_any_port;
using test::packet;
using test::step_of;
using Milliseconds = std::chrono::milliseconds;

constexpr std::int64_t for_ever = 1'000'000'000;
constexpr std::size_t forces_acting = 7;  ///< place among the energies

ImdOptions ended_by_clients() {
  ImdOptions options = on_any_port();
  options.patience.reading = std::chrono::hours(1);
  options.patience.finish = Milliseconds(20);
  return options;
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
  std::vector<std::string> warnings;
  ImdOptions options = ended_by_clients();
  options.patience.reading = Milliseconds(50);
  options.log.function = [&](Severity, std::string_view text) { warnings.emplace_back(text); };
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
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find(" dropped: read nothing for 0.05 s"), std::string::npos)
      << warnings[0];
}

TEST_F(ImdServers, TurnAwayWhoIsOneTooMany) {
  std::vector<std::string> warnings;
  ImdOptions options = ended_by_clients();
  options.most_clients = 2;
  options.log.function = [&](Severity, std::string_view text) { warnings.emplace_back(text); };
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
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].find(" turned away: 2 are connected, and no more are served"),
            std::string::npos)
      << warnings[0];
}

/// Two hands on one joint, and one of them on another: what acts is the sum.
TEST_F(ImdServers, AddUpThePullsOfAllAndForgetThoseOfWhoHasGone) {
  ImdOptions options = ended_by_clients();
  options.wait = true;
  serve(options);
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

}  // namespace pliant::imd_clients_test
