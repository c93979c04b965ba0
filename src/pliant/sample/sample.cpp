// SPDX-License-Identifier: MIT
#include "pliant/sample/sample.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/threads/ordered_work.hpp"
#include "pliant/base/threads/threads.hpp"
#include "pliant/conformers/torsions/conformer_framework.hpp"
#include "pliant/framework/measures/check_positions.hpp"
#include "pliant/framework/measures/limit_counts.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/sample/frame_maker.hpp"
#include "pliant/sample/network/coarse_nodes.hpp"
#include "pliant/sample/samplers.hpp"

namespace pliant {
namespace {

/// With lanes a thread makes so many at once: more fill them better, but a user waits for them all.
constexpr std::size_t first_in_lanes = 8, most_in_lanes = 64;
/// Seconds of a share: below there may be more frames in one, above there are fewer.
constexpr double short_wait = 0.25, long_wait = 1.0;
/// Shares a thread that may wait to be shown, while one that is hard to make holds them up.
constexpr std::size_t most_waiting = 4;
constexpr double start_tolerance = 1e-6;
/// Steps square distances from the centre: beyond, rounding is as large as the least inertia of a
/// body, 1e-6 Angstrom^2.
constexpr double largest_radius = 5e4;  // Angstrom

double seconds_since(std::chrono::steady_clock::time_point begun) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

/// A molecule so wide, or so far from the origin, that no frame would be whole is refused at once.
void check_extent(const Framework& framework, std::span<const Vec3> start) {
  check_positions(
      framework, start, Tolerance{FrameMaker::most_residual}, {[](Severity, std::string_view text) {
        throw InputError("the start: " + std::string(text) + "; move the molecule to the origin");
      }});
  Vec3 centre;
  for (Vec3 x : start) centre += (1.0 / double(start.size())) * x;
  for (std::size_t k = 0; k < start.size(); ++k)
    if (const double away = distance(start[k], centre); away > largest_radius)
      throw InputError("the start: " + framework.label(static_cast<Joint>(k)) + " is " +
                       number_text(away, 2) + " Angstrom from the centre: expected at most " +
                       number_text(largest_radius));
}

void check_start(const Framework& framework, std::span<const Vec3> start) {
  const Tolerance tolerance{start_tolerance, 0.0, 0.02, 0.02};
  const ResidualSummary found = measure(framework, start, tolerance);
  if (found.within) return check_extent(framework, start);
  if (found.max_relative > start_tolerance || !found.finite)
    throw InputError("the start: bar " + framework.label(framework.bars()[found.worst_bar]) +
                     " is not whole; resolve it first");
  if (found.max_overlap > tolerance.overlap)
    throw InputError("the start: joints " + framework.label(found.worst_overlap) +
                     " overlap; give such pairs their own distance");
  throw InputError("the start: a limit does not hold; give it the distance that it has");
}

class Sampling {
 public:
  Sampling(const Framework& framework, std::span<const Vec3> start, const NetworkNodes& nodes,
           const SampleOptions& options, const BodyPlan& plan)
      : start_(start),
        options_(options),
        sampler_(find_sampler(options.sampler).make({framework, plan, start, nodes, options})),
        joint_of_node_(joints_nearest_to(nodes.positions)),
        sums_(start, joint_of_node_),
        contacts_(framework.limits()) {
    makers_.resize(static_cast<std::size_t>(options.threads));
    for_each_in_threads(makers_.size(), makers_.size(), [&](std::size_t k) {
      makers_[k].maker = std::make_unique<FrameMaker>(framework, plan, *sampler_);
    });
  }

  SampleSummary run(const SampleObserver& observer) {
    next_ = options_.first_frame;
    last_ = options_.first_frame + options_.frames;
    OrderedWork<Share>(makers_.size(), most_waiting * makers_.size())
        .run([this](Share& share, std::size_t thread) { return take(share, makers_[thread]); },
             [this](Share& share, std::size_t thread) { make(share, makers_[thread]); },
             [&](Share& share) { return show(share, observer); });
    finish();
    return std::move(summary_);
  }

 private:
  std::vector<std::size_t> joints_nearest_to(std::span<const Vec3> nodes) const {
    std::vector<std::size_t> out;
    for (Vec3 node : nodes) out.push_back(nearest_joint(node));
    return out;
  }

  std::size_t nearest_joint(Vec3 node) const {
    const auto nearer = [&](Vec3 a, Vec3 b) {
      return norm_squared(a - node) < norm_squared(b - node);
    };
    return static_cast<std::size_t>(std::min_element(start_.begin(), start_.end(), nearer) -
                                    start_.begin());
  }

  /// Frames that a thread makes, one after the other.
  struct Share {
    std::int64_t first = 0;
    std::size_t count = 0;
    std::vector<MadeFrame> frames;  ///< the first `count` are of this share
  };
  struct Maker {
    std::unique_ptr<FrameMaker> maker;
    std::size_t in_lanes = first_in_lanes;
  };

  bool take(Share& share, const Maker& by) {
    if (next_ >= last_) return false;
    share.first = next_;
    share.count = share_size(by);
    if (share.frames.size() < share.count) share.frames.resize(share.count);
    next_ += static_cast<std::int64_t>(share.count);
    return true;
  }

  /// Towards the end fewer, so that all threads end at about the same time.
  std::size_t share_size(const Maker& by) const {
    if (!by.maker->has_lanes()) return 1;
    const auto left = static_cast<std::size_t>(last_ - next_);
    const std::size_t part = makers_.size() == 1 ? left : left / (2 * makers_.size());
    const std::size_t whole = part / first_in_lanes * first_in_lanes;  // no lane is empty
    return std::min({by.in_lanes, std::max(whole, first_in_lanes), left});
  }

  void make(Share& share, Maker& by) const {
    const auto frames = std::span(share.frames).first(share.count);
    if (!by.maker->has_lanes()) return by.maker->make(share.first, start_, frames[0]);
    const auto begun = std::chrono::steady_clock::now();
    by.maker->make_many(share.first, start_, frames);
    fit_lanes(seconds_since(begun), by);
  }

  /// Frames that are hard to resolve take a hundred times as long as others.
  static void fit_lanes(double seconds, Maker& by) {
    if (seconds < short_wait) by.in_lanes = std::min(2 * by.in_lanes, most_in_lanes);
    if (seconds > long_wait) by.in_lanes = std::max<std::size_t>(by.in_lanes / 2, 1);
  }

  /// False: stop.
  bool show(const Share& share, const SampleObserver& observer) {
    for (std::size_t k = 0; k < share.count && !summary_.stopped_by_caller; ++k)
      show(share.first + static_cast<std::int64_t>(k), share.frames[k], observer);
    const std::int64_t next = share.first + static_cast<std::int64_t>(share.count);
    if (options_.should_stop && options_.should_stop()) summary_.stopped_by_caller = next < last_;
    return !summary_.stopped_by_caller;
  }

  void show(std::int64_t number, const MadeFrame& made, const SampleObserver& observer) {
    note(number, made);
    if (!made.is_made || !observer) return;
    if (observer({.step = number,
                  .positions = made.positions,
                  .sweeps = made.steps,
                  .max_residual = made.max_residual,
                  .rms_residual = made.rms_residual,
                  .force = {},
                  .max_limit = made.result.max_limit,
                  .max_overlap = made.result.max_overlap,
                  .limits_off = made.limits_off,
                  .redraws = made.redraws,
                  .drawn_by = made.drawn_by}))
      summary_.stopped_by_caller = true;
  }

  void note(std::int64_t number, const MadeFrame& made) {
    summary_.cpu_seconds += made.cpu_seconds;
    summary_.mean_steps += double(made.steps);
    summary_.redrawn += made.redraws > 0 ? 1 : 0;
    if (!made.is_made) {
      ++summary_.failed;
      return;
    }
    ++summary_.frames;
    summary_.rescued += made.is_rescued ? 1 : 0;
    summary_.ligand_frames += made.drawn_by == DrawnBy::ligand ? 1 : 0;
    summary_.mean_off_target += made.off_target;
    summary_.mean_let_go += double(contacts_.off(made.limits_off));
    summary_.max_limit = std::max(summary_.max_limit, made.result.max_limit);
    summary_.max_overlap = std::max(summary_.max_overlap, made.result.max_overlap);
    summary_.max_closing = std::max(summary_.max_closing, made.result.max_closing);
    if (made.max_residual > summary_.max_residual) {
      summary_.max_residual = made.max_residual;
      summary_.worst_bar = made.worst_bar;
    }
    if (!is_near(number)) return;
    ++summary_.near_frames;
    sums_.add(made.positions, number - options_.first_frame >= near() / 2);
  }

  /// Fluctuations are those of frames around the start: of `reach` its near ones.
  bool is_near(std::int64_t number) const { return number < options_.first_frame + near(); }
  std::int64_t near() const {
    if (options_.near_frames == 0) return options_.frames;
    return std::clamp<std::int64_t>(options_.near_frames - options_.first_frame, 0,
                                    options_.frames);
  }

  void finish() {
    const auto frames = double(std::max<std::int64_t>(summary_.frames, 1));
    summary_.mean_off_target /= frames;
    summary_.mean_steps /= frames;
    summary_.mean_let_go /= frames;
    summary_.amplitude_asked =
        find_sampler(options_.sampler).has_amplitude && sampler_->has_amplitude()
            ? options_.amplitude
            : 0.0;
    summary_.rmsf = sums_.rmsf();
    summary_.rmsf_error = sums_.error();
    for (std::size_t joint : joint_of_node_)
      summary_.amplitude_reached += summary_.rmsf[joint] / double(joint_of_node_.size());
  }

  std::span<const Vec3> start_;
  const SampleOptions& options_;
  std::unique_ptr<Sampler> sampler_;
  std::vector<Maker> makers_;         ///< one a thread
  std::int64_t next_ = 0, last_ = 0;  ///< frames to be taken
  std::vector<std::size_t> joint_of_node_;
  FluctuationSums sums_;
  LimitCounter contacts_;
  SampleSummary summary_;
};

}  // namespace

SampleSummary sample(const Framework& framework, std::span<const Vec3> start, NetworkNodes nodes,
                     const SampleOptions& options, const SampleObserver& observer) {
  const auto begun = std::chrono::steady_clock::now();
  check(options);
  if (start.size() != framework.joint_count())
    throw OptionError("start: " + std::to_string(start.size()) + " positions for " +
                      std::to_string(framework.joint_count()) + " joints");
  check(nodes, framework.joint_count());
  check_start(framework, start);
  const std::optional<BodyPlan> plan =
      find_sampler(options.sampler).has_amplitude
          ? BodyPlan::make(framework)
          : conformer_plan(framework, start, conformer_moves(options));
  if (!plan) throw OptionError("sample: the framework has pinned joints, or lies in a plane");
  nodes = coarsened(std::move(nodes));
  SampleSummary summary = Sampling(framework, start, nodes, options, *plan).run(observer);
  summary.seconds = seconds_since(begun);
  return summary;
}

}  // namespace pliant
