// SPDX-License-Identifier: MIT
// Examples: families of frameworks by size, and a table of tiny named frameworks with known
// properties. Tests, benchmarks and documentation all use the same table.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// Joints at their places, and bars between them.
struct Sketch {
  std::vector<Vec3> positions;  ///< (N) Angstrom
  std::vector<Bar> bars;        ///< (B)
};

/// The distances that the bars of a sketch have (B).
std::vector<double> drawn_lengths(const Sketch& sketch);

/// The framework whose rest lengths are the distances in the sketch, all masses 1, none pinned.
Framework framework_of(const Sketch& sketch);

/// N joints in a staircase of unit steps, along x and y in turn.
Sketch chain(std::size_t joints);
/// N joints a unit apart along x.
Sketch straight_chain(std::size_t joints);
/// The regular polygon of n >= 3 unit sides in the plane z = 0.
Sketch ring(std::size_t joints);
/// Joint 0 at the origin, joined to n leaves a unit away in directions that differ.
Sketch star(std::size_t leaves);
/// n joints at random places in the unit cube, each joined to every other.
Sketch complete(std::size_t joints);
/// A square grid of rows x columns unit cells in the plane z = 0.
Sketch grid(std::size_t rows, std::size_t columns);
/// `sketch` with additional bars, after the old ones, between joints that share a neighbour, as
/// bond angles give them. Pairs that have a bar already get none.
Sketch with_angles(Sketch sketch);
/// `sketch` with each joint displaced by `size` Angstrom in a random direction, which makes its
/// positions generic.
Sketch shaken(Sketch sketch, double size, std::uint64_t seed = 0);

/// Properties of an example known from closed forms, the literature or another program.
struct ExampleFacts {
  std::size_t components = 1;
  std::size_t cycles = 0;                ///< independent cycles
  std::size_t bridges = 0;               ///< bars on no cycle
  std::size_t blocks = 0;                ///< biconnected components of two or more bars
  bool feasible = true;                  ///< there are positions that satisfy all constraints
  bool whole = true;                     ///< the positions of the example do
  std::optional<std::size_t> rank = {};  ///< of the rigidity matrix at the positions
  std::optional<std::size_t> rigid_motions = {};  ///< independent rigid motions: 3, 5 or 6
  std::optional<std::size_t> flexes = {};         ///< true internal degrees of freedom, in space
};

/// A named framework with its facts.
struct Example {
  std::string_view name;
  std::string_view source;  ///< where the numbers come from
  Framework framework;
  std::vector<Vec3> positions;  ///< (N) Angstrom
  ExampleFacts facts;
};

/// All examples, made once.
std::span<const Example> examples();

/// The example of that name. Throws OptionError listing the known names.
const Example& find_example(std::string_view name);

}  // namespace pliant
