// SPDX-License-Identifier: MIT
// The open document: a molecule or a graph, with everything that a page shows of it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/framework/edits.hpp"
#include "pliant/model/model.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/path/path.hpp"
#include "pliant/rigidity/rigid_clusters.hpp"
#include "reply.hpp"

namespace pliant::play {

struct Document {
  std::string title;
  std::string kind;   ///< "molecule" or "graph"
  std::string model;  ///< a name in models(); "" for a graph
  Framework framework;
  AtomTable atoms;
  std::vector<Vec3> positions;  ///< (N) Angstrom
  std::vector<Bond> bonds;      ///< for a graph: its bars
  std::vector<bool> chain_end;  ///< (R) or none
  std::vector<MolecularContact> contacts;
  ClusterList clusters;  ///< rigid clusters of atoms; none for a graph
  std::vector<std::string> warnings;
  bool has_residues = false;  ///< of a polymer
  std::size_t coloured_clusters = 0;
  std::shared_ptr<const Structure> file = nullptr;  ///< the molecule as read; null for a graph
  std::shared_ptr<PathWalk> path = nullptr;         ///< the path being found; null if there is none
  std::optional<std::uint64_t> fingerprint = {};    ///< of the structure as read, before its model
  std::shared_ptr<const Structure> made = nullptr;  ///< that the model is of; null for a graph
};

/// Data that a program knows more exactly than a molecule file: positions with all digits, and
/// bonds.
struct Known {
  std::vector<Vec3> positions;  ///< (N) Angstrom; none: those of the file
  std::vector<Bond> bonds;      ///< replace perceived ones if there are positions
};

/// Reads a molecule file with its bonds; warnings are added to `warnings`. Throws as open_file().
Structure read_molecule(const std::string& name, std::string_view bytes, const Known& known,
                        std::vector<std::string>& warnings);

/// Makes the document of a model, called `name` if it has no title.
Document document_of(MolecularModel built, const std::string& name);

/// Reads a file, whose compression the page has undone, and builds its model: a name in models(),
/// or "auto". A graph XML file has no model. Throws as the readers and build_model(), and
/// InputError if `known` does not fit the atoms.
Document open_file(const std::string& name, std::string_view bytes, const std::string& model,
                   const Known& known = {});

/// The document with the framework after edits, the contacts that are left of its own, and the
/// rigid clusters that these and the bonds that are left make: an added bar counts as one bar, a
/// freed angle not at all.
Document after_edits(const Document& document, const EditedFramework& edited);

/// The positions as numbers: x, y, z of each.
std::span<const double> numbers_of(std::span<const Vec3> positions);

/// The reply of the call `open`, with these positions.
Reply describe(const Document& document, std::span<const Vec3> positions);

}  // namespace pliant::play
