// SPDX-License-Identifier: MIT
// JSON values for output. nlohmann's library, which implements them, takes seconds to compile in
// every file that includes it.
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace pliant::app {

/// An immutable JSON value; copies share it. An object keeps the order of its fields.
class Json {
 public:
  using Field = std::pair<std::string_view, Json>;

  Json(bool value);
  Json(double value);
  Json(std::string_view value);
  Json(const std::string& value) : Json(std::string_view(value)) {}
  Json(const char* value) : Json(std::string_view(value)) {}
  template <std::signed_integral Integer>
  Json(Integer value) : Json(Signed{value}) {}
  template <std::unsigned_integral Integer>
  Json(Integer value) : Json(Unsigned{value}) {}
  Json(const std::vector<std::string>& values);

  /// An object.
  Json(std::initializer_list<Field> fields);
  static Json object(const std::vector<std::pair<std::string, Json>>& fields);

  static Json array(const std::vector<Json>& values);

  /// This object followed by the fields of another.
  Json operator+(const Json& other) const;

  /// The value as text on one line, or with `indent` spaces a level. Bytes that are not UTF-8
  /// become U+FFFD.
  std::string text(int indent = -1) const;

 private:
  struct Value;
  struct Signed {
    std::int64_t value;
  };
  struct Unsigned {
    std::uint64_t value;
  };
  Json(Signed number);
  Json(Unsigned number);
  explicit Json(Value value);

  std::shared_ptr<const Value> value_;
};

/// What a member of a flat JSON object may be.
using JsonMember = std::variant<bool, std::int64_t, std::uint64_t, double, std::string,
                                std::vector<std::string>, std::vector<std::vector<std::string>>>;

/// The members of a JSON object whose values are no objects; null is left out. Throws InputError
/// naming `file` and what was expected.
std::vector<std::pair<std::string, JsonMember>> members_of(std::string_view text,
                                                           const std::string& file);

/// Prints to standard output, with two spaces a level.
void print_json(const Json& json);

}  // namespace pliant::app
