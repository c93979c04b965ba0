// SPDX-License-Identifier: MIT
#include "options/imd_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "interrupt.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"

namespace pliant::app {
namespace {

/// Seconds; beyond it a time in nanoseconds would not fit.
constexpr double longest_timeout = 1e9;

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
  line.add_text("--imd-host", settings.host, "HOST",
                "accept clients from other machines; IMD has no passwords");
  line.add_integer("--imd-version", settings.version, 2, 3, "2 for VMD, 3 for MDAnalysis");
  line.add_flag("--imd-wait", settings.wait,
                "run only while a client is connected, and no faster than clients read");
  line.add_integer("--imd-every", settings.every, 1, std::numeric_limits<std::int64_t>::max(),
                   "send every N-th step, unless the client asks for another rate");
  line.add_real("--imd-timeout", settings.timeout, Range::positive,
                "drop a client that reads nothing for this many seconds");
  line.add_flag("--imd-kill", settings.kill, "let clients end the run (KILL)");
}

void check_imd(const CommandLine& line, ImdSettings& settings, bool has_walkers) {
  for (const char* option :
       {"--imd-host", "--imd-version", "--imd-wait", "--imd-every", "--imd-timeout", "--imd-kill"})
    if (line.was_given(option) && !settings.is_asked)
      throw OptionError(std::string(option) + ": goes with --imd");
  if (settings.is_asked && has_walkers) throw OptionError("--imd: follows one walker, not several");
}

LiveRun::LiveRun(const ImdSettings& settings, const RunOptions& run, std::size_t joint_count,
                 const Log& log)
    : settings_(settings),
      steering_(std::make_shared<Steering>(longest_step)),
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
