// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/committed_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "support/test.hpp"
#include "unit/record/samples.hpp"
#include "unit/record/write_calls.hpp"

namespace pliant::committed_file_test {

using test::TempDirectory;
using test::WriteWatch;

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

/// A version 1 B-tree node of this level, as far as the order of writes looks at it.
std::string node(char level) { return std::string("TREE\1") + level; }

class CommittedFileTest : public ::testing::Test {
 protected:
  CommittedFileTest()
      : descriptor_(::open((directory_ / "file").c_str(), O_RDWR | O_CREAT, 0600)),
        file_(descriptor_) {}
  ~CommittedFileTest() override { ::close(descriptor_); }

  void write(BlockKind kind, std::uint64_t address, const std::string& text) {
    file_.write(kind, address, bytes_of(text));
  }
  std::string read(std::uint64_t address, std::size_t size) const {
    std::string text(size, '?');
    file_.read(address, std::as_writable_bytes(std::span(text)));
    return text;
  }
  off_t size() const {
    struct stat status {};
    ::fstat(descriptor_, &status);
    return status.st_size;
  }

  TempDirectory directory_;
  int descriptor_;
  CommittedFile file_;
};

TEST_F(CommittedFileTest, MetadataWaitsForTheCommitAndDataDoesNot) {
  write(BlockKind::data, 0, "data");
  EXPECT_EQ(size(), 4);
  write(BlockKind::other_metadata, 10, "meta");
  EXPECT_EQ(size(), 4);
  EXPECT_EQ(file_.size(), 14u);
  file_.set_end(20);
  file_.commit();
  EXPECT_GT(size(), 20) << "with room for the next commit";
  file_.trim();
  EXPECT_EQ(size(), 20);
  EXPECT_EQ(read(10, 4), "meta");
}

TEST_F(CommittedFileTest, NotesDataThatStaysUntilItIsAskedFor) {
  const std::string stays = "0123456789";
  file_.keep(bytes_of(stays));
  file_.write(BlockKind::data, 0, bytes_of(stays).subspan(2, 4));
  write(BlockKind::data, 4, "else");
  EXPECT_EQ(size(), 8) << "other data is written at once";
  EXPECT_EQ(read(0, 8), "2345else") << "as is read what is only noted";
  file_.write_kept();
  file_.write(BlockKind::data, 8, bytes_of(stays).first(2));
  EXPECT_EQ(size(), 10) << "what stays is said anew each time";
}

TEST_F(CommittedFileTest, CommitsNothingBeforeTheDataThatItNames) {
  const std::string stays = "0123456789";
  file_.keep(bytes_of(stays));
  file_.write(BlockKind::data, 0, bytes_of(stays));
  write(BlockKind::other_metadata, 10, "meta");
  file_.set_end(14);
  WriteWatch watch;
  watch.keep = true;
  file_.commit();
  ASSERT_GE(watch.calls.size(), 2u);
  EXPECT_EQ(watch.calls.front().offset, 0);
  EXPECT_EQ(watch.calls.front().bytes.size(), 10u);
}

TEST_F(CommittedFileTest, ReadsWhatWaits) {
  write(BlockKind::data, 0, "0123456789");
  write(BlockKind::tree_node, 4, "TR");
  write(BlockKind::other_metadata, 8, "abcd");
  EXPECT_EQ(read(2, 8), "23TR67ab");
  EXPECT_EQ(read(9, 5), std::string("bcd\0\0", 5));
}

TEST_F(CommittedFileTest, WritesInTheOrderThatKeepsTheFileReadable) {
  write(BlockKind::superblock, 0, "super");
  write(BlockKind::tree_node, 100, node(1));
  write(BlockKind::tree_node, 200, node(0));
  for (const std::uint64_t header : {300, 400, 500}) write(BlockKind::other_metadata, header, "h");
  file_.set_end(600);
  file_.commit();
  file_.write_last({500, 300});
  WriteWatch watch;
  watch.keep = true;
  for (const std::uint64_t header : {300, 400, 500}) write(BlockKind::other_metadata, header, "H");
  write(BlockKind::tree_node, 200, node(0));
  write(BlockKind::tree_node, 100, node(1));
  write(BlockKind::superblock, 0, "SUPER");
  write(BlockKind::tree_node, 700, node(0));
  file_.set_end(800);
  file_.commit();
  std::vector<off_t> order;
  for (const auto& call : watch.calls) order.push_back(call.truncates ? -call.offset : call.offset);
  EXPECT_EQ(order, (std::vector<off_t>{700, 0, 100, 200, 400, 500, 300}));
}

/// What readers are led to is there: headers first, then trees, then data, then the end.
TEST_F(CommittedFileTest, TakesRowsAwayInTheOrderThatKeepsTheFileReadable) {
  write(BlockKind::superblock, 0, "super");
  write(BlockKind::tree_node, 100, node(1));
  write(BlockKind::tree_node, 200, node(0));
  write(BlockKind::other_metadata, 300, "header");
  file_.set_end(600);
  file_.commit();
  WriteWatch watch;
  watch.keep = true;
  file_.shrink();
  write(BlockKind::data, 400, "fill values");
  write(BlockKind::superblock, 0, "SUPER");
  write(BlockKind::tree_node, 200, node(0));
  write(BlockKind::tree_node, 100, node(1));
  write(BlockKind::other_metadata, 300, "HEADER");
  EXPECT_TRUE(watch.calls.empty()) << "data waits too";
  file_.commit();
  std::vector<off_t> order;
  for (const auto& call : watch.calls) order.push_back(call.offset);
  EXPECT_EQ(order, (std::vector<off_t>{300, 100, 200, 400, 0}));
}

TEST_F(CommittedFileTest, KnowsWhatAFileHolds) {
  write(BlockKind::other_metadata, 10, "header");
  file_.set_end(16);
  file_.commit();
  file_.trim();
  CommittedFile again(descriptor_);
  EXPECT_EQ(again.size(), 16u);
  WriteWatch watch;
  watch.keep = true;
  again.write(BlockKind::other_metadata, 10, bytes_of("HEADER"));
  again.write(BlockKind::tree_node, 20, bytes_of(node(0)));
  again.set_end(30);
  again.commit();
  ASSERT_FALSE(watch.calls.empty());
  EXPECT_EQ(watch.calls.front().offset, 20) << "new blocks first";
  EXPECT_EQ(watch.calls.back().offset, 10);
}

TEST_F(CommittedFileTest, GivesSpaceBackWhenTheEndMovesDown) {
  write(BlockKind::other_metadata, 0, "header");
  file_.set_end(5000);
  file_.commit();
  EXPECT_GE(size(), 5000);
  file_.set_end(6);
  file_.commit();
  file_.trim();
  EXPECT_EQ(size(), 6);
}

/// A leaf of a chunk tree with `entries` of four letters each, in room for three.
std::string leaf(int entries) {
  std::string text = node(0) + char(entries) + '\0';
  for (int k = 0; k < 3; ++k) text += std::string(4, k < entries ? char('a' + k) : '.');
  return text;
}

/// The disk fails at each write, with half of it done: no entry is counted that is not there.
TEST_F(CommittedFileTest, LeavesCountNoMoreThanTheyHold) {
  for (const auto& [before, after] : {std::pair(1, 3), std::pair(3, 1)})
    for (int fails_at = 0; fails_at < 2; ++fails_at) {
      SCOPED_TRACE(testing::Message() << before << " to " << after << ", write " << fails_at);
      CommittedFile file(descriptor_);
      file.write(BlockKind::tree_node, 0, bytes_of(leaf(before)));
      file.set_end(leaf(before).size());
      file.commit();
      ASSERT_EQ(file.failure(), 0);
      file.write(BlockKind::tree_node, 0, bytes_of(leaf(after)));
      {
        WriteWatch watch;
        watch.fail_at = fails_at;
        watch.error = EIO;
        watch.half = true;
        file.commit();
      }
      EXPECT_EQ(file.failure(), EIO);
      std::string left(leaf(before).size(), '?');
      ASSERT_EQ(::pread(descriptor_, left.data(), left.size(), 0), ssize_t(left.size()));
      const auto counted = static_cast<std::size_t>(left[6]);
      EXPECT_EQ(left.substr(8, 4 * counted), leaf(3).substr(8, 4 * counted));
    }
}

TEST_F(CommittedFileTest, ForkedChildWritesNothing) {
  write(BlockKind::other_metadata, 0, "parent");
  file_.set_end(6);
  const pid_t child = ::fork();
  if (child == 0) {
    write(BlockKind::data, 0, "child");
    file_.commit();
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(size(), 0);
}

}  // namespace pliant::committed_file_test
