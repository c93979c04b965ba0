// SPDX-License-Identifier: MIT
// Log of commits: what a run in one file, or a sample, has reached, for it to go on after a kill.
//
// The trajectory of several walkers is written in one go, because HDF5 files that were closed and
// opened again have other bytes. What is done meanwhile is kept in a file of its own, which has no
// other use and goes when the trajectory is complete. It consists of 64-bit words in the order of
// bytes of the machine:
//   "PLIANTCL", key of the run; then for each commit
//   number of words that follow the digest, digest of them,
//   walker, 1 if it is done, frames before these, state, number of frames, frames
// A commit that a kill cut short, and all behind it, does not count. Nothing is locked: whoever
// takes over renames the file, and the one before finds it gone and commits no more.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/base/parameter.hpp"
#include "pliant/base/threads/threads.hpp"
#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/jobs/files/kept_frames.hpp"

namespace pliant {

/// Says which run it is: the same version, framework, start and options give the same number.
std::uint64_t key_of_run(const Framework& framework, std::span<const Vec3> start,
                         std::span<const NamedParameter> parameters);

/// What a walker had reached at its last commit.
struct Committed {
  State state;
  std::size_t frames = 0;
  bool is_done = false;
};

/// Calls from several threads may overlap.
class CommitLog {
 public:
  /// Makes the file, or reads what is there. Throws FileError with the system's reason; InputError
  /// where it is no log, or that of another run.
  CommitLog(std::filesystem::path path, std::uint64_t key, Log log = {});

  /// None where nothing was committed of this walker.
  std::optional<Committed> committed(std::int64_t walker) const;
  /// Shows the committed frames of a walker, in their order. Throws FileError.
  void replay(std::int64_t walker, const std::function<void(const Frame&)>& show) const;

  /// Adds the frames from `first` on and the state behind them; `before`: frames of the walker that
  /// were committed and are not among these. Throws FileError, except where the file is gone: then
  /// it warns once, and the run goes on without commits.
  void commit(std::int64_t walker, const KeptFrames& frames, std::size_t first, const State& state,
              bool is_done, std::size_t before = 0);
  std::int64_t commits() const { return commits_; }
  /// Once all is written elsewhere.
  void remove();

 private:
  struct Place {
    std::uint64_t at;     ///< of the first word behind the digest
    std::uint64_t words;  ///< behind the digest
  };
  struct Walker {
    Committed reached;
    std::vector<Place> places;
  };

  void begin(std::uint64_t key);
  void read(std::uint64_t key);
  bool take(std::span<const std::uint64_t> words, Place place);
  void append(std::span<const std::uint64_t> words);

  std::filesystem::path path_;
  Log log_;
  Mutex writing_;
  std::map<std::int64_t, Walker> walkers_;  ///< of the file as it was opened
  std::uint64_t end_ = 0;                   ///< bytes that count
  std::int64_t commits_ = 0;                ///< made by this object
  bool is_gone_ = false;
};

}  // namespace pliant
