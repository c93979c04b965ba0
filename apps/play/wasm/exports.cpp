// SPDX-License-Identifier: MIT
// What the module exports. Texts and arrays lie in its memory; the worker copies them.
#include <cstdlib>
#include <string>

#include "call.hpp"

namespace {

pliant::play::Reply last;
std::string text;

}  // namespace

#define PLIANT_EXPORT(name) extern "C" __attribute__((export_name(#name)))

/// Room for what a call is given.
PLIANT_EXPORT(play_allocate) void* play_allocate(std::size_t bytes) { return std::malloc(bytes); }
PLIANT_EXPORT(play_free) void play_free(void* room) { std::free(room); }

/// Answers the request, JSON and bytes of a file; the length of the JSON that play_reply() points
/// at. What the call before has replied is gone.
PLIANT_EXPORT(play_call)
std::size_t play_call(const char* json, std::size_t length, const char* bytes, std::size_t size) {
  const auto request = pliant::play::Json::parse(json, json + length, nullptr, false);
  last = pliant::play::answer({request, {bytes, size}});
  text = last.text();
  return text.size();
}
PLIANT_EXPORT(play_reply) const char* play_reply() { return text.data(); }
