// SPDX-License-Identifier: MIT
// Saved part (selection of atoms to record, output group): what a file describes that holds some
// of the joints only.
#pragma once

#include <span>
#include <vector>

#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/record/h5md/h5md_header.hpp"

namespace pliant {

/// Some joints of a framework, with what joins them among each other, as if there were no others.
/// Sterics are left out: which pairs may touch is a matter of bonds that may be left out.
class SavedPart {
 public:
  /// `saved` ascending. Throws OptionError where it is empty or not ascending, or names a joint
  /// that does not exist.
  SavedPart(const Framework& whole, std::span<const Joint> saved);

  const Framework& framework() const { return framework_; }
  const std::vector<Joint>& joints() const { return joints_; }
  std::size_t joints_of_whole() const { return part_of_.size(); }

  std::vector<RecordedBond> bonds_of(std::span<const RecordedBond> bonds) const;
  /// What `header` says of these joints. No run goes on from some of its joints: without inputs.
  H5mdHeader header_of(const H5mdHeader& header) const;
  /// What `frame` says of them; residuals are those of the whole. Valid until the next call.
  Frame shown(const Frame& frame);

 private:
  static constexpr Joint left_out = ~Joint{0};

  /// The pair within the part, if both its joints are in it.
  template <class Pair>
  bool take(Pair& pair) const;
  std::shared_ptr<const AtomTable> atoms_of(const AtomTable& whole) const;
  Framework part_of(const Framework& whole);

  std::vector<Joint> joints_;       // (n) of the whole
  std::vector<Joint> part_of_;      // (N) of the part, or left_out
  std::vector<LimitIndex> limits_;  // of the whole, that are in the part
  Framework framework_;
  std::vector<Vec3> positions_;  // (n) of the frame that is shown
  std::vector<std::uint8_t> limits_off_;
};

}  // namespace pliant
