// SPDX-License-Identifier: MIT
// Amplitudes of frames along modes: normal random numbers that are white in blocks of frames, so
// that a hundred frames already have the exact mean and covariance of the Gaussian.
#pragma once

#include <cstdint>

#include "pliant/base/math/dense_matrix.hpp"

namespace pliant {

/// Number of frames in a block.
inline constexpr std::int64_t frames_a_block = 100;

/// (100 x modes) amplitudes of one block: sqrt(100) Q of the QR factors of normal random numbers
/// with the mean of each column subtracted. Columns have exactly mean 0 and variance 1 and are
/// uncorrelated. Depends on the arguments alone. `modes` is at most 99.
DenseMatrix white_amplitudes(std::uint64_t seed, std::int64_t block, std::size_t modes);

/// Independent normal random numbers to replace those of a frame that could not be resolved;
/// `attempt` counts from 1.
std::vector<double> redrawn_amplitudes(std::uint64_t seed, std::int64_t frame, int attempt,
                                       std::size_t modes);

}  // namespace pliant
