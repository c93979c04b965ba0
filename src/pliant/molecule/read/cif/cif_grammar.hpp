// SPDX-License-Identifier: MIT
// From CIF text to a CifDocument, by gemmi's grammar.
#pragma once

#include <string_view>
#include <vector>

#include "pliant/molecule/read/cif/cif_document.hpp"

namespace pliant {

/// Parses a file and keeps the tables of `categories` ("_atom_site"); `source.text` must outlive
/// the document and have LF or CRLF line ends. Throws InputError naming the line for invalid CIF:
/// unclosed quotes and text fields, values that do not fill a loop's last row, tags without values,
/// tags given twice.
CifDocument parse_cif(const SourceText& source, const std::vector<std::string_view>& categories);

}  // namespace pliant
