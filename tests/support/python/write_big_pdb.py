#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes a large PDB file: polyalanine chains in a box of water, hybrid-36 numbers.

usage: write_big_pdb.py FILE [ATOMS]

The last molecule is always whole, so the file holds up to four atoms more than ATOMS (10^6).
Chains are extended strands of 200 residues (backbone and CB, no hydrogens), laid side by side
10 Angstrom apart; waters stand on a grid of 3.1 Angstrom spacing above them. One atom in ten
belongs to a chain.
"""

import sys

UPPER = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"
CHAIN_RESIDUES = 200
RISE = 3.78  # Angstrom from residue to residue: C-N is 1.33

# Backbone of one residue, x along the chain (Angstrom): C-N to the next is 1.33.
ALANINE = [
    (" N  ", "N", (0.00, 0.00, 0.00)),
    (" CA ", "C", (1.20, 0.82, 0.00)),
    (" C  ", "C", (2.45, -0.06, 0.00)),
    (" O  ", "O", (2.45, -1.29, 0.00)),
    (" CB ", "C", (1.20, 1.73, 1.23)),
]
WATER = [
    (" O  ", "O", (0.0, 0.0, 0.0)),
    (" H1 ", "H", (0.9572, 0.0, 0.0)),
    (" H2 ", "H", (-0.2400, 0.9266, 0.0)),
]


def hybrid36(width, number):
    """A number in `width` columns: decimal, then upper-case base 36 from A000..."""
    if number < 10**width:
        return f"{number:{width}d}"
    number += 10 * 36 ** (width - 1) - 10**width
    digits = ""
    for _ in range(width):
        number, digit = divmod(number, 36)
        digits = UPPER[digit] + digits
    return digits


class Writer:
    def __init__(self, file):
        self.file = file
        self.serial = 0
        self.atoms = 0

    def residue(self, name, chain, number, origin, atoms):
        for atom, element, (x, y, z) in atoms:
            self.serial += 1
            self.atoms += 1
            self.file.write(
                f"ATOM  {hybrid36(5, self.serial)} {atom} {name:>3} {chain}"
                f"{hybrid36(4, number)}    {origin[0] + x:8.3f}{origin[1] + y:8.3f}"
                f"{origin[2] + z:8.3f}  1.00  0.00          {element:>2}\n"
            )

    def ter(self):
        self.serial += 1
        self.file.write(f"TER   {hybrid36(5, self.serial)}\n")


def write_chains(writer, count):
    """`count` chains in rows; returns the height that they fill."""
    for k in range(count):
        y, z = 10.0 * (k % 40) - 200.0, 10.0 * (k // 40) - 200.0
        for r in range(CHAIN_RESIDUES):
            origin = (RISE * r - 380.0, y, z)
            writer.residue("ALA", "ABCDEFGHIJ"[k % 10], r + 1, origin, ALANINE)
        writer.ter()
    return 10.0 * ((count - 1) // 40 + 1) - 200.0


def write_waters(writer, atoms, floor):
    """Waters until the file has `atoms` atoms. Numbers run on in hybrid-36."""
    spacing, row = 3.1, 200
    number = 0
    while writer.atoms < atoms:
        i, j, k = number % row, number // row % row, number // (row * row)
        origin = (spacing * i - 310.0, spacing * j - 310.0, spacing * k + floor)
        writer.residue("HOH", "W", number + 1, origin, WATER)
        number += 1


def write_big_pdb(path, atoms=1_000_000):
    with open(path, "w", encoding="ascii", newline="\n") as file:
        writer = Writer(file)
        file.write("TITLE     POLYALANINE CHAINS IN WATER\n")
        chains = max(1, atoms // 10 // (CHAIN_RESIDUES * len(ALANINE)))
        floor = write_chains(writer, chains)
        write_waters(writer, atoms, floor)
        file.write("END\n")
    return writer.atoms


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    print(write_big_pdb(sys.argv[1], int(sys.argv[2]) if len(sys.argv) == 3 else 1_000_000))
