// SPDX-License-Identifier: MIT
// Framework (bar-and-joint structure, geometric constraint structure): joints joined by bars of
// fixed rest length. What never changes during a run; positions are in State.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pliant/base/graphs/graph.hpp"
#include "pliant/base/random.hpp"
#include "pliant/base/vec3.hpp"
#include "pliant/framework/atom_table.hpp"
#include "pliant/framework/limits.hpp"
#include "pliant/framework/sterics.hpp"
#include "pliant/framework/torsion_preferences.hpp"

namespace pliant {

using Joint = std::uint32_t;     ///< index of a joint, from 0
using BarIndex = std::uint32_t;  ///< index of a bar, from 0

/// Two joints at a fixed distance. `a` is the joint that the input names first.
struct Bar {
  Joint a = 0, b = 0;
  friend bool operator==(Bar, Bar) = default;
};

/// What a Framework is made of; Framework's constructor checks it.
struct FrameworkParts {
  std::size_t joint_count = 0;
  std::vector<Bar> bars = {};                   ///< (B) in the order of the input
  std::vector<double> rest_lengths = {};        ///< (B) Angstrom
  std::vector<double> masses = {};              ///< (N) u, in [1e-150, 1e150]; empty: all 1
  std::vector<Joint> pinned = {};               ///< joints that never move
  std::shared_ptr<const AtomTable> atoms = {};  ///< names of the joints; may be null
  /// (N) Angstrom, positions at which every bar has its rest length, if some are known; else empty.
  /// They give the shape, chirality included, of parts that bars make rigid.
  std::vector<Vec3> drawn = {};
  bool planar = false;             ///< pushes leave the z of every joint as it is
  std::vector<Limit> limits = {};  ///< (L) distances held to intervals; never of a pair with a bar
  std::shared_ptr<const Sterics> sterics = {};  ///< how near joints may come; null: no lower bound
  std::shared_ptr<const TorsionPreferences> torsion_preferences = {};  ///< null: none
};

/// A joint reached over a bar.
struct Incidence {
  Joint joint;
  BarIndex bar;
};

/// An immutable, checked bar-and-joint framework: every bar joins two different joints, no two
/// bars join the same pair, every rest length is finite and in [1e-150, 1e150] Angstrom. It
/// may also have limits and sterics; where it has none they cost nothing.
class Framework {
 public:
  /// Takes and checks `parts`: equal duplicate bars are merged (the first is kept).
  /// Throws InputError naming both joints of a bad bar: self loop, unknown joint, length out of
  /// range, two bars of one pair with different lengths; a mass out of range; columns that differ
  /// in length; drawn positions that break a bar; a limit that joins unknown joints, a joint to
  /// itself or a pair that has a bar, or whose interval is empty or out of range; sterics that
  /// or torsion preferences that check() refuses.
  explicit Framework(FrameworkParts parts);

  std::size_t joint_count() const { return joint_count_; }
  std::size_t bar_count() const { return bars_.size(); }
  std::span<const Bar> bars() const { return bars_; }                     ///< (B)
  std::span<const double> rest_lengths() const { return rest_lengths_; }  ///< (B) Angstrom
  /// (N) 1/u, 0 for a pinned joint.
  std::span<const double> inverse_masses() const { return inverse_masses_; }
  bool is_pinned(Joint joint) const { return inverse_masses_[joint] == 0.0; }
  bool has_pinned_joints() const { return pinned_count_ > 0; }
  std::size_t pinned_count() const { return pinned_count_; }
  /// Bars at `joint` with the joint at their other end, in the order of the bars.
  std::span<const Incidence> neighbours(Joint joint) const { return graph_.at(joint); }
  const GraphOf<Incidence>& graph() const { return graph_; }
  std::span<const Limit> limits() const { return limits_; }  ///< (L) in the order of the input
  /// The limits at `joint`, ascending.
  std::span<const LimitIndex> limits_at(Joint joint) const;
  /// How near joints may come; null: any.
  const Sterics* sterics() const { return sterics_.get(); }
  /// Torsions that are usual; null: none.
  const TorsionPreferences* torsion_preferences() const { return torsion_preferences_.get(); }
  /// Whether there is nothing but bars.
  bool has_bars_only() const { return limits_.empty() && sterics_ == nullptr; }
  /// Whether it is a linkage of the plane: nothing pushes a joint along z.
  bool is_planar() const { return planar_; }
  /// A random unit vector along which joints may be pushed: without z in a planar framework.
  Vec3 random_direction(RandomSequence draws) const {
    return planar_ ? draws.direction_in_plane() : draws.direction();
  }
  const std::shared_ptr<const AtomTable>& atoms() const { return atoms_; }
  /// (N) Angstrom, positions at which every bar has its rest length; empty if none are known.
  std::span<const Vec3> drawn() const { return drawn_; }

  /// What it is made of, to make another from. Masses to rounding, 1 for pinned joints.
  FrameworkParts parts() const;

  /// The same with these joints pinned too, and every other mass to the bit. Throws InputError if a
  /// joint does not exist.
  Framework with_pinned(std::span<const Joint> joints) const;

  std::string label(Joint joint) const;  ///< the atom's name, or "joint 7"
  std::string label(Bar bar) const;      ///< "LYS12:CA - LYS12:CB", or "3 - 7"
  std::size_t merged_bar_count() const { return merged_bar_count_; }

 private:
  void check_counts() const;
  void take_masses(const std::vector<double>& masses, const std::vector<Joint>& pinned);
  void pin(std::span<const Joint> joints);
  void check_bars() const;
  void check_drawn() const;
  void check_limits() const;
  void check_limit(std::size_t index) const;
  void index_limits();
  void merge_duplicate_bars();
  void link_joints() { graph_ = {joint_count_, bars()}; }

  std::size_t joint_count_ = 0;
  std::vector<Bar> bars_;
  std::vector<double> rest_lengths_;
  std::vector<double> inverse_masses_;
  GraphOf<Incidence> graph_;
  std::shared_ptr<const AtomTable> atoms_;
  std::vector<Vec3> drawn_;
  std::vector<Limit> limits_;
  std::vector<std::uint32_t> first_limit_;  ///< (N + 1), or none where there are no limits
  std::vector<LimitIndex> limits_at_;
  std::shared_ptr<const Sterics> sterics_;
  std::shared_ptr<const TorsionPreferences> torsion_preferences_;
  std::size_t pinned_count_ = 0;
  std::size_t merged_bar_count_ = 0;
  bool planar_ = false;
};

/// What changes during a run.
struct State {
  std::vector<Vec3> positions;                ///< (N) Angstrom
  std::vector<Vec3> previous;                 ///< (N) positions one step earlier, for Verlet
  std::int64_t step = 0;                      ///< steps done
  double time = 0.0;                          ///< ps
  std::vector<std::uint8_t> limits_off = {};  ///< (L) 1: this limit is off; empty: all are on

  State() = default;
  /// At rest: previous = positions.
  explicit State(std::vector<Vec3> start) : positions(std::move(start)), previous(positions) {}
};

}  // namespace pliant
