// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/committed_driver.hpp"

#include <hdf5.h>
#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

#include <algorithm>
#include <iterator>
#include <new>

namespace pliant {
namespace {

// Blocks of this size and more begin at a page. Nodes of chunk trees have 2096 bytes (series of
// numbers) or more, and must not straddle two pages; object headers are shorter.
constexpr hsize_t alignment_threshold = 2096;
constexpr hsize_t page_size = 4096;

/// What HDF5 holds of an open file.
struct DriverFile : H5FD_t {
  CommittedFile* file;
};

CommittedFile& file_of(const H5FD_t* file) { return *static_cast<const DriverFile*>(file)->file; }

BlockKind kind_of(H5FD_mem_t type) {
  switch (type) {
    case H5FD_MEM_DRAW:
      return BlockKind::data;
    case H5FD_MEM_SUPER:
      return BlockKind::superblock;
    case H5FD_MEM_BTREE:
      return BlockKind::tree_node;
    default:
      return BlockKind::other_metadata;
  }
}

H5FD_t* open_file(const char*, unsigned, hid_t access, haddr_t) {
  auto* const* file = static_cast<CommittedFile* const*>(H5Pget_driver_info(access));
  if (file == nullptr) return nullptr;
  auto* opened = new (std::nothrow) DriverFile{};
  if (opened != nullptr) opened->file = *file;
  return opened;
}

herr_t close_file(H5FD_t* file) {
  delete static_cast<DriverFile*>(file);
  return 0;
}

herr_t query(const H5FD_t*, unsigned long* flags) {
  // No accumulator: it would glue metadata blocks of different kinds together.
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_AGGREGATE_SMALLDATA |
           H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t get_end(const H5FD_t* file, H5FD_mem_t) { return file_of(file).end(); }

herr_t set_end(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  file_of(file).set_end(end);
  return 0;
}

haddr_t get_size(const H5FD_t* file, H5FD_mem_t) { return file_of(file).size(); }

herr_t read(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void* buffer) {
  file_of(file).read(address, {static_cast<std::byte*>(buffer), size});
  return 0;
}

herr_t write(H5FD_t* file, H5FD_mem_t type, hid_t, haddr_t address, std::size_t size,
             const void* buffer) {
  file_of(file).write(kind_of(type), address, {static_cast<const std::byte*>(buffer), size});
  return 0;
}

herr_t flush(H5FD_t* file, hid_t, hbool_t) {
  file_of(file).commit();
  return 0;
}

herr_t truncate(H5FD_t*, hid_t, hbool_t) { return 0; }  // commit() sees to the length

H5FD_class_t driver_class() {
  H5FD_class_t driver{};
#if H5_VERSION_GE(1, 13, 0)
  driver.version = H5FD_CLASS_VERSION;
  driver.value = static_cast<H5FD_class_value_t>(400);  // from the range for private drivers
#endif
  driver.name = "pliant_committed";
  driver.maxaddr = HADDR_MAX;
  driver.fc_degree = H5F_CLOSE_STRONG;
  driver.fapl_size = sizeof(CommittedFile*);
  driver.open = open_file;
  driver.close = close_file;
  driver.query = query;
  driver.get_eoa = get_end;
  driver.set_eoa = set_end;
  driver.get_eof = get_size;
  driver.read = read;
  driver.write = write;
  driver.flush = flush;
  driver.truncate = truncate;
  constexpr H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(map), std::end(map), driver.fl_map);
  return driver;
}

Hid access_properties(CommittedFile* file) {
  static const H5FD_class_t driver = driver_class();
  const Hid registered = owned(H5FDregister(&driver), H5FDunregister, "register the file driver");
  Hid access = owned(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make file properties");
  checked(H5Pset_driver(access, registered, &file), "choose the file driver");
  checked(H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18),
          "choose the file format");
  checked(H5Pset_alignment(access, alignment_threshold, page_size), "align the file");
  checked(H5Pset_fclose_degree(access, H5F_CLOSE_STRONG), "choose how the file closes");
  return access;
}

}  // namespace

Hid create_hdf5(CommittedFile& file) {
  const Hid access = access_properties(&file);
  // The name is only a key: the driver writes to `file`.
  return owned(H5Fcreate("pliant", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose,
               "create the file");
}

Hid open_hdf5_to_write(CommittedFile& file) {
  const Hid access = access_properties(&file);
  return owned(H5Fopen("pliant", H5F_ACC_RDWR, access), H5Fclose, "open the file");
}

}  // namespace pliant
