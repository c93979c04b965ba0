// SPDX-License-Identifier: MIT
// What a path is asked for, of scripts and of the command.
#pragma once

#include "bind.hpp"
#include "model/model_arguments.hpp"
#include "pliant/path/path_options.hpp"

namespace pliant::python {

/// Options of a path, and of which part of its molecules it is.
struct AskedPath : PathOptions {
  AskedModel molecule{.model = {.model = "protein"}};
};

/// The class PathOptions, its table, and the function `path`.
void bind_path_options(nb::module_& module);

}  // namespace pliant::python
