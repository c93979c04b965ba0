// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/structure_walk.hpp"

#include <algorithm>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

// A block of metadata that is larger was never written by anyone.
constexpr std::uint64_t most_block_bytes = std::uint64_t{1} << 28;
// Groups and attributes of other programs: more of them than a trajectory can have.
constexpr std::size_t most_objects = 1'000'000;

[[noreturn]] void fail(const std::string& what, std::uint64_t address, const std::string& why) {
  throw InputError("is damaged: " + what + " at byte " + std::to_string(address) + " " + why);
}

}  // namespace

void StructureWalk::take(std::uint64_t address, std::uint64_t bytes, bool is_values,
                         const std::string& what) {
  if (address > end_ || bytes > end_ - address) fail(what, address, "is beyond the end");
  taken_.push_back({address, bytes, is_values});
}

std::vector<std::byte> StructureWalk::block(std::uint64_t address, std::uint64_t bytes,
                                            const std::string& what) {
  take(address, bytes, false, what);
  read_bytes_ += bytes;
  // Blocks that overlap would make the walk longer than the file.
  if (bytes > most_block_bytes || read_bytes_ > end_) fail(what, address, "is too large");
  return read(address, bytes);
}

void StructureWalk::take_values(std::uint64_t address, std::uint64_t bytes,
                                const std::string& what) {
  take(address, bytes, true, what);
}

void StructureWalk::check_overlaps() {
  std::sort(taken_.begin(), taken_.end());
  taken_.erase(std::unique(taken_.begin(), taken_.end(),
                           [](const Taken& a, const Taken& b) { return a.is_values && a == b; }),
               taken_.end());
  for (std::size_t k = 1; k < taken_.size(); ++k) {
    const Taken& before = taken_[k - 1];
    if (before.address + before.bytes > taken_[k].address)
      fail("a block", before.address,
           "and one at byte " + std::to_string(taken_[k].address) + " overlap");
  }
}

std::optional<std::uint64_t> StructureWalk::next_object() {
  while (!objects_.empty()) {
    const std::uint64_t object = objects_.back();
    objects_.pop_back();
    if (!seen_.insert(object).second) continue;
    if (seen_.size() > most_objects) throw InputError("is damaged: it has too many objects");
    return object;
  }
  return std::nullopt;
}

std::optional<StructureWalk::Table> StructureWalk::next_table() {
  if (tables_.empty()) return std::nullopt;
  const Table table = tables_.back();
  tables_.pop_back();
  return table;
}

bool StructureWalk::enter(std::uint64_t address, const std::string& what) {
  const auto [place, is_new] = entered_.emplace(address, what);
  if (place->second != what) fail(what, address, "is " + place->second);
  return is_new;
}

}  // namespace pliant
