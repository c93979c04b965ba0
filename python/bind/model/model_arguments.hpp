// SPDX-License-Identifier: MIT
// The keyword arguments of the model of a molecule: what of it is taken, its preparation, contacts.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bind.hpp"
#include "pliant/model/model.hpp"

namespace pliant::python {

/// What such arguments say.
struct AskedModel {
  ModelOptions options = {};
  std::string select = {};              ///< "": all atoms
  nb::object assembly = nb::none();     ///< None: as the file has it
  std::vector<std::string> given = {};  ///< names of the arguments that are not empty
};

/// One argument.
struct ModelArgument {
  const char* name;
  const char* type;   ///< "bool"
  const char* usual;  ///< the default, as Python writes it
  const char* doc;
  /// False where the value is not of the type.
  bool (*take)(AskedModel& asked, nb::handle value);
  bool ModelEntry::*use = nullptr;  ///< what a model must have to heed it; null: any model does
};

/// Those of functions that prepare a structure; those that find contacts besides; all.
std::span<const ModelArgument> preparation_arguments();
std::span<const ModelArgument> contact_arguments();
std::span<const ModelArgument> model_arguments();

/// "keep_waters: bool = False, ...", as signatures have them.
std::string argument_texts(std::span<const ModelArgument> arguments);

/// Their lines in a docstring.
std::string argument_docs(std::span<const ModelArgument> arguments);

/// Takes them from `given`, and leaves what is another argument or not of its type.
AskedModel take_arguments(std::span<const ModelArgument> arguments, nb::dict given);

/// As `structure_from`, of the assembly and atoms that are asked for.
nb::object part_from(nb::handle argument, const AskedModel& asked);

/// Throws OptionError for an argument that is not `allowed`: of a model nothing is left to choose.
void refuse_for_built_model(const AskedModel& asked, std::string_view allowed = {});

/// Throws OptionError for an argument that a model of this kind has no use for.
void refuse_unused(const AskedModel& asked, ModelKind kind);

}  // namespace pliant::python
