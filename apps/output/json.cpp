// SPDX-License-Identifier: MIT
#include "output/json.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "pliant/base/error.hpp"

namespace pliant::app {

struct Json::Value {
  nlohmann::ordered_json json;
};

Json::Json(Value value) : value_(std::make_shared<const Value>(std::move(value))) {}

Json::Json(bool value) : Json(Value{value}) {}

Json::Json(double value) : Json(Value{value}) {}

Json::Json(std::string_view value) : Json(Value{std::string(value)}) {}

Json::Json(Signed number) : Json(Value{number.value}) {}

Json::Json(Unsigned number) : Json(Value{number.value}) {}

Json::Json(const std::vector<std::string>& values) : Json(Value{values}) {}

Json::Json(std::initializer_list<Field> fields) : Json(Value{nlohmann::ordered_json::object()}) {
  Value object = *value_;
  for (const auto& [name, field] : fields) object.json[std::string(name)] = field.value_->json;
  *this = Json(std::move(object));
}

Json Json::object(const std::vector<std::pair<std::string, Json>>& fields) {
  Value object{nlohmann::ordered_json::object()};
  for (const auto& [name, field] : fields) object.json[name] = field.value_->json;
  return Json(std::move(object));
}

Json Json::array(const std::vector<Json>& values) {
  Value array{nlohmann::ordered_json::array()};
  for (const Json& value : values) array.json.push_back(value.value_->json);
  return Json(std::move(array));
}

Json Json::operator+(const Json& other) const {
  Value sum = *value_;
  sum.json.update(other.value_->json);
  return Json(std::move(sum));
}

std::string Json::text(int indent) const {
  return value_->json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

namespace {

JsonMember member_of(const nlohmann::json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > INT64_MAX)
    return value.get<std::uint64_t>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  if (!value.empty() && value[0].is_array())
    return value.get<std::vector<std::vector<std::string>>>();
  return value.get<std::vector<std::string>>();
}

}  // namespace

std::vector<std::pair<std::string, JsonMember>> members_of(std::string_view text,
                                                           const std::string& file) {
  std::vector<std::pair<std::string, JsonMember>> members;
  try {
    const auto object = nlohmann::ordered_json::parse(text);
    if (!object.is_object()) throw InputError(file + ": expected a JSON object");
    for (const auto& [name, value] : object.items())
      if (!value.is_null()) members.emplace_back(name, member_of(value));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file + ": expected a JSON object of options: " + error.what());
  }
  return members;
}

void print_json(const Json& json) { std::puts(json.text(2).c_str()); }

}  // namespace pliant::app
