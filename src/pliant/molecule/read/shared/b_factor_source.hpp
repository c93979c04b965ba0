// SPDX-License-Identifier: MIT
// Whether the B factors of a file are B factors or confidences, by what it says of its origin.
#pragma once

#include <string>
#include <string_view>

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Sets b_factor_source by a method, where none is known yet: "X-RAY DIFFRACTION", "THEORETICAL
/// MODEL". `record` names where it stands: "EXPDTA".
void take_method(Structure& structure, std::string_view record, std::string_view method);

/// Sets it to confidence for titles of predictions, such as "ALPHAFOLD MONOMER V2.0 PREDICTION FOR
/// UBIQUITIN", unless the method is an experiment.
void take_title_of_prediction(Structure& structure);

}  // namespace pliant
