// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/local_steps.hpp"

#include "pliant/base/random.hpp"
#include "pliant/resolve/bodies/froda.hpp"
#include "pliant/resolve/bodies/region/local_solver.hpp"
#include "pliant/resolve/bodies/units.hpp"
#include "pliant/resolve/method/moved_joints.hpp"

namespace pliant {
namespace {

/// More joints than these are not few.
constexpr std::size_t most_pushed = 32;
/// Bodies of regions, each tried if the one before does not let pushed joints follow.
constexpr std::size_t sizes[] = {18, 72, 288};
/// Pushed joints of `units` are pulled this much more strongly than others: then they follow as far
/// as in the pass over all units, which places theirs first.
constexpr double weight_of_units = 12.0;
/// Joints that follow less than this share of a push, for each unit of their weight, are held back:
/// of random pushes on a protein one in some hundreds is in the smallest region.
constexpr double least_followed = 0.05 / 12.0;
/// Where more joints than these are all stretched out, no region can follow a push and the whole
/// would have to: one in so many pushes is tried in the next larger region and, after the largest,
/// in the whole. The others stay as they are in the region, or are taken back.
constexpr std::size_t most_joints_to_try = 5000;
constexpr std::uint64_t one_in = 8;

/// As quick as a whole as in regions, or quicker.
constexpr std::size_t most_joints_as_a_whole = 200;

using MakeMethod = std::unique_ptr<Method> (*)(const Framework&, const Technique&,
                                               const ResolveOptions&);

class LocalSteps final : public Method {
 public:
  LocalSteps(const Framework& framework, const Technique& technique, const ResolveOptions& options,
             double weight, MakeMethod make_whole)
      : framework_(framework),
        technique_(technique),
        options_(options),
        weight_(weight),
        make_whole_(make_whole) {}

  bool looks_near() const override {
    return framework_.joint_count() > most_joints_as_a_whole && !framework_.has_pinned_joints() &&
           !framework_.is_planar() && !technique_.mass_weighted;
  }

  void prepare_near() override {
    if (!solver_)
      solver_ = std::make_unique<LocalSolver>(framework_, options_.tolerance,
                                              LocalOptions{.weight = weight_});
  }

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    if (call.moved == nullptr) return whole().resolve(call, summary);
    if (is_small(call) && resolve_near(call, summary)) return Stop::converged;
    call.moved->note_all(call.positions);
    return whole().resolve(call, summary);
  }

 private:
  enum class Outcome { followed, held_back, not_whole };

  Method& whole() {
    if (!whole_) whole_ = make_whole_(framework_, technique_, options_);
    return *whole_;
  }

  static bool is_small(const ResolveCall& call) {
    return !call.reference.empty() && !call.disturbed.joints.empty() &&
           call.disturbed.joints.size() <= most_pushed;
  }

  /// False, with all joints where they were, if the whole framework has to be resolved.
  bool resolve_near(const ResolveCall& call, ResolveSummary& summary) {
    prepare_near();
    if (framework_.drawn().empty() && solver_->has_loops()) return false;  // rings have no shape
    for (std::size_t size : sizes) {
      const Outcome outcome = try_region(call, size, summary);
      if (outcome == Outcome::followed) return write(call);
      if (may_try_larger(call, size)) continue;
      return outcome == Outcome::held_back ? write(call) : take_back(call);
    }
    return false;
  }

  Outcome try_region(const ResolveCall& call, std::size_t size, ResolveSummary& summary) {
    const LocalResult result =
        solver_->resolve({call.reference, call.positions, call.disturbed.joints, call.key.step,
                          call.limits_off, call.neighbours},
                         size);
    ++summary.sweeps;
    summary.projections += result.visits;
    if (!result.is_whole) return Outcome::not_whole;
    const bool follows = result.followed >= least_followed * weight_ || solver_->was_free();
    return follows ? Outcome::followed : Outcome::held_back;
  }

  bool may_try_larger(const ResolveCall& call, std::size_t size) const {
    if (framework_.joint_count() <= most_joints_to_try) return true;
    RandomKey key = call.key;
    key.domain = Domain::region;
    key.joint = size;
    return RandomSequence(key).below(one_in) == 0;
  }

  bool write(const ResolveCall& call) const {
    solver_->visit_moved([&](Joint joint, Vec3 x) {
      call.moved->note(joint, call.positions[joint]);
      call.positions[joint] = x;
    });
    return true;
  }

  static bool take_back(const ResolveCall& call) {
    for (Joint joint : call.disturbed.joints) {
      call.moved->note(joint, call.positions[joint]);
      call.positions[joint] = call.reference[joint];
    }
    return true;
  }

  const Framework& framework_;
  Technique technique_;
  ResolveOptions options_;
  double weight_;
  MakeMethod make_whole_;
  std::unique_ptr<Method> whole_;
  std::unique_ptr<LocalSolver> solver_;
};

}  // namespace

std::unique_ptr<Method> make_local_units(const Framework& framework, const Technique& technique,
                                         const ResolveOptions& options) {
  return std::make_unique<LocalSteps>(framework, technique, options, weight_of_units, make_units);
}

std::unique_ptr<Method> make_local_froda(const Framework& framework, const Technique& technique,
                                         const ResolveOptions& options) {
  return std::make_unique<LocalSteps>(framework, technique, options, 1.0, make_froda);
}

}  // namespace pliant
