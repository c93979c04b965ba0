// SPDX-License-Identifier: MIT
#include "options/guide_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/model/atoms/residue_nodes.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/sample/network/mode_field.hpp"

namespace pliant::app {
namespace {

constexpr std::int64_t most_modes = 60, most_period = 1'000'000'000;

std::vector<Joint> selected(const char* option, const std::string& selection,
                            const Structure& structure) {
  const std::vector<std::uint32_t> atoms = select_atoms(structure.atoms, selection);
  if (atoms.empty())
    throw OptionError(fmt::format("{}: {} selects no atom", option, pliant::quoted(selection)));
  return {atoms.begin(), atoms.end()};
}

Vec3 vector_of(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    const auto number = parse_real(std::string_view(text).substr(from, comma - from));
    if (number && std::isfinite(*number)) numbers.push_back(*number);
    from = comma + 1;
    if (!number) break;
  }
  if (numbers.size() != 3 || std::count(text.begin(), text.end(), ',') != 2)
    throw OptionError("--pull: expected a vector X,Y,Z in Angstrom, found " + pliant::quoted(text));
  return {numbers[0], numbers[1], numbers[2]};
}

/// "25", or "20..30".
std::pair<double, double> interval_of(const std::string& text) {
  const std::size_t dots = text.find("..");
  const auto least = parse_real(std::string_view(text).substr(0, dots));
  const auto most = dots == text.npos ? least : parse_real(std::string_view(text).substr(dots + 2));
  if (!least || !most || !(*least >= 0.0) || !(*least <= *most) || !std::isfinite(*most))
    throw OptionError(
        "--pair-distance: expected a distance such as 25, or 20..30, in Angstrom, found " +
        pliant::quoted(text));
  return {*least, *most};
}

NetworkNodes network_nodes_of(const Structure& structure) {
  ResidueNodes found = residue_nodes(structure);
  return {std::move(found.positions), std::move(found.chain), std::move(found.of_atom)};
}

Pull pull_of(const std::vector<std::string>& words, const Structure& structure) {
  Pull pull{selected("--pull", words[0], structure), vector_of(words[1])};
  // The way begins where the centre is.
  pull.to += way_of({pull.joints, {}}, structure.positions) * -1.0;
  return pull;
}

std::string asked_text(const PairDistance& pair) {
  if (pair.least == pair.most) return fmt::format("{:g} A", pair.least);
  return fmt::format("{:g} to {:g} A", pair.least, pair.most);
}

std::string joined(const std::vector<std::vector<std::string>>& groups) {
  std::string text;
  for (const auto& words : groups)
    for (const std::string& word : words) text += (text.empty() ? "" : " | ") + word;
  return text;
}

}  // namespace

void add_guide_options(CommandLine& line, GuideSettings& settings) {
  line.start_group("Guides, in place of --perturb");
  line.add_integer("--rock", settings.rock, 1, most_modes,
                   "rock back and forth along this mode of the elastic network, counted from 1",
                   "none");
  line.add_real("--rock-amplitude", settings.rock_amplitude, Range::positive,
                "how far to each side, Angstrom, r.m.s. over residues");
  line.add_integer("--period", settings.period, 2, most_period,
                   "steps of one full cycle: to one side, to the other and back");
  line.add_groups("--pull", settings.pulls, 2, "SELECTION X,Y,Z",
                  "pull these atoms by this vector, Angstrom; may be repeated;\n"
                  "whole residues get there faster than single atoms");
  line.add_groups("--pair-distance", settings.pairs, 3, "A B DISTANCE",
                  "bring the centres of two selections to a distance in Angstrom, or an\n"
                  "interval such as 20..30 (FRET, DEER, cross-links); may be repeated");
}

void check_guide(const CommandLine& line, const GuideSettings& settings, bool has_walkers) {
  if (settings.empty()) {
    for (const char* option : {"--rock-amplitude", "--period"})
      if (line.was_given(option)) throw OptionError(std::string(option) + ": goes with --rock");
    return;
  }
  for (const char* option : {"--perturb", "--forces", "--record-forces"})
    if (line.was_given(option))
      throw OptionError(std::string(option) +
                        ": goes with neither --rock, --pull nor --pair-distance");
  if (has_walkers)
    throw OptionError(
        "--walkers: all would go the same way with --rock, --pull or "
        "--pair-distance");
}

Guide guide_from(const GuideSettings& settings, const Molecule& molecule) {
  Guide guide;
  guide.period = settings.period;
  const Structure& structure = molecule.structure;
  if (settings.rock > 0)
    guide.rock = mode_field(network_nodes_of(structure), structure.positions,
                            static_cast<std::size_t>(settings.rock), settings.rock_amplitude);
  for (const auto& words : settings.pulls) guide.pulls.push_back(pull_of(words, structure));
  for (const auto& words : settings.pairs) {
    const auto [least, most] = interval_of(words[2]);
    guide.pairs.push_back({selected("--pair-distance", words[0], structure),
                           selected("--pair-distance", words[1], structure), least, most});
  }
  check(guide, molecule.framework);
  return guide;
}

std::vector<NamedParameter> parameters_of(const GuideSettings& settings) {
  return {{"guide/rock", settings.rock},
          {"guide/rock_amplitude", settings.rock_amplitude},
          {"guide/period", settings.period},
          {"guide/pull", joined(settings.pulls)},
          {"guide/pair_distance", joined(settings.pairs)}};
}

bool GuideEnd::is_reached() const {
  return guide_.empty() || !guide_.rock.empty() || has_arrived(guide_, last_);
}

bool GuideEnd::is_there(const PairDistance& pair) const {
  return std::abs(excess_of(pair, last_)) <= guide_slack;
}

bool GuideEnd::is_there(const Pull& pull) const { return norm(way_of(pull, last_)) <= guide_slack; }

void GuideEnd::print() const {
  for (std::size_t k = 0; k < guide_.pulls.size(); ++k) {
    const Pull& pull = guide_.pulls[k];
    fmt::print("pulled          {}: {:.2f} A away at first, {:.2f} A now{}\n",
               printable(settings_.pulls[k][0]), norm(way_of(pull, first_)),
               norm(way_of(pull, last_)), is_there(pull) ? "" : ": did not arrive");
  }
  for (std::size_t k = 0; k < guide_.pairs.size(); ++k) {
    const PairDistance& pair = guide_.pairs[k];
    fmt::print("pair distance   {} - {}: {:.2f} A at first, {:.2f} A now, {} asked for{}\n",
               printable(settings_.pairs[k][0]), printable(settings_.pairs[k][1]),
               norm(line_of(pair, first_)), norm(line_of(pair, last_)), asked_text(pair),
               is_there(pair) ? "" : ": not reached");
  }
}

Json GuideEnd::json() const {
  std::vector<Json> pulls, pairs;
  for (std::size_t k = 0; k < guide_.pulls.size(); ++k) {
    const Pull& pull = guide_.pulls[k];
    pulls.push_back({{"selection", settings_.pulls[k][0]},
                     {"away_at_first", norm(way_of(pull, first_))},
                     {"away", norm(way_of(pull, last_))},
                     {"is_reached", is_there(pull)}});
  }
  for (std::size_t k = 0; k < guide_.pairs.size(); ++k) {
    const PairDistance& pair = guide_.pairs[k];
    pairs.push_back({{"first", settings_.pairs[k][0]},
                     {"second", settings_.pairs[k][1]},
                     {"least", pair.least},
                     {"most", pair.most},
                     {"at_first", norm(line_of(pair, first_))},
                     {"reached", norm(line_of(pair, last_))},
                     {"is_reached", is_there(pair)}});
  }
  return {{"pulls", Json::array(pulls)}, {"pair_distances", Json::array(pairs)}};
}

}  // namespace pliant::app
