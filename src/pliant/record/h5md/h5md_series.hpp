// SPDX-License-Identifier: MIT
// Series: a growing HDF5 dataset with one row a frame, and the rows that wait to be written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pliant/record/hdf5/hdf5_session.hpp"

namespace pliant {

/// Shape of a series in the file.
struct SeriesLayout {
  std::vector<std::uint64_t> row;  ///< extents of one row; empty: a number
  std::uint64_t chunk_rows = 256;  ///< rows a chunk
  bool compress = false;           ///< shuffle and gzip 1; chunk_rows must be 1
  bool fill_with_nan = false;      ///< value that readers see in place of a lost chunk
};

/// Rows are added in memory, then written together.
class Series {
 public:
  /// Makes an empty dataset at `path`. Types are hid_t; rows are given in `memory_type`.
  Series(std::int64_t location, const std::string& path, std::int64_t file_type,
         std::int64_t memory_type, const SeriesLayout& layout = {});

  /// Opens the dataset at `path`, to continue after its first `rows` rows. Throws FileError if it
  /// has fewer.
  Series(std::int64_t location, const std::string& path, std::int64_t memory_type,
         std::uint64_t rows);

  template <class T>
  void add(const T& value) {
    add_bytes(std::as_bytes(std::span(&value, 1)));
  }
  void add_bytes(std::span<const std::byte> bytes) {
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  }
  std::span<const std::byte> waiting() const { return waiting_; }
  /// Appends `rows` waiting rows to the dataset, overwriting what an interrupted commit left beyond
  /// the last row. What was waiting() stays where it is until the next rows are written. Throws
  /// FileError.
  void write(std::uint64_t rows);
  /// Cuts off all rows beyond those that were written. Throws FileError.
  void cut();

  /// The last row that was written, as numbers. Throws FileError.
  std::vector<double> last_row() const;

  std::int64_t dataset() const { return dataset_; }

 private:
  void set_extent();
  void write_selected(std::uint64_t first, std::uint64_t rows);
  void write_chunks(std::uint64_t first, std::uint64_t rows);

  std::string path_;
  Hid memory_type_;
  Hid dataset_;
  bool row_is_chunk_ = false;           ///< and has the same bytes in memory as in the file
  std::vector<std::uint64_t> extents_;  ///< of the valid rows
  std::uint64_t rows_there_ = 0;        ///< number of rows, those of an interrupted commit included
  std::vector<std::byte> waiting_, written_;
};

}  // namespace pliant
