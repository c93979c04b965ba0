// SPDX-License-Identifier: MIT
// Saved part (selection of atoms to record, output group): the description of a file that holds
// only some of the joints.
#pragma once

#include <span>
#include <vector>

#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/record/h5md/h5md_header.hpp"

namespace pliant {

/// Some joints of a framework with the bars, bonds and limits among them. Sterics are left out,
/// because which pairs may touch depends on bonds that may be left out.
class SavedPart {
 public:
  /// `saved` must be ascending. Throws OptionError where it is empty or not ascending, or names a
  /// joint that does not exist.
  SavedPart(const Framework& whole, std::span<const Joint> saved);

  const Framework& framework() const { return framework_; }
  const std::vector<Joint>& joints() const { return joints_; }
  std::size_t joints_of_whole() const { return part_of_.size(); }

  std::vector<RecordedBond> bonds_of(std::span<const RecordedBond> bonds) const;
  /// `header` restricted to these joints, and without inputs: no run continues from some joints.
  H5mdHeader header_of(const H5mdHeader& header) const;
  /// `frame` restricted to these joints; residuals are those of all joints. Valid until the next
  /// call.
  Frame shown(const Frame& frame);

 private:
  static constexpr Joint left_out = ~Joint{0};

  /// Renumbers the joints of a pair. Returns false if one of them is left out.
  template <class Pair>
  bool take(Pair& pair) const;
  std::shared_ptr<const AtomTable> atoms_of(const AtomTable& whole) const;
  Framework part_of(const Framework& whole);

  std::vector<Joint> joints_;       // (n) indices in the whole
  std::vector<Joint> part_of_;      // (N) indices in the part, or left_out
  std::vector<LimitIndex> limits_;  // limits of the whole that are in the part
  Framework framework_;
  std::vector<Vec3> positions_;  // (n) of the frame last shown
  std::vector<std::uint8_t> limits_off_;
};

}  // namespace pliant
