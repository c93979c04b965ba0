// SPDX-License-Identifier: MIT
// Feeds bytes to the readers of graphs, bars, orderings, forces and results. Errors are right;
// crashes, hangs and numbers that are not finite are not; and what was read is written and read
// again.
//
//   read_laboratory_fuzz --format=graph FOLDER...   fuzzes one format
//   read_laboratory_fuzz --formats                  lists them
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "pliant/base/error.hpp"
#include "pliant/lab/test_sets/test_results.hpp"
#include "pliant/molecule/bars_file.hpp"
#include "pliant/order/ordering_file.hpp"
#include "pliant/perturb/force_files/force_file.hpp"
#include "pliant/record/xml/graph_xml.hpp"
#include "pliant/record/xml/write_graph_xml.hpp"

namespace {

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

const pliant::Framework& some_framework() {
  static const pliant::GraphFile graph = pliant::parse_graph_xml(
      {"kite.xml",
       "<graph><joint id='a' x='0' y='0' z='0'/><joint id='b' x='1' y='0' z='0'/>"
       "<joint id='c' x='0' y='1' z='0'/><joint id='d' x='0' y='1' z='1'/>"
       "<bar a='a' b='b'/><bar a='b' b='c'/><bar a='c' b='a'/><bar a='c' b='d'/></graph>"});
  return graph.framework;
}

void read_graph(std::string_view text) {
  const pliant::GraphFile graph = pliant::parse_graph_xml({"fuzzed", text});
  for (const pliant::Vec3 position : graph.positions)
    require(is_finite(position), "positions are finite");
  const auto write = [](const pliant::GraphFile& g) {
    return pliant::write_graph_xml(g.framework, g.positions, g.cycles);
  };
  const std::string written = write(graph);
  require(write(pliant::parse_graph_xml({"written", written})) == written, "graphs are read back");
}

void read_ordering(std::string_view text) {
  const pliant::Framework& framework = some_framework();
  const std::string written =
      write_ordering_file(parse_ordering_file({"fuzzed", text}, framework), framework);
  require(write_ordering_file(parse_ordering_file({"written", written}, framework), framework) ==
              written,
          "orderings are read back");
}

void read_forces(std::string_view text) {
  const pliant::Framework& framework = some_framework();
  const std::string written =
      write_force_file(pliant::parse_force_file(text, "fuzzed", framework), framework);
  require(write_force_file(pliant::parse_force_file(written, "written", framework), framework) ==
              written,
          "forces are read back");
}

void read_bars(std::string_view text) {
  const pliant::Framework& framework = some_framework();
  const std::string written =
      write_bars_file(pliant::parse_bars_file({"fuzzed", text}, framework), framework);
  require(write_bars_file(pliant::parse_bars_file({"written", written}, framework), framework) ==
              written,
          "bars are read back");
}

void read_results(std::string_view text) {
  const std::string written = write_test_rows(pliant::parse_test_rows({"fuzzed", text}));
  require(write_test_rows(pliant::parse_test_rows({"written", written})) == written,
          "results are read back");
}

struct Reader {
  std::string_view name;
  void (*read)(std::string_view text);
};
constexpr Reader readers[] = {{"graph", read_graph},
                              {"bars", read_bars},
                              {"ordering", read_ordering},
                              {"forces", read_forces},
                              {"results", read_results}};
const Reader* chosen = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  for (int i = 1; i < *count; ++i) {
    const std::string_view argument = (*arguments)[i];
    for (const Reader& row : readers) {
      if (argument == "--format=" + std::string(row.name)) chosen = &row;
      if (argument == "--formats")
        std::printf("%.*s\n", static_cast<int>(row.name.size()), row.name.data());
    }
    if (argument == "--formats") std::exit(0);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  require(chosen != nullptr, "--format=NAME is given");
  try {
    chosen->read({reinterpret_cast<const char*>(bytes), size});
  } catch (const pliant::Error&) {  // what is wrong was said
  }
  return 0;
}
