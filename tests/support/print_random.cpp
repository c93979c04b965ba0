// SPDX-License-Identifier: MIT
// Random numbers as the library makes them, one line of decimals for each line of decimals on
// standard input:
//
//   pliant_print_random philox     c0 c1 c2 c3 k0 k1 -> the four words of Philox4x64-10
//   pliant_print_random direction  seed domain walker step joint -> x y z, as hexadecimal floats
#include <array>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>

#include "pliant/base/random.hpp"

namespace {

using namespace pliant;

RandomSequence sequence_of(std::istream& words) {
  RandomKey key;
  std::uint64_t domain = 0;
  words >> key.seed >> domain >> key.walker >> key.step >> key.joint;
  key.domain = static_cast<Domain>(domain);
  return RandomSequence(key);
}

void print_philox(std::istream& words) {
  std::array<std::uint64_t, 4> counter{};
  std::array<std::uint64_t, 2> key{};
  for (std::uint64_t& word : counter) words >> word;
  for (std::uint64_t& word : key) words >> word;
  for (const std::uint64_t word : philox4x64(counter, key)) std::cout << word << ' ';
}

void print_direction(std::istream& words) {
  const Vec3 direction = sequence_of(words).direction();
  for (const double x : {direction.x, direction.y, direction.z}) std::printf("%a ", x);
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  const std::string mode = count > 1 ? arguments[1] : "";
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    if (mode == "philox") {
      print_philox(words);
    } else if (mode == "direction") {
      print_direction(words);
    } else {
      std::cerr << "usage: pliant_print_random philox|direction\n";
      return 2;
    }
    if (!words) {
      std::cerr << "pliant_print_random: too few numbers in: " << line << '\n';
      return 2;
    }
    std::cout << std::endl;
  }
}
