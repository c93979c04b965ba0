// SPDX-License-Identifier: MIT
#include "pliant/text/file_text.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "support/compressed.hpp"
#include "support/error_text.hpp"
#include "support/temp_directory.hpp"

namespace pliant {
namespace file_text_test {

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
  const std::string large(3'000'000, 'x');
  EXPECT_EQ(read_bytes(write("large.gz", gzipped(large))), large);
}

TEST_F(FileText, NamesTheSystemsReason) {
  EXPECT_EQ(error_text<FileError>([&] { read_bytes(path("none")); }),
            "cannot read " + path("none") + ": No such file or directory");
  EXPECT_EQ(error_text<FileError>([&] { read_bytes(path("")); }),
            "cannot read " + path("") + ": Is a directory");
}

TEST_F(FileText, RefusesDevicesThatNeverEnd) {
  for (const char* device : {"/dev/zero", "/dev/null", "/dev/urandom"})
    EXPECT_EQ(error_text<FileError>([&] { read_bytes(device); }),
              "cannot read " + std::string(device) + ": is a device, not a file");
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
  EXPECT_EQ(error_text<FileError>([&] { read_bytes(pipe); }),
            "cannot read " + pipe + ": is a pipe that nobody writes to");
}

TEST_F(FileText, RefusesFilesThatAreTooLargeBeforeReadingThem) {
  const std::string huge = write("huge", "");
  std::filesystem::resize_file(huge, usual_text + 1);  // a hole: takes no room on disk
  EXPECT_EQ(error_text<TooLargeError>([&] { read_bytes(huge); }),
            huge + ": is larger than 2000 MB, the most that is read");
  EXPECT_EQ(error_text<TooLargeError>([&] { read_bytes(huge, 1000001); }),
            huge + ": is larger than 1000001 bytes, the most that is read");
}

TEST_F(FileText, RefusesWhatExpandsToTooMuch) {
  const std::string bomb = write("bomb.gz", gzipped(std::string(std::size_t{65} << 20, ' ')));
  EXPECT_EQ(read_bytes(bomb).size(), std::size_t{65} << 20);
  EXPECT_EQ(read_bytes(bomb, std::size_t{65} << 20).size(), std::size_t{65} << 20);
  EXPECT_EQ(error_text<TooLargeError>([&] { read_bytes(bomb, (std::size_t{65} << 20) - 1); }),
            bomb + ": gzip: expands to more than 68157439 bytes, the most that is read");
  EXPECT_EQ(error_text<TooLargeError>([&] { read_bytes(bomb, 1000000); }),
            bomb + ": gzip: expands to more than 1 MB, the most that is read");
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
  EXPECT_EQ(error_text<InputError>([&] {
              check_text({"x", text});
            }),
            "x:2: holds the byte 0x1b: a binary file, not a molecule in text");
}

TEST(ByteOrderMark, IsTakenOff) {
  EXPECT_EQ(without_byte_order_mark("\xef\xbb\xbf"
                                    "ATOM"),
            "ATOM");
  EXPECT_EQ(without_byte_order_mark("ATOM"), "ATOM");
}

}  // namespace file_text_test
}  // namespace pliant
