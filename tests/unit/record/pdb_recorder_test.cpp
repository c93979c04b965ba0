// SPDX-License-Identifier: MIT
#include "pliant/record/pdb_recorder.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "pliant/base/error.hpp"
#include "unit/record/samples.hpp"

namespace pliant {
namespace pdb_recorder_test {

using namespace test;

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(PdbRecorder, WritesAModelAFrameAndBondsOnce) {
  const TempDirectory directory;
  const auto path = directory / "out.pdb";
  const Framework framework = test::chain(2);
  PdbRecorder recorder(path, framework.atoms(), {{0, 1, 0, 1}});
  recorder.record(std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}});
  EXPECT_FALSE(std::filesystem::exists(path));
  recorder.record(std::vector<Vec3>{{-1, 2, 3}, {4, 5, 9999.999}});
  recorder.close();
  EXPECT_EQ(recorder.models(), 2);
  EXPECT_EQ(text_of(path),
            "MODEL        1\n"
            "ATOM      1  CA  ALA A  -3       1.000   2.000   3.000  1.00  0.00           C\n"
            "ATOM      2 HB11 LYS A  -3B      4.000   5.000   6.000  1.00  0.00           H\n"
            "ENDMDL\n"
            "MODEL        2\n"
            "ATOM      1  CA  ALA A  -3      -1.000   2.000   3.000  1.00  0.00           C\n"
            "ATOM      2 HB11 LYS A  -3B      4.000   5.0009999.999  1.00  0.00           H\n"
            "ENDMDL\n"
            "CONECT    1    2\n"
            "CONECT    2    1\n"
            "END\n");
}

TEST(PdbRecorder, LeavesNothingThatIsNotClosed) {
  const TempDirectory directory;
  { PdbRecorder(directory / "out.pdb", test::chain(1).atoms()).record(std::vector<Vec3>{{}}); }
  PdbRecorder(directory / "empty.pdb", test::chain(1).atoms()).close();
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST(PdbRecorder, RefusesWhatDoesNotFit) {
  const TempDirectory directory;
  const auto path = directory / "out.pdb";
  PdbRecorder recorder(path, test::chain(1).atoms());
  const std::string name = std::filesystem::canonical(directory.path()).string() + "/out.pdb: ";
  EXPECT_EQ(message_of<InputError>([&] { recorder.record(std::vector<Vec3>(2)); }),
            name + "2 positions for 1 atoms");
  EXPECT_EQ(message_of<InputError>([&] {
              recorder.record(std::vector<Vec3>{{-1000, 0, 0}});
            }),
            name +
                "model 1: position of A:LYS-3B:CA (-1000, 0, 0) does not fit the columns of a "
                "PDB file (-999.999 to 9999.999 Angstrom)");
  recorder.close();
  EXPECT_EQ(message_of<FileError>([&] { recorder.record(std::vector<Vec3>(1)); }),
            name + "is closed: no frame can be recorded");
  EXPECT_EQ(message_of<InputError>([&] { PdbRecorder(path, bare(2).atoms()); }),
            "a framework without names of atoms cannot be written as PDB");
}

}  // namespace pdb_recorder_test
}  // namespace pliant
