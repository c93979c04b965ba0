// SPDX-License-Identifier: MIT
#include "pliant/molecule/bond_lengths.hpp"

#include <utility>

namespace pliant {
namespace {

struct Row {
  std::uint8_t a, b;  ///< a <= b
  std::uint8_t order;
  double length;  ///< Angstrom
};

constexpr Row rows[] = {
    {1, 1, 1, 0.741},  {1, 5, 1, 1.19},    {1, 6, 1, 1.09},   {1, 7, 1, 1.01},   {1, 8, 1, 0.96},
    {1, 9, 1, 0.917},  {1, 14, 1, 1.48},   {1, 15, 1, 1.42},  {1, 16, 1, 1.34},  {1, 17, 1, 1.275},
    {1, 34, 1, 1.46},  {1, 35, 1, 1.414},  {1, 53, 1, 1.609}, {5, 6, 1, 1.58},   {5, 7, 1, 1.42},
    {5, 8, 1, 1.37},   {5, 9, 1, 1.37},    {6, 6, 1, 1.53},   {6, 6, 2, 1.33},   {6, 6, 3, 1.19},
    {6, 6, 4, 1.39},   {6, 7, 1, 1.47},    {6, 7, 2, 1.28},   {6, 7, 3, 1.15},   {6, 7, 4, 1.34},
    {6, 8, 1, 1.42},   {6, 8, 2, 1.21},    {6, 8, 3, 1.13},   {6, 8, 4, 1.37},   {6, 9, 1, 1.37},
    {6, 14, 1, 1.86},  {6, 15, 1, 1.83},   {6, 16, 1, 1.81},  {6, 16, 2, 1.67},  {6, 16, 4, 1.71},
    {6, 17, 1, 1.76},  {6, 34, 1, 1.95},   {6, 35, 1, 1.93},  {6, 53, 1, 2.13},  {7, 7, 1, 1.41},
    {7, 7, 2, 1.24},   {7, 7, 3, 1.12},    {7, 7, 4, 1.35},   {7, 8, 1, 1.41},   {7, 8, 2, 1.22},
    {7, 8, 4, 1.39},   {7, 15, 1, 1.66},   {7, 16, 1, 1.64},  {7, 16, 2, 1.54},  {7, 16, 4, 1.65},
    {8, 8, 1, 1.47},   {8, 8, 2, 1.21},    {8, 14, 1, 1.63},  {8, 15, 1, 1.60},  {8, 15, 2, 1.48},
    {8, 16, 1, 1.58},  {8, 16, 2, 1.44},   {8, 17, 1, 1.69},  {8, 17, 2, 1.43},  {9, 14, 1, 1.59},
    {9, 15, 1, 1.58},  {9, 16, 1, 1.56},   {14, 14, 1, 2.35}, {14, 17, 1, 2.05}, {15, 16, 1, 2.09},
    {15, 16, 2, 1.95}, {15, 17, 1, 2.04},  {16, 16, 1, 2.05}, {16, 17, 1, 2.07}, {17, 17, 1, 1.988},
    {34, 34, 1, 2.34}, {35, 35, 1, 2.281}, {53, 53, 1, 2.666}};

bool makes_single_bonds_only(std::uint8_t element) {
  return element == 1 || element == 9 || element == 35 || element == 53;
}

}  // namespace

std::optional<double> standard_bond_length(std::uint8_t element_a, std::uint8_t element_b,
                                           std::uint8_t order) {
  if (element_a > element_b) std::swap(element_a, element_b);
  if (order == 0 && (makes_single_bonds_only(element_a) || makes_single_bonds_only(element_b)))
    order = 1;
  for (const Row& row : rows)
    if (row.a == element_a && row.b == element_b && row.order == order) return row.length;
  return std::nullopt;
}

}  // namespace pliant
