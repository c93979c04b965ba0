// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_commands.hpp"

#include <bit>
#include <string>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

constexpr std::size_t header_size = 8;
constexpr double kilojoules_in_kilocalorie = 4.184;

bool is_command(ImdType type, int version) {
  switch (type) {
    case ImdType::disconnect:
    case ImdType::go:
    case ImdType::kill:
    case ImdType::forces:
    case ImdType::pause:
    case ImdType::rate:
      return true;
    case ImdType::resume:
    case ImdType::wait:
      return version >= 3;
    default:
      return false;
  }
}

}  // namespace

ImdCommandReader::ImdCommandReader(const ImdFormat& format, std::size_t joint_count)
    : format_(format), joint_count_(joint_count), is_pulled_(joint_count) {}

void ImdCommandReader::take(std::span<const std::byte> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::optional<ImdCommand> ImdCommandReader::next() {
  if (bytes_.size() < header_size) return std::nullopt;
  const ImdHeader header = imd_header(bytes_.data());
  const std::size_t size = header_size + body_size(header);
  if (bytes_.size() < size) return std::nullopt;
  ImdCommand command{header.type, header.value, {}};
  if (header.type == ImdType::forces)
    command.forces = forces(static_cast<std::size_t>(header.value));
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(size));
  return command;
}

std::size_t ImdCommandReader::body_size(const ImdHeader& header) const {
  if (!is_command(header.type, format_.version))
    throw InputError("packet of type " + std::to_string(static_cast<std::int32_t>(header.type)) +
                     ", which no client of IMD version " + std::to_string(format_.version) +
                     " sends");
  if (header.type != ImdType::forces) return 0;
  if (header.value < 0 || static_cast<std::size_t>(header.value) > joint_count_)
    throw InputError("forces on " + std::to_string(header.value) + " atoms of " +
                     std::to_string(joint_count_));
  return 16 * static_cast<std::size_t>(header.value);
}

/// Forces of a packet that is complete: the atoms, then as many forces.
std::vector<JointForce> ImdCommandReader::forces(std::size_t count) {
  const std::byte* indices = bytes_.data() + header_size;
  const std::byte* numbers = indices + 4 * count;
  const double unit = format_.version >= 3 ? 1.0 : kilojoules_in_kilocalorie;
  const auto component = [&](std::size_t k) {
    return unit * double(std::bit_cast<float>(imd_word(format_, numbers + 4 * k)));
  };
  std::vector<JointForce> forces;
  is_pulled_.assign(joint_count_, 0);
  for (std::size_t k = 0; k < count; ++k) {
    const auto joint = static_cast<std::int32_t>(imd_word(format_, indices + 4 * k));
    const std::string atom = "atom " + std::to_string(joint);
    if (joint < 0 || static_cast<std::size_t>(joint) >= joint_count_)
      throw InputError("force on " + atom + " of " + std::to_string(joint_count_));
    if (is_pulled_[std::size_t(joint)]++ != 0) throw InputError("two forces on " + atom);
    forces.push_back({static_cast<Joint>(joint),
                      {component(3 * k), component(3 * k + 1), component(3 * k + 2)}});
    if (!is_finite(forces.back().force)) throw InputError("force on " + atom + " is not finite");
  }
  return forces;
}

}  // namespace pliant
