// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/h5md_reader.hpp"

#include <utility>

#include "pliant/base/system/path_text.hpp"
#include "pliant/record/h5md/h5md_frame_reader.hpp"
#include "pliant/record/h5md/h5md_static_reader.hpp"
#include "pliant/record/hdf5/while_written.hpp"

namespace pliant {

class H5mdReader::File {
 public:
  /// Calls `read` alone with HDF5, and puts the file's name before its errors. While somebody
  /// writes the file, what fails is tried again in the file as it is then.
  template <class Read>
  auto guarded(Read read) {
    const Hdf5Session session;
    bool is_again = false;
    return while_written(path_, [&] {
      if (std::exchange(is_again, true)) open();
      return read();
    });
  }

  File(const std::filesystem::path& path, H5mdReadOptions options)
      : path_(path), name_(path_text(path)), options_(std::move(options)) {
    guarded([&] {
      if (!frames_) open();
    });
  }
  ~File() {
    const Hdf5Session session;
    release();
  }

  const FrameReader& frames() const { return *frames_; }
  StaticReader fixed() const { return {hdf5_, frames_->group(), frames_->joint_count()}; }

 private:
  void open() {
    release();
    try {
      hdf5_ = open_hdf5(path_);
      frames_.emplace(hdf5_, options_.group, name_, options_.log);
    } catch (...) {
      release();
      throw;
    }
  }
  void release() {
    frames_.reset();
    hdf5_.reset();
  }

  std::filesystem::path path_;
  std::string name_;
  H5mdReadOptions options_;
  Hid hdf5_;
  std::optional<FrameReader> frames_;
};

H5mdReader::H5mdReader(const std::filesystem::path& path, const H5mdReadOptions& options)
    : file_(std::make_unique<File>(path, options)) {}
H5mdReader::~H5mdReader() = default;
H5mdReader::H5mdReader(H5mdReader&&) noexcept = default;
H5mdReader& H5mdReader::operator=(H5mdReader&&) noexcept = default;

std::int64_t H5mdReader::frames() const { return file_->frames().frames(); }
std::int64_t H5mdReader::frames_left_out() const { return file_->frames().frames_left_out(); }
std::size_t H5mdReader::joint_count() const { return file_->frames().joint_count(); }
const std::string& H5mdReader::group() const { return file_->frames().group(); }
std::size_t H5mdReader::bytes_per_coordinate() const {
  return file_->frames().bytes_per_coordinate();
}
bool H5mdReader::has_time() const { return file_->frames().has_time(); }

std::vector<Vec3> H5mdReader::positions(std::int64_t frame) const {
  return file_->guarded([&] { return file_->frames().positions(frame); });
}

void H5mdReader::read_positions(std::int64_t frame, std::span<Vec3> positions) const {
  file_->guarded([&] { file_->frames().read_positions(frame, positions); });
}

std::vector<Vec3> H5mdReader::block(std::int64_t first, std::int64_t count) const {
  return file_->guarded([&] { return file_->frames().block(first, count); });
}

double H5mdReader::rounded_to() const {
  return file_->guarded([&] { return file_->frames().rounded_to(); });
}

std::int64_t H5mdReader::step(std::int64_t frame) const {
  return file_->guarded([&] { return file_->frames().step(frame); });
}

double H5mdReader::time(std::int64_t frame) const {
  return file_->guarded([&] { return file_->frames().time(frame); });
}

std::vector<std::int64_t> H5mdReader::steps() const {
  return file_->guarded([&] { return file_->frames().steps(); });
}

std::vector<double> H5mdReader::times() const {
  return file_->guarded([&] { return file_->frames().times(); });
}

std::vector<std::string> H5mdReader::observables() const {
  return file_->guarded([&] { return file_->frames().observables(); });
}

std::vector<double> H5mdReader::observable(const std::string& name) const {
  return file_->guarded([&] { return file_->frames().observable(name); });
}

SeriesKind H5mdReader::kind_of(const std::string& observable) const {
  return file_->guarded([&] { return file_->frames().kind_of(observable); });
}

std::vector<std::uint8_t> H5mdReader::contact_states() const {
  return file_->guarded([&] { return file_->frames().contact_states(); });
}

std::shared_ptr<const AtomTable> H5mdReader::atoms() const {
  return file_->guarded([&] { return file_->fixed().atoms(); });
}

std::vector<Bar> H5mdReader::bars() const {
  return file_->guarded([&] { return file_->fixed().bars(); });
}

std::vector<double> H5mdReader::rest_lengths() const {
  return file_->guarded([&] { return file_->fixed().rest_lengths(); });
}

std::vector<double> H5mdReader::masses() const {
  return file_->guarded([&] { return file_->fixed().masses(); });
}

std::vector<Joint> H5mdReader::pinned() const {
  return file_->guarded([&] { return file_->fixed().pinned(); });
}

std::size_t H5mdReader::joints_of_whole() const {
  return file_->guarded([&] { return file_->fixed().joints_of_whole(); });
}

std::vector<Limit> H5mdReader::limits() const {
  return file_->guarded([&] { return file_->fixed().limits(); });
}

int H5mdReader::schema() const {
  return file_->guarded([&] { return file_->fixed().schema(); });
}

std::vector<RecordedBond> H5mdReader::bonds() const {
  return file_->guarded([&] { return file_->fixed().bonds(); });
}

std::vector<std::string> H5mdReader::bond_origin_names() const {
  return file_->guarded([&] { return file_->fixed().bond_origin_names(); });
}

std::vector<NamedParameter> H5mdReader::parameters() const {
  return file_->guarded([&] { return file_->fixed().parameters(); });
}

Framework H5mdReader::framework() const {
  return file_->guarded([&] { return file_->fixed().framework(); });
}

}  // namespace pliant
