// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/expansion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "pliant/record/hdf5/hdf5_dataset.hpp"
#include "unit/record/foreign_file.hpp"

namespace pliant {
namespace expansion_test {

using namespace test;
using ::testing::HasSubstr;

constexpr std::uint64_t mib = std::uint64_t{1} << 20;
constexpr std::uint64_t gib = std::uint64_t{1} << 30;

TEST(Expansion, SmallAndHonestDatasetsAreRead) {
  EXPECT_EQ(refusal_of({}), "");
  EXPECT_EQ(refusal_of({.values = 1000, .at_once = 1000, .stored = 1, .file_size = 2000}), "");
  // 10^6 atoms in a chunk of a frame, packed a thousandfold; 10^7 atoms, packed by ten
  EXPECT_EQ(refusal_of({24000000, 24000000, 24000000, 24000, 1, mib}), "");
  EXPECT_EQ(refusal_of({240000000, 240000000, 240000000, 24000000, 1, gib}), "");
  // of values that are not in memory at once there may be many
  EXPECT_EQ(refusal_of({gib, mib, mib, mib, 1024, gib}), "");
}

TEST(Expansion, ValuesThatTheFileCannotHoldAreRefused) {
  const std::string why = "has 10 bytes in the file: it was never written, or is damaged";
  EXPECT_EQ(refusal_of({.values = 11001, .stored = 10, .file_size = 99}), why);
  EXPECT_EQ(refusal_of({.values = 11000, .stored = 10, .file_size = 99}), "");
  EXPECT_EQ(refusal_of({.values = mib, .stored = 10, .file_size = 99, .unwritten = mib}), "");
  EXPECT_EQ(refusal_of({.chunk = harmless_chunk + 1, .stored = 10, .file_size = 99}), why);
  // Chunks that state the same bytes of the file again and again hold no more than these.
  EXPECT_EQ(refusal_of({.values = gib, .stored = gib, .chunks = 1000, .file_size = 10}), why);
}

TEST(Expansion, WhatIsLargeMustHaveAHundredthInTheFile) {
  EXPECT_EQ(refusal_of({.chunk = gib, .stored = gib / 100, .file_size = gib}),
            "has chunks that unpack to 1073741824 bytes, of which the file has 10737418: at most "
            "1073741800 are allowed");
  EXPECT_EQ(refusal_of({.chunk = gib, .stored = gib / 100 + 1, .file_size = gib}), "");
  EXPECT_THAT(refusal_of({.chunk = gib, .stored = gib / 100 + 1, .chunks = 2, .file_size = gib}),
              HasSubstr("has chunks that unpack to"));
  EXPECT_EQ(refusal_of({.at_once = large_expansion, .stored = 1, .file_size = gib}), "");
  EXPECT_EQ(refusal_of({.at_once = gib, .stored = mib, .file_size = gib}),
            "has values that unpack to 1073741824 bytes, of which the file has 1048576: at most "
            "104857600 are allowed");
}

TEST(Expansion, AProductStopsAtTheLargestNumber) {
  EXPECT_EQ(times(3, 4), 12);
  EXPECT_EQ(times(0, gib), 0);
  EXPECT_EQ(times(8 * gib * gib, 2), std::numeric_limits<std::uint64_t>::max());
}

/// A file with names of variable length that are all at one place of it.
void write_one_name(const std::filesystem::path& path, const std::string& name, hsize_t count) {
  const ForeignFile file(path);
  const hid_t type = H5Tcopy(H5T_C_S1), creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Tset_size(type, H5T_VARIABLE);
  H5Pset_chunk(creation, 1, &count);
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t set = H5Dcreate2(file.id(), "names", type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  std::vector<const char*> names(count, "");
  names[0] = name.c_str();
  H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, names.data());
  H5Dflush(set);
  const hsize_t start = 0;
  std::uint32_t filters = 0;
  std::vector<char> references(16 * count);
  H5Dread_chunk(set, H5P_DEFAULT, &start, &filters, references.data());
  for (std::size_t at = 16; at < references.size(); ++at) references[at] = references[at - 16];
  H5Dwrite_chunk(set, H5P_DEFAULT, 0, &start, references.size(), references.data());
  H5Dclose(set);
  H5Sclose(space);
  H5Pclose(creation);
  H5Tclose(type);
}

TEST(Expansion, ManyTextsMayBeOnePlaceInTheFile) {
  const TempDirectory directory;
  const auto path = directory / "names.h5";
  write_one_name(path, std::string(mib, 'A'), 200);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  EXPECT_THAT(message_of<InputError>([&] { Hdf5Dataset(file, "/names").texts(); }),
              HasSubstr("/names of shape (200) has values that unpack to 134217728 bytes"));
  H5Fclose(file);
  write_one_name(path, "CA", 200);
  const hid_t small = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  EXPECT_EQ(Hdf5Dataset(small, "/names").texts(), std::vector<std::string>(200, "CA"));
  H5Fclose(small);
}

}  // namespace expansion_test
}  // namespace pliant
