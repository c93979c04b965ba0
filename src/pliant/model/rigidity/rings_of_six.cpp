// SPDX-License-Identifier: MIT
#include "pliant/model/rigidity/rings_of_six.hpp"

#include <algorithm>
#include <string>

#include "pliant/base/graphs/graph.hpp"

namespace pliant {
namespace {

constexpr std::uint8_t hinge = 5;
constexpr std::size_t size = 6;

class RingsOfSix {
 public:
  explicit RingsOfSix(const RigidityNetwork& network) {
    std::vector<BodyEdge> hinges;
    for (std::size_t k = 0; k < network.bonds; ++k)
      if (network.edges[k].bars == hinge) hinges.push_back(network.edges[k]);
    hinges_ = Graph(network.atoms, hinges);
    bonds_ = Graph(network.atoms, std::span(network.edges).first(network.bonds));
  }

  std::vector<std::array<std::uint32_t, size>> find() {
    for (std::uint32_t atom = 0; atom < hinges_.node_count(); ++atom) {
      way_.assign(1, atom);
      go_on();
    }
    return std::move(found_);
  }

 private:
  /// Goes from the lowest atom of a ring towards the lower of the two beside it: each ring once.
  void go_on() {
    for (const Link& link : hinges_.at(way_.back())) {
      if (link.node <= way_.front() || !extends(link.node)) continue;
      way_.push_back(link.node);
      if (way_.size() < size)
        go_on();
      else
        close();
      way_.pop_back();
    }
  }

  /// Whether it is new, and bonded to none of the way but its end; the sixth to its beginning too.
  bool extends(std::uint32_t atom) const {
    for (std::size_t k = 0; k + 1 < way_.size(); ++k)
      if (way_[k] == atom || (are_bonded(way_[k], atom) && (k > 0 || way_.size() + 1 < size)))
        return false;
    return true;
  }

  bool are_bonded(std::uint32_t a, std::uint32_t b) const {
    const auto links = bonds_.at(a);
    return std::any_of(links.begin(), links.end(), [&](const Link& at) { return at.node == b; });
  }

  void close() {
    const auto links = hinges_.at(way_.back());
    const bool is_closed = std::any_of(links.begin(), links.end(),
                                       [&](const Link& link) { return link.node == way_.front(); });
    if (!is_closed || way_[1] > way_.back()) return;
    std::array<std::uint32_t, size> ring{};
    std::copy(way_.begin(), way_.end(), ring.begin());
    found_.push_back(ring);
  }

  Graph hinges_, bonds_;
  std::vector<std::uint32_t> way_;
  std::vector<std::array<std::uint32_t, size>> found_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 6>> rings_of_six(const RigidityNetwork& network) {
  return RingsOfSix(network).find();
}

std::string note_on_rings_of_six(std::size_t rings) {
  if (rings == 0) return "";
  return std::to_string(rings) + (rings == 1 ? " ring" : " rings") +
         " of six bonds that may turn: counted as rigid. At fixed angles a chair is, but a boat "
         "moves through twist-boats, which a count cannot see";
}

}  // namespace pliant
