// SPDX-License-Identifier: MIT
#include "pliant/fit/map/write_map.hpp"

#include <bit>
#include <cstdint>
#include <numbers>

#include "pliant/base/error.hpp"
#include "pliant/base/math/elementary.hpp"
#include "pliant/fit/map/map_header.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant {
namespace {

class MapBytes {
 public:
  MapBytes() : bytes_(map_header_size, '\0') {}

  /// Sets a word, counted from 1.
  void set(std::size_t number, std::uint32_t word) {
    for (std::size_t k = 0; k < 4; ++k)
      bytes_[4 * (number - 1) + k] = static_cast<char>(word >> 8 * k);
  }
  void set_real(std::size_t number, double real) {
    set(number, std::bit_cast<std::uint32_t>(static_cast<float>(real)));
  }
  void set_text(std::size_t number, std::string_view text) {
    bytes_.replace(4 * (number - 1), text.size(), text);
  }
  void append(float value) {
    const auto word = std::bit_cast<std::uint32_t>(value);
    const std::array bytes{static_cast<char>(word), static_cast<char>(word >> 8),
                           static_cast<char>(word >> 16), static_cast<char>(word >> 24)};
    bytes_.append(bytes.data(), bytes.size());
  }
  void reserve(std::size_t values) { bytes_.reserve(bytes_.size() + 4 * values); }
  std::string taken() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

double degrees_of(double cosine) {
  return cosine == 0.0 ? 90.0 : exact_bits_acos(cosine) * 180.0 / std::numbers::pi;
}

void set_grid(const MapGrid& grid, MapBytes& out) {
  const std::array<double, 3> spacing = grid.spacing(), cosines = grid.cosines();
  const std::array<double, 3> origin{grid.origin.x, grid.origin.y, grid.origin.z};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto count = static_cast<std::uint32_t>(grid.count[k]);
    out.set(1 + k, count);
    out.set(8 + k, count);
    out.set_real(11 + k, spacing[k] * count);
    out.set_real(14 + k, degrees_of(cosines[k]));
    out.set(17 + k, static_cast<std::uint32_t>(k + 1));
    out.set_real(50 + k, origin[k]);
  }
}

void set_rest(const DensityMap& map, MapBytes& out) {
  const MapStatistics found = map.statistics();
  out.set(4, static_cast<std::uint32_t>(MapMode::float32));
  out.set_real(20, found.least);
  out.set_real(21, found.greatest);
  out.set_real(22, found.mean);
  out.set(23, 1);      // space group P1: a volume
  out.set(28, 20140);  // version of the format
  out.set_text(53, "MAP ");
  out.set(54, 0x4144);  // little endian
  out.set_real(55, found.deviation);
  out.set(56, 1);
  out.set_text(57, "Pliant");
}

void check_directions(const std::array<Vec3, 3>& steps) {
  const bool is_standard = std::abs(steps[0].y) + std::abs(steps[0].z) < 1e-6 * steps[0].x &&
                           std::abs(steps[1].z) < 1e-6 * steps[1].y && steps[2].z > 0.0;
  if (!is_standard)
    throw InputError(
        "density map: expected a first step along x and a second in the plane of x and y, which "
        "files can keep");
}

}  // namespace

std::string map_bytes(const DensityMap& map) {
  check_directions(map.grid().steps);
  MapBytes out;
  set_grid(map.grid(), out);
  set_rest(map, out);
  out.reserve(map.values().size());
  const Grid points = map.grid().points();
  for (std::size_t k = 0; k < points.count[2]; ++k)
    for (std::size_t j = 0; j < points.count[1]; ++j)
      for (std::size_t i = 0; i < points.count[0]; ++i)
        out.append(map.values()[points.at(i, j, k)]);
  return out.taken();
}

void write_map(const std::filesystem::path& path, const DensityMap& map, bool overwrite) {
  write_text_file(path, map_bytes(map), overwrite);
}

}  // namespace pliant
