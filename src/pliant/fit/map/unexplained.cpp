// SPDX-License-Identifier: MIT
#include "pliant/fit/map/unexplained.hpp"

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

double excess(float value, double threshold) { return std::max(value - threshold, 0.0); }

double excess_of_all(const DensityMap& map, double threshold) {
  double all = 0.0;
  for (const float value : map.values()) all += excess(value, threshold);
  if (!(all > 0.0))
    throw OptionError("threshold = " + number_text(threshold) +
                      ": must be below the greatest value of the map, " +
                      number_text(map.statistics().greatest));
  return all;
}

/// Points above the threshold that are near to no position.
Mask far_points(const DensityMap& map, std::span<const Vec3> positions, double threshold,
                double radius) {
  Mask chosen;
  for (const float value : map.values()) chosen.push_back(value > threshold);
  for (const Vec3 position : positions)
    for_each_point_near(map.grid(), map.places(), position, radius,
                        [&](std::size_t point, double) { chosen[point] = 0; });
  return chosen;
}

/// Each region as a blob whose share is its density, and whose center its first moment.
std::vector<DensityBlob> blobs_of(const DensityMap& map, const Mask& chosen, double threshold) {
  const std::vector<std::int32_t> regions = regions_of(map.grid().points(), chosen);
  const std::int32_t count = *std::max_element(regions.begin(), regions.end());
  std::vector<DensityBlob> blobs(static_cast<std::size_t>(count));
  for (std::size_t point = 0; point < regions.size(); ++point) {
    if (regions[point] == 0) continue;
    DensityBlob& blob = blobs[static_cast<std::size_t>(regions[point] - 1)];
    const double density = excess(map.values()[point], threshold);
    blob.share += density;
    blob.center += density * place_of(map.grid(), point);
  }
  return blobs;
}

}  // namespace

double usual_threshold(const DensityMap& map) {
  const MapStatistics found = map.statistics();
  return found.mean + 2.0 * found.deviation;
}

UnexplainedDensity unexplained_density(const DensityMap& map, std::span<const Vec3> positions,
                                       double threshold, double radius, std::size_t most_blobs) {
  if (!(radius > 0.0 && radius <= 100.0))
    throw OptionError("radius = " + number_text(radius) +
                      ": must be above 0, and 100 at most (Angstrom)");
  const double all = excess_of_all(map, threshold);
  UnexplainedDensity out;
  out.blobs = blobs_of(map, far_points(map, positions, threshold, radius), threshold);
  for (DensityBlob& blob : out.blobs) {
    blob.center *= 1.0 / blob.share;
    blob.share /= all;
    out.share += blob.share;
  }
  std::stable_sort(out.blobs.begin(), out.blobs.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
  if (out.blobs.size() > most_blobs) out.blobs.resize(most_blobs);
  return out;
}

}  // namespace pliant
