// SPDX-License-Identifier: MIT
#include "pliant/run/taut_chain.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <vector>

namespace pliant {
namespace {

constexpr double least_reach = 0.95;
constexpr std::size_t least_bars = 6;  // fewer may be one rigid group
constexpr double least_along = 0.8;    // cosine of the chain and the pull

/// The end of the best chain to a joint, laid out in a plane: as far as it can be.
struct Stretched {
  Joint before = 0;
  std::size_t bars = 0;
  double x = 0.0, y = 0.0;              ///< in the plane of the all-trans chain
  double along_x = 1.0, along_y = 0.0;  ///< of the last bond, there
  double side = 1.0;                    ///< on which it turns next
};

class Stretching {
 public:
  Stretching(const Framework& framework, std::span<const Vec3> x, Joint joint)
      : framework_(framework), x_(x), joint_(joint), found_(framework.joint_count()) {
    for (Stretched& one : found_) one.bars = unreached;
    found_[joint] = {joint, 0};
    for (waiting_.push_back(joint); !waiting_.empty(); waiting_.pop_front())
      visit(waiting_.front());
  }

  std::optional<TautChain> longest(Vec3 along) const {
    std::optional<TautChain> best;
    double furthest = 0.0;
    for (Joint end = 0; end < found_.size(); ++end) {
      const Stretched& chain = found_[end];
      if (chain.bars == unreached || chain.bars < least_bars) continue;
      const Vec3 apart = x_[joint_] - x_[end];
      const double length = norm(apart);
      const double reach = length / std::sqrt(chain.x * chain.x + chain.y * chain.y);
      if (reach < least_reach || dot(apart, along) < least_along * length) continue;
      if (length <= furthest) continue;
      furthest = length;
      best = TautChain{chain_to(end), std::min(reach, 1.0)};
    }
    return best;
  }

 private:
  static constexpr auto unreached = std::numeric_limits<std::size_t>::max();

  std::vector<Joint> chain_to(Joint end) const {
    std::vector<Joint> chain{end};
    while (chain.back() != joint_) chain.push_back(found_[chain.back()].before);
    std::ranges::reverse(chain);
    return chain;
  }

  bool has_bar(Joint a, Joint b) const {
    return std::ranges::any_of(framework_.neighbours(a),
                               [&](const Incidence& at) { return at.joint == b; });
  }

  /// A bar that spans an angle is no bond of a chain: its joints share a neighbour, nearer to both.
  bool spans_angle(Joint a, Joint b, double length) const {
    return std::ranges::any_of(framework_.neighbours(a), [&](const Incidence& at) {
      return at.joint != b && framework_.rest_lengths()[at.bar] < length && has_bar(at.joint, b) &&
             distance(x_[at.joint], x_[b]) < length;
    });
  }

  void visit(Joint here) {
    for (const Incidence& at : framework_.neighbours(here)) {
      if (at.joint == joint_ || is_reached_[at.joint]) continue;
      const double length = framework_.rest_lengths()[at.bar];
      if (spans_angle(here, at.joint, length)) continue;
      is_reached_[at.joint] = true;
      found_[at.joint] = stretched(here, at.joint, length);
      waiting_.push_back(at.joint);
    }
  }

  Stretched stretched(Joint here, Joint next, double length) const {
    const Stretched& last = found_[here];
    Stretched chain{here, last.bars + 1};
    double cosine = 1.0;  // of the bend
    if (last.bars > 0 && has_bar(last.before, next)) {
      const Vec3 to = x_[next] - x_[here], from = x_[here] - x_[last.before];
      cosine = std::clamp(dot(to, from) / (norm(to) * norm(from)), -1.0, 1.0);
    }
    const double sine = last.side * std::sqrt(1.0 - cosine * cosine);
    chain.along_x = cosine * last.along_x - sine * last.along_y;
    chain.along_y = sine * last.along_x + cosine * last.along_y;
    chain.side = -last.side;
    chain.x = last.x + length * chain.along_x;
    chain.y = last.y + length * chain.along_y;
    return chain;
  }

  const Framework& framework_;
  std::span<const Vec3> x_;
  Joint joint_;
  std::vector<Stretched> found_;
  std::vector<bool> is_reached_ = std::vector<bool>(framework_.joint_count(), false);
  std::deque<Joint> waiting_;
};

}  // namespace

std::optional<TautChain> find_taut_chain(const Framework& framework,
                                         std::span<const Vec3> positions, Joint joint, Vec3 along) {
  return Stretching(framework, positions, joint).longest(along);
}

}  // namespace pliant
