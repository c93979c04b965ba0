// SPDX-License-Identifier: MIT
// Compressing with the libraries themselves: what the tests of expanding begin from.
#pragma once

#include <string>

namespace pliant::test {

std::string gzipped(const std::string& text);
/// Empty where this build has no such library.
std::string bzip2ed(const std::string& text);
std::string xzed(const std::string& text);
/// The same, but its header says that it needs 1 GiB of memory to be expanded.
std::string xzed_for_much_memory(const std::string& text);

}  // namespace pliant::test
