// SPDX-License-Identifier: MIT
#include "pliant/lab/test_sets/test_set.hpp"

#include "pliant/framework/graph.hpp"
#include "pliant/lab/test_sets/make_test_set.hpp"
#include "pliant/lab/test_sets/read_test_set.hpp"
#include "support/test.hpp"

namespace pliant::test_set_test {

using testing::HasSubstr;

namespace fs = std::filesystem;

class TestSets : public testing::Test {
 protected:
  static TestSetOptions small() {
    return {.settings = {.seed = 18446744073709551615u, .forces = 5},
            .classes = {"tree", "2-cycle-path"},
            .graphs = 2,
            .techniques = {"bfs_tree", "random", "blocks"},
            .weightings = {0.5, 1.0}};
  }

  TestSet make() const { return make_test_set(folder_, small()); }

  std::string text_of(const fs::path& path) const { return test::content_of(folder_ / path); }

  /// Every file below the folder with its bytes.
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
      const std::string name = fs::relative(entry.path(), folder_).string();
      files[name] = entry.is_regular_file() ? text_of(name) : "";
    }
    return files;
  }

  /// What reading says once `from` in a file is `to`.
  std::string refusal(const fs::path& path, const std::string& from, const std::string& to) const {
    const std::string whole = text_of(path);
    const std::size_t at = whole.find(from);
    EXPECT_NE(at, std::string::npos) << whole;
    std::ofstream(folder_ / path) << std::string(whole).replace(at, from.size(), to);
    const std::string text = test::error_text<InputError>([&] { read_test_set(folder_); });
    std::ofstream(folder_ / path) << whole;
    return text;
  }

  std::string place(const fs::path& path) const { return (fs::canonical(folder_) / path).string(); }

  const test::TempDirectory directory_;
  const fs::path folder_ = directory_ / "set";
};

std::vector<TestRow> rows_for(const TestGraph& graph) {
  std::vector<TestRow> rows;
  for (std::size_t k = 0; k < graph.pushes().size(); ++k)
    rows.push_back({std::int64_t(k + 1), std::int64_t(k), 10, k != 2, 1e-3 / double(k + 3)});
  return rows;
}

TEST_F(TestSets, AreTheFoldersOfFigure4_6) {
  make();
  std::vector<std::string> names;
  for (const auto& [name, bytes] : contents())
    if (!name.starts_with("2-cycle-path/graph-001") && !name.starts_with("tree/graph-001"))
      names.push_back(name);
  EXPECT_THAT(
      names,
      testing::ElementsAre(
          "2-cycle-path", "2-cycle-path/graph-000", "2-cycle-path/graph-000/graph.xml",
          "2-cycle-path/graph-000/heuristics", "2-cycle-path/graph-000/heuristics/blocks-0.5",
          "2-cycle-path/graph-000/heuristics/forces",
          "2-cycle-path/graph-000/heuristics/forces/forces-0.txt",
          "2-cycle-path/graph-000/heuristics/random-0.5",
          "2-cycle-path/graph-000/heuristics/random-1", "2-cycle-path/graph-000/ordering.txt",
          "results.xml", "tree", "tree/graph-000", "tree/graph-000/graph.xml",
          "tree/graph-000/heuristics", "tree/graph-000/heuristics/bfs_tree-0.5",
          "tree/graph-000/heuristics/bfs_tree-1", "tree/graph-000/heuristics/blocks-0.5",
          "tree/graph-000/heuristics/forces", "tree/graph-000/heuristics/forces/forces-0.txt",
          "tree/graph-000/heuristics/random-0.5", "tree/graph-000/heuristics/random-1",
          "tree/graph-000/ordering.txt"));
}

TEST_F(TestSets, AreReadBackAsTheyWereMade) {
  const TestSet made = make(), back = read_test_set(folder_);
  EXPECT_EQ(back.settings.seed, 18446744073709551615u);
  EXPECT_EQ(back.classes[1].name, made.classes[1].name);
  const TestGraph &one = made.classes[1].graphs[1], &two = back.classes[1].graphs[1];
  EXPECT_EQ(one.graph.positions, two.graph.positions);
  EXPECT_EQ(one.graph.cycles, two.graph.cycles);
  EXPECT_TRUE(
      std::ranges::equal(one.graph.framework.rest_lengths(), two.graph.framework.rest_lengths()));
  ASSERT_EQ(two.pushes().size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(one.pushes()[k].force, two.pushes()[k].force);
  const auto before = contents();
  back.save();
  EXPECT_EQ(contents(), before);
}

/// Graph and forces are those that generate() and a run of that walker have.
TEST_F(TestSets, HoldGraphsThatGenerateMakes) {
  const TestSet set = make();
  const RandomKey key{.seed = small().settings.seed, .walker = 1};
  const GeneratedGraph made = generate(find_graph_class("2-cycle-path"), {}, key);
  const TestGraph& graph = set.class_named("2-cycle-path").graphs[1];
  EXPECT_EQ(graph.graph.positions, made.positions);
  const std::vector<JointForce> pushes = random_pushes(made.framework, {}, key, 5);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(graph.pushes()[k].force, pushes[k].force);
}

TEST_F(TestSets, SpreadForcesOverFiles) {
  TestSetOptions options = small();
  options.force_files = 2;
  const TestSet set = make_test_set(folder_, options), back = read_test_set(folder_);
  const TestGraph& graph = back.classes[0].graphs[0];
  ASSERT_EQ(graph.force_files.size(), 2u);
  EXPECT_EQ(graph.force_files[0].pushes.size(), 2u);
  EXPECT_EQ(graph.force_files[1].pushes.size(), 3u);
}

TEST_F(TestSets, OfferEveryTechniqueOfTheThesisToEachClassItResolves) {
  TestSetOptions options;
  options.graphs = options.settings.forces = 1;
  const TestSet set = make_test_set(folder_, options);
  EXPECT_EQ(set.classes.size(), graph_classes().size());
  for (const TestClass& kind : set.classes) {
    std::size_t expected = 0;
    for (const OrderingEntry& row : orderings())
      expected += row.name != "input" && (kind.family == "tree" || !row.forests_only) ? 3 : 0;
    EXPECT_EQ(kind.graphs[0].heuristics.size(), expected) << kind.name;
  }
}

TEST_F(TestSets, KeepResults) {
  TestSet set = make();
  const TestGraph& graph = set.classes[1].graphs[0];
  const TestPlace known{"2-cycle-path", 0, "random", 0.5}, added{"2-cycle-path", 0, "input", 0.25};
  const std::vector<TestRow> rows = rows_for(graph);
  const TestHeuristic* first = &graph.heuristics[0];
  EXPECT_EQ(set.write_results(known, rows), summary_of(rows));
  set.write_results(added, rows);
  EXPECT_EQ(first, &graph.heuristics[0]);
  EXPECT_FALSE(read_test_set(folder_).classes[1].graphs[0].heuristics[0].results);
  set.save();
  const TestSet back = read_test_set(folder_);
  EXPECT_EQ(back.classes[1].graphs[0].heuristics.size(), graph.heuristics.size());
  for (const TestPlace& where : {known, added})
    EXPECT_EQ(write_test_rows(back.read_results(where)), write_test_rows(rows));
}

TEST_F(TestSets, RefuseResultsThatDoNotFit) {
  TestSet set = make();
  std::vector<TestRow> rows = rows_for(set.classes[0].graphs[0]);
  const auto option_error = [&](const TestPlace& where) {
    return test::error_text<OptionError>([&] { set.write_results(where, rows); });
  };
  EXPECT_EQ(option_error({"trees", 0, "random", 0.5}),
            "no class in the test set named \"trees\" (did you mean \"tree\"?); known: tree, "
            "2-cycle-path");
  EXPECT_EQ(option_error({"tree", 2, "random", 0.5}), "graph = 2: class tree has 2 graphs, from 0");
  EXPECT_THAT(option_error({"tree", 0, "jostle", 0.5}), HasSubstr("no technique named"));
  EXPECT_EQ(option_error({"tree", 0, "random", 1.5}), "weighting = 1.5: must be from 0 to 1");
  rows.pop_back();
  EXPECT_ERROR(InputError, "results of tree/graph-000: expected 5 rows, one a push, found 4",
               set.write_results({"tree", 0, "random", 0.5}, rows));
  EXPECT_ERROR(OptionError, "no results of random with weighting 0.5 on tree/graph-000",
               set.read_results({"tree", 0, "random", 0.5}));
}

TEST_F(TestSets, NoticeATableThatResultsXmlDoesNotSumUp) {
  TestSet set = make();
  const TestPlace where{"tree", 0, "random", 0.5};
  set.write_results(where, rows_for(set.classes[0].graphs[0]));
  const fs::path table = "tree/graph-000/heuristics/random-0.5/results.csv";
  std::ofstream(folder_ / table) << "force,sweeps,passes,projections,converged,final_residual\n"
                                    "0,1,1,1,true,0\n";
  EXPECT_ERROR(InputError, place(table) + ": is not the table that results.xml sums up",
               set.read_results(where));
}

TEST_F(TestSets, AreRefusedWithFileLineAndField) {
  make();
  const std::string xml = place("results.xml");
  const struct {
    const char *from, *to, *text;
  } cases[] = {
      {"version=\"1\"", "version=\"2\"", ":2: test_set: version: expected \"1\", found \"2\""},
      {"seed=\"18446744073709551615\"", "seed=\"-1\"",
       ":2: test_set: seed: expected a whole number from 0 to 18446744073709551615, found \"-1\""},
      {"timestep=\"0.01\"", "timestep=\"0\"",
       ":2: test_set: timestep: expected a number above 0, found \"0\""},
      {"family=\"tree\"", "family=\"n-cycle\"",
       ":3: class: family: expected \"tree\", found \"n-cycle\""},
      {"class name=\"tree\"", "class name=\"twig\"",
       ":3: class: name: no class of graphs named \"twig\""},
      {"xml=\"tree/graph-000/", "xml=\"../graph-000/",
       ":4: graph: xml: expected \"tree/graph-000/graph.xml\", found \"../graph-000/graph.xml\""},
      {"number=\"1\"", "number=\"2\"", ":12: graph: number: expected \"1\", found \"2\""},
      {"technique=\"random\"", "technique=\"rnd\"",
       ":8: heuristic: technique: no technique named \"rnd\""},
      {"weighting=\"0.5\"", "weighting=\"half\"",
       ":6: weighting: expected a finite number, found \"half\""},
      {"<class", "<kind/><class", ":3: expected class, found \"kind\""},
      {"<?xml", "<!DOCTYPE a [<!ENTITY b SYSTEM \"/etc/passwd\">]><?xml",
       ":1: a document type (DTD) is not read"},
  };
  for (const auto& [from, to, text] : cases)
    EXPECT_THAT(refusal("results.xml", from, to), testing::StartsWith(xml + text));
}

TEST_F(TestSets, AreRefusedWhenAFileIsNotTheirs) {
  make();
  const fs::path forces = "tree/graph-000/heuristics/forces/forces-0.txt";
  EXPECT_EQ(refusal(forces, "max_sweeps 10000", "max_sweeps 10"),
            place(forces) +
                ": expected the timestep, tolerance_length and max_sweeps of results.xml, found "
                "others");
  EXPECT_EQ(refusal(forces, "push ", "# "),
            place(forces) + ": expected 5 pushes, as results.xml has it, found 4");
  fs::copy_file(folder_ / "2-cycle-path/graph-000/graph.xml", folder_ / "tree/graph-000/graph.xml",
                fs::copy_options::overwrite_existing);
  EXPECT_ERROR(
      InputError,
      place("tree/graph-000/graph.xml") +
          ": expected a graph of class tree: 1 component and 0 independent cycles, found 1 "
          "and 2",
      read_test_set(folder_));
  fs::remove(folder_ / "tree/graph-000/graph.xml");
  EXPECT_THROW(read_test_set(folder_), FileError);
}

TEST_F(TestSets, NeedAnEmptyFolderAndOptionsInTheirRange) {
  make();
  EXPECT_ERROR(FileError, folder_.string() + ": a test set is made in an empty folder", make());
  const std::pair<const char*, std::function<void(TestSetOptions&)>> cases[] = {
      {"graphs = 0: must be from 1", [](auto& options) { options.graphs = 0; }},
      {"forces = 0: must be from 1", [](auto& options) { options.settings.forces = 0; }},
      {"force_files = 6: must be at most the forces, 5",
       [](auto& options) { options.force_files = 6; }},
      {"ring = 2: must be from 3", [](auto& options) { options.settings.sizes.ring = 2; }},
      {"tolerance_length = 0: must be positive and finite",
       [](auto& options) { options.settings.tolerance_length = 0; }},
      {"weighting = 2: must be from 0 to 1", [](auto& options) { options.weightings = {2}; }},
      {"classes: tree is given twice",
       [](auto& options) {
         options.classes = {"tree", "tree"};
       }},
  };
  for (const auto& [text, change] : cases) {
    TestSetOptions options = small();
    change(options);
    EXPECT_ERROR(OptionError, text, make_test_set(folder_, options));
  }
}

}  // namespace pliant::test_set_test
