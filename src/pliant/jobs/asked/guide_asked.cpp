// SPDX-License-Identifier: MIT
#include "pliant/jobs/asked/guide_asked.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/model/atoms/residue_nodes.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/sample/network/mode_field.hpp"

namespace pliant {
namespace {

constexpr std::string_view group = "Guides, in place of --perturb";
constexpr double most_modes = 60;

template <auto Member>
constexpr auto at = place_at<GuideAsked, Member>;

constexpr OptionField<GuideAsked> table[] = {
    {{.name = "rock",
      .group = group,
      .summary = "rock back and forth along this mode of the elastic network, counted from 1, a\n"
                 "full cycle in 100 steps",
      .range = Range::positive,
      .largest = most_modes,
      .is_optional = true,
      .unset_means = "none"},
     at<&GuideAsked::rock>},
    {{.name = "amplitude",
      .group = group,
      .summary = "how far to rock to each side, Angstrom, r.m.s. over residues",
      .range = Range::positive},
     at<&GuideAsked::amplitude>},
    {{.name = "pull",
      .group = group,
      .summary = "pull these atoms by this vector, Angstrom; may be repeated;\n"
                 "whole residues get there faster than single atoms",
      .kind = "SELECTION X,Y,Z",
      .words = 2},
     at<&GuideAsked::pulls>},
    {{.name = "pair_distance",
      .group = group,
      .summary = "bring the centres of two selections to a distance in Angstrom, or an\n"
                 "interval such as 20..30 (FRET, DEER, cross-links); may be repeated",
      .kind = "A B DISTANCE",
      .words = 3},
     at<&GuideAsked::pairs>},
};

std::vector<Joint> selected(const char* option, const std::string& selection,
                            const Structure& structure) {
  const std::vector<std::uint32_t> atoms = select_atoms(structure.atoms, selection);
  if (atoms.empty())
    throw OptionError(std::string(option) + ": " + quoted(selection) + " selects no atom");
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
    throw OptionError("--pull: expected a vector X,Y,Z in Angstrom, found " + quoted(text));
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
        quoted(text));
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

}  // namespace

std::span<const OptionField<GuideAsked>> guide_fields() { return table; }

Guide guide_from(const GuideAsked& asked, const Structure& structure, const Framework& framework) {
  Guide guide;
  if (asked.rock > 0)
    guide.rock = mode_field(network_nodes_of(structure), structure.positions,
                            static_cast<std::size_t>(asked.rock), asked.amplitude);
  for (const auto& words : asked.pulls) guide.pulls.push_back(pull_of(words, structure));
  for (const auto& words : asked.pairs) {
    const auto [least, most] = interval_of(words[2]);
    guide.pairs.push_back({selected("--pair-distance", words[0], structure),
                           selected("--pair-distance", words[1], structure), least, most});
  }
  check(guide, framework);
  return guide;
}

}  // namespace pliant
