// SPDX-License-Identifier: MIT
// Parts of a test set for Python: classes, graphs and heuristics, each of which keeps its set
// alive.
#pragma once

#include "bind.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/lab/test_sets/test_set.hpp"

namespace pliant::python {

/// A part of a test set, which it keeps alive.
template <class Row>
struct Part {
  const Row* row;
  nb::object set;

  /// The absolute path of a folder of the test set.
  std::string folder(const std::string& below) const {
    return path_text(nb::cast<TestSet&>(set).directory / below);
  }
};

using ClassPart = Part<TestClass>;
using GraphPart = Part<TestGraph>;

struct HeuristicPart : Part<TestHeuristic> {
  const TestGraph* graph;
};

/// TestClass, TestGraph, TestHeuristic and TestResults.
void bind_test_parts(nb::module_& module);

}  // namespace pliant::python
