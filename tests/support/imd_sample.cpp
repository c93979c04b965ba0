// SPDX-License-Identifier: MIT
// Serves frames over IMD that are known, for other programs to read. Frame f, joint i lies at
// (1.5 i, f + i, 0.001 f) Angstrom. Prints the port first, at the end what came of it. Not one
// frame is dropped.
//
//   imd_sample JOINTS FRAMES VERSION [swapped]
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/stream/imd_server.hpp"

namespace {

using namespace pliant;

void show(ImdServer& server, std::size_t joints, std::int64_t number) {
  std::vector<Vec3> positions(joints);
  for (std::size_t i = 0; i < joints; ++i)
    positions[i] = {1.5 * double(i), double(number) + double(i), 0.001 * double(number)};
  Frame frame;
  frame.step = number;
  frame.time = 0.01 * double(number);
  frame.positions = positions;
  frame.sweeps = 3;
  frame.max_residual = 0.5;
  server.show(frame);
}

int serve(const std::vector<std::string>& words) {
  ImdOptions options;
  options.port = 0;
  options.wait = true;
  options.version = std::stoi(words[3]);
  options.swapped = words.size() > 4 && words[4] == "swapped";
  const std::chrono::milliseconds patience = std::chrono::minutes(15);  // what reads may be slow
  options.patience = {patience, patience, patience, patience};
  const auto joints = static_cast<std::size_t>(std::stoul(words[1]));
  const std::int64_t frames = std::stoll(words[2]);
  ImdServer server(joints, options, std::make_shared<Steering>());
  std::printf("%d\n", server.port());
  std::fflush(stdout);
  for (std::int64_t number = 0; number < frames && !server.was_killed(); ++number)
    if (server.wants(number)) show(server, joints, number);
  const ImdSummary served = server.close();
  std::printf("%lld sent, %lld dropped, %lld refused\n", static_cast<long long>(served.frames_sent),
              static_cast<long long>(served.frames_dropped),
              static_cast<long long>(served.refused));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return serve({argv, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "imd_sample: %s\n", error.what());
    return 1;
  }
}
