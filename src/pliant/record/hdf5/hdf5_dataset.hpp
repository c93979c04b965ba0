// SPDX-License-Identifier: MIT
// A dataset of an untrusted HDF5 file: reads only what the file holds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pliant/record/hdf5/expansion.hpp"
#include "pliant/record/hdf5/hdf5_session.hpp"

namespace pliant {

enum class ValueClass { integer, real, truth, named, text, other };

/// An open dataset whose values are in the file and can be decoded.
class Hdf5Dataset {
 public:
  /// Throws FileError on a filter that is not installed and on values in other files, InputError
  /// when `path` is no dataset.
  Hdf5Dataset(std::int64_t location, const std::string& path);

  std::int64_t id() const { return id_; }
  const std::string& path() const { return path_; }
  const std::vector<std::uint64_t>& extents() const { return extents_; }
  std::string shape() const;  ///< "(5, 10, 3)"
  ValueClass value_class() const { return class_; }
  std::size_t value_bytes() const { return value_bytes_; }

  /// Rows [first, first + count) of the first dimension, converted to the type of `out`, which
  /// has room for them. Throws InputError when they were never written.
  void read_rows(std::uint64_t first, std::uint64_t count, std::span<double> out) const;
  void read_rows(std::uint64_t first, std::uint64_t count, std::span<std::int64_t> out) const;

  /// All values. Throws InputError when the dataset states more than its file can hold.
  std::vector<double> reals() const;
  std::vector<std::int64_t> integers() const;
  std::vector<std::string> texts() const;

  /// Throws InputError unless the file can hold `values` values, in proportion to its size: see
  /// expansion.hpp.
  void check_plausible(std::uint64_t values) const;
  /// The same of its chunks and of one row: another library reads what it likes of them.
  void check_row() const;
  /// Names of an enumeration type by value, "" for those without; empty for other types.
  std::vector<std::string> value_names() const;

 private:
  struct Rows {
    Hid memory, file;  // dataspaces
  };

  Rows select_rows(std::uint64_t first, std::uint64_t count) const;
  Expansion expansion_of(std::uint64_t values, std::uint64_t at_once) const;
  Expansion measured() const;
  void refuse(const Expansion& expansion) const;
  std::uint64_t file_size() const;
  void check_source() const;
  void check_written(std::uint64_t first, std::uint64_t count) const;
  void read_numbers(std::uint64_t first, std::uint64_t count, std::int64_t memory_type,
                    void* out) const;
  std::uint64_t row_values() const;
  std::uint64_t value_count() const;
  std::vector<std::string> fixed_texts(std::size_t length) const;
  std::vector<std::string> variable_texts() const;

  std::string path_;
  Hid id_;
  Hid properties_;
  std::vector<std::uint64_t> extents_;
  std::vector<std::uint64_t> chunk_;  // empty: not chunked
  std::size_t value_bytes_ = 0;
  ValueClass class_ = ValueClass::other;
  // What the file holds, once it was asked for: HDF5 goes over all chunks.
  mutable std::optional<Expansion> stored_;
};

/// For a file that another library is to read. Throws as open_hdf5, and InputError where a dataset
/// would take memory out of proportion to the file. What cannot be opened is left to that library.
void check_hdf5(const std::filesystem::path& path);

}  // namespace pliant
