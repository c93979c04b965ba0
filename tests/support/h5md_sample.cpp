// SPDX-License-Identifier: MIT
// Writes an H5MD file of a made-up molecule that moves in a known way, for tests in Python and for
// timing. Frame f, joint i lies at (1.5 i, 0.1 sin(f + i), 0.001 f) Angstrom.
//
//   h5md_sample OUT.h5md JOINTS FRAMES [single] [compress] [each] [overwrite] [kill]
//
// "each" commits every frame; "kill" ends by SIGKILL after the last commit, without closing.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"

namespace {

using namespace pliant;

constexpr std::size_t atoms_per_residue = 4;

AtomTable make_atoms(std::size_t count) {
  AtomTable atoms;
  const char* names[] = {"N", "CA", "C", "O"};
  const std::uint8_t elements[] = {7, 6, 6, 8};
  for (std::size_t i = 0; i < count; ++i) {
    atoms.names.emplace_back(names[i % atoms_per_residue]);
    atoms.elements.push_back(elements[i % atoms_per_residue]);
    atoms.residue_of.push_back(static_cast<std::uint32_t>(i / atoms_per_residue));
    atoms.serials.push_back(static_cast<std::int64_t>(i) + 1);
  }
  for (std::size_t r = 0; r <= (count - 1) / atoms_per_residue; ++r)
    atoms.residues.push_back(
        {"GLY", static_cast<std::int64_t>(r / 2) + 1, r % 2 ? 'A' : ' ', r < 4 ? "A" : "B"});
  return atoms;
}

Framework make_framework(std::size_t count) {
  FrameworkParts parts;
  parts.joint_count = count;
  for (Joint i = 0; i + 1 < count; ++i) {
    parts.bars.push_back({i, i + 1});
    parts.rest_lengths.push_back(1.5);
  }
  for (std::size_t i = 0; i < count; ++i) parts.masses.push_back(12.0 + double(i % 4));
  parts.pinned = {0};
  parts.atoms = std::make_shared<AtomTable>(make_atoms(count));
  return Framework(std::move(parts));
}

H5mdHeader make_header(const Framework& framework) {
  H5mdHeader header;
  for (const Bar bar : framework.bars())
    header.bonds.push_back({bar.a, bar.b, static_cast<std::uint8_t>(bar.a % 4), 1});
  header.bond_origin_names = {"file", "residue", "link", "distance"};
  header.creator_version = "0.1.0";
  header.parameters = {{"run/seed", std::int64_t{7}},
                       {"run/tolerance", 1e-6},
                       {"run/replayed", false},
                       {"technique/ordering", std::string("bfs_cycle")}};
  return header;
}

void place(std::vector<Vec3>& positions, std::int64_t frame) {
  for (std::size_t i = 0; i < positions.size(); ++i)
    positions[i] = {1.5 * double(i), 0.1 * std::sin(double(frame) + double(i)),
                    0.001 * double(frame)};
}

Frame make_frame(const std::vector<Vec3>& positions, std::int64_t f) {
  Frame frame;
  frame.step = 10 * f;
  frame.time = 0.5 * double(f);
  frame.positions = positions;
  frame.sweeps = f % 7;
  frame.projections = 3 * f;
  frame.max_residual = 1e-7 * double(f);
  frame.rms_residual = 1e-8 * double(f);
  frame.stop = f % 5 == 4 ? Stop::max_sweeps : Stop::converged;
  frame.root_joint = f == 0 ? no_joint : f % std::int64_t(positions.size());
  frame.force = {double(f), 0.0, -double(f)};
  return frame;
}

double record(H5mdRecorder& recorder, std::size_t joints, std::int64_t frames) {
  std::vector<Vec3> positions(joints);
  double seconds = 0.0;
  place(positions, 0);
  for (std::int64_t f = 0; f < frames; ++f) {
    if (joints * std::size_t(frames) < 10'000'000) place(positions, f);
    const auto start = std::chrono::steady_clock::now();
    recorder.record(make_frame(positions, f));
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  return seconds;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 4) return std::fprintf(stderr, "usage: h5md_sample OUT JOINTS FRAMES ...\n"), 2;
  const std::vector<std::string> words(argv + 4, argv + argc);
  const auto asked = [&](const char* word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  H5mdOptions options;
  options.single = asked("single");
  options.compress = asked("compress");
  options.overwrite = asked("overwrite");
  if (asked("each")) options.flush_seconds = 0.0;
  const auto joints = static_cast<std::size_t>(std::stoul(argv[2]));
  const Framework framework = make_framework(joints);
  H5mdRecorder recorder(argv[1], framework, make_header(framework), options);
  const double seconds = record(recorder, joints, std::stol(argv[3]));
  if (asked("kill")) {
    recorder.flush();
    std::raise(SIGKILL);
  }
  const auto start = std::chrono::steady_clock::now();
  recorder.close();
  const double total =
      seconds + std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("%.1f us a frame, %.0f MB/s\n", 1e6 * total / std::stod(argv[3]),
              double(joints) * 24.0 * std::stod(argv[3]) / total / 1e6);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
