// SPDX-License-Identifier: MIT
// The way from a file to its reader. What the readers make of good and bad files is tested by the
// corpus.
#include "pliant/molecule/read/read.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <locale>
#include <set>
#include <string>

#include "corpus/corpus.hpp"
#include "pliant/base/error.hpp"
#include "pliant/molecule/read/foreign.hpp"
#include "pliant/molecule/read/pdb/hybrid36.hpp"
#include "support/error_text.hpp"
#include "support/temp_directory.hpp"

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
    const std::string text = file_bytes(corpus_folder(name) / file);
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
  ReadOptions options;
  options.format = "xyz";
  EXPECT_EQ(read_structure(SourceText{"water.pdb", water}, options).format, "xyz");
  options.format = "mmcf";
  EXPECT_EQ(error_text<OptionError>([&] {
              read_structure(SourceText{"x", water}, options);
            }),
            "no format named \"mmcf\" (did you mean \"mmcif\"?); known: pdb, mmcif, sdf, xyz");
}

TEST(Formats, UnknownExtensionAndContent) {
  EXPECT_EQ(error_text<InputError>([] {
              read_structure(SourceText{"x.doc", "some words\n"});
            }),
            "x.doc: neither extension nor content matches a known format; known: pdb .pdb .ent "
            ".pdbqt; mmcif "
            ".cif .mmcif .mcif; sdf .sdf .sd .mol .mdl; xyz .xyz .extxyz");
}

TEST(Formats, ContentThatContradictsTheExtensionIsHintedAt) {
  EXPECT_EQ(error_text<InputError>([] {
              read_structure(SourceText{"x.pdb", water});
            }),
            "x.pdb: no ATOM or HETATM record in 5 lines (read as pdb; the content looks like xyz)");
  EXPECT_EQ(
      error_text<InputError>([] {
        read_structure(SourceText{"x.xyz", atom});
      }),
      "x.xyz:1: \"ATOM      1  N   ALA A   1       0.000  ...\" is not an atom count (read as "
      "xyz; the content looks like pdb)");
}

TEST(ReadStructure, ModelsAreCountedFromOne) {
  ReadOptions options;
  options.model = 0;
  EXPECT_EQ(error_text<OptionError>([&] {
              read_structure(SourceText{"x.xyz", water}, options);
            }),
            "model is 0: models are counted from 1");
  options.model = 2;
  EXPECT_EQ(error_text<OptionError>([&] {
              read_structure(SourceText{"x.xyz", water}, options);
            }),
            "no frame 2 in x.xyz: it has 1");
  options.model = 7;
  EXPECT_EQ(error_text<OptionError>([&] {
              read_structure(SourceText{"x.pdb", atom}, options);
            }),
            "no model 7 in x.pdb: it has 1");
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
  ReadOptions options;
  options.log.function = [&](Severity, std::string_view message) {
    messages.emplace_back(message);
  };
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

// The borders that cci.lbl.gov/hybrid_36 states for five and four columns.
TEST(Hybrid36, Borders) {
  EXPECT_EQ(parse_hybrid36("99999"), 99999);
  EXPECT_EQ(parse_hybrid36("A0000"), 100000);
  EXPECT_EQ(parse_hybrid36("ZZZZZ"), 43770015);
  EXPECT_EQ(parse_hybrid36("a0000"), 43770016);
  EXPECT_EQ(parse_hybrid36("zzzzz"), 87440031);
  EXPECT_EQ(parse_hybrid36("A000"), 10000);
  EXPECT_EQ(parse_hybrid36("ZZZZ"), 1223055);
  EXPECT_EQ(parse_hybrid36("a000"), 1223056);
  EXPECT_EQ(parse_hybrid36("zzzz"), 2436111);
}

TEST(Hybrid36, Decimal) {
  EXPECT_EQ(parse_hybrid36("   12"), 12);
  EXPECT_EQ(parse_hybrid36("12   "), 12);
  EXPECT_EQ(parse_hybrid36("  -5"), -5);
}

TEST(Hybrid36, WhatIsNone) {
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
