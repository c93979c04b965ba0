// SPDX-License-Identifier: MIT
#include "pliant/sample/samplers.hpp"

#include <algorithm>
#include <optional>

#include "pliant/base/choices.hpp"
#include "pliant/conformers/torsions/conformer_framework.hpp"
#include "pliant/conformers/torsions/torsion_moves.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"

namespace pliant {

/// Each is in the file of its sampler.
using MakeSampler = std::unique_ptr<Sampler>(const SamplerSetting&);
MakeSampler make_modes_sampler, make_dilute_sampler, make_turns_sampler, make_reach_sampler,
    make_pocket_sampler, make_torsions_sampler;

namespace {

constexpr SamplerEntry table[] = {
    {.name = "modes",
     .summary = "independent frames along the modes of an elastic network",
     .make = make_modes_sampler},
    {.name = "dilute",
     .summary = "the same, with each contact off with probability exp(-|E| / X)",
     .make = make_dilute_sampler},
    {.name = "turns",
     .summary = "domains turned as wholes about the links that join them",
     .make = make_turns_sampler},
    {.name = "reach",
     .summary = "modes for the first half of the frames, then wide modes, and turns",
     .make = make_reach_sampler,
     .near_sampler = "modes",
     .frames = 2 * usual_frames},
    {.name = "pocket",
     .summary = "side chains, segments and domains about one site (--around) opened or closed",
     .make = make_pocket_sampler,
     .has_place = true},
    {.name = "torsions",
     .summary = "conformers of small molecules: torsions, forms of rings, large rings closed",
     .make = make_torsions_sampler,
     .has_amplitude = false},
};

/// Of more all at once drawn, hardly any draw is free of overlaps.
constexpr std::size_t most_rotors = 64;
constexpr std::size_t most_atoms = 2000;
/// How far turns reach was measured on proteins of 130 residues and more.
constexpr std::size_t most_without_domains = 100;  // residues

/// Whether a molecule is one, and small enough for torsions to be drawn all at once.
bool is_small(const Framework& framework, std::span<const Vec3> start) {
  if (start.size() > most_atoms) return false;
  const std::optional<BodyPlan> plan = conformer_plan(framework, start);
  if (!plan) return false;
  const auto is_free = [](const PlanBody& body) { return body.parent < 0; };
  const auto bodies = plan->bodies();
  if (std::count_if(bodies.begin(), bodies.end(), is_free) > 1) return false;
  return TorsionMoves(framework, *plan, start).rotors().size() <= most_rotors;
}

std::string quoted_name(std::string_view name, std::string_view quotes) {
  return std::string(quotes).append(name).append(quotes);
}

}  // namespace

std::span<const SamplerEntry> samplers() { return table; }

const SamplerEntry& find_sampler(std::string_view name) {
  return choose(samplers(), "sampler", name);
}

const SamplerEntry& conformer_sampler() { return find_sampler("torsions"); }

std::string_view usual_sampler(const Framework& framework, std::span<const Vec3> start,
                               std::size_t residues, bool has_place) {
  if (has_place) return "pocket";
  if (residues > most_without_domains) return "reach";
  return residues == 0 && is_small(framework, start) ? conformer_sampler().name : "modes";
}

std::string usual_sampler_text(std::string_view quotes) {
  const std::string most = std::to_string(most_without_domains);
  const auto name = [&](std::string_view of) { return quoted_name(of, quotes); };
  return name("reach") + " for proteins and nucleic acids (" + name("modes") + " for up to " +
         most + "\nresidues, and up to " + std::to_string(near_block) + " frames), " +
         name(conformer_sampler().name) + " for small molecules";
}

std::string usual_frames_text(std::string_view quotes) {
  std::string text;
  for (const SamplerEntry& row : samplers())
    if (row.frames != usual_frames)
      text += std::to_string(row.frames) + " of sampler " + quoted_name(row.name, quotes) + ", ";
  return text + std::to_string(usual_frames) + " of others";
}

ConformerMoves conformer_moves(const SampleOptions& options) {
  return {.secondary_amides = options.amides,
          .ring_systems = options.ring_systems,
          .both_hands = options.both_hands};
}

}  // namespace pliant
