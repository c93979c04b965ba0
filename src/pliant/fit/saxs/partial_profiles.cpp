// SPDX-License-Identifier: MIT
#include "pliant/fit/saxs/partial_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/fit/saxs/exposure.hpp"

namespace pliant {
namespace {

constexpr double bin_width = 0.05;  // Angstrom
constexpr double longest_of = 2e4;  // Angstrom

std::size_t bins_for(double longest) {
  if (!(longest <= longest_of))
    throw InputError("positions: expected distances of at most " + number_text(longest_of) +
                     " Angstrom, found " + number_text(longest));
  return static_cast<std::size_t>(longest / bin_width) + 2;  // one for what is rounded
}

std::vector<double> waves_of(std::span<const double> q, std::size_t bins) {
  std::vector<double> waves;
  waves.reserve(bins * q.size());
  for (std::size_t b = 0; b < bins; ++b)
    for (const double one : q) waves.push_back(wave_between(one, bin_width * (double(b) + 0.5)));
  return waves;
}

/// Place of a pair of kinds k <= l among all such pairs.
std::size_t pair_row(std::size_t k, std::size_t l) { return l * (l + 1) / 2 + k; }

std::span<double> part_of(std::span<double> profiles, Partial partial) {
  const std::size_t size = profiles.size() / partial_count;
  return profiles.subspan(static_cast<std::size_t>(partial) * size, size);
}

/// to += weight a b c.
void add_product(std::span<double> to, double weight, const std::vector<double>& a,
                 const std::vector<double>& b, const std::vector<double>& c) {
  for (std::size_t k = 0; k < to.size(); ++k) to[k] += weight * (a[k] * b[k] * c[k]);
}

}  // namespace

/// Counts the distances of one set of positions.
class PartialProfiles::Counter {
 public:
  Counter(const PartialProfiles& of, std::span<const Vec3> positions)
      : of_(of),
        pairs_(pair_row(0, of.kinds_.size()) * of.bins_),
        touched_(of.kinds_.size() * of.bins_),
        layer_(of.bins_),
        bin_(positions.size()) {
    const std::vector<std::uint32_t> exposed = exposures(of.groups_, positions);
    for (const std::uint32_t group : of.order_) {
      const Vec3 at = positions[group] - positions[0];
      x_.push_back(float(at.x));
      y_.push_back(float(at.y));
      z_.push_back(float(at.z));
      exposed_.push_back(exposed[group]);
    }
    for (std::size_t k = 0; k < of.kinds_.size(); ++k)
      for (std::size_t i = of.kinds_[k].first; i < of.kinds_[k].last; ++i) count_from(i, k);
  }

  /// (bins) How many pairs of groups of two kinds k <= l.
  std::span<const std::uint32_t> pairs(std::size_t k, std::size_t l) const {
    return std::span(pairs_).subspan(pair_row(k, l) * of_.bins_, of_.bins_);
  }
  /// (bins) The exposed points of all other groups around groups of a kind.
  std::span<const std::uint32_t> touched(std::size_t k) const {
    return std::span(touched_).subspan(k * of_.bins_, of_.bins_);
  }
  /// (bins) Products of exposed points.
  std::span<const std::uint64_t> layer() const { return layer_; }
  std::uint32_t exposed(std::size_t i) const { return exposed_[i]; }

 private:
  /// All pairs of group i, of kind k, with groups after it.
  void count_from(std::size_t i, std::size_t k) {
    find_bins(i);
    for (std::size_t l = k; l < of_.kinds_.size(); ++l) {
      const std::size_t first = std::max(i + 1, of_.kinds_[l].first), last = of_.kinds_[l].last;
      std::uint32_t* row = pairs_.data() + pair_row(k, l) * of_.bins_;
      for (std::size_t j = first; j < last; ++j) ++row[bin_[j]];
      if (exposed_[i] == 0) continue;
      std::uint32_t* others = touched_.data() + l * of_.bins_;
      for (std::size_t j = first; j < last; ++j) others[bin_[j]] += exposed_[i];
    }
    std::uint32_t* own = touched_.data() + k * of_.bins_;
    for (std::size_t j = i + 1; j < x_.size(); ++j) own[bin_[j]] += exposed_[j];
    if (exposed_[i] == 0) return;
    for (std::size_t j = i + 1; j < x_.size(); ++j)
      layer_[bin_[j]] += std::uint64_t(exposed_[i]) * exposed_[j];
  }

  void find_bins(std::size_t i) {
    constexpr float per_bin = float(1.0 / bin_width);
    for (std::size_t j = i + 1; j < x_.size(); ++j) {
      const float x = x_[j] - x_[i], y = y_[j] - y_[i], z = z_[j] - z_[i];
      bin_[j] = static_cast<std::int32_t>(std::sqrt(x * x + y * y + z * z) * per_bin);
    }
  }

  const PartialProfiles& of_;
  std::vector<float> x_, y_, z_;  ///< of groups by their kinds
  std::vector<std::uint32_t> exposed_, pairs_, touched_;
  std::vector<std::uint64_t> layer_;
  std::vector<std::int32_t> bin_;
};

PartialProfiles::PartialProfiles(std::span<const ScatteringGroup> groups, std::span<const double> q,
                                 double longest)
    : groups_(groups.begin(), groups.end()),
      order_(groups.size()),
      bins_(bins_for(longest)),
      q_count_(q.size()),
      waves_(waves_of(q, bins_)) {
  std::iota(order_.begin(), order_.end(), 0U);
  std::ranges::stable_sort(order_, {}, [&](std::uint32_t k) { return groups_[k]; });
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const ScatteringGroup group = groups_[order_[k]];
    if (k == 0 || group != groups_[order_[k - 1]]) {
      kinds_.push_back({k, k, {}, {}});
      for (const double one : q) {
        kinds_.back().vacuum.push_back(form_factor(group, one));
        kinds_.back().displaced.push_back(displaced_form_factor(displaced_volume(group), one));
      }
    }
    kinds_.back().last = k + 1;
  }
  for (const double one : q) water_.push_back(water_form_factor(one) / exposure_points);
}

std::vector<double> PartialProfiles::of(std::span<const Vec3> positions) const {
  std::vector<double> profiles(partial_count * q_count_);
  if (positions.empty()) return profiles;
  const Counter counts(*this, positions);
  add_pairs(counts, profiles);
  add_layer(counts, profiles);
  return profiles;
}

void PartialProfiles::add_pairs(const Counter& counts, std::span<double> profiles) const {
  const auto part = [&](Partial partial) { return part_of(profiles, partial); };
  for (std::size_t l = 0; l < kinds_.size(); ++l)
    for (std::size_t k = 0; k <= l; ++k) {
      const Kind &one = kinds_[k], &other = kinds_[l];
      std::vector<double> sum = transformed(counts.pairs(k, l));
      // Pairs are there once, but count twice; and each group with itself once.
      const double own = k == l ? 0.5 * double(one.last - one.first) : 0.0;
      for (double& value : sum) value += own;
      add_product(part(Partial::vv), 2.0, one.vacuum, other.vacuum, sum);
      add_product(part(Partial::vd), 1.0, one.vacuum, other.displaced, sum);
      add_product(part(Partial::vd), 1.0, one.displaced, other.vacuum, sum);
      add_product(part(Partial::dd), 2.0, one.displaced, other.displaced, sum);
    }
}

void PartialProfiles::add_layer(const Counter& counts, std::span<double> profiles) const {
  double squares = 0.0;
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    double own = 0.0;
    for (std::size_t i = kinds_[k].first; i < kinds_[k].last; ++i) {
      const double exposed = counts.exposed(i);
      own += exposed;
      squares += exposed * exposed;
    }
    std::vector<double> sum = transformed(counts.touched(k));
    for (double& value : sum) value += own;
    add_product(part_of(profiles, Partial::vw), 1.0, kinds_[k].vacuum, water_, sum);
    add_product(part_of(profiles, Partial::dw), 1.0, kinds_[k].displaced, water_, sum);
  }
  std::vector<double> layer = transformed(counts.layer());
  for (double& value : layer) value += 0.5 * squares;
  add_product(part_of(profiles, Partial::ww), 2.0, water_, water_, layer);
}

template <class Count>
std::vector<double> PartialProfiles::transformed(std::span<const Count> counts) const {
  std::vector<double> sum(q_count_);
  for (std::size_t b = 0; b < counts.size(); ++b) {
    if (counts[b] == 0) continue;
    const auto count = static_cast<double>(counts[b]);
    const double* wave = waves_.data() + b * q_count_;
    for (std::size_t k = 0; k < q_count_; ++k) sum[k] += count * wave[k];
  }
  return sum;
}

}  // namespace pliant
