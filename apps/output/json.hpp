// SPDX-License-Identifier: MIT
// Values to print as JSON. nlohmann's library is behind it: it takes seconds to compile in every
// file that includes it.
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant::app {

/// A JSON value that never changes once made; copies share it. An object keeps its order.
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

  /// This object with the fields of another after its own.
  Json operator+(const Json& other) const;

  /// One line, or with `indent` spaces a level. Bytes that are no UTF-8 are shown as U+FFFD.
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

/// To standard output, two spaces a level.
void print_json(const Json& json);

}  // namespace pliant::app
