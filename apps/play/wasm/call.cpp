// SPDX-License-Identifier: MIT
#include "call.hpp"

#include "edits/edit_calls.hpp"
#include "edits/why_call.hpp"
#include "open_calls.hpp"
#include "path_calls.hpp"
#include "pliant/base/choices.hpp"
#include "recorded_call.hpp"
#include "sample_call.hpp"
#include "step_calls.hpp"
#include "steps/order_calls.hpp"
#include "steps/replay_calls.hpp"
#include "steps/select_call.hpp"
#include "steps/twin_calls.hpp"

namespace pliant::play {
namespace {

constexpr CallEntry table[] = {
    {"boot", boot},
    {"open", open},
    {"example", example},
    {"structgen", structgen},
    {"settings", settings},
    {"pull", pull},
    {"resolution", resolution},
    {"wander", wander},
    {"sample", sample_frames},
    {"path", begin_path},
    {"path_steps", path_steps},
    {"again", again},
    {"undo", undo},
    {"forces", forces},
    {"state", state},
    {"recorded", recorded},
    {"edit", edit},
    {"edited", edited},
    {"pair", pair},
    {"why", why},
    {"step_limit", step_limit},
    {"twin", begin_twin},
    {"twin_step", twin_step},
    {"twin_end", end_twin},
    {"force_file", force_file},
    {"replay", begin_replay},
    {"replay_steps", replay_steps},
    {"ordering_file", ordering_file},
    {"ordering", ordering},
    {"select", select_joints_of},
};

Reply failure(std::string_view message) {
  Reply reply;
  reply.fields = {{"ok", false}, {"error", message}};
  return reply;
}

}  // namespace

std::span<const CallEntry> calls() { return table; }

Reply answer(const Request& request) noexcept {
  try {
    const std::string name = request.fields.value("do", "");
    Reply reply = choose(calls(), "call", name).answer(request);
    reply.fields["ok"] = true;
    return reply;
  } catch (const Json::exception& error) {
    return failure(std::string("request: ") + error.what());
  } catch (const std::bad_alloc&) {
    return failure("out of memory");
  } catch (const std::exception& error) {
    return failure(error.what());
  }
}

}  // namespace pliant::play
