// SPDX-License-Identifier: MIT
#include "pliant/run/held_pull.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "pliant/run/taut_chain.hpp"

namespace pliant {
namespace {

/// Angstrom/ps^2 of 1 kJ/(mol Angstrom) on 1 u.
constexpr double acceleration_of_unit = 100.0;
constexpr double least_bar_load = 0.1;

using HolderKind = Holder::Kind;

/// Limits of one contact are one holder; a limit without a group stands alone.
std::vector<Holder> loaded_limits(const Framework& framework, const Loads& loads) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Holder> by_contact;
  const auto limits = framework.limits();
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> largest;
  for (LimitIndex k = 0; k < limits.size(); ++k) {
    if (!(loads.limits[k] > 0.0)) continue;
    const bool is_alone = limits[k].group == no_limit_group;
    const std::pair key{limits[k].group, is_alone ? k : 0};
    Holder& one = by_contact[key];
    const double load = one.load + loads.limits[k];
    if (loads.limits[k] > largest[key]) {
      largest[key] = loads.limits[k];
      one = {HolderKind::limit, limits[k].a, limits[k].b, k};
    }
    one.load = load;
  }
  std::vector<Holder> found;
  for (const auto& [key, holder] : by_contact) found.push_back(holder);
  return found;
}

std::vector<Holder> holders_of(const Framework& framework, const Loads& loads, double least) {
  std::vector<Holder> all = loaded_limits(framework, loads);
  for (const PressedPair& pair : loads.pressed)
    all.push_back({HolderKind::pressed, pair.a, pair.b, 0, pair.load});
  for (Joint joint = 0; joint < framework.joint_count(); ++joint)
    if (loads.pins[joint] > 0.0)
      all.push_back({HolderKind::pin, joint, joint, 0, loads.pins[joint]});
  std::erase_if(all, [&](const Holder& one) { return one.load < least; });
  std::ranges::stable_sort(all, std::greater<>(), &Holder::load);
  return all;
}

bool is_among(const std::vector<Holder>& holders, const Holder& one) {
  return std::ranges::any_of(holders, [&](const Holder& other) {
    return other.kind == one.kind && other.a == one.a && other.b == one.b;
  });
}

class Asking {
 public:
  Asking(const SteeredWalk& walk, const HandPull& pull, const HeldOptions& options)
      : walk_(walk), pull_(pull), options_(options) {
    const Vec3 way = pull.target - walk.state().positions[pull.joint];
    const double length = norm(way);
    along_ = length > 0.0 ? (1.0 / length) * way : Vec3{1.0, 0.0, 0.0};
  }

  HeldPull answer() {
    HeldPull found;
    found.is_pinned = walk_.framework().is_pinned(pull_.joint);
    if (found.is_pinned) return found;
    const Loads loads = loads_of(walk_);
    found.yields = loads.yields(pull_.joint, along_);
    found.holders = holders_of(walk_.framework(), loads, options_.least_load);
    for (BarIndex k = 0; k < loads.bars.size(); ++k)
      if (std::abs(loads.bars[k]) >= least_bar_load) found.loaded.push_back(k);
    found.taut = find_taut_chain(walk_.framework(), walk_.state().positions, pull_.joint, along_);
    try_removal(found);
    const bool has_pin = std::ranges::any_of(
        found.holders, [](const Holder& one) { return one.kind == HolderKind::pin; });
    if (found.frees() && !has_pin) found.taut.reset();  // a chain at its end gets no further
    return found;
  }

 private:
  Loads loads_of(const SteeredWalk& walk) const {
    const Load pull{pull_.joint, along_};
    LoadOptions options;
    options.most_passes = 400;  // shares of a few per cent are known by then
    return find_loads(walk.framework(), walk.state().positions, {&pull, 1}, options);
  }

  /// Steps under the pull. Returns how far the joint got along it at best, or nothing if a step did
  /// not converge.
  std::optional<double> tried(SteeredWalk& walk) const {
    const double start = dot(along_, walk.state().positions[pull_.joint]);
    double best = 0.0;
    for (int k = 0; k < options_.steps; ++k) {
      const JointForce force =
          force_of(pull_, walk.framework(), walk.state(), walk.options().perturb_options);
      if (walk.pull({&force, 1}).stop != Stop::converged) return std::nullopt;
      best = std::max(best, dot(along_, walk.state().positions[pull_.joint]) - start);
    }
    return best;
  }

  /// The walk without these holders.
  std::unique_ptr<SteeredWalk> without(const std::vector<Holder>& holders) const {
    std::unique_ptr<SteeredWalk> trial = walk_.branch();
    trial->edit(cuts_of(holders));
    std::vector<Joint> pins(walk_.pinned().begin(), walk_.pinned().end());
    const std::size_t before = pins.size();
    std::erase_if(pins, [&](Joint joint) {
      return is_among(holders, {HolderKind::pin, joint, joint});
    });
    if (pins.size() != before) trial->pin(pins);
    return trial;
  }

  /// Adds what holds next as long as that brings the joint further, and it is not yet free.
  void try_removal(HeldPull& found) const {
    const auto as_it_is = tried(*walk_.branch());
    if (!as_it_is) return;
    found.as_it_is = *as_it_is;
    std::vector<Holder> named = found.holders;
    for (int round = 0; round < options_.rounds; ++round) {
      const std::unique_ptr<SteeredWalk> trial = without(named);
      const auto way = tried(*trial);
      if (!way || (round > 0 && *way < found.without + HeldPull::least_gain)) return;
      found.is_tried = true;
      found.without = *way;
      found.holders = named;
      if (*way > *as_it_is + options_.free_way || !add_next(*trial, named)) return;
    }
  }

  /// Adds what holds the trial where it is. Returns whether there was anything.
  bool add_next(const SteeredWalk& trial, std::vector<Holder>& named) const {
    bool has_more = false;
    const auto next = holders_of(trial.framework(), loads_of(trial), options_.least_load);
    for (Holder holder : next) {
      if (holder.kind == HolderKind::pressed || is_among(named, holder)) continue;
      if (holder.kind == HolderKind::limit) holder.limit = limit_at_start(holder);
      holder.is_next = has_more = true;
      named.push_back(holder);
    }
    return has_more;
  }

  /// The number of a limit in the walk's own framework.
  LimitIndex limit_at_start(const Holder& holder) const {
    const Framework& framework = walk_.framework();
    for (const LimitIndex k : framework.limits_at(holder.a))
      if (framework.limits()[k].a == holder.b || framework.limits()[k].b == holder.b) return k;
    return 0;
  }

  const SteeredWalk& walk_;
  HandPull pull_;
  HeldOptions options_;
  Vec3 along_;
};

}  // namespace

JointForce force_of(const HandPull& pull, const Framework& framework, const State& state,
                    const PerturbOptions& options) {
  const Vec3 now = state.positions[pull.joint];
  Vec3 way = pull.share * (pull.target - now);
  const double length = norm(way);
  if (length > pull.furthest) way = (pull.furthest / length) * way;
  const Vec3 effort = way - (1.0 - options.damping) * (now - state.previous[pull.joint]);
  const double inverse = framework.inverse_masses()[pull.joint];
  const double mass = inverse > 0.0 ? 1.0 / inverse : 1.0;
  return {pull.joint,
          (mass / (acceleration_of_unit * options.timestep * options.timestep)) * effort};
}

std::vector<FrameworkEdit> cuts_of(std::span<const Holder> holders) {
  std::vector<FrameworkEdit> cuts;
  for (const Holder& one : holders)
    if (one.kind == HolderKind::limit) cuts.push_back({EditKind::cut, one.a, one.b});
  return cuts;
}

HeldPull why_held(const SteeredWalk& walk, const HandPull& pull, const HeldOptions& options) {
  return Asking(walk, pull, options).answer();
}

}  // namespace pliant
