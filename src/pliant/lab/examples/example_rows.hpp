// SPDX-License-Identifier: MIT
// Rows of the table of examples, by origin; private to the folder.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "pliant/lab/examples/examples.hpp"

namespace pliant {

// Sources that several of the files cite.
inline constexpr std::string_view closed_form = "closed form";
inline constexpr std::string_view pyrigi =
    "PyRigi 06cee707, frameworkDB.py and test_infinitesimal.py";

/// An example before its framework is made.
struct ExampleRow {
  std::string_view name, source;
  Sketch sketch;
  ExampleFacts facts = {};
  std::vector<double> rest_lengths = {};  ///< (B) Angstrom; empty: as in the sketch
  std::vector<double> masses = {};        ///< (N) u; empty: all 1
  std::vector<Joint> pinned = {};
  std::vector<Limit> limits = {};
  std::shared_ptr<const Sterics> sterics = {};
};

/// A sketch whose bars are written as pairs of letters, one letter for each joint: "ab bc".
Sketch spelled(std::string_view bars, std::vector<Vec3> positions);

std::vector<ExampleRow> thesis_examples();       ///< figures of the thesis
std::vector<ExampleRow> family_examples();       ///< the families at small sizes
std::vector<ExampleRow> rigidity_examples();     ///< known ranks
std::vector<ExampleRow> planar_examples();       ///< known ranks, in the plane z = 0
std::vector<ExampleRow> projection_examples();   ///< systems that test other programs
std::vector<ExampleRow> feasibility_examples();  ///< at and beyond the limits of feasibility
std::vector<ExampleRow> limit_examples();        ///< with limits and sterics

}  // namespace pliant
