// SPDX-License-Identifier: MIT
// Packets of IMD (Interactive Molecular Dynamics, the protocol by which VMD and MDAnalysis follow a
// run), as a server sends them. VMD uses version 2 (Stone, Gullingsrud, Grayson, Schulten, Proc.
// I3D 2001, 191), version 3 is that of imdclient's specification.
//
// A packet is a header, two 32-bit numbers in network order, and a body in the server's own order.
// The second number of the handshake is in the server's order, too, from which a client learns it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pliant/framework/frame.hpp"

namespace pliant {

enum class ImdType : std::int32_t {
  disconnect,
  energies,
  coordinates,
  go,
  handshake,
  kill,
  forces,  ///< from a client, on some atoms; "MDCOMM"
  pause,
  rate,
  io_error,
  session_info,
  resume,
  time,
  box,
  velocities,
  all_forces,
  wait
};

/// Format of a session.
struct ImdFormat {
  int version = 3;       ///< 2 or 3
  bool swapped = false;  ///< bodies are in the opposite byte order of this machine's
};

/// The nine numbers of an energy packet, which show how well a step was resolved.
struct ImdEnergies {
  float temperature = 0.0F;    ///< 0: a step has none
  float total = 0.0F;          ///< largest |length - rest| / rest
  float potential = 0.0F;      ///< root mean square of |length - rest| / rest
  float van_der_waals = 0.0F;  ///< largest overlap of two joints, Angstrom
  float coulomb = 0.0F;        ///< 1 if the step did not converge, 0 if it did
  float bonds = 0.0F;          ///< sweeps of the step
  float angles = 0.0F;         ///< largest distance of a limit outside its interval, Angstrom
  float dihedrals = 0.0F;      ///< number of forces of the client that act
  float impropers = 0.0F;      ///< number of frames for which this client was too slow
};

/// Counts of a client that its frames' energies include.
struct ImdCounts {
  std::int64_t forces = 0, dropped = 0;
};

ImdEnergies imd_energies(const Frame& frame, const ImdCounts& counts);

using Bytes = std::vector<std::byte>;

/// Handshake, and in version 3 the contents of each frame: time, energies and coordinates.
Bytes imd_greeting(const ImdFormat& format);

/// The first part of a frame, for one client: in version 3 time and energies, in version 2
/// energies. `timestep` in ps.
Bytes imd_head(const ImdFormat& format, const Frame& frame, double timestep,
               const ImdCounts& counts);

/// The other part, the same for all clients: coordinates (N, 3) in Angstrom, which replace the
/// contents of `bytes`.
void imd_coordinates(const ImdFormat& format, std::span<const Vec3> positions, Bytes& bytes);

/// The eight bytes before a body.
struct ImdHeader {
  ImdType type;
  std::int32_t value;
};

/// Decodes 8 bytes. The type may not be a known ImdType.
ImdHeader imd_header(const std::byte* bytes);

/// A 32-bit number of a body.
std::uint32_t imd_word(const ImdFormat& format, const std::byte* bytes);

}  // namespace pliant
