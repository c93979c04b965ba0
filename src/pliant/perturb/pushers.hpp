// SPDX-License-Identifier: MIT
// The table of pushers, by name.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "pliant/perturb/pusher.hpp"

namespace pliant {

/// One row of the table of pushers.
struct PusherEntry {
  std::string_view name;
  std::string_view summary;
  /// The framework must outlive the pusher. Throws OptionError for bad options.
  std::unique_ptr<Pusher> (*make)(const Framework& framework, const PusherOptions& options);
};

std::span<const PusherEntry> pushers();

/// The row of that name. Throws OptionError listing the known names.
const PusherEntry& find_pusher(std::string_view name);

}  // namespace pliant
