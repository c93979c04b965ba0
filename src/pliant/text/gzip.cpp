// SPDX-License-Identifier: MIT
#include "pliant/text/gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>

#include "pliant/base/error.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant {
namespace {

constexpr std::size_t always_allowed = std::size_t{64} << 20;
constexpr std::size_t largest_ratio = 300;

/// zlib's inflating stream, ended with the object.
class Inflater {
 public:
  explicit Inflater(std::string_view name) : name_(name) {
    constexpr int gzip_only = 16 + MAX_WBITS;
    if (inflateInit2(&stream_, gzip_only) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// Appends one member to `out`; returns what follows it in `bytes`.
  std::string_view member(std::string_view bytes, std::string& out, std::size_t most);

 private:
  int step(std::string_view& bytes, std::string& out);

  z_stream stream_{};
  std::string_view name_;
  std::array<char, 1 << 16> buffer_;
};

int Inflater::step(std::string_view& bytes, std::string& out) {
  const std::size_t given =
      std::min<std::size_t>(bytes.size(), std::numeric_limits<unsigned>::max());
  stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream_.avail_in = static_cast<uInt>(given);
  stream_.next_out = reinterpret_cast<Bytef*>(buffer_.data());
  stream_.avail_out = static_cast<uInt>(buffer_.size());
  const int code = inflate(&stream_, Z_NO_FLUSH);
  bytes.remove_prefix(given - stream_.avail_in);
  out.append(buffer_.data(), buffer_.size() - stream_.avail_out);
  return code;
}

std::string_view Inflater::member(std::string_view bytes, std::string& out, std::size_t most) {
  for (;;) {
    const int code = step(bytes, out);
    if (out.size() > most)
      fail({name_},
           "gzip: inflates to more than " + std::to_string(most) + " bytes, which is refused");
    if (code == Z_STREAM_END) break;
    if (code == Z_BUF_ERROR || (code == Z_OK && bytes.empty() && stream_.avail_out != 0))
      fail({name_}, "gzip: the compressed data end early, after " + std::to_string(out.size()) +
                        " bytes of text");
    if (code != Z_OK)
      fail({name_}, std::string("gzip: damaged: ") +
                        (stream_.msg != nullptr ? stream_.msg : "not inflatable"));
  }
  inflateReset(&stream_);
  return bytes;
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::string gunzip(std::string_view bytes, std::string_view name) {
  const std::size_t most =
      std::min(largest_text, std::max(always_allowed, bytes.size() * largest_ratio));
  Inflater inflater(name);
  std::string out;
  while (is_gzip(bytes)) bytes = inflater.member(bytes, out, most);
  return out;
}

}  // namespace pliant
