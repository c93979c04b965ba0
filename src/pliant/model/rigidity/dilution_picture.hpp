// SPDX-License-Identifier: MIT
// The dilution plot, an SVG picture: which residues are rigid together as hydrogen bonds are
// removed, with a line for each change of the clusters of residues, as FIRST draws it (Hespenheide,
// Rader, Thorpe, Kuhn, J. Mol. Graph. Model. 21 (2002) 195).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pliant/model/rigidity/rigidity.hpp"
#include "pliant/model/rigidity/rigidity_dilution.hpp"

namespace pliant {

/// Number of colours of clusters.
inline constexpr std::size_t cluster_colours = 14;

/// How many clusters, the largest first, get a colour: at most cluster_colours. In chains of amino
/// acids only clusters of 20 atoms or more do (a side chain alone is grey), otherwise all.
std::size_t coloured_clusters(const Structure& structure, const ClusterList& clusters);

/// The colour of a cluster, from 0, as "#0072b2". Colours repeat after the last. The first six can
/// be distinguished without seeing red and green (Okabe, Ito, Color Universal Design, 2008).
std::string cluster_colour(std::size_t cluster);

/// The rows of a dilution and their picture.
class DilutionPicture {
 public:
  /// Shows the residues of `structure` that have CA, or P or C4'.
  explicit DilutionPicture(const Structure& structure);

  /// Adds a row; rows come as from dilute_hydrogen_bonds(), from no hydrogen bond to all.
  void add(const DilutionRow& row, const ClusterList& clusters);

  /// `energies` are those of the hydrogen bonds, the strongest first, kcal/mol.
  std::string svg(const std::string& title, const std::vector<double>& energies) const;

 private:
  /// The cluster of each residue; `none` if fewer than three residues share it.
  struct Line {
    std::size_t hydrogen_bonds;
    std::vector<std::uint32_t> cluster;
  };

  std::vector<std::vector<std::uint32_t>> colours_of(const std::vector<Line>& lines) const;
  std::string axis(double bottom) const;
  const Residue& residue(std::size_t k) const;

  const Structure& structure_;
  std::vector<std::uint32_t> atoms_;  ///< one for each residue shown
  std::vector<Line> lines_;
};

/// Rows, and the picture of them.
struct DrawnDilution {
  std::vector<DilutionRow> rows;
  std::string svg;
};

/// The title of a picture: "ubi.pdb: rigid clusters of residues as hydrogen bonds go".
std::string dilution_title(const std::string& molecule);

/// Dilutes a network of this model (dilute_hydrogen_bonds) and draws it. `title` is plain text.
DrawnDilution draw_dilution(const ContactModel& model, const RigidityNetwork& network,
                            const std::string& title);

}  // namespace pliant
