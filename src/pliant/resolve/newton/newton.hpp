// SPDX-License-Identifier: MIT
// Technique `newton` finds the nearest whole positions: among the positions x at which the bars of
// a part are whole those that minimise 1/2 sum_j m_j |x_j - y_j|^2, where y are the broken ones
// (projection onto the constraint manifold in the mass-weighted norm). With d, J, W of BarEquations
// and M = W^-1 the conditions are (Karush, Kuhn, Tucker)
//
//   M (x - y) + J(x)^T lambda = 0,   |d_k| = L_k
//
// and the Lagrange-Newton step (sequential quadratic programming) minimises 1/2 s^T H s + (M (x -
// y) + J^T lambda)^T s over J s = -C with H = M + sum_k lambda_k (Laplacian of bar k). s = n + t,
// where n = -W J^T (J W J^T)^-1 C restores the bars, and t, which keeps them to first order, is
// found by conjugate gradients preconditioned with the projection onto such moves (Gould, Hribar,
// Nocedal, SIAM J. Sci. Comput. 23 (2001) 1376), so that only J W J^T is ever factored.
//
// Components with many bars for each joint are restored first, by resolve/equations/bar_newton.hpp.
// The loop over components is resolve/equations/direct_method.hpp; the row of the table adds what
// planar groups need (resolve/bodies/shape_keeper.hpp). Eight walkers at once:
// resolve/lanes/lane_direct.hpp and lane_nearest_kernels.hpp.
#pragma once

#include <memory>
#include <vector>

#include "pliant/resolve/equations/direct_method.hpp"

namespace pliant {

/// Scales of moves, for the joints of the equations.
struct JointScales {
  std::vector<double> masses;   ///< u; 0 for pinned joints
  std::vector<double> allowed;  ///< Angstrom, least error allowed for any bar of the joint
};
JointScales joint_scales(const BarEquations& equations);

class NearestPoint final : public PartSolver {
 public:
  explicit NearestPoint(BarEquations& equations) : equations_(equations), newton_(equations) {}

  PartResult solve(BarEquations::Part part, std::span<const Vec3> broken, const ResolveCall& call,
                   const MayGoOn& may_go_on) override;

 private:
  using Part = BarEquations::Part;

  void reserve();
  bool iterate(Part part, const MayGoOn& may_go_on, PartResult& result);
  void slide(Part part, const MayGoOn& may_go_on, PartResult& result);
  bool try_slide(Part part, const MayGoOn& may_go_on, PartResult& result);
  bool restore(Part part, const MayGoOn& may_go_on, PartResult& result);
  void find_moves(Part part, double radius, PartResult& result);
  void polish(Part part, const BarEquations::Errors& before);

  void find_restoring_move(Part part);
  void find_multipliers(Part part);
  void find_sliding_move(Part part, double radius);
  bool is_loaded(Part part) const;
  bool search(Part part, double radius, double& squared);
  bool is_within(Part part, double step, double radius) const;
  double step_to(Part part, double radius) const;
  void project(Part part, std::span<Vec3> v);
  void add_bent(Part part, std::span<const Vec3> v, std::span<Vec3> out) const;

  double product(Part part, std::span<const Vec3> v, std::span<const Vec3> w) const;
  double distance(Part part);
  double largest(Part part, std::span<const Vec3> move) const;
  double asked(Part part, std::span<const Vec3> move);
  void clear(Part part, std::span<Vec3> v) const;
  void add(Part part, double factor, std::span<const Vec3> v, std::span<Vec3> out) const;
  void copy(Part part, std::span<const Vec3> from, std::span<Vec3> to) const;

  BarEquations& equations_;
  BarNewton newton_;
  std::span<const Vec3> broken_;
  RandomKey key_;
  std::vector<double> lambda_, bars_;                ///< of bars: the multipliers, and scratch
  std::vector<double> masses_, allowed_;             ///< of joints; 0 for pinned ones
  std::vector<Vec3> restoring_, sliding_, kept_;     ///< of joints
  std::vector<Vec3> residual_, direction_, curved_;  ///< of joints, of conjugate gradients
};

std::unique_ptr<Method> make_newton(const Framework& framework, const Technique& technique,
                                    const ResolveOptions& options);

}  // namespace pliant
