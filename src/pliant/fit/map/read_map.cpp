// SPDX-License-Identifier: MIT
#include "pliant/fit/map/read_map.hpp"

#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/fit/map/map_header.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant {
namespace {

float from_int8(std::uint32_t bits) { return static_cast<std::int8_t>(bits); }
float from_int16(std::uint32_t bits) { return static_cast<std::int16_t>(bits); }
float from_uint16(std::uint32_t bits) { return static_cast<float>(bits); }
float from_float32(std::uint32_t bits) { return std::bit_cast<float>(bits); }

/// Sign, 5 bits of exponent, 10 of fraction (IEEE 754).
float from_float16(std::uint32_t bits) {
  const std::uint32_t sign = bits >> 15 << 31, exponent = bits >> 10 & 31, fraction = bits & 1023;
  if (exponent == 0) {
    const float size = static_cast<float>(fraction) / 16777216.0F;
    return sign != 0 ? -size : size;
  }
  const std::uint32_t wide = exponent == 31 ? 255 : exponent + 112;
  return std::bit_cast<float>(sign | wide << 23 | fraction << 13);
}

using FromBits = float (*)(std::uint32_t bits);

FromBits reader_of(MapMode mode) {
  switch (mode) {
    case MapMode::int8:
      return from_int8;
    case MapMode::int16:
      return from_int16;
    case MapMode::float32:
      return from_float32;
    case MapMode::uint16:
      return from_uint16;
    case MapMode::float16:
      return from_float16;
  }
  return from_float32;
}

/// Reads densities one after the other.
class DensityBytes {
 public:
  DensityBytes(std::string_view bytes, const MapHeader& header)
      : bytes_(bytes.substr(header.densities)),
        size_(size_of(header.mode)),
        is_big_endian_(header.is_big_endian),
        from_bits_(reader_of(header.mode)) {}

  float next() {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < size_; ++k) {
      const std::size_t at = is_big_endian_ ? k : size_ - 1 - k;
      bits = bits << 8 | static_cast<unsigned char>(bytes_[at]);
    }
    bytes_.remove_prefix(size_);
    return from_bits_(bits);
  }

 private:
  std::string_view bytes_;
  std::size_t size_;
  bool is_big_endian_;
  FromBits from_bits_;
};

std::vector<float> densities_of(std::string_view bytes, const MapHeader& header) {
  const Grid points = header.grid.points();
  const auto [column, row, section] = std::array{
      points.stride(header.axis[0]), points.stride(header.axis[1]), points.stride(header.axis[2])};
  std::vector<float> values(points.size());
  DensityBytes densities(bytes, header);
  for (std::size_t s = 0; s < header.count[2]; ++s)
    for (std::size_t r = 0; r < header.count[1]; ++r)
      for (std::size_t c = 0; c < header.count[0]; ++c)
        values[s * section + r * row + c * column] = densities.next();
  return values;
}

}  // namespace

DensityMap map_from(std::string_view bytes, std::string_view name) {
  const MapHeader header = read_map_header(bytes, name);
  if (header.grid.size() > most_map_points)
    throw TooLargeError(at({printable_name(name)}, "map: has more than " +
                                                       std::to_string(most_map_points) +
                                                       " points, the most that are read"));
  std::vector<float> values = densities_of(bytes, header);
  if (const std::string fault = not_finite_text(header.grid.points(), values); !fault.empty())
    fail({printable_name(name)}, "map: densities: expected finite numbers, found " + fault);
  return {header.grid, std::move(values)};
}

DensityMap read_map(const std::filesystem::path& path) {
  return map_from(read_bytes(path, largest_text), path_text(path));
}

}  // namespace pliant
