// SPDX-License-Identifier: MIT
// What is left of a file when its writer dies, at every write there is, or when a write fails.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "support/test.hpp"
#include "unit/record/samples.hpp"
#include "unit/record/write_calls.hpp"

namespace pliant::crash_test {

using namespace test;

constexpr double fine = 1e-9;  // Angstrom; what is rounded is compressed

void expect_frame(const H5mdReader& reader, std::int64_t frame) {
  const auto positions = reader.positions(frame);
  for (const std::size_t joint : {std::size_t{0}, positions.size() - 1})
    ASSERT_NEAR(positions[joint].y, coordinate(frame, joint, 1), fine) << "frame " << frame;
  ASSERT_EQ(reader.step(frame), 5 * frame);
}

/// The file must open, have at least `committed` frames, all readable and right, and all of
/// their observables.
void expect_intact(const std::filesystem::path& path, std::int64_t committed,
                   std::int64_t look_from) {
  const H5mdReader reader(path);
  ASSERT_GE(reader.frames(), committed);
  for (std::int64_t f = look_from; f < reader.frames(); ++f) expect_frame(reader, f);
  for (const char* name : {"sweeps", "stop", "force_z"}) {
    const auto values = reader.observable(name);
    ASSERT_EQ(std::int64_t(values.size()), reader.frames()) << name;
  }
  if (reader.frames() > 0) {
    ASSERT_EQ(reader.observable("sweeps").back(), double(reader.frames()));
  }
}

struct KillCase {
  const char* name;
  std::size_t joints;
  bool compress;
  std::int64_t first, last;  // every write of these frames is a moment of death
};

class KillTest : public FileTest, public testing::WithParamInterface<KillCase> {};

/// Dies before every write, and within every write at each page boundary.
TEST_P(KillTest, LeavesAllCommittedFrames) {
  const KillCase& kill = GetParam();
  WriteWatch watch;
  watch.keep = true;
  H5mdRecorder recorder(path_, named_chain(kill.joints), {},
                        {.precision = kill.compress ? fine : 0.0, .flush_seconds = 1e9});
  WriteReplay replay(directory_ / "left.h5md");
  const auto catch_up = [&](auto look) {
    for (const WriteCall& call : watch.calls) {
      replay.apply(call, look);
      look();
    }
    watch.calls.clear();
  };
  catch_up([] {});
  long deaths = 0;
  for (std::int64_t f = 0; f <= kill.last; ++f) {
    recorder.record(sample_frame(f, kill.joints).frame);
    if (f < kill.first - 1) continue;
    recorder.flush();
    catch_up([&] {
      if (f < kill.first) return;
      ++deaths;
      expect_intact(directory_ / "left.h5md", f, std::max<std::int64_t>(0, f - 70));
    });
    ASSERT_FALSE(HasFatalFailure()) << "frame " << f << ", death " << deaths;
  }
  recorder.close();
  catch_up([&] {
    ++deaths;
    expect_intact(directory_ / "left.h5md", kill.last + 1, 0);
  });
  EXPECT_GT(deaths, 80);
}

// A node of a chunk tree holds 64 chunks, and keeps 57 when it is split: at frame 64 of one frame a
// chunk the root gets children, at 121 they become three, at 3655 they become too many for one
// root.
INSTANTIATE_TEST_SUITE_P(
    Frames, KillTest,
    ::testing::Values(KillCase{"first_frames", 5, false, 0, 3},
                      KillCase{"new_chunks_of_numbers", 5, false, 255, 257},
                      KillCase{"first_split", 1400, false, 63, 65},
                      KillCase{"second_split", 3, true, 120, 122},
                      KillCase{"split_of_a_root_with_children", 3, true, 3654, 3656},
                      KillCase{"split_of_the_numbers", 3, false, 64 * 256 - 1, 64 * 256 + 1}),
    [](const auto& kill) { return kill.param.name; });

struct Recorded {
  std::string message;
  std::int64_t committed = 0;
};

Recorded record_until_failure(const std::filesystem::path& path, std::size_t joints,
                              std::int64_t frames) {
  H5mdRecorder recorder(path, named_chain(joints), {}, {.overwrite = true, .flush_seconds = 0.0});
  Recorded recorded;
  recorded.message = error_text<FileError>([&] {
    for (std::int64_t f = 0; f < frames; ++f) recorder.record(sample_frame(f, joints).frame);
    recorder.close();
  });
  recorded.committed = recorder.committed_frames();
  if (!recorded.message.empty()) {
    EXPECT_ERROR(FileError, recorded.message, recorder.flush());
    EXPECT_ERROR(FileError, recorded.message, recorder.record(sample_frame(99, joints).frame));
    recorder.close();
  }
  return recorded;
}

/// A process with a file size limit and the signal's default action, which is death.
int record_with_limit(const std::filesystem::path& path) {
  std::signal(SIGXFSZ, SIG_DFL);
  const rlimit limit{400'000, 400'000};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  const Recorded recorded = record_until_failure(path, 200, 1000);
  const bool shown =
      recorded.message.find("File too large; the file holds the first ") != std::string::npos;
  return shown && recorded.committed > 10 ? 0 : 1;
}

class WriterTest : public FileTest {};

TEST_F(WriterTest, IsToldThatAFileIsTooLargeAndLives) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(record_with_limit(path_));
  int status = -1;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  expect_intact(path_, 11, 0);
}

TEST_F(WriterTest, ExitWithoutDestructorLeavesTheCommittedFrames) {
  const pid_t child = ::fork();
  if (child == 0) {
    auto* leaked = new H5mdRecorder(path_, named_chain(5), {}, {.flush_seconds = 0.0});
    for (std::int64_t f = 0; f < 3; ++f) leaked->record(sample_frame(f, 5).frame);
    std::exit(0);  // HDF5's exit handler closes the file
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  expect_intact(path_, 3, 0);
}

}  // namespace pliant::crash_test
