// SPDX-License-Identifier: MIT
#include "output/json.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

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

void print_json(const Json& json) { std::puts(json.text(2).c_str()); }

}  // namespace pliant::app
