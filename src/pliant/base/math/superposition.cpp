// SPDX-License-Identifier: MIT
#include "pliant/base/math/superposition.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace pliant {
namespace {

constexpr int most_rounds = 20;
constexpr double settled = 1e-7;  // of what points are measured in
constexpr std::size_t least_points = 3;

Vec3 centre_of(std::span<const Vec3> points) {
  Vec3 sum;
  for (Vec3 point : points) sum += point;
  return (1.0 / double(points.empty() ? 1 : points.size())) * sum;
}

std::vector<Vec3> mean_of(const std::vector<std::vector<Vec3>>& frames) {
  std::vector<Vec3> mean(frames.front().size());
  for (const std::vector<Vec3>& frame : frames)
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += frame[i];
  for (Vec3& point : mean) point = (1.0 / double(frames.size())) * point;
  return mean;
}

double rms_distance(std::span<const Vec3> a, std::span<const Vec3> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += norm_squared(a[i] - b[i]);
  return std::sqrt(sum / double(a.empty() ? 1 : a.size()));
}

void superpose(std::vector<std::vector<Vec3>>& frames, std::span<const Vec3> goal) {
  for (std::vector<Vec3>& frame : frames) {
    const RigidMotion motion = superposition(frame, goal);
    for (Vec3& point : frame) point = motion(point);
  }
}

}  // namespace

RigidMotion superposition(std::span<const Vec3> points, std::span<const Vec3> goal) {
  const Vec3 from = centre_of(points), to = centre_of(goal);
  RigidMotion out{{}, to - from};
  if (points.size() < least_points) return out;
  RotationFit fit;
  for (std::size_t i = 0; i < points.size(); ++i) fit.add(points[i] - from, goal[i] - to, 1.0);
  if (fit.solve(false, out.rotation) != RotationFit::Fit::fitted) out.rotation = {};
  out.shift = to - out.rotation(from);
  return out;
}

std::vector<double> superposed_fluctuations(std::vector<std::vector<Vec3>> frames) {
  if (frames.empty()) return {};
  std::vector<Vec3> mean = frames.front();
  for (int round = 0; round < most_rounds; ++round) {
    superpose(frames, mean);
    std::vector<Vec3> next = mean_of(frames);
    const double moved = rms_distance(next, mean);
    mean = std::move(next);
    if (moved < settled) break;
  }
  std::vector<double> out(mean.size(), 0.0);
  for (const std::vector<Vec3>& frame : frames)
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += norm_squared(frame[i] - mean[i]);
  for (double& value : out) value = std::sqrt(value / double(frames.size()));
  return out;
}

}  // namespace pliant
