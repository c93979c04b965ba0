// SPDX-License-Identifier: MIT
#include "support/compressed.hpp"

#include <zlib.h>
#ifdef PLIANT_HAS_BZIP2
#include <bzlib.h>
#endif
#ifdef PLIANT_HAS_XZ
#include <lzma.h>
#endif

namespace pliant::test {

std::string gzipped(const std::string& text) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 16 + MAX_WBITS, 9, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, text.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

#ifdef PLIANT_HAS_BZIP2
std::string bzip2ed(const std::string& text) {
  std::string out(text.size() + text.size() / 100 + 600, '\0');
  auto size = static_cast<unsigned>(out.size());
  BZ2_bzBuffToBuffCompress(out.data(), &size, const_cast<char*>(text.data()),
                           static_cast<unsigned>(text.size()), 9, 0, 0);
  out.resize(size);
  return out;
}
#else
std::string bzip2ed(const std::string&) { return ""; }
#endif

#ifdef PLIANT_HAS_XZ
std::string xzed(const std::string& text) {
  std::string out(lzma_stream_buffer_bound(text.size()), '\0');
  std::size_t size = 0;
  lzma_easy_buffer_encode(6, LZMA_CHECK_CRC64, nullptr,
                          reinterpret_cast<const std::uint8_t*>(text.data()), text.size(),
                          reinterpret_cast<std::uint8_t*>(out.data()), &size, out.size());
  out.resize(size);
  return out;
}
#else
std::string xzed(const std::string&) { return ""; }
#endif

std::string xzed_for_much_memory(const std::string& text) {
  constexpr std::size_t header = 12;  // of the stream; that of the first block follows
  std::string out = xzed(text);
  if (out.empty()) return out;
  const std::size_t size = static_cast<unsigned char>(out[header]) * std::size_t{4};
  const std::size_t filter = out.find("\x21\x01", header);  // LZMA2, one byte of properties
  out[filter + 2] = 36;
  const auto* block = reinterpret_cast<const Bytef*>(out.data() + header);
  unsigned long check = ::crc32(0, block, static_cast<uInt>(size));
  for (std::size_t byte = 0; byte < 4; ++byte, check >>= 8)
    out[header + size + byte] = static_cast<char>(check & 0xff);
  return out;
}

}  // namespace pliant::test
