// SPDX-License-Identifier: MIT
#include "pliant/resolve/method/shares.hpp"

namespace pliant {
namespace {

/// Shares between joints of which `far` takes the given one, unless masses or pins say otherwise.
std::pair<double, double> shared(const Framework& framework, Joint near_joint, Joint far_joint,
                                 double far, bool mass_weighted) {
  const bool near_pinned = framework.is_pinned(near_joint);
  const bool far_pinned = framework.is_pinned(far_joint);
  if (near_pinned || far_pinned)
    return {near_pinned ? 0.0 : 1.0, far_pinned ? 0.0 : (near_pinned ? 1.0 : 0.0)};
  double near = 1.0 - far;
  if (mass_weighted) {
    near *= framework.inverse_masses()[near_joint];
    far *= framework.inverse_masses()[far_joint];
  }
  return {near / (near + far), far / (near + far)};
}

}  // namespace

std::pair<double, double> shares(const Technique& technique, const OrderedBar& visit,
                                 const Framework& framework) {
  const Bar bar = framework.bars()[visit.bar];
  const Joint far_joint = visit.near == bar.a ? bar.b : bar.a;
  return shared(framework, visit.near, far_joint, visit.is_tree ? technique.weighting : 0.5,
                technique.mass_weighted);
}

std::pair<double, double> equal_shares(const Framework& framework, Joint a, Joint b,
                                       bool mass_weighted) {
  return shared(framework, a, b, 0.5, mass_weighted);
}

}  // namespace pliant
