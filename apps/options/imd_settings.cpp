// SPDX-License-Identifier: MIT
#include "options/imd_settings.hpp"

#include <fmt/format.h>

#include "interrupt.hpp"
#include "options/option_fields.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/printable.hpp"

namespace pliant::app {
namespace {

constexpr std::int64_t largest_port = 65535;

template <auto Member>
constexpr auto at = place_at<ImdSettings, Member>;

constexpr OptionField<ImdSettings> table[] = {
    {{.name = "imd_version", .summary = "2 for VMD, 3 for MDAnalysis", .least = 2, .largest = 3},
     at<&ImdSettings::version>},
    {{.name = "imd_wait",
      .summary = "run only while a client is connected, and no faster than clients read"},
     at<&ImdSettings::wait>},
};

ImdOptions options_of(const ImdSettings& settings, const RunOptions& run, const Log& log) {
  ImdOptions options;
  options.host = settings.host;
  options.port = static_cast<int>(settings.port);
  options.version = static_cast<int>(settings.version);
  options.wait = settings.wait;
  options.timestep = run.perturb_options.timestep;
  options.should_stop = interrupted;
  options.log = log;
  return options;
}

/// "8888", "0.0.0.0:8888".
void take_address(ImdSettings& settings) {
  if (settings.address.empty()) return;
  const std::string_view address = settings.address;
  const std::size_t colon = address.rfind(':');
  const auto port = parse_integer(address.substr(colon == address.npos ? 0 : colon + 1));
  if (!port || *port < 0 || *port > largest_port)
    throw OptionError("--imd: expected a port from 0 to 65535, or HOST:PORT, found " +
                      pliant::quoted(settings.address));
  settings.port = *port;
  if (colon != address.npos && colon > 0) settings.host = address.substr(0, colon);
}

}  // namespace

void add_imd_options(CommandLine& line, ImdSettings& settings) {
  line.start_group("Live, over IMD");
  line.add_optional_text(
      "--imd", settings.is_asked, settings.address, "[HOST:]PORT", "8888",
      "let VMD, MDAnalysis or pliant watch follow the run and pull; 0: any free\n"
      "port, which is printed; HOST 0.0.0.0: from other machines, too (IMD has\n"
      "no passwords)");
  for (const OptionField<ImdSettings>& field : table)
    add_option(line, field, field.place(settings));
}

void settle_imd(const CommandLine& line, ImdSettings& settings) {
  for (const OptionField<ImdSettings>& field : table) {
    const std::string option = option_name(field.name);
    if (line.was_given(option) && !settings.is_asked)
      throw OptionError(option + ": goes with --imd");
    check_option(field, field.place(settings));
  }
  take_address(settings);
}

LiveRun::LiveRun(const ImdSettings& settings, const RunOptions& run, std::size_t joint_count,
                 const Log& log)
    : settings_(settings),
      steering_(std::make_shared<Steering>(longest_live_step)),
      server_(joint_count, options_of(settings, run, log), steering_) {
  if (!server_.is_loopback())
    log.warn("--imd " + printable_name(settings.address) +
             ": IMD has no passwords: whoever reaches port " + std::to_string(server_.port()) +
             " can follow and push");
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
