// SPDX-License-Identifier: MIT
#include "output/graph_rigidity.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "output/csv_cell.hpp"
#include "pliant/base/printable.hpp"

namespace pliant::app {
namespace {

constexpr std::size_t most_parts = 10, most_bars = 6;

void print_row(std::string_view label, std::size_t value, const std::string& comment = {}) {
  fmt::print("{:<28}{:>9}{}{}\n", label, value, comment.empty() ? "" : "   ", comment);
}

std::string name_of(const GraphRigidityReport& report, Joint joint) {
  const auto& atoms = report.framework.atoms();
  return atoms ? std::string(atoms->names[joint]) : std::to_string(joint);
}

std::size_t redundant_bars(const BarRank& rank) {
  return std::size_t(std::count(rank.redundant.begin(), rank.redundant.end(), true));
}

/// Why a number is not that of the positions; "" where it is.
std::string difference(std::size_t here, std::size_t there, const char* more, const char* less) {
  if (here == there) return "";
  return here < there ? more : less;
}

void print_freedoms(const FrameworkRigidity& found) {
  const std::size_t here = found.motions.internal();
  print_row("internal degrees of freedom", here,
            fmt::format("at these positions, and {} of the whole", found.motions.of_whole));
  print_row("  at almost all positions", found.generic_motions.internal(),
            difference(here, found.generic_motions.internal(), "",
                       "the others may be motions to first order only"));
  print_row("  by counting bars", found.counted_motions.internal(),
            difference(found.generic_motions.internal(), found.counted_motions.internal(), "",
                       "pebble game: in space it can miss freedoms"));
}

void print_parts(const GraphRigidityReport& report) {
  const auto& parts = report.found.overconstrained;
  if (parts.empty()) return;
  fmt::print("\nOverconstrained parts: any one bar of a part can go, and no freedom comes\n");
  fmt::print("{:>6} {:>7} {:>14}  {}\n", "joints", "bars", "self-stresses", "which bars");
  for (std::size_t k = 0; k < std::min(parts.size(), most_parts); ++k) {
    std::string bars;
    for (std::size_t n = 0; n < std::min(parts[k].bars.size(), most_bars); ++n) {
      const Bar bar = report.framework.bars()[parts[k].bars[n]];
      bars += fmt::format("{}{}-{}", n == 0 ? "" : ", ", name_of(report, bar.a),
                          name_of(report, bar.b));
    }
    if (parts[k].bars.size() > most_bars) bars += ", ...";
    fmt::print("{:>6} {:>7} {:>14}  {}\n", parts[k].joints, parts[k].bars.size(),
               parts[k].self_stresses, printable(bars));
  }
  if (parts.size() > most_parts) fmt::print("... {} more parts\n", parts.size() - most_parts);
}

Json json_of_motions(const Motions& motions) {
  return {{"degrees_of_freedom", motions.internal()},
          {"motions_of_the_whole", motions.of_whole},
          {"motions", motions.all}};
}

Json json_of_parts(const GraphRigidityReport& report) {
  std::vector<Json> parts;
  for (const OverconstrainedPart& part : report.found.overconstrained) {
    std::vector<Json> bars;
    for (const BarIndex bar : part.bars) bars.push_back(bar);
    parts.push_back({{"joints", part.joints},
                     {"self_stresses", part.self_stresses},
                     {"bars", Json::array(bars)}});
  }
  return Json::array(parts);
}

Json json_of_bars(const GraphRigidityReport& report) {
  std::vector<Json> bars;
  for (BarIndex k = 0; k < report.framework.bar_count(); ++k) {
    const Bar bar = report.framework.bars()[k];
    bars.push_back({{"a", name_of(report, bar.a)},
                    {"b", name_of(report, bar.b)},
                    {"redundant", bool(report.found.rank.redundant[k])},
                    {"redundant_at_almost_all", bool(report.found.generic_rank.redundant[k])}});
  }
  return Json::array(bars);
}

}  // namespace

void print_rigidity(const GraphRigidityReport& report) {
  const FrameworkRigidity& found = report.found;
  const std::size_t pinned = report.framework.pinned_count();
  fmt::print("{}\n", printable_name(report.file));
  print_row(
      "joints", report.framework.joint_count(),
      fmt::format(
          "in {}, {} pinned{}", found.dimension == 2 ? "the plane" : "space",
          pinned == 0 ? "none" : std::to_string(pinned),
          found.parts == 1 ? "" : fmt::format(", in {} parts that nothing links", found.parts)));
  const std::size_t redundant = redundant_bars(found.rank);
  print_row("bars", report.framework.bar_count(),
            redundant == 0 ? "none redundant"
                           : fmt::format("{} redundant: any one of them can go", redundant));
  print_row("independent bars", found.rank.rank,
            fmt::format("rank of the rigidity matrix: {} above {:g}",
                        found.rank.has_singular_values ? "singular values" : "rows of sparse QR",
                        rank_tolerance));
  print_row("self-stresses", report.framework.bar_count() - found.rank.rank);
  print_freedoms(found);
  print_parts(report);
}

std::string bars_as_csv(const GraphRigidityReport& report) {
  std::string text = "a,b,redundant,redundant_at_almost_all\n";
  for (BarIndex k = 0; k < report.framework.bar_count(); ++k) {
    const Bar bar = report.framework.bars()[k];
    text += fmt::format("{},{},{:d},{:d}\n", csv_cell(name_of(report, bar.a)),
                        csv_cell(name_of(report, bar.b)), bool(report.found.rank.redundant[k]),
                        bool(report.found.generic_rank.redundant[k]));
  }
  return text;
}

Json json_of_rigidity(const GraphRigidityReport& report) {
  const FrameworkRigidity& found = report.found;
  std::vector<Json> nearly;
  for (const double value : found.rank.nearly_dependent) nearly.push_back(value);
  const std::size_t bars = report.framework.bar_count();
  return Json{{"file", report.file},
              {"dimension", found.dimension},
              {"joints", report.framework.joint_count()},
              {"pinned", report.framework.pinned_count()},
              {"parts", found.parts},
              {"rank", found.rank.rank},
              {"redundant", redundant_bars(found.rank)},
              {"self_stresses", bars - found.rank.rank}} +
         json_of_motions(found.motions) +
         Json{{"at_almost_all_positions",
               json_of_motions(found.generic_motions) +
                   Json{{"rank", found.generic_rank.rank},
                        {"redundant", redundant_bars(found.generic_rank)},
                        {"self_stresses", bars - found.generic_rank.rank}}},
              {"by_counting", json_of_motions(found.counted_motions) +
                                  Json{{"independent_bars", found.counted_rank}}},
              {"rank_by", found.rank.has_singular_values ? "singular values" : "sparse QR"},
              {"tolerance", rank_tolerance},
              {"least_counted", found.rank.least},
              {"largest_not_counted", found.rank.dropped},
              {"nearly_dependent", Json::array(nearly)},
              {"overconstrained", json_of_parts(report)},
              {"bars", json_of_bars(report)}};
}

}  // namespace pliant::app
