// SPDX-License-Identifier: MIT
// Limits and near joints of a region: those of joints that move, among each other and with joints
// that stay.
#pragma once

#include <span>
#include <vector>

#include "pliant/framework/measures/joint_neighbours.hpp"
#include "pliant/resolve/bodies/tree/articulated_pass.hpp"

namespace pliant {

/// How much the worst of a kind is broken (Angstrom).
struct ContactViolation {
  double limit = 0.0, overlap = 0.0;
  double worst() const { return limit > overlap ? limit : overlap; }
};

/// Not thread-safe.
class LocalContacts {
 public:
  /// Both must outlive it.
  LocalContacts(const Framework& framework, const BodyPlan& plan)
      : framework_(framework), plan_(plan) {}

  /// For a region of the plan as it is now. `still` (N, Angstrom): where the joints are that do not
  /// move. `origin`: of places. `neighbours`: null without sterics. All must outlive the search.
  void begin(std::span<const Vec3> still, Vec3 origin, LimitsOff off, JointNeighbours* neighbours);

  /// Finds what is broken at `x` (places), and a row of `weight` for each.
  ContactViolation find(std::span<const Vec3> x, double weight);
  /// By joints, so that they do not depend on the order of neighbours.
  std::span<const DistanceRow> rows() const { return rows_; }

 private:
  struct Found {
    Joint a, b;        ///< a moves
    LimitIndex limit;  ///< or ~0: an overlap
    DistanceRow row;
  };
  struct Other {
    Slot place;  ///< DistanceRow::still: it does not move
    Vec3 at;
  };

  void find_at(Slot place, std::span<const Vec3> x, double weight);
  void find_limits(Slot place, std::span<const Vec3> x, double weight);
  void find_overlaps(Slot place, std::span<const Vec3> x, double weight);
  bool find_other(Slot place, Joint joint, std::span<const Vec3> x, Other& other) const;
  bool moves(Slot place) const { return !plan_.is_ground(plan_.body_at()[place]); }

  const Framework& framework_;
  const BodyPlan& plan_;
  std::span<const Vec3> still_;
  Vec3 origin_;
  LimitsOff off_;
  JointNeighbours* neighbours_ = nullptr;
  ContactViolation worst_;
  std::vector<Found> found_;
  std::vector<DistanceRow> rows_;
};

}  // namespace pliant
