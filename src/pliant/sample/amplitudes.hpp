// SPDX-License-Identifier: MIT
// How far each frame goes along each mode: normal numbers that are white in blocks of frames, so
// that a hundred frames already have the mean and the covariance of the Gaussian.
#pragma once

#include <cstdint>

#include "pliant/base/math/dense_matrix.hpp"

namespace pliant {

/// Frames of a block.
inline constexpr std::int64_t frames_a_block = 100;

/// (100 x modes) amplitudes of one block: sqrt(100) Q of the QR factors of normal numbers whose
/// columns have had their means taken off. Each column has mean 0 and variance 1, and no two are
/// correlated, exactly. A function of its arguments alone. `modes` is up to 99.
DenseMatrix white_amplitudes(std::uint64_t seed, std::int64_t block, std::size_t modes);

/// Independent normal numbers in place of those of a frame that could not be resolved; `attempt`
/// from 1.
std::vector<double> redrawn_amplitudes(std::uint64_t seed, std::int64_t frame, int attempt,
                                       std::size_t modes);

}  // namespace pliant
