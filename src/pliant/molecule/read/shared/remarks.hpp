// SPDX-License-Identifier: MIT
// Findings of a reader about a file: each kind once, with its first line and the number of cases.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/base/log.hpp"

namespace pliant {

/// Collects findings while a file is read; tell() sends them to the log afterwards.
class Remarks {
 public:
  Remarks(std::string_view file, const Log& log) : file_(file), log_(log) {}

  /// Adds a finding of `kind` (a string literal). `text` is a callable that returns the message; it
  /// is called only for the first finding of its kind. Line 0 means the whole file.
  template <class Text>
  void warn(std::string_view kind, std::size_t line, Text&& text) {
    if (!seen_before(kind)) add(kind, Severity::warning, at({file_, line}, text()));
  }

  /// Adds a finding that is no problem.
  template <class Text>
  void note(std::string_view kind, std::size_t line, Text&& text) {
    if (!seen_before(kind)) add(kind, Severity::note, at({file_, line}, text()));
  }

  void note(std::string_view message) { add("", Severity::note, at({file_}, message)); }

  std::string_view file() const { return file_; }
  Place place(std::size_t line) const { return {file_, line}; }

  /// Sends all to the log, in the order of first findings; repeated ones end with "(and 3 more)".
  void tell();

 private:
  struct Remark {
    std::string_view kind;
    Severity severity;
    std::string message;
    std::size_t count;
  };
  bool seen_before(std::string_view kind);
  void add(std::string_view kind, Severity severity, std::string message);

  std::string_view file_;
  const Log& log_;
  std::vector<Remark> remarks_;
};

}  // namespace pliant
