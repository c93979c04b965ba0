// SPDX-License-Identifier: MIT
// Copies of a file with something wrong, and reading them in processes of their own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace pliant::test {

/// `bytes` with one bit turned over. The same for the same number.
std::string with_a_flip(const std::string& bytes, std::uint64_t number);

/// `bytes` with a piece overwritten by another piece, zeros, ones or an odd number, or cut off.
std::string with_a_damage(const std::string& bytes, std::uint64_t number);

/// How reading a file in a forked process ended: "" well, or by an exception of ours; else what
/// killed it: a signal, more than `seconds` of the processor, or more than 1 GiB of memory.
std::string death_of(const std::function<void()>& read, unsigned seconds = 10);

}  // namespace pliant::test
