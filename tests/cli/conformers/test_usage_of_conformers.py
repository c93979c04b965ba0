# SPDX-License-Identifier: MIT
"""pliant conformers: wrong calls; what pliant sample hands over; one ligand; no RDKit."""

import gzip
import os

import pytest
from real_files import CAFFEINE

pytest.importorskip("rdkit")
from libraries import embedded, molecules
from rdkit import Chem

FAST = ("--frames", 20, "--starts", 1)

HIDE = """\
import sys
class Hidden:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] == "rdkit":
            raise ModuleNotFoundError("No module named 'rdkit'", name=name)
sys.meta_path.insert(0, Hidden())
"""


@pytest.fixture
def two(tmp_path):
    path = tmp_path / "two.sdf"
    path.write_text(2 * (CAFFEINE.read_text().split("$$$$")[0].rstrip("\n") + "\n$$$$\n"))
    return path


@pytest.mark.parametrize(
    ("words", "error"),
    [
        ("", "expected FILE or --smiles TEXT, or --continue FILE"),
        ("x.sdf --smiles C", "--smiles: goes with a PDB, mmCIF or XYZ file of one ligand"),
        ("--smiles C", "--smiles: needs --output FILE.sdf"),
        ("{} --window -1", "window = -1: must be positive and finite"),
        ("{} --energy none --window 2", "--window: needs an energy, not --energy none"),
        (
            "{} --energy GAFF",
            "--energy: expected auto, none, MMFF94s, UFF, own, GFN2 or a force field of "
            "OpenMM (.xml), found 'GAFF'",
        ),
        (
            "{} --energy none --minimise",
            "--minimise: needs MMFF94s, UFF or a force field, not --energy none",
        ),
        ("{} -o out.h5md", "--output out.h5md: expected a name that ends in .sdf or .sdf.gz"),
        ("{} --max 0", "-n/--max: expected a whole number from 1, found '0'"),
        ("{} --shard 4/3", "--shard: expected i/n with i from 1 to n, found '4/3'"),
        (
            "{} --max-input 0",
            "--max-input: expected a whole number from 1 to 1000000000, found '0'",
        ),
        ("{} --select name", "--select: goes with a PDB, mmCIF or XYZ file of one ligand"),
        ("lost.smi --keep GOL", "--keep: goes with a PDB, mmCIF or XYZ file of one ligand"),
        (
            "--smiles C -o x.sdf --no-distance-bonds",
            "--no-distance-bonds: goes with a PDB, mmCIF or XYZ file of one ligand",
        ),
        ("x.pdb --contacts c.csv", "unrecognized arguments: --contacts c.csv"),
        (
            "--continue out.sdf --max-input 3",
            "--max-input: --continue goes on with what was asked for before",
        ),
        ("--continue out.sdf --max 3", "--max: --continue goes on with what was asked for before"),
    ],
)
def test_wrong_options_are_named(pliant, words, error):
    ended = pliant("conformers", *(word.format(CAFFEINE) for word in words.split()))
    assert ended.code == 2
    assert ended.err.splitlines()[0] == f"pliant conformers: error: {error}"
    assert ended.out == ""


@pytest.mark.parametrize(
    ("smiles", "error"),
    [
        ("", "SMILES '': expected a molecule, RDKit cannot read it"),
        (" ", "SMILES ' ': expected a molecule, RDKit cannot read it"),
        ("C1CC", "SMILES 'C1CC': expected a molecule, RDKit cannot read it"),
        ("CC\nCC", "SMILES 'CC\\nCC': expected one word, found 2"),
        ("CCO ethanol", "SMILES 'CCO ethanol': expected one word, found 2"),
        (
            30_000 * "C",
            "SMILES 'CCCCCCCCCCCC...CCCCCCCCCCCCC': expected at most 20000 letters, found 30000",
        ),
    ],
)
def test_a_smiles_is_one_word(pliant, tmp_path, smiles, error):
    ended = pliant("conformers", "--smiles", smiles, "-o", "out.sdf")
    assert (ended.code, ended.out) == (2, "")
    assert ended.err == f"pliant conformers: error: --smiles: {error}\n"


def test_long_names_are_short_in_messages(pliant, tmp_path):
    ended = pliant("conformers", "--smiles", 200 * "C", "-o", "out.sdf")
    assert ended.code == 1
    assert ended.err.splitlines()[0] == (
        f"warning: record 1 ({60 * 'C'}...): expected at most 500 atoms to make 3-D, hydrogens "
        "included, found 602"
    )
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("words", "error"),
    [
        ("none.sdf", "none.sdf: No such file or directory"),
        (
            "x.gro",
            "x.gro: expected SDF, MOL, SMILES, PDB, mmCIF or XYZ (.sdf, .mol, .smi, .pdb, .cif, "
            ".xyz, each also .gz, .bz2, .xz)",
        ),
        ("empty.sdf", "empty.sdf: holds no record"),
        (
            "cut.sdf.gz",
            "cut.sdf.gz: its compression is damaged: Compressed file ended before the "
            "end-of-stream marker was reached",
        ),
        (
            "torn.sdf.gz",
            "torn.sdf.gz: its compression is damaged: Error -3 while decompressing data: invalid "
            "block type",
        ),
        ("pipe.sdf", "pipe.sdf: is a pipe, not a file"),
        (
            "large.sdf --max-input 1",
            "large.sdf: holds more than 1 MB, the most that is read; --max-input allows more",
        ),
        (
            "large.sdf.gz --max-input 1 --shard 1/3",
            "large.sdf.gz: holds more than 1 MB, the most that is read; --max-input allows more",
        ),
        ("two.sdf --shard 3/3", "two.sdf: holds no record in shard 3/3"),
        ("two.sdf -o there.sdf", "there.sdf: exists; --overwrite replaces it"),
        ("two.sdf -o no/out.sdf", "--output no/out.sdf: there is no folder no"),
        ("two.sdf --energy no.xml", "--energy no.xml: there is no such file"),
        ("--continue other.sdf", "other.sdf: nothing to continue: there is no such run"),
    ],
)
def test_files_that_cannot_be_used(pliant, two, tmp_path, words, error):
    (tmp_path / "empty.sdf").write_text("\n\n")
    (tmp_path / "there.sdf").write_text("")
    packed = gzip.compress(two.read_bytes())
    (tmp_path / "cut.sdf.gz").write_bytes(packed[:-20])
    (tmp_path / "torn.sdf.gz").write_bytes(packed[:10] + b"\xff" + packed[11:])
    (tmp_path / "large.sdf").write_text(two.read_text() + 1_000_000 * "\n")
    (tmp_path / "large.sdf.gz").write_bytes(gzip.compress((tmp_path / "large.sdf").read_bytes()))
    os.mkfifo(tmp_path / "pipe.sdf")
    before = sorted(tmp_path.iterdir())
    ended = pliant("conformers", *words.split())
    assert (ended.code, ended.err) == (1, f"pliant conformers: error: {error}\n")
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (
            "two.sdf",
            "two.sdf: holds 2 molecules: pliant conformers makes conformers of all; "
            "--frame N takes one",
        ),
        (
            "one.sdf -o out.sdf",
            "--output out.sdf: pliant conformers writes SDF, ranked by energy; "
            "--sampler torsions writes all frames of one molecule",
        ),
    ],
)
def test_sample_leaves_libraries_and_ranking_to_conformers(pliant, two, tmp_path, words, error):
    (tmp_path / "one.sdf").write_bytes(CAFFEINE.read_bytes())
    before = sorted(tmp_path.iterdir())
    ended = pliant("sample", *words.split(), "--frames", 2)
    assert (ended.code, ended.err.splitlines()[-1]) == (2, f"pliant: error: {error}")
    assert sorted(tmp_path.iterdir()) == before
    assert pliant("sample", "two.sdf", "--frame", 2, "--frames", 2).code == 0


@pytest.fixture
def without_rdkit(pliant, tmp_path):
    """pliant where RDKit is not installed."""
    (tmp_path / "hidden").mkdir()
    (tmp_path / "hidden" / "sitecustomize.py").write_text(HIDE)
    paths = [str(tmp_path / "hidden"), os.environ.get("PYTHONPATH", "")]
    env = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths))}
    return lambda *words: pliant(*words, env=env)


def test_three_dimensional_sdf_needs_no_rdkit(without_rdkit, two, tmp_path):
    ended = without_rdkit("conformers", two, "-o", "out.sdf", *FAST, "--threads", 2)
    assert (ended.code, ended.err) == (0, "")
    assert "\nenergy      Pliant's own energy, kcal/mol\n" in ended.out
    assert (tmp_path / "out.sdf").read_text().count("$$$$") == 2


def test_missing_hydrogens_need_rdkit(without_rdkit, two, tmp_path):
    lines = CAFFEINE.read_text().split("$$$$")[0].splitlines(keepends=True)
    atoms, bonds = int(lines[3][:3]), int(lines[3][3:6])
    del lines[3 + atoms + bonds], lines[3 + atoms]  # the last hydrogen, and its bond
    lines[3] = f"{atoms - 1:3d}{bonds - 1:3d}{lines[3][6:]}"
    (tmp_path / "part.sdf").write_text("".join(lines))
    ended = without_rdkit("conformers", "part.sdf", "-o", "out.sdf", *FAST)
    assert ended.code == 1
    assert ended.err.splitlines()[0] == (
        "warning: record 1 (caffeine): adding missing hydrogens (1 to C14) needs RDKit: pip "
        'install "pliant[rdkit]"'
    )


@pytest.mark.parametrize(
    ("words", "what"),
    [
        ("conformers --smiles CCO -o out.sdf", "a SMILES"),
        ("conformers some.smi -o out.sdf", "a SMILES"),
        ("conformers two.sdf --embed", "--embed"),
        ("conformers two.sdf --energy UFF", "--energy UFF"),
        ("conformers two.sdf --energy auto --minimise", "--minimise"),
    ],
)
def test_what_needs_rdkit_says_how_to_install_it(without_rdkit, two, tmp_path, words, what):
    (tmp_path / "some.smi").write_text("CCO\n")
    ended = without_rdkit(*words.split())
    assert ended.code == 2
    assert ended.err == (
        f'pliant conformers: error: {what} needs RDKit: pip install "pliant[rdkit]"\n'
    )


def test_the_file_of_one_ligand(pliant, tmp_path):
    alanine = Chem.RemoveHs(embedded("C[C@H](N)C(=O)O"))
    (tmp_path / "ligand.pdb").write_text(Chem.MolToPDBBlock(alanine, flavor=8))
    ended = pliant("conformers", "ligand.pdb", *FAST)
    assert (ended.code, ended.out) == (1, "")
    assert ended.err == (
        "warning: record 1 (ligand): the ligand has no hydrogens, and its bond orders are not "
        "known: pliant conformers FILE --smiles TEXT gives both\n"
        "pliant conformers: error: no record gave a conformer\n"
    )
    ended = pliant("conformers", "ligand.pdb", "--smiles", "C[C@H](N)C(=O)O", *FAST)
    assert (ended.code, ended.err) == (0, "")
    made = molecules(tmp_path / "ligand-conformers.sdf")
    assert {Chem.MolToSmiles(Chem.RemoveHs(one)) for one in made} == {"C[C@H](N)C(=O)O"}
    assert {one.GetProp("_Name") for one in made} == {"ligand"}
