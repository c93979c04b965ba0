// SPDX-License-Identifier: MIT
#include "pliant/molecule/structure/residue_templates.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>

#include "pliant/base/number.hpp"

namespace pliant {
namespace {

// Bonds are written A-B single, A=B double, A:B aromatic (either end may have the spelling of
// another program: a template holds all of them). A+H bonds hydrogens to A: those called H, H1, H2
// and H3. A lone word is a site without a bond.
struct Row {
  ResidueKind kind;
  std::string_view names;
  std::string_view bonds;
  std::string_view more_bonds = {};
};

constexpr std::string_view backbone =
    "N-CA CA-C C=O C=O1 C=OT1 C=OC1 C=OCT1 C-OXT C-O2 C-OT2 C-OC2 C-OCT2 C-OT "
    "OXT-HXT OXT-HO OXT-HO2 OXT-HOXT N+H N+HN N+HT CA+HA ";

constexpr std::string_view sugar_and_phosphate =
    "P=OP1 P=O1P P-OP2 P-O2P P-OP3 P-O3P P-O5T P-O5' OP2-HOP2 OP3-HOP3 O2P-HOP2 O3P-HOP3 "
    "O5'-C5' C5'-C4' C4'-O4' C4'-C3' C3'-O3' C3'-C2' C2'-C1' C1'-O4' C2'-O2' O5'-HO5' O5'-H5T "
    "O5'-HO'5 O3'-HO3' O3'-H3T O3'-HO'3 C5'-H5' C5'-H5'' C5'-H5'1 C5'-H5'2 C4'-H4' C3'-H3' "
    "C2'-H2'1 O2'-HO2' O2'-HO'2 C1'-H1' ";
// Not for CHARMM's names, where H2' is the hydroxyl's in RNA and on carbon in DNA: distances tell.
constexpr std::string_view sugar_hydrogens = "C2'-H2' C2'-H2'' C2'-H2'2 ";

constexpr std::string_view adenine =
    "C1'-N9 N9:C8 C8:N7 N7:C5 C5:C6 C6:N1 N1:C2 C2:N3 N3:C4 C4:C5 C4:N9 C6-N6 C8+H8 C2+H2 N6+H6 "
    "N6-HN61 N6-HN62 ";
constexpr std::string_view guanine =
    "C1'-N9 N9:C8 C8:N7 N7:C5 C5-C6 C6=O6 C6-N1 N1-C2 C2=N3 N3-C4 C4:C5 C4:N9 C2-N2 C8+H8 N1+H1 "
    "N2+H2 N2-HN21 N2-HN22 ";
constexpr std::string_view cytosine =
    "C1'-N1 N1-C2 C2=O2 C2-N3 N3=C4 C4-C5 C5=C6 C6-N1 C4-N4 C5+H5 C6+H6 N4+H4 N3+H3 "
    "N4-HN41 N4-HN42 ";
constexpr std::string_view uracil =
    "C1'-N1 N1-C2 C2=O2 C2-N3 N3-C4 C4=O4 C4-C5 C5=C6 C6-N1 N3+H3 C5+H5 C6+H6 ";
constexpr std::string_view thymine =
    "C1'-N1 N1-C2 C2=O2 C2-N3 N3-C4 C4=O4 C4-C5 C5=C6 C6-N1 N3+H3 C5-C7 C5-C5M C7+H7 C7+H5 "
    "C5M+H5 C5M+H7 C5M+H5M C6+H6 ";

constexpr auto amino = ResidueKind::amino_acid;
constexpr auto cap = ResidueKind::cap;
constexpr auto nucleotide = ResidueKind::nucleotide;

// Amino acids also have the bonds of `backbone`, nucleotides those of `sugar_and_phosphate`.
constexpr Row rows[] = {
    {amino, "ALA", "CA-CB CB+HB"},
    {amino, "ARG ARN",
     "CA-CB CB-CG CG-CD CD-NE NE-CZ CZ-NH1 CZ=NH2 CB+HB CG+HG CD+HD NE+HE "
     "NH1+HH1 NH2+HH2"},
    {amino, "ASN", "CA-CB CB-CG CG=OD1 CG-ND2 CB+HB ND2+HD2"},
    {amino, "ASP ASH ASPH ASPP ASZ", "CA-CB CB-CG CG=OD1 CG-OD2 CB+HB OD1+HD1 OD2+HD2"},
    {amino, "CYS CYX CYM CYSH CYS1 CYS2 CYSS CYN CYZ", "CA-CB CB-SG CB+HB SG+HG"},
    {amino, "GLN", "CA-CB CB-CG CG-CD CD=OE1 CD-NE2 CB+HB CG+HG NE2+HE2"},
    {amino, "GLU GLH GLUH GLUP GLZ", "CA-CB CB-CG CG-CD CD=OE1 CD-OE2 CB+HB CG+HG OE1+HE1 OE2+HE2"},
    {amino, "GLY", ""},
    {amino, "HIS HID HIE HIP HSD HSE HSP HISA HISB HISD HISE HISH HISP HIS1 HIS2 HISN",
     "CA-CB CB-CG CG:ND1 ND1:CE1 CE1:NE2 NE2:CD2 CD2:CG CB+HB ND1+HD1 CD2+HD2 CE1+HE1 NE2+HE2"},
    {amino, "ILE",
     "CA-CB CB-CG1 CB-CG2 CG1-CD1 CG1-CD CB+HB CG1+HG1 CG2+HG2 CD1+HD1 CD1-HD2 "
     "CD1-HD3 CD+HD1 CD-HD2 CD-HD3"},
    {amino, "LEU", "CA-CB CB-CG CG-CD1 CG-CD2 CB+HB CG+HG CD1+HD1 CD2+HD2"},
    {amino, "LYS LYN LYP LYSH LSN", "CA-CB CB-CG CG-CD CD-CE CE-NZ CB+HB CG+HG CD+HD CE+HE NZ+HZ"},
    {amino, "MET", "CA-CB CB-CG CG-SD SD-CE CB+HB CG+HG CE+HE"},
    {amino, "MSE", "CA-CB CB-CG CG-SE SE-CE CB+HB CG+HG CE+HE"},
    {amino, "PHE",
     "CA-CB CB-CG CG:CD1 CD1:CE1 CE1:CZ CZ:CE2 CE2:CD2 CD2:CG CB+HB CD1+HD1 CD2+HD2 "
     "CE1+HE1 CE2+HE2 CZ+HZ"},
    {amino, "PRO", "CA-CB CB-CG CG-CD CD-N CB+HB CG+HG CD+HD"},
    {amino, "SER", "CA-CB CB-OG CB+HB OG+HG"},
    {amino, "THR", "CA-CB CB-OG1 CB-CG2 CB+HB OG1+HG1 CG2+HG2"},
    {amino, "TRP",
     "CA-CB CB-CG CG:CD1 CD1:NE1 NE1:CE2 CE2:CD2 CD2:CG CE2:CZ2 CZ2:CH2 CH2:CZ3 "
     "CZ3:CE3 CE3:CD2 CB+HB CD1+HD1 NE1+HE1 CE3+HE3 CZ3+HZ3 CZ2+HZ2 CH2+HH2"},
    {amino, "TYR TYM",
     "CA-CB CB-CG CG:CD1 CD1:CE1 CE1:CZ CZ:CE2 CE2:CD2 CD2:CG CZ-OH CB+HB "
     "CD1+HD1 CD2+HD2 CE1+HE1 CE2+HE2 OH+HH"},
    {amino, "VAL", "CA-CB CB-CG1 CB-CG2 CB+HB CG1+HG1 CG2+HG2"},
    // Usual residues beyond the twenty: aminoisobutyric acid, ornithine, pyroglutamic acid.
    {amino, "AIB", "CA-CB1 CA-CB2 CB1+HB1 CB2+HB2"},
    {amino, "ORN", "CA-CB CB-CG CG-CD CD-NE CB+HB CG+HG CD+HD NE+HE"},
    {amino, "PCA", "CA-CB CB-CG CG-CD CD=OE CD-N CB+HB CG+HG"},

    {cap, "ACE", "CH3-C CA-C C=O C-H CH3-H1 CH3-H2 CH3-H3 CH3+HH3 CH3+HA CA+HA"},
    {cap, "FOR", "C=O C+H"},
    {cap, "NME NMA", "N-C N-CH3 N-CA N-H N+HN C-H1 C-H2 C-H3 CH3+HH3 CA+HA"},
    {cap, "NH2 NHE", "N+H N+HN"},

    {nucleotide, "DA DA5 DA3 DAN A A5 A3 AN RA RA5 RA3 RAN", adenine, sugar_hydrogens},
    {nucleotide, "DG DG5 DG3 DGN G G5 G3 GN RG RG5 RG3 RGN", guanine, sugar_hydrogens},
    {nucleotide, "DC DC5 DC3 DCN C C5 C3 CN RC RC5 RC3 RCN", cytosine, sugar_hydrogens},
    {nucleotide, "DU U U5 U3 UN RU RU5 RU3 RUN", uracil, sugar_hydrogens},
    {nucleotide, "DT DT5 DT3 DTN T", thymine, sugar_hydrogens},
    {nucleotide, "ADE", adenine},
    {nucleotide, "GUA", guanine},
    {nucleotide, "CYT", cytosine},
    {nucleotide, "URA URI", uracil},
    {nucleotide, "THY", thymine},

    // M, MW, EP, LP, OM and the like are the massless sites of four- and five-site models.
    {ResidueKind::water,
     "HOH WAT H2O HHO OHH SOL TIP TIP2 TIP3 TP3 T3P TP3M TIP4 TP4 T4P TP4E "
     "TIP5 TP5 T5P SPC SPCE DOD OH2",
     "O+H OW+H OH2+H OW+HW O+HW O-HO1 O-HO2 M M1 M2 MW MW1 MW2 EP EP1 EP2 EPW LP1 LP2 OM "
     "DOH2"},
};

using NameEdge = std::array<AtomKey, 2>;

struct Parts {
  std::vector<NameEdge> pairs;
  std::vector<std::uint8_t> orders;
  std::vector<AtomKey> names;

  void add(std::string_view a, std::string_view b, std::uint8_t order) {
    pairs.push_back({atom_key(a, false), atom_key(b, false)});
    orders.push_back(order);
    names.insert(names.end(), pairs.back().begin(), pairs.back().end());
  }
};

void add_word(Parts& parts, std::string_view word) {
  const auto sign = word.find_first_of("-=:+");
  if (sign == std::string_view::npos) return parts.names.push_back(atom_key(word, false));
  const std::string_view a = word.substr(0, sign), b = word.substr(sign + 1);
  if (word[sign] != '+') {
    parts.add(a, b, word[sign] == '-' ? 1 : word[sign] == '=' ? 2 : 4);
  } else {
    for (const char* number : {"", "1", "2", "3"}) parts.add(a, std::string(b) + number, 1);
  }
}

void add_words(Parts& parts, std::string_view words) {
  while (!words.empty()) {
    const auto end = std::min(words.find(' '), words.size());
    if (end > 0) add_word(parts, words.substr(0, end));
    words.remove_prefix(std::min(end + 1, words.size()));
  }
}

ResidueTemplate make_template(const Row& row) {
  Parts parts;
  add_words(parts, row.bonds);
  add_words(parts, row.more_bonds);
  if (row.kind == amino) add_words(parts, backbone);
  if (row.kind == nucleotide) add_words(parts, sugar_and_phosphate);
  ResidueTemplate result;
  result.kind = row.kind;
  std::sort(parts.names.begin(), parts.names.end());
  parts.names.erase(std::unique(parts.names.begin(), parts.names.end()), parts.names.end());
  result.names = std::move(parts.names);
  for (std::size_t k = 0; k < parts.pairs.size(); ++k)
    result.edges.push_back({static_cast<std::uint8_t>(result.find(parts.pairs[k][0])),
                            static_cast<std::uint8_t>(result.find(parts.pairs[k][1])),
                            parts.orders[k]});
  return result;
}

using Registry = std::map<std::string_view, std::shared_ptr<const ResidueTemplate>>;

/// Built on first use; every name of a row shares the row's template.
const Registry& registry() {
  static const Registry templates = [] {
    Registry all;
    for (const Row& row : rows) {
      const auto shared = std::make_shared<const ResidueTemplate>(make_template(row));
      for (std::string_view names = row.names; !names.empty();) {
        const auto end = std::min(names.find(' '), names.size());
        all.emplace(names.substr(0, end), shared);
        names.remove_prefix(std::min(end + 1, names.size()));
      }
    }
    return all;
  }();
  return templates;
}

const ResidueTemplate* find_exactly(std::string_view name) {
  const auto at = registry().find(name);
  return at == registry().end() ? nullptr : at->second.get();
}

}  // namespace

AtomKey atom_key(std::string_view name, bool is_hydrogen) {
  if (name.empty() || name.size() > sizeof(AtomKey)) return 0;
  const bool digit_first = name.size() > 1 && is_digit(name[0]) && !is_digit(name[1]);
  AtomKey key = 0;
  for (std::size_t k = digit_first; k < name.size(); ++k) {
    char c = name[k] == '*' ? '\'' : name[k];
    if (k == std::size_t{digit_first} && is_hydrogen && c == 'D') c = 'H';
    key = key << 8 | static_cast<unsigned char>(c);
  }
  return digit_first ? key << 8 | static_cast<unsigned char>(name[0]) : key;
}

int ResidueTemplate::find(AtomKey key) const {
  const auto at = std::lower_bound(names.begin(), names.end(), key);
  return at == names.end() || *at != key ? none : static_cast<int>(at - names.begin());
}

const ResidueTemplate* find_residue_template(std::string_view name) {
  if (const ResidueTemplate* found = find_exactly(name)) return found;
  // Amber marks the residues at the ends of a chain by a first letter: NALA, CHIE.
  if (name.size() != 4 || (name[0] != 'N' && name[0] != 'C')) return nullptr;
  const ResidueTemplate* inner = find_exactly(name.substr(1));
  return inner && inner->kind == ResidueKind::amino_acid ? inner : nullptr;
}

bool is_membrane_dummy(const Residue& residue) { return residue.name == "DUM"; }

std::vector<std::string_view> residue_template_names() {
  std::vector<std::string_view> names;
  for (const auto& [name, shape] : registry()) names.push_back(name);
  return names;
}

}  // namespace pliant
