// SPDX-License-Identifier: MIT
// Short recordings for the tests of recorders.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "pliant/record/h5md/h5md_recorder.hpp"
#include "unit/record/samples.hpp"

namespace pliant::test {

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
  H5mdRecorder recorder(path, chain(joints), sample_header(), options);
  record_frames(recorder, joints, frames);
  recorder.close();
}

inline std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace pliant::test
