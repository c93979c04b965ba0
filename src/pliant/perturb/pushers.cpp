// SPDX-License-Identifier: MIT
#include "pliant/perturb/pushers.hpp"

#include "pliant/base/choices.hpp"
#include "pliant/perturb/guided_pushers.hpp"
#include "pliant/perturb/random_pushers.hpp"
#include "pliant/perturb/replay.hpp"

namespace pliant {
namespace {

constexpr PusherEntry table[] = {
    {"force", "a random force on one random joint, moved by Verlet (as in the thesis)", make_force},
    {"force_all", "a random force on every joint, all moved by Verlet", make_force_all},
    {"displacement", "every joint displaced in a random direction (as in FRODA)",
     make_displacement},
    {"replay", "given forces on given joints, one per step, moved by Verlet", make_replay},
    {"rock", "given vectors there and back, such as a mode of an elastic network", make_rock},
    {"pull", "groups pulled to given places, step by step", make_pull},
    {"pair_distance", "pairs of groups brought to given distances, step by step",
     make_pair_distance},
};

}  // namespace

std::span<const PusherEntry> pushers() { return table; }

const PusherEntry& find_pusher(std::string_view name) { return choose(pushers(), "pusher", name); }

}  // namespace pliant
