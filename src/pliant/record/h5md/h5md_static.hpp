// SPDX-License-Identifier: MIT
// The part of our H5MD files that does not depend on time.
#pragma once

#include <cstdint>

#include "pliant/record/h5md/h5md_recorder.hpp"

namespace pliant {

/// Names of our groups, which readers share.
namespace h5md {
inline constexpr char trajectory[] = "/particles/trajectory";
inline constexpr char position[] = "/particles/trajectory/position";
inline constexpr char observables[] = "/observables";
inline constexpr char bars[] = "/connectivity/bars";
inline constexpr char bonds[] = "/connectivity/bonds";
inline constexpr char framework[] = "/parameters/framework";  // rest_length, pinned
inline constexpr char topology[] = "/parameters/topology";    // the atom table, bonds' origins
}  // namespace h5md

/// Writes everything but frames and observables into the new HDF5 file `file` (hid_t).
/// Throws FileError, and OptionError on a parameter's path that is empty or taken.
void write_static_part(std::int64_t file, const Framework& framework, const H5mdHeader& header);

}  // namespace pliant
