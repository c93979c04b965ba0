// SPDX-License-Identifier: MIT
#include "pliant/framework/joint_names.hpp"

#include <gtest/gtest.h>

#include "pliant/lab/examples/examples.hpp"
#include "support/error_text.hpp"

namespace pliant {
namespace joint_names_test {

TEST(JointNames, AreIndicesWhereThereAreNone) {
  const Framework framework = framework_of(chain(3));
  const JointNames names(framework);
  EXPECT_EQ(names.find("2", {"f.txt", 1}), 2u);
  EXPECT_EQ(names.word_for(1, "force file"), "1");
  EXPECT_EQ(test::error_text<InputError>([&] {
              names.find("3", {"f.txt", 1});
            }),
            "f.txt:1: joint: no joint is named \"3\"");
  EXPECT_EQ(test::error_text<InputError>([&] {
              names.find("-0x1", {"f.txt", 1});
            }),
            "f.txt:1: joint: no joint is named \"-0x1\"");
}

}  // namespace joint_names_test
}  // namespace pliant
