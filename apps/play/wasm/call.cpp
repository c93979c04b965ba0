// SPDX-License-Identifier: MIT
#include "call.hpp"

#include "calls.hpp"
#include "pliant/base/choices.hpp"

namespace pliant::play {
namespace {

constexpr CallEntry table[] = {
    {"boot", boot},
    {"open", open},
    {"example", example},
    {"settings", settings},
    {"pull", pull},
    {"resolution", resolution},
    {"wander", wander},
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
    {"force_file", force_file},
    {"replay", begin_replay},
    {"replay_steps", replay_steps},
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
