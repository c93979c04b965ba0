// SPDX-License-Identifier: MIT
// A small named framework, frames with known contents and short recordings of them, for tests of
// the record folder.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "support/error_text.hpp"
#include "support/temp_directory.hpp"

namespace pliant::test {

/// N joints in a chain, two residues, the first joint pinned.
inline Framework named_chain(std::size_t count) {
  FrameworkParts parts;
  parts.joint_count = count;
  auto atoms = std::make_shared<AtomTable>();
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) {
      parts.bars.push_back({static_cast<Joint>(i - 1), static_cast<Joint>(i)});
      parts.rest_lengths.push_back(1.0 + 0.25 * double(i));
    }
    parts.masses.push_back(12.0 + double(i));
    atoms->names.push_back(i % 2 == 0 ? "CA" : "HB11");
    atoms->elements.push_back(i % 2 == 0 ? 6 : 1);
    atoms->residue_of.push_back(i < count / 2 ? 0 : 1);
    atoms->serials.push_back(static_cast<std::int64_t>(i) + 100);
  }
  atoms->residues = {{"ALA", -3, ' ', "A"}, {"LYS", -3, 'B', "A"}};
  parts.pinned = {0};
  parts.atoms = atoms;
  return Framework(std::move(parts));
}

/// N joints without names or bars.
inline Framework bare(std::size_t count) {
  FrameworkParts parts;
  parts.joint_count = count;
  return Framework(std::move(parts));
}

inline double coordinate(std::int64_t frame, std::size_t joint, int axis) {
  return std::sin(double(frame) * 0.7 + double(joint) + 0.1 * axis) + double(joint);
}

/// A frame and the positions it shows.
struct SampleFrame {
  std::vector<Vec3> positions;
  Frame frame;
};

inline SampleFrame sample_frame(std::int64_t number, std::size_t joints) {
  SampleFrame sample;
  for (std::size_t i = 0; i < joints; ++i)
    sample.positions.push_back(
        {coordinate(number, i, 0), coordinate(number, i, 1), coordinate(number, i, 2)});
  Frame& frame = sample.frame;
  frame.positions = sample.positions;  // the buffer stays where it is when the sample is moved
  frame.step = 5 * number;
  frame.time = 0.25 * double(number);
  frame.sweeps = number + 1;
  frame.projections = 10 * number;
  frame.max_residual = 1e-6 * double(number);
  frame.rms_residual = 1e-7 * double(number);
  frame.stop = number % 3 == 2 ? Stop::max_sweeps : Stop::converged;
  frame.root_joint = number == 0 ? no_joint : number % std::int64_t(joints);
  frame.force = {1.0 * double(number), 0.5, -2.0};
  return sample;
}

/// A test that writes a file.
class FileTest : public testing::Test {
 protected:
  /// Files beside the one that is written, and this.
  std::ptrdiff_t files() const {
    return std::distance(std::filesystem::directory_iterator(directory_.path()), {});
  }

  TempDirectory directory_;
  std::filesystem::path path_ = directory_ / "run.h5md";
};

inline H5mdHeader sample_header() {
  H5mdHeader header;
  header.bonds = {{0, 1, 0, 1}, {1, 2, 3, 2}, {0, 3, 1, 4}};
  header.bond_origin_names = {"file", "residue", "link", "distance"};
  header.parameters = {{"run/seed", std::int64_t{-9'000'000'000}},
                       {"run/tolerance", 1e-6},
                       {"input/file", std::string("caff\xc3\xa9ine.xyz")},
                       {"run/replayed", true}};
  return header;
}

inline void record_frames(H5mdRecorder& recorder, std::size_t joints, std::int64_t frames) {
  for (std::int64_t f = 0; f < frames; ++f) recorder.record(sample_frame(f, joints).frame);
}

inline void record_file(const std::filesystem::path& path, std::size_t joints, std::int64_t frames,
                        const H5mdOptions& options = {}) {
  H5mdRecorder recorder(path, named_chain(joints), sample_header(), options);
  record_frames(recorder, joints, frames);
  recorder.close();
}

}  // namespace pliant::test
