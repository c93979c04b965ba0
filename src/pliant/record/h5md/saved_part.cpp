// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/saved_part.hpp"

#include <string>
#include <utility>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

std::vector<Joint> checked_joints(std::span<const Joint> saved, std::size_t joint_count) {
  if (saved.empty()) throw OptionError("saved joints: expected at least one, found none");
  for (std::size_t k = 0; k < saved.size(); ++k)
    if (saved[k] >= joint_count || (k > 0 && saved[k] <= saved[k - 1]))
      throw OptionError("saved joints: expected ascending indices below " +
                        std::to_string(joint_count) + ", found " + std::to_string(saved[k]) +
                        " at " + std::to_string(k));
  return {saved.begin(), saved.end()};
}

template <class T>
std::vector<T> taken(std::span<const T> values, const std::vector<Joint>& joints) {
  std::vector<T> some;
  if (values.empty()) return some;
  some.reserve(joints.size());
  for (const Joint joint : joints) some.push_back(values[joint]);
  return some;
}

}  // namespace

template <class Pair>
bool SavedPart::take(Pair& pair) const {
  pair.a = part_of_[pair.a];
  pair.b = part_of_[pair.b];
  return pair.a != left_out && pair.b != left_out;
}

SavedPart::SavedPart(const Framework& whole, std::span<const Joint> saved)
    : joints_(checked_joints(saved, whole.joint_count())),
      part_of_(whole.joint_count(), left_out),
      framework_(part_of(whole)) {}

/// Residues that lose all atoms go, too.
std::shared_ptr<const AtomTable> SavedPart::atoms_of(const AtomTable& whole) const {
  auto atoms = std::make_shared<AtomTable>();
  atoms->names = taken(std::span(whole.names), joints_);
  atoms->elements = taken(std::span(whole.elements), joints_);
  atoms->serials = taken(std::span(whole.serials), joints_);
  std::uint32_t last = ~std::uint32_t{0};
  for (const Joint joint : joints_) {
    if (whole.residue_of[joint] != last)
      atoms->residues.push_back(whole.residues[last = whole.residue_of[joint]]);
    atoms->residue_of.push_back(static_cast<std::uint32_t>(atoms->residues.size() - 1));
  }
  return atoms;
}

Framework SavedPart::part_of(const Framework& whole) {
  for (std::size_t k = 0; k < joints_.size(); ++k) part_of_[joints_[k]] = static_cast<Joint>(k);
  const FrameworkParts parts = whole.parts();
  FrameworkParts part{.joint_count = joints_.size(),
                      .masses = taken(std::span(parts.masses), joints_),
                      .planar = parts.planar};
  if (parts.atoms) part.atoms = atoms_of(*parts.atoms);
  for (std::size_t k = 0; k < parts.bars.size(); ++k)
    if (Bar bar = parts.bars[k]; take(bar)) {
      part.bars.push_back(bar);
      part.rest_lengths.push_back(parts.rest_lengths[k]);
    }
  for (const Joint joint : parts.pinned)
    if (part_of_[joint] != left_out) part.pinned.push_back(part_of_[joint]);
  for (std::size_t k = 0; k < parts.limits.size(); ++k)
    if (Limit limit = parts.limits[k]; take(limit)) {
      part.limits.push_back(limit);
      limits_.push_back(static_cast<LimitIndex>(k));
    }
  return Framework(std::move(part));
}

std::vector<RecordedBond> SavedPart::bonds_of(std::span<const RecordedBond> bonds) const {
  std::vector<RecordedBond> some;
  for (RecordedBond bond : bonds)
    if (take(bond)) some.push_back(bond);
  return some;
}

H5mdHeader SavedPart::header_of(const H5mdHeader& header) const {
  H5mdHeader part = header;
  part.bonds = bonds_of(header.bonds);
  if (header.masses.size() == part_of_.size())  // else it is refused
    part.masses = taken(std::span(header.masses), joints_);
  part.inputs.reset();
  return part;
}

Frame SavedPart::shown(const Frame& frame) {
  positions_.clear();
  for (const Joint joint : joints_) positions_.push_back(frame.positions[joint]);
  limits_off_.clear();
  if (!frame.limits_off.empty())
    for (const LimitIndex limit : limits_) limits_off_.push_back(frame.limits_off[limit]);
  Frame shown = frame;
  shown.positions = positions_;
  shown.previous = {};
  shown.limits_off = limits_off_;
  return shown;
}

}  // namespace pliant
