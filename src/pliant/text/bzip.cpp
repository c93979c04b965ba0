// SPDX-License-Identifier: MIT
#include "pliant/text/bzip.hpp"

#ifdef PLIANT_HAS_BZIP2

#include <bzlib.h>

#include <algorithm>
#include <limits>
#include <new>

namespace pliant {
namespace {

class Bzip2Decoder final : public Decoder {
 public:
  Bzip2Decoder() { start(); }
  ~Bzip2Decoder() override { BZ2_bzDecompressEnd(&stream_); }

  Decoded step(std::string_view& bytes, std::span<char> room) override {
    constexpr std::size_t most = std::numeric_limits<unsigned>::max();
    const std::size_t given = std::min(bytes.size(), most);
    stream_.next_in = const_cast<char*>(bytes.data());
    stream_.avail_in = static_cast<unsigned>(given);
    stream_.next_out = room.data();
    stream_.avail_out = static_cast<unsigned>(room.size());
    const int code = BZ2_bzDecompress(&stream_);
    bytes.remove_prefix(given - stream_.avail_in);
    return {room.size() - stream_.avail_out, code == BZ_STREAM_END, damage_of(code)};
  }

  void restart() override {
    BZ2_bzDecompressEnd(&stream_);
    start();
  }

 private:
  void start() {
    stream_ = {};
    if (BZ2_bzDecompressInit(&stream_, 0, 0) != BZ_OK) throw std::bad_alloc();
  }

  static std::string damage_of(int code) {
    if (code == BZ_MEM_ERROR) throw std::bad_alloc();
    if (code == BZ_OK || code == BZ_STREAM_END) return "";
    return code == BZ_DATA_ERROR_MAGIC ? "incorrect header" : "incorrect data check";
  }

  bz_stream stream_{};
};

}  // namespace

std::unique_ptr<Decoder> make_bzip2_decoder() { return std::make_unique<Bzip2Decoder>(); }

}  // namespace pliant

#else

std::unique_ptr<pliant::Decoder> pliant::make_bzip2_decoder() { return nullptr; }

#endif
