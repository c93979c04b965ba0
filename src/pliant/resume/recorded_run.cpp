// SPDX-License-Identifier: MIT
#include "pliant/resume/recorded_run.hpp"

#include <memory>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/resume/recorded_inputs.hpp"
#include "pliant/run/run.hpp"
#include "pliant/run/run_fields.hpp"

namespace pliant {
namespace {

RunOptions options_in(const H5mdCheckpoint& from) {
  RunOptions options = run_options_from(from.parameters);
  options.replay = replay_of(from.inputs);
  options.replay_counts = from.inputs.replay_counts;
  options.guide = guide_of(from.inputs);
  if (options.guide.empty() && is_guided_run(from.parameters))
    throw InputError("the file does not hold the guide that it followed");
  check(options.guide, from.framework);
  if (Ordering ordering = ordering_of(from.inputs); !ordering.empty())
    options.technique.ordering = std::make_shared<Ordering>(std::move(ordering));
  options.steps = from.steps;
  options.began = from.began;
  check(options);
  return options;
}

}  // namespace

RunOptions run_options_from(const H5mdCheckpoint& recorded) {
  try {
    return options_in(recorded);
  } catch (const Error& error) {
    throw InputError(recorded.path.string() + ": its run cannot go on: " + error.what());
  }
}

}  // namespace pliant
