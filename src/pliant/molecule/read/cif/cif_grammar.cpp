// SPDX-License-Identifier: MIT
// The one place that sees gemmi: its grammar of CIF (on PEGTL), with our own actions, which keep
// places in the text in place of copies, and our own words for what is wrong.
#include <algorithm>
#include <gemmi/cif.hpp>

#include "pliant/base/error.hpp"
#include "pliant/molecule/read/cif/cif_builder.hpp"
#include "pliant/molecule/read/cif/cif_grammar.hpp"

namespace pliant {
namespace {

namespace pegtl = tao::pegtl;
namespace rules = gemmi::cif::rules;

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
