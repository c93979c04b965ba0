// SPDX-License-Identifier: MIT
// Technique `froda_templates`: FRODA's own way (Wells et al., Phys. Biol. 2 (2005) S127). Each
// rigid unit is a ghost template. Templates are put where they fit their joints best, then each
// joint into the middle of where its templates have it, in turn, until they agree:
//
//   R_u, t_u = argmin sum_i w_ui |R_u s_ui + t_u - x_i|^2,   x_i = sum_u (R_u s_ui + t_u) / n_i
//
// with n_i the templates that hold joint i, and w_ui = m_i / n_i, which keeps the centre of mass.
// Neither half ever raises the sum, so it comes ever nearer, the more slowly the longer the chain;
// Anderson acceleration makes up for some of that.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// Units that have no shape, or one that their bars contradict, are taken as a template for each
/// bar. Limits and sterics are projected after the joints, as in sweeps.
std::unique_ptr<Method> make_templates(const Framework& framework, const Technique& technique,
                                       const ResolveOptions& options);

}  // namespace pliant
