// SPDX-License-Identifier: MIT
// Every file of the corpus is read (or refused) exactly as its expected.txt says: each atom, bond,
// note, warning and error.
#include "corpus/corpus.hpp"
#include "corpus/structure_text.hpp"
#include "support/test.hpp"

namespace pliant::corpus_test {

std::vector<CorpusCase> all_cases() {
  std::vector<CorpusCase> cases;
  for (const char* folder : corpus_folders)
    for (CorpusCase& next : corpus_cases(folder)) cases.push_back(next);
  return cases;
}

std::string name_of(const testing::TestParamInfo<CorpusCase>& info) {
  std::string name = info.param.file.substr(0, info.param.file.find('.'));
  if (info.param.model != 1) name += "_model_" + std::to_string(info.param.model);
  return name;
}

class Corpus : public testing::TestWithParam<CorpusCase> {};

TEST_P(Corpus, IsReadAsExpected) {
  const CorpusCase& given = GetParam();
  const std::string bytes = test::content_of(corpus_folder(given.folder) / given.file);
  EXPECT_EQ(reading_as_text({given.file, bytes}, {.model = given.model}), given.expected);
}

INSTANTIATE_TEST_SUITE_P(Files, Corpus, testing::ValuesIn(all_cases()), name_of);

/// A row of the corpus that no section reads, or the other way round, would go unseen.
TEST(CorpusFolder, EachFileHasASection) {
  for (const char* folder : corpus_folders) {
    std::set<std::string> files, sections;
    for (const auto& entry : std::filesystem::directory_iterator(corpus_folder(folder)))
      files.insert(entry.path().filename().string());
    files.erase("expected.txt");
    for (const CorpusCase& next : corpus_cases(folder)) sections.insert(next.file);
    EXPECT_EQ(files, sections) << folder;
  }
}

TEST(CorpusFolder, NoExpectationIsEmpty) {
  for (const CorpusCase& next : all_cases()) EXPECT_NE(next.expected, "") << next.file;
}

TEST(CorpusFolder, NumbersFollowEachOther) {
  struct Rows {
    const char* folder;
    const char* prefix;
    int count;
  };
  // pdb53 (a line of a million characters) is made by its test, not kept as a file.
  for (const Rows rows : {Rows{"pdb", "pdb", 117}, Rows{"xyz", "xyz", 50}, Rows{"sdf", "sdf", 36},
                          Rows{"mmcif", "cif", 42}}) {
    std::set<std::string> found, wanted;
    for (const CorpusCase& next : corpus_cases(rows.folder))
      found.insert(next.file.substr(0, next.file.find('_')));
    for (int k = 1; k <= rows.count; ++k)
      wanted.insert(rows.prefix + std::string(k < 10 ? "0" : "") + std::to_string(k));
    wanted.erase("pdb53");
    EXPECT_EQ(found, wanted);
  }
}

}  // namespace pliant::corpus_test
