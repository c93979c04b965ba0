// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/structure_trees.hpp"

#include <algorithm>
#include <string>

namespace pliant {
namespace {

constexpr std::uint64_t node_head_bytes = 24, address_bytes = 8, symbol_bytes = 40;

/// A node of a tree of version 1: its entries are still to be read.
struct TreeNode {
  std::uint64_t entries;
  StructureFields fields;
};

TreeNode read_node_head(const std::vector<std::byte>& bytes, std::uint64_t address,
                        std::uint64_t type, std::uint64_t level, std::uint64_t most) {
  StructureFields fields(bytes, place_in_file("tree node", address));
  fields.signature("TREE");
  fields.require(fields.number(1) == type, "is of another kind of tree");
  fields.require(fields.number(1) == level, "has another level than its parent says");
  const std::uint64_t entries = fields.number(2);
  fields.require(entries <= most, "has too many entries");
  fields.skip(2 * address_bytes);  // siblings, which readers do not follow
  return {entries, fields};
}

std::uint64_t level_of(StructureWalk& walk, std::uint64_t address) {
  if (address > walk.end() || walk.end() - address < node_head_bytes) return 0;
  return std::to_integer<std::uint64_t>(walk.read(address, node_head_bytes)[5]);
}

/// Names of a group of the old format.
class Heap {
 public:
  Heap(StructureWalk& walk, std::uint64_t address) : bytes_(read(walk, address)) {}

  std::uint64_t size() const { return bytes_.size(); }
  std::string text(std::uint64_t offset, const StructureFields& fields) const {
    fields.require(offset < bytes_.size(), "has a name outside of its heap");
    const std::span<const std::byte> all(bytes_);
    StructureFields from(all.subspan(offset), "heap of names");
    return from.text();
  }

 private:
  static std::vector<std::byte> read(StructureWalk& walk, std::uint64_t address) {
    const auto head = walk.block(address, 32, "heap");
    StructureFields fields(head, place_in_file("heap", address));
    fields.signature("HEAP");
    fields.require(fields.number(4) == 0, "is of an unknown version");
    const std::uint64_t bytes = fields.number(8), free = fields.number(8);
    const std::uint64_t data = fields.number(8);
    auto names = walk.block(data, bytes, "names of a heap");
    check_free_list(fields, names, free);
    return names;
  }

  static void check_free_list(const StructureFields& fields, const std::vector<std::byte>& bytes,
                              std::uint64_t free) {
    constexpr std::uint64_t none = 1;
    std::uint64_t left = bytes.size();
    while (free != none && free != no_address) {
      fields.require(free % 8 == 0 && free < bytes.size() && bytes.size() - free >= 16,
                     "has free space outside of it");
      const std::span<const std::byte> all(bytes);
      StructureFields entry(all.subspan(free, 16), "free space");
      const std::uint64_t next = entry.number(8), size = entry.number(8);
      fields.require(size >= 16 && size <= left && size <= bytes.size() - free,
                     "has free space that leads in a circle");
      left -= size;
      free = next;
    }
  }

  std::vector<std::byte> bytes_;
};

class GroupTree {
 public:
  GroupTree(StructureWalk& walk, std::uint64_t heap) : walk_(walk), heap_(walk, heap) {}

  void check(std::uint64_t address, std::uint64_t level) {
    if (!walk_.enter(address, "a node of a group")) return;
    const std::uint64_t most = 2 * walk_.sizes.group_node;
    const auto bytes =
        walk_.block(address, node_head_bytes + (2 * most + 1) * address_bytes, "tree node");
    auto [entries, fields] = read_node_head(bytes, address, 0, level, most);
    for (std::uint64_t k = 0; k < entries; ++k) {
      fields.require(fields.number(8) < heap_.size(), "has a key outside of its heap");
      const std::uint64_t child = fields.number(8);
      level > 0 ? check(child, level - 1) : check_symbols(child);
    }
  }

 private:
  void check_symbols(std::uint64_t address) {
    if (!walk_.enter(address, "a symbol node")) return;
    const std::uint64_t most = 2 * walk_.sizes.group_leaf;
    const auto bytes = walk_.block(address, 8 + most * symbol_bytes, "symbol node");
    StructureFields fields(bytes, place_in_file("symbol node", address));
    fields.signature("SNOD");
    fields.require(fields.number(2) == 1, "is of an unknown version");
    const std::uint64_t count = fields.number(2);
    fields.require(count <= most, "has too many symbols");
    std::string last;
    for (std::uint64_t k = 0; k < count; ++k) {
      const std::string name = check_symbol(fields);
      fields.require(name > last, "has names out of order");
      last = name;
    }
  }

  std::string check_symbol(StructureFields& fields) {
    std::string name = heap_.text(fields.number(8), fields);
    fields.require(!name.empty() && name.find('/') == std::string::npos, "has an empty name");
    const std::uint64_t object = fields.number(8), kind = fields.number(4);
    fields.skip(4);
    const std::uint64_t tree = fields.number(8);
    const std::uint64_t heap = fields.number(8);
    fields.require(kind <= 2, "has a symbol of an unknown kind");
    if (kind == 2) {
      heap_.text(tree & 0xffffffff, fields);
      return name;
    }
    walk_.visit_later(object);
    if (kind == 1) walk_.visit_later({tree, heap});
    return name;
  }

  StructureWalk& walk_;
  Heap heap_;
};

class ChunkTree {
 public:
  ChunkTree(StructureWalk& walk, const ChunkFacts& chunk) : walk_(walk), chunk_(chunk) {}

  void check(std::uint64_t address, std::uint64_t level) {
    if (!walk_.enter(address, "a node of a chunk tree")) return;
    const std::uint64_t most = 2 * walk_.sizes.chunk_node;
    const std::uint64_t key_bytes = 8 + 8 * (chunk_.extents.size() + 1);
    const std::uint64_t bytes = node_head_bytes + (most + 1) * key_bytes + most * address_bytes;
    const auto block = walk_.block(address, bytes, "tree node");
    auto [entries, fields] = read_node_head(block, address, 1, level, most);
    std::vector<std::uint64_t> last;
    for (std::uint64_t k = 0; k < entries; ++k) {
      const std::uint64_t stored = fields.number(4);
      fields.skip(4);  // filters that were left out
      std::vector<std::uint64_t> place = read_place(fields);
      fields.require(k == 0 || place > last, "has chunks out of order");
      last = std::move(place);
      const std::uint64_t child = fields.number(8);
      if (level > 0) {
        check(child, level - 1);
      } else {
        fields.require(stored > 0 && (chunk_.is_filtered || stored == chunk_.bytes),
                       "has a chunk of a wrong size");
        walk_.take_values(child, stored, "chunk");
      }
    }
  }

 private:
  std::vector<std::uint64_t> read_place(StructureFields& fields) {
    std::vector<std::uint64_t> place;
    for (const std::uint64_t extent : chunk_.extents) {
      place.push_back(fields.number(8));
      fields.require(place.back() % extent == 0, "has a chunk in a wrong place");
    }
    fields.require(fields.number(8) == 0, "has a chunk in a wrong place");
    return place;
  }

  StructureWalk& walk_;
  const ChunkFacts& chunk_;
};

constexpr std::uint64_t least_collection = 64;

/// The objects of a global heap collection.
std::map<std::uint64_t, std::uint64_t> read_collection(StructureWalk& walk, std::uint64_t address) {
  if (address > walk.end() || walk.end() - address < 16) walk.block(address, 16, "global heap");
  const auto head = walk.read(address, 16);
  StructureFields start(head, place_in_file("global heap", address));
  start.signature("GCOL");
  start.require(start.number(4) == 1, "is of an unknown version");
  const std::uint64_t bytes = start.number(8);
  start.require(bytes >= least_collection, "is too small");
  const auto block = walk.block(address, bytes, "global heap");
  StructureFields fields(block, place_in_file("global heap", address));
  fields.skip(16);
  std::map<std::uint64_t, std::uint64_t> objects;
  while (fields.left() >= 16) {
    const std::uint64_t index = fields.number(2);
    fields.skip(6);
    const std::uint64_t size = fields.number(8);
    if (index == 0) {  // what is free, to the end
      fields.require(size == fields.left() + 16, "has free space of a wrong size");
      break;
    }
    fields.require(objects.emplace(index, size).second, "has two objects of one number");
    fields.require(size <= fields.left(), "has an object beyond its end");
    fields.skip(std::min<std::uint64_t>((size + 7) / 8 * 8, fields.left()));
  }
  return objects;
}

}  // namespace

void check_symbol_table(StructureWalk& walk, StructureWalk::Table table) {
  const auto [tree, heap] = table;
  // The two belong together: they are known as a pair, by the heap.
  if (!walk.enter(heap, "the heap of tree " + std::to_string(tree))) return;
  GroupTree(walk, heap).check(tree, level_of(walk, tree));
}

void check_chunk_tree(StructureWalk& walk, std::uint64_t tree, const ChunkFacts& chunk) {
  ChunkTree(walk, chunk).check(tree, level_of(walk, tree));
}

void check_heap_references(StructureWalk& walk, std::span<const std::byte> references,
                           std::uint64_t item_bytes) {
  StructureFields fields(references, "values of variable length");
  while (fields.left() >= 16) {
    const std::uint64_t items = fields.number(4), address = fields.number(8);
    const std::uint64_t index = fields.number(4);
    if (items == 0 || address == 0 || address == no_address) continue;
    auto known = walk.heaps.find(address);
    if (known == walk.heaps.end())
      known = walk.heaps.emplace(address, read_collection(walk, address)).first;
    const auto object = known->second.find(index);
    fields.require(object != known->second.end() && object->second >= items * item_bytes,
                   "lead to nothing");
  }
}

}  // namespace pliant
