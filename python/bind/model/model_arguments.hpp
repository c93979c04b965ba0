// SPDX-License-Identifier: MIT
// The keyword arguments of the model of a molecule: rows of input_fields() and model_fields().
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bind.hpp"
#include "pliant/jobs/asked/input_options.hpp"
#include "pliant/jobs/asked/model_asked.hpp"

namespace pliant::python {

/// Which arguments a function has: of preparation, of contacts too, of samples too; of a path also
/// the model, and what commands alone say of a file.
enum class ModelArguments : std::uint8_t { preparation, contacts, all, path };

/// What such arguments say.
struct AskedModel {
  InputOptions input = {};
  ModelAsked model = {};
  std::optional<std::vector<MolecularContact>> contacts = {};  ///< given as an array
};

/// "keep_waters: bool = False, ...", as signatures have them.
std::string argument_texts(ModelArguments which);

/// Their lines in a docstring.
std::string argument_docs(ModelArguments which);

/// Rows for commands that are written in Python.
nb::list argument_rows(ModelArguments which);

/// Takes them from `given`, and leaves what is another argument. Raises as take_values().
AskedModel take_arguments(ModelArguments which, nb::dict given);

/// As `structure_from`, of the part of a file that is asked for.
nb::object part_from(nb::handle argument, const AskedModel& asked);

/// How a model of that kind is built. Throws OptionError for an argument that it has no use for.
ModelOptions options_of(AskedModel asked, ModelKind kind);

/// Throws OptionError for an argument that is not `allowed`: of a model nothing is left to choose.
void refuse_for_built_model(const AskedModel& asked, std::string_view allowed = {});

}  // namespace pliant::python
