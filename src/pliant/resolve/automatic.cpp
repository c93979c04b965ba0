// SPDX-License-Identifier: MIT
#include "pliant/resolve/automatic.hpp"

#include <algorithm>
#include <vector>

#include "pliant/framework/graph.hpp"
#include "pliant/resolve/method/method.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant {
namespace {

bool share_a_neighbour(const Framework& framework, Bar bar, std::vector<std::uint8_t>& marked) {
  for (const Incidence& at : framework.neighbours(bar.a)) marked[at.joint] = 1;
  const auto beside_b = framework.neighbours(bar.b);
  const bool found = std::any_of(beside_b.begin(), beside_b.end(),
                                 [&](const Incidence& at) { return marked[at.joint] != 0; });
  for (const Incidence& at : framework.neighbours(bar.a)) marked[at.joint] = 0;
  return found;
}

/// Bars across bond angles make triangles with the bonds: then most bars are in one.
bool is_mostly_triangles(const Framework& framework) {
  // A triangle is two bars more for one joint: fewer bars cannot be mostly triangles.
  if (framework.bar_count() < framework.joint_count()) return false;
  std::vector<std::uint8_t> marked(framework.joint_count(), 0);
  std::size_t in_triangles = 0;
  for (const Bar& bar : framework.bars())
    in_triangles += share_a_neighbour(framework, bar, marked) ? 1 : 0;
  return 2 * in_triangles > framework.bar_count();
}

/// Whether parts are large enough to be placed as rigid units: of up to the six bars of a
/// tetrahedron (rigid water has three) none depends on others, and Newton is quicker.
bool has_large_blocks(const GraphFacts& facts) {
  constexpr std::size_t bars_of_tetrahedron = 6;
  return facts.largest_block > bars_of_tetrahedron;
}

/// Whether a joint has so many bars that equations which couple all bars of a joint do not pay.
bool has_hubs(const Framework& framework) {
  constexpr std::size_t most_bars = 64;
  for (Joint joint = 0; joint < framework.joint_count(); ++joint)
    if (framework.neighbours(joint).size() > most_bars) return true;
  return false;
}

std::string counted(std::size_t number, const char* what) {
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

Choice chosen(const char* name, const Technique& asked, std::string why) {
  return {{name, 0.5, asked.mass_weighted}, std::move(why)};
}

class Automatic final : public Method {
 public:
  Automatic(const Framework& framework, const Technique& technique, const ResolveOptions& options)
      : technique_(choose_technique(framework, technique).technique),
        method_(find_technique(technique_.name).make(framework, technique_, options)) {}

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    return method_->resolve(call, summary);
  }
  bool looks_near() const override { return method_->looks_near(); }

 private:
  Technique technique_;
  std::unique_ptr<Method> method_;
};

}  // namespace

Choice choose_technique(const Framework& framework, const Technique& asked) {
  if (!framework.has_bars_only())
    return chosen("anderson", asked, "limits beside the bars: sweeps know them, accelerated");
  const GraphFacts facts = graph_facts(framework);
  if (facts.is_forest() && framework.pinned_count() <= 1)
    return chosen("blocks", asked, "the bars close no cycle: one outward pass makes them whole");
  if (framework.pinned_count() > 1)
    return chosen("newton", asked, "several joints are pinned: all bars are solved together");
  if (has_hubs(framework))
    return chosen("anderson", asked, "joints of many bars: sweeps, accelerated");
  if (!framework.is_planar() && has_large_blocks(facts) && is_mostly_triangles(framework))
    return chosen("units", asked, "most bars are in triangles: rigid units in one outward pass");
  return chosen("blocks", asked,
                counted(facts.blocks, "ring system") + ", each by Newton's method, and " +
                    counted(facts.bridges, "bridge") + " in one outward pass");
}

Technique technique_used(const Framework& framework, const Technique& technique) {
  return technique.name == "auto" ? choose_technique(framework, technique).technique : technique;
}

std::unique_ptr<Method> make_automatic(const Framework& framework, const Technique& technique,
                                       const ResolveOptions& options) {
  return std::make_unique<Automatic>(framework, technique, options);
}

}  // namespace pliant
