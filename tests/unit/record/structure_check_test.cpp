// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/structure_check.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "unit/record/foreign_file.hpp"

namespace pliant {
namespace structure_check_test {

using namespace test;

class StructureCheckTest : public H5mdReaderTest {
 protected:
  std::string fault() {
    return message_of<Error>([&] { check_hdf5_structure(path_); });
  }
  void put(std::uint64_t at, const std::string& bytes) {
    std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(static_cast<std::streamoff>(at));
    file << bytes;
  }
  /// Where the bytes come first, from a place on.
  std::uint64_t find(const std::string& bytes, std::uint64_t from = 0) {
    std::ifstream file(path_, std::ios::binary);
    const std::string all{std::istreambuf_iterator<char>(file), {}};
    return all.find(bytes, from);
  }
};

TEST_F(StructureCheckTest, KnowsAllOfOurFiles) {
  { H5mdRecorder(path_, test::chain(4)).record(sample_frame(0, 4).frame); }
  EXPECT_TRUE(check_hdf5_structure(path_));
}

TEST_F(StructureCheckTest, KnowsWhatOtherProgramsWrite) {
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
  {
    ForeignFile file(path_);
    file.add("/a", {64});
    file.add("/b", {64});
  }
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
  {
    ForeignFile file(path_);
    hid_t group = H5Gopen2(file.id(), "/", H5P_DEFAULT);
    for (int k = 0; k < 20'000; ++k) {
      const hid_t inner = H5Gcreate2(group, "a", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
      H5Gclose(group);
      group = inner;
    }
    H5Gclose(group);
  }
  EXPECT_TRUE(check_hdf5_structure(path_));
}

}  // namespace structure_check_test
}  // namespace pliant
