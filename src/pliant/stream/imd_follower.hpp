// SPDX-License-Identifier: MIT
// One of the clients of a run: its requests, and the frames waiting for it.
#pragma once

#include <cstdint>
#include <deque>
#include <list>
#include <memory>
#include <vector>

#include "pliant/perturb/push.hpp"
#include "pliant/stream/imd_packets.hpp"

namespace pliant {

/// A frame as sent to one client.
struct ImdOutgoing {
  Bytes head;                             ///< for this client alone
  std::shared_ptr<Bytes> body = nullptr;  ///< the coordinates, which all clients share

  std::size_t size() const { return head.size() + (body ? body->size() : 0); }
};

struct ImdFollower {
  std::int64_t every = 1;               ///< a frame every so many steps
  std::vector<JointForce> forces = {};  ///< its pulls, each joint once
  std::deque<ImdOutgoing> frames = {};  ///< waiting to be sent
  ImdCounts counts = {};
  bool is_paused = false;  ///< it has paused the run
  bool is_ready = false;   ///< everything for it has been sent
  bool gets_next = false;  ///< it gets the next frame
};

/// The pulls of all clients: forces on one joint are added in the order in which the clients came.
/// Those of a single client are as it sent them.
std::vector<JointForce> forces_of(const std::list<ImdFollower>& followers);

}  // namespace pliant
