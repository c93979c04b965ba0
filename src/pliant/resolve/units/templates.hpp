// SPDX-License-Identifier: MIT
// Technique `froda_templates`: FRODA's own method (Wells et al., Phys. Biol. 2 (2005) S127). Each
// rigid unit is a ghost template. In turn, templates are placed where they fit their joints best,
// and each joint at the mean of its positions in its templates, until both agree:
//
//   R_u, t_u = argmin sum_i w_ui |R_u s_ui + t_u - x_i|^2,   x_i = sum_u (R_u s_ui + t_u) / n_i
//
// with the number n_i of templates of joint i, and w_ui = m_i / n_i, which keeps the centre of
// mass. Neither half raises the sum, so that it converges, the more slowly the longer the chain;
// Anderson acceleration makes up for some of that.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// A unit without a shape, or with one that its bars contradict, is replaced by a template for each
/// bar. Limits and sterics are projected after the joints, as in sweeps.
std::unique_ptr<Method> make_templates(const Framework& framework, const Technique& technique,
                                       const ResolveOptions& options);

}  // namespace pliant
