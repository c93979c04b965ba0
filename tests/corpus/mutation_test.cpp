// SPDX-License-Identifier: MIT
// Every beginning of each corpus file, and the file with one byte left out, doubled or changed, is
// read or refused: no crash, no number that is not finite, no bond to nowhere, no raw byte printed.
#include "corpus/corpus.hpp"
#include "pliant/molecule/read/read.hpp"
#include "support/test.hpp"

namespace pliant::mutation_test {

bool is_printable(std::string_view message) {
  return std::all_of(message.begin(), message.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

/// Files longer than this are changed at a sample of their bytes.
constexpr std::size_t bytes_changed = 1500;

class Mutation : public testing::TestWithParam<const char*> {
 protected:
  void read(const std::string& text) {
    try {
      check(read_structure(SourceText{"mutated", text},
                           {.format = GetParam(),
                            .log = {.function =
                                        [](Severity, std::string_view message) {
                                          ASSERT_TRUE(is_printable(message)) << message;
                                        }}}),
            text);
    } catch (const Error& error) {
      ASSERT_TRUE(is_printable(error.what())) << error.what();
    }
    ++readings_;
  }

  void read_mutations(const std::string& original) {
    const std::size_t stride = original.size() / bytes_changed + 1;
    for (std::size_t at = 0; at < original.size() && !HasFailure(); at += stride) {
      read(original.substr(0, at));
      std::string text = original;
      text.erase(at, 1);
      read(text);
      text = original;
      text.insert(at, 1, original[at]);
      read(text);
      text = original;
      text[at] = static_cast<char>(text[at] ^ (1 << (at % 8)));
      read(text);
    }
  }

  std::size_t readings_ = 0;

 private:
  static void check(const Structure& structure, const std::string& text) {
    const std::size_t count = structure.size();
    ASSERT_GT(count, 0u) << text;
    ASSERT_EQ(structure.atoms.names.size(), count);
    ASSERT_EQ(structure.atoms.elements.size(), count);
    ASSERT_EQ(structure.atoms.serials.size(), count);
    ASSERT_EQ(structure.atoms.residue_of.size(), count);
    ASSERT_TRUE(structure.charges.empty() || structure.charges.size() == count);
    ASSERT_TRUE(structure.chain_end.empty() ||
                structure.chain_end.size() == structure.atoms.residues.size());
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_TRUE(is_finite(structure.positions[i])) << text;
      ASSERT_LT(structure.atoms.residue_of[i], structure.atoms.residues.size());
      if (i > 0) {
        ASSERT_LE(structure.atoms.residue_of[i - 1], structure.atoms.residue_of[i]) << text;
      }
    }
    for (const Bond& bond : structure.bonds) {
      ASSERT_LT(bond.a, bond.b) << text;
      ASSERT_LT(bond.b, count) << text;
    }
  }
};

TEST_P(Mutation, IsReadOrRefused) {
  for (const auto& entry : std::filesystem::directory_iterator(corpus_folder(GetParam()))) {
    if (entry.path().filename() == "expected.txt") continue;
    SCOPED_TRACE(entry.path().filename().string());
    read_mutations(test::content_of(entry.path()));
  }
  EXPECT_GT(readings_, 10000u);
}

INSTANTIATE_TEST_SUITE_P(Formats, Mutation, testing::ValuesIn(corpus_folders),
                         [](const auto& row) { return std::string(row.param); });

}  // namespace pliant::mutation_test
