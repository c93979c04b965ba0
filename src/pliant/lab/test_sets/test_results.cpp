// SPDX-License-Identifier: MIT
#include "pliant/lab/test_sets/test_results.hpp"

#include <cmath>
#include <map>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/text/text_lines.hpp"

namespace pliant {
namespace {

constexpr std::string_view heading = "force,sweeps,passes,projections,converged,final_residual";

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t from = 0;;) {
    const std::size_t comma = line.find(',', from);
    fields.push_back(line.substr(from, comma - from));
    if (comma == std::string_view::npos) return fields;
    from = comma + 1;
  }
}

[[noreturn]] void refuse(const Place& place, const char* column, std::string_view expected,
                         std::string_view found) {
  fail(place,
       std::string(column) + ": expected " + std::string(expected) + ", found " + quoted(found));
}

std::int64_t count_in(const Place& place, const char* column, std::string_view field) {
  const auto value = parse_integer(field);
  if (!value || *value < 0) refuse(place, column, "a whole number from 0", field);
  return *value;
}

bool truth_in(const Place& place, std::string_view field) {
  if (field != "true" && field != "false") refuse(place, "converged", "true or false", field);
  return field == "true";
}

double residual_in(const Place& place, std::string_view field) {
  const auto value = parse_real(field);
  if (!value || *value < 0.0) refuse(place, "final_residual", "a finite number from 0", field);
  return *value;
}

TestRow row_in(const Place& place, std::string_view line, std::size_t force) {
  const auto fields = fields_of(line);
  if (fields.size() != 6) fail(place, "expected 6 fields, found " + std::to_string(fields.size()));
  if (fields[0] != std::to_string(force))
    refuse(place, "force", std::to_string(force) + ", the next one", fields[0]);
  return {count_in(place, "sweeps", fields[1]), count_in(place, "passes", fields[2]),
          count_in(place, "projections", fields[3]), truth_in(place, fields[4]),
          residual_in(place, fields[5])};
}

void check_row(const TestRow& row, std::size_t force) {
  const auto require = [&](bool holds, const char* column, const std::string& found) {
    if (!holds)
      throw InputError("results: force " + std::to_string(force) + ": " + column + " = " + found +
                       ": must be finite and from 0");
  };
  require(row.sweeps >= 0, "sweeps", std::to_string(row.sweeps));
  require(row.passes >= 0, "passes", std::to_string(row.passes));
  require(row.projections >= 0, "projections", std::to_string(row.projections));
  require(row.final_residual >= 0.0 && std::isfinite(row.final_residual), "final_residual",
          number_text(row.final_residual));
}

}  // namespace

TestSummary summary_of(std::span<const TestRow> rows) {
  if (rows.empty()) throw InputError("results: no force was resolved");
  TestSummary summary;
  std::map<std::int64_t, std::int64_t> counts;
  double sum = 0.0, squares = 0.0;
  for (const TestRow& row : rows) {
    ++summary.forces;
    if (row.converged) ++summary.converged;
    sum += double(row.sweeps);
    ++counts[row.sweeps];
  }
  summary.mean = sum / double(rows.size());
  for (const TestRow& row : rows)
    squares += (double(row.sweeps) - summary.mean) * (double(row.sweeps) - summary.mean);
  if (rows.size() > 1) summary.sd = std::sqrt(squares / double(rows.size() - 1));
  std::int64_t most = 0;
  for (const auto& [sweeps, count] : counts)
    if (count > most) {
      most = count;
      summary.mode = sweeps;
    }
  return summary;
}

std::string write_test_rows(std::span<const TestRow> rows) {
  std::string text = std::string(heading) + "\n";
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const TestRow& row = rows[k];
    check_row(row, k);
    text += std::to_string(k) + "," + std::to_string(row.sweeps) + "," +
            std::to_string(row.passes) + "," + std::to_string(row.projections) + "," +
            (row.converged ? "true" : "false") + "," + shortest_text(row.final_residual) + "\n";
  }
  return text;
}

std::vector<TestRow> parse_test_rows(const SourceText& source) {
  Lines lines(source.text);
  lines.next();
  if (lines.line() != heading)
    fail({source.name, 1},
         "expected " + quoted(heading, heading.size()) + ", found " + quoted(lines.line()));
  std::vector<TestRow> rows;
  while (lines.next())
    rows.push_back(row_in({source.name, lines.number()}, lines.line(), rows.size()));
  return rows;
}

}  // namespace pliant
