// SPDX-License-Identifier: MIT
#include "pliant/molecule/selection.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/molecule/selection_terms.hpp"

namespace pliant {
namespace selection {
namespace {

struct Word {
  std::string_view text;  ///< "" at the end
  std::size_t at;         ///< character, from 1
};

std::vector<Word> split(std::string_view text) {
  std::vector<Word> result;
  for (std::size_t k = 0; k < text.size();) {
    std::size_t end = text.find_first_of(" \t\r\n()", k);
    end = end == std::string_view::npos ? text.size() : std::max(end, k + 1);
    if (std::isspace(static_cast<unsigned char>(text[k])) == 0)
      result.push_back({text.substr(k, end - k), k + 1});
    k = end;
  }
  result.push_back({"", text.size() + 1});
  return result;
}

bool is_reserved(std::string_view text) {
  return text.empty() || text == "and" || text == "or" || text == "not" || text == "(" ||
         text == ")" || find_term(text) != nullptr;
}

/// "52", "-5", "52A".
std::optional<Number> parse_number(std::string_view text, bool codes) {
  Number number;
  if (codes && text.size() > 1 && std::isalpha(static_cast<unsigned char>(text.back())) != 0) {
    number.code = text.back();
    text.remove_suffix(1);
  }
  const auto value = parse_integer(text);
  if (!value) return std::nullopt;
  number.value = *value;
  return number;
}

/// "5", "3-8", "3:8", "-5--2".
std::optional<Range> parse_range(std::string_view text, bool codes) {
  if (const auto number = parse_number(text, codes)) return Range{*number, *number};
  const std::size_t middle = text.find_first_of(":-", 1);
  if (middle == std::string_view::npos) return std::nullopt;
  const auto first = parse_number(text.substr(0, middle), codes);
  const auto last = parse_number(text.substr(middle + 1), codes);
  if (!first || !last) return std::nullopt;
  return Range{*first, *last};
}

using Mask = std::vector<bool>;

enum class Operator : std::uint8_t { parenthesis, either, both, invert };

/// Reads words from left to right with a stack of operators and one of masks (Dijkstra's shunting
/// yard), so that no depth of parentheses needs recursion.
class Parser {
 public:
  Parser(const AtomTable& atoms, std::string_view text)
      : subject_(atoms), text_(text), words_(split(text)) {}

  Mask parse() {
    while (true) {
      read_operand();
      while (word().text == ")") close();
      const Word& next = word();
      if (next.text.empty()) break;
      if (next.text != "and" && next.text != "or") fail_at("expected \"and\", \"or\" or the end");
      reduce_to_parenthesis();
      operators_.push_back({next.text == "and" ? Operator::both : Operator::either, next.at});
      ++next_;
    }
    reduce_to_parenthesis();
    if (!operators_.empty())
      fail("the parenthesis at character " + std::to_string(operators_.back().at) +
           " is not closed");
    return masks_.back();
  }

 private:
  struct Pending {
    Operator kind;
    std::size_t at;
  };

  const Word& word() const { return words_[next_]; }

  [[noreturn]] void fail(const std::string& message) const {
    throw OptionError("selection " + pliant::quoted(text_, 200) + ": " + message);
  }

  [[noreturn]] void fail_at(const std::string& message) const {
    const std::string found = word().text.empty() ? "the end" : pliant::quoted(word().text);
    fail(message + ", found " + found + " at character " + std::to_string(word().at));
  }

  void read_operand() {
    for (;; ++next_) {
      if (word().text == "not") {
        operators_.push_back({Operator::invert, word().at});
      } else if (word().text == "(") {
        operators_.push_back({Operator::parenthesis, word().at});
      } else {
        return read_term();
      }
    }
  }

  void read_term() {
    const Term* term = find_term(word().text);
    if (term == nullptr) fail_at("expected a word that selects atoms" + suggestion());
    if (term->word.name == "id" && !subject_.is_graph())
      fail_at("atoms have a name, an index (from 0) and a bynum (from 1), joints of a graph an id");
    const Meaning& meaning = term->meaning;
    ++next_;
    if (meaning.holds != nullptr)
      return push([&](std::size_t i) { return meaning.holds(subject_, i); });
    if (is_reserved(word().text))
      fail_at(pliant::quoted(term->word.name) + " needs " + std::string(term->word.values));
    if (meaning.text != nullptr) return read_patterns(meaning.text, term->word.name == "element");
    read_ranges(meaning.number, term->word.name);
  }

  std::string suggestion() const {
    const std::string nearest = nearest_name(word().text, names_of(selection_words()));
    return nearest.empty() ? "" : " (did you mean " + pliant::quoted(nearest) + "?)";
  }

  void read_patterns(Text text, bool any_case) {
    std::vector<std::string_view> patterns;
    for (; !is_reserved(word().text); ++next_) {
      if (word().text.find_first_of("[]") != std::string_view::npos)
        fail_at("a name may hold * and ? but no brackets");
      patterns.push_back(word().text.substr(word().text[0] == '\\' ? 1 : 0));
    }
    push([&](std::size_t i) {
      return std::any_of(patterns.begin(), patterns.end(), [&](std::string_view pattern) {
        return fits(pattern, text(subject_, i), any_case);
      });
    });
  }

  void read_ranges(NumberOf number, std::string_view name) {
    std::vector<Range> ranges;
    for (; !is_reserved(word().text); ++next_) {
      const auto range = parse_range(word().text, name == "resid");
      if (!range) fail_at(pliant::quoted(name) + " takes numbers and ranges such as 3-8 or 3:8");
      if (range->last < range->first) fail_at("a range goes from the lower number to the higher");
      ranges.push_back(*range);
    }
    push([&](std::size_t i) {
      const Number n = number(subject_, i);
      return std::any_of(ranges.begin(), ranges.end(),
                         [&](const Range& r) { return r.first <= n && n <= r.last; });
    });
  }

  template <class Predicate>
  void push(const Predicate& holds) {
    Mask mask(subject_.atoms.size());
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = holds(i);
    masks_.push_back(std::move(mask));
  }

  void close() {
    reduce_to_parenthesis();
    if (operators_.empty()) fail_at("no parenthesis is open");
    operators_.pop_back();
    ++next_;
  }

  /// "and" and "or" have one rank and go from left to right, "not" binds tighter: all that is
  /// pending since the last parenthesis is due.
  void reduce_to_parenthesis() {
    while (!operators_.empty() && operators_.back().kind != Operator::parenthesis) apply();
  }

  void apply() {
    const Operator kind = operators_.back().kind;
    operators_.pop_back();
    if (kind == Operator::invert) return masks_.back().flip();
    const Mask right = std::move(masks_.back());
    masks_.pop_back();
    Mask& left = masks_.back();
    for (std::size_t i = 0; i < left.size(); ++i)
      left[i] = kind == Operator::both ? left[i] && right[i] : left[i] || right[i];
  }

  Subject subject_;
  std::string_view text_;
  std::vector<Word> words_;
  std::size_t next_ = 0;
  std::vector<Pending> operators_;
  std::vector<Mask> masks_;
};

}  // namespace
}  // namespace selection

std::vector<std::uint32_t> select_atoms(const AtomTable& atoms, std::string_view selection) {
  const selection::Mask mask = selection::Parser(atoms, selection).parse();
  std::vector<std::uint32_t> selected;
  for (std::uint32_t i = 0; i < mask.size(); ++i)
    if (mask[i]) selected.push_back(i);
  return selected;
}

std::vector<std::uint32_t> select_some_atoms(const AtomTable& atoms, std::string_view selection,
                                             std::string_view option) {
  std::vector<std::uint32_t> some = select_atoms(atoms, selection);
  if (some.empty())
    throw OptionError(std::string(option) + ": selection " + quoted(selection, 200) +
                      " names no atom");
  return some;
}

std::vector<Joint> select_joints(const Framework& framework, std::string_view selection,
                                 std::string_view option) {
  if (selection.empty()) return {};
  if (!framework.atoms()) throw OptionError(std::string(option) + ": the joints have no names");
  return select_some_atoms(*framework.atoms(), selection, option);
}

}  // namespace pliant
