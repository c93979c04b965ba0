// SPDX-License-Identifier: MIT
// Decompression piece by piece, in memory that does not grow with the contents of the file.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace pliant {

/// What one step of a Decoder did.
struct Decoded {
  std::size_t made = 0;     ///< bytes written to `room`
  bool is_end = false;      ///< this member of the file is complete
  std::string damage = {};  ///< what is wrong with the data, in words; "" if nothing is
};

/// Expands the members of a compressed file, one after the other.
class Decoder {
 public:
  Decoder() = default;
  virtual ~Decoder() = default;
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  /// Fills `room` as far as `bytes` allow, and removes from `bytes` what has been used.
  virtual Decoded step(std::string_view& bytes, std::span<char> room) = 0;
  /// Prepares for a new member.
  virtual void restart() = 0;
};

}  // namespace pliant
