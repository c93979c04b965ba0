// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"

#include <algorithm>

#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/record/h5md/h5md_checkpoint.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/h5md/h5md_static.hpp"
#include "pliant/record/hdf5/hdf5_dataset.hpp"
#include "pliant/record/hdf5/hdf5_read.hpp"

namespace pliant {
namespace {

/// A state of the file, if it is complete.
struct KeptState {
  std::int64_t number = 0;
  State state;
};

class CheckpointReader {
 public:
  CheckpointReader(const std::filesystem::path& path, std::optional<std::int64_t> steps,
                   const Log& log)
      : reader_(path, {.log = log}), file_(open_hdf5(path)) {
    found_.path = path;
    found_.parameters = reader_.parameters();
    if (has_object(file_, h5md::id))
      throw InputError(
          "holds some of the molecule's atoms only (--save), so that its run cannot go on");
    if (!has_object(file_, "/parameters") || !has_object(file_, checkpoint::group) ||
        (!has_object(file_, checkpoint::state) && !has_object(file_, checkpoint::nodes)))
      throw InputError(
          "has no checkpoint, so that its run cannot go on: it was written by another program, or "
          "not by a run");
    if (reader_.frames() == 0) throw InputError("has no frame, so that its run cannot go on");
    check_series();
    read_framework();
    read_inputs();
    if (found_.is_sample())
      read_sample(steps);
    else
      read_run(steps);
  }

  H5mdCheckpoint take() { return std::move(found_); }

 private:
  std::int64_t integer(const std::string& path) const {
    for (const auto& [name, value] : found_.parameters)
      if (name == path && std::holds_alternative<std::int64_t>(value))
        return std::get<std::int64_t>(value);
    throw InputError("does not say " + path + ", so that its run cannot go on");
  }

  /// What is written to a chunk is put into its old values, which are unpacked for it.
  void check_series() const {
    for (const std::string group : {"/particles", "/observables", "/connectivity"})
      for (const std::string& path : datasets_below(file_, group))
        Hdf5Dataset(file_, group + "/" + path).check_plausible(0);
  }

  void read_run(std::optional<std::int64_t> steps) {
    read_frames(steps);
    read_state();
  }

  /// A last frame that only the end of the run made is not one of the longer run.
  void read_frames(std::optional<std::int64_t> steps) {
    every_ = std::max<std::int64_t>(1, integer("run/every"));
    planned_ = integer("run/steps");
    found_.steps = steps.value_or(planned_);
    found_.began = reader_.step(0);
    found_.frames = reader_.frames();
    last_recorded_ = found_.last_step = reader_.step(found_.frames - 1);
    const bool is_due = found_.last_step % every_ == 0 || found_.frames == 1 ||
                        found_.last_step >= found_.began + found_.steps;
    if (!is_due) found_.last_step = reader_.step(--found_.frames - 1);
  }

  void read_sample(std::optional<std::int64_t> frames) {
    found_.steps = frames.value_or(integer("sample/frames"));
    found_.began = integer("sample/first_frame");
    found_.frames = reader_.frames();
    found_.last_step = reader_.step(found_.frames - 1);
    found_.done = found_.last_step + 1 - found_.began;
  }

  void read_framework() {
    FrameworkParts parts = reader_.framework().parts();
    parts.masses = reader_.masses();
    if (has_object(file_, checkpoint::group + "/mass"))
      parts.masses = reals("/mass", parts.joint_count);
    if (has_object(file_, checkpoint::group + "/drawn"))
      parts.drawn = vectors_of(reals("/drawn", 3 * parts.joint_count));
    found_.framework = Framework(std::move(parts));
  }

  std::vector<double> reals(const std::string& name, std::size_t count) const {
    std::vector<double> values = Hdf5Dataset(file_, checkpoint::group + name).reals();
    if (values.size() != count)
      throw InputError(checkpoint::group + name + " has " + std::to_string(values.size()) +
                       " values; expected " + std::to_string(count));
    return values;
  }

  static std::vector<Vec3> vectors_of(std::span<const double> values) {
    std::vector<Vec3> vectors;
    for (std::size_t at = 0; at + 2 < values.size(); at += 3)
      vectors.push_back({values[at], values[at + 1], values[at + 2]});
    return vectors;
  }

  /// The frames that a run has recorded tell which states it had reached by then.
  bool is_reached(std::int64_t step) const {
    if (step <= last_recorded_) return true;
    const std::int64_t next_due = (last_recorded_ / every_ + 1) * every_;
    return step < std::min(next_due, found_.began + planned_);
  }

  KeptState kept(std::span<const double> row) const {
    const auto digest = checkpoint::digest_of(row);
    if (!std::equal(digest.begin(), digest.end(), row.begin() + checkpoint::digest_column))
      return {};
    const std::size_t joints = found_.framework.joint_count();
    KeptState kept{static_cast<std::int64_t>(row[checkpoint::number_column]), State()};
    kept.state.step = static_cast<std::int64_t>(row[checkpoint::step_column]);
    kept.state.time = row[checkpoint::time_column];
    kept.state.positions = vectors_of(row.subspan(checkpoint::head_columns, 3 * joints));
    kept.state.previous =
        vectors_of(row.subspan(checkpoint::head_columns + 3 * joints, 3 * joints));
    const auto off = row.subspan(checkpoint::head_columns + 6 * joints);
    if (std::any_of(off.begin(), off.end(), [](double value) { return value != 0.0; }))
      for (const double value : off) kept.state.limits_off.push_back(value != 0.0);
    return kept;
  }

  void read_state() {
    const std::size_t columns = checkpoint::columns_of(found_.framework);
    const std::vector<double> rows = reals("/state", checkpoint::state_count * columns);
    for (std::size_t k = 0; k < checkpoint::state_count; ++k) {
      KeptState one = kept(std::span(rows).subspan(k * columns, columns));
      if (one.number <= found_.number || !is_reached(one.state.step)) continue;
      found_.number = one.number;
      found_.state = std::move(one.state);
    }
    if (found_.number == 0)
      throw InputError(checkpoint::state +
                       " has no whole state: it was never written, or is damaged");
    found_.done = std::max(found_.state.step, found_.last_step) - found_.began;
  }

  template <class T>
  std::vector<T> integers(const std::string& name) const {
    std::vector<T> values;
    if (!has_object(file_, checkpoint::group + name)) return values;
    for (const std::int64_t value : Hdf5Dataset(file_, checkpoint::group + name).integers())
      values.push_back(static_cast<T>(value));
    return values;
  }

  void read_inputs() {
    RunInputs& inputs = found_.inputs;
    const auto drawn = found_.framework.drawn();
    inputs.start.assign(drawn.begin(), drawn.end());
    if (has_object(file_, checkpoint::group + "/start"))
      inputs.start = vectors_of(reals("/start", 3 * found_.framework.joint_count()));
    inputs.replay_joints = integers<Joint>("/replay_joint");
    if (!inputs.replay_joints.empty())
      inputs.replay_forces = vectors_of(reals("/replay_force", 3 * inputs.replay_joints.size()));
    inputs.replay_counts = integers<std::int64_t>("/replay_count");
    inputs.ordering_bars = integers<BarIndex>("/ordering_bar");
    inputs.ordering_near = integers<Joint>("/ordering_near");
    inputs.ordering_is_tree = integers<std::uint8_t>("/ordering_is_tree");
    if (has_object(file_, checkpoint::group + "/guide_period")) read_guide();
    if (has_object(file_, checkpoint::nodes)) read_nodes();
  }

  void read_guide() {
    RunInputs& inputs = found_.inputs;
    const auto period = integers<std::int64_t>("/guide_period");
    inputs.guide_period = period.empty() ? 0 : period.front();
    if (has_object(file_, checkpoint::group + "/rock"))
      inputs.guide_rock = vectors_of(reals("/rock", 3 * found_.framework.joint_count()));
    inputs.pull_joints = integers<Joint>("/pull_joint");
    inputs.pull_groups = integers<std::uint32_t>("/pull_group");
    if (!inputs.pull_groups.empty())
      inputs.pull_to =
          vectors_of(reals("/pull_to", 3 * (inputs.pull_groups.back() + std::size_t{1})));
    if (!has_object(file_, checkpoint::group + "/pair_group")) return;
    inputs.pair_joints = integers<Joint>("/pair_joint");
    inputs.pair_groups = integers<std::uint32_t>("/pair_group");
    const std::size_t groups = inputs.pair_groups.empty() ? 0 : inputs.pair_groups.back() + 1;
    inputs.pair_least = reals("/pair_least", groups / 2);
    inputs.pair_most = reals("/pair_most", groups / 2);
  }

  void read_nodes() {
    RunInputs& inputs = found_.inputs;
    inputs.node_chains = integers<std::uint32_t>("/node_chain");
    inputs.node_positions = vectors_of(reals("/node_position", 3 * inputs.node_chains.size()));
    inputs.node_of_joint = integers<std::int64_t>("/node_of_joint");
    const auto nodes = static_cast<std::int64_t>(inputs.node_chains.size());
    const bool are_nodes = std::ranges::all_of(
        inputs.node_of_joint, [&](std::int64_t node) { return node >= -1 && node < nodes; });
    if (nodes == 0 || !are_nodes || inputs.node_of_joint.size() != found_.framework.joint_count())
      throw InputError(checkpoint::group +
                       " has nodes that are none of its joints, so that its sample cannot go on");
  }

  H5mdReader reader_;
  Hid file_;
  std::int64_t every_ = 1, planned_ = 0, last_recorded_ = 0;
  H5mdCheckpoint found_;
};

}  // namespace

H5mdCheckpoint read_checkpoint(const std::filesystem::path& path, std::optional<std::int64_t> steps,
                               const Log& log) {
  const Hdf5Session session;
  const auto named = [&](const Error& error) {
    const std::string text = error.what(), name = path_text(path) + ": ";
    return text.starts_with(name) ? text : name + text;
  };
  try {
    return CheckpointReader(path, steps, log).take();
  } catch (const InputError& error) {
    throw InputError(named(error));
  } catch (const FileError& error) {
    throw FileError(named(error));
  }
}

}  // namespace pliant
