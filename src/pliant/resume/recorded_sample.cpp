// SPDX-License-Identifier: MIT
#include "pliant/resume/recorded_sample.hpp"

#include <algorithm>
#include <charconv>
#include <string>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

constexpr char contact_energy_path[] = "sample/contact_energy";
constexpr char former_path[] = "sample/temperature";  // of version 0.3.0, kJ/mol

using Parameters = std::vector<NamedParameter>;

/// The value of a path below /parameters.
template <class T>
const T& recorded(const Parameters& from, const std::string& path) {
  const auto found = std::ranges::find(from, path, &NamedParameter::first);
  if (found == from.end()) throw InputError("does not say /parameters/" + path);
  const T* value = std::get_if<T>(&found->second);
  if (value == nullptr) throw InputError("/parameters/" + path + " has an invalid value");
  return *value;
}

std::uint64_t recorded_seed(const Parameters& from) {
  const auto& text = recorded<std::string>(from, "sample/seed");
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, seed);
  if (error != std::errc() || stop != end)
    throw InputError("/parameters/sample/seed has an invalid value");
  return seed;
}

SampleOptions options_of(const H5mdCheckpoint& from) {
  SampleOptions options;
  options.first_frame = from.last_step;
  options.frames = from.began + from.steps - from.last_step;
  const Parameters parameters = renewed(from.parameters);
  options.amplitude = recorded<double>(parameters, "sample/amplitude");
  options.seed = recorded_seed(parameters);
  options.network = recorded<std::string>(parameters, "sample/network");
  options.sampler = recorded<std::string>(parameters, "sample/sampler");
  options.contact_energy = recorded<double>(parameters, contact_energy_path);
  check(options);
  return options;
}

}  // namespace

std::vector<NamedParameter> parameters_of(const SampleOptions& options) {
  return {{"sample/frames", options.frames},
          {"sample/first_frame", options.first_frame},
          {"sample/amplitude", options.amplitude},
          {"sample/seed", std::to_string(options.seed)},
          {"sample/network", options.network},
          {"sample/sampler", options.sampler},
          {contact_energy_path, options.contact_energy}};
}

std::vector<NamedParameter> renewed(std::vector<NamedParameter> parameters) {
  for (auto& [path, value] : parameters) {
    if (path != former_path) continue;
    path = contact_energy_path;
    if (double* energy = std::get_if<double>(&value)) *energy /= kj_per_kcal;
  }
  return parameters;
}

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
    throw InputError(recorded.path.string() + ": its sample cannot go on: " + error.what());
  }
}

SampleSummary add_frames(const H5mdCheckpoint& from, const SampleOptions& options,
                         const H5mdOptions& recording, const SampleObserver& observer) {
  H5mdRecorder recorder(from, recording);
  std::int64_t added = 0;
  SampleSummary summary = sample(from.framework, from.inputs.start, nodes_of(from.inputs), options,
                                 [&](const SampledFrame& frame) {
                                   recorder.record(recorded_frame(frame));
                                   if (frame.frame <= from.last_step) return false;
                                   ++added;
                                   return observer(frame);
                                 });
  recorder.close();
  summary.frames = added;
  return summary;
}

Frame recorded_frame(const SampledFrame& sampled) {
  Frame frame;
  frame.step = sampled.frame;
  frame.positions = sampled.positions;
  frame.sweeps = sampled.steps;
  frame.max_residual = sampled.max_residual;
  frame.rms_residual = sampled.rms_residual;
  frame.max_limit = sampled.max_limit;
  frame.max_overlap = sampled.max_overlap;
  frame.redraws = sampled.redraws;
  frame.limits_off = sampled.limits_off;
  return frame;
}

}  // namespace pliant
