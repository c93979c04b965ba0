// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/hdf5_probe.hpp"

#include <hdf5.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/record/hdf5/hdf5_session.hpp"

namespace pliant {
namespace {

constexpr rlim_t most_seconds = 5;

herr_t read_attribute(hid_t object, const char* name, const H5A_info_t*, void*) {
  const Hid attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  if (!attribute) return 0;
  const Hid type(H5Aget_type(attribute), H5Tclose);
  const Hid space(H5Aget_space(attribute), H5Sclose);
  std::string bytes(H5Aget_storage_size(attribute), '\0');
  if (type && space && !bytes.empty()) H5Aread(attribute, type, bytes.data());
  return 0;
}

herr_t look_at(hid_t file, const char* name, const H5O_info_t* info, void*) {
  const Hid object(H5Oopen(file, name, H5P_DEFAULT), H5Oclose);
  if (!object) return 0;
  H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, read_attribute, nullptr);
  if (info->type != H5O_TYPE_DATASET) return 0;
  const Hid type(H5Dget_type(object), H5Tclose);
  const Hid space(H5Dget_space(object), H5Sclose);
  const Hid properties(H5Dget_create_plist(object), H5Pclose);
  H5Dget_storage_size(object);
  return 0;
}

/// In the process that may crash: never returns.
[[noreturn]] void look_at_all(const std::filesystem::path& path) {
  const rlimit none{0, 0}, time{most_seconds, most_seconds};
  ::setrlimit(RLIMIT_CORE, &none);
  ::setrlimit(RLIMIT_CPU, &time);
  for (const int crash : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXCPU})
    ::signal(crash, SIG_DFL);
  const Hid file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
#if H5_VERSION_GE(1, 12, 0)
  if (file) H5Ovisit1(file, H5_INDEX_NAME, H5_ITER_INC, look_at, nullptr);
#else
  if (file) H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, look_at, nullptr);
#endif
  ::_exit(0);
}

}  // namespace

void probe_hdf5(const std::filesystem::path& path) {
  const pid_t child = ::fork();
  if (child < 0) return;  // no process to be had: read without
  if (child == 0) look_at_all(path);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status))
    throw InputError("is damaged: HDF5 crashes when it reads it (signal " +
                     std::to_string(WTERMSIG(status)) + ")");
}

}  // namespace pliant
