// SPDX-License-Identifier: MIT
#include "pliant/base/words.hpp"

#include <gmock/gmock.h>

namespace pliant {
namespace words_test {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Words, AreSetApartByBlanksAndEndWithAComment) {
  EXPECT_THAT(words_of(" push  C1\t1 2 3\r"), ElementsAre("push", "C1", "1", "2", "3"));
  EXPECT_THAT(words_of("bar a b# tree"), ElementsAre("bar", "a", "b"));
  EXPECT_THAT(words_of("# nothing"), IsEmpty());
  EXPECT_THAT(words_of(" \t\r"), IsEmpty());
  EXPECT_THAT(words_of(""), IsEmpty());
}

TEST(Words, AreReadBackAsOne) {
  EXPECT_TRUE(is_word("C1'"));
  for (const char* text : {"", "C 1", "#", "a#b", "a\tb", "a\nb"}) EXPECT_FALSE(is_word(text));
}

}  // namespace words_test
}  // namespace pliant
