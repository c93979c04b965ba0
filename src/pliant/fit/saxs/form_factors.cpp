// SPDX-License-Identifier: MIT
#include "pliant/fit/saxs/form_factors.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "pliant/base/math/elementary.hpp"

namespace pliant {
namespace {

/// f = sum of a exp(-b (q / 4 pi)^2) + c.
struct FormFactor {
  int element;
  std::array<double, 4> a, b;
  double c;
};

// clang-format off
constexpr FormFactor table[] = {
    {1, {0.493002, 0.322912, 0.140191, 0.04081}, {10.5109, 26.1257, 3.14236, 57.7997}, 0.003038},
    {6, {2.31, 1.02, 1.5886, 0.865}, {20.8439, 10.2075, 0.5687, 51.6512}, 0.2156},
    {7, {12.2126, 3.1322, 2.0125, 1.1663}, {0.0057, 9.8933, 28.9975, 0.5826}, -11.529},
    {8, {3.0485, 2.2868, 1.5463, 0.867}, {13.2771, 5.7011, 0.3239, 32.9089}, 0.2508},
    {9, {3.5392, 2.6412, 1.517, 1.0243}, {10.2825, 4.2944, 0.2615, 26.1476}, 0.2776},
    {11, {4.7626, 3.1736, 1.2674, 1.1128}, {3.285, 8.8422, 0.3136, 129.424}, 0.676},
    {12, {5.4204, 2.1735, 1.2269, 2.3073}, {2.8275, 79.2611, 0.3808, 7.1937}, 0.8584},
    {15, {6.4345, 4.1791, 1.78, 1.4908}, {1.9067, 27.157, 0.526, 68.1645}, 1.1149},
    {16, {6.9053, 5.2034, 1.4379, 1.5863}, {1.4679, 22.2151, 0.2536, 56.172}, 0.8669},
    {17, {11.4604, 7.1964, 6.2556, 1.6455}, {0.0104, 1.1662, 18.5194, 47.7784}, -9.5574},
    {19, {8.2186, 7.4398, 1.0519, 0.8659}, {12.7949, 0.7748, 213.187, 41.6841}, 1.4228},
    {20, {8.6266, 7.3873, 1.5899, 1.0211}, {10.4421, 0.6599, 85.7484, 178.437}, 1.3751},
    {25, {11.2819, 7.3573, 3.0193, 2.2441}, {5.3409, 0.3432, 17.8674, 83.7543}, 1.0896},
    {26, {11.7695, 7.3573, 3.5222, 2.3045}, {4.7611, 0.3072, 15.3535, 76.8805}, 1.0369},
    {27, {12.2841, 7.3409, 4.0034, 2.3488}, {4.2791, 0.2784, 13.5359, 71.1692}, 1.0118},
    {28, {12.8376, 7.292, 4.4438, 2.38}, {3.8785, 0.2565, 12.1763, 66.3421}, 1.0341},
    {29, {13.338, 7.1676, 5.6158, 1.6735}, {3.5828, 0.247, 11.3966, 64.8126}, 1.191},
    {30, {14.0743, 7.0318, 5.1652, 2.41}, {3.2655, 0.2333, 10.3163, 58.7097}, 1.3041},
    {34, {17.0006, 5.8196, 3.9731, 4.3543}, {2.4098, 0.2726, 15.2372, 43.8163}, 2.8409},
    {35, {17.1789, 5.2358, 5.6377, 3.9851}, {2.1723, 16.5796, 0.2609, 41.4328}, 2.9557},
    {53, {20.1472, 18.9949, 7.5138, 2.2735}, {4.347, 0.3814, 27.766, 66.8776}, 4.0712},
};
// clang-format on

struct Volume {
  int element;
  double volume;  // Angstrom^3
};
constexpr Volume volumes[] = {{1, 5.15},  {6, 16.44},  {7, 2.49},   {8, 9.13}, {12, 17.16},
                              {15, 5.73}, {16, 19.86}, {20, 31.89}, {25, 9.2}, {26, 7.99},
                              {29, 8.78}, {30, 9.85},  {34, 28.73}};
constexpr double other_volume = 9.2;

constexpr double solvent_density = 0.334;  // electrons per Angstrom^3
constexpr double oxygen_to_hydrogen = 0.96;

double bond_to_hydrogen(std::uint8_t element) {
  if (element == 6) return 1.09;
  if (element == 7) return 1.01;
  return element == 16 ? 1.34 : oxygen_to_hydrogen;
}

const FormFactor& nearest(int element) {
  const FormFactor* found = table;
  for (const FormFactor& row : table)
    if (std::abs(row.element - element) < std::abs(found->element - element)) found = &row;
  return *found;
}

double volume_of(int element) {
  for (const Volume& row : volumes)
    if (row.element == element) return row.volume;
  return other_volume;
}

double with_hydrogens(double heavy, int hydrogens, double bond, double q) {
  return hydrogens == 0 ? heavy
                        : heavy + hydrogens * atom_form_factor(1, q) * wave_between(q, bond);
}

}  // namespace

double wave_between(double q, double distance) {
  const double x = q * distance;
  if (x < 1e-6) return 1.0;
  return exact_bits_cos(std::remainder(x - std::numbers::pi / 2.0, 2.0 * std::numbers::pi)) / x;
}

double atom_form_factor(std::uint8_t element, double q) {
  const FormFactor& row = nearest(element);
  const double s = q / (4.0 * std::numbers::pi);
  double sum = row.c;
  for (std::size_t k = 0; k < row.a.size(); ++k)
    sum += row.a[k] * exact_bits_exp(-row.b[k] * s * s);
  return sum * element / row.element;
}

double form_factor(ScatteringGroup group, double q) {
  return with_hydrogens(atom_form_factor(group.element, q), group.hydrogens,
                        bond_to_hydrogen(group.element), q);
}

double water_form_factor(double q) { return form_factor({8, 2}, q); }

double displaced_volume(ScatteringGroup group) {
  return volume_of(group.element) + group.hydrogens * volume_of(1);
}

double displaced_form_factor(double volume, double q) {
  const double area = exact_bits_exp(exact_bits_log(volume) * 2.0 / 3.0);
  return solvent_density * volume * exact_bits_exp(-q * q * area / (4.0 * std::numbers::pi));
}

}  // namespace pliant
