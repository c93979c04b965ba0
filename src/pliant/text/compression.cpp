// SPDX-License-Identifier: MIT
#include "pliant/text/compression.hpp"

#include <algorithm>
#include <array>

#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/text/bzip.hpp"
#include "pliant/text/file_text.hpp"
#include "pliant/text/gzip.hpp"
#include "pliant/text/xz.hpp"

namespace pliant {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kept_at_once = std::size_t{64} << 20;
constexpr std::string_view xz_magic =
    "\xfd"
    "7zXZ\0"sv;

const std::array<Compression, 6> known_compressions{{
    {"gzip", ".gz", "\x1f\x8b"sv, "zlib", make_gzip_decoder},
    {"bzip2", ".bz2", "BZh"sv, "libbz2", make_bzip2_decoder},
    {"xz", ".xz", xz_magic, "liblzma", make_xz_decoder},
    {"zstd", ".zst", "\x28\xb5\x2f\xfd"sv, "", nullptr},
    {"compress", ".Z", "\x1f\x9d"sv, "", nullptr},
    {"zip", ".zip", "PK\x03\x04"sv, "", nullptr},
}};

/// Expands all members of a file, and gives what they hold block by block.
class Expander {
 public:
  Expander(const Compression& compression, std::string_view bytes, std::string_view name)
      : compression_(compression), bytes_(bytes), name_(name), decoder_(compression.decoder()) {
    if (!decoder_)
      fail({name_}, "is compressed with " + std::string(compression.name) +
                        ", which this build of Pliant does not read: it was made without " +
                        std::string(compression.library));
  }

  /// Calls take(block) for all blocks in their order.
  template <class Take>
  void each_block(const Take& take) {
    std::size_t size = 0;
    std::string_view left = bytes_;
    while (left.starts_with(compression_.magic)) {
      decoder_->restart();
      while (!step(left, size, take)) continue;
      // Members may be filled up with zeros, to whole blocks of a tape or of xz.
      left.remove_prefix(std::min(left.find_first_not_of('\0'), left.size()));
    }
  }

 private:
  template <class Take>
  bool step(std::string_view& left, std::size_t& size, const Take& take) {
    const Decoded done = decoder_->step(left, buffer_);
    const std::string what = std::string(compression_.name) + ": ";
    if (!done.damage.empty()) fail({name_}, what + "damaged: " + done.damage);
    size += done.made;
    take(std::string_view(buffer_.data(), done.made));
    if (!done.is_end && left.empty() && done.made < buffer_.size())
      fail({name_}, what + "the compressed data end early, after " + std::to_string(size) +
                        " bytes of text");
    return done.is_end;
  }

  const Compression& compression_;
  std::string_view bytes_, name_;
  std::unique_ptr<Decoder> decoder_;
  std::array<char, 1 << 16> buffer_;
};

}  // namespace

const Compression* compression_of(std::string_view bytes) {
  const auto row = std::find_if(
      known_compressions.begin(), known_compressions.end(),
      [&](const Compression& compression) { return bytes.starts_with(compression.magic); });
  return row == known_compressions.end() ? nullptr : &*row;
}

std::string expand(const Compression& compression, std::string_view bytes, std::string_view name,
                   std::size_t most) {
  if (compression.decoder == nullptr)
    fail({name}, "is compressed with " + std::string(compression.name) +
                     ": only gzip, bzip2 and xz are read");
  Expander expander(compression, bytes, name);
  std::size_t size = 0;
  std::string out;
  out.reserve(std::min(most, kept_at_once));
  expander.each_block([&](std::string_view block) {
    size += block.size();
    if (size > most)
      throw TooLargeError(at({name}, std::string(compression.name) + ": expands to more than " +
                                         megabytes(most) + ", the most that is read"));
    if (size <= kept_at_once) out += block;
  });
  if (size <= kept_at_once) return out;
  out = {};
  out.reserve(size);
  expander.each_block([&](std::string_view block) { out += block; });
  return out;
}

std::filesystem::path without_compression_suffix(const std::filesystem::path& path) {
  std::string suffix = path_text(path.extension());
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  const bool is_read = std::any_of(
      known_compressions.begin(), known_compressions.end(),
      [&](const Compression& row) { return row.decoder != nullptr && row.suffix == suffix; });
  return is_read ? path.parent_path() / path.stem() : path;
}

}  // namespace pliant
