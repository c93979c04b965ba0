// SPDX-License-Identifier: MIT
#include "pliant/perturb/force_files/force_file.hpp"

#include "pliant/perturb/force_files/force_events.hpp"
#include "support/test.hpp"

namespace pliant::force_file_test {

Framework framework_with_names(std::vector<std::string> names) {
  AtomTable atoms;
  atoms.residues = {{"UNK", 1, ' ', ""}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    atoms.elements.push_back(6);
    atoms.residue_of.push_back(0);
    atoms.serials.push_back(std::int64_t(i) + 1);
  }
  FrameworkParts parts{.joint_count = names.size()};
  atoms.names = std::move(names);
  parts.atoms = std::make_shared<AtomTable>(std::move(atoms));
  return Framework(std::move(parts));
}

const Framework& butane() {
  static const Framework framework = framework_with_names({"C1", "C2", "C3", "C4", "H", "H"});
  return framework;
}

ForceFile parse(std::string_view text, const Framework& framework = butane()) {
  return parse_force_file(text, "f.txt", framework);
}

/// tests/corpus/forces holds what is read and the other refusals.
TEST(ForceFile, RefusalsNameTheLine) {
  const std::pair<const char*, const char*> cases[] = {
      {"push 6 1 2 3", "joint: no joint is named \"6\""},
      {"push -1 1 2 3", "joint: no joint is named \"-1\""},
      {"push H 1 2 3", "joint: \"H\" is the name of 2 joints, use an index from 0"},
      {"push C1 1 2 0x3", "force z: expected a finite number up to 1e100, found \"0x3\""},
      {"push C1 1 2 3 4", "push: expected a joint and a force (x, y, z), found 5 fields"},
      {"set tolerance_length nan", "tolerance_length: expected a number above 0, found \"nan\""},
      {"set max_sweeps 1.5", "max_sweeps: expected a whole number from 1, found \"1.5\""},
      {"set timestep", "set: expected a name and a value, found 1 fields"},
  };
  for (const auto& [line, fault] : cases)
    EXPECT_ERROR(InputError, "f.txt:4: " + std::string(fault),
                 parse("pliant-forces 3\n\n# comment\n" + std::string(line)));
  for (const std::string setting : {"tolerance", "tolerance_length", "max_sweeps", "seed"}) {
    const std::string line = "set " + setting + " 1\n";
    EXPECT_ERROR(InputError, "f.txt:3: " + setting + ": is given twice",
                 parse("pliant-forces 3\n" + line + line));
  }
}

/// A file with counts is one of events.
TEST(ForceFile, WithCountsIsWrittenAsEvents) {
  ForceFile file;
  file.timestep = 0.01;
  file.settings = {{"technique", "blocks"}};
  file.pushes = {{0, {1, 2, 3}}, {1, {4, 5, 6}}, {5, {0, 0, -1}}};
  file.counts = {2, 0, 0, 1};
  const std::string text = write_force_file(file, butane());
  EXPECT_EQ(text,
            "pliant-forces 3\nset timestep 0.01\nset technique blocks\nforce C1 1 2 3\n"
            "force C2 4 5 6\nstep\nstep 2\nforce 5 0 0 -1\nstep\n");
  const std::vector<ForceEvent> events = parse_force_events(text, "f.txt", butane());
  EXPECT_EQ(write_force_events(events, butane()), text);
  EXPECT_EQ(steps_of(events), 4);
}

TEST(ForceHeader, IsReadBackAsWritten) {
  ForceHeader header = force_header_of(butane());
  header.structure = 0x5f0c1d3a9b7e2468u;
  header.input = {{"model", "protein"}, {"pin", "resname A#1 and 5%"}};
  const std::string text = write_force_header(header);
  const ForceHeader back = read_force_header(text + "set timestep 0.5\n", "f.txt");
  EXPECT_EQ(back.structure, header.structure);
  EXPECT_EQ(back.input[1].value, "resname A#1 and 5%");
  EXPECT_EQ(back.input[1].line, 6u);
  EXPECT_EQ(write_force_header(back), text);
  EXPECT_EQ(misfit(back, butane()), "");
}

TEST(ForceHeader, SaysWhatIsWrongWithItsLine) {
  const std::pair<const char*, const char*> cases[] = {
      {"structure 12", "2: structure: expected 16 hexadecimal digits, found \"12\""},
      {"joints -1", "2: joints: expected a whole number from 0, found \"-1\""},
      {"joints 1\njoints 1", "3: joints: is given twice"},
      {"input model", "2: input: expected a name and a value, found \"input model\""}};
  for (const auto& [line, fault] : cases)
    EXPECT_ERROR(InputError, "f.txt:" + std::string(fault),
                 read_force_header("pliant-forces 3\n" + std::string(line), "f.txt"));
}

TEST(ForceFile, MadeForAnotherFrameworkIsRefused) {
  const test::TempDirectory directory;
  const std::filesystem::path path = directory / "f.txt";
  std::ofstream(path) << "pliant-forces 3\njoints 746\npush 0 0 0 1\n";
  EXPECT_ERROR(InputError,
               path.string() + ": was made for another framework: of 746 joints, not " +
                   std::to_string(butane().joint_count()),
               read_force_file(path, butane()));
}

TEST(ForceFile, IsReadBackToTheSameBits) {
  ForceFile file;
  file.timestep = 0.1;
  file.tolerance = 1.0 / 3.0;
  file.max_sweeps = 7;
  file.pushes = {{3, {1e-300, -0.0, 12345.678901234567}}, {5, {1e100, 2, 3}}};
  const std::string text = write_force_file(file, butane());
  EXPECT_EQ(
      text,
      "pliant-forces 3\nset timestep 0.1\nset tolerance 0.3333333333333333\nset max_sweeps 7\n"
      "push C4 1e-300 -0 12345.678901234567\npush 5 1e+100 2 3\n");
  const ForceFile back = parse(text);
  EXPECT_EQ(write_force_file(back, butane()), text);
  EXPECT_EQ(back.pushes[0].force, file.pushes[0].force);
}

/// Names that the format cannot hold (blanks, comment signs, nothing) are written as indices.
TEST(ForceFile, WritesIndicesForNamesThatAreNoWord) {
  const Framework odd = framework_with_names({"C 1", "#", "", "\xc3\xa9"});
  ForceFile file;
  for (Joint joint = 0; joint < 4; ++joint) file.pushes.push_back({joint, {1, 2, 3}});
  const std::string text = write_force_file(file, odd);
  EXPECT_EQ(text,
            "pliant-forces 3\npush 0 1 2 3\npush 1 1 2 3\npush 2 1 2 3\npush \xc3\xa9 1 2 3\n");
  const ForceFile back = parse(text, odd);
  for (Joint joint = 0; joint < 4; ++joint) EXPECT_EQ(back.pushes[joint].joint, joint);
}

/// Joint 0 shares its name, and "0" is the name of joint 2: nothing means joint 0.
TEST(ForceFile, RefusesToWriteWhatWouldMeanAnotherJoint) {
  const Framework odd = framework_with_names({"H", "H", "0"});
  ForceFile file;
  file.pushes = {{0, {}}};
  EXPECT_ERROR(InputError,
               "force file: H(1) has no name of its own, and its index 0 is the name of another "
               "joint",
               write_force_file(file, odd));
}

TEST(ForceFile, HoldsTheToleranceThatCounts) {
  ForceFile file;
  file.set({.timestep = 0.5}, {.relative = 1e-3, .length = 0.25}, 7);
  EXPECT_EQ(write_force_file(file, butane()),
            "pliant-forces 3\nset timestep 0.5\nset tolerance_length 0.25\nset max_sweeps 7\n");
  file.set({.timestep = 0.5}, {.relative = 1e-3}, 7);
  EXPECT_EQ(write_force_file(file, butane()),
            "pliant-forces 3\nset timestep 0.5\nset tolerance 0.001\nset max_sweeps 7\n");
}

TEST(ReadForceFile, ReadsFilesAndNamesThemInErrors) {
  const test::TempDirectory directory;
  const std::filesystem::path folder = directory.path(), path = directory / "forces.txt";
  std::ofstream(path) << "pliant-forces 3\npush 4 1e2 0 -0.5\npush C1 12.5 -3 0.25";
  EXPECT_EQ(read_force_file(path, butane()).pushes[1].force, (Vec3{12.5, -3, 0.25}));
  std::ofstream(path) << "nothing";
  EXPECT_ERROR(InputError, path.string() + ":1: expected \"pliant-forces 3\", found \"nothing\"",
               read_force_file(path, butane()));
  std::filesystem::remove(path);
  EXPECT_ERROR(FileError, "cannot read " + path.string() + ": No such file or directory",
               read_force_file(path, butane()));
  EXPECT_ERROR(FileError, "cannot read " + folder.string() + ": Is a directory",
               read_force_file(folder, butane()));
}

}  // namespace pliant::force_file_test
