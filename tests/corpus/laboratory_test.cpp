// SPDX-License-Identifier: MIT
// Graphs, orderings, forces, bars and results of the corpus are read or refused as expected.txt
// beside them says; so is every beginning of each, and each with a byte left out, doubled or
// changed, without a crash or a raw byte in a message.
#include "corpus/corpus.hpp"
#include "corpus/laboratory_text.hpp"
#include "support/test.hpp"

namespace pliant {

void PrintTo(const LaboratoryFile& row, std::ostream* out) { *out << row.folder; }

namespace laboratory_test {

class LaboratoryCorpus : public testing::TestWithParam<LaboratoryFile> {
 protected:
  /// Calls `look(name, bytes)` for each file of the folder.
  template <class Look>
  static void each_file(Look look) {
    for (const auto& entry : std::filesystem::directory_iterator(corpus_folder(GetParam().folder)))
      if (entry.path().filename() != "expected.txt")
        look(entry.path().filename().string(), test::content_of(entry.path()));
  }
};

TEST_P(LaboratoryCorpus, IsReadAsExpected) {
  std::set<std::string> sections;
  for (const CorpusCase& given : corpus_cases(GetParam().folder)) {
    const std::string bytes = test::content_of(corpus_folder(given.folder) / given.file);
    EXPECT_EQ(GetParam().read({given.file, bytes}), given.expected) << given.file;
    EXPECT_NE(given.expected, "") << given.file;
    sections.insert(given.file);
  }
  each_file([&](const std::string& name, const std::string&) {
    EXPECT_TRUE(sections.contains(name)) << name << " has no section";
  });
}

TEST_P(LaboratoryCorpus, IsReadOrRefusedWhenBroken) {
  std::size_t readings = 0;
  const auto read = [&](const std::string& text) {
    const std::string said = GetParam().read({"broken", text});
    if (said.starts_with("error: ")) {
      ASSERT_TRUE(std::all_of(said.begin(), said.end() - 1, [](char c) {
        return c >= ' ' && c <= '~';
      })) << said;
    }
    ++readings;
  };
  each_file([&](const std::string&, const std::string& original) {
    for (std::size_t at = 0; at < original.size() && !HasFailure(); ++at) {
      read(original.substr(0, at));
      read(std::string(original).erase(at, 1));
      read(std::string(original).insert(at, 1, original[at]));
      std::string flipped = original;
      flipped[at] = static_cast<char>(flipped[at] ^ (1 << (at % 8)));
      read(flipped);
    }
  });
  EXPECT_GT(readings, 1000u);
}

INSTANTIATE_TEST_SUITE_P(Files, LaboratoryCorpus,
                         testing::ValuesIn(laboratory_files().begin(), laboratory_files().end()),
                         [](const auto& row) { return std::string(row.param.folder); });

}  // namespace laboratory_test
}  // namespace pliant
