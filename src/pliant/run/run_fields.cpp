// SPDX-License-Identifier: MIT
#include "pliant/run/run_fields.hpp"

#include <algorithm>
#include <charconv>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/option_text.hpp"
#include "pliant/perturb/perturbation.hpp"
#include "pliant/resolve/automatic.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant {
namespace {

/// The place that a chain of members leads to.
template <auto First, auto... Rest>
auto* follow(auto& from) {
  if constexpr (sizeof...(Rest) == 0) {
    return &(from.*First);
  } else {
    return follow<Rest...>(from.*First);
  }
}

template <auto... Members>
RunPlace at(RunOptions& options) {
  return follow<Members...>(options);
}

constexpr auto technique = &RunOptions::technique;
constexpr auto resolve = &RunOptions::resolve;
constexpr auto perturb = &RunOptions::perturb_options;

const RunField table[] = {
    {"steps", RunGroup::run, "number of steps", Range::zero_or_more, at<&RunOptions::steps>},
    {"every", RunGroup::run, "record every N-th step, and step 0", Range::positive,
     at<&RunOptions::every>},
    {"seed", RunGroup::run, "seed of all random numbers", Range::any,
     at<resolve, &ResolveOptions::seed>},
    {"technique", RunGroup::technique, "how bars are made whole (see pliant techniques)",
     Range::any, at<technique, &Technique::name>, [] { return names_of(techniques()); },
     "technique"},
    {"weighting", RunGroup::technique,
     "share of a correction that goes to the far end of a bar: 0 to 1", Range::zero_to_one,
     at<technique, &Technique::weighting>},
    {"mass_weighted", RunGroup::technique, "also share corrections in proportion to inverse mass",
     Range::any, at<technique, &Technique::mass_weighted>},
    {"tolerance", RunGroup::technique,
     "largest residual of a whole bar: |length - rest length| / rest length", Range::positive,
     at<resolve, &ResolveOptions::tolerance, &Tolerance::relative>},
    {"tolerance_length",
     RunGroup::technique,
     "largest residual in Angstrom, |length - rest length|; replaces tolerance",
     Range::positive,
     at<resolve, &ResolveOptions::tolerance, &Tolerance::length>,
     nullptr,
     {},
     true},
    {"tolerance_limit", RunGroup::technique,
     "how far a distance may be outside the range of its limit, Angstrom", Range::positive,
     at<resolve, &ResolveOptions::tolerance, &Tolerance::limit>},
    {"tolerance_overlap", RunGroup::technique, "how deep two joints may overlap, Angstrom",
     Range::positive, at<resolve, &ResolveOptions::tolerance, &Tolerance::overlap>},
    {"max_sweeps", RunGroup::technique, "give up on a step after this many sweeps", Range::positive,
     at<resolve, &ResolveOptions::max_sweeps>},
    {"perturb", RunGroup::perturbation, "what breaks the bars", Range::any,
     at<&RunOptions::perturb>, [] { return names_of(perturbations()); }, "perturbation"},
    {"force", RunGroup::perturbation, "size of a random force, kJ/(mol Angstrom)",
     Range::zero_or_more, at<perturb, &PerturbOptions::force>},
    {"timestep", RunGroup::perturbation, "length of a step, ps", Range::positive,
     at<perturb, &PerturbOptions::timestep>},
    {"damping", RunGroup::perturbation,
     "fraction of its velocity that a pushed joint loses per step", Range::zero_to_one,
     at<perturb, &PerturbOptions::damping>},
    {"displacement", RunGroup::perturbation, "length of a random displacement, Angstrom",
     Range::zero_or_more, at<perturb, &PerturbOptions::displacement>},
};

/// Checks the value at a place.
struct Check {
  const RunField& field;

  void operator()(const bool*) const {}
  void operator()(const std::uint64_t*) const {}
  void operator()(const std::int64_t* value) const { check_range(field.name, *value, field.range); }
  void operator()(const double* value) const {
    if (!(field.is_optional && *value == 0.0)) check_range(field.name, *value, field.range);
  }
  void operator()(const std::string* value) const {
    const std::vector<std::string_view> known = field.choices();
    if (std::find(known.begin(), known.end(), *value) == known.end())
      throw OptionError(unknown_choice(field.kind, *value, known));
  }
};

/// The value at a place, as files keep it.
struct Recorded {
  Parameter operator()(const std::uint64_t* value) const { return std::to_string(*value); }
  Parameter operator()(const auto* value) const { return *value; }
};

const Parameter& recorded(const std::vector<NamedParameter>& parameters, const std::string& path) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const NamedParameter& one) { return one.first == path; });
  if (found == parameters.end()) throw InputError("does not say /parameters/" + path);
  return found->second;
}

[[noreturn]] void refuse_recorded(const std::string& path) {
  throw InputError("/parameters/" + path + " has an invalid value");
}

/// Puts a recorded value into a place.
struct Restored {
  const std::string& path;
  const Parameter& value;

  void operator()(std::uint64_t* place) const {
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) refuse_recorded(path);
    const char* end = text->data() + text->size();
    if (std::from_chars(text->data(), end, *place).ptr != end) refuse_recorded(path);
  }
  template <class T>
  void operator()(T* place) const {
    if (!std::holds_alternative<T>(value)) refuse_recorded(path);
    *place = std::get<T>(value);
  }
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
  const auto* name = std::get_if<std::string>(&recorded(parameters, "run/perturb"));
  return name != nullptr && is_guided(*name);
}

std::span<const RunField> run_fields() { return table; }

const RunField& find_run_field(std::string_view name) {
  return choose(run_fields(), "option", name);
}

void set_run_field(RunOptions& options, std::string_view name, std::string_view text) {
  std::visit([&](auto* place) { set_option(name, text, *place); },
             find_run_field(name).place(options));
}

std::string run_field_text(const RunOptions& options, const RunField& field) {
  return std::visit([](const auto* value) { return option_text(*value); },
                    field.place(const_cast<RunOptions&>(options)));
}

void check_fields(const RunOptions& options) {
  // Places are only read here: a copy would take the pushes of a replay along.
  auto& places = const_cast<RunOptions&>(options);
  for (const RunField& field : run_fields()) {
    const RunPlace place = field.place(places);
    // A technique with a sweep of its own is in no table; check(Technique) knows it.
    const bool is_custom = options.technique.sweep && place == RunPlace(&places.technique.name);
    if (!is_custom) std::visit(Check{field}, place);
  }
}

RunOptions run_options_from(const std::vector<NamedParameter>& parameters) {
  RunOptions options;
  for (const RunField& field : run_fields()) {
    const std::string path = "run/" + std::string(field.name);
    std::visit(Restored{path, recorded(parameters, path)}, field.place(options));
  }
  std::int64_t walker = 0;
  Restored{"run/walker", recorded(parameters, "run/walker")}(&walker);
  options.resolve.walker = static_cast<std::uint64_t>(walker);
  if (options.perturb == events_perturbation)
    throw InputError("it follows a force file with events");
  if (options.perturb == "replay" || is_guided(options.perturb))
    options.perturb = RunOptions().perturb;
  return options;
}

std::vector<NamedParameter> parameters_of(const RunOptions& options, const Framework& framework) {
  auto& places = const_cast<RunOptions&>(options);
  std::vector<NamedParameter> values;
  for (const RunField& field : run_fields())
    values.emplace_back("run/" + std::string(field.name),
                        std::visit(Recorded{}, field.place(places)));
  const std::string pushed = replayed_steps(options) == 0 ? guided_name(options.guide) : "replay";
  if (!pushed.empty())
    for (auto& [path, value] : values)
      if (path == "run/perturb") value = pushed;
  values.emplace_back("run/technique_used", technique_used(framework, options.technique).name);
  values.emplace_back("run/walker", static_cast<std::int64_t>(options.resolve.walker));
  return values;
}

}  // namespace pliant
