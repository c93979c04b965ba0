# SPDX-License-Identifier: MIT
"""The molecules of data/: what README.md says of them, and that they are sound."""

import re
import subprocess
import sys
from itertools import pairwise

import numpy as np
import pytest
import support_program

DATA = support_program.ROOT / "data"
README = (DATA / "README.md").read_text().split("## mechanisms/")[0]
FILES = sorted(path.name for path in (DATA / "molecules").iterdir())


def table():
    """{file: (why, atoms, bonds, angles, cycles)} of README.md."""
    rows = re.findall(r"^\| (\w+\.\w+) \| (.+?) \|(.*)\|$", README, flags=re.MULTILINE)
    return {file: (why, *(int(cell) for cell in numbers.split("|"))) for file, why, numbers in rows}


def positions(name):
    """Elements and positions, read here on their own."""
    text = (DATA / "molecules" / name).read_text()
    real = r"(-?\d+\.\d{3,8})"
    rows = {
        ".xyz": rf"^([A-Z][a-z]?) +{real} +{real} +{real}$",
        ".sdf": rf"^ *{real} *{real} *{real} ([A-Z][a-z]?) ",
        ".mol": rf"^M  V30 \d+ ([A-Z][a-z]?) {real} {real} {real} 0$",
        ".cif": rf"^HETATM +\d+ +([A-Z]) .* {real} +{real} +{real} 1.00",
        ".pdb": rf"^ATOM.{{26}} *{real} *{real} *{real}  1.00  0.00 +([A-Z])",
    }
    found = re.findall(rows[name[-4:]], text, flags=re.MULTILINE)
    first = name[-4:] not in (".sdf", ".pdb")
    elements = [row[0] if first else row[3] for row in found]
    return elements, np.array([row[1:] if first else row[:3] for row in found], dtype=float)


def test_every_molecule_has_a_row():
    assert sorted(table()) == FILES
    assert len(FILES) >= 15


def test_each_format_is_there_twice():
    formats = [name.rsplit(".")[1].replace("mol", "sdf") for name in FILES]
    assert min(formats.count(kind) for kind in ("pdb", "xyz", "sdf", "cif")) >= 2


def test_numbers_are_those_that_the_library_finds():
    rows = table()
    answers = support_program.ask(["facts"], [DATA / "molecules" / name for name in FILES])
    for name, facts in zip(FILES, answers, strict=True):
        assert facts["messages"] == [], name
        assert facts["components"] == 1, name
        found = tuple(facts[key] for key in ("atoms", "bonds", "angles", "cycles"))
        assert found == rows[name][1:], name


@pytest.mark.parametrize("name", FILES)
def test_geometry_is_sensible(name):
    """Bonds are as long as their radii say; atoms three bonds apart or more do not touch."""
    radii = {"H": 0.31, "C": 0.76, "N": 0.71, "O": 0.66, "S": 1.05}
    elements, points = positions(name)
    answer = support_program.bonds([DATA / "molecules" / name])[0]
    assert len(elements) == len(answer["labels"])
    distances = np.linalg.norm(points[:, None] - points[None], axis=2)
    near = np.eye(len(elements), dtype=bool)
    for a, b in answer["pairs"]:
        sum_of_radii = radii[elements[a]] + radii[elements[b]]
        assert 0.8 < distances[a, b] / sum_of_radii < 1.1, answer["labels"][a]
        near[a, b] = near[b, a] = True
    apart = ~(near.astype(int) @ near.astype(int)).astype(bool)
    assert distances[apart].min(initial=np.inf) > 1.6
    assert np.abs(points.mean(axis=0)).max() < 0.01


def torsion(points):
    a, b, c = (q - p for p, q in pairwise(points))
    return np.degrees(
        np.arctan2(a @ np.cross(b, c) * np.linalg.norm(b), np.cross(a, b) @ np.cross(b, c))
    )


@pytest.mark.parametrize(
    ("name", "torsions"),
    [("cyclohexane_chair.xyz", [-60, 60] * 3), ("cyclohexane_boat.xyz", [60, 0, -60, 60, 0, -60])],
)
def test_cyclohexane_is_exact(name, torsions):
    elements, points = positions(name)
    ring = points[:6]
    assert elements[:7] == ["C"] * 6 + ["H"]
    for k in range(6):
        one, other = ring[k - 1] - ring[k], ring[(k + 1) % 6] - ring[k]
        assert np.linalg.norm(one) == pytest.approx(1.54, abs=1e-7)
        assert one @ other / 1.54**2 == pytest.approx(-1 / 3, abs=1e-7)
    found = [torsion([ring[(k + j) % 6] for j in range(4)]) for k in range(6)]
    assert sorted(np.round(found, 4)) == sorted(torsions)
    assert [abs(x) for x in np.round(found, 4)] in (
        [abs(x) for x in torsions],
        [abs(x) for x in torsions[1:] + torsions[:1]],
        [abs(x) for x in torsions[2:] + torsions[:2]],
    )


def test_c60_has_two_lengths_of_bonds():
    _, points = positions("c60.xyz")
    pairs = support_program.bonds([DATA / "molecules" / "c60.xyz"])[0]["pairs"]
    lengths = [round(float(np.linalg.norm(points[a] - points[b])), 6) for a, b in pairs]
    assert (lengths.count(1.458), lengths.count(1.401)) == (60, 30)


@pytest.mark.parametrize(
    "name", ["alanine_dipeptide.pdb", "cyclic_hexapeptide.pdb", "peptide_20.pdb"]
)
def test_amber_takes_the_peptides_as_they_are(name):
    app = pytest.importorskip("openmm.app")
    model = app.PDBFile(str(DATA / "molecules" / name))
    system = app.ForceField("amber14-all.xml", "implicit/gbn2.xml").createSystem(model.topology)
    assert system.getNumParticles() == len(positions(name)[0])


def test_the_long_peptide_has_each_amino_acid_once():
    text = (DATA / "molecules" / "peptide_20.pdb").read_text()
    residues = re.findall(r"^ATOM +\d+ +CA +(\w{3})", text, flags=re.MULTILINE)
    assert len(residues) == len(set(residues)) == 20


@pytest.mark.long
def test_the_script_makes_the_files_again(tmp_path):
    rdkit = pytest.importorskip("rdkit")
    if f"RDKit {rdkit.__version__}." not in README:
        pytest.skip("the committed files are of another version of RDKit")
    subprocess.run([sys.executable, DATA / "make_molecules.py", tmp_path], check=True)
    assert sorted(path.name for path in tmp_path.iterdir()) == FILES
    number = re.compile(r"-?\d+\.\d+")
    for name in FILES:
        new, old = (tmp_path / name).read_text(), (DATA / "molecules" / name).read_text()
        if new == old:
            continue
        # Another processor rounds otherwise: the last digits may differ, nothing else.
        assert number.sub("", new).split() == number.sub("", old).split(), name
        both = [np.array(number.findall(text), dtype=float) for text in (new, old)]
        assert np.abs(both[0] - both[1]).max() < 0.01, name


#: with which the page begins
PROTEIN = DATA / "proteins" / "three_helices.pdb"


def test_the_protein_of_the_page_is_three_whole_helices_by_dssp():
    mda = pytest.importorskip("MDAnalysis")
    dssp = pytest.importorskip("MDAnalysis.analysis.dssp")
    found = "".join(dssp.DSSP(mda.Universe(str(PROTEIN))).run().results.dssp[0])
    assert [len(part) for part in found.split("-") if part] == [14, 14, 15]


def test_bonds_of_that_protein_are_whole_and_nothing_is_too_near():
    radii = {"H": 0.31, "C": 0.76, "N": 0.71, "O": 0.66}
    lines = [line for line in PROTEIN.read_text().splitlines() if line.startswith("ATOM")]
    points = np.array([[float(line[k : k + 8]) for k in (30, 38, 46)] for line in lines])
    reach = np.array([radii[line[76:78].strip()] for line in lines])
    sums = reach[:, None] + reach
    far = np.linalg.norm(points[:, None] - points[None], axis=2)
    same = np.eye(len(lines), dtype=bool)
    bonded = (far < 1.25 * sums) & ~same
    assert len(lines) == 901
    assert bonded.sum() // 2 == 906  # a tree has 900; and 2 prolines, PHE, TYR, TRP twice
    assert np.abs((far / sums)[bonded] - 0.95).max() < 0.1
    near = bonded.astype(int) @ bonded.astype(int) > 0
    assert far[~(near | bonded | same)].min() > 1.9
