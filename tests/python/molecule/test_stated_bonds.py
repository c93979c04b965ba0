# SPDX-License-Identifier: MIT
"""Which bonds that a file states are bonds; metals; valence; what is no atom at all."""

import gzip
import math
import warnings
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

import pliant

pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")

METALS = {"ZN", "MG", "CA", "FE", "MN", "CU", "NI", "CO", "K", "NA", "CD", "HG"}


def atom(serial, name, residue, number, xyz, element, chain="A"):
    place = "".join(f"{x:8.3f}" for x in xyz)
    return (
        f"HETATM{serial:5d} {name:<4} {residue:>3} {chain}{number:4d}    {place}"
        f"  1.00  0.00          {element:>2}"
    )


def link(one, other):
    """A LINK of two of (name, residue, number), chain A."""
    ends = [f"{name:<4} {residue:>3} A{number:4d}" for name, residue, number in (one, other)]
    return f"LINK        {ends[0]}                {ends[1]}     1555   1555"


def conect(*pairs):
    return [f"CONECT{a:5d}{b:5d}" for a, b in pairs]


def heard(text, name="made.pdb"):
    """The structure of a text, and the warnings on the way."""
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        structure = pliant.read_text(text, name)
    return structure, [str(warning.message) for warning in found]


def bonds_of(structure):
    names = structure.names
    return {tuple(sorted((str(names[a]), str(names[b])))) for a, b in structure.bonds.tolist()}


def held(structure):
    """{(metal, atom, number of its residue): distance} of the contacts of metals."""
    kept = pliant.build_model(structure, keep_waters=True)
    rows = kept.contacts[kept.contacts["kind"] == "metal"] if len(kept.contacts) else []
    names, numbers = kept.structure.names, kept.structure.residue_ids
    return {
        (str(names[row["a"]]), str(names[row["b"]]), int(numbers[row["b"]])): float(row["distance"])
        for row in rows
    }


RING = [  # imidazole: NE2 at the origin, the metal on the x axis
    (" CG ", "C", (-2.18, 0.64, 0.0)),
    (" ND1", "N", (-2.10, -0.73, 0.0)),
    (" CD2", "C", (-0.88, 1.08, 0.0)),
    (" CE1", "C", (-0.80, -1.06, 0.0)),
    (" NE2", "N", (0.0, 0.0, 0.0)),
]


def site(records, length=2.1):
    """Zinc and three histidines; `records`: whether LINK and CONECT state what it holds."""
    lines, bonds, links = [], [], []
    for k in range(3):
        turn = 2 * math.pi * k / 3
        for name, element, (x, y, z) in RING:
            out = length - x
            place = (
                -out * math.cos(turn) - y * math.sin(turn),
                y * math.cos(turn) - out * math.sin(turn),
                z,
            )
            lines.append(atom(len(lines) + 1, name, "HIS", k + 1, place, element))
        bonds.append((len(lines), 16))
        links.append(link((" NE2", "HIS", k + 1), ("ZN  ", "ZN", 9)))
    lines.append(atom(16, "ZN  ", " ZN", 9, (0.0, 0.0, 0.0), "ZN"))
    if records:
        lines = [*links, *lines, *conect(*bonds)]
    return "\n".join([*lines, "END\n"])


def test_a_metal_is_held_alike_whether_records_state_it_or_not():
    stated, said = heard(site(True))
    found, silent = heard(site(False))
    assert said == silent
    assert stated.bonds.tolist() == found.bonds.tolist()
    assert len(stated.bonds) == 15
    assert held(stated) == held(found)
    assert list(held(stated).values()) == pytest.approx([2.1] * 3, abs=1e-3)


def test_the_same_frames_come_of_both():
    frames = [
        pliant.sample(heard(site(records))[0], frames=3, amplitude=0.5, seed=4)
        for records in (True, False)
    ]
    assert np.array_equal(frames[0].positions, frames[1].positions)


def test_what_a_file_states_beyond_reach_is_named_and_not_held():
    structure, said = heard(site(True, length=2.97))
    assert said[-1] == (
        "3 bonds of metals stated by the file, longer than coordination is, not held: "
        "A:HIS1:NE2 - A:ZN9:ZN (2.97 Angstrom), A:HIS2:NE2 - A:ZN9:ZN (2.97 Angstrom), "
        "A:HIS3:NE2 - A:ZN9:ZN (2.97 Angstrom)"
    )
    assert held(structure) == {}


@pytest.mark.parametrize(
    ("metal", "element", "length", "is_held"),
    [
        ("MG", "O", 2.75, True),
        ("MG", "O", 2.85, False),
        ("K", "O", 3.1, True),
        ("K", "O", 3.3, False),
        ("FE", "C", 1.8, True),
        ("FE", "C", 2.5, False),
        ("ZN", "CL", 2.3, True),
        ("ZN", "P", 2.4, False),
    ],
)
def test_how_far_metals_hold(metal, element, length, is_held):
    text = "\n".join(
        [
            atom(1, f"{metal:<4}", metal, 1, (0.0, 0.0, 0.0), metal),
            atom(2, f"{element:<4}", "LIG", 2, (length, 0.0, 0.0), element),
            "END\n",
        ]
    )
    assert (len(held(heard(text)[0])) == 1) == is_held


def haem(records, bound):
    """Iron in a ring of four N, and an N of another residue `bound` Angstrom above it."""
    lines = [atom(1, "FE  ", "HEM", 1, (0.0, 0.0, 0.0), "FE")]
    pairs = []
    for k, (x, y) in enumerate([(2, 0), (0, 2), (-2, 0), (0, -2)]):
        lines.append(atom(k + 2, f" N{'ABCD'[k]} ", "HEM", 1, (x, y, 0.0), "N"))
        pairs.append((1, k + 2))
    lines.append(atom(6, " NE2", "HIS", 2, (0.0, 0.0, bound), "N"))
    if records:
        lines = [link(("FE  ", "HEM", 1), (" NE2", "HIS", 2)), *lines, *conect(*pairs, (1, 6))]
    return "\n".join([*lines, "END\n"])


@pytest.mark.parametrize("records", [True, False])
def test_a_metal_is_bonded_within_its_residue_and_holds_others(records):
    structure, _ = heard(haem(records, 2.05))
    assert bonds_of(structure) == {("FE", f"N{letter}") for letter in "ABCD"}
    assert held(structure) == {("FE", "NE2", 2): pytest.approx(2.05)}


@pytest.mark.parametrize("records", [True, False])
def test_the_rings_of_ferrocene_are_bonded_to_iron(records):
    lines, pairs = [atom(1, "FE  ", "FCN", 1, (0.0, 0.0, 0.0), "FE")], []
    for k in range(10):
        turn = 2 * math.pi * k / 5
        place = (1.21 * math.cos(turn), 1.21 * math.sin(turn), 1.66 if k < 5 else -1.66)
        lines.append(atom(k + 2, f" C{k:<2}", "FCN", 1, place, "C"))
        pairs.append((1, k + 2))
        pairs.append((k + 2, k // 5 * 5 + (k + 1) % 5 + 2))
    structure, _ = heard("\n".join([*lines, *(conect(*pairs) if records else []), "END\n"]))
    assert len(structure.bonds) == 20
    assert sum("FE" in pair for pair in bonds_of(structure)) == 10


def test_ions_of_one_residue_with_others_are_not_bonded():
    """XYZ has no residues, and sodium is never more than near."""
    assert len(pliant.read_text("2\n\nFe 0 0 0\nO 2.0 0 0\n", "a.xyz").bonds) == 0
    lines = [
        atom(1, "NA  ", "UNL", 1, (0, 0, 0), "NA"),
        atom(2, " O  ", "UNL", 1, (2.2, 0, 0), "O"),
    ]
    assert len(heard("\n".join([*lines, "END\n"]))[0].bonds) == 0


def without_records_of_metals(text):
    """A PDB text without LINK and CONECT of metals and others of other residues."""
    lines = text.splitlines()
    metals, residue = set(), {}
    for line in lines:
        if line.startswith(("ATOM", "HETATM")):
            residue[line[6:11]] = line[17:27]
            if line[76:78].strip() in METALS:
                metals.add(line[6:11])

    def kept(line):
        if line.startswith("LINK  "):
            return not {line[12:16].strip(), line[42:46].strip()} & METALS
        if not line.startswith("CONECT"):
            return True
        fields = [line[k : k + 5] for k in range(6, len(line.rstrip()), 5)]
        return not any(
            (fields[0] in metals or other in metals)
            and residue.get(fields[0]) != residue.get(other)
            for other in fields[1:]
        )

    return "\n".join([line for line in lines if kept(line)]) + "\n"


@pytest.mark.parametrize("name", ["data/19hc.pdb.gz", "data/5a7u.pdb"])
def test_records_of_metals_change_no_model_of_a_real_file(name):
    spec = find_spec("MDAnalysisTests")
    if spec is None or spec.origin is None:
        pytest.skip("MDAnalysisTests is not installed")
    path = Path(spec.origin).parent / name
    data = path.read_bytes()
    text = (gzip.decompress(data) if path.suffix == ".gz" else data).decode()
    bare = without_records_of_metals(text)
    assert len(bare) < len(text)
    models = [pliant.build_model(heard(source)[0]) for source in (text, bare)]
    assert models[0].structure.bonds.tolist() == models[1].structure.bonds.tolist()
    assert np.array_equal(models[0].positions, models[1].positions)
    assert np.array_equal(models[0].contacts, models[1].contacts)
    assert (models[0].contacts["kind"] == "metal").any()


# --- lengths -------------------------------------------------------------------------------------

CARBONS = [
    atom(1, " C1 ", "LIG", 1, (0.0, 0.0, 0.0), "C"),
    atom(2, " C2 ", "LIG", 1, (1.5, 0.0, 0.0), "C"),
    atom(3, " C3 ", "LIG", 2, (5.9, 0.0, 0.0), "C"),
]


@pytest.mark.parametrize("how", ["CONECT", "LINK"])
def test_a_stated_bond_that_is_too_long_is_named_and_left_out(how):
    stated = (
        [link((" C1 ", "LIG", 1), (" C3 ", "LIG", 2)), *CARBONS]
        if how == "LINK"
        else [*CARBONS, *conect((1, 3))]
    )
    structure, said = heard("\n".join([*stated, "END\n"]))
    assert bonds_of(structure) == {("C1", "C2")}
    assert said == [
        "1 bond stated by the file, longer than 1.3 times the sum of covalent radii, left out: "
        "A:LIG1:C1 - A:LIG2:C3 (5.90 Angstrom)"
    ]


@pytest.mark.parametrize(("length", "is_bond"), [(1.97, True), (1.99, False)])
def test_it_is_too_long_from_1_3_times_the_radii(length, is_bond):
    lines = [CARBONS[0], atom(2, " C2 ", "LIG", 1, (length, 0.0, 0.0), "C"), *conect((1, 2))]
    assert len(heard("\n".join([*lines, "END\n"]))[0].bonds) == is_bond


def test_one_far_longer_than_a_box_is_left_out_between_residues():
    lines = [*CARBONS[:2], atom(3, " C3 ", "LIG", 2, (49.0, 0.0, 0.0), "C"), *conect((1, 3))]
    structure, said = heard("\n".join([*lines, "END\n"]))
    assert bonds_of(structure) == {("C1", "C2")}
    assert "(49.00 Angstrom)" in said[0]
    structure.framework()


def test_one_that_a_template_has_too_is_no_loss():
    """CA and CB are bonded by name up to 3 Angstrom."""
    lines = [
        atom(1, " CA ", "ALA", 1, (0.0, 0.0, 0.0), "C"),
        atom(2, " CB ", "ALA", 1, (2.2, 0.0, 0.0), "C"),
        *conect((1, 2)),
    ]
    structure, said = heard("\n".join([*lines, "END\n"]))
    assert (len(structure.bonds), said) == (1, [])


def test_long_bonds_of_metals_and_of_sdf_files_are_named_and_kept():
    lines = [
        atom(1, "FE1 ", "FES", 1, (0.0, 0.0, 0.0), "FE"),
        atom(2, " S1 ", "FES", 1, (3.3, 0.0, 0.0), "S"),
        *conect((1, 2)),
    ]
    structure, said = heard("\n".join([*lines, "END\n"]))
    words = "1 bond stated by the file, longer than 1.3 times the sum of covalent radii, kept: "
    assert (len(structure.bonds), said) == (1, [words + "FE1(1) - S1(2) (3.30 Angstrom)"])
    block = (
        "\n  x\n\n  2  1  0  0  0  0  0  0  0  0999 V2000\n"
        "    0.0000    0.0000    0.0000 C   0  0  0  0  0  0  0  0  0  0  0  0\n"
        "    2.6000    0.0000    {z} C   0  0  0  0  0  0  0  0  0  0  0  0\n"
        "  1  2  1  0  0  0  0\nM  END\n"
    )
    structure, said = heard(block.format(z="0.2000"), "long.mol")
    assert (len(structure.bonds), said) == (1, [words + "C(1) - C(2) (2.61 Angstrom)"])
    structure, said = heard(block.format(z="0.0000"), "drawing.mol")
    assert (len(structure.bonds), said) == (1, [])


# --- valence -------------------------------------------------------------------------------------


@pytest.mark.parametrize("stated", [True, False])
def test_no_third_heavy_atom_is_guessed_at_an_ether(stated):
    """N - C - O of a short glycosidic bond: O and N are 1.54 Angstrom apart."""
    lines = [
        atom(1, " O5 ", "NAG", 2, (1.35, 0.0, 0.0), "O"),
        atom(2, " C1 ", "NAG", 2, (0.0, 0.0, 0.0), "C"),
        atom(3, " C5 ", "NAG", 2, (2.05, 1.25, 0.0), "C"),
        atom(4, " N  ", "XYZ", 1, (0.49, -1.28, 0.0), "N"),
    ]
    bonds = conect((1, 2), (1, 3), (2, 4)) if stated else []
    structure, _ = heard("\n".join([*lines, *bonds, "END\n"]))
    assert bonds_of(structure) == {("C1", "O5"), ("C5", "O5"), ("C1", "N")}


def test_a_full_carbonyl_takes_nothing_by_distance():
    """The C of a peptide has its four bonds by name; a stray atom beside it stays alone."""
    lines = [
        atom(1, " N  ", "GLY", 1, (-1.46, 0.0, 0.0), "N"),
        atom(2, " CA ", "GLY", 1, (0.0, 0.0, 0.0), "C"),
        atom(3, " C  ", "GLY", 1, (0.54, 1.42, 0.0), "C"),
        atom(4, " O  ", "GLY", 1, (-0.2, 2.4, 0.0), "O"),
        atom(5, " N  ", "GLY", 2, (1.86, 1.55, 0.0), "N"),
        atom(6, " CA ", "GLY", 2, (2.6, 2.8, 0.0), "C"),
        atom(7, " C1 ", "LIG", 9, (0.54, 1.42, 1.8), "C"),
        atom(8, " C2 ", "LIG", 9, (0.54, 1.42, 3.3), "C"),
    ]
    structure, _ = heard("\n".join([*lines, "END\n"]))
    assert bonds_of(structure) & {("C", "C1")} == set()
    assert ("C1", "C2") in bonds_of(structure)


# --- dummies -------------------------------------------------------------------------------------

DUMMIES = [
    atom(4, " N  ", "DUM", 7, (0.0, 1.2, 0.0), "N"),
    atom(5, " O  ", "DUM", 8, (0.0, -1.2, 0.0), "O"),
]
CIF = """data_x
loop_
_atom_site.group_PDB
_atom_site.id
_atom_site.type_symbol
_atom_site.label_atom_id
_atom_site.label_comp_id
_atom_site.label_asym_id
_atom_site.label_seq_id
_atom_site.Cartn_x
_atom_site.Cartn_y
_atom_site.Cartn_z
HETATM 1 C C1 LIG A . 0.0 0.0 0.0
HETATM 2 N N DUM A . 0.0 1.2 0.0
HETATM 3 O O DUM A . 0.0 -1.2 0.0
"""


@pytest.mark.parametrize(
    "source", [("a.pdb", "\n".join([*CARBONS, *DUMMIES, "END\n"])), ("a.cif", CIF)]
)
def test_dummy_atoms_of_a_membrane_are_none(source):
    name, text = source
    structure = pliant.read_text(text, name)
    assert set(structure.residue_names) == {"LIG"}


def test_a_file_of_nothing_but_dummy_atoms_is_refused():
    message = r"d\.pdb: holds nothing but dummy atoms \(residues DUM\)"
    with pytest.raises(pliant.InputError, match=message):
        pliant.read_text("\n".join([*DUMMIES, "END\n"]), "d.pdb")
