// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_packets.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

namespace pliant {
namespace {

std::uint32_t swapped_word(std::uint32_t word) {
  return word >> 24 | (word >> 8 & 0xff00U) | (word << 8 & 0xff0000U) | word << 24;
}

/// From this machine's order of bytes to the network's, highest first, and back.
std::uint32_t network_order(std::uint32_t word) {
  return std::endian::native == std::endian::little ? swapped_word(word) : word;
}

/// Appends packets to bytes.
class PacketWriter {
 public:
  PacketWriter(const ImdFormat& format, Bytes& bytes) : format_(format), bytes_(bytes) {}

  void header(ImdType type, std::int32_t value) {
    network_word(static_cast<std::int32_t>(type));
    network_word(value);
  }

  void network_word(std::int32_t value) {
    const std::uint32_t word = network_order(static_cast<std::uint32_t>(value));
    append(&word, sizeof word);
  }

  template <class Number>
  void body(Number value) {
    auto* at = append(&value, sizeof value);
    if (format_.swapped) std::reverse(at, at + sizeof value);
  }

 private:
  std::byte* append(const void* from, std::size_t size) {
    const std::size_t old = bytes_.size();
    bytes_.resize(old + size);
    std::memcpy(&bytes_[old], from, size);
    return &bytes_[old];
  }

  const ImdFormat& format_;
  Bytes& bytes_;
};

void write_time(PacketWriter& writer, const Frame& frame, double timestep) {
  writer.header(ImdType::time, 1);
  writer.body(timestep);
  writer.body(frame.time);
  writer.body(frame.step);
}

void write_energies(PacketWriter& writer, std::int64_t step, const ImdEnergies& energies) {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  writer.header(ImdType::energies, 1);
  writer.body(static_cast<std::int32_t>(std::min(step, most)));
  for (const float value :
       {energies.temperature, energies.total, energies.potential, energies.van_der_waals,
        energies.coulomb, energies.bonds, energies.angles, energies.dihedrals, energies.impropers})
    writer.body(value);
}

}  // namespace

ImdEnergies imd_energies(const Frame& frame, const ImdCounts& counts) {
  ImdEnergies energies;
  energies.total = static_cast<float>(frame.max_residual);
  energies.potential = static_cast<float>(frame.rms_residual);
  energies.van_der_waals = static_cast<float>(frame.max_overlap);
  energies.coulomb = frame.stop == Stop::converged ? 0.0F : 1.0F;
  energies.bonds = static_cast<float>(frame.sweeps);
  energies.angles = static_cast<float>(frame.max_limit);
  energies.dihedrals = static_cast<float>(counts.forces);
  energies.impropers = static_cast<float>(counts.dropped);
  return energies;
}

Bytes imd_greeting(const ImdFormat& format) {
  Bytes bytes;
  PacketWriter writer(format, bytes);
  writer.network_word(static_cast<std::int32_t>(ImdType::handshake));
  writer.body(static_cast<std::int32_t>(format.version));
  if (format.version < 3) return bytes;
  // Time, energies, box, coordinates, whether those are wrapped, velocities, forces.
  constexpr std::array<std::uint8_t, 7> holds{1, 1, 0, 1, 0, 0, 0};
  writer.header(ImdType::session_info, holds.size());
  for (const std::uint8_t one : holds) writer.body(one);
  return bytes;
}

Bytes imd_head(const ImdFormat& format, const Frame& frame, double timestep,
               const ImdCounts& counts) {
  Bytes bytes;
  PacketWriter writer(format, bytes);
  if (format.version >= 3) write_time(writer, frame, timestep);
  // VMD takes the number of a frame from the energies before it.
  write_energies(writer, frame.step, imd_energies(frame, counts));
  return bytes;
}

// Coordinates are most of a frame, and are written without a call for each number.
void imd_coordinates(const ImdFormat& format, std::span<const Vec3> positions, Bytes& bytes) {
  bytes.clear();
  PacketWriter(format, bytes).header(ImdType::coordinates, static_cast<int>(positions.size()));
  std::size_t at = bytes.size();
  bytes.resize(at + 12 * positions.size());
  for (const Vec3& x : positions) {
    const std::array<float, 3> single{float(x.x), float(x.y), float(x.z)};
    std::array<std::uint32_t, 3> words{};
    std::memcpy(words.data(), single.data(), sizeof words);
    if (format.swapped)
      for (std::uint32_t& word : words) word = swapped_word(word);
    std::memcpy(&bytes[at], words.data(), sizeof words);
    at += sizeof words;
  }
}

ImdHeader imd_header(const std::byte* bytes) {
  std::array<std::uint32_t, 2> words{};
  std::memcpy(words.data(), bytes, sizeof words);
  return {static_cast<ImdType>(network_order(words[0])),
          static_cast<std::int32_t>(network_order(words[1]))};
}

std::uint32_t imd_word(const ImdFormat& format, const std::byte* bytes) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  return format.swapped ? swapped_word(word) : word;
}

}  // namespace pliant
