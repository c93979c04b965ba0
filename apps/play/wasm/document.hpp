// SPDX-License-Identifier: MIT
// What is open: a molecule or a graph, with all that a page shows of it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/model/model.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/path/path.hpp"
#include "pliant/rigidity/rigid_clusters.hpp"
#include "pliant/sample/network/elastic_network.hpp"
#include "reply.hpp"

namespace pliant::play {

struct Document {
  std::string title;
  std::string kind;   ///< "molecule" or "graph"
  std::string model;  ///< a name in models(); "" of a graph
  Framework framework;
  AtomTable atoms;
  std::vector<Vec3> positions;  ///< (N) Angstrom
  std::vector<Bond> bonds;      ///< of a graph: its bars
  std::vector<bool> chain_end;  ///< (R) or none
  std::vector<MolecularContact> contacts;
  ClusterList clusters;  ///< rigid ones of atoms; none of a graph
  std::vector<std::string> warnings;
  NetworkNodes nodes = {};    ///< of an elastic network; of a graph none
  bool has_residues = false;  ///< of a polymer
  std::size_t coloured_clusters = 0;
  std::shared_ptr<const Structure> file =
      nullptr;                                    ///< the molecule as it was read; null of a graph
  std::shared_ptr<PathWalk> path = nullptr;       ///< that is being found; null: none is
  std::optional<std::uint64_t> fingerprint = {};  ///< of what was read, before its model
};

/// What a program knows better than the text of a molecule: each digit of the positions, and bonds.
struct Known {
  std::vector<Vec3> positions;  ///< (N) Angstrom; none: those of the file
  std::vector<Bond> bonds;      ///< in place of perceived ones, where there are positions
};

/// A molecule of a file, with its bonds; what is said on the way is added to `warnings`. Throws as
/// open_file().
Structure read_molecule(const std::string& name, std::string_view bytes, const Known& known,
                        std::vector<std::string>& warnings);

/// A model, to be shown. `name` where it has no title.
Document document_of(MolecularModel built, const std::string& name);

/// Reads a file, whose compression the page has undone, and builds its model: a name in models(),
/// or "auto" for the one that fits. A graph XML file has no model. Throws as the readers and
/// build_model(), and InputError if `known` is of other atoms.
Document open_file(const std::string& name, std::string_view bytes, const std::string& model,
                   const Known& known = {});

/// x, y, z of each.
std::span<const double> numbers_of(std::span<const Vec3> positions);

/// All of it, as the call `open` replies, at these positions.
Reply describe(const Document& document, std::span<const Vec3> positions);

}  // namespace pliant::play
