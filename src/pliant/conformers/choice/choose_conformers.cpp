// SPDX-License-Identifier: MIT
#include "pliant/conformers/choice/choose_conformers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/math/elementary.hpp"

namespace pliant {
namespace {

void check(const ShapeDistances& shapes, std::span<const double> energies,
           const ConformerChoice& choice) {
  if (choice.most < 1) throw OptionError("most = 0: choose at least 1 conformer");
  if (!(choice.rms >= 0.0)) throw OptionError("rms: must be 0 Angstrom or more");
  if (!(choice.window >= 0.0)) throw OptionError("window: must be 0 kcal/mol or more");
  if (energies.size() != shapes.size())
    throw InputError(std::to_string(energies.size()) + " energies for " +
                     std::to_string(shapes.size()) + " conformers");
  if (!std::all_of(energies.begin(), energies.end(), [](double e) { return std::isfinite(e); }))
    throw InputError("energies of conformers must be finite");
}

constexpr double worth = 8.0;     // kcal/mol, of e times the distance
constexpr double furthest = 2.0;  // Angstrom: further ones are worth no more
constexpr double nearest = 1e-3;  // Angstrom: nearer ones cost no more

double cost_of(double energy, double apart) {
  return energy - worth * exact_bits_log(std::max(apart, nearest));
}

/// A conformer that may be chosen, and what it cost when it was last looked at: less than it costs
/// now, as others were chosen since.
struct Candidate {
  double cost;  ///< kcal/mol
  std::size_t number;
  double nearest = furthest;  ///< Angstrom, of the chosen ones that were looked at
  std::size_t looked_at = 0;

  bool operator>(const Candidate& other) const {
    return cost != other.cost ? cost > other.cost : number > other.number;
  }
};

/// Always the cheapest first; the others need not be looked at.
class Choosing {
 public:
  Choosing(const ShapeDistances& shapes, std::span<const double> energies,
           const ConformerChoice& choice)
      : shapes_(shapes), energies_(energies), choice_(choice) {
    const double lowest = *std::min_element(energies.begin(), energies.end());
    for (std::size_t k = 0; k < energies.size(); ++k)
      if (energies[k] <= lowest + choice.window) left_.push({cost_of(energies[k], furthest), k});
  }

  std::vector<std::size_t> choose() {
    while (!left_.empty() && chosen_.size() < choice_.most) {
      Candidate next = left_.top();
      left_.pop();
      if (next.looked_at == chosen_.size())
        chosen_.push_back(next.number);
      else if (look_at(next))
        left_.push(next);
    }
    std::stable_sort(chosen_.begin(), chosen_.end(), [&](std::size_t a, std::size_t b) {
      return energies_[a] != energies_[b] ? energies_[a] < energies_[b] : a < b;
    });
    return std::move(chosen_);
  }

 private:
  /// False: it is like one that is chosen.
  bool look_at(Candidate& next) const {
    for (; next.looked_at < chosen_.size(); ++next.looked_at) {
      const std::size_t known = chosen_[next.looked_at];
      const double reach = std::max(next.nearest, choice_.rms);
      const double apart = shapes_.between(known, next.number, reach);
      if (apart <= choice_.rms) return false;
      next.nearest = std::min(next.nearest, apart);
    }
    next.cost = cost_of(energies_[next.number], next.nearest);
    return true;
  }

  const ShapeDistances& shapes_;
  std::span<const double> energies_;
  const ConformerChoice& choice_;
  std::vector<std::size_t> chosen_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> left_;
};

}  // namespace

std::vector<std::size_t> choose_conformers(const ShapeDistances& shapes,
                                           std::span<const double> energies,
                                           const ConformerChoice& choice) {
  check(shapes, energies, choice);
  if (energies.empty()) return {};
  return Choosing(shapes, energies, choice).choose();
}

}  // namespace pliant
