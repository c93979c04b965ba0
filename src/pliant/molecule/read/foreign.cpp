// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/foreign.hpp"

#include <algorithm>
#include <array>

namespace pliant {
namespace {

using namespace std::string_view_literals;

/// Bytes at a place of the file.
struct Content {
  std::size_t at;
  std::string_view bytes, what;
};

constexpr auto contents = std::to_array<Content>({
    {0, "\x89HDF\r\n\x1a\n"sv,
     "an HDF5 file: trajectories are for pliant check, analyse and compare; expected a structure"},
    {257, "ustar"sv, "a tar archive: expected one file of it"},
    {0, "\x1f\x8b"sv, "compressed twice (gzip)"},
    {0, "BZh9"sv, "compressed twice (bzip2)"},
    {0,
     "\xfd"
     "7zXZ"sv,
     "compressed twice (xz)"},
    {0, "%PDF-"sv, "a PDF document"},
    {0, "\x89PNG"sv, "a picture (PNG)"},
    {0, "\xff\xd8\xff"sv, "a picture (JPEG)"},
    {0,
     "\x7f"
     "ELF"sv,
     "a program (ELF)"},
    {4, "CORD"sv, "a trajectory (DCD): expected a structure"},
    {0, "CDF\x01"sv, "a trajectory (NetCDF): expected a structure"},
    {0, "CDF\x02"sv, "a trajectory (NetCDF): expected a structure"},
    {0, "\x93NUMPY"sv, "an array (NumPy)"},
});

struct Extension {
  std::string_view name, format;
};

constexpr auto extensions = std::to_array<Extension>({
    {".cdx", "ChemDraw"},
    {".crd", "CHARMM or AMBER"},
    {".dcd", "DCD"},
    {".gro", "GROMACS"},
    {".h5", "HDF5"},
    {".h5md", "H5MD"},
    {".inpcrd", "AMBER"},
    {".mae", "Maestro"},
    {".mmtf", "MMTF"},
    {".mol2", "MOL2"},
    {".nc", "NetCDF"},
    {".parm7", "AMBER"},
    {".pqr", "PQR"},
    {".prmtop", "AMBER"},
    {".psf", "CHARMM or NAMD"},
    {".rst7", "AMBER"},
    {".smi", "SMILES"},
    {".top", "GROMACS or AMBER"},
    {".tpr", "GROMACS"},
    {".trr", "GROMACS"},
    {".xtc", "GROMACS"},
});

bool begins_as_html(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  const auto begins = [&](std::string_view tag) {
    const auto same = [](char one, char other) {
      return (one >= 'A' && one <= 'Z' ? static_cast<char>(one + 32) : one) == other;
    };
    return text.size() >= tag.size() &&
           std::equal(tag.begin(), tag.end(), text.begin(),
                      [&](char wanted, char found) { return same(found, wanted); });
  };
  return begins("<!doctype html") || begins("<html");
}

}  // namespace

std::string_view foreign_content(std::string_view text) {
  for (const Content& content : contents)
    if (text.size() >= content.at && text.substr(content.at).starts_with(content.bytes))
      return content.what;
  if (begins_as_html(text)) return "a web page (HTML), perhaps from a failed download";
  return {};
}

std::string_view foreign_format(std::string_view extension) {
  const auto row = std::find_if(extensions.begin(), extensions.end(),
                                [&](const Extension& one) { return one.name == extension; });
  return row == extensions.end() ? std::string_view{} : row->format;
}

}  // namespace pliant
