// SPDX-License-Identifier: MIT
#include "pliant/path/ends.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/math/superposition.hpp"
#include "pliant/base/number.hpp"
#include "pliant/path/matching.hpp"
#include "pliant/path/shared_contacts.hpp"

namespace pliant {

MolecularModel model_of_start(const Structure& structure, ModelOptions options) {
  options.torsions = false;  // those of the end may be others
  return build_model(structure, options);
}

namespace {

using Indices = std::vector<std::uint32_t>;
constexpr std::uint32_t none = ~std::uint32_t{0};

/// What is matched in one of the two structures.
struct MatchedSide {
  Indices traced;    ///< (M) the atom of each matched residue
  Indices residues;  ///< (M)
  Indices asked;     ///< (K) atoms
};

Vec3 middle_of(const std::vector<Vec3>& positions, const Indices& atoms) {
  Vec3 sum;
  for (std::uint32_t atom : atoms) sum += positions[atom];
  return (1.0 / double(atoms.size())) * sum;
}

std::uint32_t nearest_to(Vec3 place, const std::vector<Vec3>& positions, const Indices& traced) {
  std::uint32_t nearest = 0;
  for (std::uint32_t k = 1; k < traced.size(); ++k)
    if (norm_squared(positions[traced[k]] - place) <
        norm_squared(positions[traced[nearest]] - place))
      nearest = k;
  return nearest;
}

/// (N) the matched residue that each atom goes with: its own, else the nearest.
Indices leaders(const MolecularModel& model, const MatchedSide& side) {
  const AtomTable& atoms = model.structure.atoms;
  std::vector<Indices> members(atoms.residues.size());
  for (std::uint32_t atom = 0; atom < atoms.size(); ++atom)
    members[atoms.residue_of[atom]].push_back(atom);
  Indices number(atoms.residues.size(), none), leader(atoms.size(), none);
  for (std::uint32_t k = 0; k < side.residues.size(); ++k) number[side.residues[k]] = k;
  for (std::size_t residue = 0; residue < members.size(); ++residue) {
    if (members[residue].empty()) continue;
    if (number[residue] == none)
      number[residue] =
          nearest_to(middle_of(model.positions, members[residue]), model.positions, side.traced);
    for (std::uint32_t atom : members[residue]) leader[atom] = number[residue];
  }
  return leader;
}

MolecularModel model_of_end(const Structure& structure, ModelOptions options) {
  options.contacts.reset();
  options.contacts_file.clear();
  options.prepare.floppy_below = 0.0;
  return model_of_start(structure, std::move(options));
}

/// A second model of a structure, which says nothing.
MolecularModel model_with(const Structure& structure, std::vector<MolecularContact> contacts,
                          ModelOptions options) {
  options.contacts = std::move(contacts);
  options.more_contacts.clear();
  options.log = options.prepare.log = {};
  return model_of_start(structure, std::move(options));
}

PathSide side_of(MolecularModel model, const MatchedSide& side) {
  Indices leader = leaders(model, side);
  return {std::move(model), side.asked, std::move(leader)};
}

/// Positions of matched residues at both ends.
struct MatchedPoints {
  std::vector<Vec3> ours, theirs;

  void add(const MatchedPoints& other, std::size_t k) {
    ours.push_back(other.ours[k]);
    theirs.push_back(other.theirs[k]);
  }
};

/// The sum of squared distances once superposed.
double squared_misfit(const MatchedPoints& points) {
  const RigidMotion fit = superposition(points.ours, points.theirs);
  double sum = 0.0;
  for (std::size_t k = 0; k < points.ours.size(); ++k)
    sum += norm_squared(fit(points.ours[k]) - points.theirs[k]);
  return sum;
}

/// To hundredths.
double rounded(double value) { return std::round(100.0 * value) / 100.0; }

/// A note where chains that are superposed one by one fit much better than all together, as where
/// crystals pack a dimer in two ways; "" else.
std::string arrangement_note(const MatchedPoints& points, const std::vector<std::string>& chains) {
  constexpr double least_of_all = 3.0;  // Angstrom: below, a path gets there
  constexpr double much_better = 0.5;   // of the misfit of all
  std::map<std::string, MatchedPoints> by_chain;
  for (std::size_t k = 0; k < chains.size(); ++k) by_chain[chains[k]].add(points, k);
  if (by_chain.size() < 2) return {};
  double of_chains = 0.0;
  std::string names;
  for (const auto& [name, part] : by_chain) {
    of_chains += squared_misfit(part);
    names += (names.empty() ? "" : ", ") + name;
  }
  const double count = double(chains.size());
  const double together = std::sqrt(squared_misfit(points) / count);
  const double alone = std::sqrt(of_chains / count);
  if (together < least_of_all || alone > much_better * together) return {};
  return "chains " + names + " are arranged differently in the two structures: superposed all " +
         "together they are " + number_text(rounded(together)) + " Angstrom apart, one by one " +
         number_text(rounded(alone)) + "; --select \"chainID " + by_chain.begin()->first +
         "\" follows one";
}

/// Contacts of theirs between atoms of ours, as far as we have those.
std::vector<MolecularContact> as_ours(const std::vector<MolecularContact>& contacts,
                                      const MatchedAtoms& theirs, const MatchedAtoms& ours) {
  std::vector<MolecularContact> found;
  for (MolecularContact contact : contacts) {
    const auto a = ours.atom_of(*theirs.name_of(contact.a));
    const auto b = ours.atom_of(*theirs.name_of(contact.b));
    if (!a || !b) continue;
    contact.a = *a;
    contact.b = *b;
    found.push_back(contact);
  }
  return found;
}

/// Matches a start with an end.
class EndsMatcher {
 public:
  EndsMatcher(const Structure& start, const Structure& end, const PathOptions& options)
      : options_(options),
        whole_(model_of_start(start, options.model)),
        goal_(model_of_end(end, options.model)) {}

  PathEnds match(const Structure& start, const Structure& end) {
    std::vector<std::string> notes = match_traces();
    if (find_path_atoms(options_.atoms).are_heavy) ask_heavy();
    const Structure &here = whole_.structure, &there = goal_.structure;
    const ResiduePairing all = with_ligands(here, there, {ours_.residues, theirs_.residues});
    const MatchedAtoms ours(here, all.ours), theirs(there, all.theirs);
    SharedContacts contacts = share_contacts(whole_.contacts, ours, goal_.contacts, theirs);
    PathEnds found{
        .start = side_of(model_with(start, std::move(contacts.ours), options_.model), ours_),
        .end = std::nullopt,
        .goal = {},
        .matched = ours_.residues.size(),
        .end_contacts = contacts.only_theirs.size(),
        .to_lose = std::move(contacts.only_ours),
        .to_make = as_ours(contacts.only_theirs, theirs, ours),
        .source_of_end = there.source,
        .notes = std::move(notes)};
    for (std::uint32_t atom : theirs_.asked) found.goal.push_back(goal_.positions[atom]);
    if (options_.both)
      found.end = side_of(model_with(end, std::move(contacts.theirs), options_.model), theirs_);
    return found;
  }

 private:
  /// Matches the traces; returns notes on how.
  std::vector<std::string> match_traces() {
    const Trace ours = trace_of(whole_.structure), theirs = trace_of(goal_.structure);
    if (ours.size() == 0)
      throw InputError(whole_.structure.source + ": has no residues of proteins or nucleic acids");
    ResidueMatch match = match_residues(ours, theirs, goal_.structure.source);
    take(ours, match.ours, whole_.structure, ours_);
    take(theirs, match.theirs, goal_.structure, theirs_);
    if (std::string note = note_on_arrangement(); !note.empty())
      match.notes.push_back(std::move(note));
    return std::move(match.notes);
  }

  std::string note_on_arrangement() const {
    MatchedPoints points;
    std::vector<std::string> chains;
    const AtomTable& atoms = whole_.structure.atoms;
    for (std::size_t k = 0; k < ours_.traced.size(); ++k) {
      points.ours.push_back(whole_.positions[ours_.traced[k]]);
      points.theirs.push_back(goal_.positions[theirs_.traced[k]]);
      chains.push_back(atoms.residues[ours_.residues[k]].chain);
    }
    return arrangement_note(points, chains);
  }

  static void take(const Trace& trace, const Indices& residues, const Structure& structure,
                   MatchedSide& side) {
    for (std::uint32_t residue : residues) {
      side.traced.push_back(trace[residue].atom);
      side.residues.push_back(structure.atoms.residue_of[trace[residue].atom]);
    }
    side.asked = side.traced;
  }

  /// Atoms of both that have the same name in residues that go together, but no hydrogens.
  void ask_heavy() {
    const Structure& structure = whole_.structure;
    const MatchedAtoms here(structure, ours_.residues);
    const MatchedAtoms there(goal_.structure, theirs_.residues);
    ours_.asked.clear();
    theirs_.asked.clear();
    for (std::uint32_t atom = 0; atom < structure.size(); ++atom) {
      const auto name = here.name_of(atom);
      if (!name || structure.atoms.elements[atom] <= 1) continue;
      const auto other = there.atom_of(*name);
      if (!other) continue;
      ours_.asked.push_back(atom);
      theirs_.asked.push_back(*other);
    }
  }

  const PathOptions& options_;
  MolecularModel whole_, goal_;
  MatchedSide ours_, theirs_;
};

/// Whether the goals of the residues of a contact, which go with the k-th atom each, let it be.
bool keeps(const MolecularContact& contact, const Indices& leader, const std::vector<Vec3>& here,
           const std::vector<Vec3>& goal) {
  constexpr double most_change = 2.0;  // Angstrom
  const std::uint32_t a = leader[contact.a], b = leader[contact.b];
  return std::abs(distance(goal[a], goal[b]) - distance(here[a], here[b])) <= most_change;
}

void check_goal(const MolecularModel& model, const Indices& atoms, const std::vector<Vec3>& goal) {
  const std::string where = model.structure.source + ": goal: ";
  if (atoms.size() < 3 || atoms.size() != goal.size())
    throw InputError(where + "expected the places of three or more residues");
  for (const std::uint32_t atom : atoms)
    if (atom >= model.positions.size()) throw InputError(where + "no such atom");
  if (!std::ranges::all_of(goal, is_finite)) throw InputError(where + "is not finite");
}

}  // namespace

PathEnds ends_at(const Structure& start, std::vector<std::uint32_t> atoms, std::vector<Vec3> goal,
                 const PathOptions& options, std::vector<Vec3> from) {
  check(options);
  const MolecularModel whole = model_of_start(start, options.model);
  check_goal(whole, atoms, goal);
  MatchedSide side{.traced = atoms, .residues = {}, .asked = atoms};
  std::vector<Vec3> here;
  for (const std::uint32_t atom : atoms) {
    side.residues.push_back(whole.structure.atoms.residue_of[atom]);
    here.push_back(whole.positions[atom]);
  }
  const Indices leader = leaders(whole, side);
  std::vector<MolecularContact> held, to_lose;
  for (const MolecularContact& contact : whole.contacts)
    (keeps(contact, leader, here, goal) ? held : to_lose).push_back(contact);
  PathEnds found{.start = side_of(model_with(start, std::move(held), options.model), side),
                 .end = std::nullopt,
                 .goal = std::move(goal),
                 .matched = atoms.size(),
                 .end_contacts = 0,
                 .to_lose = std::move(to_lose),
                 .to_make = {},
                 .source_of_end = "",
                 .notes = {}};
  if (from.empty()) return found;
  if (from.size() != whole.positions.size())
    throw InputError(whole.structure.source + ": begun: expected a frame of its model");
  found.start.model.positions = std::move(from);
  return found;
}

PathEnds match_ends(const Structure& start, const Structure& end, const PathOptions& options) {
  check(options);
  return EndsMatcher(start, end, options).match(start, end);
}

}  // namespace pliant
