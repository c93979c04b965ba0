// SPDX-License-Identifier: MIT
// H5MD reader (trajectory reader): frames, names, bars and parameters of an H5MD file, written by
// Pliant or by another program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/record/h5md/h5md_header.hpp"

namespace pliant {

enum class SeriesKind { real, whole, truth };

struct H5mdReadOptions {
  std::string group =
      "";        ///< a name below /particles; "": "trajectory", or the first with positions
  Log log = {};  ///< where notes and warnings go
};

/// An open H5MD file. Frames are read on demand; memory is bounded by what the file contains, not
/// by what it claims. Links and datasets that lead to other files are refused.
///
/// Every call throws FileError when HDF5 cannot read (the message ends with its reason) and
/// InputError when the data make no sense; both name the file and the path within it.
class H5mdReader {
 public:
  /// Opens the file. While a recorder writes it, a read that meets an unfinished commit is repeated
  /// in the file opened anew, which may then have more frames; after two seconds it throws
  /// FileError "is being written by ...". Notes how many frames are left out when positions, steps
  /// and times differ in number; warns when steps do not increase, unless the file holds several
  /// walkers.
  explicit H5mdReader(const std::filesystem::path& path, const H5mdReadOptions& options = {});
  ~H5mdReader();
  H5mdReader(H5mdReader&&) noexcept;
  H5mdReader& operator=(H5mdReader&&) noexcept;

  std::int64_t frames() const;           ///< frames with positions, step and time
  std::int64_t frames_left_out() const;  ///< frames that lack one or two of these
  std::size_t joint_count() const;
  const std::string& group() const;  ///< "trajectory"
  /// Size of a coordinate in the file: 8 for double precision, 4 for single.
  std::size_t bytes_per_coordinate() const;

  /// Positions of frame 0 to frames() - 1 (Angstrom), converted from the file's unit and type.
  /// Throws InputError naming the first joint whose position is not finite: the frame is damaged.
  std::vector<Vec3> positions(std::int64_t frame) const;
  void read_positions(std::int64_t frame, std::span<Vec3> positions) const;
  /// Positions of `count` frames from `first` on, one after the other, read at once. Those of a
  /// damaged frame may not be finite.
  std::vector<Vec3> block(std::int64_t first, std::int64_t count) const;
  /// Coordinates are multiples of this, Angstrom; 0: as they were when they were recorded.
  double rounded_to() const;
  std::int64_t step(std::int64_t frame) const;  ///< number of the frame if there are no steps
  bool has_time() const;
  double time(std::int64_t frame) const;    ///< ps; throws InputError if there are no times
  std::vector<std::int64_t> steps() const;  ///< of all frames
  std::vector<double> times() const;        ///< of all frames; empty if there are no times

  /// Names of all observables with one number a frame, sorted: "max_residual", "thermo/energy".
  std::vector<std::string> observables() const;
  /// Returns at most frames() values in the file's unit; truth values are 0 and 1.
  std::vector<double> observable(const std::string& name) const;
  SeriesKind kind_of(const std::string& observable) const;
  /// Returns what each contact of the model was in each frame, frame after frame: 0 held, 1 broken,
  /// 2 switched off. Contacts are in the order of each one's first limit; none may be recorded.
  std::vector<std::uint8_t> contact_states() const;

  std::shared_ptr<const AtomTable> atoms() const;  ///< null where the file has no atom table
  std::vector<Bar> bars() const;                   ///< empty where the file has none
  std::vector<double> rest_lengths() const;        ///< (B) Angstrom
  std::vector<double> masses() const;              ///< (N) u; empty where the file has none
  std::vector<Joint> pinned() const;
  /// Joints of the molecule, of which the file has some; 0: it has all.
  std::size_t joints_of_whole() const;
  std::vector<Limit> limits() const;  ///< (L); empty where the file has none
  /// Version of our own part of the file: 2, which may have limits; 1 where it says none.
  int schema() const;
  std::vector<RecordedBond> bonds() const;
  std::vector<std::string> bond_origin_names() const;
  /// The scalars below /parameters, sorted by path, without those of our own groups.
  std::vector<NamedParameter> parameters() const;

  /// The recorded framework. Throws InputError where the file has no bars.
  Framework framework() const;

 private:
  class File;
  std::unique_ptr<File> file_;
};

}  // namespace pliant
