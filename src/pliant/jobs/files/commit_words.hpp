// SPDX-License-Identifier: MIT
// States and frames as 64-bit words, which a log of commits consists of.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// Takes numbers and lists of them, one after another.
class CommitWords {
 public:
  void add(std::int64_t value) { words_.push_back(std::bit_cast<std::uint64_t>(value)); }
  void add(double value) { words_.push_back(std::bit_cast<std::uint64_t>(value)); }
  void add(std::span<const Vec3> vectors);
  /// Eight of them in a word.
  void add(std::span<const std::uint8_t> bytes);
  void add(std::string_view text);
  void add(const State& state);
  /// Without the positions of the step before.
  void add(const Frame& frame);

  std::span<const std::uint64_t> words() const { return words_; }

 private:
  std::vector<std::uint64_t> words_;
};

/// Gives back what CommitWords took, in the same order. Throws InputError where words are missing.
class CommitWordReader {
 public:
  explicit CommitWordReader(std::span<const std::uint64_t> words) : words_(words) {}

  std::int64_t integer() { return std::bit_cast<std::int64_t>(next()); }
  double real() { return std::bit_cast<double>(next()); }
  std::vector<Vec3> vectors();
  std::vector<std::uint8_t> bytes();
  State state();
  /// The frame; its spans show `positions` and `limits_off`.
  Frame frame(std::vector<Vec3>& positions, std::vector<std::uint8_t>& limits_off);

 private:
  std::uint64_t next();
  std::span<const std::uint64_t> take(std::size_t count);

  std::span<const std::uint64_t> words_;
};

/// The digest of all of them (base/word_digest.hpp).
std::uint64_t digest_of(std::span<const std::uint64_t> words);

}  // namespace pliant
