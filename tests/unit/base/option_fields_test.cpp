// SPDX-License-Identifier: MIT
#include "pliant/base/option_fields.hpp"

#include "support/test.hpp"

namespace pliant::option_fields_test {

struct Place {
  double left = 0.5;
};

struct Options {
  bool is_wide = false;
  std::int64_t count = 3;
  std::uint64_t seed = 7;
  Place place = {};
  std::string colour = "red";
  std::string shown = "red";
};

const OptionField<Options> table[] = {
    {{.name = "is_wide"}, place_at<Options, &Options::is_wide>},
    {{.name = "count", .range = Range::positive}, place_at<Options, &Options::count>},
    {{.name = "seed"}, place_at<Options, &Options::seed>},
    {{.name = "left", .range = Range::zero_to_one, .is_optional = true},
     place_at<Options, &Options::place, &Place::left>},
    {{.name = "colour",
      .choices =
          [] {
            return std::vector<std::string_view>{"red", "blue"};
          },
      .kind = "colour",
      .automatic = "any"},
     place_at<Options, &Options::colour>},
    {{.name = "shown", .users = {.file = false}}, place_at<Options, &Options::shown>},
};
const auto fields = std::span(table);

std::string refusal_of(std::size_t row, Options options) {
  return test::error_text<OptionError>(
      [&] { check_option(fields[row], fields[row].place(options)); });
}

TEST(OptionFields, ValuesAreReadBackFromTheirText) {
  const char* texts[] = {"true", "12", "18446744073709551615", "0.1", "blue"};
  Options options;
  for (std::size_t k = 0; k < std::size(texts); ++k) {
    set_option(fields[k], fields[k].place(options), texts[k]);
    EXPECT_EQ(option_text(fields[k].place(options)), texts[k]);
  }
  EXPECT_TRUE(options.is_wide);
  EXPECT_EQ(options.place.left, 0.1);
}

TEST(OptionFields, TextsThatAreNoValueAreRefused) {
  const char* expected[] = {"true or false", "a whole number", "a whole number from 0", "a number"};
  Options options;
  for (std::size_t k = 0; k < std::size(expected); ++k)
    EXPECT_ERROR(OptionError,
                 std::string(fields[k].name) + ": expected " + expected[k] + ", found \"-x\"",
                 set_option(fields[k], fields[k].place(options), "-x"));
}

TEST(OptionFields, RangesAndNamesAreChecked) {
  EXPECT_EQ(refusal_of(1, {.count = 0}), "count = 0: must be from 1");
  EXPECT_EQ(refusal_of(3, {.place = {2.0}}), "left = 2: must be from 0 to 1");
  EXPECT_EQ(refusal_of(4, {.colour = "blu"}),
            "no colour named \"blu\" (did you mean \"blue\"?); known: red, blue");
}

TEST(OptionFields, NumbersAboveTheLargestAreRefused) {
  const auto refusal = [](const OptionFacts& facts, auto value) {
    return test::error_text<OptionError>([&] { check_option(facts, &value); });
  };
  const OptionFacts bars{.name = "bars", .range = Range::zero_or_more, .largest = 6.0};
  EXPECT_EQ(refusal(bars, std::int64_t{7}), "bars = 7: must be at most 6");
  EXPECT_EQ(refusal({.name = "step", .largest = 2.0, .unit = "Angstrom"}, 2.5),
            "step = 2.5: must be at most 2 Angstrom");
  std::int64_t most = 6;
  EXPECT_NO_THROW(check_option(bars, &most));
}

TEST(OptionFields, WithoutChoicesAnyTextWillDo) {
  std::string text = "element O";
  EXPECT_NO_THROW(check_option({.name = "free_angles", .kind = "SELECTION"}, &text));
}

TEST(OptionFields, ZeroStandsForNotUsedWhereThatIsAllowed) {
  Options options;
  options.place.left = 0.0;
  const OptionFacts positive{.name = "left", .range = Range::positive, .is_optional = true};
  EXPECT_NO_THROW(check_option(positive, &options.place.left));
}

TEST(OptionFields, WhatFilesHoldIsReadBack) {
  Options options{true, 9, ~std::uint64_t{0}, {0.25}, "blue", "green"};
  const auto parameters = option_parameters("task", fields, options);
  EXPECT_EQ(parameters.size(), 5U);
  EXPECT_EQ(parameters[2], NamedParameter("task/seed", std::string("18446744073709551615")));
  Options again;
  restore_options("task", fields, parameters, again);
  EXPECT_EQ(again.seed, options.seed);
  EXPECT_EQ(again.count, 9);
  EXPECT_EQ(again.place.left, 0.25);
  EXPECT_EQ(again.colour, "blue");
  EXPECT_EQ(again.shown, "red");
}

TEST(OptionFields, AnInvalidParameterIsNamedAndAFileOfAnotherTaskToo) {
  auto parameters = option_parameters("task", fields, Options{});
  const auto fault = [&] {
    Options options;
    return test::error_text<InputError>(
        [&] { restore_options("task", fields, parameters, options); });
  };
  parameters[2].second = std::string("");
  EXPECT_EQ(fault(), "/parameters/task/seed has an invalid value");
  parameters[1].second = true;
  EXPECT_EQ(fault(), "/parameters/task/count has an invalid value");
  parameters.erase(parameters.begin());
  EXPECT_EQ(fault(), "does not say /parameters/task/is_wide");
}

/// It is older than the option.
TEST(OptionFields, WhatAFileLacksKeepsItsDefault) {
  auto parameters = option_parameters("task", fields, Options{true, 9, 5, {0.25}, "blue", "green"});
  std::erase_if(parameters, [](const auto& one) { return one.first == "task/count"; });
  Options again;
  restore_options("task", fields, parameters, again);
  EXPECT_EQ(again.count, Options{}.count);
  EXPECT_EQ(again.seed, 5U);
}

TEST(OptionFields, WhatATaskChoosesIsLeftOpen) {
  Options options;
  leave_open(fields, options);
  EXPECT_EQ(options.colour, "any");
}

}  // namespace pliant::option_fields_test
