// SPDX-License-Identifier: MIT
#include "pliant/base/system/process.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>

#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/file_lock.hpp"
#include "pliant/base/system/program_folders.hpp"
#include "pliant/base/system/signals.hpp"
#include "pliant/base/system/sockets.hpp"
#include "support/temp_directory.hpp"

namespace pliant {
namespace process_test {

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

}  // namespace process_test
}  // namespace pliant
