// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/structure_check.hpp"

#include <array>
#include <cstring>
#include <deque>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/record/hdf5/structure_messages.hpp"
#include "pliant/record/hdf5/structure_trees.hpp"

namespace pliant {
namespace {

constexpr char file_signature[] = {'\x89', 'H', 'D', 'F', '\r', '\n', '\x1a', '\n'};
constexpr std::uint64_t header_continuation = 0x10;
constexpr std::size_t checksum_bytes = 4;

/// Throws unless the last four bytes are the checksum of the others.
void check_sum(std::span<const std::byte> bytes, const StructureFields& fields) {
  fields.require(bytes.size() >= checksum_bytes, "ends too early");
  StructureFields sum(bytes.last(checksum_bytes), "checksum");
  fields.require(sum.number(4) == structure_checksum(bytes.first(bytes.size() - checksum_bytes)),
                 "has a wrong checksum");
}

/// The header of one object, in all its blocks.
class ObjectHeader {
 public:
  ObjectHeader(StructureWalk& walk, std::uint64_t address) : walk_(walk), address_(address) {}

  void check() {
    const auto start = first_bytes();
    std::memcmp(start.data(), "OHDR", 4) == 0 ? read_new(start) : read_old();
    while (!blocks_.empty()) {
      const auto [address, bytes] = blocks_.front();
      blocks_.pop_front();
      is_new_ ? read_new_block(address, bytes) : read_old_block(address, bytes);
    }
    const StructureFields fields({}, place_in_file("object header", address_));
    fields.require(is_new_ || messages_ == stated_messages_, "has not the messages that it states");
    check_object_facts(walk_, facts_, fields);
  }

 private:
  /// Bytes of the longest prefix, or what there is.
  std::vector<std::byte> first_bytes() const {
    constexpr std::uint64_t prefix = 32;
    if (address_ > walk_.end() || walk_.end() - address_ < 16)
      throw InputError("is damaged: " + place_in_file("object header", address_) +
                       " is beyond the end");
    return walk_.read(address_, std::min(prefix, walk_.end() - address_));
  }

  void read_old() {
    const auto bytes = walk_.block(address_, 16, "object header");
    StructureFields fields(bytes, place_in_file("object header", address_));
    fields.require(fields.number(1) == 1, "is of an unknown version");
    fields.skip(1);
    stated_messages_ = fields.number(2);
    fields.skip(4);
    const std::uint64_t size = fields.number(4);
    if (size > 0) read_old_block(address_ + 16, size);
  }

  void read_old_block(std::uint64_t address, std::uint64_t size) {
    const auto bytes = walk_.block(address, size, "object header");
    StructureFields fields(bytes, place_in_file("object header", address_));
    while (fields.left() >= 8) {
      const std::uint64_t type = fields.number(2), length = fields.number(2);
      const std::uint64_t flags = fields.number(1);
      fields.skip(3);
      fields.require(length % 8 == 0, "has a message of an uneven length");
      add(type, flags, fields.part(length, "message of kind " + std::to_string(type)));
    }
    fields.require(fields.left() == 0, "ends within a message");
  }

  void read_new(std::span<const std::byte> start) {
    is_new_ = true;
    StructureFields fields(start, place_in_file("object header", address_));
    fields.signature("OHDR");
    fields.require(fields.number(1) == 2, "is of an unknown version");
    flags_ = fields.number(1);
    fields.require(flags_ < 64, "has unknown flags");
    if ((flags_ & 32) != 0) fields.skip(16);
    if ((flags_ & 16) != 0) fields.skip(4);
    const std::uint64_t size = fields.number(std::size_t{1} << (flags_ & 3));
    fields.require(size < walk_.end(), "is too large");
    const auto bytes =
        walk_.block(address_, fields.position() + size + checksum_bytes, "object header");
    StructureFields all(bytes, place_in_file("object header", address_));
    check_sum(bytes, all);
    all.skip(fields.position());
    read_new_messages(all.part(size, "messages"));
  }

  void read_new_block(std::uint64_t address, std::uint64_t size) {
    const auto bytes = walk_.block(address, size, "object header");
    StructureFields fields(bytes, place_in_file("object header", address_));
    fields.signature("OCHK");
    check_sum(bytes, fields);
    fields.require(fields.left() >= checksum_bytes, "ends too early");
    read_new_messages(fields.part(fields.left() - checksum_bytes, "messages"));
  }

  void read_new_messages(StructureFields fields) {
    const std::size_t head = (flags_ & 4) != 0 ? 6 : 4;
    while (fields.left() >= head) {
      const std::uint64_t type = fields.number(1), length = fields.number(2);
      const std::uint64_t flags = fields.number(1);
      fields.skip(head - 4);
      add(type, flags, fields.part(length, "message of kind " + std::to_string(type)));
    }
  }

  void add(std::uint64_t type, std::uint64_t flags, StructureFields fields) {
    ++messages_;
    add_message(walk_, {type, flags, fields, is_new_}, facts_);
    if (type != header_continuation) return;
    const std::uint64_t address = fields.number(8);
    blocks_.emplace_back(address, fields.number(8));
  }

  StructureWalk& walk_;
  std::uint64_t address_;
  ObjectFacts facts_;
  std::deque<std::pair<std::uint64_t, std::uint64_t>> blocks_;  // that continue the header
  std::uint64_t stated_messages_ = 0, messages_ = 0, flags_ = 0;
  bool is_new_ = false;
};

void check_ends(StructureWalk& walk, StructureFields& fields, std::uint64_t base,
                std::uint64_t end) {
  fields.require(base == 0, "does not begin at the start of the file");
  fields.require(end <= walk.file_size(), "truncated file: " + std::to_string(end) +
                                              " bytes are stated, " +
                                              std::to_string(walk.file_size()) + " are there");
  walk.set_end(end);
}

void check_sizes(StructureFields& fields) {
  fields.require(fields.number(1) == 8 && fields.number(1) == 8, "has addresses of a rare size");
}

void read_old_superblock(StructureWalk& walk, StructureFields& fields, std::uint64_t version) {
  fields.skip(4);
  check_sizes(fields);
  fields.skip(1);
  walk.sizes.group_leaf = fields.number(2);
  walk.sizes.group_node = fields.number(2);
  fields.skip(4);
  if (version == 1) {
    walk.sizes.chunk_node = fields.number(2);
    fields.skip(2);
  }
  fields.require(walk.sizes.group_leaf > 0 && walk.sizes.group_node > 0 &&
                     walk.sizes.chunk_node > 0 && walk.sizes.chunk_node < 32768,
                 "states trees without entries");
  const std::uint64_t base = fields.number(8), free = fields.number(8), end = fields.number(8);
  check_ends(walk, fields, base, end);
  fields.require(free == no_address && fields.number(8) == no_address, "has a driver of its own");
  fields.skip(8);
  const std::uint64_t root = fields.number(8), kind = fields.number(4);
  fields.skip(4);
  const std::uint64_t tree = fields.number(8), heap = fields.number(8);
  fields.require(kind <= 1, "has a root of an unknown kind");
  walk.block(0, fields.position(), "superblock");
  walk.visit_later(root);
  if (kind == 1) walk.visit_later({tree, heap});
}

void read_new_superblock(StructureWalk& walk, StructureFields& fields) {
  check_sizes(fields);
  fields.skip(1);
  const std::uint64_t base = fields.number(8), extension = fields.number(8);
  const std::uint64_t end = fields.number(8), root = fields.number(8);
  check_sum(fields.all().first(fields.position() + checksum_bytes), fields);
  check_ends(walk, fields, base, end);
  walk.block(0, fields.position() + checksum_bytes, "superblock");
  walk.visit_later(root);
  if (extension != no_address) walk.leave_unchecked();
}

bool has_signature(std::span<const std::byte> bytes) {
  return bytes.size() >= sizeof file_signature &&
         std::memcmp(bytes.data(), file_signature, sizeof file_signature) == 0;
}

/// Something else may come first, which no program that we know does to trajectories.
void pass_user_block(StructureWalk& walk) {
  for (std::uint64_t at = 512; at + 100 < walk.file_size(); at *= 2)
    if (has_signature(walk.read(at, sizeof file_signature))) return walk.leave_unchecked();
  throw InputError("is not an HDF5 file");
}

void read_superblock(StructureWalk& walk) {
  constexpr std::uint64_t longest = 100;
  const auto bytes = walk.read(0, std::min(longest, walk.file_size()));
  if (!has_signature(bytes)) return pass_user_block(walk);
  StructureFields fields(bytes, "superblock");
  fields.skip(sizeof file_signature);
  const std::uint64_t version = fields.number(1);
  fields.require(version <= 3, "is of an unknown version");
  version <= 1 ? read_old_superblock(walk, fields, version) : read_new_superblock(walk, fields);
}

}  // namespace

bool check_hdf5_structure(const std::filesystem::path& path) {
  const StructureFile file(path);
  StructureWalk walk(file);
  read_superblock(walk);
  bool is_done = false;
  while (!is_done) {
    const auto object = walk.next_object();
    if (object) ObjectHeader(walk, *object).check();
    const auto table = walk.next_table();
    if (table) check_symbol_table(walk, *table);
    is_done = !object && !table;
  }
  walk.check_overlaps();
  return walk.is_complete();
}

}  // namespace pliant
