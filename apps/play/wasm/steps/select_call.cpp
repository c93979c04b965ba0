// SPDX-License-Identifier: MIT
#include "calls.hpp"

#include "pliant/molecule/selection.hpp"
#include "session.hpp"

namespace pliant::play {

Reply select_joints_of(const Request& request) {
  const auto found =
      select_atoms(session().document().atoms, request.fields.value("text", std::string()));
  const std::vector<std::int32_t> joints(found.begin(), found.end());
  Reply reply;
  reply.add("joints", std::span<const std::int32_t>(joints));
  return reply;
}

}  // namespace pliant::play
