// SPDX-License-Identifier: MIT
#include "pliant/sample/amplitudes.hpp"

#include <cmath>

#include "pliant/base/math/normal.hpp"

namespace pliant {
namespace {

/// Keys of blocks have no attempt; those of frames drawn again do.
RandomKey key_of(std::uint64_t seed, std::int64_t number, std::uint64_t mode,
                 std::uint64_t attempt) {
  return {seed, Domain::amplitude, attempt, static_cast<std::uint64_t>(number), mode};
}

void take_off_mean(std::span<double> x) {
  double sum = 0.0;
  for (double value : x) sum += value;
  for (double& value : x) value -= sum / double(x.size());
}

}  // namespace

DenseMatrix white_amplitudes(std::uint64_t seed, std::int64_t block, std::size_t modes) {
  constexpr auto frames = static_cast<std::size_t>(frames_a_block);
  DenseMatrix columns(modes, frames);
  for (std::size_t m = 0; m < modes; ++m) {
    const auto x = columns.row(m);
    RandomSequence draws(key_of(seed, block, m, 0));
    fill_normal(draws, x);
    for (int again = 0; again < 2; ++again) {  // Gram and Schmidt, twice for the sake of rounding
      take_off_mean(x);
      for (std::size_t k = 0; k < m; ++k)
        add_scaled(-dot_product(columns.row(k), x) / double(frames), columns.row(k), x);
    }
    const double scale = std::sqrt(double(frames) / dot_product(x, x));
    for (double& value : x) value *= scale;
  }
  DenseMatrix out(frames, modes);
  for (std::size_t f = 0; f < frames; ++f)
    for (std::size_t m = 0; m < modes; ++m) out(f, m) = columns(m, f);
  return out;
}

std::vector<double> redrawn_amplitudes(std::uint64_t seed, std::int64_t frame, int attempt,
                                       std::size_t modes) {
  std::vector<double> out(modes);
  RandomSequence draws(key_of(seed, frame, 0, static_cast<std::uint64_t>(attempt)));
  fill_normal(draws, out);
  return out;
}

}  // namespace pliant
