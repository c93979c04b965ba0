// SPDX-License-Identifier: MIT
#include "options/imd_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "interrupt.hpp"
#include "options/option_fields.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"

namespace pliant::app {
namespace {

/// Seconds; beyond it a time in nanoseconds would not fit.
constexpr double longest_timeout = 1e9;

template <auto Member>
constexpr auto at = place_at<ImdSettings, Member>;

constexpr OptionField<ImdSettings> table[] = {
    {{.name = "imd_host",
      .summary = "accept clients from other machines; IMD has no passwords",
      .kind = "HOST"},
     at<&ImdSettings::host>},
    {{.name = "imd_version", .summary = "2 for VMD, 3 for MDAnalysis", .least = 2, .largest = 3},
     at<&ImdSettings::version>},
    {{.name = "imd_wait",
      .summary = "run only while a client is connected, and no faster than clients read"},
     at<&ImdSettings::wait>},
    {{.name = "imd_every",
      .summary = "send every N-th step, unless the client asks for another rate",
      .range = Range::positive},
     at<&ImdSettings::every>},
    {{.name = "imd_timeout",
      .summary = "drop a client that reads nothing for this many seconds",
      .range = Range::positive},
     at<&ImdSettings::timeout>},
    {{.name = "imd_kill", .summary = "let clients end the run (KILL)"}, at<&ImdSettings::kill>},
};

ImdOptions options_of(const ImdSettings& settings, const RunOptions& run, const Log& log) {
  ImdOptions options;
  options.host = settings.host;
  options.port = static_cast<int>(settings.port);
  options.version = static_cast<int>(settings.version);
  options.wait = settings.wait;
  options.kill = settings.kill;
  options.patience.reading =
      std::chrono::milliseconds(std::llround(1000.0 * std::min(settings.timeout, longest_timeout)));
  options.every = settings.every;
  options.timestep = run.perturb_options.timestep;
  options.should_stop = interrupted;
  options.log = log;
  return options;
}

}  // namespace

void add_imd_options(CommandLine& line, ImdSettings& settings) {
  line.start_group("Live, over IMD");
  line.add_optional_integer("--imd", settings.is_asked, settings.port, 0, 65535, "PORT",
                            "let VMD, MDAnalysis or pliant watch follow the run and pull;\n"
                            "0: any free port, which is printed");
  for (const OptionField<ImdSettings>& field : table)
    add_option(line, field, field.place(settings));
}

void check_imd(const CommandLine& line, const ImdSettings& settings) {
  for (const OptionField<ImdSettings>& field : table) {
    const std::string option = option_name(field.name);
    if (line.was_given(option) && !settings.is_asked)
      throw OptionError(option + ": goes with --imd");
    check_option(field, field.place(places_of(settings)));
  }
}

LiveRun::LiveRun(const ImdSettings& settings, const RunOptions& run, std::size_t joint_count,
                 const Log& log)
    : settings_(settings),
      steering_(std::make_shared<Steering>(longest_live_step)),
      server_(joint_count, options_of(settings, run, log), steering_) {
  if (!server_.is_loopback())
    log.warn("--imd-host " + printable_name(settings.host) +
             ": IMD has no passwords: whoever reaches port " + std::to_string(server_.port()) +
             (settings.kill ? " can follow, push and end the run" : " can follow and push"));
}

Onlooker LiveRun::onlooker() {
  return {[this](std::int64_t step) { return server_.wants(step); },
          [this](const Frame& frame) { server_.show(frame); }};
}

void LiveRun::say_where(const std::string& topology) const {
  fmt::print(stderr, "note: IMD version {} on {}:{}{}{}\n", settings_.version,
             printable_name(settings_.host), server_.port(),
             topology == "none" ? "" : ", atoms as in " + printable_name(topology),
             settings_.wait ? "; waiting for a client" : "");
}

}  // namespace pliant::app
