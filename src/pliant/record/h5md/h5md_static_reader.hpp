// SPDX-License-Identifier: MIT
// Reads the time-independent part of an H5MD file.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/record/h5md/h5md_header.hpp"

namespace pliant {

/// Implements H5mdReader. Callers hold an Hdf5Session.
class StaticReader {
 public:
  /// `file` is a hid_t, `group` a name below /particles.
  StaticReader(std::int64_t file, std::string group, std::size_t joint_count)
      : file_(file), group_(std::move(group)), joint_count_(joint_count) {}

  std::shared_ptr<const AtomTable> atoms() const;
  std::vector<Bar> bars() const;
  std::vector<double> rest_lengths() const;
  std::vector<double> masses() const;
  std::vector<Joint> pinned() const;
  std::size_t joints_of_whole() const;
  bool planar() const;  ///< whether the framework is planar
  std::vector<Limit> limits() const;
  std::shared_ptr<const Sterics> sterics() const;  ///< null where the file has none
  std::shared_ptr<const TorsionPreferences> torsion_preferences() const;  ///< null: none
  int schema() const;
  std::vector<RecordedBond> bonds() const;
  std::vector<std::string> bond_origin_names() const;
  std::vector<NamedParameter> parameters() const;
  Framework framework() const;

 private:
  std::vector<double> reals(const std::string& path, std::size_t count) const;
  std::vector<std::int64_t> integers(const std::string& path, std::size_t count, std::int64_t least,
                                     std::int64_t most) const;
  std::vector<std::string> texts(const std::string& path, std::size_t count) const;
  std::vector<Bar> pairs(const std::string& path) const;
  std::vector<std::uint32_t> joints(const std::string& path, std::size_t columns) const;
  std::vector<Residue> residues() const;

  std::int64_t file_;
  std::string group_;
  std::size_t joint_count_;
};

}  // namespace pliant
