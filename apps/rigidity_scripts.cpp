// SPDX-License-Identifier: MIT
#include "rigidity_scripts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace pliant::app {
namespace {

/// The first are told apart without seeing red and green (Okabe, Ito, 2008), then tints of them.
constexpr std::array<std::string_view, 14> colours{"0072b2", "e69f00", "009e73", "cc79a7", "56b4e9",
                                                   "d55e00", "f0e442", "5a4fcf", "8c564b", "7f9f3f",
                                                   "b05a8f", "2f8f9f", "c0a060", "6b6b9f"};

constexpr std::string_view loose = "d0d0d0";  ///< of atoms in no cluster that is coloured

}  // namespace

std::string cluster_colour(std::size_t cluster) {
  return fmt::format("#{}", colours[cluster % colours.size()]);
}

std::string rigidity_pymol_script(std::size_t clusters, bool is_polymer) {
  std::string text =
      "# pymol show.pml: scene F1 rigid clusters, each in a colour, grey is flexible;\n"
      "# scene F2 flexibility of residues: blue rigid, red flexible\n"
      "load clusters.pdb, clusters\nload flexibility.pdb, flexibility\nhide everything\n"
      "bg_color white\n";
  text += fmt::format("color 0x{}, clusters\n", loose);
  for (std::size_t k = std::min(clusters, colours.size()); k-- > 0;)
    text += fmt::format("color 0x{}, clusters and b > {}.5 and b < {}.5\n", colours[k], k, k + 1);
  const char* style = is_polymer ? "cartoon" : "sticks";
  text +=
      fmt::format("show {}, clusters\nshow lines, clusters and b > 0.5\norient clusters\n", style);
  text += "scene F1, store\nhide everything\nspectrum b, blue_white_red, flexibility, -100, 100\n";
  text += fmt::format("show {}, flexibility\nscene F2, store\nscene F1, recall\n", style);
  return text;
}

std::string rigidity_chimerax_script(std::size_t clusters, bool is_polymer) {
  std::string text =
      "# ChimeraX: open show.cxc; model 1: rigid clusters, each in a colour, grey is flexible;\n"
      "# model 2, hidden: flexibility of residues, blue rigid, red flexible\n"
      "open clusters.pdb\nopen flexibility.pdb\nset bgColor white\n";
  text += fmt::format("color #1 #{}\n", loose);
  for (std::size_t k = std::min(clusters, colours.size()); k-- > 0;)
    text += fmt::format("color #1@@bfactor>{}.5 & #1@@bfactor<{}.5 #{}\n", k, k + 1, colours[k]);
  text += is_polymer ? "hide atoms\nshow cartoons\ncolor #1 fromatoms\n" : "show atoms\n";
  text += "color byattribute bfactor #2 palette -100,blue:0,white:100,red\nhide #2 models\nview\n";
  return text;
}

}  // namespace pliant::app
