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
#include "pliant/model/atoms/confidence.hpp"
#include "pliant/model/atoms/residue_nodes.hpp"
#include "pliant/model/ensemble_amplitude.hpp"

namespace pliant {
namespace {

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
      "it into one; give a number (Angstrom) or a file of models (--floppy-below 50 frees residues "
      "with a pLDDT below that)");
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
  if (const std::string why = why_no_b_factors(structure); !why.empty()) refuse_b_factors(why);
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
