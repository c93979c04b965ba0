// SPDX-License-Identifier: MIT
// Whether the B factors of a structure are confidences (pLDDT): by what its file says of its
// origin, else by their values.
#pragma once

#include <string>

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Whether the B factors are confidences from 0 to 100. Linear.
bool has_confidences(const Structure& structure);

/// Why the B factors are no B factors, for messages; "" if they may be.
std::string why_no_b_factors(const Structure& structure);

}  // namespace pliant
