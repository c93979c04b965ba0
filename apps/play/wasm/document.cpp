// SPDX-License-Identifier: MIT
#include "document.hpp"

#include <algorithm>
#include <utility>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/framework/fingerprint.hpp"
#include "pliant/model/model.hpp"
#include "pliant/model/rigidity/dilution_picture.hpp"
#include "pliant/model/rigidity/rigidity.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/read/read.hpp"
#include "pliant/record/xml/graph_xml.hpp"
#include "pliant/text/compression.hpp"

namespace pliant::play {
namespace {

bool ends_with_xml(std::string_view name) {
  return name.size() > 4 && name.substr(name.size() - 4) == ".xml";
}

/// The text of a compressed file: a build without zlib and its like says that it cannot.
std::string expanded(const std::string& name, std::string_view bytes) {
  const Compression* compression = compression_of(bytes);
  return compression ? expand(*compression, bytes, name, usual_text) : std::string(bytes);
}

Document open_graph(const SourceText& source, const Log& log) {
  GraphFile graph = parse_graph_xml(source, log);
  std::vector<Bond> bonds;
  for (Bar bar : graph.framework.bars())
    bonds.push_back({std::min(bar.a, bar.b), std::max(bar.a, bar.b), BondOrigin::file, 0});
  AtomTable atoms = *graph.framework.atoms();
  return {std::string(source.name),
          "graph",
          "",
          std::move(graph.framework),
          std::move(atoms),
          std::move(graph.positions),
          std::move(bonds),
          {},
          {},
          {},
          {}};
}

ModelKind kind_of(const std::string& model, const Structure& structure) {
  if (model == "auto") return usual_model(structure);
  return choose(models(), "model", model).kind;
}

void put_known(Structure& read, const Known& known) {
  if (known.positions.size() != read.size())
    throw InputError(read.source + ": has " + std::to_string(read.size()) + " atoms, positions " +
                     std::to_string(known.positions.size()));
  for (const Bond& bond : known.bonds)
    if (bond.a >= bond.b || bond.b >= read.size())
      throw InputError(read.source + ": bond of atoms " + std::to_string(bond.a) + " and " +
                       std::to_string(bond.b) + " of " + std::to_string(read.size()));
  read.positions = known.positions;
  read.bonds = known.bonds;
}

Structure read_bonded(const SourceText& source, const Known& known, const Log& log) {
  ReadOptions reading;
  reading.log = log;
  Structure read = read_structure(source, reading);
  if (!known.positions.empty()) {
    put_known(read, known);
    return read;
  }
  BondOptions bonding;
  bonding.log = log;
  perceive_bonds(read, bonding);
  return read;
}

Log log_into(std::vector<std::string>& warnings) {
  return {[&warnings](Severity severity, std::string_view text) {
    if (severity == Severity::warning) warnings.emplace_back(text);
  }};
}

Document open_molecule(const std::string& name, std::string_view bytes, const std::string& model,
                       const Known& known, std::vector<std::string>& warnings) {
  auto read = std::make_shared<const Structure>(read_molecule(name, bytes, known, warnings));
  ModelOptions options;
  options.kind = kind_of(model, *read);
  options.log = log_into(warnings);
  Document document = document_of(build_model(*read, options), name);
  document.fingerprint = fingerprint(read->atoms, read->positions);
  document.file = std::move(read);
  return document;
}

Document open_graph_file(const std::string& name, std::string_view bytes,
                         std::vector<std::string>& warnings) {
  const std::string text = expanded(name, bytes);
  Document document = open_graph({name, without_byte_order_mark(text)}, log_into(warnings));
  document.fingerprint = fingerprint(document.atoms, document.positions);
  return document;
}

}  // namespace

Structure read_molecule(const std::string& name, std::string_view bytes, const Known& known,
                        std::vector<std::string>& warnings) {
  const std::string text = expanded(name, bytes);
  return read_bonded({name, without_byte_order_mark(text)}, known, log_into(warnings));
}

Document document_of(MolecularModel built, const std::string& name) {
  Structure& made = built.structure;
  auto kept = std::make_shared<const Structure>(made);
  const Rigidity rigidity = analyse_rigidity(made, built.contacts);
  const bool has_residues = usual_model(made) == ModelKind::protein;
  const std::size_t coloured = coloured_clusters(made, rigidity.found.clusters);
  Document document{made.title.empty() ? name : made.title,
                    "molecule",
                    std::string(entry(built.kind).name),
                    std::move(built.framework),
                    std::move(made.atoms),
                    std::move(built.positions),
                    std::move(made.bonds),
                    std::move(made.chain_end),
                    std::move(built.contacts),
                    rigidity.found.clusters,
                    {},
                    has_residues,
                    coloured};
  document.made = std::move(kept);
  return document;
}

Document open_file(const std::string& name, std::string_view bytes, const std::string& model,
                   const Known& known) {
  std::vector<std::string> warnings;
  Document document = ends_with_xml(name) ? open_graph_file(name, bytes, warnings)
                                          : open_molecule(name, bytes, model, known, warnings);
  document.warnings = std::move(warnings);
  return document;
}

}  // namespace pliant::play
