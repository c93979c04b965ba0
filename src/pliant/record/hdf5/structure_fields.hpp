// SPDX-License-Identifier: MIT
// Reads fields of a file that may be damaged, within bounds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/system/descriptor.hpp"

namespace pliant {

/// HDF5's address for "none", in eight bytes.
inline constexpr std::uint64_t no_address = ~std::uint64_t{0};

/// "tree node at byte 96".
std::string place_in_file(std::string_view what, std::uint64_t address);

/// Little-endian fields of a block, one after another. All functions throw InputError ("is damaged:
/// WHAT: WHY") where the block ends before the field does.
class StructureFields {
 public:
  /// `what` names the block in errors. Does not own the bytes.
  StructureFields(std::span<const std::byte> bytes, std::string what)
      : bytes_(bytes), what_(std::move(what)) {}

  std::uint64_t number(std::size_t width);  ///< width of 1 to 8 bytes
  void skip(std::size_t count);
  /// Returns the next `count` bytes as a separate block.
  StructureFields part(std::size_t count, std::string_view what);
  /// Text up to a NUL, which is skipped.
  std::string text();
  /// Throws unless these characters come next.
  void signature(std::string_view characters);

  std::size_t left() const { return bytes_.size() - at_; }
  std::size_t position() const { return at_; }
  std::span<const std::byte> all() const { return bytes_; }

  [[noreturn]] void fail(std::string_view why) const;
  void require(bool condition, std::string_view why) const {
    if (!condition) fail(why);
  }

 private:
  std::span<const std::byte> bytes_;
  std::string what_;
  std::size_t at_ = 0;
};

/// A regular file opened for reading.
class StructureFile {
 public:
  /// Throws FileError.
  explicit StructureFile(const std::filesystem::path& path);

  std::uint64_t size() const { return size_; }
  /// Returns bytes [address, address + count), which must lie within the file. Throws InputError if
  /// the file has become shorter.
  std::vector<std::byte> read(std::uint64_t address, std::size_t count) const;

 private:
  Descriptor file_;
  std::uint64_t size_ = 0;
};

/// Bob Jenkins' lookup3 with initial value 0, HDF5's checksum of metadata.
std::uint32_t structure_checksum(std::span<const std::byte> bytes);

}  // namespace pliant
