// SPDX-License-Identifier: MIT
// Runs that are recorded, go on from their files, and are compared.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

#include "pliant/jobs/files/run_checkpoint.hpp"
#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/run/run.hpp"
#include "pliant/run/run_fields.hpp"
#include "support/frameworks.hpp"

namespace pliant::test {

inline void run_into(H5mdRecorder recorder, const Framework& framework, State state,
                     const RunOptions& options) {
  run(framework, state, options, {[&](const Frame& frame) {
        recorder.record(frame);
        return false;
      }});
  recorder.end_run(state);
  recorder.close();
}

/// Records a run from its start.
inline void record_run(const std::filesystem::path& path, const Framework& framework,
                       const State& start, const RunOptions& options,
                       const H5mdOptions& recording = {}) {
  H5mdHeader header;
  header.parameters = parameters_of(options, framework);
  header.inputs = run_inputs(options);
  run_into(H5mdRecorder(path, framework, header, recording), framework, start, options);
}

/// Goes on with the run of a file, up to `steps` in all.
inline void go_on(const std::filesystem::path& path, std::int64_t steps,
                  const H5mdOptions& recording = {}) {
  const H5mdCheckpoint from = read_checkpoint(path, steps);
  run_into(H5mdRecorder(from, recording), from.framework, from.state, run_options_from(from));
}

/// Positions, steps, times, observables and parameters, bit by bit.
inline void expect_same_file(const std::filesystem::path& one, const std::filesystem::path& other) {
  const H5mdReader a(one), b(other);
  ASSERT_EQ(a.frames(), b.frames());
  EXPECT_EQ(a.frames_left_out(), b.frames_left_out());
  for (std::int64_t f = 0; f < a.frames(); ++f) {
    EXPECT_EQ(a.step(f), b.step(f));
    EXPECT_EQ(a.time(f), b.time(f));
    EXPECT_TRUE(same_bits(a.positions(f), b.positions(f))) << "frame " << f;
  }
  ASSERT_EQ(a.observables(), b.observables());
  for (const std::string& name : a.observables())
    EXPECT_EQ(a.observable(name), b.observable(name)) << name;
  EXPECT_EQ(a.parameters(), b.parameters());
}

}  // namespace pliant::test
