// SPDX-License-Identifier: MIT
// Trees, heaps and symbol nodes of an HDF5 file that may be damaged: traversed, or refused. HDF5
// File Format Specification 3.0, III.A.1, III.B, III.D and III.E.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/record/hdf5/structure_walk.hpp"

namespace pliant {

/// Checks a group of the old format: its tree of symbol nodes, and the heap of their names. Objects
/// that it leads to are visited later.
void check_symbol_table(StructureWalk& walk, StructureWalk::Table table);

/// Properties of the chunks of a dataset.
struct ChunkFacts {
  std::vector<std::uint64_t> extents;  ///< of a chunk, in values
  std::uint64_t bytes = 0;             ///< of an unfiltered chunk
  bool is_filtered = false;
};

void check_chunk_tree(StructureWalk& walk, std::uint64_t tree, const ChunkFacts& chunk);

/// Checks references to values of variable length: 16 bytes each, with `item_bytes` an item.
void check_heap_references(StructureWalk& walk, std::span<const std::byte> references,
                           std::uint64_t item_bytes);

}  // namespace pliant
