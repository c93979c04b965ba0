# SPDX-License-Identifier: MIT
"""How far frames of pliant sample go: as given, as B factors say, as an ensemble of the user's."""

import json

import h5py
import numpy as np
import pytest

LINE = "ATOM  {:5d} {:<4s} ALA {:s}{:4d}    {:8.3f}{:8.3f}{:8.3f}  1.00{:6.2f}          {:>2s}"
#: an alanine of a helix: N, CA, C, O, CB (Angstrom)
RESIDUE = {
    "N": (1.357, -0.757, -0.796),
    "CA": (2.28, 0.0, 0.0),
    "C": (1.63, 0.35, 1.33),
    "O": (1.65, 1.53, 1.72),
    "CB": (2.72, 1.26, -0.72),
}
COUNT = 14


def helix(shift=None):
    """(COUNT, 5, 3) positions of a helix of alanines; shift: (COUNT, 3) of whole residues."""
    out = []
    for k in range(COUNT):
        turn = np.radians(100.0) * k
        c, s = np.cos(turn), np.sin(turn)
        rotation = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        out.append(np.array(list(RESIDUE.values())) @ rotation.T + [0, 0, 1.5 * k])
    places = np.array(out)
    return places if shift is None else places + shift[:, None]


def pdb(models, b_of=lambda residue, name: 10.0, first=1, chain="A"):
    lines = []
    for number, places in enumerate(models, start=1):
        lines.append(f"MODEL     {number:4d}")
        serial = 0
        for k in range(len(places)):
            for name, place in zip(RESIDUE, places[k], strict=True):
                serial += 1
                lines.append(
                    LINE.format(
                        serial, f" {name}", chain, k + first, *place, b_of(k, name), name[0]
                    )
                )
        lines.append("ENDMDL")
    return "\n".join([*lines, "END", ""])


def uneven(residue, name):
    """B factors that differ within residues."""
    return 30.0 + 2.0 * residue + (name == "CA")


def ensemble(frames, seed=1):
    """Frames of the helix, whole residues of which are shifted at random, then all of it turned."""
    rng = np.random.default_rng(seed)
    out = []
    for _ in range(frames):
        q = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        q *= np.linalg.det(q)
        out.append(np.round(helix(rng.normal(scale=0.6, size=(COUNT, 3))) @ q.T + 4, 3))
    return np.array(out)


def mean_rmsf(frames):
    """By numpy, frames (F, n, 3) superposed on their mean (Kabsch)."""
    mean = frames[0]
    for _ in range(30):
        moved = []
        for frame in frames:
            x, y = frame - frame.mean(axis=0), mean - mean.mean(axis=0)
            u, _, vt = np.linalg.svd(x.T @ y)
            u[:, 2] *= np.sign(np.linalg.det(u @ vt))
            moved.append(x @ u @ vt)
        mean = np.mean(moved, axis=0)
    return np.sqrt(((moved - mean) ** 2).sum(axis=2).mean(axis=0)).mean()


@pytest.fixture
def start(tmp_path):
    (tmp_path / "start.pdb").write_text(
        pdb([helix()], lambda k, name: 5.0 + 2.0 * k + (name == "CA"))
    )
    return "start.pdb"


def asked(pliant, start, *words):
    ended = pliant(
        "sample", start, "-o", "out.h5md", "--frames", 2, "--json", "--overwrite", *words
    )
    assert ended.code == 0, ended.err
    return json.loads(ended.out)


def test_it_is_as_b_factors_say(pliant, start, tmp_path):
    report = asked(pliant, start, "--amplitude", "bfactors")
    b = 6.0 + 2.0 * np.arange(COUNT)
    expected = np.sqrt(3 * b / (8 * np.pi**2)).mean()
    assert report["amplitude_asked"] == pytest.approx(expected, rel=1e-6)
    assert report["amplitude_from"] == "bfactors"
    assert report["amplitude_reason"] == "B factors of 14 residues, mean 19 A^2"
    assert any("B factors, which contain disorder of the crystal" in w for w in report["warnings"])
    with h5py.File(tmp_path / "out.h5md") as file:
        assert file["parameters/sample/amplitude"][()] == pytest.approx(expected, rel=1e-6)
        assert file["parameters/sample/amplitude_from"][()] == b"bfactors"


@pytest.mark.parametrize(("first", "chain"), [(1, "A"), (1, "B")])
def test_it_is_as_far_as_an_ensemble_goes(pliant, start, tmp_path, first, chain):
    frames = ensemble(25)
    (tmp_path / "nmr.pdb").write_text(pdb(frames, first=first, chain=chain))
    report = asked(pliant, start, "--amplitude", "nmr.pdb")
    assert report["amplitude_asked"] == pytest.approx(mean_rmsf(frames[:, :, 1]), rel=1e-5)
    assert report["amplitude_reason"] == (
        "25 models of nmr.pdb, mean RMSF of 14 of 14 residues, superposed"
    )


def test_a_trajectory_of_ours_is_an_ensemble(pliant, start, tmp_path):
    ended = pliant(
        "sample", start, "-o", "first.h5md", "--frames", 30, "--amplitude", 0.5, "--json"
    )
    reached = json.loads(ended.out)["amplitude_reached"]
    report = asked(pliant, start, "--amplitude", "first.h5md")
    with h5py.File(tmp_path / "first.h5md") as file:
        names = file["parameters/topology/atom_name"].asstr()[:]
        positions = file["particles/trajectory/position/value"][:][:, names == "CA"]
    assert report["amplitude_asked"] == pytest.approx(mean_rmsf(positions), rel=1e-5)
    assert reached == pytest.approx(report["amplitude_asked"], rel=0.01)


def test_what_cannot_be_an_amplitude_is_refused(pliant, start, tmp_path):
    (tmp_path / "equal.pdb").write_text(pdb([helix()]))
    (tmp_path / "zero.pdb").write_text(pdb([helix()], lambda *_: 0.0))
    (tmp_path / "alphafold.pdb").write_text(pdb([helix()], lambda k, _: 60.0 + k))
    (tmp_path / "title.pdb").write_text(
        "TITLE     ALPHAFOLD MONOMER V2.0 PREDICTION FOR A HELIX\n" + pdb([helix()], uneven)
    )
    (tmp_path / "model.pdb").write_text("EXPDTA    THEORETICAL MODEL\n" + pdb([helix()], uneven))
    end = "; give a number (Angstrom) or a file of models"
    cases = [
        ("equal.pdb", "bfactors", "amplitude bfactors: all B factors are 10" + end),
        ("zero.pdb", "bfactors", "amplitude bfactors: all B factors are 0" + end),
        ("alphafold.pdb", "bfactors", "amplitude bfactors: the B factors look like confidences "
         "(pLDDT): one value a residue, none above 100, and the file names no experiment (EXPDTA, "
         "_exptl.method)" + end),
        ("title.pdb", "bfactors", "amplitude bfactors: the file says that they are confidences "
         "such as pLDDT (title ALPHAFOLD MONOMER V2.0 PREDICTION FOR A HELIX)" + end),
        ("model.pdb", "bfactors", "amplitude bfactors: the file says that it is a theoretical "
         "model (EXPDTA THEORETICAL MODEL), which has none" + end),
        (start, "plddt", "amplitude plddt: pLDDT is a confidence, not a distance, and no law is "
         "known that converts it into one" + end
         + " (--floppy-below 50 frees residues with a pLDDT below that)"),
        (start, "nmr", "amplitude: expected a number above 0 (Angstrom), bfactors, or a file with "
         'models of the molecule; found "nmr"'),
        (start, "-1", '--amplitude: expected a number above 0, found "-1"'),
    ]  # fmt: skip  # a table: a row a line
    for file, word, message in cases:
        ended = pliant("sample", file, "-o", "out.h5md", f"--amplitude={word}", "--quiet")
        assert (ended.code, ended.err.splitlines()[-1]) == (2, f"pliant: error: {message}")
    assert not (tmp_path / "out.h5md").exists()


#: the same values for all atoms of a residue, as refinements at low resolution have them and pLDDT
EVEN = {"b_of": lambda k, _: 40.0 + k}


@pytest.mark.parametrize(
    "record",
    ["EXPDTA    ELECTRON MICROSCOPY", "EXPDTA    X-RAY DIFFRACTION", "EXPDTA    SOLUTION NMR"],
)
def test_b_factors_of_an_experiment_are_b_factors_whatever_their_values(pliant, tmp_path, record):
    (tmp_path / "even.pdb").write_text(record + "\n" + pdb([helix()], **EVEN))
    report = asked(pliant, "even.pdb", "--amplitude", "bfactors")
    assert report["amplitude_from"] == "bfactors"
    assert not any("confidence" in warning for warning in report["warnings"])
    (tmp_path / "even.pdb").write_text(pdb([helix()], **EVEN))
    report = asked(pliant, "even.pdb", "--amplitude", "1")
    assert any("10 residues with a confidence (B factor) below 50" in w for w in report["warnings"])


def test_what_an_mmcif_says_decides_too(pliant, tmp_path):
    """gemmi writes the atoms; values differ within a residue, as those of AlphaFold 3 do."""
    gemmi = pytest.importorskip("gemmi")
    (tmp_path / "uneven.pdb").write_text(pdb([helix()], uneven))
    document = gemmi.read_structure(str(tmp_path / "uneven.pdb")).make_mmcif_document()
    block = document.sole_block()
    block.set_pair("_exptl.method", "'ELECTRON MICROSCOPY'")
    document.write_file(str(tmp_path / "map.cif"))
    assert asked(pliant, "map.cif", "--amplitude", "bfactors")["amplitude_from"] == "bfactors"
    block.set_pair("_exptl.method", "'THEORETICAL MODEL'")
    block.set_pair("_ma_qa_metric.name", "pLDDT")
    document.write_file(str(tmp_path / "model.cif"))
    ended = pliant("sample", "model.cif", "-o", "o.h5md", "--amplitude", "bfactors", "--quiet")
    assert (ended.code, ended.err.splitlines()[-1]) == (
        2,
        "pliant: error: amplitude bfactors: the file says that they are confidences such as pLDDT "
        "(_ma_qa_metric); give a number (Angstrom) or a file of models",
    )
    report = asked(pliant, "model.cif", "--amplitude", "1")
    assert any("with a confidence (B factor) below 50" in w for w in report["warnings"])


def test_files_that_are_no_ensemble_of_it_are_refused(pliant, start, tmp_path):
    (tmp_path / "one.pdb").write_text(pdb([helix()]))
    (tmp_path / "far.pdb").write_text(pdb(ensemble(3), first=401))
    cases = [
        (
            "one.pdb",
            "amplitude: expected at least 2 models, found 1: one structure does not fluctuate",
        ),
        (
            "far.pdb",
            "has 0 of 14 residues of the sampled molecule, by chain and number: number both alike",
        ),
    ]
    for file, message in cases:
        ended = pliant("sample", start, "-o", "out.h5md", "--amplitude", file, "--quiet")
        assert (ended.code, ended.err.splitlines()[-1]) == (1, f"pliant: error: {file}: {message}")
    assert not (tmp_path / "out.h5md").exists()


def test_the_file_of_the_amplitude_is_not_written_over(pliant, start, tmp_path):
    (tmp_path / "nmr.pdb").write_text(pdb(ensemble(3)))
    before = (tmp_path / "nmr.pdb").read_bytes()
    ended = pliant("sample", start, "-o", "nmr.pdb", "--amplitude", "nmr.pdb", "--overwrite")
    assert ended.code != 0
    assert (tmp_path / "nmr.pdb").read_bytes() == before


def test_what_does_not_move_is_a_warning(pliant, tmp_path):
    """Modes of a network bend benzene, and its angles do not let them."""
    ring = tmp_path / "ring.xyz"
    angles = np.radians(60.0) * np.arange(6)
    lines = [f"C {1.39 * np.cos(a):.4f} {1.39 * np.sin(a):.4f} 0.0" for a in angles]
    ring.write_text("\n".join(["6", "ring", *lines, ""]))
    ended = pliant(
        "sample", ring, *"-o out.h5md --frames 20 --quiet --json --sampler modes".split()
    )
    assert ended.code == 0
    assert json.loads(ended.out)["warnings"] == [
        "frames reach an amplitude of 0.00 of the 1.40 Angstrom asked for: the molecule "
        "is held too tightly to move that far"
    ]
