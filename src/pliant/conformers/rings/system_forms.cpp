// SPDX-License-Identifier: MIT
#include "pliant/conformers/rings/system_forms.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/base/math/best_fit.hpp"
#include "pliant/base/math/superposition.hpp"
#include "pliant/base/random.hpp"
#include "pliant/conformers/rings/distance_fit.hpp"
#include "pliant/conformers/rings/ring_pucker.hpp"
#include "pliant/resolve/lanes/lane_kernels.hpp"

namespace pliant {
namespace {

constexpr int starts = 300;
constexpr int idle_starts = 24, idle_starts_a_form = 3;  // so many without a new form end it
constexpr double shift = 1.8;                            // Angstrom: how far atoms go at most
constexpr int system_relaxing_steps = 40;
constexpr double system_relaxing = 0.05;
constexpr double soft_angle = 0.12;     // Angstrom
constexpr double least_square = 0.135;  // Angstrom^2, that of six atoms 0.15 apart

/// A form pressed onto its mean plane.
std::vector<Vec3> flattened(std::vector<Vec3> x) {
  Vec3 centre{};
  for (Vec3 point : x) centre += (1.0 / double(x.size())) * point;
  std::array<double, 9> moments{}, axes{};
  for (Vec3 point : x) {
    const Vec3 r = point - centre;
    const std::array<double, 3> at{r.x, r.y, r.z};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) moments[3 * i + j] += at[i] * at[j];
  }
  find_eigenvectors(moments, axes, 3);
  std::size_t thin = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (moments[4 * k] < moments[4 * thin]) thin = k;
  const Vec3 normal{axes[thin], axes[3 + thin], axes[6 + thin]};
  for (Vec3& point : x) point -= dot(point - centre, normal) * normal;
  return x;
}

class SystemForms {
 public:
  SystemForms(const RingSystem& system, const Framework& framework, const BondChemistry& chemistry,
              std::span<const Vec3> start)
      : system_(system), chemistry_(chemistry) {
    for (Joint atom : system.atoms) start_.push_back(start[atom]);
    const std::vector<Bar> angles = system_angles(system, chemistry);
    for (const Bar& bar : framework.bars()) add(bar, !is_among(bar, angles));
    for (const Bar& pair : angles) add(pair, false);
    for (const auto* part : {&exact_, &soft_})
      for (const WantedDistance& at : *part)
        all_.push_back({std::uint32_t(at.i), std::uint32_t(at.j), at.square});
    room_.resize(approach_room(all_.size(), start_.size()));
    places_.resize(start_.size());
    flat_ = flattened(start_);
  }

  std::vector<RingForm> find(std::size_t most) {
    add_form(start_);
    add_mirrored(start_);
    int last = 0;  // that found a form
    for (int k = 0; k < starts && forms_.size() < most; ++k) {
      if (k - last > idle_starts + idle_starts_a_form * int(forms_.size())) break;
      const std::size_t known = forms_.size(), lane = std::size_t(k) % lane_count;
      if (lane == 0) relax_from(k);
      std::vector<Vec3>& x = relaxed_[lane];
      if ((well_ >> lane & 1) && is_form(x)) {
        add_form(x);
        add_mirrored(std::move(x));
      }
      if (forms_.size() > known) last = k;
    }
    mark_chairs();
    return std::move(forms_);
  }

 private:
  static bool is_among(Bar bar, const std::vector<Bar>& pairs) {
    const Joint a = std::min(bar.a, bar.b), b = std::max(bar.a, bar.b);
    return std::any_of(pairs.begin(), pairs.end(),
                       [&](Bar pair) { return pair.a == a && pair.b == b; });
  }

  /// Pairs of two atoms of the system, each once.
  void add(Bar pair, bool is_exact) {
    const auto& atoms = system_.atoms;
    const auto one = std::lower_bound(atoms.begin(), atoms.end(), pair.a);
    const auto other = std::lower_bound(atoms.begin(), atoms.end(), pair.b);
    if (one == atoms.end() || *one != pair.a || other == atoms.end() || *other != pair.b) return;
    const auto i = std::size_t(one - atoms.begin()), j = std::size_t(other - atoms.begin());
    auto& to = is_exact ? exact_ : soft_;
    const auto is_same = [&](const WantedDistance& at) {
      return std::minmax(at.i, at.j) == std::minmax(i, j);
    };
    if (std::none_of(to.begin(), to.end(), is_same))
      to.push_back({i, j, norm_squared(start_[i] - start_[j])});
  }

  std::vector<Vec3> shifted(int k) const {
    RandomSequence draws({0, Domain::torsion, 0, 0, std::uint64_t(k)});
    std::vector<Vec3> x = k % 2 == 0 ? start_ : flat_;
    for (Vec3& point : x) point += (shift * draws.uniform()) * draws.direction();
    return x;
  }

  /// Eight starts at once, from number k on.
  void relax_from(int k) {
    const LaneKernels& kernels = *lane_levels().front();
    std::array<double*, lane_count> rows{};
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      relaxed_[lane] = shifted(k + int(lane));
      rows[lane] = &relaxed_[lane][0].x;
    }
    kernels.gather(rows.data(), 3 * start_.size(), &places_[0].x);
    well_ = kernels.approach({all_.data(), all_.size()}, start_.size(), system_relaxing,
                             system_relaxing_steps, room_.data(), places_.data());
    kernels.scatter(&places_[0].x, 3 * start_.size(), rows.data());
  }

  bool is_form(std::vector<Vec3>& x) const {
    return meet(exact_, x) && keeps_angles(x) && keeps_hands(x);
  }

  bool keeps_angles(std::span<const Vec3> x) const {
    return std::all_of(soft_.begin(), soft_.end(), [&](const WantedDistance& at) {
      return std::abs(distance(x[at.i], x[at.j]) - std::sqrt(at.square)) <= soft_angle;
    });
  }

  /// Where three bonds of the system meet; nitrogen that bears nothing else may invert.
  bool keeps_hands(std::span<const Vec3> x) const {
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (system_.neighbours[k].size() < 3) continue;
      const Joint atom = system_.atoms[k];
      if (chemistry_.is_amine(atom) || !chemistry_.is_tetrahedral(atom)) continue;
      if (!(volume(k, x) * volume(k, start_) > 0.0)) return false;
    }
    return true;
  }

  double volume(std::size_t k, std::span<const Vec3> x) const {
    const auto& at = system_.neighbours[k];
    return dot(cross(x[at[0]] - x[k], x[at[1]] - x[k]), x[at[2]] - x[k]);
  }

  void add_form(std::vector<Vec3> x) {
    for (const RingForm& known : forms_) {
      const RigidMotion onto = superposition(x, known.positions);
      double sum = 0.0;
      for (std::size_t k = 0; k < x.size(); ++k)
        sum += norm_squared(onto(x[k]) - known.positions[k]);
      if (sum < least_square) return;
    }
    forms_.push_back({std::move(x), false});
  }

  /// All distances of a mirror image are the same.
  void add_mirrored(std::vector<Vec3> x) {
    for (Vec3& at : x) at.z = -at.z;
    if (keeps_hands(x)) add_form(std::move(x));
  }

  /// Marks the forms with the most chairs.
  void mark_chairs() {
    std::vector<std::size_t> chairs;
    for (const RingForm& form : forms_) chairs.push_back(chairs_of(form.positions));
    const std::size_t most = *std::max_element(chairs.begin(), chairs.end());
    for (std::size_t k = 0; k < forms_.size(); ++k)
      forms_[k].is_chair = most > 0 && chairs[k] == most;
  }

  std::size_t chairs_of(std::span<const Vec3> x) const {
    std::size_t count = 0;
    for (const auto& ring : system_.rings) {
      if (ring.size() > largest_small_ring) continue;
      std::vector<Vec3> at;
      for (std::size_t atom : ring) at.push_back(x[atom]);
      if (is_chair(at)) ++count;
    }
    return count;
  }

  const RingSystem& system_;
  const BondChemistry& chemistry_;
  std::vector<Vec3> start_, flat_;
  std::vector<WantedDistance> exact_, soft_;
  std::vector<LaneDistance> all_;
  std::vector<LaneValue> room_;
  std::vector<LaneVector> places_;
  std::array<std::vector<Vec3>, lane_count> relaxed_;
  LaneMask well_ = 0;  // the lanes that could be relaxed
  std::vector<RingForm> forms_;
};

}  // namespace

std::vector<RingForm> system_forms(const RingSystem& system, const Framework& framework,
                                   const BondChemistry& chemistry, std::span<const Vec3> start,
                                   std::size_t most) {
  return SystemForms(system, framework, chemistry, start).find(most);
}

}  // namespace pliant
