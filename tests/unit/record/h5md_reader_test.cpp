// SPDX-License-Identifier: MIT
#include "pliant/record/h5md_reader.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "pliant/base/error.hpp"
#include "unit/record/samples.hpp"

namespace pliant {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Extents = std::vector<hsize_t>;

/// A file as other programs write it, built dataset by dataset.
class ForeignFile {
 public:
  explicit ForeignFile(const std::filesystem::path& path, hid_t creation = H5P_DEFAULT)
      : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, H5P_DEFAULT)) {}
  ~ForeignFile() { H5Fclose(file_); }

  hid_t id() const { return file_; }

  /// A dataset of values 0, 1, 2, ... in `type`; groups on the way are made.
  void add(const std::string& path, const Extents& extents, hid_t type = H5T_IEEE_F64LE,
           hid_t creation = H5P_DEFAULT, bool write = true) {
    const hid_t space = extents.empty()
                            ? H5Screate(H5S_SCALAR)
                            : H5Screate_simple(int(extents.size()), extents.data(), nullptr);
    const hid_t links = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(links, 1);
    const hid_t set = H5Dcreate2(file_, path.c_str(), type, space, links, creation, H5P_DEFAULT);
    if (write) {
      std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = double(i);
      H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    }
    H5Dclose(set), H5Pclose(links), H5Sclose(space);
  }

  void write(const std::string& path, const std::vector<double>& values) {
    const hid_t set = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(set);
  }

  /// A text attribute of fixed length, or, with `variable`, of variable length.
  void unit(const std::string& path, const std::string& text, bool variable = true) {
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
    H5Tset_size(type, variable ? H5T_VARIABLE : text.size());
    const hid_t attribute = H5Acreate_by_name(file_, path.c_str(), "unit", type, space, H5P_DEFAULT,
                                              H5P_DEFAULT, H5P_DEFAULT);
    const char* pointer = text.c_str();
    H5Awrite(attribute, type, variable ? static_cast<const void*>(&pointer) : pointer);
    H5Aclose(attribute), H5Sclose(space), H5Tclose(type);
  }

  /// Four frames of two joints, with everything that the format asks for.
  void add_trajectory(const std::string& group = "trajectory") {
    const std::string position = "/particles/" + group + "/position";
    add(position + "/value", {4, 2, 3});
    add(position + "/step", {4}, H5T_STD_I32LE);
    add(position + "/time", {4});
    unit(position + "/value", "Angstrom");
    unit(position + "/time", "ps");
  }

 private:
  hid_t file_;
};

constexpr char value[] = "/particles/trajectory/position/value";
constexpr char step[] = "/particles/trajectory/position/step";
constexpr char time_path[] = "/particles/trajectory/position/time";

class H5mdReaderTest : public ::testing::Test {
 protected:
  // HDF5 tells on stderr of each failing call, of which these tests have many.
  H5mdReaderTest() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

  H5mdReader open(const std::string& group = "") {
    H5mdReadOptions options;
    options.group = group;
    options.log.function = [this](Severity severity, std::string_view text) {
      messages_.push_back((severity == Severity::note ? "note: " : "warning: ") +
                          std::string(text));
    };
    return H5mdReader(path_, options);
  }
  /// The message with which opening (or `use` of) the file fails, without the file's name.
  std::string failure(const std::function<void(const H5mdReader&)>& use = [](const auto&) {}) {
    const std::string text = message_of<Error>([&] { use(open()); });
    const std::string name = path_.string() + ": ";
    EXPECT_EQ(text.substr(0, name.size()), name);
    return text.substr(std::min(text.size(), name.size()));
  }
  static void read_first(const H5mdReader& reader) { reader.positions(0); }

  TempDirectory directory_;
  std::filesystem::path path_ = directory_ / "file.h5md";
  std::vector<std::string> messages_;
};

TEST_F(H5mdReaderTest, ReadsAForeignTrajectory) {
  { ForeignFile(path_).add_trajectory(); }
  const H5mdReader reader = open();
  EXPECT_EQ(reader.frames(), 4);
  EXPECT_EQ(reader.joint_count(), 2u);
  EXPECT_EQ(reader.positions(1), (std::vector<Vec3>{{6, 7, 8}, {9, 10, 11}}));
  EXPECT_EQ(reader.step(3), 3);
  EXPECT_EQ(reader.time(3), 3.0);
  EXPECT_EQ(reader.atoms(), nullptr);
  EXPECT_TRUE(reader.bars().empty() && reader.bonds().empty() && reader.masses().empty());
  EXPECT_TRUE(reader.observables().empty() && reader.parameters().empty());
  EXPECT_THAT(messages_, ElementsAre());
  EXPECT_EQ(failure([](const H5mdReader& r) { r.framework(); }),
            "no bars with rest lengths: /connectivity/bars or /parameters/framework/rest_length "
            "is missing");
  EXPECT_EQ(failure([](const H5mdReader& r) { r.positions(4); }),
            "no frame 4: there are 4, counted from 0");
}

// h501
TEST_F(H5mdReaderTest, NamesTheGroupsThereAre) {
  { ForeignFile(path_).add("/somewhere/else", {2}); }
  EXPECT_EQ(failure(),
            "no group with positions in /particles; groups of the file: \"somewhere\"; of "
            "/particles: none");
  {
    ForeignFile file(path_);
    file.add_trajectory("solvent");
    file.add("/particles/empty/mass", {2});
  }
  EXPECT_EQ(open().group(), "solvent");
  EXPECT_EQ(open("solvent").group(), "solvent");
  EXPECT_THAT(message_of<InputError>([&] { open("protein"); }),
              HasSubstr("no group \"protein\" in /particles; there are: \"empty\", \"solvent\""));
  EXPECT_THAT(message_of<InputError>([&] { open("empty"); }),
              HasSubstr("no positions: /particles/empty/position/value is missing"));
}

// h502
TEST_F(H5mdReaderTest, ReadsTheFramesThatAreWhole) {
  {
    ForeignFile file(path_);
    file.add(value, {5, 2, 3});
    file.add(step, {3}, H5T_STD_I64LE);
    file.add(time_path, {4});
    file.unit(value, "Angstrom");
    file.unit(time_path, "ps");
    file.add("/observables/long/value", {9});
    file.add("/observables/short/value", {2});
  }
  const H5mdReader reader = open();
  EXPECT_EQ(reader.frames(), 3);
  EXPECT_EQ(reader.frames_left_out(), 2);
  EXPECT_THAT(messages_, ElementsAre("note: " + path_.string() +
                                     ": 2 of 5 frames left out: they lack positions, step or "
                                     "time"));
  EXPECT_THAT(reader.observable("long"), ElementsAre(0, 1, 2));
  EXPECT_THAT(reader.observable("short"), ElementsAre(0, 1));
}

// h503
TEST_F(H5mdReaderTest, WarnsOfStepsThatDoNotIncrease) {
  {
    ForeignFile file(path_);
    file.add_trajectory();
    file.write(step, {0, 10, 10, 5});
  }
  EXPECT_EQ(open().frames(), 4);
  EXPECT_THAT(messages_, ElementsAre("warning: " + path_.string() +
                                     ": steps do not increase: frame 2 has step 10 after 10"));
}

// h504
TEST_F(H5mdReaderTest, NamesAWrongShape) {
  for (const auto& [extents, shape] :
       std::vector<std::pair<Extents, std::string>>{{{4, 6}, "(4, 6)"},
                                                    {{4, 2, 2}, "(4, 2, 2)"},
                                                    {{4, 2, 3, 1}, "(4, 2, 3, 1)"},
                                                    {{}, "()"}}) {
    { ForeignFile(path_).add(value, extents); }
    EXPECT_EQ(failure(),
              std::string(value) + " has shape " + shape + "; expected (frames, joints, 3)");
  }
  {
    ForeignFile file(path_);
    file.add(value, {4, 2, 3});
    file.add(step, {4, 1}, H5T_STD_I64LE);
  }
  EXPECT_EQ(failure(), std::string(step) + " has shape (4, 1); expected one value a frame");
  {
    ForeignFile file(path_);
    file.add(std::string(value) + "/inside", {4});
  }
  EXPECT_EQ(failure(), std::string(value) + " is not a dataset");
}

// h505
TEST_F(H5mdReaderTest, ConvertsNumbers) {
  for (const hid_t type : {H5T_IEEE_F32LE, H5T_IEEE_F64BE, H5T_IEEE_F32BE, H5T_STD_I16BE,
                           H5T_STD_U8LE, H5T_STD_I64LE}) {
    {
      ForeignFile file(path_);
      file.add_trajectory();
      H5Ldelete(file.id(), value, H5P_DEFAULT);
      file.add(value, {4, 2, 3}, type);
      file.unit(value, "Angstrom");
    }
    EXPECT_EQ(open().positions(3)[1], (Vec3{21, 22, 23}));
  }
  {
    ForeignFile file(path_);
    const hid_t text = H5Tcopy(H5T_C_S1);
    file.add(value, {4, 2, 3}, text, H5P_DEFAULT, false);
  }
  EXPECT_EQ(failure(), std::string(value) + " has no numbers");
}

// h506
TEST_F(H5mdReaderTest, ConvertsUnits) {
  const std::pair<std::string, double> lengths[] = {{"nm", 10.0}, {"pm", 0.01}, {"A", 1.0}};
  for (const auto& [unit, factor] : lengths) {
    for (const bool variable : {true, false}) {
      {
        ForeignFile file(path_);
        file.add(value, {4, 2, 3});
        file.add(step, {4}, H5T_STD_I64LE);
        file.add(time_path, {4});
        file.unit(value, unit, variable);
        file.unit(time_path, "fs", variable);
      }
      EXPECT_DOUBLE_EQ(open().positions(1)[0].y, 7.0 * factor) << unit;
      EXPECT_DOUBLE_EQ(open().time(2), 0.002);
    }
  }
  {
    ForeignFile file(path_);
    file.add(value, {4, 2, 3});
    file.unit(value, "parsec");
  }
  EXPECT_EQ(failure(), std::string(value) +
                           " has the unit \"parsec\"; known: Angstrom, angstrom, A, nm, pm, fm, "
                           "um, m");
}

TEST_F(H5mdReaderTest, WarnsWhereUnitsAreMissing) {
  {
    ForeignFile file(path_);
    file.add(value, {4, 2, 3});
    file.add(time_path, {4});
  }
  EXPECT_EQ(open().positions(0)[1].x, 3.0);
  EXPECT_THAT(
      messages_,
      ElementsAre("warning: " + path_.string() + ": " + value + " has no unit; Angstrom assumed",
                  "warning: " + path_.string() + ": " + time_path + " has no unit; ps assumed"));
}

// h507
TEST_F(H5mdReaderTest, TakesIncrementsAndMissingTimes) {
  {
    ForeignFile file(path_);
    file.add(value, {4, 2, 3});
    file.unit(value, "nm");
    file.add(step, {}, H5T_STD_I32LE);
    file.write(step, {50});
    file.add(time_path, {});
    file.write(time_path, {0.5});
    file.unit(time_path, "ps");
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t offset = H5Acreate_by_name(file.id(), time_path, "offset", H5T_IEEE_F64LE, space,
                                           H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    const double start = 100.0;
    H5Awrite(offset, H5T_NATIVE_DOUBLE, &start);
    H5Aclose(offset), H5Sclose(space);
  }
  EXPECT_EQ(open().frames(), 4);
  EXPECT_EQ(open().step(3), 150);
  EXPECT_EQ(open().time(3), 101.5);
  {
    ForeignFile file(path_);
    file.add(value, {4, 2, 3});
    file.unit(value, "nm");
  }
  EXPECT_EQ(open().step(3), 3);
  EXPECT_FALSE(open().has_time());
  EXPECT_EQ(failure([](const H5mdReader& r) { r.time(0); }),
            "/particles/trajectory/position has no times");
}

// h508
TEST_F(H5mdReaderTest, StaysWithinTheFile) {
  const auto other = directory_ / "other.h5md";
  { ForeignFile(other).add_trajectory(); }
  {
    ForeignFile file(path_);
    H5Lcreate_external(other.c_str(), "/particles", file.id(), "/particles", H5P_DEFAULT,
                       H5P_DEFAULT);
  }
  EXPECT_EQ(failure(), "\"/particles\" leads to the file \"" + other.string() +
                           "\": links to other files are not followed");
  {
    ForeignFile file(path_);
    file.add_trajectory();
    H5Ldelete(file.id(), value, H5P_DEFAULT);
    H5Lcreate_external(other.c_str(), value, file.id(), "/elsewhere", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/elsewhere", file.id(), value, H5P_DEFAULT, H5P_DEFAULT);
  }
  EXPECT_EQ(failure(), "\"" + std::string(value) + "\" leads to the file \"" + other.string() +
                           "\": links to other files are not followed");
}

TEST_F(H5mdReaderTest, ReadsNoValuesOfOtherFiles) {
  const hid_t external = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(external, "/etc/passwd", 0, H5F_UNLIMITED);
  { ForeignFile(path_).add(value, {4, 2, 3}, H5T_STD_U8LE, external, false); }
  EXPECT_EQ(failure(), std::string(value) + " has its values in other files, which are not read");
  H5Pclose(external);
}

TEST_F(H5mdReaderTest, FollowsLinksWithinTheFileAndEndsCycles) {
  {
    ForeignFile file(path_);
    file.add_trajectory("real");
    H5Lcreate_soft("/particles/real", file.id(), "/particles/trajectory", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_hard(file.id(), "/particles", file.id(), "/particles/real/loop", H5P_DEFAULT,
                   H5P_DEFAULT);
    file.add("/observables/a/value", {4});
    H5Lcreate_hard(file.id(), "/observables", file.id(), "/observables/a/loop", H5P_DEFAULT,
                   H5P_DEFAULT);
  }
  EXPECT_EQ(open().group(), "trajectory");
  EXPECT_EQ(open().positions(1)[0].x, 6.0);
  EXPECT_THAT(open().observables(), ElementsAre("a"));
  {
    ForeignFile file(path_);
    H5Lcreate_soft("/b", file.id(), "/particles", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/particles", file.id(), "/b", H5P_DEFAULT, H5P_DEFAULT);
  }
  EXPECT_EQ(failure(), "cannot open \"/particles\": too many links");
}

// h509
TEST_F(H5mdReaderTest, NamesAMissingFilter) {
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
TEST_F(H5mdReaderTest, TakesNoMemoryForWhatIsOnlyStated) {
  const hsize_t chunk[] = {1, 2, 3};
  const hid_t chunked = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(chunked, 3, chunk);
  {
    ForeignFile file(path_);
    file.add(value, {hsize_t{1} << 62, 2, 3}, H5T_IEEE_F64LE, chunked, false);
    file.unit(value, "nm");
  }
  EXPECT_EQ(open().frames(), std::int64_t{1} << 62);
  const std::string never = std::string(value) +
                            " of shape (4611686018427387904, 2, 3) has 0 bytes in the file: it "
                            "was never written, or is damaged";
  EXPECT_EQ(failure(read_first), never);
  {
    ForeignFile file(path_);
    file.add(value, {4, hsize_t{1} << 31, 3}, H5T_IEEE_F64LE, chunked, false);
    file.unit(value, "nm");
  }
  EXPECT_THAT(failure(read_first), HasSubstr("has 0 bytes in the file"));
  {
    ForeignFile file(path_);
    file.add(value, {4, hsize_t{1} << 33, 3}, H5T_IEEE_F64LE, chunked, false);
  }
  EXPECT_EQ(failure(), std::string(value) + " states shape (4, 8589934592, 3)");
  H5Pclose(chunked);
}

TEST_F(H5mdReaderTest, TakesNoMemoryForStatedStepsAndNames) {
  const hsize_t chunk[] = {64};
  const hid_t chunked = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(chunked, 1, chunk);
  const hsize_t huge = hsize_t{1} << 50;
  {
    ForeignFile file(path_);
    file.add_trajectory();
    file.add("/parameters/topology/atom_name", {huge}, H5T_C_S1, chunked, false);
    file.add("/observables/x/value", {huge}, H5T_IEEE_F64LE, chunked, false);
  }
  EXPECT_THAT(failure([](const H5mdReader& r) { r.atoms(); }), HasSubstr("has 0 bytes"));
  EXPECT_THAT(failure([](const H5mdReader& r) { r.observable("x"); }), HasSubstr("has 0 bytes"));
  H5Pclose(chunked);
}

// h511
TEST_F(H5mdReaderTest, CallsAFrameOfFillValuesDamaged) {
  {
    ForeignFile file(path_);
    file.add_trajectory();
    std::vector<double> values(24, 1.0);
    values[6 + 3] = std::nan("");
    file.write(value, values);
  }
  EXPECT_EQ(open().positions(0)[0].x, 1.0);
  EXPECT_EQ(failure([](const H5mdReader& r) { r.positions(1); }),
            "frame 1 is damaged: the position of joint 1 is not finite");
}

TEST_F(H5mdReaderTest, CallsAFrameThatWasNeverWrittenDamaged) {
  const hsize_t chunk[] = {2, 2, 3}, start[] = {0, 0, 0}, count[] = {1, 2, 3};
  const hid_t chunked = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(chunked, 3, chunk);
  {
    ForeignFile file(path_);
    file.add(value, {4, 2, 3}, H5T_IEEE_F64LE, chunked, false);
    file.unit(value, "A");
    const hid_t set = H5Dopen2(file.id(), value, H5P_DEFAULT), space = H5Dget_space(set);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr);
    const hid_t memory = H5Screate_simple(3, count, nullptr);
    const std::vector<double> values(6, 2.0);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data());
    H5Sclose(memory), H5Sclose(space), H5Dclose(set);
  }
  H5Pclose(chunked);
  EXPECT_EQ(open().positions(0)[1].z, 2.0);
  EXPECT_EQ(failure([](const H5mdReader& r) { r.positions(3); }),
            std::string(value) + ": row 3 was never written, or is damaged");
}

// h512
TEST_F(H5mdReaderTest, SaysWhatToDoWithAFileThatItsWriterLeftOpen) {
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
TEST_F(H5mdReaderTest, SaysThatAnotherProgramHasTheFile) {
  { ForeignFile(path_).add_trajectory(); }
  const int other = ::open(path_.c_str(), O_RDWR);
  ASSERT_EQ(::flock(other, LOCK_EX | LOCK_NB), 0);
  EXPECT_THAT(failure(),
              HasSubstr("is in use by another program (unable to lock file, errno = 11"));
  ::close(other);
}

// h514
TEST_F(H5mdReaderTest, NamesWhatIsNoHdf5File) {
  EXPECT_EQ(failure(), "cannot open: No such file or directory");
  std::ofstream(path_) << "ATOM      1  N   ALA A   1";
  EXPECT_EQ(failure(), "is not an HDF5 file");
  std::ofstream(path_, std::ios::trunc).flush();
  EXPECT_EQ(failure(), "is not an HDF5 file");
  std::filesystem::remove(path_);
  std::filesystem::create_directory(path_);
  EXPECT_EQ(failure(), "is not a regular file");
}

TEST_F(H5mdReaderTest, NamesATruncatedFile) {
  { ForeignFile(path_).add_trajectory(); }
  const auto size = std::filesystem::file_size(path_);
  std::filesystem::resize_file(path_, size - 100);
  EXPECT_THAT(failure(), HasSubstr("cannot be opened: truncated file"));
}

/// Lengths that a copy can break off at: an error, never a crash.
TEST_F(H5mdReaderTest, SurvivesPrefixes) {
  { ForeignFile(path_).add_trajectory(); }
  std::ifstream file(path_, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  for (std::size_t size = 0; size < whole.size(); size += 1 + size / 64) {
    std::ofstream(path_, std::ios::binary | std::ios::trunc).write(whole.data(), long(size));
    EXPECT_THROW(open(), Error) << size;
  }
}

TEST_F(H5mdReaderTest, AcceptsAUserBlock) {
  const hid_t creation = H5Pcreate(H5P_FILE_CREATE);
  H5Pset_userblock(creation, 1024);
  { ForeignFile(path_, creation).add_trajectory(); }
  H5Pclose(creation);
  EXPECT_EQ(open().positions(1)[0].x, 6.0);
}

TEST_F(H5mdReaderTest, RefusesConnectivityThatLeadsNowhere) {
  {
    ForeignFile file(path_);
    file.add_trajectory();
    file.add("/connectivity/bars", {2, 2}, H5T_STD_I32LE);
    file.add("/connectivity/bonds", {2, 3}, H5T_STD_I32LE);
    file.add("/parameters/framework/rest_length", {5});
  }
  EXPECT_EQ(failure([](const H5mdReader& r) { r.bars(); }),
            "/connectivity/bars: value 2 is 2; expected 0 to 1");
  EXPECT_EQ(failure([](const H5mdReader& r) { r.bonds(); }),
            "/connectivity/bonds has shape (2, 3); expected (pairs, 2)");
  {
    ForeignFile file(path_);
    file.add_trajectory();
    file.add("/connectivity/bars", {1, 2}, H5T_STD_I32LE);
    file.add("/parameters/framework/rest_length", {5});
  }
  EXPECT_EQ(failure([](const H5mdReader& r) { r.framework(); }),
            "/parameters/framework/rest_length has 5 values; expected 1");
}

TEST_F(H5mdReaderTest, ListsObservablesAndSkipsWhatIsNone) {
  {
    ForeignFile file(path_);
    file.add_trajectory();
    file.add("/observables/energy/value", {4});
    file.add("/observables/energy/step", {4}, H5T_STD_I64LE);
    file.add("/observables/thermo/pressure/value", {4}, H5T_IEEE_F32BE);
    file.add("/observables/virial/value", {4, 3});
    file.add("/observables/constant", {});
  }
  EXPECT_THAT(open().observables(), ElementsAre("energy", "thermo/pressure"));
  EXPECT_THAT(open().observable("thermo/pressure"), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(failure([](const H5mdReader& r) { r.observable("virial"); }),
            "no observable \"virial\"; there are: \"energy\", \"thermo/pressure\"");
}

}  // namespace
}  // namespace pliant
