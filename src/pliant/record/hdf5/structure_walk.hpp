// SPDX-License-Identifier: MIT
// State of a walk through the structure of an HDF5 file: its bytes, which blocks are in use, and
// what remains to be visited.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pliant/record/hdf5/structure_fields.hpp"

namespace pliant {

/// Sizes of tree nodes and group nodes, from the superblock.
struct StructureSizes {
  std::uint64_t group_leaf = 4, group_node = 16, chunk_node = 32;
};

/// Each block is read once, and blocks must not overlap, so that the walk terminates.
class StructureWalk {
 public:
  explicit StructureWalk(const StructureFile& file) : file_(file), end_(file.size()) {}

  /// Reads a block of metadata and marks it as used. Throws InputError where it is not in the file.
  std::vector<std::byte> block(std::uint64_t address, std::uint64_t bytes, const std::string& what);
  /// Marks bytes of values as used. The same bytes may be used again as a whole.
  void take_values(std::uint64_t address, std::uint64_t bytes, const std::string& what);
  /// Reads bytes that are marked as used.
  std::vector<std::byte> read(std::uint64_t address, std::size_t bytes) const {
    return file_.read(address, bytes);
  }
  /// Throws InputError if blocks overlap.
  void check_overlaps();

  /// Sets the end of the file according to its superblock.
  void set_end(std::uint64_t end) { end_ = end; }
  std::uint64_t end() const { return end_; }
  std::uint64_t file_size() const { return file_.size(); }

  /// Adds an object to be visited.
  void visit_later(std::uint64_t object) { objects_.push_back(object); }
  /// Returns an object that was not visited yet.
  std::optional<std::uint64_t> next_object();

  /// The tree and the heap of a group of the old format.
  struct Table {
    std::uint64_t tree, heap;
  };
  /// Adds a group to be visited; groups may be nested too deeply for recursion.
  void visit_later(Table table) { tables_.push_back(table); }
  std::optional<Table> next_table();

  /// Returns false if the address was entered before. Throws InputError if it was entered as
  /// something else.
  bool enter(std::uint64_t address, const std::string& what);

  /// Notes that something was not checked: formats that our files do not have.
  void leave_unchecked() { is_complete_ = false; }
  bool is_complete() const { return is_complete_; }

  StructureSizes sizes;

  /// Global heap collections: size of each object by its number.
  std::map<std::uint64_t, std::map<std::uint64_t, std::uint64_t>> heaps;

 private:
  struct Taken {
    std::uint64_t address, bytes;
    bool is_values;
    auto operator<=>(const Taken&) const = default;
  };

  void take(std::uint64_t address, std::uint64_t bytes, bool is_values, const std::string& what);

  const StructureFile& file_;
  std::uint64_t end_;
  std::vector<Taken> taken_;
  std::vector<std::uint64_t> objects_;
  std::vector<Table> tables_;
  std::set<std::uint64_t> seen_;
  std::map<std::uint64_t, std::string> entered_;
  std::uint64_t read_bytes_ = 0;
  bool is_complete_ = true;
};

}  // namespace pliant
