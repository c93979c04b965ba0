// SPDX-License-Identifier: MIT
// Damaged, hostile and half-written H5MD files.
#include "pliant/record/h5md/h5md_reader.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/test.hpp"
#include "unit/record/foreign_file.hpp"

namespace pliant::h5md_damage_test {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class H5mdDamageTest : public H5mdReaderTest {};

// h508
TEST_F(H5mdDamageTest, StaysWithinTheFile) {
  const auto other = directory_ / "other.h5md";
  { ForeignFile(other).add_trajectory(); }
  foreign([&](ForeignFile& file) {
    H5Lcreate_external(other.c_str(), "/particles", file.id(), "/particles", H5P_DEFAULT,
                       H5P_DEFAULT);
  });
  EXPECT_EQ(failure(), "\"/particles\" leads to the file \"" + other.string() +
                           "\": links to other files are not followed");
  trajectory_with([&](ForeignFile& file) {
    H5Ldelete(file.id(), value, H5P_DEFAULT);
    H5Lcreate_external(other.c_str(), value, file.id(), "/elsewhere", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/elsewhere", file.id(), value, H5P_DEFAULT, H5P_DEFAULT);
  });
  EXPECT_EQ(failure(), "\"" + std::string(value) + "\" leads to the file \"" + other.string() +
                           "\": links to other files are not followed");
}

TEST_F(H5mdDamageTest, ReadsNoValuesOfOtherFiles) {
  const hid_t external = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(external, "/etc/passwd", 0, H5F_UNLIMITED);
  { ForeignFile(path_).add(value, {4, 2, 3}, H5T_STD_U8LE, external, false); }
  EXPECT_EQ(failure(), std::string(value) + " has its values in other files, which are not read");
  H5Pclose(external);
}

TEST_F(H5mdDamageTest, FollowsLinksWithinTheFileAndEndsCycles) {
  foreign([&](ForeignFile& file) {
    file.add_trajectory("real");
    H5Lcreate_soft("/particles/real", file.id(), "/particles/trajectory", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_hard(file.id(), "/particles", file.id(), "/particles/real/loop", H5P_DEFAULT,
                   H5P_DEFAULT);
    file.add("/observables/a/value", {4});
    H5Lcreate_hard(file.id(), "/observables", file.id(), "/observables/a/loop", H5P_DEFAULT,
                   H5P_DEFAULT);
  });
  EXPECT_EQ(open().group(), "trajectory");
  EXPECT_EQ(open().positions(1)[0].x, 6.0);
  EXPECT_THAT(open().observables(), ElementsAre("a"));
  foreign([&](ForeignFile& file) {
    H5Lcreate_soft("/b", file.id(), "/particles", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/particles", file.id(), "/b", H5P_DEFAULT, H5P_DEFAULT);
  });
  EXPECT_EQ(failure(), "cannot open \"/particles\": too many links");
}

// h509
TEST_F(H5mdDamageTest, NamesAMissingFilter) {
  const hsize_t chunk[] = {1, 2, 3};
  const hid_t packed = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(packed, 3, chunk);
  H5Pset_filter(packed, 32001, H5Z_FLAG_OPTIONAL, 0, nullptr);
  { ForeignFile(path_).add(value, {4, 2, 3}, H5T_IEEE_F64LE, packed, false); }
  H5Pclose(packed);
  EXPECT_THAT(failure(), HasSubstr(std::string(value) + " is packed with filter 32001 ("));
  EXPECT_THAT(failure(), HasSubstr("), which HDF5 does not have here"));
}

// h510
TEST_F(H5mdDamageTest, TakesNoMemoryForWhatIsOnlyStated) {
  const hsize_t chunk[] = {1, 2, 3};
  const hid_t chunked = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(chunked, 3, chunk);
  foreign([&](ForeignFile& file) {
    file.add(value, {hsize_t{1} << 62, 2, 3}, H5T_IEEE_F64LE, chunked, false);
    file.unit(value, "nm");
  });
  EXPECT_EQ(open().frames(), std::int64_t{1} << 62);
  const std::string never = std::string(value) +
                            " of shape (4611686018427387904, 2, 3) has 0 bytes in the file: it "
                            "was never written, or is damaged";
  EXPECT_EQ(failure(read_first), never);
  foreign([&](ForeignFile& file) {
    file.add(value, {4, hsize_t{1} << 31, 3}, H5T_IEEE_F64LE, chunked, false);
    file.unit(value, "nm");
  });
  EXPECT_THAT(failure(read_first), HasSubstr("has 0 bytes in the file"));
  foreign([&](ForeignFile& file) {
    file.add(value, {4, hsize_t{1} << 33, 3}, H5T_IEEE_F64LE, chunked, false);
  });
  EXPECT_EQ(failure(), std::string(value) + " states shape (4, 8589934592, 3)");
  H5Pclose(chunked);
}

TEST_F(H5mdDamageTest, TakesNoMemoryForStatedStepsAndNames) {
  const hsize_t chunk[] = {64};
  const hid_t chunked = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(chunked, 1, chunk);
  const hsize_t huge = hsize_t{1} << 50;
  trajectory_with([&](ForeignFile& file) {
    file.add("/parameters/topology/atom_name", {huge}, H5T_C_S1, chunked, false);
    file.add("/observables/x/value", {huge}, H5T_IEEE_F64LE, chunked, false);
  });
  EXPECT_THAT(failure([](const H5mdReader& r) { r.atoms(); }), HasSubstr("has 0 bytes"));
  EXPECT_THAT(failure([](const H5mdReader& r) { r.observable("x"); }), HasSubstr("has 0 bytes"));
  H5Pclose(chunked);
}

// h511
TEST_F(H5mdDamageTest, CallsAFrameOfFillValuesDamaged) {
  trajectory_with([&](ForeignFile& file) {
    std::vector<double> values(24, 1.0);
    values[6 + 3] = std::nan("");
    file.write(value, values);
  });
  EXPECT_EQ(open().positions(0)[0].x, 1.0);
  EXPECT_EQ(failure([](const H5mdReader& r) { r.positions(1); }),
            "frame 1 is damaged: the position of joint 1 is not finite");
}

TEST_F(H5mdDamageTest, CallsAFrameThatWasNeverWrittenDamaged) {
  const hsize_t chunk[] = {2, 2, 3}, start[] = {0, 0, 0}, count[] = {1, 2, 3};
  const hid_t chunked = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(chunked, 3, chunk);
  foreign([&](ForeignFile& file) {
    file.add(value, {4, 2, 3}, H5T_IEEE_F64LE, chunked, false);
    file.unit(value, "A");
    const hid_t set = H5Dopen2(file.id(), value, H5P_DEFAULT), space = H5Dget_space(set);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr);
    const hid_t memory = H5Screate_simple(3, count, nullptr);
    const std::vector<double> values(6, 2.0);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data());
    H5Sclose(memory);
    H5Sclose(space);
    H5Dclose(set);
  });
  H5Pclose(chunked);
  EXPECT_EQ(open().positions(0)[1].z, 2.0);
  EXPECT_EQ(failure([](const H5mdReader& r) { r.positions(3); }),
            std::string(value) + ": row 3 was never written, or is damaged");
}

// h512
TEST_F(H5mdDamageTest, SaysWhatToDoWithAFileThatItsWriterLeftOpen) {
  const pid_t child = ::fork();
  if (child == 0) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
    const hid_t file = H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
    H5Fflush(file, H5F_SCOPE_GLOBAL);
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(failure(),
            "was not closed by the program that wrote it, or is still being written; \"h5clear -s "
            "--increment\" on a copy may bring it back, -s alone destroys it");
}

// h513
TEST_F(H5mdDamageTest, SaysThatAnotherProgramHasTheFile) {
  { ForeignFile(path_).add_trajectory(); }
  const int other = ::open(path_.c_str(), O_RDWR);
  ASSERT_EQ(::flock(other, LOCK_EX | LOCK_NB), 0);
  EXPECT_THAT(failure(),
              HasSubstr("is in use by another program (unable to lock file, errno = 11"));
  ::close(other);
}

// h514
TEST_F(H5mdDamageTest, NamesWhatIsNoHdf5File) {
  EXPECT_EQ(failure(), "cannot open: No such file or directory");
  std::ofstream(path_) << "ATOM      1  N   ALA A   1";
  EXPECT_EQ(failure(), "is not an HDF5 file");
  std::ofstream(path_, std::ios::trunc).flush();
  EXPECT_EQ(failure(), "is not an HDF5 file");
  std::filesystem::remove(path_);
  std::filesystem::create_directory(path_);
  EXPECT_EQ(failure(), "is not a regular file");
}

TEST_F(H5mdDamageTest, NamesATruncatedFile) {
  { ForeignFile(path_).add_trajectory(); }
  const auto size = std::filesystem::file_size(path_);
  std::filesystem::resize_file(path_, size - 100);
  EXPECT_THAT(failure(), HasSubstr("is damaged: superblock: truncated file: "));
}

/// Lengths that a copy can break off at: an error, never a crash.
TEST_F(H5mdDamageTest, SurvivesPrefixes) {
  { ForeignFile(path_).add_trajectory(); }
  const std::string whole = content_of(path_);
  const std::size_t finer = std::getenv("PLIANT_ALL") == nullptr ? 16 : 64;
  for (std::size_t size = 0; size < whole.size(); size += 1 + size / finer) {
    std::ofstream(path_, std::ios::binary | std::ios::trunc).write(whole.data(), long(size));
    EXPECT_THROW(open(), Error) << size;
  }
}

TEST_F(H5mdDamageTest, RefusesConnectivityThatLeadsNowhere) {
  trajectory_with([&](ForeignFile& file) {
    file.add("/connectivity/bars", {2, 2}, H5T_STD_I32LE);
    file.add("/connectivity/bonds", {2, 3}, H5T_STD_I32LE);
    file.add("/parameters/framework/rest_length", {5});
  });
  EXPECT_EQ(failure([](const H5mdReader& r) { r.bars(); }),
            "/connectivity/bars: value 2 is 2; expected 0 to 1");
  EXPECT_EQ(failure([](const H5mdReader& r) { r.bonds(); }),
            "/connectivity/bonds has shape (2, 3); expected (pairs, 2)");
  trajectory_with([&](ForeignFile& file) {
    file.add("/connectivity/bars", {1, 2}, H5T_STD_I32LE);
    file.add("/parameters/framework/rest_length", {5});
  });
  EXPECT_EQ(failure([](const H5mdReader& r) { r.framework(); }),
            "/parameters/framework/rest_length has 5 values; expected 1");
}

}  // namespace pliant::h5md_damage_test
