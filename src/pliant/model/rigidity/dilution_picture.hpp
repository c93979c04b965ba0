// SPDX-License-Identifier: MIT
// The dilution plot: which residues are rigid together as hydrogen bonds go, one line each time
// that clusters of residues change, as FIRST draws it (Hespenheide, Rader, Thorpe, Kuhn, J. Mol.
// Graph. Model. 21 (2002) 195). An SVG picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pliant/model/rigidity/rigidity.hpp"
#include "pliant/model/rigidity/rigidity_dilution.hpp"

namespace pliant {

/// Clusters that are drawn have one of so many colours.
inline constexpr std::size_t cluster_colours = 14;

/// Of clusters, the largest first, so many have a colour: at most cluster_colours; where there are
/// chains of amino acids those of 20 atoms or more (a side chain alone stays grey), else all.
std::size_t coloured_clusters(const Structure& structure, const ClusterList& clusters);

/// "#0072b2": of a cluster, from 0; colours come again after the last. The first six are told apart
/// without seeing red and green (Okabe, Ito, Color Universal Design, 2008).
std::string cluster_colour(std::size_t cluster);

/// Rows of a dilution, and the picture of them.
class DilutionPicture {
 public:
  /// Residues are those of `structure` that have CA, or P or C4'; others are left out.
  explicit DilutionPicture(const Structure& structure);

  /// As dilute_hydrogen_bonds() shows rows: from no hydrogen bond to all.
  void add(const DilutionRow& row, const ClusterList& clusters);

  /// `energies`: of the hydrogen bonds, the strongest first, kcal/mol.
  std::string svg(const std::string& title, const std::vector<double>& energies) const;

 private:
  /// The cluster of each residue; `none` where fewer than three share it.
  struct Line {
    std::size_t hydrogen_bonds;
    std::vector<std::uint32_t> cluster;
  };

  std::vector<std::vector<std::uint32_t>> colours_of(const std::vector<Line>& lines) const;
  std::string axis(double bottom) const;
  const Residue& residue(std::size_t k) const;

  const Structure& structure_;
  std::vector<std::uint32_t> atoms_;  ///< one a residue that is shown
  std::vector<Line> lines_;
};

/// Rows, and the picture of them.
struct DrawnDilution {
  std::vector<DilutionRow> rows;
  std::string svg;
};

/// Of a picture: "ubi.pdb: rigid clusters of residues as hydrogen bonds go".
std::string dilution_title(const std::string& molecule);

/// Dilutes a network of this model (dilute_hydrogen_bonds) and draws it. `title` is plain text.
DrawnDilution draw_dilution(const ContactModel& model, const RigidityNetwork& network,
                            const std::string& title);

}  // namespace pliant
