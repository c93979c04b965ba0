# SPDX-License-Identifier: MIT
"""pliant sample of one ligand: a small molecule, whatever its atoms are called."""

import json

import pytest

#: Heavy atoms of N-methylbutylamine, in a row.
CHAIN = [
    ("C", (0.000, 0.000, 0.000)),
    ("C", (1.540, 0.000, 0.000)),
    ("C", (2.054, 1.452, 0.000)),
    ("C", (3.594, 1.452, 0.000)),
    ("N", (4.084, 2.836, 0.000)),
    ("C", (5.554, 2.836, 0.000)),
]
PLAIN = ("C1", "C2", "C3", "C4", "N1", "C5")
NAMES = {
    "as an amino acid": ("CB", "CA", "C", "CX", "N", "C5"),
    "as a nucleotide": ("C5'", "C4'", "C3'", "C2'", "N1", "C5"),
}


def pdb(names, residue="LIG"):
    rows = zip(names, CHAIN, strict=True)
    atoms = [
        f"HETATM{k:5d}  {name:<3} {residue:>3} A   1    "
        f"{x:8.3f}{y:8.3f}{z:8.3f}  1.00  0.00          {element:>2}  "
        for k, (name, (element, (x, y, z))) in enumerate(rows, 1)
    ]
    bonds = [f"CONECT{k:5d}{k + 1:5d}" for k in range(1, len(CHAIN))]
    return "\n".join([*atoms, *bonds, "END"]) + "\n"


def sampled(pliant, tmp_path, text, *options):
    (tmp_path / "ligand.pdb").write_text(text)
    words = ("--frames", 3, "--overwrite", "--json", *options)
    ended = pliant("sample", "ligand.pdb", "-o", "out.h5md", *words)
    assert ended.code == 0, ended.err
    report = json.loads(ended.out)
    return {key: report[key] for key in ("model", "sampler", "frames")}


@pytest.mark.parametrize("kind", NAMES)
@pytest.mark.parametrize("options", [(), ("--sampler", "torsions")])
def test_names_of_atoms_make_no_polymer(pliant, tmp_path, kind, options):
    plain = sampled(pliant, tmp_path, pdb(PLAIN), *options)
    found = sampled(pliant, tmp_path, pdb(NAMES[kind]), *options)
    assert found == plain
    assert (found["model"], found["sampler"]) == ("molecule", "torsions")


def test_an_amino_acid_alone_is_a_small_molecule(pliant, tmp_path):
    found = sampled(pliant, tmp_path, pdb(("CB", "CA", "C", "CX", "N", "C5"), "LYS"))
    assert found["model"] == "molecule"
