// SPDX-License-Identifier: MIT
#include "pliant/sample/sample_summary.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "pliant/base/math/superposition.hpp"

namespace pliant {
namespace {

constexpr double least_reached = 0.5;  // share of the amplitude asked for

std::string two_digits(double value) {
  const auto hundredths = static_cast<std::int64_t>(std::llround(100.0 * value));
  const std::string rest = std::to_string(hundredths % 100);
  return std::to_string(hundredths / 100) + (rest.size() < 2 ? ".0" : ".") + rest;
}

}  // namespace

void warn_of_amplitude(const SampleSummary& summary, const Log& log) {
  if (summary.near_frames < 2 || !(summary.amplitude_reached < least_reached * summary.amplitude_asked))
    return;
  log.warn("frames reach an amplitude of " + two_digits(summary.amplitude_reached) + " of the " +
           two_digits(summary.amplitude_asked) +
           " Angstrom asked for: the molecule is held too tightly to move that far");
}

FluctuationSums::FluctuationSums(std::span<const Vec3> start, std::vector<std::size_t> fitted)
    : start_(start.begin(), start.end()), fitted_(std::move(fitted)), points_(fitted_.size()) {
  for (std::size_t joint : fitted_) goal_.push_back(start_[joint]);
  for (Half& half : halves_) {
    half.sum.resize(start.size());
    half.squares.assign(start.size(), 0.0);
  }
}

void FluctuationSums::add(std::span<const Vec3> positions, bool is_second) {
  Half& half = halves_[is_second ? 1 : 0];
  ++half.frames;
  for (std::size_t k = 0; k < fitted_.size(); ++k) points_[k] = positions[fitted_[k]];
  const RigidMotion motion = superposition(points_, goal_);
  for (std::size_t k = 0; k < start_.size(); ++k) {
    const Vec3 move = motion(positions[k]) - start_[k];
    half.sum[k] += move;
    half.squares[k] += norm_squared(move);
  }
}

std::vector<double> FluctuationSums::rmsf_of(const Half& half) {
  std::vector<double> out(half.sum.size(), 0.0);
  if (half.frames == 0) return out;
  const double share = 1.0 / double(half.frames);
  for (std::size_t k = 0; k < out.size(); ++k)
    out[k] = std::sqrt(std::max(0.0, share * half.squares[k] - norm_squared(share * half.sum[k])));
  return out;
}

std::vector<double> FluctuationSums::rmsf() const {
  Half both = halves_[0];
  both.frames += halves_[1].frames;
  for (std::size_t k = 0; k < both.sum.size(); ++k) {
    both.sum[k] += halves_[1].sum[k];
    both.squares[k] += halves_[1].squares[k];
  }
  return rmsf_of(both);
}

std::vector<double> FluctuationSums::error() const {
  std::vector<double> out = rmsf_of(halves_[0]);
  const std::vector<double> other = rmsf_of(halves_[1]);
  const bool has_both = halves_[0].frames > 0 && halves_[1].frames > 0;
  for (std::size_t k = 0; k < out.size(); ++k)
    out[k] = has_both ? 0.5 * std::abs(out[k] - other[k]) : 0.0;
  return out;
}

}  // namespace pliant
