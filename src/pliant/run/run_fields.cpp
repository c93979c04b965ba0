// SPDX-License-Identifier: MIT
#include "pliant/run/run_fields.hpp"

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/perturb/perturbation.hpp"
#include "pliant/resolve/auto.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant {
namespace {

template <auto... Members>
constexpr auto at = place_at<RunOptions, Members...>;

constexpr auto technique = &RunOptions::technique;
constexpr auto resolve = &RunOptions::resolve;
constexpr auto tolerance = &ResolveOptions::tolerance;
constexpr auto perturb = &RunOptions::perturb_options;

constexpr std::string_view run_group = "Run";
constexpr std::string_view technique_group = "Technique";
constexpr std::string_view perturbation_group = "Perturbation";

constexpr RunField table[] = {
    {{.name = "steps",
      .group = run_group,
      .summary = "number of steps",
      .range = Range::zero_or_more},
     at<&RunOptions::steps>},
    {{.name = "every",
      .group = run_group,
      .summary = "record step 0, every N-th step and the last",
      .range = Range::positive},
     at<&RunOptions::every>},
    {{.name = "seed", .group = run_group, .summary = "seed of all random numbers"},
     at<resolve, &ResolveOptions::seed>},
    {{.name = "technique",
      .group = technique_group,
      .summary = "how bars are made whole (see pliant lab techniques)",
      .choices = [] { return names_of(techniques()); },
      .kind = "technique",
      .in_python = "How bars are made whole, by name (``techniques()``); or a function (positions, "
                   "sweep,\nframework) that makes one sweep, recorded as ``custom``."},
     at<technique, &Technique::name>},
    {{.name = "weighting",
      .group = technique_group,
      .summary = "share of a correction that goes to the far end of a bar: 0 to 1",
      .range = Range::zero_to_one},
     at<technique, &Technique::weighting>},
    {{.name = "mass_weighted",
      .group = technique_group,
      .summary = "also share corrections in proportion to inverse mass"},
     at<technique, &Technique::mass_weighted>},
    {{.name = "tolerance",
      .group = technique_group,
      .summary = "largest residual of a whole bar: |length - rest length| / rest length",
      .range = Range::positive},
     at<resolve, tolerance, &Tolerance::relative>},
    {{.name = "tolerance_length",
      .group = technique_group,
      .summary = "largest residual in Angstrom, |length - rest length|; replaces tolerance",
      .range = Range::positive,
      .is_optional = true,
      .type_in_python = "float | None"},
     at<resolve, tolerance, &Tolerance::length>},
    {{.name = "tolerance_limit",
      .group = technique_group,
      .summary = "how far a distance may be outside the range of its limit, Angstrom",
      .range = Range::positive,
      .users = {.command = false}},
     at<resolve, tolerance, &Tolerance::limit>},
    {{.name = "tolerance_overlap",
      .group = technique_group,
      .summary = "how deep two joints may overlap, Angstrom",
      .range = Range::positive,
      .users = {.command = false}},
     at<resolve, tolerance, &Tolerance::overlap>},
    {{.name = "max_sweeps",
      .group = technique_group,
      .summary = "give up on a step after this many sweeps",
      .range = Range::positive},
     at<resolve, &ResolveOptions::max_sweeps>},
    {{.name = "perturb",
      .group = perturbation_group,
      .summary =
          "what breaks the bars: force, force_all or displacement (see pliant lab techniques)",
      .choices = [] { return names_of(perturbations()); },
      .kind = "perturbation"},
     at<&RunOptions::perturb>},
    {{.name = "force",
      .group = perturbation_group,
      .summary = "size of a random force, kJ/(mol Angstrom)",
      .range = Range::zero_or_more},
     at<perturb, &PerturbOptions::force>},
    {{.name = "timestep",
      .group = perturbation_group,
      .summary = "length of a step, ps",
      .range = Range::positive},
     at<perturb, &PerturbOptions::timestep>},
    {{.name = "damping",
      .group = perturbation_group,
      .summary = "fraction of its velocity that a pushed joint loses per step",
      .range = Range::zero_to_one},
     at<perturb, &PerturbOptions::damping>},
    {{.name = "displacement",
      .group = perturbation_group,
      .summary = "length of a random displacement, Angstrom",
      .range = Range::zero_or_more},
     at<perturb, &PerturbOptions::displacement>},
};

/// "rock+pull"; "": nothing guides.
std::string guided_name(const Guide& guide) {
  std::string name;
  for (const std::string& pusher : pushers_of(guide)) name += (name.empty() ? "" : "+") + pusher;
  return name;
}

/// Whether that is the name of some guide.
bool is_guided(std::string_view name) {
  for (int parts = 1; parts < 8; ++parts) {
    Guide guide;
    if (parts & 1) guide.rock.resize(1);
    if (parts & 2) guide.pulls.resize(1);
    if (parts & 4) guide.pairs.resize(1);
    if (guided_name(guide) == name) return true;
  }
  return false;
}

}  // namespace

bool is_guided_run(const std::vector<NamedParameter>& parameters) {
  const auto* name = std::get_if<std::string>(&find_parameter(parameters, "run/perturb"));
  return name != nullptr && is_guided(*name);
}

std::span<const RunField> run_fields() { return table; }

const RunField& find_run_field(std::string_view name) {
  return choose(run_fields(), "option", name);
}

void set_run_field(RunOptions& options, std::string_view name, std::string_view text) {
  const RunField& field = find_run_field(name);
  set_option(field, field.place(options), text);
}

std::string run_field_text(const RunOptions& options, const RunField& field) {
  return option_text(field.place(places_of(options)));
}

void check_fields(const RunOptions& options) {
  RunOptions& places = places_of(options);
  for (const RunField& field : run_fields()) {
    const OptionPlace place = field.place(places);
    // A technique with a sweep of its own is in no table; check(Technique) knows it.
    const bool is_custom = options.technique.sweep && place == OptionPlace(&places.technique.name);
    if (!is_custom) check_option(field, place);
  }
}

RunOptions run_options_from(const std::vector<NamedParameter>& parameters) {
  RunOptions options;
  restore_options("run", run_fields(), parameters, options);
  std::int64_t walker = 0;
  restore_option(parameters, "run/walker", &walker);
  options.resolve.walker = static_cast<std::uint64_t>(walker);
  if (options.perturb == events_perturbation)
    throw InputError("it follows a force file with events");
  if (options.perturb == "replay" || is_guided(options.perturb))
    options.perturb = RunOptions().perturb;
  return options;
}

std::vector<NamedParameter> parameters_of(const RunOptions& options, const Framework& framework) {
  std::vector<NamedParameter> values = option_parameters("run", run_fields(), options);
  const std::string pushed = replayed_steps(options) == 0 ? guided_name(options.guide) : "replay";
  if (!pushed.empty())
    for (auto& [path, value] : values)
      if (path == "run/perturb") value = pushed;
  values.emplace_back("run/technique_used", technique_used(framework, options.technique).name);
  values.emplace_back("run/walker", static_cast<std::int64_t>(options.resolve.walker));
  return values;
}

}  // namespace pliant
