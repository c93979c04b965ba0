// SPDX-License-Identifier: MIT
#include "pliant/resolve/method/shares.hpp"

namespace pliant {

std::pair<double, double> shares(const Technique& technique, const OrderedBar& visit,
                                 const Framework& framework) {
  const Bar bar = framework.bars()[visit.bar];
  const Joint far_joint = visit.near == bar.a ? bar.b : bar.a;
  const bool near_pinned = framework.is_pinned(visit.near);
  const bool far_pinned = framework.is_pinned(far_joint);
  if (near_pinned || far_pinned)
    return {near_pinned ? 0.0 : 1.0, far_pinned ? 0.0 : (near_pinned ? 1.0 : 0.0)};
  double far = visit.is_tree ? technique.weighting : 0.5;
  double near = 1.0 - far;
  if (technique.mass_weighted) {
    near *= framework.inverse_masses()[visit.near];
    far *= framework.inverse_masses()[far_joint];
  }
  return {near / (near + far), far / (near + far)};
}

}  // namespace pliant
