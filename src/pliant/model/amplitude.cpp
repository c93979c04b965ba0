// SPDX-License-Identifier: MIT
#include "pliant/model/amplitude.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <numbers>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/atoms/residue_nodes.hpp"
#include "pliant/model/ensemble_amplitude.hpp"

namespace pliant {
namespace {

constexpr std::size_t fewest_that_look_alike = 10;
constexpr std::string_view expected =
    "amplitude: expected a number above 0 (Angstrom), bfactors, or a file with models of the "
    "molecule";

[[noreturn]] void refuse_b_factors(const std::string& why) {
  throw OptionError("amplitude bfactors: " + why +
                    "; give a number (Angstrom) or a file of models");
}

[[noreturn]] void refuse_confidence() {
  throw OptionError(
      "amplitude plddt: pLDDT is a confidence, not a distance, and no law is known that converts "
      "it into one; give a number (Angstrom) or a file of models (--floppy frees residues with a "
      "pLDDT "
      "below 50)");
}

/// Nodes of residues, or all where there are none.
std::vector<std::uint32_t> atoms_that_count(const Structure& structure) {
  const ResidueNodes nodes = residue_nodes(structure);
  const bool has_residues =
      std::find(nodes.is_residue.begin(), nodes.is_residue.end(), true) != nodes.is_residue.end();
  std::vector<std::uint32_t> out;
  for (std::size_t k = 0; k < nodes.atom.size(); ++k)
    if (nodes.is_residue[k] || !has_residues) out.push_back(nodes.atom[k]);
  return out;
}

/// Confidences have one value for each residue, from above 0 to 100. Hydrogens may have been placed
/// since the file was read.
bool looks_like_confidence(const Structure& structure) {
  const ResidueAtoms residues(structure.atoms);
  const std::size_t count = structure.atoms.residues.size();
  std::size_t of_several = 0;
  for (std::size_t r = 0; r < count; ++r) {
    const float first = structure.b_factors[residues.begin(r)];
    for (std::uint32_t i = residues.begin(r); i < residues.end(r); ++i) {
      const float b = structure.b_factors[i];
      if (b != first || b <= 0.0F || b > 100.0F) return false;
    }
    of_several += residues.end(r) - residues.begin(r) > 3 ? 1 : 0;
  }
  return of_several >= fewest_that_look_alike;
}

double fluctuation_of(double b_factor) {
  return std::sqrt(3.0 * b_factor / (8.0 * std::numbers::pi * std::numbers::pi));
}

AmplitudeChoice given(double value) {
  if (!(value > 0.0)) throw OptionError(std::string(expected) + "; found " + number_text(value));
  return {value, number_text(value), "as given"};
}

}  // namespace

AmplitudeChoice b_factor_amplitude(const Structure& structure, const Log& log) {
  if (structure.b_factors.empty()) refuse_b_factors("the file has no B factors");
  const std::vector<std::uint32_t> atoms = atoms_that_count(structure);
  if (atoms.empty()) refuse_b_factors("the file has no residue");
  const auto value = [&](std::uint32_t atom) { return double(structure.b_factors[atom]); };
  double sum = 0.0, mean_b = 0.0;
  std::size_t count = 0;
  for (std::uint32_t atom : atoms) {
    if (value(atom) <= 0.0) continue;
    sum += fluctuation_of(value(atom));
    mean_b += value(atom);
    ++count;
  }
  if (count == 0) refuse_b_factors("all B factors are 0");
  const bool differ = std::any_of(atoms.begin(), atoms.end(),
                                  [&](std::uint32_t a) { return value(a) != value(atoms[0]); });
  if (!differ && atoms.size() > 1)
    refuse_b_factors("all B factors are " + number_text(value(atoms[0])));
  if (looks_like_confidence(structure))
    refuse_b_factors(
        "the B factors look like confidences (pLDDT): one value a residue, none above 100");
  if (count < atoms.size())
    log.warn(std::to_string(atoms.size() - count) +
             " residues have no B factor above 0 and are left out of the amplitude");
  log.warn(
      "the amplitude is from B factors, which contain disorder of the crystal and errors of the "
      "model as well as motion, and in which crystal packing suppresses domain motions");
  return {sum / double(count), "bfactors",
          "B factors of " + std::to_string(count) + " residues, mean " +
              number_text(mean_b / double(count), 3) + " A^2"};
}

AmplitudeChoice choose_amplitude(std::string_view text, const Structure& structure,
                                 const Log& log) {
  if (const auto number = parse_real(text)) return given(*number);
  if (text == "bfactors") return b_factor_amplitude(structure, log);
  if (text == "plddt") refuse_confidence();
  if (!is_there(path_of(text)))
    throw OptionError(std::string(expected) + "; found " + quoted(text));
  return ensemble_amplitude(path_of(text), structure, log);
}

}  // namespace pliant
