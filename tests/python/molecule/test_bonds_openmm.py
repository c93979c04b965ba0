# SPDX-License-Identifier: MIT
"""Bonds of PDB and mmCIF files against OpenMM's, which come from its templates and CONECT."""

import gzip
import os
from pathlib import Path

import pytest
import support_program

pytest.importorskip("openmm")
pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests
from openmm import app
from real_files import unpacked_bytes

# OpenMM reports every alternate location.
pytestmark = pytest.mark.filterwarnings("ignore:WARNING")

OPENMM = Path(app.__file__).parent / "data"
MDA = Path(MDAnalysisTests.__file__).parent / "data"

# Proteins, nucleic acids, ligands and water; X-ray, NMR and simulation; with and without hydrogens.
STRUCTURES = [
    "adk_closed.pdb",
    "adk_open.pdb",
    "adk_open_10res.pdb",
    "cobrotoxin.pdb",
    "nmr_neopetrosiamide.pdb",
    "A6PA6_alpha.pdb",
    "1a28.pdb.gz",
    "19hc.pdb.gz",
    "1hvr.pdb",
    "1osm.pdb.gz",
    "4E43.pdb",
    "merge/2zmm/protein.pdb",
    "mmcif/3PWP.pdb.gz",
    "capping/ace.pdb",
    "capping/nma.pdb",
    "capping/maestro_aaqaa_capped.pdb",
    "fullerene.pdb.gz",
    "4x8u.pdbx",
    "mmcif/1YJP.cif.gz",
    "mmcif/3KPR.cif.gz",
    "mmcif/3PWP.cif.gz",
    "mmcif/7ETN.cif.gz",
    *sorted(f"dssp/{name}" for name in os.listdir(MDA / "dssp") if name.endswith("A.pdb.gz")),
]

GAP = "OpenMM bonds residues that follow each other in the file, however far apart"
UNKNOWN = "OpenMM has no template for this residue and the file no CONECT"
METAL = "CONECT states it; to another residue it is coordination and no bond"
CHARMM = "CHARMM's names: OpenMM takes H2' for the hydrogen of C2'; in RNA it is the hydroxyl's"
DEUTERIUM = "OpenMM's templates have no names for deuterium"
EXTRA = "the residue has a third hydrogen on CB, which OpenMM's names do not foresee"

# {file: {reason: number of differences}}. Each difference must be one that its reason explains.
KNOWN_DIFFERENCES = {
    "5a7u.pdb": {EXTRA: 1},
    "6msm.pdb.bz2": {METAL: 4, GAP: 4},
    "mmcif/1BD2.pdb.gz": {GAP: 2},
    "mmcif/1BD2.cif.gz": {GAP: 2},
    "mmcif/5PTI.cif.gz": {DEUTERIUM: 103},
    "1grm_single.pdb": {UNKNOWN: 8},
    "elements.pdb": {UNKNOWN: 6},
    "analysis/1k5i_c36.pdb.gz": {CHARMM: 69},
}


def is_mmcif(path):
    return not {".cif", ".pdbx"}.isdisjoint(path.suffixes)


class Comparison:
    """Ours and OpenMM's bonds of one file."""

    def __init__(self, path, answer):
        with gzip.open(path, "rt") if path.suffix == ".gz" else open(path) as file:
            model = (app.PDBxFile if is_mmcif(path) else app.PDBFile)(file)
        self.atoms = list(model.topology.atoms())
        self.positions = model.getPositions(asNumpy=True)._value * 10
        self.labels = answer["labels"]
        self.ours = answer["pairs"]
        ends = [(a.index, b.index) for a, b in model.topology.bonds()]
        self.theirs = {(min(pair), max(pair)) for pair in ends}
        assert len(self.labels) == len(self.atoms), path

    def differences(self):
        return support_program.differences(self.labels, self.ours, self.theirs)

    def explains(self, reason, a, b):
        """Whether a reason holds for a bond that only one of the two has."""
        one, other = self.atoms[a], self.atoms[b]
        length = sum((self.positions[a] - self.positions[b]) ** 2) ** 0.5
        elements = {one.element.symbol, other.element.symbol}
        if (a, b) in self.theirs:
            is_link = one.residue != other.residue
            return {
                METAL: is_link and "Mg" in elements and length < 3.0,
                GAP: length > 2.0 and is_link and one.name == "C" and other.name == "N",
                CHARMM: one.name in ("C2'", "O2'") and other.name in ("H2'", "H2''"),
            }.get(reason, False)
        return {
            UNKNOWN: bool({one.residue.name, other.residue.name} & {"ETA", "DMS"}) and length < 2.0,
            CHARMM: length < 1.2 and "H" in elements,
            DEUTERIUM: length < 1.2 and "D" in {one.name[0], other.name[0]},
            EXTRA: length < 1.2 and one.name == "CB" and "H" in elements,
        }.get(reason, False)


def unpacked(name, folder):
    """The path of a file that both of us read: OpenMM does not read bz2."""
    path = MDA / name
    if path.suffix != ".bz2":
        return path
    import bz2

    target = folder / path.stem
    target.write_bytes(bz2.decompress(path.read_bytes()))
    return target


def compare(path):
    return Comparison(path, support_program.bonds([path])[0])


MOST_BYTES = 1_000_000  # of the text of files that every change is tested with


def by_size(folder, names):
    """Names as parameters; those of large files are for the long tests."""
    return [
        pytest.param(
            name, marks=pytest.mark.long if unpacked_bytes(folder / name) > MOST_BYTES else ()
        )
        for name in names
    ]


OPENMM_FILES = sorted(str(path.relative_to(OPENMM)) for path in OPENMM.glob("**/*.pdb"))


def test_there_are_files_to_compare():
    assert len(OPENMM_FILES) >= 10
    assert len(STRUCTURES) > 50


@pytest.mark.parametrize("name", by_size(OPENMM, OPENMM_FILES))
def test_bonds_equal_openmms_for_every_pdb_file_of_openmm(name):
    one = compare(OPENMM / name)
    assert one.ours
    assert one.differences() == []


@pytest.mark.parametrize("name", by_size(MDA, STRUCTURES))
def test_bonds_equal_openmms_for_structures_of_mdanalysis(name):
    one = compare(MDA / name)
    assert one.ours
    assert one.differences() == []


@pytest.mark.parametrize("name", KNOWN_DIFFERENCES)
def test_bonds_differ_from_openmms_only_for_known_reasons(name, tmp_path):
    one = compare(unpacked(name, tmp_path))
    counts = dict.fromkeys(KNOWN_DIFFERENCES[name], 0)
    unexplained = []
    for a, b in sorted(one.ours ^ one.theirs):
        reasons = [reason for reason in counts if one.explains(reason, a, b)]
        if reasons:
            counts[reasons[0]] += 1
        else:
            unexplained.append(f"{one.labels[a]} - {one.labels[b]}")
    assert unexplained == []
    assert counts == KNOWN_DIFFERENCES[name]


def test_hydrogens_do_not_matter_for_the_other_bonds(tmp_path):
    """The same protein without its hydrogens has the same bonds between its other atoms."""
    lines = (MDA / "cobrotoxin.pdb").read_text().splitlines()
    full = tmp_path / "full.pdb"
    bare = tmp_path / "bare.pdb"
    atoms = [line for line in lines if line.startswith(("ATOM", "HETATM"))]
    protein = [line for line in atoms if line[17:20] not in ("SOL", "HOH", " NA", " CL")]
    is_hydrogen = [line[12:16].strip().lstrip("123").startswith("H") for line in protein]
    heavy = [line for line, h in zip(protein, is_hydrogen, strict=True) if not h]
    full.write_text("\n".join(protein))
    bare.write_text("\n".join(heavy))
    with_hydrogens, without = support_program.bonds([full, bare])
    kept = [i for i, h in enumerate(is_hydrogen) if not h]
    place = {atom: k for k, atom in enumerate(kept)}
    expected = {(place[a], place[b]) for a, b in with_hydrogens["pairs"] if {a, b} <= place.keys()}
    assert len(without["labels"]) == len(heavy) < len(protein)
    assert without["pairs"] == expected
    assert without["pairs"] == Comparison(bare, without).theirs
