// SPDX-License-Identifier: MIT
// Messages in object headers of an HDF5 file that may be damaged: decoded, or refused. HDF5 File
// Format Specification 3.0, IV.A.2.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pliant/record/hdf5/structure_types.hpp"
#include "pliant/record/hdf5/structure_walk.hpp"

namespace pliant {

/// Location of the values of a dataset.
struct LayoutFacts {
  enum Kind { compact, contiguous, chunked, unknown } kind = unknown;
  std::uint64_t address = no_address;
  std::uint64_t bytes = 0;             ///< of compact and contiguous values
  std::vector<std::uint64_t> extents;  ///< of a chunk; the last is the size of a value
  std::vector<std::byte> values = {};  ///< compact ones
};

/// What the messages of one object say.
struct ObjectFacts {
  std::optional<SpaceFacts> space;
  std::optional<TypeFacts> type;
  std::optional<LayoutFacts> layout;
  std::optional<std::uint64_t> fill_bytes;
  bool is_filtered = false;
  bool has_links = false;
  bool is_unchecked = false;  ///< some message was not checked
};

/// One message of a header: `type` and `flags` as in the file.
struct HeaderMessage {
  std::uint64_t type, flags;
  StructureFields fields;
  bool has_checksum;
};

/// Adds what a message says to `facts`. Throws InputError if it is invalid.
void add_message(StructureWalk& walk, const HeaderMessage& message, ObjectFacts& facts);

/// Throws InputError if the parts of an object contradict each other.
void check_object_facts(StructureWalk& walk, const ObjectFacts& facts,
                        const StructureFields& header);

}  // namespace pliant
