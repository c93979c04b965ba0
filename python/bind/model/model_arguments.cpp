// SPDX-License-Identifier: MIT
#include "model/model_arguments.hpp"

#include <utility>

#include "messages.hpp"
#include "model/molecular_contacts.hpp"
#include "option_fields.hpp"
#include "pliant/base/error.hpp"

namespace pliant::python {
namespace {

/// Those of contacts are about what holds, that of samples about torsions.
bool has(ModelArguments which, const ModelField& field) {
  if (field.name == "model") return which == ModelArguments::path;  // others: own defaults
  if (field.name == "free_torsions") return which == ModelArguments::all;
  return which != ModelArguments::preparation || field.use == &ModelEntry::is_prepared ||
         field.name == "floppy_below";
}

std::vector<ModelField> rows_of(ModelArguments which) {
  std::vector<ModelField> rows;
  for (const ModelField& field : model_fields())
    if (has(which, field)) rows.push_back(field);
  return rows;
}

ModelAsked usual(ModelArguments which) {
  return {.model = std::string(which == ModelArguments::path ? automatic_model : "")};
}

}  // namespace

std::string argument_texts(ModelArguments which) {
  return argument_texts(input_fields(), InputOptions()) + ", " +
         argument_texts(rows_of(which), usual(which));
}

std::string argument_docs(ModelArguments which) {
  return argument_docs(input_fields(), InputOptions()) +
         argument_docs(rows_of(which), usual(which));
}

nb::list argument_rows(ModelArguments which) {
  nb::list rows = rows_for_commands(input_fields(), InputOptions());
  rows.extend(rows_for_commands(rows_of(which), usual(which)));
  return rows;
}

AskedModel take_arguments(ModelArguments which, nb::dict given) {
  AskedModel asked{.model = usual(which)};
  const bool is_named = which == ModelArguments::preparation || !given.contains("contacts") ||
                        nb::isinstance<nb::str>(given["contacts"]) ||
                        nb::hasattr(given["contacts"], "__fspath__");
  if (!is_named) {
    if (!given["contacts"].is_none()) asked.contacts = contacts_from(given["contacts"]);
    nb::del(given["contacts"]);
  }
  take_values(input_fields(), given, asked.input, which == ModelArguments::path);
  take_values(rows_of(which), given, asked.model);
  return asked;
}

nb::object part_from(nb::handle argument, const AskedModel& asked) {
  const InputOptions &input = asked.input, usual;
  nb::dict reading;
  if (!input.assembly.empty()) reading["assembly"] = input.assembly;
  if (input.frame != usual.frame) reading["model"] = input.frame;
  if (input.max_input != usual.max_input) reading["max_input"] = input.max_input * 1'000'000;
  if (!input.distance_bonds) reading["distance_bonds"] = false;
  return nb::module_::import_("pliant.trajectory.sources")
      .attr("part_of")(argument, input.select, **reading);
}

ModelOptions options_of(AskedModel asked, ModelKind kind) {
  check(asked.model, &entry(kind), "");
  if (asked.contacts && !entry(kind).has_contacts) {
    asked.model.contacts = "given";  // for the same message
    check(asked.model, &entry(kind), "");
  }
  ModelOptions options = model_options_of(asked.model, kind, python_log());
  options.contacts = std::move(asked.contacts);
  return options;
}

void refuse_for_built_model(const AskedModel& asked, std::string_view allowed) {
  const auto refuse = [allowed](const OptionFacts& facts, bool is_given) {
    if (is_given && facts.name != allowed)
      throw OptionError(std::string(facts.name) +
                        ": goes with a Structure; a MolecularModel is prepared already");
  };
  InputOptions input;
  ModelAsked model;
  for (const auto& field : input_fields())
    refuse(field,
           option_text(field.place(places_of(asked.input))) != option_text(field.place(input)));
  for (const ModelField& field : model_fields())
    refuse(field,
           option_text(field.place(places_of(asked.model))) != option_text(field.place(model)) ||
               (field.name == "contacts" && asked.contacts));
}

}  // namespace pliant::python
