# SPDX-License-Identifier: MIT
"""pliant.compare on trajectories whose answer is known, and what it says when they do not fit."""

import importlib.util
import json

import MDAnalysis
import numpy as np
import pytest
from json_shape import holds
from made_trajectories import molecule_run
from pliant.report.compare.command import main
from real_files import DIPEPTIDE, ROOT

import pliant

PEPTIDE = "CC(=O)NC(C)C(=O)NC"


@pytest.fixture(scope="module")
def made():
    run = molecule_run(PEPTIDE, frames=60)
    # Of one residue but for two atoms: so there is something to select and to number.
    run.residues = [("DIP", 1)] * 20 + [("CAP", 2)] * (len(run.elements) - 20)
    return run


@pytest.fixture
def ours(made, tmp_path):
    return str(made.write(tmp_path / "ours.h5md"))


def write_theirs(made, tmp_path, positions=None, order=None, names=None, name="theirs.dcd"):
    """A trajectory and a PDB that names its atoms, as another program would leave them."""
    order = np.arange(len(made.elements)) if order is None else np.asarray(order)
    positions = made.positions if positions is None else positions
    count = len(order)
    residue_of = np.array([number - 1 for _, number in made.residues])[order]
    universe = MDAnalysis.Universe.empty(
        count, n_residues=2, atom_resindex=residue_of, trajectory=True
    )
    own = [f"{element}{k + 1}" for k, element in enumerate(made.elements)]
    universe.add_TopologyAttr("names", (np.array(names or own))[order])
    universe.add_TopologyAttr("elements", np.array(made.elements)[order])
    universe.add_TopologyAttr("resnames", ["DIP", "CAP"])
    universe.add_TopologyAttr("resids", [1, 2])
    universe.load_new(positions[:, order].astype(np.float32))
    universe.atoms.write(str(tmp_path / "theirs.pdb"))
    universe.atoms.write(str(tmp_path / name), frames="all")
    return str(tmp_path / name), str(tmp_path / "theirs.pdb")


def test_a_trajectory_is_like_itself(ours):
    report = pliant.compare(ours, ours)
    assert report.atoms.atom_fluctuations.pearson == pytest.approx(1.0, abs=1e-6)
    assert report.atoms.modes.rmsip == pytest.approx(1.0, abs=1e-3)
    assert np.diag(report.atoms.modes.overlaps) == pytest.approx(1.0, abs=0.01)
    # A 32-bit coordinate may put an angle at the edge of a bin into its neighbour.
    assert max(torsion.distance for torsion in report.atoms.torsions) < 0.15


def test_both_are_measured_as_they_are_stored(ours):
    """32-bit floats miss bars by some 1e-7; an H5MD file of theirs has doubles, as ours has."""
    bars = pliant.compare(ours, ours).atoms.bars
    assert bars.residual_theirs == bars.residual_ours < 1e-9
    assert np.array_equal(bars.spread_ours, bars.spread_theirs)


def test_rigid_motions_change_nothing(made, ours, tmp_path):
    from scipy.spatial.transform import Rotation

    turns = Rotation.random(len(made.positions), rng=5).as_matrix()
    theirs, topology = write_theirs(made, tmp_path, made.positions @ turns + 12.5)
    report = pliant.compare(ours, theirs, topology=topology)
    assert report.atoms.atom_fluctuations.ours == pytest.approx(
        report.atoms.atom_fluctuations.theirs, abs=1e-3
    )
    assert report.atoms.modes.rmsip == pytest.approx(1.0, abs=1e-3)


def test_fluctuations_are_those_of_mdanalysis(made, ours, tmp_path):
    from MDAnalysis.analysis.align import AlignTraj, AverageStructure
    from MDAnalysis.analysis.rms import RMSF

    theirs, topology = write_theirs(made, tmp_path)
    report = pliant.compare(ours, theirs, topology=topology)
    universe = MDAnalysis.Universe(topology, theirs, in_memory=True)
    for _ in range(20):
        average = AverageStructure(universe, select="not element H", ref_frame=0).run()
        reference = average.results.universe
        AlignTraj(universe, reference, select="not element H", in_memory=True).run()
    found = RMSF(universe.atoms).run().results.rmsf
    assert report.atoms.atom_fluctuations.theirs == pytest.approx(found, abs=2e-3)


def test_atoms_in_another_order_are_matched_by_name(made, ours, tmp_path):
    order = [*np.random.default_rng(1).permutation(20), 21, 20]
    theirs, topology = write_theirs(made, tmp_path, order=order)
    report = pliant.compare(ours, theirs, topology=topology)
    assert report.notes == ["atoms are matched by residue and name; the order differs"]
    assert report.atoms.atom_fluctuations.pearson == pytest.approx(1.0, abs=1e-6)


def test_other_names_are_matched_by_order_if_elements_agree(made, ours, tmp_path):
    names = [f"{element}X{k}" for k, element in enumerate(made.elements)]
    theirs, topology = write_theirs(made, tmp_path, names=names)
    report = pliant.compare(ours, theirs, topology=topology)
    assert report.notes == [
        "atoms are matched by order; elements agree, 22 names do not (the first: C1, CX0)"
    ]


def test_other_elements_are_refused(made, ours, tmp_path):
    # Two atoms change places: all are there, but the names say nothing of which is which.
    order = np.arange(22)
    order[[2, 3]] = order[[3, 2]]
    names = [f"{element}X{k}" for k, element in enumerate(made.elements)]
    theirs, topology = write_theirs(made, tmp_path, order=order, names=names)
    with pytest.raises(pliant.InputError) as error:
        pliant.compare(ours, theirs, topology=topology)
    assert str(error.value) == (
        "both have 22 atoms, but atom 2 is DIP1:O3 in ours and DIP1:NX3 in theirs"
    )


def test_different_counts_are_named_with_an_atom_that_is_missing(made, ours, tmp_path):
    theirs, topology = write_theirs(made, tmp_path, order=np.arange(19))
    with pytest.raises(pliant.InputError) as error:
        pliant.compare(ours, theirs, topology=topology)
    assert str(error.value) == (
        "ours has 22 atoms and theirs 19: choose the same of both with --select "
        "(only ours has DIP1:H20 and 2 more)"
    )
    report = pliant.compare(ours, theirs, topology=topology, select="not name H*")
    assert len(report.atoms.ensembles.atoms) == 10


def test_a_trajectory_without_names_is_taken_by_order(made, ours, tmp_path):
    theirs, _ = write_theirs(made, tmp_path)
    report = pliant.compare(ours, theirs)
    assert report.notes == ["atoms are matched by order: their file has no names"]
    assert report.atoms.modes.rmsip == pytest.approx(1.0, abs=1e-3)


def test_a_trajectory_without_names_and_another_count_is_refused(made, ours, tmp_path):
    theirs, _ = write_theirs(made, tmp_path, order=np.arange(19))
    with pytest.raises(pliant.InputError) as error:
        pliant.compare(ours, theirs)
    assert str(error.value) == (
        f"{theirs}: has 19 atoms and ours has 22: give a --topology that names its atoms, and "
        "choose the same of both with --select"
    )


def test_what_the_periodic_box_has_cut_is_refused(made, ours, tmp_path):
    positions = made.positions.copy()
    positions[5, :3] += 40.0
    theirs, topology = write_theirs(made, tmp_path, positions)
    with pytest.raises(pliant.InputError) as error:
        pliant.compare(ours, theirs, topology=topology)
    assert "A long in frame 6 of those read: the edge" in str(error.value)


@pytest.mark.parametrize(
    ("select", "message"),
    [
        ("name NOTHING", "--select 'name NOTHING' chooses no atom"),
        ("name C1 C2", "--select 'name C1 C2': expected at least 3 atoms"),
    ],
)
def test_a_selection_of_too_few_is_refused(ours, select, message):
    with pytest.raises(pliant.InputError) as error:
        pliant.compare(ours, ours, select=select)
    assert str(error.value).endswith(message)


def test_a_wrong_selection_is_refused_in_one_line(ours, capsys):
    assert main([ours, ours, "--select", "nmae C1"]) == 1
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 1
    assert lines[0].startswith("pliant compare: error: --select 'nmae C1': ")


def test_one_frame_is_too_few(made, ours, tmp_path):
    theirs, topology = write_theirs(made, tmp_path, made.positions[:1])
    with pytest.raises(pliant.InputError) as error:
        pliant.compare(ours, theirs, topology=topology)
    assert str(error.value) == f"{theirs}: expected at least 2 frames, found 1"


@pytest.mark.parametrize("missing", ["ours", "theirs", "topology"])
def test_a_missing_file_is_named(made, ours, tmp_path, missing):
    theirs, topology = write_theirs(made, tmp_path)
    files = {"ours": ours, "theirs": theirs, "topology": topology}
    files[missing] = str(tmp_path / "none.dcd")
    with pytest.raises(pliant.InputError) as error:
        pliant.compare(files["ours"], files["theirs"], topology=files["topology"])
    assert str(error.value) == f"{tmp_path / 'none.dcd'}: no such file"


def test_a_broken_trajectory_is_one_line(ours, tmp_path, capsys):
    path = tmp_path / "broken.dcd"
    path.write_bytes(b"not a trajectory")
    assert main([ours, str(path)]) == 1
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 1
    assert lines[0].startswith(f"pliant compare: error: {path}: MDAnalysis cannot read it: ")


def test_bars_do_not_vary_in_ours_and_do_in_theirs(made, ours, tmp_path):
    rng = np.random.default_rng(2)
    shaken = made.positions + rng.normal(scale=0.02, size=made.positions.shape)
    theirs, topology = write_theirs(made, tmp_path, shaken)
    bars = pliant.compare(ours, theirs, topology=topology).atoms.bars
    assert (
        bars.residual_ours <= 1e-6 and bars.spread_ours.max() < 2e-6
    )  # 1e-6 of at most 2 Angstrom
    # Each end is off by 0.02 along the bar: the length by the root of two times that.
    assert np.mean(bars.spread_theirs) == pytest.approx(0.02 * np.sqrt(2), rel=0.1)


def test_frames_are_spread_over_both(ours):
    report = pliant.compare(ours, ours, frames=7)
    assert len(report.atoms.ensembles.ours) == len(report.atoms.ensembles.theirs) == 7


RMSF = {"labels": [str], "ours": [float], "theirs": [float], "pearson": float}
SCHEMA = {
    "pliant": str,
    "ours": {"file": str, "frames": int},
    "theirs": {"file": str, "frames": int},
    "conclusions": [str],
    "cautions": [str],
    "residues": type(None),
    "atoms": int,
    "matched": str,
    "rmsf": {"atoms": RMSF, "residues": (dict, type(None))},
    "modes": {
        "atoms": int,
        "overlaps": [[float]],
        "rmsip": float,
        "chance": float,
        "halves_ours": float,
        "halves_theirs": float,
        "share_ours": float,
        "share_theirs": float,
    },
    "torsions": [
        {
            "label": str,
            "ours": [float],
            "theirs": [float],
            "distance": float,
            "halves_theirs": float,
        }
    ],
    "bars": {
        "labels": [str],
        "spread_ours": [float],
        "spread_theirs": [float],
        "residual_ours": float,
        "residual_theirs": float,
    },
    "radius_of_gyration": {
        "ours": {"mean": float, "standard_deviation": float},
        "theirs": {"mean": float, "standard_deviation": float},
    },
    "notes": [str],
    "pictures": [str],
}


def test_json_is_one_object_of_a_fixed_shape(ours, capsys):
    assert main([ours, ours, "--json"]) == 0
    captured = capsys.readouterr()
    holds(json.loads(captured.out), SCHEMA)
    assert captured.err == ""


def test_the_table_and_the_pictures(ours, tmp_path, capsys, rendered):
    folder = tmp_path / "new" / "folder"
    assert main([ours, ours, "-o", str(folder)]) == 0
    out = capsys.readouterr().out
    for name in ("ours.compare.png", "ours.compare-torsions.png"):
        assert (folder / name).read_bytes()[:8] == b"\x89PNG\r\n\x1a\n"
        assert f"picture  {folder / name}\n" in out
    for words in (
        "Pearson r 1.00",
        "RMSIP 1.00",
        "by chance",
        "(A), no error",
        "(standard deviation)",
    ):
        assert words in out


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--frames", "1"], "--frames: expected a whole number from 2 or all, found '1'"),
        (["--what"], "unrecognized arguments: --what"),
    ],
)
def test_a_bad_option_ends_with_2(words, message, capsys):
    with pytest.raises(SystemExit) as stopped:
        main(["out.h5md", "out.dcd", *words])
    assert stopped.value.code == 2
    assert capsys.readouterr().err.splitlines()[0] == f"pliant compare: error: {message}"


@pytest.mark.long
def test_dynamics_and_pliant_side_by_side(tmp_path, capsys):
    """The example with real OpenMM dynamics, run short: amber14 in implicit solvent."""
    path = ROOT / "python" / "examples" / "openmm_dynamics.py"
    spec = importlib.util.spec_from_file_location("openmm_dynamics", path)
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    words = [
        str(DIPEPTIDE),
        "-o",
        str(tmp_path),
        *"--picoseconds 1 --frames 20 --platform Reference".split(),
    ]
    assert example.main(words) == 0
    out = capsys.readouterr().out
    assert "theirs  " in out and "ALA2 phi" in out and "ALA2 psi" in out
    start, dcd = tmp_path / "alanine_dipeptide-start.pdb", tmp_path / "alanine_dipeptide-openmm.dcd"
    dynamics = MDAnalysis.Universe(str(start), str(dcd))
    assert len(dynamics.trajectory) == 20
    # It is dynamics: bonds between heavy atoms vibrate, and no atom is where it began.
    ace = dynamics.select_atoms("resname ACE and name CH3 C")
    lengths = [np.linalg.norm(np.diff(ace.positions, axis=0)) for _ in dynamics.trajectory]
    assert 0.005 < np.std(lengths) < 0.2
    for name in ("alanine_dipeptide.compare.png", "alanine_dipeptide.compare-torsions.png"):
        assert (tmp_path / name).exists()
