// SPDX-License-Identifier: MIT
#include "pliant/sample/network/coarse_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "pliant/base/math/elementary.hpp"

namespace pliant {
namespace {

constexpr double residue_length = 5.1;  // Angstrom: the cube root of the volume of a residue
constexpr double longer = 1.25;         // cells, while there are too many
constexpr std::size_t least_cells = 8;  // about the origin there are always so many

using Cell = std::array<std::int64_t, 3>;

Cell cell_of(Vec3 x, double edge) {
  const auto index = [edge](double value) {
    return static_cast<std::int64_t>(std::floor(value / edge));
  };
  return {index(x.x), index(x.y), index(x.z)};
}

class Merging {
 public:
  Merging(const NetworkNodes& nodes, std::size_t most)
      : nodes_(nodes),
        most_(most),
        each_((nodes.positions.size() + most - 1) / most),
        root_(exact_bits_exp(exact_bits_log(double(each_)) / 3.0)),
        node_of_(nodes.positions.size()) {}

  NetworkNodes run() {
    merge_chains();
    merge_lone_nodes();
    for (std::uint32_t node : nodes_.of_joint)
      out_.of_joint.push_back(node == no_node ? no_node : node_of_[node]);
    out_.scale = nodes_.scale * root_;
    return std::move(out_);
  }

 private:
  bool is_lone(std::size_t k) const {
    const auto& chain = nodes_.chain;
    return (k == 0 || chain[k - 1] != chain[k]) &&
           (k + 1 == chain.size() || chain[k + 1] != chain[k]);
  }

  std::uint32_t begin_node(std::uint32_t chain) {
    out_.chain.push_back(chain);
    out_.positions.emplace_back();
    members_.push_back(0);
    return static_cast<std::uint32_t>(out_.chain.size() - 1);
  }

  void put(std::size_t k, std::uint32_t into) {
    Vec3& mean = out_.positions[into];
    mean += (1.0 / double(++members_[into])) * (nodes_.positions[k] - mean);
    node_of_[k] = into;
  }

  void merge_chains() {
    for (std::size_t k = 0; k < node_of_.size(); ++k) {
      last_chain_ = std::max(last_chain_, nodes_.chain[k]);
      if (is_lone(k)) {
        lone_.push_back(k);
        continue;
      }
      if (out_.chain.empty() || nodes_.chain[k] != out_.chain.back() || members_.back() == each_)
        begin_node(nodes_.chain[k]);
      put(k, static_cast<std::uint32_t>(out_.chain.size() - 1));
    }
  }

  void merge_lone_nodes() {
    std::map<Cell, std::uint32_t> node_of_cell;
    const double edge = cell_edge();
    for (std::size_t k : lone_) {
      const auto [place, is_new] = node_of_cell.try_emplace(cell_of(nodes_.positions[k], edge));
      if (is_new) place->second = begin_node(++last_chain_);
      put(k, place->second);
    }
  }

  double cell_edge() const {
    double edge = residue_length * root_;
    while (cells(edge) > std::max(most_ / 4, least_cells)) edge *= longer;
    return edge;
  }

  std::size_t cells(double edge) const {
    std::vector<Cell> all;
    all.reserve(lone_.size());
    for (std::size_t k : lone_) all.push_back(cell_of(nodes_.positions[k], edge));
    std::sort(all.begin(), all.end());
    return static_cast<std::size_t>(std::unique(all.begin(), all.end()) - all.begin());
  }

  const NetworkNodes& nodes_;
  std::size_t most_, each_;
  double root_;
  std::vector<std::uint32_t> node_of_;  ///< of each node before
  std::vector<std::size_t> members_;    ///< of each node after
  std::vector<std::size_t> lone_;
  std::uint32_t last_chain_ = 0;
  NetworkNodes out_;
};

}  // namespace

NetworkNodes coarsened(NetworkNodes nodes, std::size_t most) {
  if (nodes.positions.size() <= most) return nodes;
  return Merging(nodes, most).run();
}

}  // namespace pliant
