// SPDX-License-Identifier: MIT
#include "calls.hpp"

#include <algorithm>

#include "pliant/base/version.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/model/model.hpp"
#include "pliant/order/ordering.hpp"
#include "pliant/resolve/techniques.hpp"
#include "session.hpp"

namespace pliant::play {
namespace {

/// Such techniques go bar by bar, and can be watched.
bool is_ordering(std::string_view name) {
  return std::ranges::any_of(orderings(), [&](const auto& row) { return row.name == name; });
}

Json techniques_told() {
  Json rows = Json::array();
  for (const TechniqueEntry& row : techniques())
    rows.push_back({{"name", row.name},
                    {"title", row.summary},
                    {"weightings", row.has_weighting},
                    {"limits", row.knows_limits},
                    {"watched", is_ordering(row.name)},
                    {"forestsOnly", row.forests_only}});
  return rows;
}

Json models_told() {
  Json rows = Json::array({{{"name", "auto"}, {"title", "what fits the molecule"}}});
  for (const ModelEntry& row : models())
    rows.push_back({{"name", row.name}, {"title", row.summary}});
  return rows;
}

/// Frameworks of the library that stand whole.
Json examples_told() {
  Json rows = Json::array();
  for (const Example& row : examples())
    if (row.facts.whole)
      rows.push_back({{"name", row.name}, {"title", row.source}, {"kind", "graph"}});
  return rows;
}

Document graph_document(std::string title, Framework framework, std::vector<Vec3> positions) {
  AtomTable atoms;
  if (framework.atoms()) {
    atoms = *framework.atoms();
  } else {
    atoms.residues.push_back({"", 1, ' ', ""});
    for (std::size_t k = 0; k < positions.size(); ++k) {
      atoms.names.push_back(std::to_string(k));
      atoms.elements.push_back(0);
      atoms.residue_of.push_back(0);
      atoms.serials.push_back(static_cast<std::int64_t>(k) + 1);
    }
  }
  std::vector<Bond> bonds;
  for (Bar bar : framework.bars())
    bonds.push_back({std::min(bar.a, bar.b), std::max(bar.a, bar.b), BondOrigin::file, 0});
  return {std::move(title),
          "graph",
          "",
          std::move(framework),
          std::move(atoms),
          std::move(positions),
          std::move(bonds),
          {},
          {},
          {},
          {}};
}

/// `positions` x, y, z of each atom, `bonds` a, b, order of each, sorted by (a, b).
Known known_of(const Json& fields) {
  Known known;
  const auto numbers = fields.value("positions", std::vector<double>());
  for (std::size_t k = 0; k + 2 < numbers.size(); k += 3)
    known.positions.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
  const auto bonds = fields.value("bonds", std::vector<std::uint32_t>());
  for (std::size_t k = 0; k + 2 < bonds.size(); k += 3)
    known.bonds.push_back(
        {bonds[k], bonds[k + 1], BondOrigin::file, static_cast<std::uint8_t>(bonds[k + 2])});
  return known;
}

}  // namespace

Reply boot(const Request&) {
  Reply reply;
  reply.fields = {{"version", version()},
                  {"techniques", techniques_told()},
                  {"weightings", {0.5, 0.75, 1.0}},
                  {"models", models_told()},
                  {"examples", examples_told()}};
  return reply;
}

Reply open(const Request& request) {
  return begin_session(open_file(request.fields.value("name", "file"), request.bytes,
                                 request.fields.value("model", "auto"), known_of(request.fields)));
}

Reply example(const Request& request) {
  const Example& row = find_example(request.fields.value("name", ""));
  return begin_session(graph_document(std::string(row.name), row.framework, row.positions));
}

}  // namespace pliant::play
