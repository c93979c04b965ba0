// SPDX-License-Identifier: MIT
#include "pliant/record/topology_pdb.hpp"

#include <fmt/format.h>

#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/record/pdb_text.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant {

void check_topology_pdb(const AtomTable& atoms, std::span<const Vec3> positions) {
  const PdbText pdb(atoms, false);
  for (std::size_t i = 0; i < positions.size(); ++i) pdb.check_atom(i, positions[i]);
}

void write_topology_pdb(const std::filesystem::path& path, const AtomTable& atoms,
                        std::span<const Vec3> positions, std::span<const RecordedBond> bonds,
                        const TopologyPdbOptions& options) {
  if (positions.size() != atoms.size())
    throw InputError(fmt::format("{} positions for {} atoms", positions.size(), atoms.size()));
  PdbText pdb(atoms, options.hybrid36_bonds);
  pdb.add_title(options.title);
  pdb.add_atoms(positions);
  pdb.add_bonds(bonds);
  pdb.add_end();
  OutputFile file(path, options.overwrite);
  file.write(pdb.text());
  file.publish();
  pdb.cuts().tell(path_text(file.target()), options.log);
}

}  // namespace pliant
