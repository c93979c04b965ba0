// SPDX-License-Identifier: MIT
#include "pliant/run/run_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "pliant/lab/examples/examples.hpp"
#include "pliant/run/run.hpp"
#include "support/error_text.hpp"
#include "support/frameworks.hpp"

namespace pliant {
namespace run_fields_test {

std::string refusal(const RunOptions& options) {
  return test::error_text<OptionError>([&] { check(options); });
}

TEST(RunFields, EachHasANamePlaceAndSummaryOfItsOwn) {
  RunOptions options;
  std::set<std::string_view> names;
  std::set<const void*> places;
  for (const RunField& field : run_fields()) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_TRUE(places
                    .insert(std::visit([](auto* place) -> const void* { return place; },
                                       field.place(options)))
                    .second)
        << field.name;
    EXPECT_FALSE(field.summary.empty());
    EXPECT_EQ(std::holds_alternative<std::string*>(field.place(options)), field.choices != nullptr);
  }
}

TEST(RunFields, DefaultsAreInTheirRanges) { EXPECT_NO_THROW(check(RunOptions{})); }

// What lies out of its range is refused by name, whichever option it is.
TEST(RunFields, EveryNumberIsHeldToItsRange) {
  for (const RunField& field : run_fields()) {
    SCOPED_TRACE(field.name);
    RunOptions options;
    const OptionPlace place = field.place(options);
    if (auto* real = std::get_if<double*>(&place)) {
      **real = -0.5;
    } else if (auto* whole = std::get_if<std::int64_t*>(&place)) {
      **whole = -1;
    } else {
      continue;
    }
    EXPECT_EQ(refusal(options).rfind(std::string(field.name) + " = -", 0), 0u) << refusal(options);
  }
}

TEST(RunFields, UnknownNamesAreRefusedWithTheKnownOnes) {
  RunOptions options;
  options.perturb = "forse";
  EXPECT_EQ(refusal(options).rfind("no perturbation named \"forse\" (did you mean \"force\"?)", 0),
            0u);
}

TEST(RunFields, ParametersAreAllOptions) {
  const Framework framework = framework_of(chain(4));
  RunOptions options;
  options.resolve.seed = 18446744073709551615u;
  options.resolve.max_sweeps = 7;
  options.replay = {{0, {1, 0, 0}}};
  const std::vector<NamedParameter> list = parameters_of(options, framework);
  const std::map<std::string, Parameter> values(list.begin(), list.end());
  EXPECT_EQ(values.size(), run_fields().size() + 2);
  EXPECT_EQ(values.at("run/seed"), Parameter(std::string("18446744073709551615")));
  EXPECT_EQ(values.at("run/max_sweeps"), Parameter(std::int64_t{7}));
  EXPECT_EQ(values.at("run/perturb"), Parameter(std::string("replay")));
  EXPECT_EQ(values.at("run/technique"), Parameter(std::string("auto")));
  EXPECT_EQ(values.at("run/technique_used"), Parameter(std::string("blocks")));
}

}  // namespace run_fields_test
}  // namespace pliant
