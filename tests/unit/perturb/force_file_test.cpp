// SPDX-License-Identifier: MIT
#include "pliant/perturb/force_files/force_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "pliant/perturb/force_files/force_events.hpp"
#include "support/error_text.hpp"
#include "support/temp_directory.hpp"

namespace pliant::force_file_test {

Framework framework_with_names(std::vector<std::string> names) {
  AtomTable atoms;
  atoms.residues = {{"UNK", 1, ' ', ""}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    atoms.elements.push_back(6);
    atoms.residue_of.push_back(0);
    atoms.serials.push_back(std::int64_t(i) + 1);
  }
  FrameworkParts parts;
  parts.joint_count = names.size();
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

std::string refusal(std::string_view text, const Framework& framework = butane()) {
  return test::error_text<InputError>([&] { parse(text, framework); });
}

constexpr std::string_view plain =
    "pliant-forces 3\n"
    "set timestep 0.01            # ps\n"
    "set tolerance_length 0.001\n"
    "set max_sweeps 1000\n"
    "push C1 12.5 -3 0.25\n"
    "\n"
    "# nothing here\n"
    "push 4 1e2 0 -0.5";

TEST(ForceFile, ReadsSettingsAndPushes) {
  const ForceFile file = parse(plain);
  EXPECT_EQ(file.timestep, 0.01);
  EXPECT_EQ(file.tolerance, std::nullopt);
  EXPECT_EQ(file.tolerance_length, 0.001);
  EXPECT_EQ(file.max_sweeps, 1000);
  ASSERT_EQ(file.pushes.size(), 2u);
  EXPECT_EQ(file.pushes[0].joint, 0u);
  EXPECT_EQ(file.pushes[0].force, (Vec3{12.5, -3, 0.25}));
  EXPECT_EQ(file.pushes[1].joint, 4u);
  EXPECT_EQ(file.pushes[1].force, (Vec3{100, 0, -0.5}));
}

TEST(ForceFile, NamesUnknownJointsAndTheirLine) {
  EXPECT_EQ(refusal("pliant-forces 3\nset timestep 1\n\npush C9 1 2 3"),
            "f.txt:4: joint: no joint is named \"C9\"");
  EXPECT_EQ(refusal("pliant-forces 3\npush 6 1 2 3"), "f.txt:2: joint: no joint is named \"6\"");
  EXPECT_EQ(refusal("pliant-forces 3\npush -1 1 2 3"), "f.txt:2: joint: no joint is named \"-1\"");
  EXPECT_EQ(refusal("pliant-forces 3\npush H 1 2 3"),
            "f.txt:2: joint: \"H\" is the name of 2 joints, use an index from 0");
}

TEST(ForceFile, RefusesForcesThatAreNone) {
  const std::string line = "pliant-forces 3\n\n\npush C1 ";
  EXPECT_EQ(refusal(line + "1 nan 3"),
            "f.txt:4: force y: expected a finite number up to 1e100, found \"nan\"");
  EXPECT_EQ(refusal(line + "inf 2 3"),
            "f.txt:4: force x: expected a finite number up to 1e100, found \"inf\"");
  EXPECT_EQ(refusal(line + "1 2 1e200"),
            "f.txt:4: force z: expected a finite number up to 1e100, found \"1e200\"");
  EXPECT_EQ(refusal(line + "1 2 0x3"),
            "f.txt:4: force z: expected a finite number up to 1e100, found \"0x3\"");
  EXPECT_EQ(refusal(line + "1,5 2 3"),
            "f.txt:4: force x: expected a finite number up to 1e100, found \"1,5\"");
}

TEST(ForceFile, RefusesForcesOfAnotherDimension) {
  EXPECT_EQ(refusal("pliant-forces 3\n\n\npush C1 1 2"),
            "f.txt:4: push: expected a joint and a force (x, y, z), found 3 fields");
  EXPECT_EQ(refusal("pliant-forces 3\npush C1 1 2 3 4"),
            "f.txt:2: push: expected a joint and a force (x, y, z), found 5 fields");
}

TEST(ForceFile, RefusesSettingsOutOfRange) {
  EXPECT_EQ(refusal("pliant-forces 3\nset timestep -0.01"),
            "f.txt:2: timestep: expected a number above 0, found \"-0.01\"");
  EXPECT_EQ(refusal("pliant-forces 3\nset tolerance 0"),
            "f.txt:2: tolerance: expected a number above 0, found \"0\"");
  EXPECT_EQ(refusal("pliant-forces 3\nset tolerance_length nan"),
            "f.txt:2: tolerance_length: expected a number above 0, found \"nan\"");
  EXPECT_EQ(refusal("pliant-forces 3\nset max_sweeps 0"),
            "f.txt:2: max_sweeps: expected a whole number from 1, found \"0\"");
  EXPECT_EQ(refusal("pliant-forces 3\nset max_sweeps 1.5"),
            "f.txt:2: max_sweeps: expected a whole number from 1, found \"1.5\"");
  EXPECT_EQ(refusal("pliant-forces 3\nset timestep"),
            "f.txt:2: set: expected a name and a value, found 1 fields");
}

TEST(ForceFile, RefusesASettingGivenTwice) {
  for (const char* setting :
       {"timestep 1", "tolerance 1", "tolerance_length 1", "max_sweeps 1", "seed 1"}) {
    const std::string line = setting;
    EXPECT_EQ(refusal("pliant-forces 3\nset " + line + "\nset " + line),
              "f.txt:3: " + line.substr(0, line.size() - 2) + ": is given twice");
  }
}

TEST(ForceFile, LeavesOutWhatItDoesNotSay) {
  const ForceFile file = parse("pliant-forces 3\npush C2 0 0 1\n");
  EXPECT_EQ(file.timestep, std::nullopt);
  EXPECT_EQ(file.tolerance, std::nullopt);
  EXPECT_EQ(file.tolerance_length, std::nullopt);
  EXPECT_EQ(file.max_sweeps, std::nullopt);
  EXPECT_EQ(parse("pliant-forces 3").pushes.size(), 0u);
}

TEST(ForceFile, TakesLinesEndedByCarriageReturnAndNewline) {
  std::string text;
  for (char c : plain) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const ForceFile unix = parse(plain), windows = parse(text);
  EXPECT_EQ(write_force_file(unix, butane()), write_force_file(windows, butane()));
}

TEST(ForceFile, SaysWhatItExpected) {
  EXPECT_EQ(refusal(""), "f.txt: expected \"pliant-forces 3\" first, found no text");
  EXPECT_EQ(refusal("\n\npliant-forces 2\n"),
            "f.txt:3: expected \"pliant-forces 3\", found \"pliant-forces 2\"");
  EXPECT_EQ(refusal("HEADER \x1b[2J"),
            "f.txt:1: expected \"pliant-forces 3\", found \"HEADER \\x1b[2J\"");
  EXPECT_EQ(refusal("pliant-forces 3\npull C1 1 2 3"),
            "f.txt:2: expected structure, joints, bars, input, set or push, found \"pull\"");
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
  const auto error = [](const std::string& line) {
    return test::error_text<InputError>(
        [&] { read_force_header("pliant-forces 3\n" + line, "f.txt"); });
  };
  EXPECT_EQ(error("structure 12"),
            "f.txt:2: structure: expected 16 hexadecimal digits, found \"12\"");
  EXPECT_EQ(error("joints -1"), "f.txt:2: joints: expected a whole number from 0, found \"-1\"");
  EXPECT_EQ(error("joints 1\njoints 1"), "f.txt:3: joints: is given twice");
  EXPECT_EQ(error("input model"),
            "f.txt:2: input: expected a name and a value, found \"input model\"");
}

TEST(ForceFile, MadeForAnotherFrameworkIsRefused) {
  const test::TempDirectory directory;
  const std::filesystem::path path = directory / "f.txt";
  std::ofstream(path) << "pliant-forces 3\njoints 746\npush 0 0 0 1\n";
  EXPECT_EQ(test::error_text<InputError>([&] { read_force_file(path, butane()); }),
            path.string() + ": was made for another framework: of 746 joints, not " +
                std::to_string(butane().joint_count()));
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
  EXPECT_EQ(back.timestep, file.timestep);
  EXPECT_EQ(back.tolerance, file.tolerance);
  EXPECT_EQ(back.max_sweeps, file.max_sweeps);
  ASSERT_EQ(back.pushes.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(back.pushes[k].joint, file.pushes[k].joint);
    EXPECT_EQ(back.pushes[k].force, file.pushes[k].force);
  }
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
  EXPECT_EQ(test::error_text<InputError>([&] { write_force_file(file, odd); }),
            "force file: H(1) has no name of its own, and its index 0 is the name of another "
            "joint");
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
  std::ofstream(path) << plain;
  EXPECT_EQ(read_force_file(path, butane()).pushes.size(), 2u);
  std::ofstream(path) << "nothing";
  EXPECT_EQ(test::error_text<InputError>([&] { read_force_file(path, butane()); }),
            path.string() + ":1: expected \"pliant-forces 3\", found \"nothing\"");
  std::filesystem::remove(path);
  EXPECT_EQ(test::error_text<FileError>([&] { read_force_file(path, butane()); }),
            "cannot read " + path.string() + ": No such file or directory");
  EXPECT_EQ(test::error_text<FileError>([&] { read_force_file(folder, butane()); }),
            "cannot read " + folder.string() + ": Is a directory");
}

}  // namespace pliant::force_file_test
