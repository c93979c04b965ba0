// SPDX-License-Identifier: MIT
#include "pliant/lab/examples/examples.hpp"

#include <iterator>
#include <utility>

#include "pliant/base/choices.hpp"
#include "pliant/lab/examples/example_rows.hpp"

namespace pliant {
namespace {

Example example_of(ExampleRow row) {
  if (row.rest_lengths.empty()) row.rest_lengths = drawn_lengths(row.sketch);
  FrameworkParts parts;
  parts.joint_count = row.sketch.positions.size();
  parts.bars = std::move(row.sketch.bars);
  parts.rest_lengths = std::move(row.rest_lengths);
  parts.masses = std::move(row.masses);
  parts.pinned = std::move(row.pinned);
  parts.limits = std::move(row.limits);
  parts.sterics = std::move(row.sterics);
  return {row.name, row.source, Framework(std::move(parts)), std::move(row.sketch.positions),
          row.facts};
}

std::vector<Example> all_examples() {
  std::vector<Example> all;
  for (const auto rows : {thesis_examples, family_examples, rigidity_examples, planar_examples,
                          projection_examples, feasibility_examples, limit_examples})
    for (ExampleRow& row : rows()) all.push_back(example_of(std::move(row)));
  return all;
}

}  // namespace

Sketch spelled(std::string_view bars, std::vector<Vec3> positions) {
  Sketch sketch;
  sketch.positions = std::move(positions);
  for (std::size_t i = 0; i + 1 < bars.size(); i += 3)
    sketch.bars.push_back(
        {static_cast<Joint>(bars[i] - 'a'), static_cast<Joint>(bars[i + 1] - 'a')});
  return sketch;
}

std::span<const Example> examples() {
  static const std::vector<Example> all = all_examples();
  return all;
}

const Example& find_example(std::string_view name) { return choose(examples(), "example", name); }

}  // namespace pliant
