// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/foreign.hpp"

#include <gtest/gtest.h>

#include <string>

#include "pliant/base/error.hpp"
#include "pliant/molecule/read/read.hpp"
#include "support/error_text.hpp"

namespace pliant {
namespace foreign_test {

using namespace std::string_literals;

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

}  // namespace foreign_test
}  // namespace pliant
