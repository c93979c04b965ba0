// SPDX-License-Identifier: MIT
#include "calls.hpp"

#include "pliant/base/elements.hpp"
#include "pliant/jobs/asked/guide_asked.hpp"
#include "pliant/jobs/asked/molecule_input.hpp"
#include "pliant/record/h5md/h5md_header.hpp"
#include "pliant/run/replay_events.hpp"
#include "pliant/run/run_fields.hpp"
#include "session.hpp"

namespace pliant::play {
namespace {

/// JSON alone would not tell 1 from 1.0.
struct Typed {
  Json operator()(std::int64_t value) const { return {"int64", value}; }
  Json operator()(double value) const { return {"float64", value}; }
  Json operator()(bool value) const { return {"bool", value}; }
  Json operator()(const std::string& value) const { return {"text", value}; }
};

std::vector<NamedParameter> of_run(const Session& session) {
  const std::vector<ForceEvent> events = session.events();
  std::vector<NamedParameter> values = parameters_of(
      options_after({}, events, session.document().framework), session.document().framework);
  for (auto& [path, value] : values)
    if (path == "run/perturb" && !events.empty()) value = std::string(events_perturbation);
  values.insert(values.end(), {{"run/ordering", std::string()}, {"run/forces", std::string()}});
  if (std::string edits = edits_text(events, session.document().framework); !edits.empty())
    values.emplace_back("run/edits", std::move(edits));
  return values;
}

/// The page has none of these options of the command: what they are where they are not given.
std::vector<NamedParameter> of_input(const Document& document, const std::string& file) {
  const bool is_graph = document.model.empty();
  BarsAsked bars;
  bars.bars = is_graph ? "bonds" : document.model;
  ModelAsked model;
  model.model = document.model;
  std::vector<NamedParameter> values{{"input/file", file}};
  const auto add = [&](std::vector<NamedParameter> more) {
    values.insert(values.end(), more.begin(), more.end());
  };
  add(option_parameters("input", input_fields(), InputOptions{}));
  add(option_parameters("input", bars_fields(), bars));
  add(option_parameters("guide", guide_fields(), GuideAsked{}));
  add(parameters_of(H5mdOptions{}, ""));
  if (!is_graph) add(option_parameters("model", model_fields(), model));
  std::erase_if(values, [](const auto& row) { return row.first == "model/free_torsions"; });
  if (document.framework.is_planar()) values.emplace_back("framework/planar", true);
  return values;
}

Json texts_of(const AtomTable& atoms) {
  Json elements = Json::array(), names = Json::array(), codes = Json::array(),
       chains = Json::array();
  for (const std::uint8_t element : atoms.elements)
    elements.push_back(element == 0 ? "" : std::string(element_symbol(element)));
  for (const Residue& residue : atoms.residues) {
    names.push_back(residue.name);
    codes.push_back(residue.insertion_code == ' ' ? "" : std::string(1, residue.insertion_code));
    chains.push_back(residue.chain);
  }
  return {{"atom_name", atoms.names},
          {"element", elements},
          {"residue_name", names},
          {"insertion_code", codes},
          {"chain", chains}};
}

Json numbers_of_atoms(const AtomTable& atoms) {
  Json residues = Json::array();
  for (const Residue& residue : atoms.residues) residues.push_back(residue.number);
  return {{"atom_serial", atoms.serials}, {"residue_number", residues}};
}

}  // namespace

Reply recorded(const Request& request) {
  const Document& document = session().document();
  const std::string file = request.fields.value("name", document.title);
  Reply reply;
  Json& rows = reply.fields["parameters"] = Json::array();
  for (const auto& more : {of_run(session()), of_input(document, file)})
    for (const auto& [path, value] : more) {
      const Json typed = std::visit(Typed{}, value);
      rows.push_back({path, typed[0], typed[1]});
    }
  reply.fields["texts"] = texts_of(document.atoms);
  reply.fields["integers"] = numbers_of_atoms(document.atoms);
  // For a file that has room for them: H5MD keeps none.
  if (document.file != nullptr && document.file->charges.size() == document.atoms.size())
    reply.fields["charges"] =
        std::vector<int>(document.file->charges.begin(), document.file->charges.end());
  reply.fields["barsOnly"] = document.framework.has_bars_only();
  std::vector<std::uint8_t> origins, orders;
  for (const Bond& bond : document.bonds) {
    origins.push_back(static_cast<std::uint8_t>(bond.origin));
    orders.push_back(bond.order);
  }
  reply.add("bondOrigins", std::span<const std::uint8_t>(origins));
  std::vector<double> masses;  // a framework keeps 1 / m alone; of a graph there are none
  if (!document.model.empty())
    for (const std::uint8_t element : document.atoms.elements)
      masses.push_back(element_mass(element));
  reply.add("mass", std::span<const double>(masses));
  reply.add("bondOrders", std::span<const std::uint8_t>(orders));
  return reply;
}

}  // namespace pliant::play
