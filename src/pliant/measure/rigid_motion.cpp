// SPDX-License-Identifier: MIT
#include "pliant/measure/rigid_motion.hpp"

#include <array>

#include "pliant/base/math/dense_matrix.hpp"
#include "pliant/base/math/symmetric_eigen.hpp"

namespace pliant {
namespace {

/// Motions that sites hardly tell apart, as turns of sites in a line, by their squares.
constexpr double least_share_of_motion = 1e-9;

using Square = std::array<std::array<double, 6>, 6>;

/// Shifts along x, y, z and turns about them: what each does to a site `arm` from the middle.
std::array<Vec3, 6> rigid_motions(Vec3 arm) {
  return {Vec3{1.0, 0.0, 0.0},      Vec3{0.0, 1.0, 0.0},      Vec3{0.0, 0.0, 1.0},
          Vec3{0.0, -arm.z, arm.y}, Vec3{arm.z, 0.0, -arm.x}, Vec3{-arm.y, arm.x, 0.0}};
}

Square pseudo_inverse(const DenseMatrix& square) {
  const EigenPairs pairs = symmetric_eigen(square);
  Square found{};
  for (std::size_t m = 0; m < 6; ++m) {
    if (!(pairs.values[m] > least_share_of_motion * pairs.values[5])) continue;
    const std::span<const double> vector = pairs.vectors.row(m);
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j) found[i][j] += vector[i] * vector[j] / pairs.values[m];
  }
  return found;
}

class BestMotion {
 public:
  BestMotion(const SiteMoves& sites, std::span<const std::int64_t> body)
      : sites_(sites), frames_(sites.weights.size()), along_(6 * frames_), amounts_(6 * frames_) {
    for (const std::int64_t site : body) middle_ += sites.mean[site];
    middle_ *= 1.0 / static_cast<double>(body.size());
    DenseMatrix square(6, 6);
    for (const std::int64_t site : body) add(static_cast<std::size_t>(site), square);
    find_amounts(pseudo_inverse(square));
  }

  /// Mean square of what is left of the moves of a site.
  double left_of(std::size_t site) const {
    const Vec3 arm = sites_.mean[site] - middle_;
    const auto x = static_cast<float>(arm.x), y = static_cast<float>(arm.y),
               z = static_cast<float>(arm.z);
    const float* own = &sites_.moves[3 * site * frames_];
    return left_along(own, 0, row(4), z, row(5), -y) +
           left_along(own + frames_, 1, row(5), x, row(3), -z) +
           left_along(own + 2 * frames_, 2, row(3), y, row(4), -x);
  }

 private:
  static constexpr std::size_t lanes = 16;

  const float* row(std::size_t motion) const { return &amounts_[motion * frames_]; }

  void add(std::size_t site, DenseMatrix& square) {
    const std::array<Vec3, 6> motions = rigid_motions(sites_.mean[site] - middle_);
    const float* x = &sites_.moves[3 * site * frames_];
    const float *y = x + frames_, *z = y + frames_;
    for (std::size_t k = 0; k < 6; ++k) {
      for (std::size_t m = 0; m < 6; ++m) square.row(k)[m] += dot(motions[k], motions[m]);
      const auto a = static_cast<float>(motions[k].x), b = static_cast<float>(motions[k].y),
                 c = static_cast<float>(motions[k].z);
      float* along = &along_[k * frames_];
      for (std::size_t f = 0; f < frames_; ++f) along[f] += a * x[f] + (b * y[f] + c * z[f]);
    }
  }

  void find_amounts(const Square& inverse) {
    for (std::size_t k = 0; k < 6; ++k)
      for (std::size_t m = 0; m < 6; ++m) {
        const auto share = static_cast<float>(inverse[k][m]);
        for (std::size_t f = 0; f < frames_; ++f)
          amounts_[k * frames_ + f] += share * along_[m * frames_ + f];
      }
  }

  /// Mean square of `moves` less a shift along their axis and two turns about the others.
  double left_along(const float* moves, std::size_t shift, const float* one, float arm_one,
                    const float* other, float arm_other) const {
    const float* shifts = row(shift);
    std::array<float, lanes> sums{};
    std::size_t f = 0;
    const auto left = [&](std::size_t at) {
      const float rest = moves[at] - (shifts[at] + (arm_one * one[at] + arm_other * other[at]));
      return sites_.weights[at] * (rest * rest);
    };
    for (; f + lanes <= frames_; f += lanes)
      for (std::size_t k = 0; k < lanes; ++k) sums[k] += left(f + k);
    double sum = 0.0;
    for (; f < frames_; ++f) sum += left(f);
    for (const float one_sum : sums) sum += one_sum;
    return sum;
  }

  const SiteMoves& sites_;
  std::size_t frames_;
  Vec3 middle_;
  std::vector<float> along_;    ///< (6 x F) of the motions: their products with the moves
  std::vector<float> amounts_;  ///< (6 x F) of the motions, in the one that fits best
};

}  // namespace

std::vector<double> left_by_rigid_motion(const SiteMoves& sites,
                                         std::span<const std::int64_t> body) {
  const BestMotion motion(sites, body);
  std::vector<double> left(sites.mean.size());
  for (std::size_t site = 0; site < left.size(); ++site) left[site] = motion.left_of(site);
  return left;
}

}  // namespace pliant
