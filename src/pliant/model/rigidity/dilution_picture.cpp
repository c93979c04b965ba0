// SPDX-License-Identifier: MIT
#include "pliant/model/rigidity/dilution_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "pliant/model/atoms/residue_nodes.hpp"
#include "pliant/model/prepare/survey.hpp"

namespace pliant {
namespace {

constexpr std::array<std::string_view, cluster_colours> hexadecimal{
    "0072b2", "e69f00", "009e73", "cc79a7", "56b4e9", "d55e00", "f0e442",
    "5a4fcf", "8c564b", "7f9f3f", "b05a8f", "2f8f9f", "c0a060", "6b6b9f"};

constexpr std::uint32_t none = ~std::uint32_t{0};
constexpr std::size_t least_residues = 3;  // that make a cluster which is shown
constexpr double left = 110.0, above = 62.0, height = 13.0, bar = 9.0;  // pixels
constexpr double widest = 1000.0, largest_step = 9.0;

/// Clusters of fewer residues are none.
void drop_small(std::vector<std::uint32_t>& clusters) {
  std::map<std::uint32_t, std::size_t> sizes;
  for (std::uint32_t cluster : clusters) ++sizes[cluster];
  for (std::uint32_t& cluster : clusters)
    if (sizes[cluster] < least_residues) cluster = none;
}

/// Whether two lines group residues alike, whatever the numbers of clusters.
bool is_alike(const std::vector<std::uint32_t>& one, const std::vector<std::uint32_t>& other) {
  std::map<std::uint32_t, std::uint32_t> there, back;
  for (std::size_t k = 0; k < one.size(); ++k) {
    if ((one[k] == none) != (other[k] == none)) return false;
    if (there.try_emplace(one[k], other[k]).first->second != other[k]) return false;
    if (back.try_emplace(other[k], one[k]).first->second != one[k]) return false;
  }
  return true;
}

double step_of(std::size_t residues) {
  return std::min(largest_step, widest / std::max(1.0, double(residues)));
}

std::string text_at(double x, double y, const std::string& text, const char* anchor) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     text);
}

std::string head(double width, double tall, const std::string& title) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"10\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "<text x=\"10\" y=\"18\" font-size=\"14\">{2}</text>\n",
      width, tall, title);
}

/// A thin line, and on it a bar for each stretch of residues of one colour.
std::string stretches(const std::vector<std::uint32_t>& colours, double middle) {
  const double step = step_of(colours.size());
  std::string text = fmt::format(
      "<line x1=\"{0:.1f}\" y1=\"{2:.1f}\" x2=\"{1:.1f}\" y2=\"{2:.1f}\" stroke=\"black\"/>\n",
      left, left + step * double(colours.size()), middle);
  for (std::size_t first = 0, last = 0; first < colours.size(); first = last) {
    while (last < colours.size() && colours[last] == colours[first]) ++last;
    if (colours[first] != none)
      text += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n",
          left + step * double(first), middle - 0.5 * bar, step * double(last - first), bar,
          cluster_colour(colours[first]));
  }
  return text;
}

/// Places of the residues of a cluster.
using Members = std::vector<std::size_t>;

/// The clusters of a line, those of most residues first.
std::vector<Members> clusters_of(const std::vector<std::uint32_t>& line) {
  std::map<std::uint32_t, Members> members;
  for (std::size_t k = 0; k < line.size(); ++k)
    if (line[k] != none) members[line[k]].push_back(k);
  std::vector<Members> sorted;
  for (auto& [cluster, residues] : members) sorted.push_back(std::move(residues));
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Members& a, const Members& b) { return a.size() > b.size(); });
  return sorted;
}

/// The colour that most of these residues have in the line above, unless a larger cluster has it;
/// or none.
std::uint32_t colour_above(const Members& members, const std::vector<std::uint32_t>& above_it,
                           const std::vector<std::uint32_t>& taken) {
  std::map<std::uint32_t, std::size_t> counts;
  for (std::size_t k : members)
    if (above_it[k] != none) ++counts[above_it[k]];
  std::uint32_t best = none;
  std::size_t most = 0;
  for (const auto& [colour, count] : counts)
    if (count > most && std::find(taken.begin(), taken.end(), colour) == taken.end()) {
      best = colour;
      most = count;
    }
  return best;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (char c : text)
    out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return out;
}

}  // namespace

std::size_t coloured_clusters(const Structure& structure, const ClusterList& clusters) {
  constexpr std::uint32_t least_in_protein = 20;
  const bool is_protein = usual_model(structure) == ModelKind::protein;
  return std::min(clusters.count(is_protein ? least_in_protein : least_cluster), cluster_colours);
}

std::string cluster_colour(std::size_t cluster) {
  return fmt::format("#{}", hexadecimal[cluster % cluster_colours]);
}

DilutionPicture::DilutionPicture(const Structure& structure) : structure_(structure) {
  const ResidueNodes nodes = residue_nodes(structure);
  for (std::size_t k = 0; k < nodes.atom.size(); ++k)
    if (nodes.is_residue[k]) atoms_.push_back(nodes.atom[k]);
}

void DilutionPicture::add(const DilutionRow& row, const ClusterList& clusters) {
  Line line{row.hydrogen_bonds, {}};
  for (std::uint32_t atom : atoms_) line.cluster.push_back(clusters.of_body[atom]);
  drop_small(line.cluster);
  // Rows come from none to all; of those that are alike the one with all of its bonds is kept.
  if (!lines_.empty() && is_alike(lines_.back().cluster, line.cluster)) lines_.pop_back();
  lines_.push_back(std::move(line));
}

std::vector<std::vector<std::uint32_t>> DilutionPicture::colours_of(
    const std::vector<Line>& lines) const {
  std::vector<std::vector<std::uint32_t>> all;
  std::uint32_t next = 0;
  for (const Line& line : lines) {
    const std::vector<std::uint32_t> above_it =
        all.empty() ? std::vector<std::uint32_t>(line.cluster.size(), none) : all.back();
    std::vector<std::uint32_t> colours(line.cluster.size(), none), taken;
    for (const Members& members : clusters_of(line.cluster)) {
      std::uint32_t colour = colour_above(members, above_it, taken);
      if (colour == none) colour = next++;
      taken.push_back(colour);
      for (std::size_t k : members) colours[k] = colour;
    }
    all.push_back(std::move(colours));
  }
  return all;
}

const Residue& DilutionPicture::residue(std::size_t k) const {
  return structure_.atoms.residues[structure_.atoms.residue_of[atoms_[k]]];
}

/// Numbers of residues, every so many, and where chains begin.
std::string DilutionPicture::axis(double bottom) const {
  const double step = step_of(atoms_.size());
  const std::int64_t every = step > 6.0 ? 10 : step > 2.5 ? 20 : 50;
  std::string text;
  for (std::size_t k = 0; k < atoms_.size(); ++k) {
    const double x = left + step * (double(k) + 0.5);
    if (residue(k).number % every == 0)
      text += text_at(x, above - 8.0, std::to_string(residue(k).number), "middle");
    if (k > 0 && residue(k).chain == residue(k - 1).chain) continue;
    if (!residue(k).chain.empty())
      text += text_at(x, above - 24.0, "chain " + escaped(residue(k).chain), "start");
    text += fmt::format(
        "<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\" stroke=\"#b0b0b0\"/>\n",
        x - 0.5 * step, above - 20.0, bottom);
  }
  return text;
}

std::string DilutionPicture::svg(const std::string& title,
                                 const std::vector<double>& energies) const {
  const std::vector<Line> lines(lines_.rbegin(), lines_.rend());
  const auto colours = colours_of(lines);
  const double right = left + step_of(atoms_.size()) * double(atoms_.size());
  const double bottom = above + height * double(lines.size());
  std::string text = head(std::max(right, left + 660.0) + 20.0, bottom + 34.0, escaped(title));
  text += text_at(6.0, above - 8.0, "kcal/mol", "start") +
          text_at(left - 8.0, above - 8.0, "bonds", "end") + axis(bottom);
  for (std::size_t row = 0; row < lines.size(); ++row) {
    const double middle = above + height * (double(row) + 0.5);
    const std::size_t bonds = lines[row].hydrogen_bonds;
    const bool has_energy = bonds > 0 && bonds <= energies.size();
    text += text_at(50.0, middle + 3.5,
                    has_energy ? fmt::format("{:.2f}", energies[bonds - 1]) : "", "end") +
            text_at(left - 8.0, middle + 3.5, std::to_string(bonds), "end") +
            stretches(colours[row], middle);
  }
  text += text_at(left, bottom + 18.0,
                  "Bars of one colour in a line are one rigid cluster; a thin line is flexible. "
                  "Left: the weakest bond that is left, and how many are.",
                  "start");
  return text + "</svg>\n";
}

std::string dilution_title(const std::string& molecule) {
  return molecule + ": rigid clusters of residues as hydrogen bonds go";
}

DrawnDilution draw_dilution(const ContactModel& model, const RigidityNetwork& network,
                            const std::string& title) {
  DrawnDilution drawn;
  DilutionPicture picture(model.structure);
  drawn.rows = dilute_hydrogen_bonds(
      network,
      [&](const DilutionRow& row, const ClusterList& clusters) { picture.add(row, clusters); });
  std::vector<double> energies;
  for (std::size_t k = network.first_hydrogen_bond; k < network.edges.size(); ++k)
    energies.push_back(model.contacts[network.contact_of(k)].energy);
  drawn.svg = picture.svg(title, energies);
  return drawn;
}

}  // namespace pliant
