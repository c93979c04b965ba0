// SPDX-License-Identifier: MIT
#include "sample_call.hpp"

#include "pliant/base/error.hpp"
#include "pliant/sample/sample.hpp"
#include "pliant/sample/samplers.hpp"
#include "session.hpp"

namespace pliant::play {
namespace {

SampleOptions options_of(const Json& asked, const Document& document) {
  SampleOptions options;
  options.frames = asked.value("frames", std::int64_t{20});
  options.first_frame = asked.value("first", std::int64_t{0});
  options.amplitude = asked.value("amplitude", options.amplitude);
  options.network = asked.value("network", options.network);
  options.sampler = asked.value("sampler", "auto");
  options.seed = asked.value("seed", std::uint64_t{0});
  if (options.sampler == "auto")
    options.sampler = usual_sampler(document.framework, document.positions, document.has_residues);
  return options;
}

}  // namespace

Reply sample_frames(const Request& request) {
  const Document& document = session().document();
  if (document.nodes.positions.size() < 2)
    throw OptionError("sample: expected a molecule of two residues or atoms that can move apart");
  const SampleOptions options = options_of(request.fields, document);
  Reply reply;
  reply.fields["sampler"] = options.sampler;
  reply.fields["frames"] = Json::array();
  sample(document.framework, document.positions, document.nodes, options,
         [&](const SampledFrame& frame) {
           Json& frames = reply.fields["frames"];
           const std::string place = "frames." + std::to_string(frames.size()) + ".positions";
           frames.push_back({{"frame", frame.frame},
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
