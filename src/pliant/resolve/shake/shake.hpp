// SPDX-License-Identifier: MIT
// Technique `shake`: the result of SHAKE, LINCS and CCMA. Joints move along the directions of the
// bars in a reference structure, by inverse mass:
//
//   |x_b - x_a| = L_k,   x = y - W sum_k lambda_k d_k(reference)
//
// (Ryckaert, Ciccotti, Berendsen, J. Comput. Phys. 23 (1977) 327; CCMA: Eastman, Pande, J. Chem.
// Theory Comput. 6 (2010) 434), where y are the broken positions. Without a reference, directions
// are those of the broken bars, as in OpenMM's Context::applyConstraints.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

std::unique_ptr<Method> make_shake(const Framework& framework, const Technique& technique,
                                   const ResolveOptions& options);

}  // namespace pliant
