// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/hdf5_write.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace pliant {
namespace {

Hid scalar_space() { return owned(H5Screate(H5S_SCALAR), H5Sclose, "make a dataspace"); }

Hid array_space(std::size_t rows) {
  const hsize_t extent = rows;
  return owned(H5Screate_simple(1, &extent, nullptr), H5Sclose, "make a dataspace");
}

/// `size` in bytes, or H5T_VARIABLE.
Hid text_type(std::size_t size) {
  Hid type = owned(H5Tcopy(H5T_C_S1), H5Tclose, "make a string type");
  checked(H5Tset_size(type, size), "set the length of a string type");
  checked(H5Tset_cset(type, H5T_CSET_UTF8), "set the encoding of a string type");
  if (size != H5T_VARIABLE) checked(H5Tset_strpad(type, H5T_STR_NULLPAD), "pad a string type");
  return type;
}

/// Groups on the way are made. A name in UTF-8 makes HDF5 keep the links of its group in the newer
/// way: more than eight in a heap and a tree ("dense"), which it cannot list without crashing once
/// a byte of them is wrong. So only what is no ASCII is called UTF-8.
Hid link_properties(const std::string& path) {
  Hid properties = owned(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "make link properties");
  checked(H5Pset_create_intermediate_group(properties, 1), "ask for intermediate groups");
  const bool is_ascii =
      std::all_of(path.begin(), path.end(), [](char c) { return (c & 0x80) == 0; });
  checked(H5Pset_char_encoding(properties, is_ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8),
          "set the encoding of names");
  return properties;
}

/// No times are kept, so that the same run writes the same bytes.
Hid dataset_properties() {
  Hid properties = owned(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make dataset properties");
  checked(H5Pset_obj_track_times(properties, false), "switch time stamps off");
  return properties;
}

/// HDF5 converts values in a buffer that it fills with zeros first: of 1 MiB, for each number and
/// each text, unless another size is asked for. Short texts need little of it.
Hid transfer_properties() {
  constexpr std::size_t bytes = std::size_t{1} << 14;
  Hid properties = owned(H5Pcreate(H5P_DATASET_XFER), H5Pclose, "make transfer properties");
  checked(H5Pset_buffer(properties, bytes, nullptr, nullptr), "choose the buffer of conversions");
  return properties;
}

void write_attribute(hid_t object, const char* name, hid_t file_type, hid_t memory_type,
                     hid_t space, const void* value) {
  const std::string what = "write the attribute " + std::string(name);
  const Hid attribute =
      owned(H5Acreate2(object, name, file_type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, what);
  checked(H5Awrite(attribute, memory_type, value), what);
}

Hid write_dataset(hid_t location, const std::string& path, hid_t file_type, hid_t memory_type,
                  hid_t space, const void* values) {
  const std::string what = "write " + path;
  Hid dataset = owned(H5Dcreate2(location, path.c_str(), file_type, space, link_properties(path),
                                 dataset_properties(), H5P_DEFAULT),
                      H5Dclose, what);
  if (H5Sget_simple_extent_npoints(space) > 0)
    checked(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, transfer_properties(), values), what);
  return dataset;
}

template <class T>
Hid write_array(hid_t location, const std::string& path, hid_t file_type, hid_t memory_type,
                std::span<const T> values) {
  return write_dataset(location, path, file_type, memory_type, array_space(values.size()),
                       values.data());
}

bool is_utf8(const std::string& text) {
  std::size_t rest = 0;  // continuation bytes still to come
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (rest > 0) {
      if ((byte & 0xc0) != 0x80) return false;
      --rest;
    } else if (byte >= 0x80) {
      if (byte < 0xc2 || byte > 0xf4) return false;
      rest = byte < 0xe0 ? 1 : byte < 0xf0 ? 2 : 3;
    }
  }
  return rest == 0;
}

void insert_name(hid_t type, const std::string& name, std::uint8_t number) {
  checked(H5Tenum_insert(type, name.c_str(), &number), "name the value " + name);
}

struct ParameterWriter {
  hid_t location;
  const std::string& path;

  void operator()(std::int64_t value) const {
    write_dataset(location, path, H5T_STD_I64LE, H5T_NATIVE_INT64, scalar_space(), &value);
  }
  void operator()(double value) const {
    write_dataset(location, path, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, scalar_space(), &value);
  }
  void operator()(bool value) const {
    const Hid type = boolean_type();
    const std::uint8_t number = value ? 1 : 0;
    write_dataset(location, path, type, type, scalar_space(), &number);
  }
  void operator()(const std::string& value) const {
    const Hid type = text_type(H5T_VARIABLE);
    const std::string text = as_utf8(value);
    const char* pointer = text.c_str();
    write_dataset(location, path, type, type, scalar_space(), &pointer);
  }
};

}  // namespace

std::string as_utf8(const std::string& text) {
  if (is_utf8(text)) return text;
  constexpr char hex[] = "0123456789abcdef";
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      out += c;
    } else {
      out += {'\\', 'x', hex[byte >> 4], hex[byte & 15]};
    }
  }
  return out;
}

Hid make_group(std::int64_t location, const std::string& path) {
  const Hid properties = owned(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "make group properties");
  checked(H5Pset_obj_track_times(properties, false), "switch time stamps off");
  return owned(H5Gcreate2(location, path.c_str(), link_properties(path), properties, H5P_DEFAULT),
               H5Gclose, "make the group " + path);
}

void write_text_attribute(std::int64_t object, const char* name, const std::string& text) {
  const Hid type = text_type(H5T_VARIABLE);
  const std::string value = as_utf8(text);
  const char* pointer = value.c_str();
  write_attribute(object, name, type, type, scalar_space(), &pointer);
}

void write_text_attribute(std::int64_t object, const char* name,
                          std::span<const std::string> texts) {
  const Hid type = text_type(H5T_VARIABLE);
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  write_attribute(object, name, type, type, array_space(texts.size()), pointers.data());
}

void write_integer_attribute(std::int64_t object, const char* name, std::span<const int> values) {
  write_attribute(object, name, H5T_STD_I32LE, H5T_NATIVE_INT, array_space(values.size()),
                  values.data());
}

void write_integer_attribute(std::int64_t object, const char* name, int value) {
  write_attribute(object, name, H5T_STD_I32LE, H5T_NATIVE_INT, scalar_space(), &value);
}

void write_real_attribute(std::int64_t object, const char* name, double value) {
  write_attribute(object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, scalar_space(), &value);
}

std::uint64_t object_address(std::int64_t location, const std::string& path) {
  hobj_ref_t reference;  // which is the address of the object's header
  checked(H5Rcreate(&reference, location, path.c_str(), H5R_OBJECT, -1), "find " + path);
  return reference;
}

void write_reference_attribute(std::int64_t object, const char* name, const char* target) {
  const hobj_ref_t reference = object_address(object, target);
  write_attribute(object, name, H5T_STD_REF_OBJ, H5T_STD_REF_OBJ, scalar_space(), &reference);
}

Hid write_numbers(std::int64_t location, const std::string& path, std::span<const double> values) {
  return write_array(location, path, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values);
}

Hid write_numbers(std::int64_t location, const std::string& path,
                  std::span<const std::int64_t> values) {
  return write_array(location, path, H5T_STD_I64LE, H5T_NATIVE_INT64, values);
}

Hid write_numbers(std::int64_t location, const std::string& path,
                  std::span<const std::uint32_t> values) {
  return write_array(location, path, H5T_STD_U32LE, H5T_NATIVE_UINT32, values);
}

Hid write_numbers(std::int64_t location, const std::string& path,
                  std::span<const std::uint8_t> values) {
  return write_array(location, path, H5T_STD_U8LE, H5T_NATIVE_UINT8, values);
}

Hid write_table(std::int64_t location, const std::string& path, std::size_t rows,
                std::size_t columns, std::span<const double> values) {
  const hsize_t extents[] = {rows, columns};
  const Hid space = owned(H5Screate_simple(2, extents, nullptr), H5Sclose, "make a dataspace");
  return write_dataset(location, path, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, space, values.data());
}

Hid write_table(std::int64_t location, const std::string& path, std::size_t rows,
                std::size_t columns, std::span<const std::uint32_t> values) {
  const hsize_t extents[] = {rows, columns};
  const Hid space = owned(H5Screate_simple(2, extents, nullptr), H5Sclose, "make a dataspace");
  return write_dataset(location, path, H5T_STD_U32LE, H5T_NATIVE_UINT32, space, values.data());
}

void rewrite_integer(std::int64_t location, const std::string& path, std::int64_t value) {
  const Hid dataset =
      owned(H5Dopen2(location, path.c_str(), H5P_DEFAULT), H5Dclose, "open " + path);
  checked(H5Dwrite(dataset, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value),
          "write " + path);
}

Hid write_pairs(std::int64_t location, const std::string& path, std::span<const Bar> pairs) {
  const hsize_t extents[] = {pairs.size(), 2};
  const Hid space = owned(H5Screate_simple(2, extents, nullptr), H5Sclose, "make a dataspace");
  // Signed, as other programs write them; unsigned only for indices that need it.
  const bool large = std::any_of(pairs.begin(), pairs.end(), [](Bar pair) {
    return std::max(pair.a, pair.b) > std::uint32_t{std::numeric_limits<std::int32_t>::max()};
  });
  return write_dataset(location, path, large ? H5T_STD_U32LE : H5T_STD_I32LE, H5T_NATIVE_UINT32,
                       space, pairs.data());
}

Hid write_booleans(std::int64_t location, const std::string& path,
                   std::span<const std::uint8_t> values) {
  const Hid type = boolean_type();
  return write_array(location, path, type, type, values);
}

Hid write_named_numbers(std::int64_t location, const std::string& path,
                        std::span<const std::uint8_t> values, std::span<const std::string> names) {
  if (names.empty()) return write_numbers(location, path, values);
  const Hid type = named_number_type(names);
  return write_array(location, path, type, type, values);
}

Hid write_texts(std::int64_t location, const std::string& path,
                const std::vector<std::string>& texts) {
  std::size_t length = 1;
  for (const std::string& text : texts) length = std::max(length, as_utf8(text).size());
  std::vector<char> table(texts.size() * length, '\0');
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::string text = as_utf8(texts[i]);
    std::memcpy(table.data() + i * length, text.data(), text.size());
  }
  const Hid type = text_type(length);
  return write_dataset(location, path, type, type, array_space(texts.size()), table.data());
}

void write_parameter(std::int64_t location, const std::string& path, const Parameter& value) {
  std::visit(ParameterWriter{location, path}, value);
}

Hid boolean_type() {
  const std::array<std::string, 2> names{"FALSE", "TRUE"};
  Hid type = owned(H5Tenum_create(H5T_STD_I8LE), H5Tclose, "make a truth value type");
  for (std::size_t i = 0; i < names.size(); ++i)
    insert_name(type, names[i], static_cast<std::uint8_t>(i));
  return type;
}

Hid named_number_type(std::span<const std::string> names) {
  Hid type = owned(H5Tenum_create(H5T_STD_U8LE), H5Tclose, "make a type of names");
  for (std::size_t i = 0; i < names.size(); ++i)
    insert_name(type, names[i], static_cast<std::uint8_t>(i));
  return type;
}

}  // namespace pliant
