// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/hdf5_read.hpp"

#include <hdf5.h>

#include <algorithm>
#include <cerrno>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/base/system/file_lock.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/record/hdf5/hdf5_probe.hpp"
#include "pliant/record/hdf5/structure_check.hpp"

namespace pliant {
namespace {

/// Called before an external link is followed: keeps its file's name and says no.
herr_t refuse_external_link(const char*, const char*, const char* file, const char*, unsigned*,
                            hid_t, void* name) {
  *static_cast<std::string*>(name) = file;
  return -1;
}

/// Link access properties with which no link leaves the file.
class InsideLinks {
 public:
  InsideLinks() : properties_(owned(H5Pcreate(H5P_LINK_ACCESS), H5Pclose, "make link properties")) {
    checked(H5Pset_elink_cb(properties_, refuse_external_link, &refused_),
            "switch external links off");
  }
  operator std::int64_t() const { return properties_; }

  /// Whether a link wanted to; HDF5 may call its object absent then.
  bool refused() const { return !refused_.empty(); }
  /// Throws the error for a call that came back negative or was refused.
  [[noreturn]] void fail(const std::string& path) const {
    if (refused_.empty()) throw_hdf5_error("open " + pliant::quoted(path, 200));
    throw FileError(pliant::quoted(path, 200) + " leads to the file " +
                    pliant::quoted(refused_, 200) + ": links to other files are not followed");
  }

 private:
  std::string refused_;
  Hid properties_;
};

std::string open_failure(const std::string& reason) {
  if (reason.find("unable to lock") != std::string::npos)
    return "is in use by another program (" + reason + ")";
  if (reason.find("h5clear") != std::string::npos)
    return "was not closed by the program that wrote it, or is still being written; "
           "\"h5clear -s --increment\" on a copy may bring it back, -s alone destroys it";
  if (reason.find("signature not found") != std::string::npos) return "is not an HDF5 file";
  return "cannot be opened: " + reason;
}

/// HDF5 refuses to read where a file system has no locks, as some network ones. Files of ours need
/// none, also while they are written (committed_file.hpp).
bool lacks_locks(const std::string& reason) {
  const auto says = [&](int error) {
    return reason.find("unable to lock file, errno = " + std::to_string(error) + ",") !=
           std::string::npos;
  };
  return says(ENOLCK) || says(ENOSYS) || says(EOPNOTSUPP);
}

Hid open_read_only(const std::string& name, std::int64_t access) {
  return {H5Fopen(name.c_str(), H5F_ACC_RDONLY, access), H5Fclose};
}

bool link_exists(std::int64_t location, const std::string& path, const InsideLinks& links) {
  const htri_t exists = H5Lexists(location, path.c_str(), links);
  if (exists < 0) links.fail(path);
  return exists > 0;
}

constexpr int most_group_levels = 50;

struct Names {
  std::vector<std::string> names;
};

herr_t add_name(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<Names*>(names)->names.emplace_back(name);
  return 0;
}

/// A hard link: its name, and the address or token of what it leads to.
using HardLink = std::pair<std::string, std::string>;

herr_t add_hard_link(hid_t, const char* name, const H5L_info_t* link, void* links) {
  if (link->type == H5L_TYPE_HARD)
    static_cast<std::vector<HardLink>*>(links)->emplace_back(
        name, std::string(reinterpret_cast<const char*>(&link->u), sizeof link->u));
  return 0;
}

struct Below {
  std::vector<std::string> datasets;
  std::set<std::string> seen;  // addresses or tokens of groups
};

/// H5Lvisit would need a stack as deep as the file is.
void add_datasets(hid_t group, const std::string& above, int level, Below& below) {
  std::vector<HardLink> links;
  hsize_t at = 0;
  checked(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, &at, add_hard_link, &links),
          "list " + pliant::quoted("/" + above, 200));
  for (const auto& [name, place] : links) {
    const Hid object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose);
    const H5I_type_t type = object ? H5Iget_type(object) : H5I_BADID;
    if (type == H5I_DATASET) below.datasets.push_back(above + name);
    if (type == H5I_GROUP && level < most_group_levels && below.seen.insert(place).second)
      add_datasets(object, above + name + "/", level + 1, below);
  }
}

std::string attribute_text(hid_t attribute, hid_t type) {
  if (H5Tis_variable_str(type) > 0) {
    char* value = nullptr;
    const Hid memory = owned(H5Tcopy(type), H5Tclose, "copy a type");
    if (H5Aread(attribute, memory, &value) < 0 || value == nullptr) return "";
    const std::string text = value;
    H5free_memory(value);
    return text;
  }
  std::string text(H5Tget_size(type), '\0');
  if (H5Aread(attribute, type, text.data()) < 0) return "";
  text.resize(std::min(text.find('\0'), text.size()));
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

/// A scalar attribute, or one of a single value.
Hid open_single_attribute(std::int64_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return {};
  Hid attribute = owned(H5Aopen(object, name, H5P_DEFAULT), H5Aclose,
                        "open the attribute " + std::string(name));
  const Hid space = owned(H5Aget_space(attribute), H5Sclose, "look at an attribute");
  if (H5Sget_simple_extent_npoints(space) != 1) return {};
  return attribute;
}

}  // namespace

Hid open_hdf5(const std::filesystem::path& path) {
  if (!check_hdf5_structure(path)) probe_hdf5(path);
  const Hid access = owned(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make file properties");
  checked(H5Pset_fclose_degree(access, H5F_CLOSE_STRONG), "choose how the file closes");
  const std::string name = path_text(path);
  Hid file;
  // Where they keep from reading: HDF5 locks all of the file, also the byte of our writer.
  if (!locks_keep_from_reading()) file = open_read_only(name, access);
  if (!file && (locks_keep_from_reading() || lacks_locks(hdf5_reason()))) {
    checked(H5Pset_file_locking(access, false, true), "choose to read without a lock");
    file = open_read_only(name, access);
  }
  if (!file) throw FileError(open_failure(hdf5_reason()));
  return file;
}

bool has_object(std::int64_t location, const std::string& path) {
  const InsideLinks links;
  for (std::size_t end = path.find('/', 1); end != std::string::npos; end = path.find('/', end + 1))
    if (!link_exists(location, path.substr(0, end), links)) return false;
  if (!link_exists(location, path, links)) return false;
  const htri_t exists = H5Oexists_by_name(location, path.c_str(), links);
  if (exists < 0 || links.refused()) links.fail(path);
  return exists > 0;
}

Hid open_object(std::int64_t location, const std::string& path) {
  const InsideLinks links;
  Hid object(H5Oopen(location, path.c_str(), links), H5Oclose);
  if (!object) links.fail(path);
  return object;
}

std::vector<std::string> names_in(std::int64_t location, const std::string& group) {
  Names found;
  if (!has_object(location, group)) return {};
  const Hid object = open_object(location, group);
  if (H5Iget_type(object) != H5I_GROUP) return {};
  hsize_t at = 0;
  checked(H5Literate(object, H5_INDEX_NAME, H5_ITER_INC, &at, add_name, &found),
          "list " + pliant::quoted(group, 200));
  return found.names;
}

std::vector<std::string> datasets_below(std::int64_t location, const std::string& group) {
  if (!has_object(location, group)) return {};
  const Hid object = open_object(location, group);
  if (H5Iget_type(object) != H5I_GROUP) return {};
  Below below;
  add_datasets(object, "", 0, below);
  std::sort(below.datasets.begin(), below.datasets.end());
  return std::move(below.datasets);
}

std::optional<std::string> text_attribute(std::int64_t object, const char* name) {
  const Hid attribute = open_single_attribute(object, name);
  if (!attribute) return std::nullopt;
  const Hid type = owned(H5Aget_type(attribute), H5Tclose, "look at an attribute");
  if (H5Tget_class(type) != H5T_STRING) return std::nullopt;
  return attribute_text(attribute, type);
}

std::optional<double> number_attribute(std::int64_t object, const char* name) {
  const Hid attribute = open_single_attribute(object, name);
  if (!attribute) return std::nullopt;
  double value = 0.0;
  if (H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0) return std::nullopt;
  return value;
}

}  // namespace pliant
