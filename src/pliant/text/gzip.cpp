// SPDX-License-Identifier: MIT
#include "pliant/text/gzip.hpp"

#ifdef PLIANT_HAS_ZLIB

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>

namespace pliant {
namespace {

class GzipDecoder final : public Decoder {
 public:
  GzipDecoder() {
    constexpr int gzip_only = 16 + MAX_WBITS;
    if (inflateInit2(&stream_, gzip_only) != Z_OK) throw std::bad_alloc();
  }
  ~GzipDecoder() override { inflateEnd(&stream_); }

  Decoded step(std::string_view& bytes, std::span<char> room) override {
    constexpr std::size_t most = std::numeric_limits<uInt>::max();
    const std::size_t given = std::min(bytes.size(), most);
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream_.avail_in = static_cast<uInt>(given);
    stream_.next_out = reinterpret_cast<Bytef*>(room.data());
    stream_.avail_out = static_cast<uInt>(room.size());
    const int code = inflate(&stream_, Z_NO_FLUSH);
    bytes.remove_prefix(given - stream_.avail_in);
    return {room.size() - stream_.avail_out, code == Z_STREAM_END, damage_of(code)};
  }

  void restart() override { inflateReset(&stream_); }

 private:
  std::string damage_of(int code) const {
    if (code == Z_MEM_ERROR) throw std::bad_alloc();
    if (code == Z_OK || code == Z_STREAM_END || code == Z_BUF_ERROR) return "";
    return stream_.msg != nullptr ? stream_.msg : "not inflatable";
  }

  z_stream stream_{};
};

}  // namespace

std::unique_ptr<Decoder> make_gzip_decoder() { return std::make_unique<GzipDecoder>(); }

}  // namespace pliant

#else

std::unique_ptr<pliant::Decoder> pliant::make_gzip_decoder() { return nullptr; }

#endif
