// SPDX-License-Identifier: MIT
// From the numbers of Windows to those of C.
#pragma once

namespace pliant {

/// Sets errno to what the last call of Windows has failed with. Returns false.
bool keep_windows_error();

}  // namespace pliant
