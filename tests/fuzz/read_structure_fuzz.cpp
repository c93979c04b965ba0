// SPDX-License-Identifier: MIT
// Feeds bytes to a reader and what it made of them to everything up to the framework. Errors are
// right; crashes, hangs, numbers that are not finite and bonds to nowhere are not.
//
//   read_structure_fuzz --format=pdb FOLDER...   fuzzes one format
//   read_structure_fuzz --formats                lists them
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "pliant/base/error.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/build_framework.hpp"
#include "pliant/molecule/read/read.hpp"

namespace {

std::string format_name;

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

void check(const pliant::Structure& structure) {
  const std::size_t count = structure.positions.size();
  for (const pliant::Vec3 position : structure.positions)
    require(is_finite(position), "positions are finite");
  for (const pliant::Bond& bond : structure.bonds) {
    require(bond.a < bond.b, "a bond names its lower atom first");
    require(bond.b < count, "a bond joins atoms of the structure");
  }
}

void read(std::string_view text) {
  pliant::ReadOptions options;
  options.format = format_name;
  pliant::Structure structure = read_structure(pliant::SourceText{"fuzzed", text}, options);
  check(structure);
  perceive_bonds(structure);
  check(structure);
  build_framework(structure);
}

void list_formats() {
  for (const pliant::Format& format : pliant::formats())
    std::printf("%.*s\n", static_cast<int>(format.name.size()), format.name.data());
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  constexpr std::string_view flag = "--format=";
  for (int i = 1; i < *count; ++i) {
    const std::string_view argument = (*arguments)[i];
    if (argument.starts_with(flag)) format_name = argument.substr(flag.size());
    if (argument == "--formats") {
      list_formats();
      std::exit(0);
    }
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    read({reinterpret_cast<const char*>(bytes), size});
  } catch (const pliant::Error&) {  // what is wrong was said
  }
  return 0;
}
