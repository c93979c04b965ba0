// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_exchange.hpp"

#include <gtest/gtest.h>

namespace pliant {
namespace imd_exchange_test {

/// Without sockets, in one thread: where the run would have to wait, it counts that and goes on.
class ImdExchanges : public testing::Test {
 protected:
  bool has_waited() {
    const int before = waits_;
    exchange_.wants(1);
    return waits_ > before;
  }

  int waits_ = 0;
  std::shared_ptr<Steering> steering_ = std::make_shared<Steering>();
  ImdExchange exchange_{{.should_stop = [this] { return ++waits_ > 0; }}, steering_};
};

TEST_F(ImdExchanges, HoldTheRunAsLongAsOneClientHasPausedIt) {
  ImdFollower& one = exchange_.begin_client();
  ImdFollower& other = exchange_.begin_client();
  EXPECT_FALSE(has_waited());
  exchange_.pause(one, true);
  exchange_.pause(other, true);
  EXPECT_TRUE(has_waited());
  exchange_.pause(one, false);
  EXPECT_TRUE(has_waited()) << "the other has not said RESUME";
  exchange_.end_client(other);
  EXPECT_FALSE(has_waited()) << "who leaves holds nothing";
}

TEST_F(ImdExchanges, HaveARateForEachClient) {
  ImdFollower& often = exchange_.begin_client();
  ImdFollower& seldom = exchange_.begin_client();
  exchange_.set_rate(often, 2);
  exchange_.set_rate(seldom, 3);
  exchange_.set_ready(often);
  exchange_.set_ready(seldom);
  EXPECT_FALSE(exchange_.wants(1));
  EXPECT_TRUE(exchange_.wants(2));
  exchange_.put(exchange_.buffer(), [](const ImdCounts&) { return Bytes(1); });
  EXPECT_EQ(often.frames.size(), 1u);
  EXPECT_TRUE(seldom.frames.empty());
  EXPECT_TRUE(exchange_.wants(3));
  EXPECT_FALSE(exchange_.wants(4)) << "a frame waits for it already";
}

TEST_F(ImdExchanges, TellEachClientOfItselfAlone) {
  ImdFollower& slow = exchange_.begin_client();
  ImdFollower& quick = exchange_.begin_client();
  exchange_.set_ready(quick);
  exchange_.wants(1);
  exchange_.set_ready(slow);
  exchange_.wants(2);
  exchange_.pull(quick, {{3, {1, 0, 0}}});
  std::vector<std::string> said;
  exchange_.put(exchange_.buffer(), [&](const ImdCounts& counts) {
    said.push_back(std::to_string(counts.forces) + " " + std::to_string(counts.dropped));
    return Bytes{};
  });
  EXPECT_EQ(said, (std::vector<std::string>{"0 1", "1 0"}));
}

TEST_F(ImdExchanges, MakeTheCoordinatesOnceForAll) {
  for (int k = 0; k < 3; ++k) exchange_.set_ready(exchange_.begin_client());
  ASSERT_TRUE(exchange_.wants(1));
  const auto coordinates = exchange_.buffer();
  exchange_.put(coordinates, [](const ImdCounts&) { return Bytes{}; });
  EXPECT_EQ(coordinates.use_count(), 4);
}

TEST_F(ImdExchanges, TellAtMostAHundredWarnings) {
  for (int k = 0; k < 200; ++k) exchange_.refuse("no " + std::to_string(k));
  std::vector<std::string> said;
  exchange_.tell({[&](Severity, std::string_view text) { said.emplace_back(text); }});
  ASSERT_EQ(said.size(), 100u);
  EXPECT_EQ(said[99], "no 99; further ones are only counted");
  EXPECT_EQ(exchange_.summary().refused, 200);
}

}  // namespace imd_exchange_test
}  // namespace pliant
