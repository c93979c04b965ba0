// SPDX-License-Identifier: MIT
// The way from a file to its reader. What the readers make of good and bad files is tested by the
// corpus.
#include "pliant/molecule/read/read.hpp"

#include <zlib.h>

#include <locale>

#include "corpus/corpus.hpp"
#include "pliant/molecule/read/foreign.hpp"
#include "pliant/molecule/read/pdb/hybrid36.hpp"
#include "pliant/record/topology_pdb.hpp"
#include "support/test.hpp"

namespace pliant::read_test {

using namespace std::string_literals;
using test::error_text;

const char* const water = "3\nwater\nO 0 0 0.119\nH 0 0.763 -0.477\nH 0 -0.763 -0.477\n";
const std::string atom =
    "ATOM      1  N   ALA A   1       0.000   0.000   0.000  1.00  0.00           N\n";

std::string format_of(std::string_view name, std::string_view text) {
  return read_structure(SourceText{name, text}).format;
}

TEST(Formats, HaveNamesExtensionsAndReaders) {
  std::set<std::string_view> names, extensions;
  for (const Format& format : formats()) {
    EXPECT_TRUE(names.insert(format.name).second) << format.name;
    for (std::string_view extension : format.extensions) {
      EXPECT_EQ(extension[0], '.');
      EXPECT_TRUE(extensions.insert(extension).second) << extension;
    }
    EXPECT_NE(format.summary, "");
  }
  EXPECT_EQ(names, (std::set<std::string_view>{"pdb", "mmcif", "sdf", "xyz"}));
}

/// The first file of each corpus folder, a plain molecule, under every name.
TEST(Formats, ByExtensionInAnyCaseAndByContentWithoutOne) {
  const std::pair<const char*, const char*> plain[] = {{"pdb", "pdb01_plain.pdb"},
                                                       {"xyz", "xyz01_plain.xyz"},
                                                       {"sdf", "sdf01_plain.sdf"},
                                                       {"mmcif", "cif01_plain.cif"}};
  for (const auto& [name, file] : plain) {
    const std::string text = test::content_of(corpus_folder(name) / file);
    for (const Format& format : formats()) {
      EXPECT_EQ(format.looks_like(text), format.name == name) << format.name << " " << name;
      if (format.name != name) continue;
      for (std::string_view extension : format.extensions)
        EXPECT_EQ(format_of("some.file" + std::string(extension), text), name);
    }
    for (const char* other : {"file", "file.txt", "file.gz", "file.", ".hidden"})
      EXPECT_EQ(format_of(other, text), name) << other;
  }
  EXPECT_EQ(format_of("WATER.XYZ", water), "xyz");
  EXPECT_EQ(format_of("water.xyz.gz", water), "xyz");
}

TEST(Formats, ByName) {
  ReadOptions options{.format = "xyz"};
  EXPECT_EQ(read_structure(SourceText{"water.pdb", water}, options).format, "xyz");
  options.format = "mmcf";
  EXPECT_ERROR(OptionError,
               "no format named \"mmcf\" (did you mean \"mmcif\"?); known: pdb, mmcif, sdf, xyz",
               read_structure(SourceText{"x", water}, options));
}

TEST(Formats, ContentThatContradictsTheExtensionIsHintedAt) {
  EXPECT_ERROR(
      InputError,
      "x.pdb: no ATOM or HETATM record in 5 lines (read as pdb; the content looks like xyz)",
      read_structure(SourceText{"x.pdb", water}));
  EXPECT_ERROR(
      InputError,
      "x.xyz:1: \"ATOM      1  N   ALA A   1       0.000  ...\" is not an atom count (read as "
      "xyz; the content looks like pdb)",
      read_structure(SourceText{"x.xyz", atom}));
}

TEST(ReadStructure, ModelsAreCountedFromOne) {
  ReadOptions options{.model = 0};
  EXPECT_ERROR(OptionError, "model is 0: models are counted from 1",
               read_structure(SourceText{"x.xyz", water}, options));
  options.model = 2;
  EXPECT_ERROR(OptionError, "no frame 2 in x.xyz: it has 1",
               read_structure(SourceText{"x.xyz", water}, options));
  options.model = 7;
  EXPECT_ERROR(OptionError, "no model 7 in x.pdb: it has 1",
               read_structure(SourceText{"x.pdb", atom}, options));
}

TEST(ReadStructure, FromAFileAndFromAGzippedOne) {
  const test::TempDirectory directory;
  const std::string path = (directory / "water").string();
  std::ofstream(path + ".xyz") << "\xef\xbb\xbf" << water;
  const gzFile packed = gzopen((path + ".xyz.gz").c_str(), "wb");
  gzputs(packed, water);
  gzclose(packed);
  for (const char* ending : {".xyz", ".xyz.gz"}) {
    const Structure structure = read_structure(std::filesystem::path(path + ending));
    EXPECT_EQ(structure.size(), 3u);
    EXPECT_EQ(structure.source, path + ending);
    EXPECT_EQ(structure.format, "xyz");
    EXPECT_EQ(structure.title, "water");
  }
}

/// Row pdb53: a line of a million characters, as a remark and at the end of an atom.
TEST(ReadStructure, ALineOfAMillionCharacters) {
  const std::string line(1'000'000, 'x');
  EXPECT_EQ(read_structure(SourceText{"x.pdb", "REMARK " + line + "\n" + atom}).size(), 1u);
  std::string long_atom = atom;
  long_atom.insert(long_atom.size() - 1, line);
  EXPECT_EQ(read_structure(SourceText{"x.pdb", long_atom + atom}).size(), 1u);
  const std::string message = error_text<InputError>([&] {
    read_structure(SourceText{"x.xyz", line});
  });
  EXPECT_LT(message.size(), 100u) << message;
  EXPECT_EQ(read_structure(SourceText{"x.xyz", "1\n" + line + "\nC 0 0 0\n"}).title, line);
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(ReadStructure, DoesNotFollowTheLocale) {
  const std::locale before =
      std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  const Structure structure = read_structure(SourceText{"x.xyz", water});
  const std::string message = error_text<InputError>([] {
    read_structure(SourceText{"x.xyz", "12345\n\nC 0 0 0\n"});
  });
  std::locale::global(before);
  EXPECT_EQ(structure.positions[0], (Vec3{0, 0, 0.119}));
  EXPECT_EQ(message, "x.xyz:4: 12345 atoms wanted, 1 found");
}

/// What is reported once with a count must not cost a message an atom.
TEST(ReadStructure, EachKindOfWarningOnce) {
  std::string text;
  for (int k = 0; k < 50'000; ++k)
    text += atom.substr(0, 30) + "   1.000   2.000" + "   " + std::to_string(10000 + k) + "\n";
  std::vector<std::string> messages;
  const ReadOptions options{
      .log = {[&](Severity, std::string_view message) { messages.emplace_back(message); }}};
  EXPECT_EQ(read_structure(SourceText{"x.pdb", text}, options).size(), 50'000u);
  EXPECT_EQ(messages, (std::vector<std::string>{
                          "x.pdb:1: no element in columns 77-78: taken from the atom name, "
                          "\" N  \" as N (and 49999 more)",
                          "x.pdb:2: atom A:ALA1:N is given twice, at different points: both kept "
                          "(and 49998 more)"}));
}

TEST(Foreign, IsToldByItsFirstBytes) {
  EXPECT_EQ(foreign_content("\x1f\x8b\x08"), "compressed twice (gzip)");
  EXPECT_EQ(foreign_content("%PDF-1.4"), "a PDF document");
  EXPECT_EQ(foreign_content("T\0\0\0CORD"s), "a trajectory (DCD): expected a structure");
  EXPECT_EQ(foreign_content("  \n<HTML>"), "a web page (HTML), perhaps from a failed download");
  EXPECT_EQ(foreign_content(std::string(257, 'x') + "ustar"),
            "a tar archive: expected one file of it");
}

TEST(Foreign, MoleculesAreNot) {
  for (const std::string& text :
       {""s, "ATOM"s, "2\n\nO 0 0 0\n"s, "<graph/>"s, "data_x\n"s, std::string(300, ' '), "CDF"s})
    EXPECT_EQ(foreign_content(text), "") << text;
}

TEST(Foreign, NamesAreToldByTheirExtension) {
  const auto refusal = [](const char* name) {
    return test::error_text<InputError>([&] { read_structure(SourceText{name, "hello\n"}); });
  };
  const std::string known =
      "known: pdb .pdb .ent .pdbqt; mmcif .cif .mmcif .mcif; sdf .sdf .sd .mol .mdl; xyz .xyz "
      ".extxyz";
  EXPECT_EQ(refusal("a.GRO.gz"),
            "a.GRO.gz: is a file of GROMACS by its extension .gro, which is not read "
            "(pliant.from_mdanalysis in Python may); " +
                known);
  EXPECT_EQ(refusal("letter.txt"),
            "letter.txt: neither extension nor content matches a known format; " + known);
}

/// tests/unit/record/topology_pdb_test.cpp has the borders that cci.lbl.gov/hybrid_36 states.
TEST(Hybrid36, IsReadBack) {
  for (std::int64_t number : {0, -9999, 99999, 100000, 100035, 43770015, 43770016, 87440031})
    EXPECT_EQ(parse_hybrid36(hybrid36(number, 5)), number);
  for (std::int64_t number : {9999, 10000, 1223055, 1223056, 2436111})
    EXPECT_EQ(parse_hybrid36(hybrid36(number, 4)), number);
  EXPECT_EQ(parse_hybrid36("12   "), 12);
  for (const char* field : {"", "     ", "*****", "A 000", " A000", "Aa000", "A00a0", "1A000",
                            "12 34", "A-000", "AAAAAAAAA"})
    EXPECT_EQ(parse_hybrid36(field), std::nullopt) << field;
}

TEST(Hexadecimal, OfVmd) {
  EXPECT_EQ(parse_vmd_hexadecimal("186a0"), 100000);
  EXPECT_EQ(parse_vmd_hexadecimal("186A0"), 100000);
  EXPECT_EQ(parse_vmd_hexadecimal(" 270f"), 9999);
  for (const char* field : {"18700", "a0000", "", "1g000", "1a2-3", "-1a", "*****"})
    EXPECT_EQ(parse_vmd_hexadecimal(field), std::nullopt) << field;
  EXPECT_EQ(parse_hexadecimal("18700"), 100096);
  EXPECT_EQ(parse_hexadecimal("a0000"), 655360);
  EXPECT_EQ(parse_hexadecimal("-1"), std::nullopt);
  EXPECT_EQ(parse_hexadecimal(""), std::nullopt);
}

}  // namespace pliant::read_test
