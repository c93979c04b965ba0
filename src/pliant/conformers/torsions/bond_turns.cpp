// SPDX-License-Identifier: MIT
#include "pliant/conformers/torsions/bond_turns.hpp"

namespace pliant {
namespace {

constexpr TorsionPeak any[] = {{0, 0, 5},   {30, 0, 5},  {60, 0, 5}, {90, 0, 5},
                               {120, 0, 5}, {150, 0, 5}, {180, 0, 5}};
constexpr TorsionPeak staggered[] = {{60, 0, 9}, {180, 0, 9}, {90, 1.6, 12}, {150, 1.6, 12}};
constexpr TorsionPeak alkyl[] = {{180, 0, 9}, {64, 0.9, 9}};
constexpr TorsionPeak gauche[] = {{65, 0, 9}, {180, 0.5, 9}};
constexpr TorsionPeak ether[] = {{180, 0, 10}, {75, 1.3, 10}};
constexpr TorsionPeak ether_branched[] = {{80, 0, 12}, {155, 0, 15}};
constexpr TorsionPeak amine[] = {{180, 0, 10}, {65, 0.7, 10}};
constexpr TorsionPeak thioether[] = {{180, 0, 12}, {70, 0.2, 12}};
constexpr TorsionPeak disulfide[] = {{90, 0, 12}};
constexpr TorsionPeak phosphate[] = {{60, 0, 15}, {180, 0, 15}, {100, 0.8, 15}};
constexpr TorsionPeak acid[] = {{180, 0, 6}, {0, 4.0, 6}};
constexpr TorsionPeak ester_alkyl[] = {{180, 0, 12}, {85, 0.4, 12}};
constexpr TorsionPeak ester_branched[] = {{95, 0, 15}, {145, 0, 15}};
constexpr TorsionPeak amide_alkyl[] = {{85, 0, 15}, {120, 0.3, 15}, {180, 0.5, 15}};
constexpr TorsionPeak amide_branched[] = {{80, 0.3, 12}, {105, 0.1, 12}, {140, 0, 15}};
constexpr TorsionPeak acyl_alkyl[] = {{180, 0, 18}, {110, 0, 18}, {65, 0.6, 15}, {30, 1.2, 15}};
constexpr TorsionPeak acyl_branched[] = {{60, 0.2, 12},  {90, 0, 12},    {120, 0, 12},
                                         {150, 0.2, 12}, {180, 0.5, 12}, {30, 0.8, 12},
                                         {5, 1.0, 12}};
constexpr TorsionPeak acyl_hetero[] = {{0, 0.2, 15}, {180, 0, 15}, {145, 0.5, 15}, {60, 1.0, 15}};
constexpr TorsionPeak acyl_benzyl[] = {{90, 0.2, 18}, {130, 0, 18}, {60, 0.5, 15}, {180, 1.0, 15}};
constexpr TorsionPeak sulfonamide[] = {{62, 0, 10}, {85, 0.4, 10}, {105, 0.7, 10}, {180, 2.5, 12}};
constexpr TorsionPeak sulfonamide_alkyl[] = {{85, 0, 15}, {120, 0.3, 15}, {180, 0.3, 15}};
constexpr TorsionPeak aryl_sulfonyl[] = {
    {90, 0, 12}, {60, 0.2, 12}, {120, 0.2, 12}, {25, 1.0, 14}, {155, 1.0, 14}};
constexpr TorsionPeak aryl_sulfide[] = {{0, 0, 14}, {180, 0, 14}, {90, 0.6, 16}};
constexpr TorsionPeak aryl_ether[] = {{0, 0, 9}, {180, 0, 9}, {80, 1.8, 15}, {100, 1.8, 15}};
constexpr TorsionPeak aryl_ether_branched[] = {
    {0, 0, 18}, {180, 0, 18}, {65, 0.6, 15}, {115, 0.6, 15}};
constexpr TorsionPeak diaryl[] = {{10, 0.3, 12},  {170, 0.3, 12}, {40, 0.3, 12},
                                  {140, 0.3, 12}, {70, 0, 12},    {110, 0, 12}};
constexpr TorsionPeak aryl_ester[] = {{65, 0, 14}, {115, 0, 14}, {90, 0.3, 14}};
constexpr TorsionPeak flanked[] = {{90, 0, 12}, {65, 0.6, 12}, {115, 0.6, 12}};
constexpr TorsionPeak aryl_amine[] = {{0, 0, 9},     {180, 0, 9},   {30, 0.7, 9},
                                      {150, 0.7, 9}, {60, 1.4, 12}, {120, 1.4, 12}};
constexpr TorsionPeak aryl_amine_ortho[] = {{0, 0.4, 12},   {180, 0, 12},  {40, 0.4, 12},
                                            {140, 0.2, 12}, {65, 0.8, 12}, {115, 0.6, 12}};
constexpr TorsionPeak off_plane[] = {{60, 0, 14}, {120, 0, 14}, {90, 0, 14}};
constexpr TorsionPeak aryl_amide[] = {{0, 0, 10}, {180, 0, 10}, {30, 0.2, 10}, {150, 0.2, 10}};
constexpr TorsionPeak aryl_amide_ortho[] = {{50, 0, 12},  {130, 0, 12},  {180, 0.3, 12},
                                            {0, 0.6, 12}, {75, 0.4, 12}, {105, 0.4, 12}};
constexpr TorsionPeak aryl_acylated[] = {
    {60, 0, 12}, {120, 0, 12}, {90, 0, 14}, {40, 0.6, 12}, {140, 0.6, 12}};
constexpr TorsionPeak aryl_sulfonamide[] = {
    {70, 0, 14}, {110, 0, 14}, {40, 0.7, 14}, {140, 0.7, 14}};
constexpr TorsionPeak aryl_acyl[] = {{25, 0, 9},    {155, 0, 9},  {0, 0.3, 9},
                                     {180, 0.3, 9}, {45, 0.7, 9}, {135, 0.7, 9}};
constexpr TorsionPeak aryl_acyl_ortho[] = {{50, 0, 10},    {130, 0, 10},  {25, 0.1, 10},
                                           {155, 0.1, 10}, {5, 0.4, 10},  {175, 0.4, 10},
                                           {75, 0.8, 10},  {105, 0.8, 10}};
constexpr TorsionPeak aryl_acyl_flanked[] = {{65, 0, 12}, {115, 0, 12}, {90, 0, 12}};
constexpr TorsionPeak aryl_ketone[] = {{0, 0, 9}, {180, 0, 9}, {25, 0.6, 10}, {155, 0.6, 10}};
constexpr TorsionPeak pyridyl_amide[] = {{0, 0, 9}, {180, 1.5, 12}};
constexpr TorsionPeak flat_primary[] = {
    {90, 0, 12}, {70, 0.2, 10}, {110, 0.2, 10}, {45, 1.0, 12}, {135, 1.0, 12}};
constexpr TorsionPeak flat_hetero[] = {{90, 0.1, 12},  {70, 0, 12},   {110, 0, 12},  {45, 0.2, 12},
                                       {135, 0.2, 12}, {15, 0.6, 12}, {165, 0.6, 12}};
constexpr TorsionPeak flat_branched[] = {{60, 0, 12},    {120, 0, 12}, {90, 0.6, 12}, {30, 1.0, 10},
                                         {150, 1.0, 10}, {5, 1.0, 10}, {175, 1.0, 10}};
constexpr TorsionPeak flat_quaternary[] = {{0, 0, 10},    {60, 0, 10},   {120, 0, 10},
                                           {180, 0, 10},  {30, 0.4, 10}, {90, 0.4, 10},
                                           {150, 0.4, 10}};
constexpr TorsionPeak biaryl[] = {{38, 0, 9}, {142, 0, 9}, {15, 1.0, 9}, {165, 1.0, 9}};
constexpr TorsionPeak biaryl_plane[] = {{0, 0, 10}, {180, 0, 10}, {28, 0.4, 8}, {152, 0.4, 8}};
constexpr TorsionPeak biaryl_ortho[] = {{52, 0, 9},   {128, 0, 9},   {30, 0.1, 9}, {150, 0.1, 9},
                                        {75, 0.7, 9}, {105, 0.7, 9}, {8, 0.8, 9},  {172, 0.8, 9}};
constexpr TorsionPeak biaryl_flanked[] = {
    {90, 0, 10}, {70, 0, 9}, {110, 0, 9}, {50, 0.3, 9}, {130, 0.3, 9}};
constexpr TorsionPeak in_plane[] = {{0, 0, 10}, {180, 0, 10}};
constexpr TorsionPeak conjugated[] = {{180, 0, 8}, {0, 0.8, 10}};
constexpr TorsionPeak aryl_vinyl[] = {{0, 0, 10}, {180, 0, 10}, {30, 0.4, 10}, {150, 0.4, 10}};
constexpr TorsionPeak allyl[] = {{120, 0, 12}, {0, 0.6, 12}, {60, 0.6, 12}, {180, 0.6, 14}};
constexpr TorsionPeak hydrazine[] = {{90, 0, 16}, {180, 0, 14}, {0, 1.2, 14}};
constexpr TorsionPeak beside_acyl[] = {{90, 0, 12}, {180, 0, 12}};
constexpr TorsionPeak ring_amide[] = {{180, 0, 8}, {0, 0, 8}};

constexpr BondTurnEntry bond_turn_table[] = {
    {BondTurn::any, "any", any},
    {BondTurn::staggered, "staggered", staggered},
    {BondTurn::alkyl, "alkyl", alkyl},
    {BondTurn::gauche, "gauche", gauche},
    {BondTurn::ether, "ether", ether},
    {BondTurn::ether_branched, "ether_branched", ether_branched},
    {BondTurn::amine, "amine", amine},
    {BondTurn::thioether, "thioether", thioether},
    {BondTurn::disulfide, "disulfide", disulfide},
    {BondTurn::phosphate, "phosphate", phosphate},
    {BondTurn::ester, "ester", {}},
    {BondTurn::acid, "acid", acid},
    {BondTurn::ester_alkyl, "ester_alkyl", ester_alkyl},
    {BondTurn::ester_branched, "ester_branched", ester_branched},
    {BondTurn::amide_alkyl, "amide_alkyl", amide_alkyl},
    {BondTurn::amide_branched, "amide_branched", amide_branched},
    {BondTurn::acyl_alkyl, "acyl_alkyl", acyl_alkyl},
    {BondTurn::acyl_branched, "acyl_branched", acyl_branched},
    {BondTurn::acyl_hetero, "acyl_hetero", acyl_hetero},
    {BondTurn::acyl_benzyl, "acyl_benzyl", acyl_benzyl},
    {BondTurn::sulfonamide, "sulfonamide", sulfonamide},
    {BondTurn::sulfonamide_alkyl, "sulfonamide_alkyl", sulfonamide_alkyl},
    {BondTurn::aryl_sulfonyl, "aryl_sulfonyl", aryl_sulfonyl},
    {BondTurn::aryl_sulfide, "aryl_sulfide", aryl_sulfide},
    {BondTurn::aryl_ether, "aryl_ether", aryl_ether},
    {BondTurn::aryl_ether_branched, "aryl_ether_branched", aryl_ether_branched},
    {BondTurn::diaryl, "diaryl", diaryl},
    {BondTurn::aryl_ester, "aryl_ester", aryl_ester},
    {BondTurn::flanked, "flanked", flanked},
    {BondTurn::aryl_amine, "aryl_amine", aryl_amine},
    {BondTurn::aryl_amine_ortho, "aryl_amine_ortho", aryl_amine_ortho},
    {BondTurn::off_plane, "off_plane", off_plane},
    {BondTurn::aryl_amide, "aryl_amide", aryl_amide},
    {BondTurn::aryl_amide_ortho, "aryl_amide_ortho", aryl_amide_ortho},
    {BondTurn::aryl_acylated, "aryl_acylated", aryl_acylated},
    {BondTurn::aryl_sulfonamide, "aryl_sulfonamide", aryl_sulfonamide},
    {BondTurn::aryl_acyl, "aryl_acyl", aryl_acyl},
    {BondTurn::aryl_acyl_ortho, "aryl_acyl_ortho", aryl_acyl_ortho},
    {BondTurn::aryl_acyl_flanked, "aryl_acyl_flanked", aryl_acyl_flanked},
    {BondTurn::aryl_ketone, "aryl_ketone", aryl_ketone},
    {BondTurn::pyridyl_amide, "pyridyl_amide", pyridyl_amide},
    {BondTurn::flat_primary, "flat_primary", flat_primary},
    {BondTurn::flat_hetero, "flat_hetero", flat_hetero},
    {BondTurn::flat_branched, "flat_branched", flat_branched},
    {BondTurn::flat_quaternary, "flat_quaternary", flat_quaternary},
    {BondTurn::biaryl, "biaryl", biaryl},
    {BondTurn::biaryl_plane, "biaryl_plane", biaryl_plane},
    {BondTurn::biaryl_ortho, "biaryl_ortho", biaryl_ortho},
    {BondTurn::biaryl_flanked, "biaryl_flanked", biaryl_flanked},
    {BondTurn::atropisomer, "atropisomer", {}},
    {BondTurn::in_plane, "in_plane", in_plane},
    {BondTurn::conjugated, "conjugated", conjugated},
    {BondTurn::aryl_vinyl, "aryl_vinyl", aryl_vinyl},
    {BondTurn::allyl, "allyl", allyl},
    {BondTurn::hydrazine, "hydrazine", hydrazine},
    {BondTurn::beside_acyl, "beside_acyl", beside_acyl},
    {BondTurn::ring_amide, "ring_amide", ring_amide}};

}  // namespace

std::span<const BondTurnEntry> bond_turns() { return bond_turn_table; }

const BondTurnEntry& entry(BondTurn kind) {
  return bond_turn_table[static_cast<std::size_t>(kind)];
}

}  // namespace pliant
