// SPDX-License-Identifier: MIT
// One of the clients of a run: what it asked for, and what waits to be sent to it.
#pragma once

#include <cstdint>
#include <deque>
#include <list>
#include <memory>
#include <vector>

#include "pliant/perturb/push.hpp"
#include "pliant/stream/imd_packets.hpp"

namespace pliant {

/// A frame as it goes out to one client.
struct ImdOutgoing {
  Bytes head;                             ///< for this client alone
  std::shared_ptr<Bytes> body = nullptr;  ///< the coordinates, which all clients share

  std::size_t size() const { return head.size() + (body ? body->size() : 0); }
};

struct ImdFollower {
  std::int64_t every = 1;               ///< a frame in so many steps
  std::vector<JointForce> forces = {};  ///< its pull, each joint once
  std::deque<ImdOutgoing> frames = {};  ///< that wait to be sent
  ImdCounts counts = {};
  bool is_paused = false;  ///< it holds the run
  bool is_ready = false;   ///< all that there was for it is on its way
  bool gets_next = false;  ///< the frame that is about to be put
};

/// The pulls of all: forces on one joint are added up, in the order in which the clients came.
/// Those of one client alone are as it sent them.
std::vector<JointForce> forces_of(const std::list<ImdFollower>& followers);

}  // namespace pliant
