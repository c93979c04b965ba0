// SPDX-License-Identifier: MIT
// Small molecules for tests of samples.
#pragma once

#include <string>

#include "pliant/model/model.hpp"
#include "support/molecules.hpp"

namespace pliant::test {

/// The model of a file of data/molecules.
inline MolecularModel model_of(const std::string& file) {
  const Structure structure = bonded(molecule_file(file));
  return build_model(structure, {.kind = usual_model(structure)});
}

/// A peptide with contacts across its ring that sampler `dilute` may turn off, each at its end.
inline MolecularModel held_peptide() {
  MolecularModel model = model_of("cyclic_hexapeptide.pdb");
  FrameworkParts parts = model.framework.parts();
  for (Joint a = 0; a < 24; a += 3) {
    const Joint b = a + 30;
    const double apart = distance(model.positions[a], model.positions[b]);
    parts.limits.push_back(
        {.a = a, .b = b, .most = apart + 0.01, .energy = -1.0 - double(a), .group = 900 + a});
  }
  model.framework = Framework(std::move(parts));
  return model;
}

}  // namespace pliant::test
