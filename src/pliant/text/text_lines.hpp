// SPDX-License-Identifier: MIT
// The lines of a text, whatever ends them: LF, CRLF or a lone CR (old Mac), without copying.
#pragma once

#include <cstddef>
#include <string_view>

namespace pliant {

/// Walks over the lines of a text. A copy keeps its own place. Takes linear time even where the
/// text has no LF.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text), lf_(text.find('\n')), cr_(text.find('\r')) {}

  /// Moves to the next line; false when there is none. A final line end begins no further line.
  bool next() {
    line_ = {};
    if (at_ >= text_.size()) return false;
    ++number_;
    if (lf_ < at_) lf_ = text_.find('\n', at_);
    if (cr_ < at_) cr_ = text_.find('\r', at_);
    const std::size_t end = lf_ < cr_ ? lf_ : cr_;
    line_ = text_.substr(at_, end == none ? none : end - at_);
    if (end == none) {
      at_ = text_.size();
    } else {
      at_ = end + (end == cr_ && lf_ == cr_ + 1 ? 2 : 1);
    }
    return true;
  }

  std::string_view line() const { return line_; }

  /// Number of the current line, from 1; 0 before the first.
  std::size_t number() const { return number_; }

  /// Bytes that lie beyond the current line.
  std::size_t bytes_left() const { return text_.size() - at_; }

 private:
  static constexpr std::size_t none = std::string_view::npos;
  std::string_view text_, line_;
  std::size_t at_ = 0, number_ = 0;
  std::size_t lf_, cr_;  // the next LF and CR at or after at_, or none
};

}  // namespace pliant
