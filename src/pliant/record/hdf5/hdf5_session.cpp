// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/hdf5_session.hpp"

#include <hdf5.h>

#include <type_traits>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

static_assert(std::is_same_v<hid_t, std::int64_t>, "Hid holds what HDF5 calls hid_t");

std::recursive_mutex& hdf5_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

/// Keeps the description that the walk meets first, which is the innermost one.
herr_t keep_innermost(unsigned, const H5E_error2_t* error, void* text) {
  auto& reason = *static_cast<std::string*>(text);
  if (reason.empty() && error->desc != nullptr) reason = error->desc;
  return 0;
}

}  // namespace

Hdf5Session::Hdf5Session() : lock_(hdf5_mutex()) {
  H5Eget_auto2(H5E_DEFAULT, &printer_, &printer_argument_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Session::~Hdf5Session() { H5Eset_auto2(H5E_DEFAULT, printer_, printer_argument_); }

std::string hdf5_reason() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
  return reason.empty() ? "unknown reason" : reason;
}

void throw_hdf5_error(std::string_view what) {
  throw FileError("cannot " + std::string(what) + ": " + hdf5_reason());
}

}  // namespace pliant
