// SPDX-License-Identifier: MIT
// The files of a recorder: names, locks, commits.
#include "pliant/record/h5md/h5md_recorder.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "pliant/record/h5md/h5md_reader.hpp"
#include "support/test.hpp"
#include "unit/record/samples.hpp"

namespace pliant::h5md_recorder_files_test {

using namespace test;
using testing::HasSubstr;

class H5mdRecorderFiles : public FileTest {};

TEST_F(H5mdRecorderFiles, ReplacesAFileOnlyWhenItMay) {
  const std::string path = path_.string();
  std::ofstream(path) << "precious";
  EXPECT_ERROR(FileError, path + ": exists already; overwrite replaces it",
               H5mdRecorder(path, named_chain(2)));
  EXPECT_EQ(content_of(path), "precious");
  record_file(path, 4, 2, {.overwrite = true});
  EXPECT_EQ(H5mdReader(path).frames(), 2);
  EXPECT_EQ(files(), 1);
}

TEST_F(H5mdRecorderFiles, KeepsTheOldFileWhenTheNewOneFails) {
  std::ofstream(path_) << "precious";
  H5mdHeader header;
  header.masses = {1.0};
  EXPECT_THROW(H5mdRecorder(path_, named_chain(2), header, {.overwrite = true}), OptionError);
  EXPECT_EQ(content_of(path_), "precious");
  EXPECT_EQ(files(), 1);
}

TEST_F(H5mdRecorderFiles, TakesItsNameWithItsFirstFrame) {
  std::ofstream(path_) << "precious";
  {
    H5mdRecorder recorder(path_, named_chain(4), {}, {.overwrite = true, .flush_seconds = 1e9});
    EXPECT_EQ(content_of(path_), "precious");
    EXPECT_THROW(recorder.record(sample_frame(0, 3).frame), InputError);
    EXPECT_EQ(content_of(path_), "precious");
  }
  EXPECT_EQ(content_of(path_), "precious") << "a recorder without frames leaves nothing behind";
  EXPECT_EQ(files(), 1);
  H5mdRecorder recorder(path_, named_chain(4), {}, {.overwrite = true, .flush_seconds = 1e9});
  recorder.record(sample_frame(0, 4).frame);
  EXPECT_EQ(H5mdReader(path_).frames(), 1);
}

/// A killed writer leaves its temporary file behind.
TEST_F(H5mdRecorderFiles, TakesOverWhatAKilledWriterLeft) {
  std::ofstream(directory_ / ".run.h5md.partial") << std::string(100'000, 'x');
  record_file(path_, 4, 2);
  EXPECT_EQ(H5mdReader(path_).frames(), 2);
  EXPECT_EQ(files(), 1);
}

/// A reader asks for the file's length before it reads in the superblock how long it is.
TEST_F(H5mdRecorderFiles, IsLongerThanTheNextCommitSays) {
  H5mdRecorder recorder(path_, named_chain(500), {}, {.flush_seconds = 0.0});
  std::uintmax_t before = 0;
  for (std::int64_t f = 0; f < 200; ++f) {
    recorder.record(sample_frame(f, 500).frame);
    std::ifstream file(path_, std::ios::binary);
    std::uint64_t end = 0;  // HDF5 File Format Specification, II.A, version 0: byte 40
    file.seekg(40).read(reinterpret_cast<char*>(&end), sizeof end);
    if (f > 0) {
      EXPECT_GE(before, end) << "frame " << f;
    }
    before = std::filesystem::file_size(path_);
  }
  recorder.close();
  std::uint64_t end = 0;
  std::ifstream(path_, std::ios::binary).seekg(40).read(reinterpret_cast<char*>(&end), sizeof end);
  EXPECT_EQ(std::filesystem::file_size(path_), end);
}

TEST_F(H5mdRecorderFiles, FollowsASymbolicLink) {
  record_file(directory_ / "real.h5md", 4, 1);
  std::filesystem::create_symlink("real.h5md", directory_ / "link.h5md");
  record_file(directory_ / "link.h5md", 4, 3, {.overwrite = true});
  EXPECT_TRUE(std::filesystem::is_symlink(directory_ / "link.h5md"));
  EXPECT_EQ(H5mdReader(directory_ / "real.h5md").frames(), 3);
}

TEST_F(H5mdRecorderFiles, NamesWhatIsWrongWithThePlace) {
  const auto message = [](const std::filesystem::path& path) {
    return error_text<FileError>(
        [&] { H5mdRecorder(path, named_chain(2), {}, {.overwrite = true}); });
  };
  const std::string base = directory_.path().string();
  EXPECT_EQ(message(directory_ / "no/run.h5md"),
            base + "/no/run.h5md: the directory " + base + "/no does not exist");
  EXPECT_EQ(message(directory_.path()), base + ": is a directory");
  std::ofstream(directory_ / "file") << "x";
  EXPECT_EQ(message(directory_ / "file/run.h5md"),
            base + "/file/run.h5md: " + base + "/file is not a directory");
  EXPECT_EQ(message("/dev/full"), "/dev/full: is not a regular file");
  EXPECT_EQ(message(""), "the name of the output file is empty");
}

TEST_F(H5mdRecorderFiles, SecondRecorderOfAFileIsRefused) {
  const std::string path = path_.string();
  H5mdRecorder first(path, named_chain(4));
  for (const bool overwrite : {false, true}) {
    EXPECT_THAT(error_text<FileError>(
                    [&] { H5mdRecorder(path, named_chain(4), {}, {.overwrite = overwrite}); }),
                HasSubstr(path + ": is being written by "));
  }
  record_frames(first, 4, 2);
  first.close();
  EXPECT_EQ(H5mdReader(path).frames(), 2);
  EXPECT_NO_THROW(H5mdRecorder(path, named_chain(4), {}, {.overwrite = true}));
}

/// A child that records and then waits to be killed; returns when its file is there.
pid_t start_recording_child(const std::string& path) {
  int ready[2];
  if (::pipe(ready) != 0) return -1;
  const pid_t child = ::fork();
  if (child == 0) {
    H5mdRecorder recorder(path, named_chain(4), {}, {.flush_seconds = 0.0});
    recorder.record(sample_frame(0, 4).frame);
    [[maybe_unused]] const auto written = ::write(ready[1], "x", 1);
    ::pause();
  }
  char byte = 0;
  [[maybe_unused]] const auto heard = ::read(ready[0], &byte, 1);
  ::close(ready[0]), ::close(ready[1]);
  return child;
}

TEST_F(H5mdRecorderFiles, NamesTheProcessThatWrites) {
  const std::string path = path_.string();
  const pid_t child = start_recording_child(path);
  EXPECT_ERROR(FileError, path + ": is being written by process " + std::to_string(child),
               H5mdRecorder(path, named_chain(4), {}, {.overwrite = true}));
  EXPECT_EQ(H5mdReader(path).frames(), 1) << "a reader is let in";
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_ERROR(FileError, path + ": exists already; overwrite replaces it",
               H5mdRecorder(path, named_chain(4)));
  EXPECT_NO_THROW(H5mdRecorder(path, named_chain(4), {}, {.overwrite = true}));
}

TEST_F(H5mdRecorderFiles, OneOfManyStartedAtOnceWins) {
  for (const bool overwrite : {false, true}) {
    const auto path = directory_ / (overwrite ? "over.h5md" : "new.h5md");
    std::atomic<int> winners = 0, losers = 0;
    std::vector<std::thread> threads;
    std::vector<std::unique_ptr<H5mdRecorder>> recorders(8);
    for (auto& recorder : recorders)
      threads.emplace_back([&] {
        try {
          recorder = std::make_unique<H5mdRecorder>(path, named_chain(4), H5mdHeader{},
                                                    H5mdOptions{.overwrite = overwrite});
          ++winners;
        } catch (const FileError&) {
          ++losers;
        }
      });
    for (auto& thread : threads) thread.join();
    EXPECT_EQ(winners, 1);
    EXPECT_EQ(losers, 7);
  }
}

TEST_F(H5mdRecorderFiles, CommitsInTimeAndOnDemand) {
  H5mdRecorder recorder(path_, named_chain(4), {}, {.flush_seconds = 0.02});
  recorder.record(sample_frame(0, 4).frame);
  ::usleep(30'000);
  recorder.record(sample_frame(1, 4).frame);
  EXPECT_EQ(recorder.committed_frames(), 2);
  H5mdRecorder patient(directory_ / "patient.h5md", named_chain(4), {}, {.flush_seconds = 1e9});
  patient.record(sample_frame(0, 4).frame);
  EXPECT_EQ(patient.committed_frames(), 1) << "the first at once";
  patient.record(sample_frame(1, 4).frame);
  EXPECT_EQ(patient.committed_frames(), 1);
  patient.flush();
  EXPECT_EQ(patient.committed_frames(), 2);
  EXPECT_EQ(H5mdReader(directory_ / "patient.h5md").frames(), 2);
}

TEST_F(H5mdRecorderFiles, MovesAndClosesTwice) {
  H5mdRecorder first(path_, named_chain(4));
  first.record(sample_frame(0, 4).frame);
  H5mdRecorder second = std::move(first);
  second.record(sample_frame(1, 4).frame);
  second.close();
  second.close();
  second.flush();
  EXPECT_EQ(second.committed_frames(), 2);
}

}  // namespace pliant::h5md_recorder_files_test
