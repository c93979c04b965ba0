// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_session.hpp"

#include <sys/socket.h>

#include <thread>

#include "imd_client.hpp"
#include "support/test.hpp"

namespace pliant::imd_session_test {

using namespace test;
using Milliseconds = std::chrono::milliseconds;
using Clock = ImdSession::Clock;

constexpr std::size_t atoms = 5;

/// A session whose client is the test itself, in one thread: what the client has sent is there when
/// step() looks.
class ImdSessions : public testing::Test {
 protected:
  void begin(int version = 3, const ImdPatience& patience = {}, bool can_kill = true) {
    session_.reset();  // which speaks to the exchange to its end
    exchange_ = std::make_unique<ImdExchange>(ImdExchange::Options{false, can_kill, {}}, steering_);
    auto [mine, other] = test::socket_pair();
    client_ = std::move(other);
    session_ = std::make_unique<ImdSession>(Peer{std::move(mine), "test"},
                                            ImdFormat{version, false}, atoms, *exchange_, patience);
    greeting_ = imd_greeting({version, false});
  }

  /// What the server does for each session in turn.
  bool step() {
    std::array<SocketEvents, 2> waits{{{exchange_->woken().to_wait_for()}, session_->events()}};
    const auto left = std::chrono::ceil<Milliseconds>(session_->deadline() - Clock::now());
    const bool has_deadline = session_->deadline() != Clock::time_point::max();
    wait_for(waits, has_deadline ? std::max(0, int(left.count())) : -1);
    if (waits[0].can_read) exchange_->woken().sleep_again();
    return session_->step(waits[1]);
  }

  /// Steps of the session until it can be given a frame of this step of the run; gives it.
  void show(std::int64_t step_of_run, const Bytes& coordinates) {
    while (!exchange_->wants(step_of_run)) ASSERT_TRUE(step());
    exchange_->put(std::make_shared<Bytes>(coordinates), [](const ImdCounts&) { return Bytes{}; });
  }

  void send(const Bytes& bytes) { test::send_all(client_, bytes); }

  /// A session that has begun, the greeting is out and GO has come.
  template <class... How>
  void follow(const How&... how) {
    begin(how...);
    send(packet(ImdType::go));
    while (exchange_->summary().clients == 0) ASSERT_TRUE(step());
    EXPECT_EQ(test::receive(client_, greeting_.size()), greeting_);
  }

  /// What a session that has been sent this is dropped for.
  std::string refusal(const Bytes& bytes) {
    send(bytes);
    return test::error_text<InputError>([&] {
      for (int k = 0; k < 10; ++k)
        if (!step()) return;
    });
  }

  std::shared_ptr<Steering> steering_ = std::make_shared<Steering>();
  std::unique_ptr<ImdExchange> exchange_;
  Socket client_;
  std::unique_ptr<ImdSession> session_;
  Bytes greeting_;
};

TEST_F(ImdSessions, SendFramesAfterGo) {
  begin();
  EXPECT_FALSE(exchange_->wants(0)) << "nobody follows";
  follow();
  show(1, bytes_of("0102"));
  show(2, bytes_of("03"));
  while (exchange_->summary().frames_sent < 2) ASSERT_TRUE(step());
  EXPECT_EQ(test::receive(client_, 3), bytes_of("010203"));
}

TEST_F(ImdSessions, EndAtDisconnectAndWhenTheClientGoes) {
  follow();
  send(packet(ImdType::disconnect));
  EXPECT_FALSE(step());
  follow();
  client_ = Socket();
  EXPECT_FALSE(step());
  session_.reset();
  EXPECT_FALSE(exchange_->wants(1)) << "nobody follows any more";
}

TEST_F(ImdSessions, HalfCloseAtTheEndAndSendWhatIsLeft) {
  follow();
  show(1, Bytes(10, std::byte{7}));
  send(packet(ImdType::pause));  // never read by a server that only closes: then RST
  exchange_->finish();
  std::thread server([&] {
    while (step()) continue;
    session_.reset();
  });
  EXPECT_EQ(test::receive_all(client_).size(), 10u) << "the frame, then the end of the stream";
  shutdown(static_cast<int>(client_.get()), SHUT_RDWR);
  server.join();
}

TEST_F(ImdSessions, PauseAndResumeAsVersion3Says) {
  follow();
  send(packet(ImdType::pause) + packet(ImdType::pause));
  ASSERT_TRUE(step());
  std::atomic<bool> is_through{false};
  std::thread run([&] {
    exchange_->wants(1);
    is_through = true;
  });
  EXPECT_FALSE(is_through) << "a second PAUSE changes nothing";
  send(packet(ImdType::resume));
  ASSERT_TRUE(step());
  run.join();
  EXPECT_GE(exchange_->summary().seconds_waited, 0.0);
}

TEST_F(ImdSessions, PauseTwiceIsResumeInVersion2) {
  follow(2);
  send(packet(ImdType::pause));
  ASSERT_TRUE(step());
  std::thread run([&] { exchange_->wants(1); });
  send(packet(ImdType::pause));
  ASSERT_TRUE(step());
  run.join();
}

TEST_F(ImdSessions, OfAClientThatGoesFreeTheRun) {
  follow();
  send(packet(ImdType::pause));
  ASSERT_TRUE(step());
  std::thread run([&] { EXPECT_FALSE(exchange_->wants(1)); });
  client_ = Socket();
  EXPECT_FALSE(step());
  session_.reset();
  run.join();
}

TEST_F(ImdSessions, SendAtTheRateThatIsAsked) {
  follow();
  send(packet(ImdType::rate, 10));
  ASSERT_TRUE(step());
  while (!exchange_->wants(20)) ASSERT_TRUE(step());
  EXPECT_FALSE(exchange_->wants(15));
  EXPECT_TRUE(exchange_->wants(30));
  send(packet(ImdType::rate, -3));
  ASSERT_TRUE(step());
  EXPECT_TRUE(exchange_->wants(31)) << "below 1: as at first";
}

TEST_F(ImdSessions, KillOnlyIfAskedWhereClientsMay) {
  follow();
  EXPECT_FALSE(exchange_->was_killed());
  send(packet(ImdType::kill));
  ASSERT_TRUE(step());
  EXPECT_TRUE(exchange_->was_killed());
  follow(3, ImdPatience{}, false);
  send(packet(ImdType::kill));
  ASSERT_TRUE(step());
  EXPECT_FALSE(exchange_->was_killed());
  std::string said;
  exchange_->tell({[&](Severity, std::string_view text) { said = text; }});
  EXPECT_EQ(said,
            "IMD client test asked the run to end (KILL): it goes on, as clients of other machines "
            "can reach it");
  EXPECT_EQ(exchange_->summary().refused, 0);
}

TEST_F(ImdSessions, WaitForAClientFromThenOn) {
  follow();
  send(packet(ImdType::wait, 1) + packet(ImdType::disconnect));
  EXPECT_FALSE(step());
  session_.reset();
  std::thread run([&] { EXPECT_FALSE(exchange_->wants(1)); });
  exchange_->set_waits(false);
  run.join();
}

/// What fits into no socket: the client has to read for the rest to be sent.
const Bytes large(std::size_t{1} << 22, std::byte{1});

TEST_F(ImdSessions, GiveASlowClientTheNewestFrame) {
  follow();
  show(0, large);
  ASSERT_TRUE(step());
  const std::int64_t dropped = exchange_->summary().frames_dropped;
  for (int step_of_run = 1; step_of_run < 100; ++step_of_run)
    EXPECT_FALSE(exchange_->wants(step_of_run)) << "it would wait, and be old when it is sent";
  EXPECT_EQ(exchange_->summary().frames_dropped - dropped, 99);
  std::thread client([&] { test::receive(client_, large.size()); });
  while (exchange_->summary().frames_sent < 1) ASSERT_TRUE(step());
  client.join();
  show(100, bytes_of("64"));
  while (exchange_->summary().frames_sent < 2) ASSERT_TRUE(step());
  EXPECT_EQ(test::receive(client_, 1), bytes_of("64"));
}

TEST_F(ImdSessions, AreOverForAClientThatReadsNothing) {
  ImdPatience short_of_it;
  short_of_it.reading = Milliseconds(50);
  follow(3, short_of_it);
  show(0, large);
  EXPECT_EQ(refusal({}), "read nothing for 0.05 s");
}

/// imdclient holds the run as long as its analysis has enough to do, and reads nothing then.
TEST_F(ImdSessions, AreNotOverForAClientThatReadsNothingWhileItHoldsTheRun) {
  ImdPatience short_of_it;
  short_of_it.reading = Milliseconds(50);
  follow(3, short_of_it);
  show(0, large);
  send(packet(ImdType::pause));
  SocketEvents said = session_->events();
  said.can_read = true;
  EXPECT_NE(session_->deadline(), Clock::time_point::max());
  EXPECT_TRUE(session_->step(said));
  EXPECT_EQ(session_->deadline(), Clock::time_point::max());
  send(packet(ImdType::resume));
  EXPECT_EQ(refusal({}), "read nothing for 0.05 s");
}

TEST_F(ImdSessions, PullUntilTheClientGoes) {
  follow();
  send(test::forces(2, {1, 4}, {1, 0, 0, 0, 2, 0}));
  ASSERT_TRUE(step());
  const Framework framework({.joint_count = atoms});
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
  follow();
  EXPECT_EQ(refusal(packet(ImdType::go)), "said GO twice");
  follow();
  EXPECT_EQ(refusal(packet(ImdType::forces, -5)), "forces on -5 atoms of 5");
}

TEST_F(ImdSessions, AreOverForSilence) {
  ImdPatience short_of_it;
  short_of_it.go = Milliseconds(5);
  begin(3, short_of_it);
  EXPECT_EQ(refusal({}), "did not say GO in time");
  ImdPatience for_packets;
  for_packets.packet = Milliseconds(5);
  follow(3, for_packets);
  EXPECT_EQ(refusal(bytes_of("00000006")), "stopped in the middle of a packet");
  follow(3, for_packets);
  Bytes forces = test::forces(1, {1}, {1, 2, 3});
  forces.pop_back();
  EXPECT_EQ(refusal(forces), "stopped in the middle of a packet");
}

}  // namespace pliant::imd_session_test
