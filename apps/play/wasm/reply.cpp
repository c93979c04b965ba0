// SPDX-License-Identifier: MIT
#include "reply.hpp"

#include <cstring>

namespace pliant::play {

void Reply::put_bytes(const char* name, const char* type, std::size_t count,
                      std::span<const std::byte> bytes) {
  Array array{name, type, count, std::vector<std::uint64_t>((bytes.size() + 7) / 8)};
  if (!bytes.empty()) std::memcpy(array.words.data(), bytes.data(), bytes.size());
  arrays_.push_back(std::move(array));
}

std::string Reply::text() const {
  Json all = fields;
  Json& places = all["arrays"] = Json::object();
  for (const Array& array : arrays_)
    places[array.name] = {{"type", array.type},
                          {"at", reinterpret_cast<std::uintptr_t>(array.words.data())},
                          {"count", array.count}};
  // Bytes of a file that are no UTF-8 get into messages: they must not stop the reply.
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace pliant::play
