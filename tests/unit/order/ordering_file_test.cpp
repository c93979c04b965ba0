// SPDX-License-Identifier: MIT
#include "pliant/order/ordering_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "pliant/base/error.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "support/error_text.hpp"
#include "support/temp_directory.hpp"

namespace pliant {
namespace ordering_file_test {

/// Joints a, b, c, d; bars ab, bc, ca, cd.
const Framework& kite() {
  static const Framework framework = [] {
    AtomTable atoms;
    atoms.residues = {{"", 1, ' ', ""}};
    for (const char* name : {"a", "b", "c", "d"}) {
      atoms.names.emplace_back(name);
      atoms.elements.push_back(0);
      atoms.residue_of.push_back(0);
      atoms.serials.push_back(std::int64_t(atoms.names.size()));
    }
    FrameworkParts parts;
    parts.joint_count = 4;
    parts.bars = {{0, 1}, {1, 2}, {2, 0}, {2, 3}};
    parts.rest_lengths = {1, 1, 1, 1};
    parts.atoms = std::make_shared<AtomTable>(std::move(atoms));
    return Framework(std::move(parts));
  }();
  return framework;
}

Ordering parse(std::string_view text, const Framework& framework = kite()) {
  return parse_ordering_file({"o.txt", text}, framework);
}

std::string refusal(std::string_view lines) {
  return test::error_text<InputError>([&] { parse("pliant-ordering 1\n" + std::string(lines)); });
}

constexpr std::string_view plain =
    "pliant-ordering 1\n"
    "# from c\n"
    "bar c b tree\n"
    "bar c a tree      # the far end is a\n"
    "\n"
    "bar c d tree\n"
    "bar b a non_tree";

void expect_plain(const Ordering& ordering) {
  ASSERT_EQ(ordering.size(), 4u);
  const Ordering expected{{1, 2, true}, {2, 2, true}, {3, 2, true}, {0, 1, false}};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(ordering[k].bar, expected[k].bar);
    EXPECT_EQ(ordering[k].near, expected[k].near);
    EXPECT_EQ(ordering[k].is_tree, expected[k].is_tree);
  }
}

TEST(OrderingFile, ReadsBarsFromTheirNearJoints) { expect_plain(parse(plain)); }

TEST(OrderingFile, TakesCarriageReturnsAndIndices) {
  std::string text;
  for (char c : plain) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_plain(parse(text));
  expect_plain(
      parse("pliant-ordering 1\nbar 2 1 tree\nbar 2 0 tree\nbar c 3 tree\nbar 1 0 non_tree\n"));
}

TEST(OrderingFile, IsReadBackToTheSameVisits) {
  const std::string text = write_ordering_file(parse(plain), kite());
  EXPECT_EQ(text,
            "pliant-ordering 1\nbar c b tree\nbar c a tree\nbar c d tree\nbar b a non_tree\n");
  expect_plain(parse(text));
}

TEST(OrderingFile, SaysWhatItExpectedFirst) {
  const auto error = [](std::string_view text) {
    return test::error_text<InputError>([&] { parse(text); });
  };
  EXPECT_EQ(error(""), "o.txt: expected the line \"pliant-ordering 1\" first, found no text");
  EXPECT_EQ(error("\npliant-ordering 2"),
            "o.txt:2: expected \"pliant-ordering 1\", found \"pliant-ordering 2\"");
  EXPECT_EQ(error("pliant-forces 1\x1b[2J"),
            "o.txt:1: expected \"pliant-ordering 1\", found \"pliant-forces 1\\x1b[2J\"");
}

TEST(OrderingFile, NamesTheFieldThatIsWrong) {
  EXPECT_EQ(refusal("bar a zz tree"), "o.txt:2: joint: no joint is named \"zz\"");
  EXPECT_EQ(refusal("bar 4 a tree"), "o.txt:2: joint: no joint is named \"4\"");
  EXPECT_EQ(refusal("bar a d tree"), "o.txt:2: bar \"a\" - \"d\": the framework has no such bar");
  EXPECT_EQ(refusal("bar a a tree"), "o.txt:2: bar \"a\" - \"a\": the framework has no such bar");
  EXPECT_EQ(refusal("bar a b twig"), "o.txt:2: kind: expected tree or non_tree, found \"twig\"");
  EXPECT_EQ(refusal("bar a b"),
            "o.txt:2: bar: expected near joint, far joint and kind (tree or non_tree), found 2 "
            "fields");
  EXPECT_EQ(refusal("rod a b tree"), "o.txt:2: expected bar, found \"rod\"");
}

TEST(OrderingFile, WantsEachBarOnce) {
  EXPECT_EQ(refusal("bar a b tree\n\nbar b a tree"),
            "o.txt:4: bar \"b\" - \"a\" is given twice, first in line 2");
  EXPECT_EQ(refusal("bar a b tree\nbar c d tree\nbar c a non_tree"),
            "o.txt: bar b - c is missing: expected 4 bars, found 3");
}

TEST(OrderingFile, IsWrittenOnlyIfItCouldBeRead) {
  const auto error = [](const Ordering& ordering) {
    return test::error_text<InputError>([&] { write_ordering_file(ordering, kite()); });
  };
  EXPECT_EQ(error({{0, 0, true}}), "ordering file: bar b - c is missing");
  EXPECT_EQ(error({{0, 3, true}}), "ordering file: bar a - b has a near joint that is not its end");
  EXPECT_EQ(error({{7, 0, true}}), "ordering file: bar 7 unknown");
}

TEST(ReadOrderingFile, ReadsFilesAndNamesThemInErrors) {
  const test::TempDirectory directory;
  const std::filesystem::path path = directory / "ordering.txt";
  std::ofstream(path) << "\xef\xbb\xbf" << plain;
  expect_plain(read_ordering_file(path, kite()));
  std::ofstream(path) << "nothing";
  EXPECT_EQ(test::error_text<InputError>([&] { read_ordering_file(path, kite()); }),
            path.string() + ":1: expected \"pliant-ordering 1\", found \"nothing\"");
  std::filesystem::remove(path);
  EXPECT_THROW(read_ordering_file(path, kite()), FileError);
}

}  // namespace ordering_file_test
}  // namespace pliant
