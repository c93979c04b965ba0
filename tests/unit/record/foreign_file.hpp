// SPDX-License-Identifier: MIT
// H5MD files as other programs write them, made with HDF5 itself, and a fixture that reads them.
#pragma once

#include <gtest/gtest.h>
#include <hdf5.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "unit/record/samples.hpp"

namespace pliant::test {

using Extents = std::vector<hsize_t>;

/// A file as other programs write it, built dataset by dataset.
class ForeignFile {
 public:
  explicit ForeignFile(const std::filesystem::path& path, hid_t creation = H5P_DEFAULT,
                       hid_t access = H5P_DEFAULT)
      : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access)) {}
  ~ForeignFile() { H5Fclose(file_); }

  hid_t id() const { return file_; }

  /// A dataset of values 0, 1, 2, ... in `type`; groups on the way are made.
  void add(const std::string& path, const Extents& extents, hid_t type = H5T_IEEE_F64LE,
           hid_t creation = H5P_DEFAULT, bool write = true) {
    const hid_t space = extents.empty()
                            ? H5Screate(H5S_SCALAR)
                            : H5Screate_simple(int(extents.size()), extents.data(), nullptr);
    const hid_t links = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(links, 1);
    const hid_t set = H5Dcreate2(file_, path.c_str(), type, space, links, creation, H5P_DEFAULT);
    if (write) {
      std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = double(i);
      H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    }
    H5Dclose(set);
    H5Pclose(links);
    H5Sclose(space);
  }

  void write(const std::string& path, const std::vector<double>& values) {
    const hid_t set = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(set);
  }

  /// A text attribute of fixed length, or, with `variable`, of variable length.
  void unit(const std::string& path, const std::string& text, bool variable = true) {
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
    H5Tset_size(type, variable ? H5T_VARIABLE : text.size());
    const hid_t attribute = H5Acreate_by_name(file_, path.c_str(), "unit", type, space, H5P_DEFAULT,
                                              H5P_DEFAULT, H5P_DEFAULT);
    const char* pointer = text.c_str();
    H5Awrite(attribute, type, variable ? static_cast<const void*>(&pointer) : pointer);
    H5Aclose(attribute);
    H5Sclose(space);
    H5Tclose(type);
  }

  /// Four frames of two joints, with everything that the format asks for.
  void add_trajectory(const std::string& group = "trajectory") {
    const std::string position = "/particles/" + group + "/position";
    add(position + "/value", {4, 2, 3});
    add(position + "/step", {4}, H5T_STD_I32LE);
    add(position + "/time", {4});
    unit(position + "/value", "Angstrom");
    unit(position + "/time", "ps");
  }

 private:
  hid_t file_;
};

inline constexpr char value[] = "/particles/trajectory/position/value";
inline constexpr char step[] = "/particles/trajectory/position/step";
inline constexpr char time_path[] = "/particles/trajectory/position/time";

class H5mdReaderTest : public FileTest {
 protected:
  // HDF5 tells on stderr of each failing call, of which these tests have many.
  H5mdReaderTest() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

  using Write = std::function<void(ForeignFile&)>;
  /// Makes the file at path_.
  void foreign(const Write& write) {
    ForeignFile file(path_);
    write(file);
  }
  /// The same; it has a trajectory already.
  void trajectory_with(const Write& write) {
    foreign([&](ForeignFile& file) {
      file.add_trajectory();
      write(file);
    });
  }

  H5mdReader open(const std::string& group = "") {
    H5mdReadOptions options;
    options.group = group;
    options.log.function = [this](Severity severity, std::string_view text) {
      messages_.push_back((severity == Severity::warning ? "warning: " : "note: ") +
                          std::string(text));
    };
    return H5mdReader(path_, options);
  }
  /// The message with which opening (or `use` of) the file fails, without the file's name.
  std::string failure(const std::function<void(const H5mdReader&)>& use = [](const auto&) {}) {
    const std::string text = error_text<Error>([&] { use(open()); });
    const std::string name = path_.string() + ": ";
    EXPECT_EQ(text.substr(0, name.size()), name);
    return text.substr(std::min(text.size(), name.size()));
  }
  static void read_first(const H5mdReader& reader) { reader.positions(0); }

  std::vector<std::string> messages_;
};

}  // namespace pliant::test
