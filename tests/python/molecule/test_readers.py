# SPDX-License-Identifier: MIT
"""What Pliant reads against gemmi, MDAnalysis and RDKit: every atom of the same files.

Coordinates are compared bit for bit (in single precision with MDAnalysis). A difference must be one
that its reason explains, and the reasons of each file are counted: one that is not needed any more
fails, too.
"""

from collections import Counter
from pathlib import Path

import pytest
import read_by_others
from real_files import unpacked_bytes
from support_program import ROOT

pytest.importorskip("gemmi")
pytest.importorskip("openmm")
pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests
import openmm.app

OPENMM = Path(openmm.app.__file__).parent / "data"
MDA = Path(MDAnalysisTests.__file__).parent / "data"
ENDINGS = (".pdb", ".pdb.gz", ".ent", ".pdbx", ".cif", ".cif.gz")
REFUSED = {"cryst_then_model.pdb.gz": "a tar archive", "model_then_cryst.pdb.gz": "a tar archive"}
GEMMI_REFUSES = {
    "incomplete.pdb": "two models of one number",
    "varying_occ_tmp.pdb": "a MODEL record inside a model",
}
MDANALYSIS_REFUSES = {
    "mmcif/1YJP_invalid.cif.gz": "a loop that is no atoms",
    "4x8u.pdbx": "the extension",
}
LARGE = 300_000  # bytes; MDAnalysis takes its time
LONG = 1_000_000  # bytes of the text of a file that is left to the long tests


def molecule_files(folder):
    found = (path for path in folder.rglob("*") if path.name.endswith(ENDINGS))
    return sorted(str(path.relative_to(folder)) for path in found)


FILES = {name: OPENMM / name for name in molecule_files(OPENMM)}
FILES |= {name: MDA / name for name in molecule_files(MDA) if name not in REFUSED}

ION = "an atom named like its residue is an ion; gemmi goes by the column that its name begins in"
COLUMN_13 = (
    "an atom of a file that begins all names in column 13: its second letter is no element's"
)
FOUR_LETTERS = "a residue name of four letters reaches over the column of the chain"
FIVE_DIGITS = "a residue number of five digits reaches into the insertion code"
SOLV = "MDAnalysis takes the chain for the fourth letter of the residue name"
CONFORMER = "left out: an alternate location that is not used"
TWICE = "left out: given twice at one point"

# {file: {reason: number of differing fields, or of atoms left out}}
FROM_GEMMI = {
    "test.pdb": {ION: 2},
    "5digitResid.pdb": {FOUR_LETTERS: 10, FIVE_DIGITS: 2},
    "RANDOM_WALK_TOPO.pdb": {FOUR_LETTERS: 200},
    "adk_closed.pdb": {COLUMN_13: 2311},
    "adk_open.pdb": {COLUMN_13: 2311},
    "adk_open_10res.pdb": {COLUMN_13: 101},
    "adk_oplsaa.pdb": {ION: 4},
    "analysis/1k5i_c36.pdb.gz": {FOUR_LETTERS: 34332, ION: 22},
    "cobrotoxin.pdb": {ION: 19},
    "coordinates/test_topology.pdb": {COLUMN_13: 5},
    "cryst_then_model.pdb": {FOUR_LETTERS: 8},
    "gromos11/gromos11_traj_solv.pdb.gz": {FOUR_LETTERS: 26, ION: 2},
    "gromos11/gromos11_traj_vac.pdb.gz": {FOUR_LETTERS: 26, ION: 2},
    "model_then_cryst.pdb": {FOUR_LETTERS: 8},
    "nucl_res.pdb": {COLUMN_13: 39},
    "pdbqt_querypdb.pdb": {ION: 1},
    "sameresid_diffresname.pdb": {FOUR_LETTERS: 2},
    "xl_serial.pdb": {FOUR_LETTERS: 8},
}
FROM_MDANALYSIS = {
    "5digitResid.pdb": {FIVE_DIGITS: 2},
    "gromos11/gromos11_traj_solv.pdb.gz": {SOLV: 5448},
}
LEFT_OUT = {
    "19hc.pdb.gz": {CONFORMER: 77},
    "4E43.pdb": {CONFORMER: 34},
    "mmcif/3PWP.cif.gz": {CONFORMER: 6},
    "mmcif/3PWP.pdb.gz": {CONFORMER: 6},
    "mmcif/5PTI.cif.gz": {CONFORMER: 17},
    "conect_parsing.pdb": {TWICE: 9},
}
# Of these many side chains are in the file two times, or more.
TWICE_IN_DSSP = {
    "1h4aX": 29, "1or4A": 4, "1pdoA": 378, "2a2lA": 360, "2cayA": 425, "2fvvA": 53, "2gu3A": 7,
    "2xcjA": 3, "2xr6A": 78, "3a4rA": 11, "3e8mA": 39, "3ejfA": 19, "3fhkA": 7, "3ii2A": 20,
    "3k7pA": 452, "3l4rA": 28, "3lqcA": 2, "3nbkA": 918, "3on9A": 7, "3q4oA": 558, "3so6A": 24,
    "4gcnA": 22,
}  # fmt: skip  # some pairs a line
LEFT_OUT |= {f"dssp/{name}.pdb.gz": {TWICE: count} for name, count in TWICE_IN_DSSP.items()}

# Ions whose names are no symbols (CHARMM).
SYMBOLS = {"SOD": "NA", "POT": "K", "CLA": "CL"}
FIELDS = ("element", "residue", "number", "insertion", "chain")


def is_ion(atom):
    symbol = SYMBOLS.get(atom.name, atom.name).upper()
    residue = atom.residue.upper().rstrip("+-")
    element = read_by_others.number_of(symbol.capitalize())
    return symbol == SYMBOLS.get(residue, residue) and element == atom.element


def reasons(field, mine, theirs):
    """What explains a difference in one field of one atom."""
    if field == "element":
        if is_ion(mine):
            yield ION
        two_letters = read_by_others.number_of(mine.name[:2].capitalize()) or 0
        one_letter = read_by_others.number_of(mine.name[0])
        if (mine.element, theirs.element) == (one_letter, two_letters):
            yield COLUMN_13
    if field in ("residue", "chain"):
        if len(mine.residue) == 4 and mine.residue + mine.chain == theirs.residue + theirs.chain:
            yield FOUR_LETTERS
        if theirs.residue == mine.residue + mine.chain and theirs.chain == "":
            yield SOLV
    if field in ("number", "insertion") and f"{theirs.number}{theirs.insertion}" == str(
        mine.number
    ):
        yield FIVE_DIGITS


class Comparison:
    """Our atoms and another reader's: the same places and names, then field by field."""

    def __init__(self, mine, theirs, single):
        self.counts = Counter()
        self.unexplained = []
        self.places = {}
        self.mine = {atom.key(single) for atom in mine}
        for atom in theirs:
            self.places.setdefault(atom.key(single), []).append(atom)
        for atom in mine:
            others = self.places.get(atom.key(single))
            if others:
                self.compare(atom, others.pop(0))
            else:
                self.unexplained.append(("ours alone", atom))
        for key, others in self.places.items():
            for atom in others:
                self.take_left_out(key, atom)

    def compare(self, mine, theirs):
        for field in FIELDS:
            stated = getattr(theirs, field)
            if stated is None or stated == getattr(mine, field):
                continue
            found = next(reasons(field, mine, theirs), None)
            if found is None:
                self.unexplained.append((field, mine, theirs))
            self.counts[found] += 1

    def take_left_out(self, key, atom):
        if atom.conformer.strip():
            self.counts[CONFORMER] += 1
        elif key in self.mine:
            self.counts[TWICE] += 1
        else:
            self.unexplained.append(("theirs alone", atom))


def assert_same(path, theirs, known, single=False):
    one = Comparison(read_by_others.ours(path), theirs, single)
    assert one.unexplained == []
    assert dict(one.counts) == known


def test_there_are_many_files():
    assert len([name for name in FILES if FILES[name].is_relative_to(OPENMM)]) >= 13
    assert len(FILES) >= 130
    for names in (FROM_GEMMI, FROM_MDANALYSIS, LEFT_OUT, GEMMI_REFUSES, MDANALYSIS_REFUSES):
        assert names.keys() <= FILES.keys()


def by_size(names):
    """Names as parameters; those of large files are for the long tests."""
    return [
        pytest.param(name, marks=pytest.mark.long if unpacked_bytes(FILES[name]) > LONG else ())
        for name in names
    ]


@pytest.mark.parametrize("name", by_size(name for name in FILES if name not in GEMMI_REFUSES))
def test_atoms_are_gemmis(name):
    known = LEFT_OUT.get(name, {}) | FROM_GEMMI.get(name, {})
    assert_same(FILES[name], read_by_others.gemmis(FILES[name]), known)


SMALL = [name for name, path in FILES.items() if path.stat().st_size < LARGE]


@pytest.mark.parametrize("name", by_size(name for name in SMALL if name not in MDANALYSIS_REFUSES))
def test_atoms_are_those_of_mdanalysis(name):
    known = LEFT_OUT.get(name, {}) | FROM_MDANALYSIS.get(name, {})
    assert_same(FILES[name], read_by_others.mdanalysis(FILES[name]), known, single=True)


@pytest.mark.parametrize("name", GEMMI_REFUSES)
def test_what_gemmi_refuses(name):
    with pytest.raises((RuntimeError, ValueError)):
        read_by_others.gemmis(FILES[name])


MOLECULES = sorted((ROOT / "data/molecules").iterdir())


def same_places(path, theirs, single):
    mine = read_by_others.ours(path)
    assert [atom.key(single)[0] for atom in mine] == [atom.key(single)[0] for atom in theirs]
    assert [atom.element for atom in mine] == [atom.element for atom in theirs]


@pytest.mark.parametrize(
    "path", [path for path in MOLECULES if path.suffix in (".sdf", ".mol", ".xyz")], ids=str
)
def test_molecules_of_data_are_rdkits(path):
    pytest.importorskip("rdkit")
    same_places(path, read_by_others.rdkits(path), single=False)


@pytest.mark.parametrize("path", [p for p in MOLECULES if p.suffix == ".xyz"], ids=str)
def test_xyz_molecules_of_data_are_those_of_mdanalysis(path):
    same_places(path, read_by_others.mdanalysis(path), single=True)


@pytest.mark.parametrize("path", [p for p in MOLECULES if p.suffix in (".pdb", ".cif")], ids=str)
def test_pdb_and_mmcif_molecules_of_data_are_gemmis_and_those_of_mdanalysis(path):
    assert_same(path, read_by_others.gemmis(path), {})
    assert_same(path, read_by_others.mdanalysis(path), {}, single=True)
