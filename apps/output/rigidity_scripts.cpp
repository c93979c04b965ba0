// SPDX-License-Identifier: MIT
#include "output/rigidity_scripts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <string_view>

#include "pliant/model/rigidity/dilution_picture.hpp"

namespace pliant::app {
namespace {

constexpr std::string_view loose = "d0d0d0";  ///< of atoms in no cluster that is coloured

/// Blue, light grey and orange, of 255.
constexpr std::array<std::array<int, 3>, 3> ramp{{{47, 103, 153}, {222, 226, 228}, {213, 94, 0}}};

std::string hexadecimal(std::size_t cluster) { return cluster_colour(cluster).substr(1); }

}  // namespace

std::string rigidity_pymol_script(std::size_t clusters, bool is_polymer, double most) {
  std::string text =
      "# pymol show.pml: scene F1 rigid clusters, each in a colour, the others grey,\n"
      "# scene F2 flexibility of residues: blue rigid, orange flexible\n"
      "load clusters.pdb, clusters\nload flexibility.pdb, flexibility\nhide everything\n"
      "bg_color white\n";
  text += fmt::format("color 0x{}, clusters\n", loose);
  for (std::size_t k = clusters; k-- > 0;)
    text +=
        fmt::format("color 0x{}, clusters and b > {}.5 and b < {}.5\n", hexadecimal(k), k, k + 1);
  const std::string style =
      is_polymer ? "show cartoon, {0}\nshow sticks, {0} and organic\n" : "show sticks, {0}\n";
  const auto shown = [&](const char* name) { return fmt::format(fmt::runtime(style), name); };
  text += shown("clusters") + "orient clusters\nscene F1, store\nhide everything\n";
  text += fmt::format("set_color rigid, [{}]\nset_color between, [{}]\nset_color flexible, [{}]\n",
                      fmt::join(ramp[0], ", "), fmt::join(ramp[1], ", "), fmt::join(ramp[2], ", "));
  text += fmt::format("spectrum b, rigid between flexible, flexibility, 0, {:.0f}\n", most);
  return text + shown("flexibility") + "scene F2, store\nscene F1, recall\n";
}

std::string rigidity_chimerax_script(std::size_t clusters, bool is_polymer, double most) {
  std::string text =
      "# ChimeraX: open show.cxc. Model 1: rigid clusters, each in a colour, the others grey,\n"
      "# model 2, hidden: flexibility of residues, blue rigid, orange flexible\n"
      "open clusters.pdb\nopen flexibility.pdb\nset bgColor white\n";
  text += fmt::format("color #1 #{}\n", loose);
  for (std::size_t k = clusters; k-- > 0;)
    text += fmt::format("color (#1 & @@bfactor>{}.5 & @@bfactor<{}.5) {}\n", k, k + 1,
                        cluster_colour(k));
  text +=
      fmt::format("color byattribute bfactor #2 palette 0,#2f6799:{:.1f},#dee2e4:{:.0f},#d55e00\n",
                  0.5 * most, most);
  text += is_polymer ? "hide atoms\nshow ligand atoms\nshow cartoons\ncolor #1,2 fromatoms\n"
                     : "show atoms\n";
  return text + "hide #2 models\nview\n";
}

}  // namespace pliant::app
