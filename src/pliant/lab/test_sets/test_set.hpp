// SPDX-License-Identifier: MIT
// Test sets (StructGen's test mode, thesis figure 4.6): random graphs of several classes in
// folders, each with its force files, an ordering file and a folder for each heuristic (technique
// and weighting); results.xml on top names everything.
//
//   results.xml
//   tree/graph-000/graph.xml
//   tree/graph-000/ordering.txt                         bfs_cycle from joint 0
//   tree/graph-000/heuristics/forces/forces-0.txt
//   tree/graph-000/heuristics/bfs_tree-0.5/results.csv  once an experiment has filled it
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pliant/lab/generate/random_graphs.hpp"
#include "pliant/lab/test_sets/test_results.hpp"
#include "pliant/order/ordering.hpp"
#include "pliant/perturb/force_files/force_file.hpp"
#include "pliant/record/xml/graph_xml.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant {

/// Settings shared by all graphs of a test set; kept in results.xml.
struct TestSettings {
  std::uint64_t seed = 0;
  std::int64_t forces = 50;        ///< number of pushes for each graph, from 1
  double force = 50.0;             ///< size of each, kJ/(mol Angstrom)
  double timestep = 0.01;          ///< ps
  double tolerance_length = 0.01;  ///< largest |length - rest| of a whole bar (Angstrom)
  std::int64_t max_sweeps = 10000;
  GenerateOptions sizes = {};
};

/// A technique with a weighting, and its results if known.
struct TestHeuristic {
  std::string technique;
  double weighting = 0.5;
  std::optional<TestSummary> results = {};

  std::string name() const;  ///< "bfs_cycle-0.5", the name of its folder
};

struct TestGraph {
  std::string folder;       ///< "tree/graph-000", below the folder of the test set
  std::int64_t number = 0;  ///< of the graph in its class
  GraphFile graph;
  Ordering ordering = {};
  std::vector<ForceFile> force_files = {};
  std::deque<TestHeuristic> heuristics = {};  ///< adding one does not move the others

  std::vector<JointForce> pushes() const;  ///< of all force files, in their order
};

struct TestClass {
  std::string name;  ///< in graph_classes()
  std::string family;
  std::vector<TestGraph> graphs = {};
};

/// Identifies a heuristic of a graph.
struct TestPlace {
  std::string_view kind;  ///< name of the class
  std::int64_t graph = 0;
  std::string_view technique;
  double weighting = 0.5;
};

struct TestSet {
  std::filesystem::path directory;  ///< absolute
  TestSettings settings;
  std::vector<TestClass> classes = {};

  /// Throws OptionError listing the existing names.
  const TestClass& class_named(std::string_view name) const;
  /// Writes results.xml atomically.
  void save() const;
  /// Writes the table of a heuristic, one row a push, and keeps its summary, which save() writes to
  /// results.xml. A heuristic that the set does not have is added. Throws OptionError for a class,
  /// graph or technique that is unknown; InputError for rows that are not one a push or contain
  /// invalid numbers; FileError.
  const TestSummary& write_results(const TestPlace& place, std::span<const TestRow> rows);
  /// Reads the table back. Throws OptionError if there is none, InputError if it contradicts
  /// results.xml.
  std::vector<TestRow> read_results(const TestPlace& place) const;
};

namespace test_set_paths {
inline constexpr std::string_view index_file = "results.xml";
inline constexpr std::string_view graph_file = "graph.xml";
inline constexpr std::string_view ordering_file = "ordering.txt";
inline constexpr std::string_view table_file = "results.csv";
std::string graph_folder(std::string_view kind, std::int64_t number);
std::string force_file(const TestGraph& graph, std::size_t k);
std::string heuristic(const TestGraph& graph, const TestHeuristic& heuristic);
}  // namespace test_set_paths

}  // namespace pliant
