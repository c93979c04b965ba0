// SPDX-License-Identifier: MIT
#include "pliant/molecule/cif_document.hpp"

#include <algorithm>
#include <gemmi/cif.hpp>
#include <unordered_set>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

namespace pegtl = tao::pegtl;
namespace rules = gemmi::cif::rules;

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  return out;
}

/// Fills a document while the grammar is matched.
class CifBuilder {
 public:
  CifBuilder(const SourceText& source, const std::vector<std::string_view>& categories,
             CifDocument& document)
      : source_(source), categories_(categories), document_(document) {}

  void begin_block(std::string_view name) {
    document_.blocks.push_back({std::string(name), {}, false});
    tags_.clear();
    in_frame_ = false;
  }
  void begin_frame() { in_frame_ = true; }
  void end_frame() { in_frame_ = false; }

  void item_tag(std::string_view tag, std::size_t line) {
    table_ = table_of(add_tag(tag, line), line, false);
    if (table_ != nullptr) table_->tags.push_back(tail_of(tag));
  }
  void item_value(CifValue value) {
    if (table_ != nullptr) table_->values.push_back(value);
  }
  [[noreturn]] void fail_without_value(std::size_t line) const {
    fail(place(line), "tag " + quoted(last_tag_) + " has no value");
  }

  void begin_loop(std::size_t line) {
    table_ = nullptr;
    loop_line_ = line;
    loop_width_ = loop_values_ = 0;
  }
  void loop_tag(std::string_view tag, std::size_t line) {
    const std::string category = add_tag(tag, line);
    if (loop_width_++ == 0) table_ = table_of(category, line, true);
    if (table_ == nullptr) return;
    table_->tags.push_back(category == table_->category ? tail_of(tag) : std::string());
  }
  void loop_value(CifValue value, std::size_t line) {
    if (loop_values_++ % loop_width_ == 0) row_line_ = line;
    if (table_ != nullptr) table_->values.push_back(value);
  }
  void end_loop() const {
    const std::size_t rest = loop_width_ == 0 ? 0 : loop_values_ % loop_width_;
    if (rest != 0)
      fail(place(row_line_), "the loop begun on line " + std::to_string(loop_line_) + " has " +
                                 std::to_string(loop_width_) + " tags, its last row " +
                                 std::to_string(rest) + (rest == 1 ? " value" : " values"));
  }

  std::size_t loop_line() const { return loop_line_; }

  void text_field_mark(std::size_t line) { text_field_line_ = line; }
  std::size_t text_field_line() const { return text_field_line_; }

 private:
  Place place(std::size_t line) const { return {source_.name, line}; }

  /// Refuses a tag given twice in a block; returns its category: all before the dot.
  std::string add_tag(std::string_view tag, std::size_t line) {
    last_tag_ = tag;
    std::string key = lower(tag);
    if (in_frame_) return {};
    if (key.starts_with("_atom_site_") && !document_.blocks.empty())
      document_.blocks.back().has_fractions = true;
    std::string category = key.substr(0, std::min(key.find('.'), key.size()));
    if (!tags_.insert(std::move(key)).second)
      fail(place(line), "tag " + quoted(tag) + " is given twice");
    return category;
  }

  std::string tail_of(std::string_view tag) const {
    const std::size_t dot = tag.find('.');
    return dot == std::string_view::npos ? std::string() : lower(tag.substr(dot + 1));
  }

  /// The table of a wanted category in the current block, or null. Pairs of one category share a
  /// table; a loop has its own.
  CifTable* table_of(const std::string& category, std::size_t line, bool is_loop) {
    if (in_frame_ || document_.blocks.empty()) return nullptr;
    if (std::find(categories_.begin(), categories_.end(), category) == categories_.end())
      return nullptr;
    auto& tables = document_.blocks.back().tables;
    const auto same = [&](const CifTable& table) { return table.category == category; };
    const auto found = std::find_if(tables.begin(), tables.end(), same);
    if (found != tables.end()) {
      if (!is_loop && !found->is_loop) return &*found;
      fail(place(line), "category " + pliant::quoted(category) +
                            " is given twice, the first time on line " +
                            std::to_string(found->line));
    }
    tables.push_back({category, {}, {}, line, is_loop});
    return &tables.back();
  }

  const SourceText& source_;
  const std::vector<std::string_view>& categories_;
  CifDocument& document_;
  std::unordered_set<std::string> tags_;
  std::string_view last_tag_;
  CifTable* table_ = nullptr;
  bool in_frame_ = false;
  std::size_t loop_line_ = 0, loop_width_ = 0, loop_values_ = 0, row_line_ = 0;
  std::size_t text_field_line_ = 0;
};

/// What a matched rule hands to the builder: text, line and place.
template <class Input>
std::string_view text_of(const Input& in) {
  return {in.begin(), in.size()};
}
template <class Input>
std::size_t line_of(const Input& in) {
  return in.iterator().line;
}
template <class Input>
CifValue value_of(const Input& in) {
  return {static_cast<std::uint32_t>(in.iterator().byte), static_cast<std::uint32_t>(in.size())};
}

template <class Rule>
struct Build : pegtl::nothing<Rule> {};

template <>
struct Build<rules::datablockname> {
  template <class Input>
  static void apply(const Input& in, CifBuilder& out) {
    out.begin_block(text_of(in));
  }
};
template <>
struct Build<rules::str_global> {
  template <class Input>
  static void apply(const Input&, CifBuilder& out) {
    out.begin_block("global");
  }
};
template <>
struct Build<rules::framename> {
  template <class Input>
  static void apply(const Input&, CifBuilder& out) {
    out.begin_frame();
  }
};
template <>
struct Build<rules::endframe> {
  template <class Input>
  static void apply(const Input&, CifBuilder& out) {
    out.end_frame();
  }
};
template <>
struct Build<rules::item_tag> {
  template <class Input>
  static void apply(const Input& in, CifBuilder& out) {
    out.item_tag(text_of(in), line_of(in));
  }
};
template <>
struct Build<rules::item_value> {
  template <class Input>
  static void apply(const Input& in, CifBuilder& out) {
    out.item_value(value_of(in));
  }
};
template <>
struct Build<rules::missing_value> {
  template <class Input>
  static void apply(const Input& in, CifBuilder& out) {
    out.fail_without_value(line_of(in));
  }
};
template <>
struct Build<rules::str_loop> {
  template <class Input>
  static void apply(const Input& in, CifBuilder& out) {
    out.begin_loop(line_of(in));
  }
};
template <>
struct Build<rules::loop_tag> {
  template <class Input>
  static void apply(const Input& in, CifBuilder& out) {
    out.loop_tag(text_of(in), line_of(in));
  }
};
template <>
struct Build<rules::loop_value> {
  template <class Input>
  static void apply(const Input& in, CifBuilder& out) {
    out.loop_value(value_of(in), line_of(in));
  }
};
template <>
struct Build<rules::loop> {
  template <class Input>
  static void apply(const Input&, CifBuilder& out) {
    out.end_loop();
  }
};
template <>
struct Build<rules::field_sep> {
  template <class Input>
  static void apply(const Input& in, CifBuilder& out) {
    out.text_field_mark(line_of(in));
  }
};

using LoopTags = pegtl::plus<pegtl::seq<rules::loop_tag, rules::whitespace, pegtl::discard>>;
using TextFieldTail = pegtl::until<rules::field_sep>;

/// What is wrong where a rule that must match does not; the builder knows where loops and text
/// fields begin.
enum class Begun { here, loop, text_field };
struct Problem {
  Begun begun;
  std::string_view text;
};
struct SyntaxError {
  Problem problem;
  std::size_t line, byte;
};

template <class Rule>
inline constexpr Problem problem{Begun::here, "is not CIF here"};
template <>
inline constexpr Problem problem<pegtl::eof>{Begun::here, "is a value without a tag"};
template <>
inline constexpr Problem problem<rules::content>{Begun::here,
                                                 "stands where the file should begin with data_"};
template <>
inline constexpr Problem problem<LoopTags>{Begun::loop, "loop_ is not followed by tags"};
template <>
inline constexpr Problem problem<TextFieldTail>{
    Begun::text_field,
    "the text field that begins here is not closed by a line that begins with ;"};
template <>
inline constexpr Problem problem<rules::quoted_tail<pegtl::one<'\''>>>{
    Begun::here, "has a quote that is not closed"};
template <>
inline constexpr Problem problem<rules::quoted_tail<pegtl::one<'"'>>>{
    Begun::here, "has a quote that is not closed"};

template <class Rule>
struct Raise : pegtl::normal<Rule> {
  template <class Input, class... States>
  static void raise(const Input& in, States&&...) {
    const auto position = in.position();
    throw SyntaxError{problem<Rule>, position.line, position.byte};
  }
};

std::string_view line_around(std::string_view text, std::size_t byte) {
  std::size_t start = std::min(byte, text.size());
  start = start == 0 ? 0 : text.rfind('\n', start - 1) + 1;
  const std::string_view rest = text.substr(start);
  return rest.substr(0, rest.find_first_of("\r\n"));
}

[[noreturn]] void fail_syntax(const SyntaxError& error, const SourceText& source,
                              const CifBuilder& builder) {
  if (error.problem.begun == Begun::loop)
    fail({source.name, builder.loop_line()}, error.problem.text);
  if (error.problem.begun == Begun::text_field)
    fail({source.name, builder.text_field_line()}, error.problem.text);
  const std::string_view line = line_around(source.text, error.byte);
  const std::string found = line.empty() ? "the end of the file" : quoted(line);
  fail({source.name, error.line}, found + " " + std::string(error.problem.text));
}

}  // namespace

std::optional<std::size_t> CifTable::column(std::string_view tag) const {
  const auto found = std::find(tags.begin(), tags.end(), tag);
  if (found == tags.end()) return std::nullopt;
  return static_cast<std::size_t>(found - tags.begin());
}

const CifTable* CifBlock::table(std::string_view category) const {
  for (const CifTable& table : tables)
    if (table.category == category) return &table;
  return nullptr;
}

std::string_view CifDocument::word(CifValue value) const {
  std::string_view word = raw(value);
  if (word == "?" || word == ".") return {};
  if (word.size() >= 2 && (word[0] == '"' || word[0] == '\''))
    return word.substr(1, word.size() - 2);
  if (word.size() >= 2 && word[0] == ';' && word.back() == ';') {
    word = word.substr(1, word.size() - 2);
    while (!word.empty() && (word.back() == '\n' || word.back() == '\r')) word.remove_suffix(1);
  }
  return word;
}

std::size_t CifLines::operator()(CifValue value) {
  if (value.offset < offset_) offset_ = 0, line_ = 1;
  const std::string_view passed = text_.substr(offset_, value.offset - offset_);
  line_ += static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
  offset_ = value.offset;
  return line_;
}

CifDocument parse_cif(const SourceText& source, const std::vector<std::string_view>& categories) {
  CifDocument document{source.text, {}};
  CifBuilder builder(source, categories, document);
  pegtl::memory_input<> input(source.text.data(), source.text.size(), "");
  try {
    pegtl::parse<rules::file, Build, Raise>(input, builder);
  } catch (const SyntaxError& error) {
    fail_syntax(error, source, builder);
  }
  return document;
}

}  // namespace pliant
