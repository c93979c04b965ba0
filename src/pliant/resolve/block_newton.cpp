// SPDX-License-Identifier: MIT
#include "pliant/resolve/block_newton.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "pliant/resolve/project_bar.hpp"

namespace pliant {
namespace {

/// Up to this many bars a dense factorization beats a sparse one.
constexpr std::size_t most_dense_bars = 24;
/// Beyond so many pairs of bars that share a joint, a bar, memory and time would no longer be
/// linear in the bars: hubs of thousands of bars, complete graphs. Molecules have up to about 15.
constexpr std::size_t most_couplings_a_bar = 32;
/// What is added to a pivot or a diagonal that redundancy has made vanish, relative to its size.
constexpr double regularisation = 1e-9;
constexpr double vanishing = 1e-12;

}  // namespace

/// Holds J W J^T, and solves with it.
class BlockNewton::Factor {
 public:
  virtual ~Factor() = default;
  virtual void clear() = 0;
  virtual void add(std::size_t row, std::size_t column, double value) = 0;
  /// Solves in place. False if the matrix could not be factored.
  virtual bool solve(std::vector<double>& right_hand_side) = 0;
};

/// L D L^T by columns, of the lower triangle.
class BlockNewton::DenseFactor final : public Factor {
 public:
  explicit DenseFactor(std::size_t size) : n_(size), a_(size * size, 0.0) {}

  void clear() override { std::fill(a_.begin(), a_.end(), 0.0); }
  void add(std::size_t row, std::size_t column, double value) override {
    a_[row * n_ + column] += value;
  }

  bool solve(std::vector<double>& b) override {
    factor();
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < i; ++j) b[i] -= a_[i * n_ + j] * b[j];
    for (std::size_t i = 0; i < n_; ++i) b[i] /= a_[i * n_ + i];
    for (std::size_t i = n_; i-- > 0;)
      for (std::size_t j = i + 1; j < n_; ++j) b[i] -= a_[j * n_ + i] * b[j];
    return true;
  }

 private:
  void factor() {
    for (std::size_t j = 0; j < n_; ++j) {
      const double diagonal = a_[j * n_ + j];
      double pivot = diagonal;
      for (std::size_t k = 0; k < j; ++k) pivot -= a_[j * n_ + k] * a_[j * n_ + k] * a_[k * n_ + k];
      if (!(pivot > vanishing * diagonal)) pivot = regularisation * diagonal;
      a_[j * n_ + j] = pivot;
      for (std::size_t i = j + 1; i < n_; ++i) {
        double sum = a_[i * n_ + j];
        for (std::size_t k = 0; k < j; ++k) sum -= a_[i * n_ + k] * a_[j * n_ + k] * a_[k * n_ + k];
        a_[i * n_ + j] = sum / pivot;
      }
    }
  }

  std::size_t n_;
  std::vector<double> a_;
};

/// Eigen's simplicial LDL^T; the pattern is analysed once.
class BlockNewton::SparseFactor final : public Factor {
 public:
  SparseFactor(std::size_t size, const std::vector<Coupling>& couplings) {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t k = 0; k < size; ++k) entries.emplace_back(int(k), int(k), 0.0);
    for (const Coupling& c : couplings) entries.emplace_back(int(c.row), int(c.column), 0.0);
    const auto n = static_cast<Eigen::Index>(size);
    matrix_.resize(n, n);
    matrix_.setFromTriplets(entries.begin(), entries.end());
    solver_.analyzePattern(matrix_);
  }

  void clear() override {
    std::fill(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros(), 0.0);
  }
  void add(std::size_t row, std::size_t column, double value) override {
    matrix_.coeffRef(Eigen::Index(row), Eigen::Index(column)) += value;
  }

  bool solve(std::vector<double>& b) override {
    solver_.setShift(vanishing);
    solver_.factorize(matrix_);
    if (solver_.info() != Eigen::Success || smallest_pivot() < vanishing) {
      solver_.setShift(regularisation);
      solver_.factorize(matrix_);
    }
    if (solver_.info() != Eigen::Success) return false;
    Eigen::Map<Eigen::VectorXd> rhs(b.data(), Eigen::Index(b.size()));
    rhs = solver_.solve(rhs).eval();
    return true;
  }

 private:
  double smallest_pivot() const { return solver_.vectorD().minCoeff(); }

  Eigen::SparseMatrix<double> matrix_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> solver_;
};

bool BlockNewton::can_hold(const Framework& framework, std::span<const BarIndex> bars) {
  std::vector<Joint> ends;
  for (BarIndex bar : bars) {
    ends.push_back(framework.bars()[bar].a);
    ends.push_back(framework.bars()[bar].b);
  }
  std::sort(ends.begin(), ends.end());
  std::size_t couplings = 0;
  for (std::size_t first = 0, next = 0; first < ends.size(); first = next) {
    while (next < ends.size() && ends[next] == ends[first]) couplings += next++ - first;
  }
  return couplings <= most_couplings_a_bar * bars.size();
}

BlockNewton::BlockNewton(const Framework& framework, std::vector<BarIndex> bars,
                         std::span<const double> weights, const Tolerance& tolerance)
    : bars_(std::move(bars)) {
  index_joints(framework);
  for (std::size_t k = 0; k < bars_.size(); ++k) {
    const double rest = framework.rest_lengths()[bars_[k]];
    block_bars_[k].rest = rest;
    block_bars_[k].allowed = tolerance.of(rest);
  }
  for (Joint joint : joints_) weights_.push_back(weights[joint]);
  moving_ = weights_;
  couple_bars();
  x_.resize(joints_.size());
  best_.resize(joints_.size());
  directions_.resize(bars_.size());
  errors_.resize(bars_.size());
  if (bars_.size() <= most_dense_bars) {
    factor_ = std::make_unique<DenseFactor>(bars_.size());
  } else {
    factor_ = std::make_unique<SparseFactor>(bars_.size(), couplings_);
  }
}

BlockNewton::~BlockNewton() = default;
BlockNewton::BlockNewton(BlockNewton&&) noexcept = default;

void BlockNewton::index_joints(const Framework& framework) {
  for (BarIndex bar : bars_) {
    joints_.push_back(framework.bars()[bar].a);
    joints_.push_back(framework.bars()[bar].b);
  }
  std::sort(joints_.begin(), joints_.end());
  joints_.erase(std::unique(joints_.begin(), joints_.end()), joints_.end());
  const auto place_of = [this](Joint joint) {
    return static_cast<std::uint32_t>(std::lower_bound(joints_.begin(), joints_.end(), joint) -
                                      joints_.begin());
  };
  for (BarIndex bar : bars_)
    block_bars_.push_back(
        {place_of(framework.bars()[bar].a), place_of(framework.bars()[bar].b), 0.0, 0.0});
}

void BlockNewton::couple_bars() {
  std::vector<std::vector<std::uint32_t>> at_joint(joints_.size());
  for (std::uint32_t k = 0; k < block_bars_.size(); ++k) {
    at_joint[block_bars_[k].a].push_back(k);
    at_joint[block_bars_[k].b].push_back(k);
  }
  for (std::uint32_t j = 0; j < joints_.size(); ++j)
    for (std::size_t p = 0; p < at_joint[j].size(); ++p)
      for (std::size_t q = 0; q < p; ++q) {
        const std::uint32_t row = at_joint[j][p], column = at_joint[j][q];
        const bool same_end = (block_bars_[row].a == j) == (block_bars_[column].a == j);
        couplings_.push_back({row, column, j, same_end ? 1.0 : -1.0});
      }
}

void BlockNewton::gather(std::span<const Vec3> positions, Joint entry) {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    x_[j] = positions[joints_[j]];
    moving_[j] = joints_[j] == entry ? 0.0 : weights_[j];
  }
}

/// Fills errors and directions; the largest error in units of what is allowed. Coincident joints
/// have no direction: they count as infinitely wrong, which leaves them to the sweeps.
double BlockNewton::measure_bars() {
  double worst = 0.0;
  relative_error_ = 0.0;
  for (std::size_t k = 0; k < block_bars_.size(); ++k) {
    const BlockBar& bar = block_bars_[k];
    const Vec3 delta = x_[bar.b] - x_[bar.a];
    const double squared = norm_squared(delta);
    if (!(squared >= least_squared_length)) return std::numeric_limits<double>::infinity();
    const double d = std::sqrt(squared);
    directions_[k] = (1.0 / d) * delta;
    errors_[k] = d - bar.rest;
    worst = std::max(worst, std::abs(errors_[k]) / bar.allowed);
    relative_error_ = std::max(relative_error_, std::abs(errors_[k]) / bar.rest);
  }
  return worst;
}

void BlockNewton::assemble(double damping) {
  factor_->clear();
  for (std::size_t k = 0; k < block_bars_.size(); ++k)
    factor_->add(k, k, (1.0 + damping) * (moving_[block_bars_[k].a] + moving_[block_bars_[k].b]));
  for (const Coupling& c : couplings_)
    factor_->add(c.row, c.column,
                 c.sign * moving_[c.joint] * dot(directions_[c.row], directions_[c.column]));
}

void BlockNewton::move() {
  for (std::size_t k = 0; k < block_bars_.size(); ++k) {
    const Vec3 pull = errors_[k] * directions_[k];
    x_[block_bars_[k].a] += moving_[block_bars_[k].a] * pull;
    x_[block_bars_[k].b] -= moving_[block_bars_[k].b] * pull;
  }
}

void BlockNewton::scatter(std::span<Vec3> positions) const {
  for (std::size_t j = 0; j < joints_.size(); ++j)
    if (moving_[j] > 0.0) positions[joints_[j]] = best_[j];
}

BlockNewton::Outcome BlockNewton::solve(std::span<Vec3> positions, Joint entry,
                                        std::int64_t most_iterations, std::int64_t& iterations) {
  gather(positions, entry);
  const double error = measure_bars();
  if (error <= 1.0) return Outcome::whole;
  if (!std::isfinite(error)) return Outcome::not_finite;
  best_ = x_;
  const double best = is_overbraced() ? iterate_damped(error, most_iterations, iterations)
                                      : iterate(error, most_iterations, iterations);
  scatter(positions);
  return best <= 1.0 ? Outcome::whole : Outcome::stalled;
}

/// Rings and cages of bonds have one to one and a half bars a joint; with 1-3 bars there are two
/// and more, and where centres are planar some depend on others.
bool BlockNewton::is_overbraced() const { return bars_.size() >= 2 * joints_.size(); }

double BlockNewton::iterate(double error, std::int64_t most_iterations, std::int64_t& iterations) {
  // Newton may take a step or two to come near; after that each must pay.
  constexpr int most_bad_steps = 3;
  double best = error;
  int bad_steps = 0;
  for (std::int64_t i = 0; i < most_iterations && std::isfinite(error) && best > 1.0; ++i) {
    assemble(0.0);
    if (!factor_->solve(errors_)) break;
    move();
    ++iterations;
    error = measure_bars();
    if (!(error < 0.9 * best) && ++bad_steps > most_bad_steps) break;
    if (error < best) best = error, best_ = x_;
  }
  return best;
}

/// Levenberg and Marquardt's way: a step that does not pay is taken back and tried again shorter.
/// The damping falls with the error, so that it costs no digits at the end (Yamashita, Fukushima,
/// Computing Suppl. 15 (2001) 239).
double BlockNewton::iterate_damped(double error, std::int64_t most_iterations,
                                   std::int64_t& iterations) {
  constexpr double most_damping = 1e6;
  double best = error, damping = 0.1;
  for (std::int64_t i = 0; i < most_iterations && best > 1.0 && damping < most_damping; ++i) {
    assemble(damping * std::min(1.0, relative_error_));
    if (!factor_->solve(errors_)) break;
    move();
    ++iterations;
    error = measure_bars();
    if (error < best) {
      best = error, best_ = x_;
      damping = std::max(1e-3, 0.3 * damping);
    } else {
      x_ = best_;
      measure_bars();
      damping *= 4.0;
    }
  }
  return best;
}

}  // namespace pliant
