// SPDX-License-Identifier: MIT
#include "options/option_fields.hpp"

namespace pliant::app {
namespace {

/// "--steps", "-o,--output".
std::string with_letter(const OptionFacts& facts) {
  const std::string option = option_name(facts.name);
  return facts.letter == 0 ? option : std::string("-") + facts.letter + "," + option;
}

/// Adds an option by the kind of its value.
struct AddField {
  CommandLine& line;
  const OptionFacts& facts;
  std::string option = with_letter(facts);
  std::string help = std::string(facts.summary);
  std::string unset = std::string(facts.unset_means);

  void operator()(bool* value) const {
    if (facts.opposite.empty()) return line.add_flag(option, *value, help);
    line.add_opposite(option_name(facts.opposite), *value, help);
  }
  void operator()(std::uint64_t* value) const { line.add_seed(option, *value, help); }
  void operator()(std::int64_t* value) const {
    line.add_integer(option, *value, least_taken(facts), largest_taken(facts), help,
                     unset.empty() ? nullptr : unset.c_str());
  }
  void operator()(double* value) const {
    line.add_real(option, *value, facts.range, help, facts.is_optional ? "" : nullptr);
  }
  void operator()(OptionNames* value) const { line.add_names(option, *value, "", help); }
  void operator()(OptionGroups* value) const {
    line.add_groups(option, *value, facts.words, std::string(facts.kind), help);
  }
  void operator()(std::string* value) const {
    if (facts.choices == nullptr)
      return line.add_text(option, *value, std::string(facts.kind), help);
    std::vector<std::string_view> known = facts.choices();
    if (!facts.automatic.empty()) known.insert(known.begin(), facts.automatic);
    line.add_choice(option, *value, known, help);
  }
};

}  // namespace

void add_option(CommandLine& line, const OptionFacts& facts, OptionPlace place) {
  std::visit(AddField{line, facts}, place);
}

}  // namespace pliant::app
