// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/h5md_reader.hpp"

#include <cerrno>

#include "support/test.hpp"
#include "unit/record/foreign_file.hpp"
#include "unit/record/write_calls.hpp"

namespace pliant::h5md_reader_test {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;

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

TEST_F(H5mdReaderTest, ReadsWithoutLocksWhereThereAreNone) {
  { ForeignFile(path_).add_trajectory(); }
  for (const int why : {ENOLCK, EOPNOTSUPP}) {
    const NoLocks nowhere(why);
    EXPECT_EQ(open().frames(), 4);
  }
  const NoLocks held(EWOULDBLOCK);  // by another program: that is no lack
  EXPECT_THAT(error_text<FileError>([&] { open(); }), HasSubstr("is in use by another program"));
}

// h501
TEST_F(H5mdReaderTest, NamesTheGroupsThereAre) {
  { ForeignFile(path_).add("/somewhere/else", {2}); }
  EXPECT_EQ(failure(),
            "no group with positions in /particles; groups of the file: \"somewhere\"; of "
            "/particles: none");
  foreign([&](ForeignFile& file) {
    file.add_trajectory("solvent");
    file.add("/particles/empty/mass", {2});
  });
  EXPECT_EQ(open().group(), "solvent");
  EXPECT_EQ(open("solvent").group(), "solvent");
  EXPECT_THAT(error_text<InputError>([&] { open("protein"); }),
              HasSubstr("no group \"protein\" in /particles; there are: \"empty\", \"solvent\""));
  EXPECT_THAT(error_text<InputError>([&] { open("empty"); }),
              HasSubstr("no positions: /particles/empty/position/value is missing"));
}

// h502
TEST_F(H5mdReaderTest, ReadsTheFramesThatAreWhole) {
  foreign([&](ForeignFile& file) {
    file.add(value, {5, 2, 3});
    file.add(step, {3}, H5T_STD_I64LE);
    file.add(time_path, {4});
    file.unit(value, "Angstrom");
    file.unit(time_path, "ps");
    file.add("/observables/long/value", {9});
    file.add("/observables/short/value", {2});
  });
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
  trajectory_with([&](ForeignFile& file) { file.write(step, {0, 10, 10, 5}); });
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
  foreign([&](ForeignFile& file) {
    file.add(value, {4, 2, 3});
    file.add(step, {4, 1}, H5T_STD_I64LE);
  });
  EXPECT_EQ(failure(), std::string(step) + " has shape (4, 1); expected one value a frame");
  foreign([&](ForeignFile& file) { file.add(std::string(value) + "/inside", {4}); });
  EXPECT_EQ(failure(), std::string(value) + " is not a dataset");
}

// h505
TEST_F(H5mdReaderTest, ConvertsNumbers) {
  for (const hid_t type : {H5T_IEEE_F32LE, H5T_IEEE_F64BE, H5T_IEEE_F32BE, H5T_STD_I16BE,
                           H5T_STD_U8LE, H5T_STD_I64LE}) {
    trajectory_with([&](ForeignFile& file) {
      H5Ldelete(file.id(), value, H5P_DEFAULT);
      file.add(value, {4, 2, 3}, type);
      file.unit(value, "Angstrom");
    });
    EXPECT_EQ(open().positions(3)[1], (Vec3{21, 22, 23}));
  }
  foreign([&](ForeignFile& file) {
    const hid_t text = H5Tcopy(H5T_C_S1);
    file.add(value, {4, 2, 3}, text, H5P_DEFAULT, false);
  });
  EXPECT_EQ(failure(), std::string(value) + " has no numbers");
}

// h506
TEST_F(H5mdReaderTest, ConvertsUnits) {
  const std::pair<std::string, double> lengths[] = {{"nm", 10.0}, {"pm", 0.01}, {"A", 1.0}};
  for (const auto& [unit, factor] : lengths) {
    for (const bool variable : {true, false}) {
      foreign([&](ForeignFile& file) {
        file.add(value, {4, 2, 3});
        file.add(step, {4}, H5T_STD_I64LE);
        file.add(time_path, {4});
        file.unit(value, unit, variable);
        file.unit(time_path, "fs", variable);
      });
      EXPECT_DOUBLE_EQ(open().positions(1)[0].y, 7.0 * factor) << unit;
      EXPECT_DOUBLE_EQ(open().time(2), 0.002);
    }
  }
  foreign([&](ForeignFile& file) {
    file.add(value, {4, 2, 3});
    file.unit(value, "parsec");
  });
  EXPECT_EQ(failure(), std::string(value) +
                           " has the unit \"parsec\"; known: Angstrom, angstrom, A, nm, pm, fm, "
                           "um, m");
}

TEST_F(H5mdReaderTest, WarnsWhereUnitsAreMissing) {
  foreign([&](ForeignFile& file) {
    file.add(value, {4, 2, 3});
    file.add(time_path, {4});
  });
  EXPECT_EQ(open().positions(0)[1].x, 3.0);
  EXPECT_THAT(
      messages_,
      ElementsAre("warning: " + path_.string() + ": " + value + " has no unit; Angstrom assumed",
                  "warning: " + path_.string() + ": " + time_path + " has no unit; ps assumed"));
}

// h507
TEST_F(H5mdReaderTest, TakesIncrementsAndMissingTimes) {
  foreign([&](ForeignFile& file) {
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
    H5Aclose(offset);
    H5Sclose(space);
  });
  EXPECT_EQ(open().frames(), 4);
  EXPECT_EQ(open().step(3), 150);
  EXPECT_EQ(open().time(3), 101.5);
  foreign([&](ForeignFile& file) {
    file.add(value, {4, 2, 3});
    file.unit(value, "nm");
  });
  EXPECT_EQ(open().step(3), 3);
  EXPECT_FALSE(open().has_time());
  EXPECT_EQ(failure([](const H5mdReader& r) { r.time(0); }),
            "/particles/trajectory/position has no times");
}

TEST_F(H5mdReaderTest, AcceptsAUserBlock) {
  const hid_t creation = H5Pcreate(H5P_FILE_CREATE);
  H5Pset_userblock(creation, 1024);
  { ForeignFile(path_, creation).add_trajectory(); }
  H5Pclose(creation);
  EXPECT_EQ(open().positions(1)[0].x, 6.0);
}

TEST_F(H5mdReaderTest, ListsObservablesAndSkipsWhatIsNone) {
  trajectory_with([&](ForeignFile& file) {
    file.add("/observables/energy/value", {4});
    file.add("/observables/energy/step", {4}, H5T_STD_I64LE);
    file.add("/observables/thermo/pressure/value", {4}, H5T_IEEE_F32BE);
    file.add("/observables/virial/value", {4, 3});
    file.add("/observables/constant", {});
  });
  EXPECT_THAT(open().observables(), ElementsAre("energy", "thermo/pressure"));
  EXPECT_THAT(open().observable("thermo/pressure"), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(failure([](const H5mdReader& r) { r.observable("virial"); }),
            "no observable \"virial\"; there are: \"energy\", \"thermo/pressure\"");
}

}  // namespace pliant::h5md_reader_test
