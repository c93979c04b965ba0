// SPDX-License-Identifier: MIT
// What keeps the shape of nodes (alpha carbons) in a fit: springs to the distances of the start,
// and sterics.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "pliant/fit/fit_term.hpp"

namespace pliant {

/// Nodes of residues, in the order of their chains.
struct FitNodes {
  std::vector<Vec3> positions;       ///< (M) Angstrom
  std::vector<std::uint32_t> chain;  ///< (M) nodes of an unbroken chain are consecutive
};

/// How many residues two nodes of a chain are apart; a large number for those of two chains.
std::uint32_t residues_between(const FitNodes& nodes, std::uint32_t i, std::uint32_t j);

/// Springs between nodes within 10 Angstrom, k u^2 where u is how much longer than at the start:
/// k = 100, 30 and 10 for neighbours i+1, i+2 and i+3, else (6 / d)^6. Between residues more than
/// four apart a spring gives way when stretched: k c^2 u^2 / (c^2 + u^2), c = 2 Angstrom. So parts
/// can leave each other, but keep their shape.
class SpringTerm : public FitTerm {
 public:
  explicit SpringTerm(const FitNodes& nodes);
  double add(std::span<const Vec3> nodes, std::span<Vec3> gradient) const override;

 private:
  struct Spring {
    std::uint32_t i, j;
    double length, constant;
    bool gives_way;
  };

  std::vector<Spring> springs_;
};

/// Keeps nodes, four residues or more apart, from coming nearer than 4 Angstrom: 10 u^2.
class StericTerm : public FitTerm {
 public:
  explicit StericTerm(const FitNodes& nodes) : start_(nodes) {}
  void begin(std::size_t stage, std::span<const Vec3> nodes) override;
  double add(std::span<const Vec3> nodes, std::span<Vec3> gradient) const override;

 private:
  const FitNodes& start_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> near_;
};

}  // namespace pliant
