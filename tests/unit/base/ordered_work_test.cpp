// SPDX-License-Identifier: MIT
// Work on several threads that is shown in order.
#include "pliant/base/threads/ordered_work.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <thread>

namespace pliant::ordered_work_test {

struct Share {
  int number = -1, square = 0;
};

/// Shares 0 to count - 1; shows the squares.
std::vector<int> squares(std::size_t threads, int count, const std::function<void(int)>& before) {
  int next = 0;
  std::vector<int> shown;
  OrderedWork<Share>(threads, 3 * threads)
      .run([&](Share& share, std::size_t) { return (share.number = next++) < count; },
           [&](Share& share, std::size_t) {
             before(share.number);
             share.square = share.number * share.number;
           },
           [&](const Share& share) {
             shown.push_back(share.square);
             return true;
           });
  return shown;
}

TEST(OrderedWork, ShowsInOrderHoweverLongAShareTakes) {
  std::vector<int> expected;
  for (int k = 0; k < 40; ++k) expected.push_back(k * k);
  const auto first_takes_long = [](int k) {
    if (k % 10 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  };
  for (std::size_t threads : {1, 2, 7}) EXPECT_EQ(squares(threads, 40, first_takes_long), expected);
  EXPECT_TRUE(squares(4, 0, first_takes_long).empty());
}

TEST(OrderedWork, TakesNoMoreThanMayWait) {
  std::atomic<int> shown = 0, most = 0;
  int next = 0;
  OrderedWork<Share>(3, 5).run(
      [&](Share& share, std::size_t) {
        share.number = next++;
        most = std::max(most.load(), share.number - shown);
        return share.number < 100;
      },
      [](Share&, std::size_t) {}, [&](const Share&) { return ++shown, true; });
  EXPECT_EQ(shown, 100);
  EXPECT_LE(most, 5);
}

TEST(OrderedWork, EndsWhereItIsStopped) {
  int next = 0, shown = 0;
  OrderedWork<Share>(3, 9).run(
      [&](Share& share, std::size_t) { return (share.number = next++, true); },
      [](Share&, std::size_t) {}, [&](const Share&) { return ++shown < 20; });
  EXPECT_EQ(shown, 20);
}

TEST(OrderedWork, ThrowsWhatIsThrownInAnyThread) {
  for (const int failing : {0, 1, 2})
    for (std::size_t threads : {1, 4}) {
      int next = 0;
      const auto fail_at = [&](int place) {
        if (place == failing) throw std::runtime_error("share");
      };
      EXPECT_THROW(OrderedWork<Share>(threads, 8)
                       .run(
                           [&](Share& share, std::size_t) {
                             if (next == 12) fail_at(0);
                             return (share.number = next++) < 50;
                           },
                           [&](Share& share, std::size_t) {
                             if (share.number == 12) fail_at(1);
                           },
                           [&](const Share& share) {
                             if (share.number == 12) fail_at(2);
                             return true;
                           }),
                   std::runtime_error);
    }
}

TEST(OrderedWork, EndsIfAnotherThreadFailsWhileOneIsShown) {
  using std::chrono::milliseconds;
  std::atomic<bool> is_shown = false, has_failed = false;
  int next = 0;
  const auto take = [&](Share& share, std::size_t) { return share.number = next++, true; };
  const auto fail_beside = [&](const Share& share, std::size_t thread) {
    if (thread == 0 || share.number == 0) return;
    while (!is_shown) std::this_thread::sleep_for(milliseconds(1));
    has_failed = true;
    throw std::runtime_error("share");
  };
  const auto show_until_it_has_failed = [&](const Share&) {
    is_shown = true;
    for (int k = 0; k < 100 && !has_failed; ++k) std::this_thread::sleep_for(milliseconds(1));
    std::this_thread::sleep_for(milliseconds(5));
    return true;
  };
  OrderedWork<Share> work(2, 8);
  EXPECT_THROW(work.run(take, fail_beside, show_until_it_has_failed), std::runtime_error);
}

}  // namespace pliant::ordered_work_test
