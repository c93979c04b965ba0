// SPDX-License-Identifier: MIT
#include "corpus/laboratory_text.hpp"

#include <sstream>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/lab/test_sets/test_results.hpp"
#include "pliant/molecule/bars_file.hpp"
#include "pliant/order/ordering_file.hpp"
#include "pliant/perturb/force_files/force_file.hpp"
#include "pliant/record/xml/graph_xml.hpp"

namespace pliant {
namespace {

/// Joints a, b, c, d; bars ab, bc, ca, cd.
const Framework& kite() {
  static const GraphFile graph = parse_graph_xml(
      {"kite.xml",
       "<graph><joint id='a' x='0' y='0' z='0'/><joint id='b' x='1' y='0' z='0'/>"
       "<joint id='c' x='0' y='1' z='0'/><joint id='d' x='0' y='1' z='1'/>"
       "<bar a='a' b='b'/><bar a='b' b='c'/><bar a='c' b='a'/><bar a='c' b='d'/></graph>"});
  return graph.framework;
}

std::string text_of(Vec3 v) {
  return shortest_text(v.x) + " " + shortest_text(v.y) + " " + shortest_text(v.z);
}

void write(const GraphFile& graph, std::ostream& out) {
  const Framework& framework = graph.framework;
  for (Joint joint = 0; joint < framework.joint_count(); ++joint) {
    out << "joint " << framework.label(joint) << ' ' << text_of(graph.positions[joint]);
    if (framework.is_pinned(joint)) out << " pinned";
    const double inverse_mass = framework.inverse_masses()[joint];
    if (inverse_mass != 0.0 && inverse_mass != 1.0) out << " mass " << 1.0 / inverse_mass;
    out << '\n';
  }
  for (std::size_t k = 0; k < framework.bar_count(); ++k)
    out << "bar " << framework.label(framework.bars()[k]) << ' '
        << shortest_text(framework.rest_lengths()[k]) << '\n';
  for (const std::vector<Joint>& cycle : graph.cycles) {
    out << "cycle";
    for (Joint joint : cycle) out << ' ' << framework.label(joint);
    out << '\n';
  }
}

void write(const Ordering& ordering, std::ostream& out) {
  for (const OrderedBar& visit : ordering)
    out << "bar " << kite().label(kite().bars()[visit.bar]) << " from " << kite().label(visit.near)
        << (visit.is_tree ? " tree\n" : " non_tree\n");
}

void write(const ForceFile& file, std::ostream& out) {
  if (file.timestep) out << "timestep " << *file.timestep << '\n';
  if (file.tolerance) out << "tolerance " << *file.tolerance << '\n';
  if (file.tolerance_length) out << "tolerance_length " << *file.tolerance_length << '\n';
  if (file.max_sweeps) out << "max_sweeps " << *file.max_sweeps << '\n';
  for (const JointForce& push : file.pushes)
    out << "push " << kite().label(push.joint) << ' ' << text_of(push.force) << '\n';
}

void write(const std::vector<TestRow>& rows, std::ostream& out) {
  for (const TestRow& row : rows)
    out << row.sweeps << " sweeps, " << row.passes << " passes, " << row.projections
        << " projections, " << (row.converged ? "converged" : "not converged") << ", off by "
        << shortest_text(row.final_residual) << '\n';
  if (rows.empty()) out << "no force\n";
}

/// As a file that holds the same.
void write(const BarsFile& file, std::ostream& out) { out << write_bars_file(file, kite()); }

template <class Read>
std::string reading(Read read) {
  std::ostringstream out;
  try {
    write(read(out), out);
  } catch (const Error& error) {
    out << "error: " << error.what() << '\n';
  }
  return out.str();
}

std::string read_graph(const SourceText& source) {
  return reading([&](std::ostream& out) {
    const Log log{[&out](Severity, std::string_view text) { out << "warning: " << text << '\n'; }};
    return parse_graph_xml({source.name, without_byte_order_mark(source.text)}, log);
  });
}

std::string read_ordering(const SourceText& source) {
  return reading([&](std::ostream&) {
    return parse_ordering_file({source.name, without_byte_order_mark(source.text)}, kite());
  });
}

std::string read_forces(const SourceText& source) {
  return reading([&](std::ostream&) { return parse_force_file(source.text, source.name, kite()); });
}

std::string read_bars(const SourceText& source) {
  return reading([&](std::ostream&) {
    return parse_bars_file({source.name, without_byte_order_mark(source.text)}, kite());
  });
}

std::string read_results(const SourceText& source) {
  return reading([&](std::ostream&) { return parse_test_rows(source); });
}

constexpr LaboratoryFile table[] = {{"graph", read_graph},
                                    {"ordering", read_ordering},
                                    {"forces", read_forces},
                                    {"bars", read_bars},
                                    {"results", read_results}};

}  // namespace

std::span<const LaboratoryFile> laboratory_files() { return table; }

}  // namespace pliant
