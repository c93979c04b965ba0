// SPDX-License-Identifier: MIT
#include <sys/resource.h>

#include <cerrno>
#include <csignal>

#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/file_lock.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/base/system/process.hpp"
#include "pliant/base/system/program_folders.hpp"
#include "pliant/base/system/signals.hpp"
#include "pliant/base/system/sockets.hpp"
#include "support/test.hpp"

namespace pliant::system_test {

using Bytes = std::span<const std::byte>;

Bytes bytes_of(std::string_view text) { return std::as_bytes(std::span(text)); }

/// A folder that goes with the test.
class Descriptors : public testing::Test {
 protected:
  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  std::string text(const std::string& name) const { return test::content_of(path(name)); }

 private:
  const test::TempDirectory folder_;
};

std::string read_from(int descriptor, std::uint64_t position, std::size_t count) {
  std::string text(count, '?');
  const auto got = read_at(descriptor, position, std::as_writable_bytes(std::span(text)));
  return got < 0 ? std::strerror(errno) : text.substr(0, static_cast<std::size_t>(got));
}

TEST_F(Descriptors, WriteAndReadAtPositions) {
  const Descriptor file = open_file(path("new"), Opening::to_make);
  ASSERT_TRUE(file);
  EXPECT_TRUE(write_all(file.get(), bytes_of("abcdef")));
  EXPECT_TRUE(write_all_at(file.get(), 2, bytes_of("XY")));
  EXPECT_TRUE(write_all_at(file.get(), 8, bytes_of("z")));
  EXPECT_EQ(text("new"), std::string("abXYef\0\0z", 9));
  EXPECT_EQ(read_from(file.get(), 1, 4), "bXYe");
  EXPECT_EQ(read_from(file.get(), 9, 4), "") << "the end";
  EXPECT_TRUE(resize_file(file.get(), 3));
  EXPECT_TRUE(flush_contents(file.get()));
  EXPECT_EQ(text("new"), "abX");
  EXPECT_EQ(facts_of(file.get())->size, 3u);
}

TEST_F(Descriptors, OpenWhatIsThereOrAnew) {
  write("old", "old");
  EXPECT_FALSE(open_file(path("none"), Opening::to_read));
  EXPECT_EQ(errno, ENOENT);
  EXPECT_FALSE(open_file(path("old"), Opening::to_make_anew));
  EXPECT_EQ(errno, EEXIST);
  EXPECT_EQ(read_from(open_file(path("old"), Opening::to_make).get(), 0, 9), "old");
  EXPECT_EQ(read_from(open_file(path("old"), Opening::to_change).get(), 0, 9), "old");
  const Descriptor anew = open_file(path("anew"), Opening::to_make_anew);
  EXPECT_TRUE(is_there(path("anew")));
  EXPECT_FALSE(is_there(path("none")));
}

TEST_F(Descriptors, SayWhatIsOpen) {
  std::filesystem::create_directory(path("folder"));
  write("file", "12345");
  const auto kind = [&](const std::string& name) {
    return facts_of(open_file(path(name), Opening::to_read).get())->kind;
  };
  EXPECT_EQ(kind("folder"), FileKind::folder);
  EXPECT_EQ(kind("file"), FileKind::regular);
  EXPECT_EQ(facts_of(open_file("/dev/null", Opening::to_read).get())->kind, FileKind::device);
  EXPECT_FALSE(facts_of(-1));
}

TEST_F(Descriptors, TellAFileFromAnotherOfItsName) {
  write("one", "1");
  const Descriptor one = open_file(path("one"), Opening::to_read);
  EXPECT_TRUE(is_same_file(one.get(), path("one")));
  write("two", "2");
  EXPECT_FALSE(is_same_file(one.get(), path("two")));
  ASSERT_TRUE(replace_name(path("two"), path("one")));
  EXPECT_FALSE(is_same_file(one.get(), path("one")));
}

TEST_F(Descriptors, TakeAndReplaceNames) {
  write("a", "a");
  write("b", "b");
  EXPECT_FALSE(take_name(path("a"), path("b")));
  EXPECT_EQ(errno, EEXIST);
  EXPECT_TRUE(take_name(path("a"), path("c")));
  EXPECT_FALSE(is_there(path("a")));
  EXPECT_TRUE(replace_name(path("c"), path("b")));
  EXPECT_EQ(text("b"), "a");
  remove_name(path("b"));
  remove_name(path("b"));
  EXPECT_FALSE(is_there(path("b")));
}

TEST(PathText, KeepsEveryName) {
  for (const char* name : {"", "a/b.pdb", "größe/名前.h5md", "\xf0\x9f\x94\xac"})
    EXPECT_EQ(path_text(path_of(name)), name);
}

TEST(PathText, TakesTheWordsAfterTheFirst) {
  std::string program = "pliant", one = "a b", two = "名";
  std::array<char*, 3> words{program.data(), one.data(), two.data()};
  EXPECT_EQ(command_words(3, words.data()), (std::vector<std::string>{"a b", "名"}));
  EXPECT_TRUE(command_words(0, nullptr).empty());
}

TEST(Process, KnowsItsOwnProgram) {
  EXPECT_TRUE(is_program(own_program()));
  EXPECT_EQ(own_program().filename(), "pliant_tests");
}

TEST(Process, FindsProgramsInFolders) {
  const auto folders = program_folders();
  const auto has_shell = [](const std::filesystem::path& folder) {
    return is_program(folder / program_file("sh"));
  };
  EXPECT_TRUE(std::ranges::any_of(folders, has_shell));
  EXPECT_FALSE(is_program("/etc/passwd")) << "may not be started";
  EXPECT_FALSE(is_program("/tmp")) << "a folder";
}

TEST(Process, SaysHowACopyEnds) {
  EXPECT_EQ(crash_in_copy([] {}, 5), 0);
  EXPECT_EQ(crash_in_copy([] { std::raise(SIGSEGV); }, 5), SIGSEGV);
}

TEST(Process, EndsACopyThatTakesTooLong) {
  const auto spin = [] {
    for (const volatile bool go_on = true; go_on;) {
    }
  };
  const std::optional<int> signal = crash_in_copy(spin, 1);
  EXPECT_TRUE(signal == SIGXCPU || signal == SIGKILL);
}

TEST(Process, RunsAProgramWithInput) {
  EXPECT_EQ(run_program_with_input("/bin/sh", {"-c", "read word; [ \"$word\" = yes ]"}, "yes\n"),
            0);
  EXPECT_EQ(run_program_with_input("/bin/sh", {"-c", "exit 7"}, std::string(1 << 20, 'x')), 7);
  EXPECT_EQ(run_program_with_input("/bin/sh", {"-c", "kill -9 $$"}, ""), -1);
}

TEST(FileLock, HoldsOneWriter) {
  const test::TempDirectory folder;
  const Descriptor one = open_file(folder / "file", Opening::to_make);
  Descriptor two = open_file(folder / "file", Opening::to_change);
  EXPECT_FALSE(is_being_written(two.get()));
  EXPECT_EQ(lock_for_writing(two.get()), Locking::locked);
  EXPECT_EQ(lock_for_writing(one.get()), Locking::held_by_another);
  EXPECT_TRUE(is_being_written(one.get()));
  two.close();
  EXPECT_EQ(lock_for_writing(one.get()), Locking::locked);
}

/// The limit of this process, put back at the end.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST(Signals, OfTheFileSizeLimitWaitAndAreForgotten) {
  const test::TempDirectory folder;
  const Descriptor file = open_file(folder / "file", Opening::to_make);
  const std::string text(200, 'x');
  {
    const FileSizeLimit limit(100);
    const FileSizeSignalHeld held;
    EXPECT_FALSE(write_all(file.get(), std::as_bytes(std::span(text))));
    EXPECT_EQ(errno, EFBIG);
  }
  EXPECT_EQ(facts_of(file.get())->size, 100u) << "and this process is still there";
}

TEST(Sockets, WakeWhoWaits) {
  const Wake wake;
  std::array<SocketEvents, 2> waits{{{wake.to_wait_for()}, {}}};
  wait_for(waits, 0);
  EXPECT_FALSE(waits[0].can_read);
  wake.wake();
  wake.wake();
  wait_for(waits, -1);
  EXPECT_TRUE(waits[0].can_read);
  EXPECT_FALSE(waits[1].can_read) << "none is passed over";
  wake.sleep_again();
  wait_for(waits, 0);
  EXPECT_FALSE(waits[0].can_read) << "all calls are forgotten";
}

}  // namespace pliant::system_test
