// SPDX-License-Identifier: MIT
#include "steps/twin_calls.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "pliant/base/error.hpp"
#include "settings.hpp"
#include "steps/step_reply.hpp"
#include "steps/twin.hpp"

namespace pliant::play {
namespace {

Twin& twin() {
  if (!session().twin) throw OptionError("twin: none has been begun");
  return *session().twin;
}

}  // namespace

void add_difference(Reply& reply) {
  const std::vector<Vec3>&here = session().state().positions, &there = twin().state().positions;
  std::vector<float> apart(here.size());
  double squares = 0.0;
  for (std::size_t k = 0; k < here.size(); ++k) {
    const double square = norm_squared(here[k] - there[k]);
    apart[k] = static_cast<float>(std::sqrt(square));
    squares += square;
  }
  const auto most = std::ranges::max_element(apart);
  reply.fields["apart"] = {
      {"rms", apart.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(apart.size()))},
      {"most", most == apart.end() ? 0.0f : *most},
      {"joint", most - apart.begin()}};
  reply.add("aparts", std::span<const float>(apart));
}

namespace {

Reply step_told(bool is_watched) {
  const MadeStep& step = session().last_step();
  Reply reply = is_watched ? film_of([&](const OnBar* on_bar) { return twin().step(step, on_bar); },
                                     twin().residuals())
                           : with_bars(twin().step(step, nullptr), twin().residuals());
  add_difference(reply);
  return reply;
}

}  // namespace

Reply begin_twin(const Request& request) {
  Session& open = session();
  const bool is_after_last = request.fields.value("last", false);
  const RunOptions options = open.with_ordering(with_settings(open.options(), request.fields));
  if (is_after_last) open.last_step();  // throws where there is none
  const State& start = is_after_last ? open.before_last_step() : open.state();
  open.twin = std::make_shared<Twin>(open.document().framework, start, open.options(),
                                     options.technique, open.clock());
  if (is_after_last) return step_told(request.fields.value("watched", false));
  Reply reply;
  reply.add("positions", numbers_of(twin().state().positions));
  add_difference(reply);
  return reply;
}

Reply twin_step(const Request& request) {
  return step_told(request.fields.value("watched", false));
}

Reply end_twin(const Request&) {
  session().twin.reset();
  return {};
}

}  // namespace pliant::play
