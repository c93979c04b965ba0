// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/shared/assembly.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "pliant/molecule/read/shared/reading.hpp"

namespace pliant {
namespace {

constexpr std::size_t most_atoms = 20'000'000;
constexpr double on_axis = 0.5;  // Angstrom between an atom and its own copy

/// A motion, and the atoms that it copies.
struct Copy {
  RigidMotion motion;
  std::vector<bool> takes;  ///< by instance, or by residue's chain where the file has no instances
};

/// What parts of an assembly speak of: label_asym_id of mmCIF, chains of PDB.
class Instances {
 public:
  explicit Instances(const AtomSites& sites) : sites_(sites) {
    if (sites.instances.empty())
      for (const Residue& residue : sites.structure.atoms.residues) number_of(residue.chain);
    for (const std::string& name : sites.instances) number_of(name);
  }

  std::size_t size() const { return numbers_.size(); }
  std::size_t of_atom(std::size_t atom) const {
    if (!sites_.instances.empty()) return sites_.instance_of[atom];
    const AtomTable& atoms = sites_.structure.atoms;
    return numbers_.find(atoms.residues[atoms.residue_of[atom]].chain)->second;
  }
  /// size() where there is none.
  std::size_t find(const std::string& name) const {
    const auto at = numbers_.find(name);
    return at == numbers_.end() ? size() : at->second;
  }

 private:
  void number_of(const std::string& name) { numbers_.emplace(name, numbers_.size()); }

  const AtomSites& sites_;
  std::map<std::string, std::size_t> numbers_;
};

/// One copy for each motion, whatever parts ask for it.
std::vector<Copy> copies_of(const Assembly& assembly, const Instances& instances) {
  std::vector<Copy> copies;
  for (const AssemblyPart& part : assembly)
    for (const RigidMotion& motion : part.motions) {
      auto copy = std::ranges::find(copies, motion, &Copy::motion);
      if (copy == copies.end())
        copy = copies.insert(copy, {motion, std::vector<bool>(instances.size(), false)});
      for (const std::string& chain : part.chains)
        if (const std::size_t k = instances.find(chain); k < instances.size())
          copy->takes[k] = true;
    }
  return copies;
}

/// Names for copies of chains.
class ChainNames {
 public:
  explicit ChainNames(const AtomTable& atoms) {
    for (const Residue& residue : atoms.residues) used_.insert(residue.chain);
  }

  /// The name of this chain in that copy.
  const std::string& of(const std::string& chain, std::size_t copy) {
    const auto [at, is_new] = names_.try_emplace({chain, copy});
    if (!is_new) return at->second;
    at->second = met_.insert(chain).second ? chain : next_free();
    copies_[chain].push_back(at->second);
    return at->second;
  }

  /// "A is A and C; B is B"
  std::string text() const {
    std::string text;
    for (const auto& [chain, names] : copies_) {
      text += (text.empty() ? "" : "; ") + pliant::quoted(chain) + " is ";
      for (std::size_t k = 0; k < names.size(); ++k)
        text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
    }
    return text;
  }

 private:
  std::string next_free() {
    constexpr std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";
    for (;; ++tried_) {
      std::string name;
      for (std::size_t n = tried_ + 1; n > 0; n = (n - 1) / letters.size())
        name.insert(name.begin(), letters[(n - 1) % letters.size()]);
      if (used_.insert(name).second) return name;
    }
  }

  std::set<std::string> used_, met_;
  std::map<std::pair<std::string, std::size_t>, std::string> names_;
  std::map<std::string, std::vector<std::string>> copies_;
  std::size_t tried_ = 0;
};

/// Makes the structure of all copies.
class Assembler {
 public:
  Assembler(const Structure& from, const Instances& instances, std::vector<Copy> copies)
      : from_(from), instances_(instances), copies_(std::move(copies)), names_(from.atoms) {
    to_.title = from.title;
    to_.model = from.model;
    to_.model_count = from.model_count;
    to_.assemblies = from.assemblies;
  }

  Structure make() {
    std::vector<std::vector<std::uint32_t>> made(copies_.size());
    for (std::size_t c = 0; c < copies_.size(); ++c) add_copy(c, made);
    for (const std::vector<std::uint32_t>& copy : made) add_bonds(copy);
    sort_bonds(to_.bonds);
    if (copies_.size() > 1)
      for (std::size_t i = 0; i < to_.size(); ++i)
        to_.atoms.serials[i] = static_cast<std::int64_t>(i + 1);
    return std::move(to_);
  }

  std::size_t atoms_on_axes() const { return on_axes_; }
  std::string chains() const { return names_.text(); }

 private:
  /// `made[c][i]`: which atom atom i became in copy c, or left_out.
  void add_copy(std::size_t c, std::vector<std::vector<std::uint32_t>>& made) {
    made[c].assign(from_.size(), left_out);
    std::size_t residue = from_.atoms.residues.size();
    for (std::size_t i = 0; i < from_.size(); ++i) {
      if (!copies_[c].takes[instances_.of_atom(i)]) continue;
      const Vec3 position = copies_[c].motion(from_.positions[i]);
      made[c][i] = earlier_copy(i, c, position, made);
      if (made[c][i] != left_out) continue;
      if (from_.atoms.residue_of[i] != residue) add_residue(residue = from_.atoms.residue_of[i], c);
      made[c][i] = static_cast<std::uint32_t>(to_.size());
      add_atom(i, position);
    }
    if (!to_.chain_end.empty()) to_.chain_end.back() = true;
  }

  std::uint32_t earlier_copy(std::size_t i, std::size_t c, Vec3 position,
                             const std::vector<std::vector<std::uint32_t>>& made) {
    for (std::size_t before = 0; before < c; ++before) {
      const std::uint32_t other = made[before][i];
      if (other == left_out || distance(to_.positions[other], position) > on_axis) continue;
      ++on_axes_;
      return other;
    }
    return left_out;
  }

  void add_residue(std::size_t residue, std::size_t c) {
    Residue copy = from_.atoms.residues[residue];
    copy.chain = names_.of(copy.chain, c);
    to_.atoms.residues.push_back(std::move(copy));
    if (!from_.chain_end.empty()) to_.chain_end.push_back(from_.chain_end[residue]);
  }

  void add_atom(std::size_t i, Vec3 position) {
    to_.atoms.names.push_back(from_.atoms.names[i]);
    to_.atoms.elements.push_back(from_.atoms.elements[i]);
    to_.atoms.residue_of.push_back(static_cast<std::uint32_t>(to_.atoms.residues.size() - 1));
    to_.atoms.serials.push_back(from_.atoms.serials[i]);
    to_.positions.push_back(position);
    if (!from_.charges.empty()) to_.charges.push_back(from_.charges[i]);
    if (!from_.b_factors.empty()) to_.b_factors.push_back(from_.b_factors[i]);
  }

  void add_bonds(const std::vector<std::uint32_t>& made) {
    for (Bond bond : from_.bonds) {
      const std::uint32_t a = made[bond.a], b = made[bond.b];
      if (a == left_out || b == left_out) continue;
      bond.a = std::min(a, b);
      bond.b = std::max(a, b);
      to_.bonds.push_back(bond);
    }
  }

  const Structure& from_;
  const Instances& instances_;
  std::vector<Copy> copies_;
  ChainNames names_;
  Structure to_;
  std::size_t on_axes_ = 0;
};

void check_size(const std::vector<Copy>& copies, std::size_t atoms, const std::string& name,
                const Remarks& remarks) {
  if (copies.size() > most_atoms / std::max<std::size_t>(atoms, 1))
    fail(remarks.place(0), "assembly " + name + " has " + std::to_string(copies.size()) +
                               " copies of " + std::to_string(atoms) + " atoms: at most " +
                               std::to_string(most_atoms) + " are made");
}

}  // namespace

Vec3 RigidMotion::operator()(Vec3 x) const {
  return {turn[0] * x.x + turn[1] * x.y + turn[2] * x.z + shift.x,
          turn[3] * x.x + turn[4] * x.y + turn[5] * x.z + shift.y,
          turn[6] * x.x + turn[7] * x.y + turn[8] * x.z + shift.z};
}

RigidMotion product(const RigidMotion& first, const RigidMotion& second) {
  RigidMotion both;
  both.shift = first(second.shift);
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
        sum += first.turn[3 * row + k] * second.turn[3 * k + column];
      both.turn[3 * row + column] = sum;
    }
  return both;
}

void check_assembly(const std::vector<std::string>& stated, const std::string& wanted,
                    const Remarks& remarks) {
  if (std::ranges::find(stated, wanted) != stated.end()) return;
  std::string known;
  for (const std::string& name : stated) known += (known.empty() ? "" : ", ") + name;
  throw OptionError("no assembly " + pliant::quoted(wanted) + " in " + std::string(remarks.file()) +
                    ": it states " + (known.empty() ? "none" : known));
}

void make_assembly(AtomSites& sites, const std::string& name, const Assembly& assembly,
                   Remarks& remarks) {
  const Instances instances(sites);
  std::vector<Copy> copies = copies_of(assembly, instances);
  const std::size_t count = copies.size();
  check_size(copies, sites.size(), name, remarks);
  Assembler assembler(sites.structure, instances, std::move(copies));
  Structure made = assembler.make();
  if (made.size() == 0)
    fail(remarks.place(0), "assembly " + name + ": none of its chains has atoms");
  remarks.note("assembly " + name + ": " + std::to_string(made.size()) + " atoms by " +
               std::to_string(count) + (count == 1 ? " motion" : " motions") + "; chain " +
               assembler.chains());
  if (assembler.atoms_on_axes() > 0)
    remarks.warn("axes", 0, [&] {
      return "assembly " + name + ": " + std::to_string(assembler.atoms_on_axes()) +
             (assembler.atoms_on_axes() == 1 ? " copy of an atom" : " copies of atoms") +
             " left out that would lie on the atom itself, as on an axis of symmetry";
    });
  sites.structure = std::move(made);
}

}  // namespace pliant
