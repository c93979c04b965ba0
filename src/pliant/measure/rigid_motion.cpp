// SPDX-License-Identifier: MIT
#include "pliant/measure/rigid_motion.hpp"

#include <cmath>

namespace pliant {
namespace {

/// Motions that sites hardly tell apart, as turns of sites in a line, by their squares.
constexpr double least_share_of_motion = 1e-9;
constexpr std::size_t rigid = 6, products = rigid * (rigid + 1) / 2;

/// Shifts along x, y, z and turns about them: what each does to a site.
std::array<Vec3, rigid> rigid_motions(Vec3 at) {
  return {Vec3{1.0, 0.0, 0.0},    Vec3{0.0, 1.0, 0.0},    Vec3{0.0, 0.0, 1.0},
          Vec3{0.0, -at.z, at.y}, Vec3{at.z, 0.0, -at.x}, Vec3{-at.y, at.x, 0.0}};
}

/// Sums over sites of the products of rigid motions with each other (the lower triangle), and then
/// with the moves (6 x m): sums of two bodies add, so that those of stretches are differences.
class Sums {
 public:
  explicit Sums(const SiteMoves& sites) : motions_(sites.motions()), along_(rigid * motions_) {
    for (const Vec3& place : sites.mean) middle_ += place;
    middle_ *= 1.0 / static_cast<double>(sites.mean.size());
  }

  std::size_t width() const { return products + rigid * motions_; }

  /// Those of one site.
  void of(const SiteMoves& sites, std::size_t site, double* sums) const {
    const std::array<Vec3, rigid> of_body = rigid_motions(sites.mean[site] - middle_);
    const double* x = &sites.moves[3 * site * motions_];
    const double *y = x + motions_, *z = y + motions_;
    for (std::size_t i = 0; i < rigid; ++i) {
      for (std::size_t j = 0; j <= i; ++j) *sums++ = dot(of_body[i], of_body[j]);
    }
    for (const Vec3& one : of_body)
      for (std::size_t k = 0; k < motions_; ++k)
        *sums++ = one.x * x[k] + one.y * y[k] + one.z * z[k];
  }

  /// b^T S^-1 b by Cholesky's decomposition, for all moves together.
  double followed(const double* sums) {
    const double *row = sums, *moves = sums + products;
    std::array<std::array<double, rigid>, rigid> lower{};
    double total = 0.0;
    for (std::size_t i = 0; i < rigid; row += ++i) {
      double* own = &along_[i * motions_];
      for (std::size_t k = 0; k < motions_; ++k) own[k] = moves[i * motions_ + k];
      double pivot = row[i];
      for (std::size_t j = 0; j < i; ++j) {
        const double part = lower[i][j] = over_pivot(row[j], lower, i, j);
        pivot -= part * part;
        const double* before = &along_[j * motions_];
        for (std::size_t k = 0; k < motions_; ++k) own[k] -= part * before[k];
      }
      const bool is_told = pivot > least_share_of_motion * row[i];
      lower[i][i] = is_told ? 1.0 / std::sqrt(pivot) : 0.0;
      for (std::size_t k = 0; k < motions_; ++k) {
        own[k] *= lower[i][i];
        total += own[k] * own[k];
      }
    }
    return total;
  }

 private:
  /// An entry of the lower triangle, on whose diagonal are the inverses.
  static double over_pivot(double sum, const std::array<std::array<double, rigid>, rigid>& lower,
                           std::size_t i, std::size_t j) {
    for (std::size_t k = 0; k < j; ++k) sum -= lower[i][k] * lower[j][k];
    return sum * lower[j][j];
  }

  std::size_t motions_;
  Vec3 middle_;
  std::vector<double> along_;  ///< (6 x m)
};

}  // namespace

std::vector<std::array<double, 2>> followed_rigidly(const SiteMoves& sites,
                                                    std::span<const std::uint8_t> is_one,
                                                    std::span<const Stretch> stretches) {
  Sums sums(sites);
  const std::size_t width = sums.width(), count = sites.mean.size();
  // of the sites before each, those of the other body less those of the one
  std::vector<double> before((count + 1) * width, 0.0), own(width), one(width, 0.0);
  for (std::size_t site = 0; site < count; ++site) {
    sums.of(sites, site, own.data());
    const double side = is_one[site] ? -1.0 : 1.0;
    double* next = &before[(site + 1) * width];
    for (std::size_t k = 0; k < width; ++k) next[k] = next[k - width] + side * own[k];
    if (is_one[site])
      for (std::size_t k = 0; k < width; ++k) one[k] += own[k];
  }
  std::vector<std::array<double, 2>> found;
  std::vector<double> changed(width), rest(width);
  const double* difference = &before[count * width];
  for (const auto& [first, end] : stretches) {
    const double *low = &before[static_cast<std::size_t>(first) * width],
                 *high = &before[static_cast<std::size_t>(end) * width];
    for (std::size_t k = 0; k < width; ++k) {
      changed[k] = one[k] + (high[k] - low[k]);
      rest[k] = difference[k] + 2.0 * one[k] - changed[k];
    }
    found.push_back({sums.followed(changed.data()), sums.followed(rest.data())});
  }
  return found;
}

}  // namespace pliant
