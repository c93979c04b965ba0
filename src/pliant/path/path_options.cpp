// SPDX-License-Identifier: MIT
#include "pliant/path/path_options.hpp"

#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

constexpr double largest_step = 2.0;  // Angstrom
constexpr std::int64_t most_attempts = 1000;

}  // namespace

std::string_view name(PathAtoms atoms) { return atoms == PathAtoms::alpha ? "CA" : "heavy"; }

PathAtoms find_path_atoms(std::string_view name) {
  if (name == "CA") return PathAtoms::alpha;
  if (name == "heavy") return PathAtoms::heavy;
  throw OptionError("atoms: expected \"CA\" or \"heavy\", found " + quoted(name));
}

double arrived_within(PathAtoms atoms) { return atoms == PathAtoms::alpha ? 0.5 : 1.0; }

void check(const PathOptions& options) {
  if (!(options.step > 0.0 && options.step <= largest_step))
    throw OptionError("step: expected above 0, at most 2 Angstrom, found " +
                      number_text(options.step));
  if (options.backtrack < 0 || options.backtrack > most_attempts)
    throw OptionError("backtrack: expected 0 to " + std::to_string(most_attempts) + ", found " +
                      std::to_string(options.backtrack));
}

}  // namespace pliant
