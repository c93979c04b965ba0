// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/h5md_series.hpp"

#include <hdf5.h>

#include <algorithm>
#include <limits>
#include <type_traits>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

static_assert(sizeof(hsize_t) == sizeof(std::uint64_t));

// A chunk is smaller than 4 GiB: longer rows are cut.
constexpr std::uint64_t longest_chunk_row = std::uint64_t{1} << 26;

Hid creation_properties(const SeriesLayout& layout) {
  Hid properties = owned(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make dataset properties");
  std::vector<hsize_t> chunk{layout.chunk_rows};
  for (const std::uint64_t extent : layout.row)
    chunk.push_back(std::min<hsize_t>(extent, longest_chunk_row));
  checked(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()),
          "choose the chunks");
  checked(H5Pset_obj_track_times(properties, false), "switch time stamps off");
  if (layout.compress) {
    checked(H5Pset_shuffle(properties), "choose the shuffle filter");
    checked(H5Pset_deflate(properties, 1), "choose the gzip filter");
  }
  if (layout.fill_with_nan) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    checked(H5Pset_fill_value(properties, H5T_NATIVE_DOUBLE, &nan), "choose the fill value");
  }
  return properties;
}

/// Rows come in whole chunks or once only: HDF5's chunk cache would keep them for nothing.
Hid access_properties(const SeriesLayout& layout) {
  Hid properties = owned(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose, "make access properties");
  if (layout.chunk_rows == 1)
    checked(H5Pset_chunk_cache(properties, 0, 0, H5D_CHUNK_CACHE_W0_DEFAULT),
            "switch the chunk cache off");
  return properties;
}

bool is_chunk_as_it_stands(const SeriesLayout& layout, hid_t file_type, hid_t memory_type) {
  return layout.chunk_rows == 1 && !layout.compress && !layout.row.empty() &&
         *std::max_element(layout.row.begin(), layout.row.end()) <= longest_chunk_row &&
         H5Tequal(file_type, memory_type) > 0;
}

}  // namespace

namespace {

std::vector<std::uint64_t> series_extents(hid_t dataset) {
  const Hid space = owned(H5Dget_space(dataset), H5Sclose, "look at a dataset");
  std::vector<hsize_t> extents(
      static_cast<std::size_t>(checked(H5Sget_simple_extent_ndims(space), "look at a dataset")));
  checked(H5Sget_simple_extent_dims(space, extents.data(), nullptr), "look at a dataset");
  return {extents.begin(), extents.end()};
}

SeriesLayout series_layout(hid_t dataset) {
  const Hid properties = owned(H5Dget_create_plist(dataset), H5Pclose, "look at a dataset");
  const std::vector<std::uint64_t> extents = series_extents(dataset);
  std::vector<hsize_t> chunk(extents.size());
  if (extents.empty() || H5Pget_layout(properties) != H5D_CHUNKED)
    throw FileError("a series is not laid out as this program lays it out");
  checked(H5Pget_chunk(properties, static_cast<int>(chunk.size()), chunk.data()), "look at chunks");
  return {.row = {extents.begin() + 1, extents.end()},
          .chunk_rows = chunk[0],
          .compress = H5Pget_nfilters(properties) > 0};
}

}  // namespace

Series::Series(std::int64_t location, const std::string& path, std::int64_t memory_type,
               std::uint64_t rows)
    : path_(path) {
  dataset_ = owned(H5Dopen2(location, path.c_str(), H5P_DEFAULT), H5Dclose, "open " + path);
  const SeriesLayout layout = series_layout(dataset_);
  dataset_.reset();  // properties are those of the first who opens it
  dataset_ =
      owned(H5Dopen2(location, path.c_str(), access_properties(layout)), H5Dclose, "open " + path);
  memory_type_ = owned(H5Tcopy(memory_type), H5Tclose, "copy a type");
  const Hid file_type = owned(H5Dget_type(dataset_), H5Tclose, "look at " + path);
  row_is_chunk_ = is_chunk_as_it_stands(layout, file_type, memory_type);
  extents_ = series_extents(dataset_);
  rows_there_ = extents_[0];
  if (rows_there_ < rows) throw FileError(path + " has fewer rows than frames");
  extents_[0] = rows;
}

Series::Series(std::int64_t location, const std::string& path, std::int64_t file_type,
               std::int64_t memory_type, const SeriesLayout& layout)
    : path_(path),
      row_is_chunk_(is_chunk_as_it_stands(layout, file_type, memory_type)),
      extents_{0} {
  extents_.insert(extents_.end(), layout.row.begin(), layout.row.end());
  std::vector<hsize_t> start(extents_.begin(), extents_.end()), limit = start;
  limit[0] = H5S_UNLIMITED;
  const Hid space =
      owned(H5Screate_simple(static_cast<int>(start.size()), start.data(), limit.data()), H5Sclose,
            "make a dataspace");
  memory_type_ = owned(H5Tcopy(memory_type), H5Tclose, "copy a type");
  dataset_ = owned(H5Dcreate2(location, path.c_str(), file_type, space, H5P_DEFAULT,
                              creation_properties(layout), access_properties(layout)),
                   H5Dclose, "make " + path);
}

void Series::write(std::uint64_t rows) {
  const std::uint64_t first = extents_[0];
  extents_[0] += rows;
  if (extents_[0] > rows_there_) set_extent();
  written_.swap(waiting_);
  waiting_.clear();
  row_is_chunk_ ? write_chunks(first, rows) : write_selected(first, rows);
}

void Series::set_extent() {
  const std::vector<hsize_t> extents(extents_.begin(), extents_.end());
  checked(H5Dset_extent(dataset_, extents.data()), "extend " + path_);
  rows_there_ = extents_[0];
}

void Series::cut() {
  if (rows_there_ > extents_[0]) set_extent();
}

std::vector<double> Series::last_row() const {
  std::vector<hsize_t> start(extents_.size(), 0), count(extents_.begin(), extents_.end());
  start[0] = extents_[0] - 1;
  count[0] = 1;
  std::size_t size = 1;
  for (const hsize_t extent : count) size *= extent;
  const Hid space = owned(H5Dget_space(dataset_), H5Sclose, "look at " + path_);
  checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
          "select rows of " + path_);
  const Hid memory = owned(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
                           H5Sclose, "make a dataspace");
  std::vector<double> row(size);
  checked(H5Dread(dataset_, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, row.data()),
          "read " + path_);
  return row;
}

void Series::write_selected(std::uint64_t first, std::uint64_t rows) {
  std::vector<hsize_t> start(extents_.size(), 0), count(extents_.begin(), extents_.end());
  start[0] = first;
  count[0] = rows;
  const Hid file_space = owned(H5Dget_space(dataset_), H5Sclose, "look at " + path_);
  checked(
      H5Sselect_hyperslab(file_space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
      "select rows of " + path_);
  const Hid memory_space =
      owned(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose,
            "make a dataspace");
  checked(H5Dwrite(dataset_, memory_type_, memory_space, file_space, H5P_DEFAULT, written_.data()),
          "write " + path_);
}

/// Straight to the file: H5Dwrite would make a chunk of fill values first and copy the row into it.
void Series::write_chunks(std::uint64_t first, std::uint64_t rows) {
  if (rows == 0) return;
  const std::size_t row_bytes = written_.size() / rows;
  std::vector<hsize_t> start(extents_.size(), 0);
  for (std::uint64_t row = 0; row < rows; ++row) {
    start[0] = first + row;
    checked(H5Dwrite_chunk(dataset_, H5P_DEFAULT, 0, start.data(), row_bytes,
                           written_.data() + row * row_bytes),
            "write " + path_);
  }
}

}  // namespace pliant
