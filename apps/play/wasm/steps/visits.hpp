// SPDX-License-Identifier: MIT
// The visits of a technique to bars in one step, for slow motion.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/resolve/method/resolve_options.hpp"
#include "reply.hpp"

namespace pliant::play {

class Visits {
 public:
  explicit Visits(std::size_t bars) : seen_(bars) {}

  void note(const RepairedBar& visit);
  /// `events` (4 E): bar, near joint, far joint, sweep; `moved` (6 E): where both joints are after
  /// it (Angstrom); `whole`: whether these are all visits.
  void add_to(Reply& reply) const;
  bool is_whole() const { return is_whole_; }

 private:
  std::vector<std::int32_t> events_;
  std::vector<double> moved_;
  std::int32_t sweep_ = 0;
  std::vector<bool> seen_;
  bool is_whole_ = true;
};

}  // namespace pliant::play
