// SPDX-License-Identifier: MIT
#include "pliant/base/graphs/grouped.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <utility>

namespace pliant {
namespace grouped_test {

using Slotted = std::pair<std::size_t, int>;

std::vector<int> list(std::span<const int> things) { return {things.begin(), things.end()}; }

RC_GTEST_PROP(Grouped, HasTheThingsOfEachSlotInTheirOrder, ()) {
  const auto slots = *rc::gen::inRange<std::size_t>(1, 8);
  const auto all = *rc::gen::container<std::vector<Slotted>>(
      rc::gen::pair(rc::gen::inRange<std::size_t>(0, slots), rc::gen::arbitrary<int>()));
  const Grouped<int> grouped(slots, [&](const auto& put) {
    for (const auto& [slot, thing] : all) put(slot, thing);
  });
  std::vector<std::vector<int>> expected(slots);
  for (const auto& [slot, thing] : all) expected[slot].push_back(thing);
  RC_ASSERT(grouped.size() == slots);
  RC_ASSERT(grouped.things().size() == all.size());
  Grouped<int, std::size_t> added;
  for (std::size_t k = 0; k < slots; ++k) {
    RC_ASSERT(list(grouped.at(k)) == expected[k]);
    RC_ASSERT(grouped.at(k).data() == grouped.things().data() + grouped.begin_of(k));
    added.add(expected[k]);
    RC_ASSERT(list(added.at(k)) == expected[k]);
  }
  RC_ASSERT(added.size() == slots);
}

TEST(Grouped, BeginsWithoutSlots) {
  EXPECT_EQ(Grouped<int>().size(), 0u);
  EXPECT_TRUE(Grouped<int>().things().empty());
  const Grouped<int> none(0, [](const auto&) {});
  EXPECT_EQ(none.size(), 0u);
}

TEST(Grouped, GivesThingsToChange) {
  Grouped<int> grouped;
  grouped.add(std::vector<int>{1, 2});
  grouped.add(std::vector<int>{3});
  for (int& thing : grouped.at(0)) thing *= 10;
  for (int& thing : grouped.things()) ++thing;
  EXPECT_EQ(list(std::as_const(grouped).things()), (std::vector<int>{11, 21, 4}));
}

}  // namespace grouped_test
}  // namespace pliant
