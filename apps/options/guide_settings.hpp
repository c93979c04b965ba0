// SPDX-License-Identifier: MIT
// The options of pliant run that guide it, and their result.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "options/molecule_input.hpp"
#include "output/json.hpp"
#include "pliant/base/parameter.hpp"
#include "pliant/perturb/guide.hpp"

namespace pliant::app {

struct GuideSettings {
  std::int64_t rock = 0;                        ///< mode, from 1; 0: none
  double rock_amplitude = 1.0;                  ///< Angstrom, r.m.s. of residues
  std::int64_t period = 100;                    ///< steps
  std::vector<std::vector<std::string>> pulls;  ///< selection, "x,y,z"
  std::vector<std::vector<std::string>> pairs;  ///< selection, selection, "d" or "d1..d2"

  bool empty() const { return rock == 0 && pulls.empty() && pairs.empty(); }
};

void add_guide_options(CommandLine& line, GuideSettings& settings);

/// Throws OptionError for options that exclude each other; `has_walkers`: there are several.
void check_guide(const CommandLine& line, const GuideSettings& settings, bool has_walkers);

/// Makes the guide. Throws OptionError naming the option, and what is wrong with its value.
Guide guide_from(const GuideSettings& settings, const Molecule& molecule);

/// The options as given, to be recorded.
std::vector<NamedParameter> parameters_of(const GuideSettings& settings);

/// Distances of pairs at the start, at the end and as asked, and how far pulled groups are from
/// their targets.
class GuideEnd {
 public:
  /// Positions (N) of the first and the last frame. All arguments must outlive it.
  GuideEnd(const GuideSettings& settings, const Guide& guide, std::span<const Vec3> first,
           std::span<const Vec3> last)
      : settings_(settings), guide_(guide), first_(first), last_(last) {}

  bool is_reached() const;
  void print() const;
  Json json() const;

 private:
  bool is_there(const PairDistance& pair) const;
  bool is_there(const Pull& pull) const;

  const GuideSettings& settings_;
  const Guide& guide_;
  std::span<const Vec3> first_, last_;
};

}  // namespace pliant::app
