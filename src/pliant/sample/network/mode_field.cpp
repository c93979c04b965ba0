// SPDX-License-Identifier: MIT
#include "pliant/sample/network/mode_field.hpp"

#include <cmath>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/sample/network/coarse_nodes.hpp"
#include "pliant/sample/network/mode_displacement.hpp"
#include "pliant/sample/network/network_modes.hpp"

namespace pliant {

std::vector<Vec3> mode_field(const NetworkNodes& nodes, std::span<const Vec3> start,
                             std::size_t mode, double amplitude, std::string_view network) {
  check(nodes, start.size());
  const NetworkNodes coarse = coarsened(nodes);
  NetworkModes modes = network_modes(coarse, network);
  if (mode < 1 || mode > modes.variances.size())
    throw OptionError("mode = " + std::to_string(mode) + ": must be from 1 to " +
                      std::to_string(modes.variances.size()) + ", the modes of the network");
  // Modes have unit length: the mean square of n nodes is 1 / n.
  for (double& variance : modes.variances) variance = 1.0;
  std::vector<double> amplitudes(modes.variances.size(), 0.0);
  amplitudes[mode - 1] = amplitude * std::sqrt(double(coarse.positions.size()));
  std::vector<Vec3> field(start.size());
  ModeDisplacement(coarse, std::move(modes), start).displacements(amplitudes, field);
  return field;
}

}  // namespace pliant
