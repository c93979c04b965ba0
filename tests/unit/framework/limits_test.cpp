// SPDX-License-Identifier: MIT
#include "pliant/framework/limits.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pliant/base/error.hpp"
#include "pliant/framework/framework.hpp"
#include "support/error_text.hpp"

namespace pliant {
namespace limits_test {

std::string fault_of(const Limit& limit) {
  return test::error_text<InputError>([&] {
    Framework({.joint_count = 4, .bars = {{0, 1}}, .rest_lengths = {1.5}, .limits = {limit}});
  });
}

TEST(Limit, ItsExcessIsSigned) {
  const Limit limit{.a = 0, .b = 1, .least = 2.0, .most = 3.0};
  EXPECT_EQ(excess(limit, 3.5), 0.5);
  EXPECT_EQ(excess(limit, 1.5), -0.5);
  EXPECT_EQ(excess(limit, 2.0), 0.0);
  EXPECT_EQ(excess(limit, 3.0), 0.0);
}

TEST(Limit, KindsHaveNames) {
  for (const LimitKindEntry& row : limit_kinds()) EXPECT_EQ(find_limit_kind(row.name), row.kind);
  EXPECT_THROW(find_limit_kind("cable"), OptionError);
}

TEST(Limit, WhatCannotBeIsRefused) {
  EXPECT_EQ(fault_of({.a = 0, .b = 2, .most = 1.0}), test::no_error);
  EXPECT_EQ(fault_of({.a = 0, .b = 9}), "limit 0 joins joints 0 and 9 but there are 4 joints");
  EXPECT_EQ(fault_of({.a = 2, .b = 2}), "limit 0 joins joint 2 to itself");
  EXPECT_EQ(fault_of({.a = 1, .b = 0}), "limit 1 - 0 has a bar already, of 1.5 Angstrom");
  EXPECT_EQ(fault_of({.a = 0, .b = 2, .least = 2.0, .most = 1.0}),
            "limit 0 - 2 has least distance 2 above most 1 Angstrom");
  EXPECT_EQ(fault_of({.a = 0, .b = 2, .least = -1.0}),
            "limit 0 - 2 has least distance -1: must be from 0 to 1e150 Angstrom");
  EXPECT_EQ(fault_of({.a = 0, .b = 2, .most = std::nan("")}),
            "limit 0 - 2 has most distance nan: must be above 0, up to 1e150 Angstrom or infinite");
  EXPECT_EQ(fault_of({.a = 0, .b = 2, .energy = std::nan("")}),
            "limit 0 - 2 has energy nan: must be finite");
}

TEST(Limit, JointsKnowTheirLimits) {
  const Framework framework(
      {.joint_count = 4, .limits = {{.a = 0, .b = 2}, {.a = 3, .b = 0}, {.a = 2, .b = 3}}});
  const auto at = framework.limits_at(0);
  EXPECT_EQ(std::vector<LimitIndex>(at.begin(), at.end()), (std::vector<LimitIndex>{0, 1}));
  EXPECT_TRUE(framework.limits_at(1).empty());
}

}  // namespace limits_test
}  // namespace pliant
