// SPDX-License-Identifier: MIT
// Biological assemblies of an mmCIF file: pdbx_struct_assembly_gen and pdbx_struct_oper_list.
#pragma once

#include <string>
#include <vector>

#include "pliant/molecule/read/cif/cif_document.hpp"
#include "pliant/molecule/read/shared/assembly.hpp"

namespace pliant {

inline constexpr std::string_view cif_assembly_gen = "_pdbx_struct_assembly_gen";
inline constexpr std::string_view cif_oper_list = "_pdbx_struct_oper_list";

/// Names of the assemblies ("1", "PAU") of the block, each once, in their order.
std::vector<std::string> cif_assembly_names(const CifDocument& document, const CifBlock& block);

/// The assembly of that name; its chains are those of label_asym_id. An operation expression is a
/// comma-separated list of terms; a term is a name, a range "1-60", or a product of lists in
/// parentheses, "(X0)(1-60)", whose last factor acts first. Throws InputError naming the line.
Assembly cif_assembly(const CifDocument& document, const CifBlock& block, const std::string& name,
                      const Remarks& remarks);

}  // namespace pliant
