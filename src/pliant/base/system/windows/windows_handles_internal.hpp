// SPDX-License-Identifier: MIT
// What Windows knows a descriptor of C by.
#pragma once

#include <io.h>
#include <windows.h>

namespace pliant {

inline HANDLE handle_of(int descriptor) {
  return reinterpret_cast<HANDLE>(::_get_osfhandle(descriptor));
}

}  // namespace pliant
