// SPDX-License-Identifier: MIT
// Contacts as text, to look at, to edit and to give back.
//
//   kind,a,b,hydrogen,base,energy,distance,least,most,hydrogen_most,base_least,base_most
//   hydrogen_bond,A:LYS6:N,A:LEU67:O,A:LYS6:H,A:LEU67:C,-5.79,2.87,0,3.1,2.2,2.31,3.51
//   hydrophobic,A:ILE3:CG2,A:LEU15:CD1,,,-1,3.81,0,4.31,,,
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pliant/model/contacts/contact_list.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant {

/// Comma-separated, one line a contact below one of names; distances in Angstrom, energies in
/// kcal/mol. read_contacts reads it back to the same bits.
std::string contacts_as_csv(const std::vector<MolecularContact>& contacts,
                            const Structure& structure);

/// The same as JSON: {"contacts": [{"kind": ..., "a": ..., ...}, ...]}, null where there is none.
std::string contacts_as_json(const std::vector<MolecularContact>& contacts,
                             const Structure& structure);

/// Reads what contacts_as_csv or contacts_as_json writes; JSON begins with {. Atoms are those of
/// `structure`, by name or by index from 0. Columns may come in any order; what is missing, empty
/// or null is as the structure has it (energy: -1). Throws InputError naming file, line, field,
/// expected and found; FileError.
std::vector<MolecularContact> read_contacts(const std::filesystem::path& path,
                                            const Structure& structure);
std::vector<MolecularContact> parse_contacts(const SourceText& source, const Structure& structure);

}  // namespace pliant
