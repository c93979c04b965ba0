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
  if (field.name == "model") return false;  // each function has its own default
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

}  // namespace

std::string argument_texts(ModelArguments which) {
  return argument_texts(input_fields(), InputOptions()) + ", " +
         argument_texts(rows_of(which), ModelAsked());
}

std::string argument_docs(ModelArguments which) {
  return argument_docs(input_fields(), InputOptions()) +
         argument_docs(rows_of(which), ModelAsked());
}

AskedModel take_arguments(ModelArguments which, nb::dict given) {
  AskedModel asked;
  const bool is_named = which == ModelArguments::preparation || !given.contains("contacts") ||
                        nb::isinstance<nb::str>(given["contacts"]) ||
                        nb::hasattr(given["contacts"], "__fspath__");
  if (!is_named) {
    if (!given["contacts"].is_none()) asked.contacts = contacts_from(given["contacts"]);
    nb::del(given["contacts"]);
  }
  take_values(input_fields(), given, asked.input);
  take_values(rows_of(which), given, asked.model);
  return asked;
}

nb::object part_from(nb::handle argument, const AskedModel& asked) {
  const nb::object assembly =
      asked.input.assembly.empty() ? nb::none() : nb::cast(asked.input.assembly);
  return nb::module_::import_("pliant._trajectory.sources")
      .attr("part_of")(argument, asked.input.select, assembly);
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
