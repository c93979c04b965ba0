// SPDX-License-Identifier: MIT
// Feeds bytes to a reader, of molecules and on to the framework, or of graphs, bars, orderings,
// forces and results, which are written and read again. Errors are right; crashes, hangs, numbers
// that are not finite, bonds to nowhere and other readings are not.
//
//   read_fuzz --format=pdb FOLDER...   fuzzes one format
//   read_fuzz --formats                lists them
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/lab/test_sets/test_results.hpp"
#include "pliant/molecule/bars_file.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/build_framework.hpp"
#include "pliant/molecule/read/read.hpp"
#include "pliant/order/ordering_file.hpp"
#include "pliant/perturb/force_files/force_file.hpp"
#include "pliant/record/xml/graph_xml.hpp"
#include "pliant/record/xml/write_graph_xml.hpp"

namespace {

using namespace pliant;

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

void check(const Structure& structure) {
  for (const Vec3 position : structure.positions)
    require(is_finite(position), "positions are finite");
  for (const Bond& bond : structure.bonds) {
    require(bond.a < bond.b, "a bond names its lower atom first");
    require(bond.b < structure.positions.size(), "a bond joins atoms of the structure");
  }
}

void read_molecule(std::string_view text, const std::string& format) {
  Structure structure = read_structure(SourceText{"fuzzed", text}, {.format = format});
  check(structure);
  perceive_bonds(structure);
  check(structure);
  build_framework(structure);
}

const Framework& some_framework() {
  static const GraphFile graph = parse_graph_xml(
      {"kite.xml",
       "<graph><joint id='a' x='0' y='0' z='0'/><joint id='b' x='1' y='0' z='0'/>"
       "<joint id='c' x='0' y='1' z='0'/><joint id='d' x='0' y='1' z='1'/>"
       "<bar a='a' b='b'/><bar a='b' b='c'/><bar a='c' b='a'/><bar a='c' b='d'/></graph>"});
  return graph.framework;
}

/// Each returns what was read as a file of the same format.
std::string graph_again(std::string_view text) {
  const GraphFile graph = parse_graph_xml({"fuzzed", text});
  for (const Vec3 position : graph.positions) require(is_finite(position), "positions are finite");
  return write_graph_xml(graph.framework, graph.positions, graph.cycles);
}
std::string bars_again(std::string_view text) {
  return write_bars_file(parse_bars_file({"fuzzed", text}, some_framework()), some_framework());
}
std::string ordering_again(std::string_view text) {
  return write_ordering_file(parse_ordering_file({"fuzzed", text}, some_framework()),
                             some_framework());
}
std::string forces_again(std::string_view text) {
  return write_force_file(parse_force_file(text, "fuzzed", some_framework()), some_framework());
}
std::string results_again(std::string_view text) {
  return write_test_rows(parse_test_rows({"fuzzed", text}));
}

struct Reader {
  std::string name;
  std::function<void(std::string_view text)> read;
};

std::vector<Reader> readers() {
  std::vector<Reader> all;
  for (const Format& format : formats()) {
    const std::string name(format.name);
    all.push_back({name, [name](std::string_view text) { read_molecule(text, name); }});
  }
  const std::pair<const char*, std::string (*)(std::string_view)> others[] = {
      {"graph", graph_again},
      {"bars", bars_again},
      {"ordering", ordering_again},
      {"forces", forces_again},
      {"results", results_again}};
  for (const auto& [name, again] : others)
    all.push_back({name, [again = again](std::string_view text) {
                     const std::string written = again(text);
                     require(again(written) == written, "what is written is read back");
                   }});
  return all;
}

std::function<void(std::string_view)> chosen;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  for (int i = 1; i < *count; ++i) {
    const std::string_view argument = (*arguments)[i];
    for (const Reader& row : readers()) {
      if (argument == "--format=" + row.name) chosen = row.read;
      if (argument == "--formats") std::puts(row.name.c_str());
    }
    if (argument == "--formats") std::exit(0);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  require(chosen != nullptr, "--format=NAME is given");
  try {
    chosen({reinterpret_cast<const char*>(bytes), size});
  } catch (const Error&) {  // what is wrong was said
  }
  return 0;
}
