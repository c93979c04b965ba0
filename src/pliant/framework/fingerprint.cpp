// SPDX-License-Identifier: MIT
#include "pliant/framework/fingerprint.hpp"

#include <bit>
#include <string_view>

namespace pliant {
namespace {

class Fnv1a {
 public:
  void add(std::uint8_t byte) { hash_ = (hash_ ^ byte) * 0x100000001b3u; }
  void add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int shift = 0; shift < 64; shift += 8) add(static_cast<std::uint8_t>(bits >> shift));
  }
  void add(std::span<const Vec3> positions) {
    for (const Vec3& x : positions)
      for (double part : {x.x, x.y, x.z}) add(part);
  }
  /// Adds a text with an end, so that "C", "A1" is not "CA", "1".
  void add(std::string_view text) {
    for (char c : text) add(static_cast<std::uint8_t>(c));
    add(std::uint8_t{0});
  }
  std::uint64_t hash() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace

std::uint64_t fingerprint(std::span<const Vec3> positions) {
  Fnv1a all;
  all.add(positions);
  return all.hash();
}

std::uint64_t fingerprint(const AtomTable& atoms, std::span<const Vec3> positions) {
  Fnv1a all;
  all.add(positions);
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    all.add(std::string_view(atoms.names[k]));
    all.add(atoms.elements[k]);
    all.add(std::string_view(atoms.residues[atoms.residue_of[k]].name));
  }
  return all.hash();
}

std::string fingerprint_text(std::uint64_t fingerprint) {
  std::string text(16, '0');
  for (std::size_t k = 16; k-- > 0; fingerprint >>= 4)
    text[k] = "0123456789abcdef"[fingerprint & 15u];
  return text;
}

}  // namespace pliant
