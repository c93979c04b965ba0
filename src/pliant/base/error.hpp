// SPDX-License-Identifier: MIT
// The kinds of failure that callers may want to tell apart. A resolve that does not converge is no
// error: ResolveSummary says so.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace pliant {

/// Anything that Pliant throws.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The input is wrong: the message names file, line and field, what was expected and found.
class InputError : public Error {
 public:
  using Error::Error;
};

/// An option is out of its range or names no known choice.
class OptionError : public Error {
 public:
  using Error::Error;
};

/// A file could not be opened, read or written; the message ends with the system's reason.
class FileError : public Error {
 public:
  using Error::Error;
};

/// A place in an input. `line` counts from 1; 0 means the file as a whole.
struct Place {
  std::string_view file;
  std::size_t line = 0;
};

/// "file:line: message", or "file: message" where there is no line.
std::string at(const Place& place, std::string_view message);

/// Throws InputError with `at(place, message)`.
[[noreturn]] void fail(const Place& place, std::string_view message);

/// `text` in double quotes, shortened to `most` bytes, with control and non-ASCII bytes escaped as
/// \xNN: safe to print to a terminal whatever a file holds.
std::string quoted(std::string_view text, std::size_t most = 40);

}  // namespace pliant
