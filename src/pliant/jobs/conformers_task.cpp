// SPDX-License-Identifier: MIT
#include "pliant/jobs/conformers_task.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/base/random.hpp"
#include "pliant/conformers/strain/bent_rings.hpp"
#include "pliant/conformers/strain/conformer_energy.hpp"
#include "pliant/conformers/strain/relaxation.hpp"
#include "pliant/conformers/strain/strain.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "pliant/sample/samplers.hpp"

namespace pliant {
namespace {

constexpr double furthest_shaken = 1.0;  // Angstrom
constexpr std::uint64_t tries = 4;       // to shake rings and keep handedness
constexpr double least_volume = 0.3;  // Angstrom^3, of three bonds: flatter ones have no handedness

MolecularModel molecule_model(const Structure& structure, const Log& log) {
  ModelOptions options;
  options.kind = ModelKind::molecule;
  options.log = log;
  return build_model(structure, options);
}

/// The shaken rings of further starts are their other forms.
SampleAsked torsions_asked(std::int64_t first, std::int64_t frames, bool is_first_start,
                           const ConformerOptions& asked) {
  SampleAsked wanted;
  wanted.options.ring_systems = is_first_start;
  wanted.options.amides = asked.amides;
  wanted.options.both_hands = asked.both_hands;
  wanted.options.threads = asked.threads;
  wanted.options.sampler = conformer_sampler().name;
  wanted.options.first_frame = first;
  wanted.options.frames = frames;
  wanted.options.seed = std::uint64_t(asked.seed);
  wanted.options.log = asked.log;
  return wanted;
}

/// Signs of what relaxing must not change; nitrogen may invert, flat atoms bend to either side.
class Handedness {
 public:
  Handedness(const BondChemistry& chemistry, std::span<const Vec3> x) {
    for (Joint atom = 0; atom < x.size(); ++atom) {
      const auto bonds = chemistry.bonds_at(atom);
      if (bonds.size() < 3 || chemistry.is_nitrogen(atom) || !chemistry.is_tetrahedral(atom))
        continue;
      const Corner corner{atom, bonds[0].node, bonds[1].node, bonds[2].node};
      if (std::abs(volume(corner, x)) > least_volume) corners_.push_back(corner);
    }
    for (const Corner& corner : corners_) volumes_.push_back(volume(corner, x));
  }

  bool is_kept(std::span<const Vec3> x) const {
    for (std::size_t k = 0; k < corners_.size(); ++k)
      if (!(volume(corners_[k], x) * volumes_[k] > 0.0)) return false;
    return true;
  }

 private:
  struct Corner {
    Joint atom, a, b, c;
  };
  static double volume(const Corner& at, std::span<const Vec3> x) {
    return dot(cross(x[at.a] - x[at.atom], x[at.b] - x[at.atom]), x[at.c] - x[at.atom]);
  }
  std::vector<Corner> corners_;
  std::vector<double> volumes_;
};

/// Atoms of rings that are not flat, each with what hangs on it outside of rings.
std::vector<std::vector<Joint>> ring_parts(const BondChemistry& chemistry) {
  std::vector<std::vector<Joint>> parts;
  for (const std::vector<Bar>& bonds : chemistry.ring_blocks()) {
    std::vector<Joint> atoms;
    for (const Bar& bond : bonds) atoms.insert(atoms.end(), {bond.a, bond.b});
    std::sort(atoms.begin(), atoms.end());
    atoms.erase(std::unique(atoms.begin(), atoms.end()), atoms.end());
    if (std::none_of(atoms.begin(), atoms.end(),
                     [&](Joint atom) { return chemistry.is_tetrahedral(atom); }))
      continue;
    for (Joint atom : atoms) {
      parts.push_back(chemistry.beyond(atom, atoms));
      parts.back().push_back(atom);
    }
  }
  return parts;
}

/// Atoms of rings go up to `furthest` Angstrom from where they are.
void shake(const BondChemistry& chemistry, double furthest, RandomSequence& draws,
           std::span<Vec3> x) {
  for (const std::vector<Joint>& part : ring_parts(chemistry)) {
    const Vec3 move = (furthest * draws.uniform()) * draws.direction();
    for (Joint atom : part) x[atom] += move;
  }
}

/// A conformer of a model, its rings `bent` into one form after the other by the number of the
/// start, shaken and relaxed; corners keep their handedness, or it is empty.
std::vector<Vec3> relaxed(const MolecularModel& model, const BondChemistry& chemistry,
                          const std::vector<FlexibleRing>& bent, std::size_t number,
                          std::span<const Vec3> conformer, RandomSequence draws) {
  std::vector<Vec3> x(conformer.begin(), conformer.end());
  const Handedness hands(chemistry, x);
  for (const FlexibleRing& ring : bent)
    if (const std::size_t form = number % (ring.forms.size() + 1); form < ring.forms.size())
      take_form(ring, ring.forms[form], x);
  const Strain strain(model.framework, chemistry, model.positions, x);
  shake(chemistry, furthest_shaken, draws, x);
  relax([&](std::span<const Vec3> at, std::span<Vec3> gradient) { return strain.at(at, gradient); },
        {}, x);
  if (!hands.is_kept(x)) x.clear();
  return x;
}

/// As `model` was built from `structure`, atom by atom, at other positions.
Structure moved(const Structure& structure, std::vector<Vec3> x) {
  Structure made = structure;
  made.positions = std::move(x);
  return made;
}

}  // namespace

std::vector<MolecularModel> conformer_starts(const Structure& structure,
                                             const ConformerOptions& asked) {
  check(asked);
  const std::int64_t count = asked.starts;
  std::vector<MolecularModel> starts;
  starts.reserve(std::size_t(count));  // what refers to the first must stay valid
  starts.push_back(molecule_model(structure, asked.log));
  if (count == 1) return starts;
  const BondChemistry chemistry(starts[0].framework, starts[0].positions);
  const std::vector<FlexibleRing> bent =
      bent_rings(starts[0].framework, chemistry, starts[0].positions);
  std::vector<std::vector<Vec3>> found;
  const SampleTask task(subject_of(starts[0]), torsions_asked(0, count - 1, true, asked));
  task.run([&](const Frame& frame) {
    found.emplace_back(frame.positions.begin(), frame.positions.end());
    return false;
  });
  for (std::size_t k = 0; k < found.size(); ++k)
    for (std::uint64_t attempt = 0; attempt < tries; ++attempt) {
      const RandomSequence draws({std::uint64_t(asked.seed), Domain::start, attempt, k, 0});
      std::vector<Vec3> x = relaxed(starts[0], chemistry, bent, k, found[k], draws);
      if (x.empty()) continue;
      starts.push_back(molecule_model(moved(starts[0].structure, std::move(x)), {}));
      break;
    }
  return starts;
}

DrawnConformers draw_conformers(std::span<const MolecularModel> starts,
                                const ConformerOptions& asked) {
  DrawnConformers drawn;
  if (starts.empty()) return drawn;
  const BondChemistry chemistry(starts[0].framework, starts[0].positions);
  const ConformerEnergy energy(starts[0].framework, chemistry);
  const auto count = static_cast<std::int64_t>(starts.size());
  for (std::int64_t k = 0; k < count; ++k) {
    const std::int64_t first = asked.frames * k / count, last = asked.frames * (k + 1) / count;
    if (first == last) continue;
    const SampleTask task(subject_of(starts[k]),
                          torsions_asked(first, last - first, k == 0, asked));
    const SampleSummary summary = task.run([&](const Frame& frame) {
      drawn.positions.emplace_back(frame.positions.begin(), frame.positions.end());
      drawn.start.push_back(std::uint32_t(k));
      drawn.energies.push_back(energy.at(frame.positions));
      return false;
    });
    drawn.max_residual = std::max(drawn.max_residual, summary.max_residual);
  }
  return drawn;
}

}  // namespace pliant
