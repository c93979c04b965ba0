// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/hdf5_probe.hpp"

#include <hdf5.h>

#include <optional>
#include <string>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/base/system/process.hpp"
#include "pliant/record/hdf5/hdf5_session.hpp"

namespace pliant {
namespace {

constexpr unsigned most_seconds = 5;
constexpr int most_levels = 50;

herr_t read_attribute(hid_t object, const char* name, const H5A_info_t*, void*) {
  const Hid attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  if (!attribute) return 0;
  const Hid type(H5Aget_type(attribute), H5Tclose);
  const Hid space(H5Aget_space(attribute), H5Sclose);
  std::string bytes(H5Aget_storage_size(attribute), '\0');
  if (type && space && !bytes.empty()) H5Aread(attribute, type, bytes.data());
  return 0;
}

void look_at_dataset(hid_t dataset) {
  const Hid type(H5Dget_type(dataset), H5Tclose);
  const Hid space(H5Dget_space(dataset), H5Sclose);
  const Hid properties(H5Dget_create_plist(dataset), H5Pclose);
  H5Dget_storage_size(dataset);
}

/// Keeps the name of a link within the file.
herr_t keep_name(hid_t, const char* name, const H5L_info_t* link, void* names) {
  if (link->type != H5L_TYPE_EXTERNAL)
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

void look_at_group(hid_t group, int depth);

void look_at(hid_t object, int depth) {
  H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, read_attribute, nullptr);
  const H5I_type_t kind = H5Iget_type(object);
  if (kind == H5I_DATASET) look_at_dataset(object);
  if (kind == H5I_GROUP && depth < most_levels) look_at_group(object, depth + 1);
}

/// Goes on behind what cannot be opened, as readers do, and looks up by name, as they do.
void look_at_group(hid_t group, int depth) {
  std::vector<std::string> names;
  H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, keep_name, &names);
  for (const std::string& name : names) {
    H5Lexists(group, name.c_str(), H5P_DEFAULT);
    const Hid object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose);
    if (object) look_at(object, depth);
  }
}

void visit(const std::filesystem::path& path) {
  const Hid file(H5Fopen(path_text(path).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file) return;
  const Hid root(H5Oopen(file, "/", H5P_DEFAULT), H5Oclose);
  if (root) look_at(root, 0);
}

}  // namespace

void probe_hdf5(const std::filesystem::path& path) {
  const std::optional<int> crash = crash_in_copy([&] { visit(path); }, most_seconds);
  if (crash.value_or(0) != 0)  // no process to be had: it is read without
    throw InputError("is damaged: HDF5 crashes when it reads it (signal " + std::to_string(*crash) +
                     ")");
}

}  // namespace pliant
