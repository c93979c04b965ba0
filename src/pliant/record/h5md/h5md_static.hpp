// SPDX-License-Identifier: MIT
// The time-independent part of our H5MD files.
#pragma once

#include <cstdint>
#include <string>

#include "pliant/record/h5md/h5md_header.hpp"

namespace pliant {

/// Names of our groups, which readers share.
namespace h5md {
inline constexpr char trajectory[] = "/particles/trajectory";
inline constexpr char position[] = "/particles/trajectory/position";
/// (N) index of each joint in the molecule, if the file has only some joints, with an attribute:
/// the number of joints in the molecule.
inline constexpr char id[] = "/particles/trajectory/id";
inline constexpr char joints_of_whole[] = "joints_of_whole";
inline constexpr char rounded_to[] = "rounded_to";  // attribute of positions: of their unit
inline constexpr char observables[] = "/observables";
inline constexpr char bars[] = "/connectivity/bars";
inline constexpr char bonds[] = "/connectivity/bonds";
inline constexpr char limits[] = "/connectivity/limits";  // (L, 2) joints
/// value (F, C): states of C contacts, in the order of their first limits
inline constexpr char contact_states[] = "/connectivity/contact_states";
inline constexpr char limit[] = "/parameters/limit";  // least, most, kind, energy, group
/// kind, least, own, own_least, unit, bonds_apart, bonds
inline constexpr char sterics[] = "/parameters/sterics";
/// staggered (S, 4) joints, free (S) radians, backbone (B, 5) joints, reach (B)
inline constexpr char torsion_preferences[] = "/parameters/torsion_preferences";
inline constexpr int schema = 2;                                // of /h5md/creator; none is 1
inline constexpr char framework[] = "/parameters/framework";    // rest_length, pinned, planar
inline constexpr char checkpoint[] = "/parameters/checkpoint";  // see h5md_checkpoint.hpp
inline constexpr char topology[] = "/parameters/topology";      // the atom table, bonds' origins
}  // namespace h5md

/// Whether a path below /parameters is in one of our groups.
bool is_own_parameter(const std::string& path);

/// Writes everything except frames and observables into the new HDF5 file `file` (hid_t). Throws
/// FileError, and OptionError for a parameter's path that is empty or taken.
void write_static_part(std::int64_t file, const Framework& framework, const H5mdHeader& header);

/// Writes which joints of a molecule of `joint_count` joints the file has (H5MD's element id).
void write_saved_joints(std::int64_t file, const std::vector<std::uint32_t>& joints,
                        std::size_t joint_count);

}  // namespace pliant
