// SPDX-License-Identifier: MIT
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <optional>

#include "pliant/base/error.hpp"
#include "pliant/record/hdf5/hdf5_dataset.hpp"
#include "pliant/record/hdf5/hdf5_read.hpp"

namespace pliant {
namespace {

constexpr std::uint64_t texts_at_once = 64;  // of variable length

bool is_truth_type(hid_t type) {
  if (H5Tget_nmembers(type) != 2) return false;
  std::string names;
  for (unsigned member = 0; member < 2; ++member) {
    char* name = H5Tget_member_name(type, member);
    if (name != nullptr) names += std::string(name) + " ";
    H5free_memory(name);
  }
  return names == "FALSE TRUE " || names == "TRUE FALSE ";
}

ValueClass class_of(hid_t type) {
  switch (H5Tget_class(type)) {
    case H5T_INTEGER:
      return ValueClass::integer;
    case H5T_FLOAT:
      return ValueClass::real;
    case H5T_ENUM:
      return is_truth_type(type) ? ValueClass::truth : ValueClass::named;
    case H5T_STRING:
      return ValueClass::text;
    default:
      return ValueClass::other;
  }
}

std::vector<std::uint64_t> extents_of(hid_t dataset) {
  const Hid space = owned(H5Dget_space(dataset), H5Sclose, "look at a dataset");
  const int rank = checked(H5Sget_simple_extent_ndims(space), "look at a dataset");
  std::vector<hsize_t> extents(static_cast<std::size_t>(rank));
  if (rank > 0)
    checked(H5Sget_simple_extent_dims(space, extents.data(), nullptr), "look at a dataset");
  return {extents.begin(), extents.end()};
}

std::vector<std::uint64_t> chunk_of(hid_t properties, std::size_t rank) {
  if (H5Pget_layout(properties) != H5D_CHUNKED) return {};
  std::vector<hsize_t> chunk(rank);
  checked(H5Pget_chunk(properties, static_cast<int>(rank), chunk.data()), "look at chunks");
  return {chunk.begin(), chunk.end()};
}

std::string trimmed_text(std::string text) {
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

}  // namespace

Hdf5Dataset::Hdf5Dataset(std::int64_t location, const std::string& path)
    : path_(path), id_(open_object(location, path)) {
  if (H5Iget_type(id_) != H5I_DATASET) throw InputError(path_ + " is not a dataset");
  properties_ = owned(H5Dget_create_plist(id_), H5Pclose, "look at " + path_);
  extents_ = extents_of(id_);
  chunk_ = chunk_of(properties_, extents_.size());
  const Hid type = owned(H5Dget_type(id_), H5Tclose, "look at " + path_);
  class_ = class_of(type);
  value_bytes_ = H5Tget_size(type);
  check_source();
}

void Hdf5Dataset::check_source() const {
  if (H5Pget_external_count(properties_) > 0 || H5Pget_layout(properties_) == H5D_VIRTUAL)
    throw FileError(path_ + " has its values in other files, which are not read");
  const int filters = H5Pget_nfilters(properties_);
  for (int k = 0; k < filters; ++k) {
    unsigned flags = 0, config = 0;
    std::size_t parameters = 0;
    std::array<char, 64> name{};
    const H5Z_filter_t filter =
        H5Pget_filter2(properties_, static_cast<unsigned>(k), &flags, &parameters, nullptr,
                       name.size() - 1, name.data(), &config);
    if (filter < 0 || H5Zfilter_avail(filter) <= 0)
      throw FileError(path_ + " is packed with filter " + std::to_string(filter) + " (" +
                      pliant::quoted(name.data()) + "), which HDF5 does not have here");
  }
}

std::string Hdf5Dataset::shape() const {
  std::string text = "(";
  for (std::size_t k = 0; k < extents_.size(); ++k)
    text += (k == 0 ? "" : ", ") + std::to_string(extents_[k]);
  return text + ")";
}

std::uint64_t Hdf5Dataset::row_values() const {
  std::uint64_t values = 1;
  for (std::size_t k = 1; k < extents_.size(); ++k) values = times(values, extents_[k]);
  return values;
}

std::uint64_t Hdf5Dataset::value_count() const {
  return extents_.empty() ? 1 : times(extents_[0], row_values());
}

void Hdf5Dataset::check_plausible(std::uint64_t values) const {
  refuse(expansion_of(values, values));
}

void Hdf5Dataset::check_row() const {
  if (!chunk_.empty() && H5Dget_storage_size(id_) > 0) refuse(expansion_of(0, row_values()));
}

Expansion Hdf5Dataset::expansion_of(std::uint64_t values, std::uint64_t at_once) const {
  if (!stored_) stored_ = measured();
  Expansion expansion = *stored_;
  expansion.values = times(values, value_bytes_);
  expansion.at_once = times(at_once, value_bytes_);
  return expansion;
}

Expansion Hdf5Dataset::measured() const {
  Expansion expansion{.chunk = chunk_.empty() ? 0 : value_bytes_,
                      .stored = H5Dget_storage_size(id_),
                      .file_size = file_size()};
  for (const std::uint64_t extent : chunk_) expansion.chunk = times(expansion.chunk, extent);
  if (expansion.chunk > large_expansion) {
    hsize_t chunks = 0;
    const Hid space = owned(H5Dget_space(id_), H5Sclose, "look at " + path_);
    checked(H5Dget_num_chunks(id_, space, &chunks), "count the chunks of " + path_);
    expansion.chunks = chunks;
  }
  return expansion;
}

void Hdf5Dataset::refuse(const Expansion& expansion) const {
  if (const std::string why = refusal_of(expansion); !why.empty())
    throw InputError(path_ + " of shape " + shape() + " " + why);
}

std::uint64_t Hdf5Dataset::file_size() const {
  hsize_t size = 0;
  const Hid file = owned(H5Iget_file_id(id_), H5Fclose, "look at the file of " + path_);
  checked(H5Fget_filesize(file, &size), "look at the size of the file");
  return size;
}

/// A chunk that is not there reads as fill values, which look like values.
void Hdf5Dataset::check_written(std::uint64_t first, std::uint64_t count) const {
  check_plausible(times(count, row_values()));
  if (chunk_.empty()) return;
  std::vector<hsize_t> at(chunk_.size(), 0);
  for (std::uint64_t row = first - first % chunk_[0]; row < first + count; row += chunk_[0]) {
    hsize_t bytes = 0;
    at[0] = row;
    if (H5Dget_chunk_storage_size(id_, at.data(), &bytes) < 0 || bytes == 0)
      throw InputError(path_ + ": row " + std::to_string(std::max(row, first)) +
                       " was never written, or is damaged");
  }
}

void Hdf5Dataset::read_numbers(std::uint64_t first, std::uint64_t count, std::int64_t memory_type,
                               void* out) const {
  if (class_ == ValueClass::text || class_ == ValueClass::other)
    throw InputError(path_ + " has no numbers");
  if (count == 0 || row_values() == 0) return;
  check_written(first, count);
  const Rows rows = select_rows(first, count);
  checked(H5Dread(id_, memory_type, rows.memory, rows.file, H5P_DEFAULT, out), "read " + path_);
}

Hdf5Dataset::Rows Hdf5Dataset::select_rows(std::uint64_t first, std::uint64_t count) const {
  Hid space = owned(H5Dget_space(id_), H5Sclose, "look at " + path_);
  if (extents_.empty())
    return {owned(H5Scopy(space), H5Sclose, "look at " + path_), std::move(space)};
  std::vector<hsize_t> start(extents_.size(), 0), rows(extents_.begin(), extents_.end());
  start[0] = first;
  rows[0] = count;
  checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, rows.data(), nullptr),
          "select rows of " + path_);
  return {owned(H5Screate_simple(static_cast<int>(rows.size()), rows.data(), nullptr), H5Sclose,
                "make a dataspace"),
          std::move(space)};
}

void Hdf5Dataset::read_rows(std::uint64_t first, std::uint64_t count, std::span<double> out) const {
  if (out.size() < times(count, row_values())) throw Error(path_ + ": no room for its values");
  read_numbers(first, count, H5T_NATIVE_DOUBLE, out.data());
}

void Hdf5Dataset::read_rows(std::uint64_t first, std::uint64_t count,
                            std::span<std::int64_t> out) const {
  if (out.size() < times(count, row_values())) throw Error(path_ + ": no room for its values");
  read_numbers(first, count, H5T_NATIVE_INT64, out.data());
}

std::vector<double> Hdf5Dataset::reals() const {
  check_plausible(value_count());
  std::vector<double> values(value_count());
  read_numbers(0, extents_.empty() ? 1 : extents_[0], H5T_NATIVE_DOUBLE, values.data());
  return values;
}

std::vector<std::int64_t> Hdf5Dataset::integers() const {
  check_plausible(value_count());
  std::vector<std::int64_t> values(value_count());
  read_numbers(0, extents_.empty() ? 1 : extents_[0], H5T_NATIVE_INT64, values.data());
  return values;
}

std::vector<std::string> Hdf5Dataset::texts() const {
  if (class_ != ValueClass::text) throw InputError(path_ + " has no texts");
  check_plausible(value_count());
  const Hid type = owned(H5Dget_type(id_), H5Tclose, "look at " + path_);
  if (value_count() == 0) return {};
  return H5Tis_variable_str(type) > 0 ? variable_texts() : fixed_texts(value_bytes_);
}

std::vector<std::string> Hdf5Dataset::fixed_texts(std::size_t length) const {
  std::vector<char> table(value_count() * length);
  const Hid type = owned(H5Dget_type(id_), H5Tclose, "look at " + path_);
  checked(H5Dread(id_, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.data()), "read " + path_);
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < table.size(); at += length)
    texts.push_back(trimmed_text({table.data() + at, length}));
  return texts;
}

std::vector<std::string> Hdf5Dataset::variable_texts() const {
  const Hid type = owned(H5Dget_type(id_), H5Tclose, "look at " + path_);
  std::vector<std::string> texts;
  const std::uint64_t rows = extents_.empty() ? 1 : extents_[0];
  Expansion expansion{.stored = file_size(), .file_size = file_size()};
  for (std::uint64_t first = 0; first < rows; first += texts_at_once) {
    const std::uint64_t count = std::min(rows - first, texts_at_once);
    const Rows part = select_rows(first, count);
    std::vector<char*> pointers(count * row_values(), nullptr);
    checked(H5Dread(id_, type, part.memory, part.file, H5P_DEFAULT, pointers.data()),
            "read " + path_);
    for (const char* pointer : pointers) {
      texts.emplace_back(pointer == nullptr ? "" : pointer);
      expansion.at_once += texts.back().size();
    }
    H5Dvlen_reclaim(type, part.memory, H5P_DEFAULT, pointers.data());
    refuse(expansion);  // many texts may be one place in the file
  }
  return texts;
}

std::vector<std::string> Hdf5Dataset::value_names() const {
  std::vector<std::string> names;
  const Hid type = owned(H5Dget_type(id_), H5Tclose, "look at " + path_);
  if (H5Tget_class(type) != H5T_ENUM) return names;
  const int members = H5Tget_nmembers(type);
  for (int member = 0; member < members; ++member) {
    std::array<unsigned char, 16> value{};
    if (H5Tget_size(type) != 1) return {};
    checked(H5Tget_member_value(type, static_cast<unsigned>(member), value.data()),
            "look at " + path_);
    char* name = H5Tget_member_name(type, static_cast<unsigned>(member));
    if (value[0] >= names.size()) names.resize(value[0] + std::size_t{1});
    if (name != nullptr) names[value[0]] = name;
    H5free_memory(name);
  }
  return names;
}

void check_hdf5(const std::filesystem::path& path) {
  const Hdf5Session session;
  const Hid file = open_hdf5(path);
  for (const std::string& name : datasets_below(file, "/")) {
    std::optional<Hdf5Dataset> dataset;
    try {
      dataset.emplace(file, "/" + name);
    } catch (const Error&) {
      continue;
    }
    dataset->check_row();
  }
}

}  // namespace pliant
