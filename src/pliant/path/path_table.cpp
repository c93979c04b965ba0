// SPDX-License-Identifier: MIT
#include "pliant/path/path_table.hpp"

#include <algorithm>

#include "pliant/framework/measures/residual.hpp"
#include "pliant/path/path_walker.hpp"
#include "pliant/path/shared_contacts.hpp"

namespace pliant {
namespace {

constexpr double broken = 0.1;  // a contact so far outside its interval is none, Angstrom

std::int64_t count_broken(std::span<const MolecularContact> contacts,
                          std::span<const Vec3> positions) {
  return std::count_if(contacts.begin(), contacts.end(), [&](const MolecularContact& contact) {
    return outside(contact, positions) > broken;
  });
}

/// "A:LYS12 NZ"
std::string label_of(const AtomTable& atoms, Joint atom) {
  std::string label = atoms.label(atom);
  if (const std::size_t colon = label.rfind(':'); colon != std::string::npos) label[colon] = ' ';
  return label;
}

}  // namespace

PathTable::PathTable(const PathEnds& ends)
    : ends_(ends),
      begun_(asked_of(ends.start, ends.start.model.positions)),
      near_(ends.start.model.framework) {}

PathFrame PathTable::row(std::int64_t step, std::span<const Vec3> positions, double max_residual) {
  const std::vector<Vec3> here = asked_of(ends_.start, positions);
  PathFrame row;
  row.step = step;
  row.to_end = rms(ways(here, ends_.goal));
  row.from_start = rms(ways(here, begun_));
  row.lost = count_broken(ends_.to_lose, positions);
  row.made = std::int64_t(ends_.to_make.size()) - count_broken(ends_.to_make, positions);
  row.max_residual = max_residual;
  for (const MolecularContact& contact : ends_.start.model.contacts)
    row.held_off = std::max(row.held_off, outside(contact, positions));
  find_tightest(positions, row);
  return row;
}

void PathTable::find_tightest(std::span<const Vec3> positions, PathFrame& row) {
  const MolecularModel& model = ends_.start.model;
  const ResidualSummary found = measure(model.framework, positions, {}, {}, &near_);
  if (found.max_overlap <= 0.0) return;
  const auto [one, other] = std::minmax(found.worst_overlap.a, found.worst_overlap.b);
  row.overlap = found.max_overlap;
  row.tightest =
      label_of(model.structure.atoms, one) + " - " + label_of(model.structure.atoms, other);
}

std::vector<TightPlace> tight_places(std::span<const PathFrame> frames, std::size_t count) {
  std::vector<TightPlace> found;
  for (const PathFrame& frame : frames) {
    if (frame.tightest.empty()) continue;
    auto place = std::find_if(found.begin(), found.end(),
                              [&](const TightPlace& one) { return one.atoms == frame.tightest; });
    if (place == found.end()) place = found.insert(found.end(), {frame.tightest, 0.0, 0, 0});
    ++place->frames;
    if (frame.overlap <= place->overlap) continue;
    place->overlap = frame.overlap;
    place->step = frame.step;
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const TightPlace& a, const TightPlace& b) { return a.overlap > b.overlap; });
  if (found.size() > count) found.resize(count);
  return found;
}

}  // namespace pliant
