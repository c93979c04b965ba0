# SPDX-License-Identifier: MIT
"""Coverage: how pairs are found, distances against MDAnalysis and NumPy, shares, the command."""

import csv
import json

import numpy as np
import pytest

import pliant

MDA = pytest.importorskip("MDAnalysisTests.datafiles")
rms = pytest.importorskip("MDAnalysis.analysis.rms")
pytest.importorskip("scipy")

from pliant.lab.bench.command import main  # noqa: E402
from pliant.lab.pairs import coverage as measure  # noqa: E402
from pliant.lab.pairs.coverage import Nearest  # noqa: E402
from pliant.lab.pairs.directions import DOMAIN, POCKET, Judge, directions_of  # noqa: E402
from pliant.lab.structures import read_quietly  # noqa: E402

BACKBONE = "name N CA C O and not resid 214"  # whose oxygens have names of their own


@pytest.fixture(scope="module")
def pairs(tmp_path_factory):
    """The kinase, open and closed (MDAnalysis' DIMS), as domain motion and as a pocket."""
    import MDAnalysis

    folder = tmp_path_factory.mktemp("pairs")
    universe = MDAnalysis.Universe(MDA.PSF, MDA.DCD)
    atoms = universe.select_atoms("protein and name N CA C O CB")
    for place in ("kinase", "pocket"):
        (folder / place).mkdir()
        for name, frame in (("closed", 0), ("open", -1)):
            universe.trajectory[frame]
            atoms.write(folder / place / f"{name}.pdb")
    local = {
        "alignment_resid_ranges": [[1, 29], [60, 120], [160, None]],
        "metric_resid_ranges": [[30, 59]],
    }
    (folder / "pocket" / "local.json").write_text(json.dumps(local))
    (folder / "alone").mkdir()
    (folder / "alone" / "one.pdb").write_text("END\n")
    return folder


def judges(pairs):
    for direction in directions_of(pairs):
        structure = read_quietly(direction.start)
        yield direction, structure, Judge(direction, structure)


def backbone(path):
    import MDAnalysis

    return MDAnalysis.Universe(path).select_atoms(BACKBONE)


def test_both_directions_of_each_pair_are_found(pairs):
    found = directions_of(pairs)
    assert [(one.kind, one.protein, one.name) for one in found] == [
        (DOMAIN, "kinase", "closed to open"),
        (DOMAIN, "kinase", "open to closed"),
        (POCKET, "pocket", "closed to open"),
        (POCKET, "pocket", "open to closed"),
    ]


def test_a_folder_without_pairs_is_refused(tmp_path):
    with pytest.raises(pliant.InputError, match="no subfolder holds two structures"):
        directions_of(tmp_path)


def test_domain_motions_are_measured_as_mdanalysis_does(pairs):
    for direction, _, judge in judges(pairs):
        if direction.kind == DOMAIN:
            start, goal = (backbone(path).positions for path in (direction.start, direction.goal))
            expected = rms.rmsd(start, goal, superposition=True)
            assert judge.at_start == pytest.approx(expected, abs=1e-4)


def test_pockets_are_superposed_on_what_holds_still(pairs):
    for direction, _, judge in judges(pairs):
        if direction.kind != POCKET:
            continue
        start, goal = (backbone(path) for path in (direction.start, direction.goal))
        still = ~np.isin(start.resids, np.r_[30:60, 121:160])
        pocket = np.isin(start.resids, np.r_[30:60])
        a, b = start.positions.astype(float), goal.positions.astype(float)
        a, b = a - a[still].mean(axis=0), b - b[still].mean(axis=0)
        u, _, vt = np.linalg.svd(a[still].T @ b[still])
        turn = u @ np.diag([1, 1, np.sign(np.linalg.det(u @ vt))]) @ vt
        expected = np.linalg.norm(a[pocket] @ turn - b[pocket], axis=1).mean()
        assert judge.at_start == pytest.approx(expected, abs=1e-4)


def test_the_goal_itself_is_at_no_distance(pairs):
    for direction, structure, judge in judges(pairs):
        goal = np.array(structure.positions)
        goal[judge.atoms.ravel()] = backbone(direction.goal).positions
        assert judge.distances(goal[None])[0] < 1e-3


def nearest(protein, at_start, distance):
    return Nearest(
        DOMAIN, protein, f"{protein} {at_start}", 100, "modes", 10, at_start, distance, 3
    )


def test_shares_are_counted_over_directions_and_by_distance():
    rows = [nearest("a", 4, 1), nearest("a", 6, 4), nearest("b", 10, 2.9), nearest("b", 10, 9)]
    shares = measure._shares(rows, DOMAIN, "modes", 10)
    assert [(s.of_distance, s.directions, s.covered) for s in shares] == [
        ("all", 4, 0.5), ("0-5", 1, 1.0), ("5-8", 1, 0.0), ("8 on", 2, 0.5)]  # fmt: skip  # a table
    assert shares[0].nearest == pytest.approx(np.mean([1, 4, 2.9, 9]))
    assert shares[0].error == 0.0, "each protein has one direction of two"


@pytest.mark.long
def test_the_command_measures_draws_and_writes(pairs, tmp_path, capsys):
    table, picture = tmp_path / "coverage.csv", tmp_path / "coverage.png"
    words = ["coverage", "--data", str(pairs / "kinase"), "--only", "reach,ANM"]
    words += ["--frames", "102"]
    assert main([*words, "--csv", str(table), "-o", str(picture), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["skipped"] == []
    assert {row["ensemble"] for row in found["shares"]} == {"reach", "ANM"}
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 4
    assert all(float(row["nearest"]) < float(row["at_start"]) for row in rows)
    assert picture.stat().st_size > 10_000


def test_what_does_not_exist_is_refused(pairs, capsys):
    assert main(["coverage", "--data", str(pairs), "--only", "magic"]) == 2
    assert "--only magic: must be one of reach, turns, modes" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["coverage", "--data", str(pairs), "--frames", "many"])
    expected = "--frames: expected whole numbers from 1 between commas, found 'many'"
    assert expected in capsys.readouterr().err
