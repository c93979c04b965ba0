// SPDX-License-Identifier: MIT
#include "pliant/molecule/bonds/stated_bonds.hpp"

#include <algorithm>

#include "pliant/base/elements.hpp"
#include "pliant/molecule/bonds/coordination.hpp"
#include "pliant/molecule/bonds/cut_bonds.hpp"
#include "pliant/molecule/read/read.hpp"

namespace pliant::perception {
namespace {

constexpr double largest_ratio = 1.3;  // to the sum of covalent radii

class Judge {
 public:
  explicit Judge(Perception& perception)
      : p_(perception), atoms_(perception.structure.atoms), is_flat_(is_flat()) {}

  void run() {
    std::erase_if(p_.bonds, [&](const Bond& bond) { return !is_bond(bond); });
  }

 private:
  bool is_flat() const {
    return is_from(p_.structure, &Format::has_small_molecules) &&
           std::ranges::all_of(p_.structure.positions, [](Vec3 p) { return p.z == 0.0; });
  }

  bool is_bond(const Bond& bond) {
    if (bond.origin != BondOrigin::file) return true;
    const double length = p_.length(bond.a, bond.b);
    if (is_coordination(atoms_, bond)) {
      if (length > reach_of(bond)) p_.unheld.push_back(bond);
      return false;
    }
    if (!is_long(bond, length)) return true;
    const bool stays = is_of_metal(bond) || is_from(p_.structure, &Format::has_small_molecules);
    (stays ? p_.long_kept : p_.long_out).push_back(bond);
    return stays;
  }

  bool is_of_metal(const Bond& bond) const {
    return is_metal(atoms_.elements[bond.a]) || is_metal(atoms_.elements[bond.b]);
  }

  double reach_of(const Bond& bond) const {
    const std::uint8_t a = atoms_.elements[bond.a], b = atoms_.elements[bond.b];
    return is_metal(a) ? coordination_reach(a, b) : coordination_reach(b, a);
  }

  bool is_long(const Bond& bond, double length) const {
    if (is_flat_ || p_.excluded[bond.a] || p_.excluded[bond.b]) return false;
    const double one = covalent_radius(atoms_.elements[bond.a]);
    const double other = covalent_radius(atoms_.elements[bond.b]);
    if (one <= 0.0 || other <= 0.0 || length <= largest_ratio * (one + other)) return false;
    const bool is_of_one_residue = atoms_.residue_of[bond.a] == atoms_.residue_of[bond.b];
    return !is_of_one_residue || length <= longest_bad_bond;
  }

  Perception& p_;
  const AtomTable& atoms_;
  bool is_flat_;
};

}  // namespace

void judge_stated_bonds(Perception& perception) { Judge(perception).run(); }

}  // namespace pliant::perception
