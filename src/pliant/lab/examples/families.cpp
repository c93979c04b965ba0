// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>
#include <utility>

#include "pliant/base/random.hpp"
#include "pliant/lab/examples/examples.hpp"

namespace pliant {
namespace {

Joint joint(std::size_t index) { return static_cast<Joint>(index); }

void join_in_a_row(Sketch& sketch) {
  for (std::size_t i = 1; i < sketch.positions.size(); ++i)
    sketch.bars.push_back({joint(i - 1), joint(i)});
}

RandomSequence draws_for(std::uint64_t seed, std::size_t index) {
  return RandomSequence({seed, Domain::generate, 0, 0, index});
}

}  // namespace

std::vector<double> drawn_lengths(const Sketch& sketch) {
  std::vector<double> lengths;
  lengths.reserve(sketch.bars.size());
  for (const Bar bar : sketch.bars)
    lengths.push_back(distance(sketch.positions[bar.a], sketch.positions[bar.b]));
  return lengths;
}

Framework framework_of(const Sketch& sketch) {
  FrameworkParts parts;
  parts.joint_count = sketch.positions.size();
  parts.bars = sketch.bars;
  parts.rest_lengths = drawn_lengths(sketch);
  return Framework(std::move(parts));
}

Sketch chain(std::size_t joints) {
  Sketch sketch;
  for (std::size_t i = 0; i < joints; ++i) {
    const std::size_t right = (i + 1) / 2, up = i / 2;
    sketch.positions.push_back({double(right), double(up), 0.0});
  }
  join_in_a_row(sketch);
  return sketch;
}

Sketch straight_chain(std::size_t joints) {
  Sketch sketch;
  for (std::size_t i = 0; i < joints; ++i) sketch.positions.push_back({double(i), 0.0, 0.0});
  join_in_a_row(sketch);
  return sketch;
}

Sketch ring(std::size_t joints) {
  Sketch sketch;
  const double turn = 2.0 * std::numbers::pi / double(joints);
  const double radius = 0.5 / std::sin(0.5 * turn);
  for (std::size_t i = 0; i < joints; ++i)
    sketch.positions.push_back(
        {radius * std::cos(turn * double(i)), radius * std::sin(turn * double(i)), 0.0});
  join_in_a_row(sketch);
  sketch.bars.push_back({joint(joints - 1), 0});
  return sketch;
}

Sketch star(std::size_t leaves) {
  Sketch sketch;
  sketch.positions.push_back({});
  for (std::size_t i = 1; i <= leaves; ++i) {
    sketch.positions.push_back(draws_for(0, i).direction());
    sketch.bars.push_back({0, joint(i)});
  }
  return sketch;
}

Sketch complete(std::size_t joints) {
  Sketch sketch;
  for (std::size_t i = 0; i < joints; ++i) {
    RandomSequence draws = draws_for(0, i);
    const double x = draws.uniform(), y = draws.uniform(), z = draws.uniform();
    sketch.positions.push_back({x, y, z});
    for (std::size_t k = 0; k < i; ++k) sketch.bars.push_back({joint(k), joint(i)});
  }
  return sketch;
}

Sketch grid(std::size_t rows, std::size_t columns) {
  Sketch sketch;
  const auto at = [&](std::size_t row, std::size_t column) {
    return joint(row * (columns + 1) + column);
  };
  for (std::size_t row = 0; row <= rows; ++row) {
    for (std::size_t column = 0; column <= columns; ++column) {
      sketch.positions.push_back({double(column), double(row), 0.0});
      if (column > 0) sketch.bars.push_back({at(row, column - 1), at(row, column)});
      if (row > 0) sketch.bars.push_back({at(row - 1, column), at(row, column)});
    }
  }
  return sketch;
}

Sketch with_angles(Sketch sketch) {
  const Framework framework = framework_of(sketch);
  // While the neighbours of joint i are looked at, i + 1 marks the joints that have their bar.
  std::vector<std::size_t> joined(framework.joint_count(), 0);
  for (std::size_t i = 0; i < framework.joint_count(); ++i) {
    joined[i] = i + 1;
    for (const Incidence& near : framework.neighbours(joint(i))) joined[near.joint] = i + 1;
    for (const Incidence& near : framework.neighbours(joint(i))) {
      for (const Incidence& far : framework.neighbours(near.joint)) {
        if (joined[far.joint] == i + 1 || far.joint < i) continue;
        joined[far.joint] = i + 1;
        sketch.bars.push_back({joint(i), far.joint});
      }
    }
  }
  return sketch;
}

Sketch shaken(Sketch sketch, double size, std::uint64_t seed) {
  for (std::size_t i = 0; i < sketch.positions.size(); ++i)
    sketch.positions[i] += size * draws_for(seed, i).direction();
  return sketch;
}

}  // namespace pliant
