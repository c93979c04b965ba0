// SPDX-License-Identifier: MIT
// H5MD files with flipped bits and broken structures: read, or refused; never the end of the
// process, never a wait, never memory for what is only stated.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "support/damaged_files.hpp"
#include "unit/record/foreign_file.hpp"
#include "unit/record/samples.hpp"

namespace pliant {
namespace h5md_flip_test {

using namespace test;

std::uint64_t count_of(std::uint64_t few, std::uint64_t many) {
  return std::getenv("PLIANT_ALL") == nullptr ? few : many;
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
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
    const std::string whole = bytes_of(path_);
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
  H5mdOptions options;
  options.compress = compress;
  options.flush_seconds = 0.0;
  H5mdRecorder recorder(path, test::chain(joints), header, options);
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

}  // namespace h5md_flip_test
}  // namespace pliant
