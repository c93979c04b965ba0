// SPDX-License-Identifier: MIT
#include "pliant/text/file_text.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <ctime>

#include "pliant/text/compression.hpp"
#include "pliant/text/text_lines.hpp"
#include "support/compressed.hpp"
#include "support/test.hpp"

namespace pliant::file_text_test {

using test::error_text;
using test::gzipped;

/// A folder that goes with the test.
class FileText : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

 private:
  const test::TempDirectory folder_;
};

TEST_F(FileText, ReadsAllBytes) {
  const std::string bytes("a\r\n\0b\xff", 6);
  EXPECT_EQ(read_bytes(write("plain", bytes)), bytes);
  EXPECT_EQ(read_bytes(write("empty", "")), "");
}

TEST_F(FileText, UndoesGzipByContent) {
  EXPECT_EQ(read_bytes(write("one.pdb", gzipped("ATOM"))), "ATOM");
  EXPECT_EQ(read_bytes(write("named.gz", "no gzip at all")), "no gzip at all");
}

TEST_F(FileText, NamesTheSystemsReason) {
  EXPECT_ERROR(FileError, "cannot read " + path("none") + ": No such file or directory",
               read_bytes(path("none")));
  EXPECT_ERROR(FileError, "cannot read " + path("") + ": Is a directory", read_bytes(path("")));
}

TEST_F(FileText, RefusesDevicesThatNeverEnd) {
  for (const char* device : {"/dev/zero", "/dev/null", "/dev/urandom"})
    EXPECT_ERROR(FileError, "cannot read " + std::string(device) + ": is a device, not a file",
                 read_bytes(device));
}

TEST_F(FileText, ReadsPipes) {
  const std::string pipe = path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string text(60'000, 'y');  // less than a pipe holds
  const int reading_end = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  std::ofstream(pipe) << text;
  EXPECT_EQ(read_bytes(pipe), text);
  ::close(reading_end);
}

TEST_F(FileText, RefusesPipesThatNobodyWritesTo) {
  const std::string pipe = path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_ERROR(FileError, "cannot read " + pipe + ": is a pipe that nobody writes to",
               read_bytes(pipe));
}

TEST_F(FileText, RefusesFilesThatAreTooLargeBeforeReadingThem) {
  const std::string huge = write("huge", "");
  std::filesystem::resize_file(huge, usual_text + 1);  // a hole: takes no room on disk
  EXPECT_ERROR(TooLargeError, huge + ": is larger than 2000 MB, the most that is read",
               read_bytes(huge));
  EXPECT_ERROR(TooLargeError, huge + ": is larger than 1000001 bytes, the most that is read",
               read_bytes(huge, 1000001));
}

TEST_F(FileText, RefusesWhatExpandsToTooMuch) {
  const std::string bomb = write("bomb.gz", gzipped(std::string(2000000, ' ')));
  EXPECT_EQ(read_bytes(bomb, 2000000).size(), 2000000u);
  EXPECT_ERROR(TooLargeError, bomb + ": gzip: expands to more than 1 MB, the most that is read",
               read_bytes(bomb, 1000000));
}

TEST_F(FileText, NamesOtherCompressions) {
  using namespace std::string_literals;
  const auto refusal = [&](const std::string& bytes) {
    const std::string file = write("packed", bytes);
    return error_text<InputError>([&] { read_bytes(file); }).substr(file.size());
  };
  const std::string others = ": only gzip, bzip2 and xz are read";
  EXPECT_EQ(refusal("\x28\xb5\x2f\xfd\x04"s), ": is compressed with zstd" + others);
  EXPECT_EQ(refusal("\x1f\x9d\x90"s), ": is compressed with compress" + others);
  EXPECT_EQ(refusal("PK\x03\x04\x14"s), ": is compressed with zip" + others);
}

TEST(CheckText, TakesText) {
  for (const char* text : {"ATOM\n", "\t\v\f\r\n", "\xc3\xa5\n", "end\x1a"})
    EXPECT_NO_THROW(check_text({"x", text})) << text;
}

TEST(CheckText, RefusesEmptyAndWideText) {
  using namespace std::string_view_literals;
  const auto refusal = [](std::string_view text) {
    return error_text<InputError>([&] { check_text({"x.pdb", text}); });
  };
  EXPECT_EQ(refusal(""), "x.pdb: is empty");
  for (const auto text : {"\xff\xfe"
                          "A\0"sv,
                          "\xfe\xff\0A"sv, "A\0T\0"sv, "\0A\0T"sv})
    EXPECT_EQ(refusal(text), "x.pdb: is UTF-16 text: save it as UTF-8 or ASCII");
  for (const auto text : {"\xff\xfe\0\0"sv, "\0\0\xfe\xff"sv})
    EXPECT_EQ(refusal(text), "x.pdb: is UTF-32 text: save it as UTF-8 or ASCII");
}

TEST(CheckText, NamesTheLineOfTheFirstBinaryByte) {
  std::string text = std::string(5000, 'a') + "\n" + std::string(5000, 'b') + "\n";
  for (const char byte : {'\0', '\x01', '\x08', '\x0e', '\x1b', '\x1f'}) {
    text[7000] = byte;
    const std::string message = error_text<InputError>([&] { check_text({"x", text}); });
    EXPECT_TRUE(message.starts_with("x:2: holds the byte 0x")) << message;
  }
  text[7000] = '\x1b';
  EXPECT_ERROR(InputError, "x:2: holds the byte 0x1b: a binary file, not a molecule in text",
               check_text({"x", text}));
}

TEST(ByteOrderMark, IsTakenOff) {
  EXPECT_EQ(without_byte_order_mark("\xef\xbb\xbf"
                                    "ATOM"),
            "ATOM");
  EXPECT_EQ(without_byte_order_mark("ATOM"), "ATOM");
}

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
  EXPECT_ERROR(TooLargeError,
               begin() + "expands to more than 68157439 bytes, the most that is read",
               expanded(bomb, text.size() - 1));
  EXPECT_ERROR(TooLargeError, begin() + "expands to more than 1 MB, the most that is read",
               expanded(bomb, 1000000));
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
  EXPECT_ERROR(InputError,
               "x: is compressed with gzip, which this build of Pliant does not read: it was made "
               "without zlib",
               expand(row, "\x1f\x8b", "x", usual_text));
}

TEST(Compression, SuffixesAreTakenOff) {
  EXPECT_EQ(without_compression_suffix("a/1abc.pdb.gz"), "a/1abc.pdb");
  EXPECT_EQ(without_compression_suffix("1ABC.PDB.BZ2"), "1ABC.PDB");
  EXPECT_EQ(without_compression_suffix("x.cif.xz"), "x.cif");
  for (const char* other : {"x.pdb", "x.zip", "x.zst", "gz", ""})
    EXPECT_EQ(without_compression_suffix(other), other);
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> found;
  for (Lines lines(text); lines.next();) found.emplace_back(lines.line());
  return found;
}

using Text = std::vector<std::string>;

TEST(Lines, AnyLineEnd) {
  EXPECT_EQ(lines_of("a\nb\n"), (Text{"a", "b"}));
  EXPECT_EQ(lines_of("a\r\nb\r\n"), (Text{"a", "b"}));
  EXPECT_EQ(lines_of("a\rb\r"), (Text{"a", "b"}));
  EXPECT_EQ(lines_of("a\rb\nc\r\nd"), (Text{"a", "b", "c", "d"}));
  EXPECT_EQ(lines_of("a\r\r\nb"), (Text{"a", "", "b"}));
}

TEST(Lines, EmptyLinesAndEnds) {
  EXPECT_EQ(lines_of(""), Text{});
  EXPECT_EQ(lines_of("\n"), Text{""});
  EXPECT_EQ(lines_of("\n\nx"), (Text{"", "", "x"}));
  EXPECT_EQ(lines_of("x\n\n"), (Text{"x", ""}));
}

TEST(Lines, CountsAndRemembersItsPlaceWhenCopied) {
  Lines lines("a\nb\nc");
  EXPECT_EQ(lines.number(), 0u);
  lines.next();
  Lines copy = lines;
  EXPECT_TRUE(lines.next() && lines.next());
  EXPECT_EQ(lines.number(), 3u);
  EXPECT_FALSE(lines.next());
  EXPECT_EQ(lines.number(), 3u);
  EXPECT_TRUE(copy.next());
  EXPECT_EQ(copy.line(), "b");
  EXPECT_EQ(copy.number(), 2u);
}

/// Looking for an LF from every line of a text without any would take 10^12 steps here.
TEST(Lines, LinearWhereOneKindOfLineEndIsMissing) {
  const std::string text(1'000'000, '\r');
  const std::clock_t begin = std::clock();  // of this process: others may be busy
  EXPECT_EQ(lines_of(text).size(), text.size());
  EXPECT_LT(std::clock() - begin, 5 * CLOCKS_PER_SEC);
}

}  // namespace pliant::file_text_test
