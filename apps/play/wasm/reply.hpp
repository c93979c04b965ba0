// SPDX-License-Identifier: MIT
// The reply of a call: a JSON object, and arrays of numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant::play {

using Json = nlohmann::json;

/// The arrays are kept as bytes until the next call. The member `arrays` of the JSON has {type, at,
/// count} for the name of each, where `type` is the word before "Array" in JavaScript.
class Reply {
 public:
  Json fields = Json::object();

  void add(const char* name, std::span<const double> values) { put(name, "Float64", values); }
  void add(const char* name, std::span<const float> values) { put(name, "Float32", values); }
  void add(const char* name, std::span<const std::int32_t> values) { put(name, "Int32", values); }
  void add(const char* name, std::span<const std::uint8_t> values) { put(name, "Uint8", values); }

  /// The JSON text with the addresses of the arrays, which are valid as long as this object.
  std::string text() const;

 private:
  struct Array {
    std::string name, type;
    std::size_t count;
    std::vector<std::uint64_t> words;  ///< aligned for all types
  };

  template <class T>
  void put(const char* name, const char* type, std::span<const T> values) {
    put_bytes(name, type, values.size(), std::as_bytes(values));
  }
  void put_bytes(const char* name, const char* type, std::size_t count,
                 std::span<const std::byte> bytes);

  std::vector<Array> arrays_;
};

}  // namespace pliant::play
