// SPDX-License-Identifier: MIT
#include "pliant/molecule/crystal_additives.hpp"

#include "pliant/base/words.hpp"

namespace pliant {
namespace {

constexpr CrystalAdditive table[] = {
    // solvents and cryoprotectants
    {"GOL", "glycerol"},
    {"EDO EGL", "ethylene glycol"},
    {"PGO PGR", "propylene glycol"},
    {"MPD MRD", "2-methyl-2,4-pentanediol"},
    {"BU1 HEZ", "butanediol, hexanediol"},
    {"DMS", "dimethyl sulfoxide"},
    {"DMF", "dimethylformamide"},
    {"MOH EOH", "methanol, ethanol"},
    {"IPA POL TBU", "propanols, tert-butanol"},
    {"ACN CCN DIO", "acetone, acetonitrile, dioxane"},
    {"ETF ACM", "trifluoroethanol, acetamide"},
    // polyethylene glycols and their ethers
    {"PEG PGE PG4 1PE P6G P33 PE8 2PE XPE", "polyethylene glycol"},
    {"PE3 PE4 PE5 P3G P4C 7PE 12P 15P 16P", "polyethylene glycol"},
    {"1PG 7PG P15 P4G AE3 AE4 ETE", "polyethylene glycol ether"},
    {"PG0 PG5 PG6 PGF ME2 TOE PEU", "polyethylene glycol ether"},
    // salts and acids
    {"SO4", "sulfate"},
    {"PO4 PI", "phosphate"},
    {"NO3 NH4", "nitrate, ammonium"},
    {"SCN AZI", "thiocyanate, azide"},
    {"ACT ACY", "acetate"},
    {"FMT", "formate"},
    {"CIT FLC", "citrate"},
    {"TAR TLA SRT", "tartrate"},
    {"MLA MLI", "malonate"},
    {"CAC CAD", "cacodylate"},
    {"GAI URE", "guanidine, urea"},
    // buffers
    {"TRS TAM", "tris"},
    {"BTB B3P", "bis-tris, bis-tris propane"},
    {"EPE", "HEPES"},
    {"MES MPO", "MES, MOPS"},
    {"NHE CXS", "CHES, CAPS"},
    {"IMD", "imidazole"},
    // reducing agents
    {"BME HED", "2-mercaptoethanol"},
    {"DTT DTU DTV DTD", "dithiothreitol"},
    // detergents
    {"LDA C8E", "lauryldimethylamine oxide, octyl tetraoxyethylene"},
    {"BOG BNG LMT LMU", "octyl glucoside, nonyl glucoside, dodecyl maltoside"},
};

}  // namespace

std::span<const CrystalAdditive> crystal_additives() { return table; }

std::vector<std::string_view> crystal_additive_names() {
  std::vector<std::string_view> names;
  for (const CrystalAdditive& row : table)
    for (std::string_view name : words_of(row.residues)) names.push_back(name);
  return names;
}

}  // namespace pliant
