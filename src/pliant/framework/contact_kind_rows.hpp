// SPDX-License-Identifier: MIT
// Kinds of molecular contacts, one row each. A row and the finder that it names, in a file of its
// own below model/contacts, are all that a kind needs: records, contact files, reports, rigidity,
// the command, Python and the page go over these rows.
//
//   PLIANT_CONTACT_KIND(name, number, finder, fields of MolecularContactKindEntry)
//
// The number is what files record limits of that kind as (LimitKind): a new kind takes the next one
// that is free, 6 or more (0 is `given`, 3 is `torsion`), and none ever changes. Records do not
// distinguish kinds of one number. The name, of 16 letters at most, is that of
// MolecularContactKind, of files and of options. Who includes this defines PLIANT_CONTACT_KIND:
// what is made of a row. The rows are words and numbers, and lie this low because readers and
// writers of limits need their names; functions are looked up in model/contacts/contact_kinds.hpp
// alone.
#ifdef PLIANT_CONTACT_KIND

PLIANT_CONTACT_KIND(hydrogen_bond, 1, find_hydrogen_bonds,  //
                    .singular = "hydrogen bond", .plural = "hydrogen bonds",
                    .summary = "donor, hydrogen and acceptor, by their energy",
                    .hold = ContactHold::by_hydrogen, .slack = 0.2, .bars = 5, .colour = "#3a9d8f",
                    .is_usual = true)

PLIANT_CONTACT_KIND(salt_bridge, 1, find_hydrogen_bonds,  //
                    .singular = "salt bridge", .plural = "salt bridges",
                    .summary = "a hydrogen bond between charged groups",
                    .hold = ContactHold::by_hydrogen, .slack = 0.2, .bars = 5, .colour = "#d1495b",
                    .is_usual = true)

PLIANT_CONTACT_KIND(hydrophobic, 2, find_tethers,  //
                    .singular = "hydrophobic contact", .plural = "hydrophobic contacts",
                    .summary = "two C or S near each other without polar neighbours",
                    .hold = ContactHold::below, .slack = 0.5, .bars = 2, .colour = "#a68a3d",
                    .is_usual = true)

PLIANT_CONTACT_KIND(metal, 4, find_metals,  //
                    .singular = "metal", .plural = "metals",
                    .summary = "a metal and an N, O or S of another residue beside it",
                    .hold = ContactHold::both_ways, .slack = 0.2, .bars = 5, .colour = "#6b5bd2",
                    .is_usual = true)

PLIANT_CONTACT_KIND(cation_pi, 5, find_cation_pi,  //
                    .singular = "cation-pi contact", .plural = "cation-pi contacts",
                    .summary = "LYS or ARG over the face of a ring of PHE, TYR or TRP",
                    .hold = ContactHold::below, .slack = 0.5, .bars = 2, .colour = "#f0a202",
                    .is_usual = false)

#undef PLIANT_CONTACT_KIND
#endif
