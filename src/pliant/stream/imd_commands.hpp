// SPDX-License-Identifier: MIT
// The commands of an IMD client, read from bytes that arrive in arbitrary pieces. Clients are not
// trusted: the first invalid command ends the session.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "pliant/perturb/push.hpp"
#include "pliant/stream/imd_packets.hpp"

namespace pliant {

/// One packet of a client.
struct ImdCommand {
  ImdType type = ImdType::go;
  std::int32_t value = 0;               ///< for rate and wait
  std::vector<JointForce> forces = {};  ///< for forces, kJ/(mol Angstrom)
};

class ImdCommandReader {
 public:
  ImdCommandReader(const ImdFormat& format, std::size_t joint_count);

  void take(std::span<const std::byte> bytes);

  /// Returns the next complete packet; nothing if there is none. Throws InputError naming what is
  /// wrong: an unknown or unexpected type, forces on atoms that do not exist, twice on one, or not
  /// finite, or more forces than atoms. An invalid packet is refused by its header, before its body
  /// has arrived.
  std::optional<ImdCommand> next();

  /// Whether part of a packet has arrived.
  bool is_within_packet() const { return !bytes_.empty(); }

 private:
  std::size_t body_size(const ImdHeader& header) const;
  std::vector<JointForce> forces(std::size_t count);

  ImdFormat format_;
  std::size_t joint_count_;
  Bytes bytes_;
  std::vector<std::uint8_t> is_pulled_;  ///< (N) used in forces()
};

}  // namespace pliant
