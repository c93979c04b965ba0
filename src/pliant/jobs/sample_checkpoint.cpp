// SPDX-License-Identifier: MIT
#include "pliant/jobs/sample_checkpoint.hpp"

#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"

namespace pliant {
namespace {

SampleOptions options_of(const H5mdCheckpoint& from) {
  SampleOptions options = sample_options_from(from.parameters);
  options.first_frame = from.last_step;
  options.frames = from.began + from.steps - from.last_step;
  check(options);
  return options;
}

}  // namespace

RunInputs sample_inputs(std::span<const Vec3> start, const NetworkNodes& nodes) {
  RunInputs inputs;
  inputs.start.assign(start.begin(), start.end());
  inputs.node_positions = nodes.positions;
  inputs.node_chains = nodes.chain;
  for (const std::uint32_t node : nodes.of_joint)
    inputs.node_of_joint.push_back(node == no_node ? -1 : std::int64_t{node});
  return inputs;
}

NetworkNodes nodes_of(const RunInputs& inputs) {
  NetworkNodes nodes;
  nodes.positions = inputs.node_positions;
  nodes.chain = inputs.node_chains;
  for (const std::int64_t node : inputs.node_of_joint)
    nodes.of_joint.push_back(node < 0 ? no_node : static_cast<std::uint32_t>(node));
  return nodes;
}

SampleOptions sample_options_from(const H5mdCheckpoint& recorded) {
  try {
    return options_of(recorded);
  } catch (const Error& error) {
    throw InputError(path_text(recorded.path) + ": its sample cannot go on: " + error.what());
  }
}

SampleSummary add_frames(const H5mdCheckpoint& from, const SampleOptions& options,
                         const H5mdOptions& recording, const SampleObserver& observer) {
  H5mdRecorder recorder(from, recording);
  std::int64_t added = 0;
  const SampleTask task({from.framework, from.inputs.start, nodes_of(from.inputs)}, options);
  SampleSummary summary = task.run([&](const Frame& frame) {
    recorder.record(frame);
    if (frame.step <= from.last_step) return false;
    ++added;
    return observer && observer(frame);
  });
  recorder.close();
  summary.frames = added;
  return summary;
}

}  // namespace pliant
