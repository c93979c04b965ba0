// SPDX-License-Identifier: MIT
#include "pliant/text/xz.hpp"

#ifdef PLIANT_HAS_XZ

#include <lzma.h>

#include <new>

namespace pliant {
namespace {

constexpr std::uint64_t most_memory = std::uint64_t{256} << 20;

class XzDecoder final : public Decoder {
 public:
  XzDecoder() { start(); }
  ~XzDecoder() override { lzma_end(&stream_); }

  Decoded step(std::string_view& bytes, std::span<char> room) override {
    stream_.next_in = reinterpret_cast<const std::uint8_t*>(bytes.data());
    stream_.avail_in = bytes.size();
    stream_.next_out = reinterpret_cast<std::uint8_t*>(room.data());
    stream_.avail_out = room.size();
    const lzma_ret code = lzma_code(&stream_, LZMA_RUN);
    bytes.remove_prefix(bytes.size() - stream_.avail_in);
    return {room.size() - stream_.avail_out, code == LZMA_STREAM_END, damage_of(code)};
  }

  void restart() override { start(); }

 private:
  /// A stream that was in use keeps its memory for the next one.
  void start() {
    if (lzma_stream_decoder(&stream_, most_memory, 0) != LZMA_OK) throw std::bad_alloc();
  }

  static std::string damage_of(lzma_ret code) {
    switch (code) {
      case LZMA_OK:
      case LZMA_STREAM_END:
      case LZMA_BUF_ERROR:
        return "";
      case LZMA_MEM_ERROR:
        throw std::bad_alloc();
      case LZMA_MEMLIMIT_ERROR:
        return "needs more than 256 MiB of memory to be expanded";
      case LZMA_FORMAT_ERROR:
        return "incorrect header";
      case LZMA_OPTIONS_ERROR:
        return "unknown compression method";
      default:
        return "incorrect data check";
    }
  }

  lzma_stream stream_ = LZMA_STREAM_INIT;
};

}  // namespace

std::unique_ptr<Decoder> make_xz_decoder() { return std::make_unique<XzDecoder>(); }

}  // namespace pliant

#else

std::unique_ptr<pliant::Decoder> pliant::make_xz_decoder() { return nullptr; }

#endif
