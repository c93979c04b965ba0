// SPDX-License-Identifier: MIT
#include "pliant/resolve/auto.hpp"

#include <algorithm>
#include <vector>

#include "pliant/framework/graph.hpp"
#include "pliant/resolve/method/method.hpp"
#include "pliant/resolve/method/moved_joints.hpp"
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

std::size_t joints_with_bars(const Framework& framework) {
  std::size_t count = 0;
  for (Joint joint = 0; joint < framework.joint_count(); ++joint)
    count += framework.neighbours(joint).empty() ? 0 : 1;
  return count;
}

/// Bars across bond angles make triangles with the bonds: then most bars are in one.
bool is_mostly_triangles(const Framework& framework) {
  // A triangle is two bars more for one joint: fewer bars cannot be mostly triangles. Joints
  // without bars (ions, dummy sites of waters) do not count.
  if (framework.bar_count() < joints_with_bars(framework)) return false;
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

/// Whether a component has joints that move and several that do not: bars between pinned joints
/// are not free to follow a pass. Components that are pinned as a whole stand still and bind none.
bool has_bound_component(const Framework& framework) {
  if (framework.pinned_count() <= 1) return false;
  const Components components = find_components(framework);
  std::vector<std::size_t> pinned(components.count, 0), all(components.count, 0);
  for (Joint joint = 0; joint < framework.joint_count(); ++joint) {
    ++all[components.of_node[joint]];
    pinned[components.of_node[joint]] += framework.is_pinned(joint) ? 1 : 0;
  }
  for (std::size_t c = 0; c < components.count; ++c)
    if (pinned[c] > 1 && pinned[c] < all[c]) return true;
  return false;
}

std::string counted(std::size_t number, const char* what) {
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

Choice chosen(const char* name, const Technique& asked, std::string why) {
  return {{name, 0.5, asked.mass_weighted}, std::move(why)};
}

/// A technique, and those that take over in their order where it does not arrive.
struct Chain {
  std::string_view first;
  std::vector<std::string_view> others;
};

/// `shake` goes along the bars as they were before the push, so large rings that are pushed far
/// follow it where Newton's method loses its way; sweeps arrive where matrices are singular.
const std::vector<Chain>& chains() {
  static const std::vector<Chain> rows = {{"blocks", {"shake", "newton", "anderson"}},
                                          {"units", {"shake", "newton", "anderson"}},
                                          {"newton", {"shake", "anderson"}}};
  return rows;
}

std::vector<std::string_view> others_than(std::string_view first) {
  for (const Chain& chain : chains())
    if (chain.first == first) return chain.others;
  return {};
}

/// Sweeps that each technique may take before the next is asked: a hopeless push costs a time in
/// proportion to the size of the framework, and is then taken back. Where there is nothing to go
/// back to, the last technique goes on as long as the caller allows.
constexpr std::int64_t most_sweeps_of_one = 20;

class Automatic final : public Method {
 public:
  Automatic(const Framework& framework, const Technique& technique, const ResolveOptions& options)
      : framework_(framework),
        options_(options),
        technique_(choose_technique(framework, technique).technique),
        others_(others_than(technique_.name)),
        methods_(1 + others_.size()) {
    method(0, true);
  }

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    for (std::size_t k = 0;; ++k) {
      const Stop stop = method(k, !call.reference.empty()).resolve(call, summary);
      if (stop == Stop::converged || stop == Stop::stopped_by_caller) return stop;
      if (k == others_.size() || summary.sweeps >= options_.max_sweeps) return give_up(call, stop);
      put_back(call);
    }
  }

  bool looks_near() const override { return methods_[0]->looks_near(); }
  void prepare_near() override { methods_[0]->prepare_near(); }

 private:
  /// Made when it is needed first. A chain's last is not `limited` where nothing is before the
  /// push.
  Method& method(std::size_t k, bool limited) {
    std::unique_ptr<Method>& made = k > 0 && k == others_.size() && !limited ? last_ : methods_[k];
    if (made) return *made;
    ResolveOptions options = options_;
    if (!others_.empty() && &made != &last_)
      options.max_sweeps = std::min(options.max_sweeps, most_sweeps_of_one * std::int64_t(k + 1));
    Technique technique = technique_;
    if (k > 0) technique.name = others_[k - 1];
    made = find_technique(technique.name).make(framework_, technique, options);
    return *made;
  }

  /// Puts joints back to where the push left them.
  static void put_back(const ResolveCall& call) {
    if (call.moved != nullptr) {
      call.moved->put_back(call.positions);
      call.moved->note_all(call.positions);
    } else {
      std::copy(call.pushed.begin(), call.pushed.end(), call.positions.begin());
    }
  }

  /// Goes back to before the push if all bars were whole there, so that the next step begins whole.
  Stop give_up(const ResolveCall& call, Stop stop) const {
    if (others_.empty() || call.reference.empty()) return stop;
    if (!is_whole(framework_, call.reference, options_.tolerance)) return stop;
    if (call.moved != nullptr && !call.moved->holds_all()) {
      call.moved->put_back(call.positions);
      call.moved->note_all(call.positions);
    }
    std::copy(call.reference.begin(), call.reference.end(), call.positions.begin());
    return stop;
  }

  const Framework& framework_;
  ResolveOptions options_;
  Technique technique_;
  std::vector<std::string_view> others_;
  std::vector<std::unique_ptr<Method>> methods_;
  std::unique_ptr<Method> last_;  ///< the last of methods_ without its limit of sweeps
};

}  // namespace

Choice choose_technique(const Framework& framework, const Technique& asked) {
  if (!framework.has_bars_only() && !framework.is_planar() && is_mostly_triangles(framework))
    return chosen("froda", asked, "limits beside rigid units: torsions that know them");
  if (!framework.has_bars_only())
    return chosen("anderson", asked, "limits beside the bars: sweeps know them, accelerated");
  const GraphFacts facts = graph_facts(framework);
  const bool is_bound = has_bound_component(framework);
  if (facts.is_forest() && !is_bound)
    return chosen("blocks", asked, "the bars close no cycle: one outward pass makes them whole");
  if (is_bound)
    return chosen("newton", asked, "several joints are pinned: all bars are solved together");
  if (has_hubs(framework))
    return chosen("anderson", asked, "joints of many bars: sweeps, accelerated");
  if (!framework.is_planar() && has_large_blocks(facts) && is_mostly_triangles(framework))
    return chosen("units", asked, "most bars are in triangles: rigid units in one outward pass");
  return chosen("blocks", asked,
                counted(facts.blocks, "ring system") + ", each by Newton's method, and " +
                    counted(facts.bridges, "bridge") + " in one outward pass");
}

bool forms_rigid_units(const Framework& framework) {
  return !framework.is_planar() && is_mostly_triangles(framework) &&
         has_large_blocks(graph_facts(framework));
}

Technique technique_used(const Framework& framework, const Technique& technique) {
  return technique.name == "auto" ? choose_technique(framework, technique).technique : technique;
}

std::unique_ptr<Method> make_automatic(const Framework& framework, const Technique& technique,
                                       const ResolveOptions& options) {
  return std::make_unique<Automatic>(framework, technique, options);
}

}  // namespace pliant
