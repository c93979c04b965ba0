// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/structure_fields.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <optional>

#include "pliant/base/error.hpp"

namespace pliant {

std::string place_in_file(std::string_view what, std::uint64_t address) {
  return std::string(what) + " at byte " + std::to_string(address);
}

std::uint64_t StructureFields::number(std::size_t width) {
  require(left() >= width, "ends too early");
  std::uint64_t value = 0;
  for (std::size_t k = width; k-- > 0;)
    value = value << 8 | std::to_integer<std::uint64_t>(bytes_[at_ + k]);
  at_ += width;
  return value;
}

void StructureFields::skip(std::size_t count) {
  require(left() >= count, "ends too early");
  at_ += count;
}

StructureFields StructureFields::part(std::size_t count, std::string_view what) {
  require(left() >= count, "ends too early");
  StructureFields part(bytes_.subspan(at_, count), what_ + ", " + std::string(what));
  at_ += count;
  return part;
}

std::string StructureFields::text() {
  const auto rest = bytes_.subspan(at_);
  const auto end = std::find(rest.begin(), rest.end(), std::byte{0});
  require(end != rest.end(), "has a name without an end");
  const auto length = static_cast<std::size_t>(end - rest.begin());
  at_ += length + 1;
  return {reinterpret_cast<const char*>(rest.data()), length};
}

void StructureFields::signature(std::string_view characters) {
  require(left() >= characters.size(), "ends too early");
  require(std::memcmp(bytes_.data() + at_, characters.data(), characters.size()) == 0,
          "does not begin with " + std::string(characters));
  at_ += characters.size();
}

void StructureFields::fail(std::string_view why) const {
  throw InputError("is damaged: " + what_ + ": " + std::string(why));
}

StructureFile::StructureFile(const std::filesystem::path& path)
    : file_(open_file(path, Opening::to_read)) {
  const std::optional<FileFacts> facts = file_ ? facts_of(file_.get()) : std::nullopt;
  if (!facts) throw FileError("cannot open: " + error_words(errno));
  if (facts->kind != FileKind::regular) throw FileError("is not a regular file");
  size_ = facts->size;
}

std::vector<std::byte> StructureFile::read(std::uint64_t address, std::size_t count) const {
  std::vector<std::byte> bytes(count);
  std::size_t done = 0;
  while (done < count) {
    const std::ptrdiff_t got = read_at(file_.get(), address + done, std::span(bytes).subspan(done));
    if (got < 0) throw FileError("cannot read: " + error_words(errno));
    if (got == 0) throw InputError("is damaged: it has become shorter");
    done += static_cast<std::size_t>(got);
  }
  return bytes;
}

namespace {

using Three = std::array<std::uint32_t, 3>;

void mix(Three& v) {
  constexpr std::array turns{4, 6, 8, 16, 19, 4};
  for (std::size_t k = 0; k < turns.size(); ++k) {
    std::uint32_t& x = v[k % 3];
    const std::uint32_t last = v[(k + 2) % 3];
    x = (x - last) ^ std::rotl(last, turns[k]);
    v[(k + 2) % 3] = last + v[(k + 1) % 3];
  }
}

void finish(Three& v) {
  constexpr std::array turns{14, 11, 25, 16, 4, 14, 24};
  for (std::size_t k = 0; k < turns.size(); ++k) {
    std::uint32_t& x = v[(k + 2) % 3];
    const std::uint32_t last = v[(k + 1) % 3];
    x = (x ^ last) - std::rotl(last, turns[k]);
  }
}

}  // namespace

// http://burtleburtle.net/bob/c/lookup3.c, public domain: hashlittle().
std::uint32_t structure_checksum(std::span<const std::byte> bytes) {
  const auto start = 0xdeadbeef + static_cast<std::uint32_t>(bytes.size());
  Three v{start, start, start};
  if (bytes.empty()) return start;
  const auto add = [&](std::size_t count) {
    for (std::size_t k = 0; k < count; ++k)
      v[k / 4] += std::to_integer<std::uint32_t>(bytes[k]) << (8 * (k % 4));
  };
  while (bytes.size() > 12) {
    add(12);
    mix(v);
    bytes = bytes.subspan(12);
  }
  add(bytes.size());
  finish(v);
  return v[2];
}

}  // namespace pliant
