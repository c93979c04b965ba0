// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_session.hpp"

#include <gtest/gtest.h>

#include <sys/socket.h>

#include <thread>

#include "imd_client.hpp"
#include "support/error_text.hpp"

namespace pliant {
namespace imd_session_test {

using test::bytes_of;
using test::operator+;
using test::packet;
using Milliseconds = std::chrono::milliseconds;

constexpr std::size_t atoms = 5;

/// A session whose client is the test itself, in one thread: what the client has sent is there when
/// step() looks.
class ImdSessions : public testing::Test {
 protected:
  void begin(int version = 3, bool waits = false, const ImdPatience& patience = {}) {
    session_.reset();  // which speaks to the exchange to its end
    exchange_ = std::make_unique<ImdExchange>(ImdExchange::Options{waits, 1, {}}, steering_);
    auto [mine, other] = test::socket_pair();
    client_ = std::move(other);
    session_ =
        std::make_unique<ImdSession>(Peer{std::move(mine), "test"}, ImdFormat{version, false},
                                     atoms, *exchange_, patience, &others_);
    greeting_ = imd_greeting({version, false});
  }

  void send(const Bytes& bytes) { test::send_all(client_, bytes); }

  /// The greeting is out and GO has come.
  void follow() {
    send(packet(ImdType::go));
    while (exchange_->summary().clients == 0) ASSERT_TRUE(session_->step());
    EXPECT_EQ(test::receive(client_, greeting_.size()), greeting_);
  }

  /// What a session that has been sent this is dropped for.
  std::string refusal(const Bytes& bytes) {
    send(bytes);
    return test::error_text<InputError>([&] {
      for (int k = 0; k < 10; ++k)
        if (!session_->step()) return;
    });
  }

  std::shared_ptr<Steering> steering_ = std::make_shared<Steering>();
  std::unique_ptr<ImdExchange> exchange_;
  Descriptor client_;
  const Descriptor others_ = make_wake();  ///< can be read from once it has been woken
  std::unique_ptr<ImdSession> session_;
  Bytes greeting_;
};

TEST_F(ImdSessions, SendFramesAfterGo) {
  begin();
  EXPECT_FALSE(exchange_->wants(0)) << "nobody follows";
  follow();
  EXPECT_TRUE(exchange_->wants(1));
  exchange_->put(bytes_of("0102"));
  exchange_->put(bytes_of("03"));
  while (exchange_->summary().frames_sent < 2) ASSERT_TRUE(session_->step());
  EXPECT_EQ(test::receive(client_, 3), bytes_of("010203"));
}

TEST_F(ImdSessions, EndAtDisconnectAndWhenTheClientGoes) {
  begin();
  follow();
  send(packet(ImdType::disconnect));
  EXPECT_FALSE(session_->step());
  begin();
  follow();
  client_ = Descriptor();
  EXPECT_FALSE(session_->step());
  session_.reset();
  EXPECT_FALSE(exchange_->wants(1)) << "nobody follows any more";
}

TEST_F(ImdSessions, HalfCloseAtTheEndAndSendWhatIsLeft) {
  begin();
  follow();
  for (int k = 0; k < 10; ++k) exchange_->put(bytes_of("ab"));
  send(packet(ImdType::pause));  // never read by a server that only closes: then RST
  exchange_->finish();
  std::thread server([&] {
    while (session_->step()) continue;
    session_.reset();
  });
  EXPECT_EQ(test::receive_all(client_).size(), 10u) << "all frames, then the end of the stream";
  shutdown(client_.get(), SHUT_RDWR);
  server.join();
}

TEST_F(ImdSessions, PauseAndResumeAsVersion3Says) {
  begin();
  follow();
  send(packet(ImdType::pause) + packet(ImdType::pause));
  ASSERT_TRUE(session_->step());
  std::atomic<bool> is_through{false};
  std::thread run([&] {
    exchange_->wants(1);
    is_through = true;
  });
  EXPECT_FALSE(is_through) << "a second PAUSE changes nothing";
  send(packet(ImdType::resume));
  ASSERT_TRUE(session_->step());
  run.join();
  EXPECT_GE(exchange_->summary().seconds_waited, 0.0);
}

TEST_F(ImdSessions, PauseTwiceIsResumeInVersion2) {
  begin(2);
  follow();
  send(packet(ImdType::pause));
  ASSERT_TRUE(session_->step());
  std::thread run([&] { exchange_->wants(1); });
  send(packet(ImdType::pause));
  ASSERT_TRUE(session_->step());
  run.join();
}

TEST_F(ImdSessions, OfAClientThatGoesFreeTheRun) {
  begin();
  follow();
  send(packet(ImdType::pause));
  ASSERT_TRUE(session_->step());
  std::thread run([&] { EXPECT_FALSE(exchange_->wants(1)); });
  client_ = Descriptor();
  EXPECT_FALSE(session_->step());
  session_.reset();
  run.join();
}

TEST_F(ImdSessions, SendAtTheRateThatIsAsked) {
  begin();
  follow();
  send(packet(ImdType::rate, 10));
  ASSERT_TRUE(session_->step());
  EXPECT_FALSE(exchange_->wants(15));
  EXPECT_TRUE(exchange_->wants(20));
  send(packet(ImdType::rate, -3));
  ASSERT_TRUE(session_->step());
  EXPECT_TRUE(exchange_->wants(21)) << "below 1: as at first";
}

TEST_F(ImdSessions, KillOnlyIfAsked) {
  begin();
  follow();
  EXPECT_FALSE(exchange_->was_killed());
  send(packet(ImdType::kill));
  ASSERT_TRUE(session_->step());
  EXPECT_TRUE(exchange_->was_killed());
}

TEST_F(ImdSessions, WaitForAClientFromThenOn) {
  begin();
  follow();
  send(packet(ImdType::wait, 1) + packet(ImdType::disconnect));
  EXPECT_FALSE(session_->step());
  session_.reset();
  std::thread run([&] { EXPECT_FALSE(exchange_->wants(1)); });
  exchange_->set_waits(false);
  run.join();
}

TEST_F(ImdSessions, DropFramesThatAClientIsTooSlowFor) {
  begin();
  follow();
  std::int64_t wanted = 0;
  for (int step = 0; step < 100; ++step)
    if (exchange_->wants(step)) {
      ++wanted;
      exchange_->put(bytes_of("00"));
    }
  EXPECT_EQ(wanted, 16);
  EXPECT_EQ(exchange_->summary().frames_dropped, 84);
  EXPECT_EQ(exchange_->counts().dropped, 84);
}

TEST_F(ImdSessions, PullUntilTheClientGoes) {
  begin();
  follow();
  send(test::forces(2, {1, 4}, {1, 0, 0, 0, 2, 0}));
  ASSERT_TRUE(session_->step());
  EXPECT_EQ(exchange_->counts().forces, 2);
  FrameworkParts parts;
  parts.joint_count = atoms;
  const Framework framework(std::move(parts));
  State state{std::vector<Vec3>(atoms)};
  Push push;
  const PushCall call{framework, {}, 0.01, 0.0, state.previous};
  steering_->push(call, state, push);
  ASSERT_EQ(push.forces.size(), 2u);
  EXPECT_EQ(push.forces[1].joint, 4u);
  session_.reset();
  push.clear();
  steering_->push(call, state, push);
  EXPECT_TRUE(push.forces.empty());
}

TEST_F(ImdSessions, AreOverForWhatNoClientDoes) {
  begin();
  EXPECT_EQ(refusal(packet(ImdType::pause)), "said something before GO");
  begin();
  EXPECT_EQ(refusal(bytes_of("474554202f204854")),
            "packet of type 1195725856, which no client of IMD version 3 sends");
  begin();
  follow();
  EXPECT_EQ(refusal(packet(ImdType::go)), "said GO twice");
  begin();
  follow();
  EXPECT_EQ(refusal(packet(ImdType::forces, -5)), "forces on -5 atoms of 5");
}

TEST_F(ImdSessions, AreOverForSilence) {
  ImdPatience short_of_it;
  short_of_it.go = short_of_it.go_alone = short_of_it.packet = Milliseconds(5);
  begin(3, false, short_of_it);
  EXPECT_EQ(refusal({}), "did not say GO in time");
  ImdPatience for_packets;
  for_packets.packet = Milliseconds(5);
  begin(3, false, for_packets);
  follow();
  EXPECT_EQ(refusal(bytes_of("00000006")), "stopped in the middle of a packet");
  begin(3, false, for_packets);
  follow();
  Bytes forces = test::forces(1, {1}, {1, 2, 3});
  forces.pop_back();
  EXPECT_EQ(refusal(forces), "stopped in the middle of a packet");
}

TEST_F(ImdSessions, GiveWayToOthersOnlyIfTheyDoNotSayGo) {
  const ImdPatience at_once{Milliseconds(0), Milliseconds(60'000), Milliseconds(60'000), {}};
  begin(3, false, at_once);
  wake(others_);
  EXPECT_EQ(refusal({}), "did not say GO in time, and another client waits");
  begin(3, false, at_once);
  follow();
  for (int k = 0; k < 5; ++k) {
    send(packet(ImdType::rate, 1));  // else a step would wait
    EXPECT_TRUE(session_->step());
  }
}

}  // namespace imd_session_test
}  // namespace pliant
