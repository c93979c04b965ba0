// SPDX-License-Identifier: MIT
#include "pliant/lab/test_sets/test_results.hpp"

#include "support/test.hpp"

namespace pliant::test_results_test {

const std::string heading = "force,sweeps,passes,projections,converged,final_residual\n";

std::vector<TestRow> rows_of(std::initializer_list<std::int64_t> sweeps) {
  std::vector<TestRow> rows;
  for (std::int64_t count : sweeps) rows.push_back({count, count, 10 * count, true, 0.5});
  return rows;
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
  EXPECT_EQ(write_test_rows(parse_test_rows({"results.csv", text})), text);
}

TEST(TestRows, NameTheColumnThatIsWrong) {
  EXPECT_ERROR(InputError, "results.csv:2: projections: expected a whole number from 0, found \"\"",
               parse_test_rows({"results.csv", heading + "0,3,2,,true,0"}));
  EXPECT_ERROR(InputError,
               "results.csv:2: final_residual: expected a finite number from 0, found \"-1\"",
               parse_test_rows({"results.csv", heading + "0,3,2,75,true,-1"}));
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
