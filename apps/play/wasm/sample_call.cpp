// SPDX-License-Identifier: MIT
#include "sample_call.hpp"

#include "pliant/base/error.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "pliant/sample/sample_fields.hpp"
#include "session.hpp"
#include "settings.hpp"

namespace pliant::play {
namespace {

constexpr std::int64_t frames_of_page = 20;

SampleAsked asked_of(const Json& fields) {
  SampleOptions options = unset_sample_options();
  options.frames = frames_of_page;
  return {with_options(sample_fields(), options, fields)};
}

}  // namespace

Reply sample_frames(const Request& request) {
  const Document& document = session().document();
  if (document.nodes.positions.size() < 2)
    throw OptionError("sample: expected a molecule of two residues or atoms that can move apart");
  const SampleTask task(
      {document.framework, document.positions, document.nodes, document.has_residues},
      asked_of(request.fields));
  Reply reply;
  reply.fields["sampler"] = task.options().sampler;
  reply.fields["frames"] = Json::array();
  task.run([&](const Frame& frame) {
    Json& frames = reply.fields["frames"];
    const std::string place = "frames." + std::to_string(frames.size()) + ".positions";
    frames.push_back({{"frame", frame.step},
                      {"residual", frame.max_residual},
                      {"limit", frame.max_limit},
                      {"overlap", frame.max_overlap},
                      {"redraws", frame.redraws}});
    reply.add(place.c_str(), numbers_of(frame.positions));
    return false;
  });
  return reply;
}

}  // namespace pliant::play
