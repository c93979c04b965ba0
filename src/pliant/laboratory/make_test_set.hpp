// SPDX-License-Identifier: MIT
// Making test sets: random graphs, forces and orderings in folders.
#pragma once

#include <filesystem>

#include "pliant/laboratory/test_set.hpp"

namespace pliant {

/// What make_test_set() makes.
struct TestSetOptions {
  TestSettings settings = {};
  std::vector<std::string> classes = {};  ///< names in graph_classes(); empty: all
  std::int64_t graphs = 20;               ///< of each class, from 1
  std::int64_t force_files = 1;           ///< files that the forces of a graph are spread over
  /// Names in techniques(), each for the classes that it resolves; empty: every row of orderings()
  /// but `input`.
  std::vector<std::string> techniques = {};
  std::vector<double> weightings = {0.5, 0.75, 1.0};
  std::function<void(std::int64_t)> on_graph = {};  ///< told how many graphs are written
};

/// Makes the graphs, forces and orderings and writes them into `directory`, which must be new or
/// empty; results.xml comes last. Graph k of a class is generate() with walker = k, its forces are
/// random_pushes() with the same key: what it holds depends on the options alone.
/// Throws OptionError naming an option that is out of its range; FileError.
TestSet make_test_set(const std::filesystem::path& directory, const TestSetOptions& options = {});

}  // namespace pliant
