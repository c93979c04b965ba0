// SPDX-License-Identifier: MIT
#include "pliant/text/compression.hpp"

#include <gtest/gtest.h>

#include "pliant/text/file_text.hpp"
#include "support/compressed.hpp"
#include "support/error_text.hpp"

namespace pliant {
namespace compression_test {

using test::error_text;

/// A compression and the library's own way to make its files.
struct Case {
  const char* name;
  std::string (*compressed)(const std::string& text);
};

class EachCompression : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    if (packed("text").empty()) GTEST_SKIP() << "this build has no library for it";
  }

  static std::string packed(const std::string& text) { return GetParam().compressed(text); }
  static std::string expanded(const std::string& bytes, std::size_t most = usual_text) {
    const Compression* compression = compression_of(bytes);
    if (compression == nullptr) return "not compressed";
    EXPECT_EQ(compression->name, GetParam().name);
    return expand(*compression, bytes, "x", most);
  }
  static std::string refusal(const std::string& bytes) {
    return error_text<InputError>([&] { expanded(bytes); });
  }
  static std::string begin() { return "x: " + std::string(GetParam().name) + ": "; }
};

TEST_P(EachCompression, IsUndone) {
  EXPECT_EQ(expanded(packed("")), "");
  EXPECT_EQ(expanded(packed("ATOM")), "ATOM");
  std::string large;
  for (int line = 0; line < 300'000; ++line) large += std::to_string(line) + "\n";
  EXPECT_EQ(expanded(packed(large)), large);
}

TEST_P(EachCompression, MembersFollowOneAnother) {
  EXPECT_EQ(expanded(packed("one\n") + packed("two\n")), "one\ntwo\n");
  EXPECT_EQ(expanded(packed("one\n") + std::string(4, '\0') + packed("two\n")), "one\ntwo\n");
  EXPECT_EQ(expanded(packed("text") + "padding"), "text");
}

TEST_P(EachCompression, WhatIsCutAtAnyByteIsRefused) {
  const std::string whole = packed("ATOM      1  N   ALA A   1       0.000   0.000   0.000\n");
  const std::size_t magic = compression_of(whole)->magic.size();
  for (std::size_t size = magic; size < whole.size(); ++size) {
    const std::string message = refusal(whole.substr(0, size));
    EXPECT_TRUE(message.starts_with(begin() + "the compressed data end early, after "))
        << size << ": " << message;
  }
}

TEST_P(EachCompression, WhatIsDamagedIsRefusedOrTheSame) {
  const std::string text = std::string(1000, 'x') + "ATOM";
  const std::string whole = packed(text);
  std::size_t refused = 0;
  for (std::size_t at = compression_of(whole)->magic.size(); at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    try {
      EXPECT_EQ(expanded(damaged), text) << at;  // a bit that tells a time or a name
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(begin())) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, whole.size() / 2);
}

TEST_P(EachCompression, TooMuchIsRefused) {
  const std::string text(std::size_t{65} << 20, ' ');
  const std::string bomb = packed(text);
  EXPECT_LT(bomb.size() * 300, text.size());
  EXPECT_TRUE(expanded(bomb, text.size()) == text);
  EXPECT_EQ(error_text<TooLargeError>([&] { expanded(bomb, text.size() - 1); }),
            begin() + "expands to more than 68157439 bytes, the most that is read");
  EXPECT_EQ(error_text<TooLargeError>([&] { expanded(bomb, 1000000); }),
            begin() + "expands to more than 1 MB, the most that is read");
}

INSTANTIATE_TEST_SUITE_P(Compression, EachCompression,
                         testing::Values(Case{"gzip", test::gzipped}, Case{"bzip2", test::bzip2ed},
                                         Case{"xz", test::xzed}),
                         [](const auto& row) { return std::string(row.param.name); });

std::string refusal(const std::string& bytes) {
  return error_text<InputError>([&] { expand(*compression_of(bytes), bytes, "x", usual_text); });
}

TEST(Compression, SaysWhatIsDamaged) {
  std::string damaged = test::gzipped(std::string(1000, 'x') + "ATOM");
  damaged[damaged.size() - 6] ^= 1;  // in the checksum
  EXPECT_EQ(refusal(damaged), "x: gzip: damaged: incorrect data check");
  EXPECT_EQ(refusal("\x1f\x8b\x07\x01 garbage"), "x: gzip: damaged: unknown compression method");
  if (test::bzip2ed("").empty()) return;
  EXPECT_EQ(refusal("BZh91AY garbage"), "x: bzip2: damaged: incorrect data check");
  EXPECT_EQ(refusal("BZh!"), "x: bzip2: damaged: incorrect header");
}

TEST(Compression, AnXzFileThatNeedsMuchMemoryIsRefused) {
  const std::string packed = test::xzed_for_much_memory("ATOM");
  if (packed.empty()) GTEST_SKIP() << "this build has no liblzma";
  EXPECT_EQ(refusal(packed), "x: xz: damaged: needs more than 256 MiB of memory to be expanded");
}

TEST(Compression, OneThatTheBuildHasNoLibraryForIsNamed) {
  Compression row = *compression_of("\x1f\x8b");
  row.decoder = []() -> std::unique_ptr<Decoder> { return nullptr; };
  EXPECT_EQ(error_text<InputError>([&] { expand(row, "\x1f\x8b", "x", usual_text); }),
            "x: is compressed with gzip, which this build of Pliant does not read: it was made "
            "without zlib");
}

TEST(Compression, SuffixesAreTakenOff) {
  EXPECT_EQ(without_compression_suffix("a/1abc.pdb.gz"), "a/1abc.pdb");
  EXPECT_EQ(without_compression_suffix("1ABC.PDB.BZ2"), "1ABC.PDB");
  EXPECT_EQ(without_compression_suffix("x.cif.xz"), "x.cif");
  for (const char* other : {"x.pdb", "x.zip", "x.zst", "gz", ""})
    EXPECT_EQ(without_compression_suffix(other), other);
}

}  // namespace compression_test
}  // namespace pliant
