// SPDX-License-Identifier: MIT
#include "pliant/order/ordering_file.hpp"

#include <algorithm>
#include <unordered_map>

#include "pliant/base/number.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/base/words.hpp"
#include "pliant/framework/joint_names.hpp"
#include "pliant/order/check_ordering.hpp"
#include "pliant/text/text_lines.hpp"

namespace pliant {
namespace {

constexpr std::string_view heading = "pliant-ordering 1";

std::uint64_t pair_key(Joint a, Joint b) {
  return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}

/// Reads an ordering file line by line.
class Parser {
 public:
  Parser(std::string_view file, const Framework& framework)
      : place_{file, 0},
        framework_(framework),
        names_(framework),
        given_in_line_(framework.bar_count(), 0) {
    for (std::size_t k = 0; k < framework.bar_count(); ++k) {
      const Bar bar = framework.bars()[k];
      bars_.emplace(pair_key(bar.a, bar.b), static_cast<BarIndex>(k));
    }
  }

  Ordering parse(std::string_view text) {
    for (Lines lines(text); lines.next();) {
      place_.line = lines.number();
      take(words_of(lines.line()), lines.line());
    }
    place_.line = 0;
    if (!headed_) fail(place_, "expected the line " + quoted(heading) + " first, found no text");
    expect_all_bars();
    return std::move(found_);
  }

 private:
  void take(const Words& words, std::string_view line) {
    if (words.empty()) return;
    if (headed_) return take_bar(words);
    if (words.size() != 2 || words[0] != "pliant-ordering" || words[1] != "1")
      fail(place_, "expected " + quoted(heading) + ", found " + quoted(trimmed(line)));
    headed_ = true;
  }

  void take_bar(const Words& words) {
    if (words[0] != "bar") fail(place_, "expected bar, found " + quoted(words[0]));
    if (words.size() != 4)
      fail(place_, "bar: expected near joint, far joint and kind (tree or non_tree), found " +
                       std::to_string(words.size() - 1) + " fields");
    const Joint near = names_.find(words[1], place_), far = names_.find(words[2], place_);
    const std::string name = quoted(words[1]) + " - " + quoted(words[2]);
    const auto at = bars_.find(pair_key(near, far));
    if (at == bars_.end()) fail(place_, "bar " + name + ": the framework has no such bar");
    std::size_t& line = given_in_line_[at->second];
    if (line != 0)
      fail(place_, "bar " + name + " is given twice, first in line " + std::to_string(line));
    line = place_.line;
    found_.push_back({at->second, near, is_tree(words[3])});
  }

  bool is_tree(std::string_view word) const {
    if (word != "tree" && word != "non_tree")
      fail(place_, "kind: expected tree or non_tree, found " + quoted(word));
    return word == "tree";
  }

  void expect_all_bars() const {
    const auto missing = std::count(given_in_line_.begin(), given_in_line_.end(), std::size_t{0});
    if (missing == 0) return;
    const auto first = std::find(given_in_line_.begin(), given_in_line_.end(), std::size_t{0});
    const Bar bar = framework_.bars()[std::size_t(first - given_in_line_.begin())];
    fail(place_, "bar " + framework_.label(bar) + " is missing: expected " +
                     std::to_string(framework_.bar_count()) + " bars, found " +
                     std::to_string(found_.size()));
  }

  Place place_;
  const Framework& framework_;
  JointNames names_;
  std::unordered_map<std::uint64_t, BarIndex> bars_;
  std::vector<std::size_t> given_in_line_;  ///< of each bar; 0: not yet
  bool headed_ = false;
  Ordering found_;
};

}  // namespace

Ordering parse_ordering_file(const SourceText& source, const Framework& framework) {
  return Parser(source.name, framework).parse(source.text);
}

Ordering read_ordering_file(const std::filesystem::path& path, const Framework& framework) {
  const std::string bytes = read_bytes(path);
  const std::string name = path_text(path);
  return parse_ordering_file({name, without_byte_order_mark(bytes)}, framework);
}

std::string write_ordering_file(const Ordering& ordering, const Framework& framework) {
  const std::string fault = check_ordering(framework, ordering, {.tree_bars = false});
  if (!fault.empty()) throw InputError("ordering file: " + fault);
  const JointNames names(framework);
  std::string text = std::string(heading) + "\n";
  for (const OrderedBar& visit : ordering) {
    const Bar bar = framework.bars()[visit.bar];
    const Joint far = visit.near == bar.a ? bar.b : bar.a;
    text += "bar " + names.word_for(visit.near, "ordering file") + " " +
            names.word_for(far, "ordering file") + (visit.is_tree ? " tree\n" : " non_tree\n");
  }
  return text;
}

}  // namespace pliant
