// SPDX-License-Identifier: MIT
// A molecule as jobs on bars take it: a model with bars of its own, or bars that are asked for; or
// a graph.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/jobs/asked/input_options.hpp"
#include "pliant/jobs/asked/model_asked.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/perturb/force_files/force_header.hpp"

namespace pliant {

struct BarsAsked {
  std::string bars;  ///< a name or a file; "": those of the model, or bonds without a model
  std::string pin;
};

/// The table of these options; recorded below "input".
std::span<const OptionField<BarsAsked>> bars_fields();

struct MoleculeOptions {
  InputOptions input;
  ModelAsked model;
  BarsAsked bars;
  bool may_be_cut = false;  ///< accept a molecule that a periodic box has cut, for a report
};

/// All rows of the three tables.
std::span<const OptionRow<MoleculeOptions>> molecule_rows();

struct Molecule {
  Structure structure;
  Framework framework;
  std::uint64_t fingerprint = 0;           ///< of the structure as read, before its model
  std::vector<std::string> left_out = {};  ///< by its model
  std::string model = {};                  ///< its name; "": none
};

/// What a run moves. All must outlive it.
struct RunSubject {
  const Framework& framework;
  std::span<const Vec3> start;                    ///< (N) Angstrom
  const Structure* structure = nullptr;           ///< null: nothing is known of its atoms
  std::optional<std::uint64_t> fingerprint = {};  ///< of the structure as read, before its model
  std::string model = {};                         ///< its name; "": none
  bool is_given = false;                          ///< as a framework, which no option made

  bool is_graph() const { return structure == nullptr || structure->format == "graph"; }
};

RunSubject subject_of(const Molecule& molecule);

/// The name or file of the bars: "bonds" by default, or the name of the model.
std::string bars_of(const MoleculeOptions& options);

/// Whether the file is a graph XML file, by its name.
bool is_graph(const MoleculeOptions& options);

/// Reads the file and builds the framework. Throws OptionError for options that exclude each other,
/// and as read_input(), build_model(), build_framework() and parse_graph_xml() do.
Molecule load_molecule(const MoleculeOptions& options, const Log& log);

/// The files that are read; "" for none.
std::vector<std::string> inputs_of(const MoleculeOptions& options);

/// The header of a force file for it: options that are not as usual.
ForceHeader force_header_of(const MoleculeOptions& options, const RunSubject& subject);

}  // namespace pliant
