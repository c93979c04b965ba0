// SPDX-License-Identifier: MIT
// What an IMD client says, read from bytes that come in any pieces. Clients are not trusted: the
// first thing that is no command ends the session.
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
  std::int32_t value = 0;               ///< of rate and wait
  std::vector<JointForce> forces = {};  ///< of forces, kJ/(mol Angstrom)
};

class ImdCommandReader {
 public:
  ImdCommandReader(const ImdFormat& format, std::size_t joint_count);

  void take(std::span<const std::byte> bytes);

  /// The next packet that is whole; nothing if there is none. Throws InputError that says what is
  /// no command: an unknown or unexpected type, forces on atoms that there are not, twice on one,
  /// or not finite, or more of them than atoms. A packet that cannot be right is refused by its
  /// header, before its body has come.
  std::optional<ImdCommand> next();

  /// Whether a packet has begun to come and is not whole.
  bool is_within_packet() const { return !bytes_.empty(); }

 private:
  std::size_t body_size(const ImdHeader& header) const;
  std::vector<JointForce> forces(std::size_t count);

  ImdFormat format_;
  std::size_t joint_count_;
  Bytes bytes_;
  std::vector<std::uint8_t> is_pulled_;  ///< (N) within forces()
};

}  // namespace pliant
