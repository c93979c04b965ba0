// SPDX-License-Identifier: MIT
// Datatypes and dataspaces of an HDF5 file that may be damaged: decoded, or refused. HDF5 File
// Format Specification 3.0, IV.A.2.b and IV.A.2.d.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/record/hdf5/structure_fields.hpp"

namespace pliant {

/// Properties of a datatype.
struct TypeFacts {
  std::uint64_t bytes = 0;          ///< of one value
  bool is_variable = false;         ///< its values are in global heaps
  std::uint64_t item_bytes = 0;     ///< of one item of such a value
  bool has_variable_parts = false;  ///< has variable members or elements, which are not checked
};

/// Thrown for a datatype of an unknown format.
struct UnknownDatatype {};

/// Reads a datatype. Throws InputError when it is invalid, or UnknownDatatype.
TypeFacts check_datatype(StructureFields& fields, int level = 0);

/// Extents of a dataset; empty for a single value.
struct SpaceFacts {
  std::vector<std::uint64_t> extents;
  std::uint64_t count = 1;  ///< of values
};

/// Reads a dataspace. Throws InputError when it is invalid. A count that overflows becomes the
/// largest number.
SpaceFacts check_dataspace(StructureFields& fields);

}  // namespace pliant
