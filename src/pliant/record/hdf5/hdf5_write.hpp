// SPDX-License-Identifier: MIT
// Writes groups, datasets and attributes of a new HDF5 file in the few shapes that H5MD needs.
// Identifiers are HDF5's hid_t; all functions throw FileError naming what could not be written.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/parameter.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/record/hdf5/hdf5_session.hpp"

namespace pliant {

/// Makes a group at `path` below `location`, and missing groups on the way.
Hid make_group(std::int64_t location, const std::string& path);

/// Scalar UTF-8 string of variable length: the only kind that MDAnalysis takes as a unit.
void write_text_attribute(std::int64_t object, const char* name, const std::string& text);
void write_integer_attribute(std::int64_t object, const char* name, std::span<const int> values);
/// Writes a scalar.
void write_real_attribute(std::int64_t object, const char* name, double value);
/// Writes a scalar.
void write_integer_attribute(std::int64_t object, const char* name, int value);
void write_text_attribute(std::int64_t object, const char* name,
                          std::span<const std::string> texts);
/// Reference to the object at `target` (an absolute path of the same file).
void write_reference_attribute(std::int64_t object, const char* name, const char* target);

/// (n) little-endian numbers at `path`.
Hid write_numbers(std::int64_t location, const std::string& path, std::span<const double> values);
Hid write_numbers(std::int64_t location, const std::string& path,
                  std::span<const std::int64_t> values);
Hid write_numbers(std::int64_t location, const std::string& path,
                  std::span<const std::uint32_t> values);
Hid write_numbers(std::int64_t location, const std::string& path,
                  std::span<const std::uint8_t> values);
/// (rows, columns) little-endian numbers, row by row.
Hid write_table(std::int64_t location, const std::string& path, std::size_t rows,
                std::size_t columns, std::span<const double> values);
Hid write_table(std::int64_t location, const std::string& path, std::size_t rows,
                std::size_t columns, std::span<const std::uint32_t> values);
/// (n, 2) joints.
Hid write_pairs(std::int64_t location, const std::string& path, std::span<const Bar> pairs);
/// (n) truth values, in the enumeration {FALSE, TRUE} that h5py reads as bool.
Hid write_booleans(std::int64_t location, const std::string& path,
                   std::span<const std::uint8_t> values);
/// (n) numbers that stand for names: an enumeration type keeps the names.
Hid write_named_numbers(std::int64_t location, const std::string& path,
                        std::span<const std::uint8_t> values, std::span<const std::string> names);
/// (n) strings of the length of the longest, UTF-8, padded with NUL.
Hid write_texts(std::int64_t location, const std::string& path,
                const std::vector<std::string>& texts);
/// Writes a scalar dataset.
void write_parameter(std::int64_t location, const std::string& path, const Parameter& value);

/// Overwrites the integer at `path`.
void rewrite_integer(std::int64_t location, const std::string& path, std::int64_t value);

/// Enumeration types of one byte, for the functions above.
Hid boolean_type();
Hid named_number_type(std::span<const std::string> names);

/// Address of the object at `path` in the file.
std::uint64_t object_address(std::int64_t location, const std::string& path);

/// `text`, or, if it is not UTF-8, with each byte above 127 as \xNN so that readers can decode it.
std::string as_utf8(const std::string& text);

}  // namespace pliant
