// SPDX-License-Identifier: MIT
// H5MD files with flipped bits and broken structures: read, or refused; never the end of the
// process, never a wait, never memory for what is only stated.
#include "pliant/record/hdf5/structure_check.hpp"

#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/record/hdf5/expansion.hpp"
#include "pliant/record/hdf5/hdf5_dataset.hpp"
#include "support/damaged_files.hpp"
#include "support/test.hpp"
#include "unit/record/foreign_file.hpp"
#include "unit/record/samples.hpp"

namespace pliant::structure_check_test {

using namespace test;
using testing::HasSubstr;

class StructureCheckTest : public H5mdReaderTest {
 protected:
  std::string fault() {
    return error_text<Error>([&] { check_hdf5_structure(path_); });
  }
  void put(std::uint64_t at, const std::string& bytes) {
    std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(static_cast<std::streamoff>(at));
    file << bytes;
  }
  /// Where the bytes come first, from a place on.
  std::uint64_t find(const std::string& bytes, std::uint64_t from = 0) {
    return content_of(path_).find(bytes, from);
  }
};

TEST_F(StructureCheckTest, KnowsAllOfOurFilesAndWhatOtherProgramsWrite) {
  { H5mdRecorder(path_, named_chain(4)).record(sample_frame(0, 4).frame); }
  EXPECT_TRUE(check_hdf5_structure(path_));
  { ForeignFile(path_).add_trajectory(); }
  EXPECT_TRUE(check_hdf5_structure(path_));
}

TEST_F(StructureCheckTest, SaysThatNewerFormatsAreNotAllKnown) {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
  {
    ForeignFile file(path_, H5P_DEFAULT, access);
    for (int k = 0; k < 12; ++k) file.add("/o" + std::to_string(k), {4});
  }
  H5Pclose(access);
  EXPECT_FALSE(check_hdf5_structure(path_));
}

TEST_F(StructureCheckTest, NamesWhatIsWrong) {
  { ForeignFile(path_).add_trajectory(); }
  const std::uint64_t tree = find("TREE"), heap = find("HEAP"), node = find("SNOD");
  put(tree + 4, "\x02");
  EXPECT_EQ(fault(), "is damaged: tree node at byte " + std::to_string(tree) +
                         ": is of another kind of tree");
  put(tree + 4, std::string(1, '\0'));
  put(heap, "h");
  EXPECT_EQ(fault(),
            "is damaged: heap at byte " + std::to_string(heap) + ": does not begin with HEAP");
  put(heap, "H");
  put(node + 6, "\x77");
  EXPECT_EQ(fault(),
            "is damaged: symbol node at byte " + std::to_string(node) + ": has too many symbols");
}

TEST_F(StructureCheckTest, SeesBlocksThatOverlapAndAddressesBeyondTheEnd) {
  foreign([&](ForeignFile& file) {
    file.add("/a", {64});
    file.add("/b", {64});
  });
  // Version 3, contiguous, then the address of the values: that of b becomes that of a.
  const std::uint64_t first = find(std::string("\x03\x01", 2)),
                      second = find("\x03\x01", first + 2);
  std::ifstream file(path_, std::ios::binary);
  std::string address(8, '\0');
  file.seekg(static_cast<std::streamoff>(first + 2));
  file.read(address.data(), 8);
  put(second + 2, std::string(8, '\x11'));
  EXPECT_EQ(fault(), "is damaged: values at byte 1229782938247303441 is beyond the end");
  put(second + 2, address.substr(0, 1) + std::string(1, char(address[1] + 1)) + address.substr(2));
  EXPECT_NE(fault().find(" overlap"), std::string::npos);
}

TEST_F(StructureCheckTest, GoesThroughGroupsNestedWithoutEnd) {
  foreign([&](ForeignFile& file) {
    hid_t group = H5Gopen2(file.id(), "/", H5P_DEFAULT);
    for (int k = 0; k < 20'000; ++k) {
      const hid_t inner = H5Gcreate2(group, "a", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
      H5Gclose(group);
      group = inner;
    }
    H5Gclose(group);
  });
  EXPECT_TRUE(check_hdf5_structure(path_));
}

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
  EXPECT_THAT(error_text<InputError>([&] { Hdf5Dataset(file, "/names").texts(); }),
              HasSubstr("/names of shape (200) has values that unpack to 134217728 bytes"));
  H5Fclose(file);
  write_one_name(path, "CA", 200);
  const hid_t small = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  EXPECT_EQ(Hdf5Dataset(small, "/names").texts(), std::vector<std::string>(200, "CA"));
  H5Fclose(small);
}

std::uint64_t count_of(std::uint64_t few, std::uint64_t many) {
  return std::getenv("PLIANT_ALL") == nullptr ? few : many;
}

void read_all(const std::filesystem::path& path) {
  const H5mdReader reader(path);
  for (std::int64_t frame = 0; frame < std::min<std::int64_t>(reader.frames(), 100); ++frame) {
    reader.positions(frame);
    reader.step(frame);
    if (reader.has_time()) reader.time(frame);
  }
  for (const std::string& name : reader.observables()) reader.observable(name);
  reader.parameters();
  reader.bonds();
  reader.bond_origin_names();
  reader.atoms();
  reader.schema();
  reader.framework();
}

class H5mdFlipTest : public H5mdReaderTest {
 protected:
  /// Reads copies of the file at path_, of which none may kill.
  void read_damaged(std::uint64_t flips, std::uint64_t damages) {
    const std::string whole = content_of(path_);
    ASSERT_EQ(death_of([&] { read_all(path_); }), "");
    for (std::uint64_t k = 0; k < flips + damages; ++k) {
      const bool is_flip = k < flips;
      const std::string bytes = is_flip ? with_a_flip(whole, k) : with_a_damage(whole, k);
      std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes;
      EXPECT_EQ(death_of([&] { read_all(path_); }), "") << (is_flip ? "flip " : "damage ") << k;
    }
  }
};

void record(const std::filesystem::path& path, bool compress) {
  constexpr std::size_t joints = 5;
  H5mdHeader header;
  header.bonds = {{0, 1, 0, 1}, {1, 2, 0, 2}};
  header.bond_origin_names = {"file", "distance"};
  for (int k = 0; k < 20; ++k) header.parameters.emplace_back("run/n" + std::to_string(k), 0.5 * k);
  header.parameters.emplace_back("run/technique", std::string("blocks"));
  H5mdRecorder recorder(path, named_chain(joints), header,
                        {.precision = compress ? 1e-9 : 0.0, .flush_seconds = 0.0});
  for (int number = 0; number < 70; ++number) recorder.record(sample_frame(number, joints).frame);
}

TEST_F(H5mdFlipTest, OfOursKillsNobody) {
  record(path_, false);
  read_damaged(count_of(75, 6000), count_of(25, 600));
}

TEST_F(H5mdFlipTest, OfOursThatIsCompressedKillsNobody) {
  record(path_, true);
  read_damaged(count_of(25, 2000), count_of(12, 200));
}

void write_foreign(const std::filesystem::path& path, hid_t access) {
  ForeignFile file(path, H5P_DEFAULT, access);
  file.add_trajectory();
  for (int k = 0; k < 12; ++k) file.add("/observables/o" + std::to_string(k) + "/value", {4});
}

TEST_F(H5mdFlipTest, OfAnotherProgramKillsNobody) {
  write_foreign(path_, H5P_DEFAULT);
  read_damaged(count_of(25, 1000), count_of(12, 100));
}

/// More than eight links of a group are in a heap and a tree, which HDF5 reads in another process
/// first.
TEST_F(H5mdFlipTest, OfANewerFormatKillsNobody) {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
  write_foreign(path_, access);
  H5Pclose(access);
  read_damaged(count_of(25, 1000), count_of(12, 100));
}

}  // namespace pliant::structure_check_test
