// SPDX-License-Identifier: MIT
// Makes test sets: random graphs, forces and orderings in folders.
#pragma once

#include <filesystem>

#include "pliant/lab/test_sets/test_set.hpp"

namespace pliant {

/// What make_test_set() makes.
struct TestSetOptions {
  TestSettings settings = {};
  std::vector<std::string> classes = {};  ///< names in graph_classes(); empty: all
  std::int64_t graphs = 20;               ///< of each class, from 1
  std::int64_t force_files = 1;           ///< number of files with the forces of a graph
  /// Names in techniques(), each used for the classes that it resolves; empty: every row of
  /// orderings() except `input`.
  std::vector<std::string> techniques = {};
  std::vector<double> weightings = {0.5, 0.75, 1.0};
  std::function<void(std::int64_t)> on_graph = {};  ///< called with the number of graphs written
};

/// Makes the graphs, forces and orderings and writes them into `directory`, which must be new or
/// empty; results.xml is written last. Graph k of a class is generate() with walker = k, and its
/// forces are random_pushes() with the same key: the contents depend only on the options. Throws
/// OptionError naming an option that is out of its range; FileError.
/// Throws OptionError naming an option that is out of its range; FileError.
TestSet make_test_set(const std::filesystem::path& directory, const TestSetOptions& options = {});

}  // namespace pliant
