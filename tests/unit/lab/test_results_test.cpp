// SPDX-License-Identifier: MIT
#include "pliant/lab/test_sets/test_results.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pliant/base/error.hpp"
#include "support/error_text.hpp"

namespace pliant::test_results_test {

const std::string heading = "force,sweeps,passes,projections,converged,final_residual\n";

std::vector<TestRow> rows_of(std::initializer_list<std::int64_t> sweeps) {
  std::vector<TestRow> rows;
  for (std::int64_t count : sweeps) rows.push_back({count, count, 10 * count, true, 0.5});
  return rows;
}

std::string refusal(const std::string& lines) {
  return test::error_text<InputError>([&] { parse_test_rows({"results.csv", heading + lines}); });
}

TEST(TestSummary, SumsUpSweeps) {
  const TestSummary summary = summary_of(rows_of({2, 4, 4, 4, 5, 5, 7, 9}));
  EXPECT_EQ(summary.forces, 8);
  EXPECT_EQ(summary.converged, 8);
  EXPECT_EQ(summary.mean, 5.0);
  EXPECT_EQ(summary.mode, 4);
  EXPECT_DOUBLE_EQ(summary.sd, std::sqrt(32.0 / 7.0));
}

TEST(TestSummary, TakesTheSmallestOfEqualModesAndNoSpreadOfOneForce) {
  EXPECT_EQ(summary_of(rows_of({7, 3, 3, 7, 5})).mode, 3);
  EXPECT_EQ(summary_of(rows_of({6})), (TestSummary{1, 1, 6.0, 6, 0.0}));
  EXPECT_THROW(summary_of({}), InputError);
}

TEST(TestSummary, CountsWhatConverged) {
  std::vector<TestRow> rows = rows_of({1, 2, 3});
  rows[1].converged = false;
  EXPECT_EQ(summary_of(rows).converged, 2);
}

TEST(TestRows, AreReadBackToTheSameBits) {
  const std::vector<TestRow> rows{{3, 2, 75, true, 1.0 / 3.0}, {0, 0, 0, false, 0.0}};
  const std::string text = write_test_rows(rows);
  EXPECT_EQ(text, heading + "0,3,2,75,true,0.3333333333333333\n1,0,0,0,false,0\n");
  const std::vector<TestRow> back = parse_test_rows({"results.csv", text});
  ASSERT_EQ(back.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(back[k].sweeps, rows[k].sweeps);
    EXPECT_EQ(back[k].passes, rows[k].passes);
    EXPECT_EQ(back[k].projections, rows[k].projections);
    EXPECT_EQ(back[k].converged, rows[k].converged);
    EXPECT_EQ(back[k].final_residual, rows[k].final_residual);
  }
}

TEST(TestRows, NameTheColumnThatIsWrong) {
  EXPECT_EQ(refusal("1,3,2,75,true,0"),
            "results.csv:2: force: expected 0, the next one, found \"1\"");
  EXPECT_EQ(refusal("0,3,2,75,true,0\n0,3,2,75,true,0"),
            "results.csv:3: force: expected 1, the next one, found \"0\"");
  EXPECT_EQ(refusal("0,-3,2,75,true,0"),
            "results.csv:2: sweeps: expected a whole number from 0, found \"-3\"");
  EXPECT_EQ(refusal("0,3,2.5,75,true,0"),
            "results.csv:2: passes: expected a whole number from 0, found \"2.5\"");
  EXPECT_EQ(refusal("0,3,2,,true,0"),
            "results.csv:2: projections: expected a whole number from 0, found \"\"");
  EXPECT_EQ(refusal("0,3,2,75,True,0"),
            "results.csv:2: converged: expected true or false, found \"True\"");
  EXPECT_EQ(refusal("0,3,2,75,true,nan"),
            "results.csv:2: final_residual: expected a finite number from 0, found \"nan\"");
  EXPECT_EQ(refusal("0,3,2,75,true,-1"),
            "results.csv:2: final_residual: expected a finite number from 0, found \"-1\"");
  EXPECT_EQ(refusal("0,3,2,75,true"), "results.csv:2: expected 6 fields, found 5");
  EXPECT_EQ(
      test::error_text<InputError>([] {
        parse_test_rows({"results.csv", "a,b\n"});
      }),
      "results.csv:1: expected \"" + heading.substr(0, heading.size() - 1) + "\", found \"a,b\"");
}

TEST(TestRows, AreNotWrittenWithNumbersThatAreNone) {
  const auto refusal_to_write = [](const TestRow& row) {
    return test::error_text<InputError>([&] { write_test_rows(std::vector<TestRow>{row}); });
  };
  EXPECT_EQ(refusal_to_write({-1, 0, 0, true, 0}),
            "results: force 0: sweeps = -1: must be finite and from 0");
  EXPECT_EQ(refusal_to_write({0, 0, 0, true, std::numeric_limits<double>::infinity()}),
            "results: force 0: final_residual = inf: must be finite and from 0");
}

}  // namespace pliant::test_results_test
