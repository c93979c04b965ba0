// SPDX-License-Identifier: MIT
// Sparse matrices brought to row echelon form, row by row: their rank, and combinations of their
// rows that vanish. In real numbers by rotations (QR), modulo a prime by exact elimination.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "pliant/base/wide_product.hpp"

namespace pliant {

/// A number modulo the prime 2^61 - 1.
class ModularNumber {
 public:
  static constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - 1;

  constexpr ModularNumber() = default;
  constexpr explicit ModularNumber(std::uint64_t value) : value_((value & prime) + (value >> 61)) {
    if (value_ >= prime) value_ -= prime;
  }

  friend constexpr ModularNumber operator+(ModularNumber a, ModularNumber b) {
    return ModularNumber(a.value_ + b.value_);
  }
  friend constexpr ModularNumber operator-(ModularNumber a, ModularNumber b) {
    return ModularNumber(a.value_ + prime - b.value_);
  }
  friend constexpr ModularNumber operator*(ModularNumber a, ModularNumber b) {
    const WideProduct product = wide_product(a.value_, b.value_);
    return ModularNumber((product.low & prime) + (product.high << 3 | product.low >> 61));
  }
  friend constexpr bool operator==(ModularNumber, ModularNumber) = default;

  /// One over it (Fermat).
  constexpr ModularNumber inverse() const {
    ModularNumber result(1), power = *this;
    for (std::uint64_t rest = prime - 2; rest > 0; rest >>= 1, power = power * power)
      if ((rest & 1) != 0) result = result * power;
    return result;
  }

 private:
  std::uint64_t value_ = 0;
};

/// What a row and the row of its first column become: the row's first entry 0. A row whose first
/// column no other row has is scaled.
struct RowRotation {
  using Number = double;
  double c, s;

  static RowRotation of(double kept, double given) {
    const double length = std::sqrt(kept * kept + given * given);
    return {kept / length, given / length};
  }
  static double scale(double) { return 1.0; }
  std::pair<double, double> turn(double kept, double given) const {
    return {c * kept + s * given, c * given - s * kept};
  }
  /// Takes factors of the rows after to those of the rows before.
  std::pair<double, double> turn_back(double kept, double given) const {
    return {c * kept - s * given, s * kept + c * given};
  }
  static bool is_zero(double value) { return std::abs(value) <= 1e-14; }
};

struct RowElimination {
  using Number = ModularNumber;
  ModularNumber factor;

  static RowElimination of(ModularNumber, ModularNumber given) { return {given}; }
  static ModularNumber scale(ModularNumber first) { return first.inverse(); }
  std::pair<ModularNumber, ModularNumber> turn(ModularNumber kept, ModularNumber given) const {
    return {kept, given - factor * kept};
  }
  std::pair<ModularNumber, ModularNumber> turn_back(ModularNumber kept, ModularNumber given) const {
    return {kept - factor * given, given};
  }
  static bool is_zero(ModularNumber value) { return value == ModularNumber(); }
};

/// Rows are added one by one, in any order.
template <class Turn>
class RowReduction {
 public:
  using Number = typename Turn::Number;
  struct Entry {
    std::uint32_t column;
    Number value;
  };
  using Row = std::vector<Entry>;  ///< columns ascending

  explicit RowReduction(std::size_t columns) : kept_(columns) {}

  /// Takes a row in. `vanishes(row)` says whether what is left of it counts as 0. Returns whether
  /// it is independent of the rows before.
  template <class Vanishes>
  bool add(Row row, const Vanishes& vanishes) {
    first_.push_back(steps_.size());
    place_.push_back(none);
    scale_.push_back(Number{});
    while (!row.empty()) {
      if (Turn::is_zero(row.front().value)) {
        row.erase(row.begin());
        continue;
      }
      const std::uint32_t column = row.front().column;
      if (kept_[column].empty()) {
        if (vanishes(row)) return false;
        keep(std::move(row));
        return true;
      }
      const Turn turn = Turn::of(kept_[column].front().value, row.front().value);
      steps_.push_back({column, turn});
      row = turned(turn, kept_[column], row);
    }
    return false;
  }

  /// Factors of the rows (R), not all 0, with which they add up to nothing. `draw()` is called for
  /// each row that was not independent; what it returns chooses among all such factors.
  template <class Draw>
  std::vector<Number> vanishing_factors(const Draw& draw) const {
    std::vector<Number> of_kept(kept_.size()), factors(place_.size());
    for (std::size_t row = place_.size(); row-- > 0;) {
      Number factor = place_[row] == none ? draw() : of_kept[place_[row]] * scale_[row];
      if (place_[row] != none) of_kept[place_[row]] = Number{};
      const std::size_t end = row + 1 < first_.size() ? first_[row + 1] : steps_.size();
      for (std::size_t k = end; k-- > first_[row];) {
        Number& kept = of_kept[steps_[k].column];
        std::tie(kept, factor) = steps_[k].turn.turn_back(kept, factor);
      }
      factors[row] = factor;
    }
    return factors;
  }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  struct Step {
    std::uint32_t column;
    Turn turn;
  };

  void keep(Row row) {
    const Number scale = Turn::scale(row.front().value);
    for (Entry& entry : row) entry.value = entry.value * scale;
    place_.back() = row.front().column;
    scale_.back() = scale;
    kept_[row.front().column] = std::move(row);
  }

  /// Turns `kept` and `given`, which begin with one column; returns what `given` becomes.
  static Row turned(const Turn& turn, Row& kept, const Row& given) {
    Row above, below;
    auto a = kept.begin();
    auto b = given.begin();
    while (a != kept.end() || b != given.end()) {
      const std::uint32_t column =
          std::min(a == kept.end() ? none : a->column, b == given.end() ? none : b->column);
      const bool has_a = a != kept.end() && a->column == column;
      const bool has_b = b != given.end() && b->column == column;
      const auto [x, y] = turn.turn(has_a ? a->value : Number{}, has_b ? b->value : Number{});
      if (has_a || !(x == Number{})) above.push_back({column, x});
      if (column != given.front().column && !(y == Number{})) below.push_back({column, y});
      a += has_a;
      b += has_b;
    }
    kept = std::move(above);
    return below;
  }

  std::vector<Row> kept_;  ///< by first column
  std::vector<Step> steps_;
  std::vector<std::size_t> first_;    ///< (R) the first step of each row
  std::vector<std::uint32_t> place_;  ///< (R) the column where it is kept, or none
  std::vector<Number> scale_;         ///< (R) by which it was multiplied there
};

}  // namespace pliant
