// SPDX-License-Identifier: MIT
// From a file to motion: reads a protein, models it, pushes it 20 times. 0 if every bar was whole.
#include <algorithm>
#include <cstdio>

#include "pliant/pliant.hpp"

int main(int count, char** arguments) {
  if (count != 2) return 2;
  pliant::Structure structure = pliant::read_structure(arguments[1]);
  pliant::perceive_bonds(structure);
  const pliant::MolecularModel model = pliant::build_model(structure);
  for (const std::string& line : model.notes) std::printf("%s\n", line.c_str());

  pliant::Motion motion(model.framework, pliant::State(model.positions), {.push = {"force"}});
  double worst = 0.0;
  for (int step = 0; step < 20; ++step) worst = std::max(worst, motion.step().max_residual);
  std::printf("20 steps of %zu atoms, worst bar off by %.1e of its length\n",
              model.positions.size(), worst);
  return worst <= 1e-6 ? 0 : 1;
}
