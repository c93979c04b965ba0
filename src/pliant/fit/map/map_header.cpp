// SPDX-License-Identifier: MIT
#include "pliant/fit/map/map_header.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/math/elementary.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/printable.hpp"

namespace pliant {
namespace {

using Words = std::array<std::int32_t, 3>;
using Reals = std::array<double, 3>;

std::string three_text(const Words& words) {
  return std::to_string(words[0]) + " " + std::to_string(words[1]) + " " + std::to_string(words[2]);
}

std::string three_text(const Reals& reals) {
  return number_text(reals[0]) + " " + number_text(reals[1]) + " " + number_text(reals[2]);
}

/// Words of a header, counted from 1 as its description does.
class HeaderWords {
 public:
  HeaderWords(std::string_view bytes, std::string_view name)
      : bytes_(bytes), name_(printable_name(name)) {
    if (bytes.size() < map_header_size)
      fail("header", std::to_string(map_header_size) + " bytes",
           std::to_string(bytes.size()) + " bytes");
    is_big_endian_ = found_order();
  }

  bool is_big_endian() const { return is_big_endian_; }
  bool is_marked() const { return bytes_.substr(208, 3) == "MAP"; }

  std::int32_t word(std::size_t number) const {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t at = 4 * (number - 1) + (is_big_endian_ ? k : 3 - k);
      value = value << 8 | static_cast<unsigned char>(bytes_[at]);
    }
    return static_cast<std::int32_t>(value);
  }
  Words words(std::size_t first) const { return {word(first), word(first + 1), word(first + 2)}; }
  Reals reals(std::size_t first) const {
    const auto real = [&](std::size_t k) {
      return static_cast<double>(std::bit_cast<float>(word(first + k)));
    };
    return {real(0), real(1), real(2)};
  }

  [[noreturn]] void fail(std::string_view field, std::string_view expected,
                         const std::string& found) const {
    pliant::fail({name_}, "map: " + std::string(field) + ": expected " + std::string(expected) +
                              ", found " + found);
  }

 private:
  bool found_order() {
    const char stamp = bytes_[212];
    if (stamp == 0x44 || stamp == 0x11) return stamp == 0x11;
    const Words little = words(1);
    return !std::all_of(little.begin(), little.end(),
                        [](std::int32_t one) { return one > 0 && one < 65536; });
  }

  std::string_view bytes_;
  std::string name_;
  bool is_big_endian_ = false;
};

MapMode mode_of(const HeaderWords& header) {
  const std::int32_t mode = header.word(4);
  if (mode != 0 && mode != 1 && mode != 2 && mode != 6 && mode != 12)
    header.fail("mode (word 4)", "0, 1, 2, 6 or 12", std::to_string(mode));
  return static_cast<MapMode>(mode);
}

std::array<std::size_t, 3> counts_of(const HeaderWords& header) {
  const Words counts = header.words(1);
  if (*std::min_element(counts.begin(), counts.end()) < 2)
    header.fail("columns, rows and sections (words 1 to 3)", "2 or more of each",
                three_text(counts));
  return {static_cast<std::size_t>(counts[0]), static_cast<std::size_t>(counts[1]),
          static_cast<std::size_t>(counts[2])};
}

std::array<std::size_t, 3> axes_of(const HeaderWords& header) {
  const Words axes = header.words(17);
  if (axes == Words{}) return {0, 1, 2};
  Words sorted = axes;
  std::sort(sorted.begin(), sorted.end());
  if (sorted != Words{1, 2, 3})
    header.fail("axes (words 17 to 19)", "1, 2 and 3 in some order", three_text(axes));
  return {static_cast<std::size_t>(axes[0] - 1), static_cast<std::size_t>(axes[1] - 1),
          static_cast<std::size_t>(axes[2] - 1)};
}

/// Where densities begin, if all are there: without a product that could be too large.
std::size_t start_of_densities(const HeaderWords& header, const MapHeader& found,
                               std::size_t file_size) {
  const std::int32_t extended = header.word(24);
  if (extended < 0)
    header.fail("length of the extended header (word 24)", "0 or more", std::to_string(extended));
  const std::size_t start = map_header_size + static_cast<std::size_t>(extended);
  const std::size_t left = file_size > start ? file_size - start : 0;
  const std::size_t rows = left / size_of(found.mode) / found.count[0];
  if (found.count[2] > rows / found.count[1])
    header.fail("densities",
                std::to_string(found.count[0]) + " x " + std::to_string(found.count[1]) + " x " +
                    std::to_string(found.count[2]) + " of " + std::to_string(size_of(found.mode)) +
                    " bytes from byte " + std::to_string(start),
                std::to_string(left) + " bytes: the file is cut short, or is no map");
  return start;
}

/// Distances between points along each axis of the cell, Angstrom.
Reals spacing_of(const HeaderWords& header, const std::array<std::size_t, 3>& count) {
  const Reals cell = header.reals(11);
  for (const double length : cell)
    if (!(length > 0.0 && length < 1e6))
      header.fail("cell (words 11 to 13)", "lengths above 0 Angstrom", three_text(cell));
  const Words intervals = header.words(8);
  if (*std::min_element(intervals.begin(), intervals.end()) < 0)
    header.fail("intervals (words 8 to 10)", "1 or more", three_text(intervals));
  Reals spacing{};
  for (std::size_t k = 0; k < 3; ++k)
    spacing[k] = cell[k] / (intervals[k] > 0 ? intervals[k] : static_cast<double>(count[k]));
  return spacing;
}

/// Cosines of the angles of the cell: exactly 0 at 90 degrees.
Reals cosines_of(const HeaderWords& header) {
  const Reals angles = header.reals(14);
  if (angles == Reals{}) return {};
  Reals cosines{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(angles[k] > 0.0 && angles[k] < 180.0))
      header.fail("angles of the cell (words 14 to 16)", "degrees between 0 and 180",
                  three_text(angles));
    cosines[k] = angles[k] == 90.0 ? 0.0 : exact_bits_cos(angles[k] * std::numbers::pi / 180.0);
  }
  return cosines;
}

/// Steps of unit length: the first along x, the second in the plane of x and y.
std::array<Vec3, 3> directions_of(const HeaderWords& header) {
  const auto [alpha, beta, gamma] = cosines_of(header);
  const double sine = std::sqrt(1.0 - gamma * gamma);
  const double y = (alpha - beta * gamma) / sine;
  const double squared = 1.0 - beta * beta - y * y;
  // A cell as flat as this is a header gone wrong; so is one whose angles fit no cell.
  if (!(std::sqrt(std::max(squared, 0.0)) * sine > 0.1))
    header.fail("angles of the cell (words 14 to 16)", "those of a cell that is not nearly flat",
                three_text(header.reals(14)));
  return {Vec3{1, 0, 0}, Vec3{gamma, sine, 0}, Vec3{beta, y, std::sqrt(squared)}};
}

Vec3 origin_of(const HeaderWords& header, const MapHeader& found) {
  const Reals origin = header.reals(50);
  const Vec3 stated{origin[0], origin[1], origin[2]};
  if (header.is_marked() && !(stated == Vec3{})) {
    if (!is_finite(stated))
      header.fail("origin (words 50 to 52)", "finite coordinates", three_text(origin));
    return stated;
  }
  const Words start = header.words(5);
  Vec3 place;
  for (std::size_t k = 0; k < 3; ++k) place += start[k] * found.grid.steps[found.axis[k]];
  return place;
}

}  // namespace

std::size_t size_of(MapMode mode) {
  return mode == MapMode::int8 ? 1 : mode == MapMode::float32 ? 4 : 2;
}

MapHeader read_map_header(std::string_view bytes, std::string_view name) {
  const HeaderWords header(bytes, name);
  MapHeader out;
  out.is_big_endian = header.is_big_endian();
  out.count = counts_of(header);
  out.mode = mode_of(header);
  out.axis = axes_of(header);
  out.densities = start_of_densities(header, out, bytes.size());
  for (std::size_t k = 0; k < 3; ++k) out.grid.count[out.axis[k]] = out.count[k];
  const Reals spacing = spacing_of(header, out.grid.count);
  const std::array<Vec3, 3> directions = directions_of(header);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(spacing[k] >= 1e-3 && spacing[k] <= 1e4))
      header.fail("cell divided by intervals", "0.001 to 10000 Angstrom", three_text(spacing));
    out.grid.steps[k] = spacing[k] * directions[k];
  }
  out.grid.origin = origin_of(header, out);
  return out;
}

}  // namespace pliant
